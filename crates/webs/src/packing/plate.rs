//! Places stiff canopies (plates) in a packed web. A pattern moves every point separately and would bend a plate.
//!
//! In a scaled web and in a bag, the middle of a plate lies where the pattern puts it, and the plate is parallel to the
//! flat web. Ropes run straight from plate to plate. (For folds see `position_based/folded_plates.rs`.)
//!
//! Two plates with side s, whose middles are L apart in the flat web, are joined by ropes of length L - sqrt(3) s. If
//! the pattern moves the middles to a distance q L along the same line, the ends of the rope are |q L - sqrt(3) s|
//! apart: for L > 2 sqrt(3) s no q from 0 to 1 stretches the rope. In a deep bag one middle lies below the other, and
//! the ends can be farther apart; the audit reports this. Plates may overlap: there is no contact here.

use glam::{DMat3, DVec3};

use crate::CutWeb;

/// Largest distance of a given corner from the plate's own, as a share of the plate's side: numbers in a file are
/// rounded.
const TOLERANCE: f64 = 1e-6;

/// A stiff canopy, which keeps its shape.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffPlate {
    /// Its canopy, as an index into [`crate::Web::canopies`].
    pub canopy: usize,
    /// All nodes fixed to it.
    pub nodes: Vec<usize>,
}

impl StiffPlate {
    /// Places the plates parallel to the flat web, with their middles where the pattern has put them, and lays the
    /// ropes tied to them straight. `packed` are positions in the launch frame, m, (nodes,).
    pub fn lay(plates: &[StiffPlate], cut_web: &CutWeb, packed: &mut [DVec3]) {
        let mut is_tied = vec![false; cut_web.web.knots.len()];
        for plate in plates {
            plate.place(cut_web, DMat3::IDENTITY, packed);
            for &knot in &cut_web.web.canopies[plate.canopy].rim {
                is_tied[knot] = true;
            }
        }
        for (rope, cut) in cut_web.web.ropes.iter().zip(&cut_web.ropes) {
            if is_tied[rope.a] || is_tied[rope.b] {
                let (a, b) = (packed[rope.a], packed[rope.b]);
                for (node, place) in cut.interior().zip(1..) {
                    packed[node] = a.lerp(b, f64::from(place) / cut.segments as f64);
                }
            }
        }
    }

    /// Places the plate at the given positions of its middle and its corners. Returns its rotation against the flat
    /// web.
    ///
    /// # Errors
    /// The largest distance of a given corner from the plate's own, m, if only a bent plate would fit.
    pub fn fit(&self, cut_web: &CutWeb, packed: &mut [DVec3]) -> Result<DMat3, f64> {
        let canopy = &cut_web.web.canopies[self.canopy];
        let rim = canopy.rim.map(|knot| packed[knot]);
        let x = (rim[0] - rim[3]).normalize_or_zero();
        let z = x.cross(rim[1] + rim[2] - rim[4] - rim[5]).normalize_or_zero();
        let turn = DMat3::from_cols(x, z.cross(x), z);
        let placed = |node: usize| packed[canopy.hub] + turn * (cut_web.nodes[node] - cut_web.nodes[canopy.hub]);
        let off = canopy.rim.iter().map(|&knot| placed(knot).distance(packed[knot])).fold(0.0, f64::max);
        let size = cut_web.nodes[canopy.rim[0]].distance(cut_web.nodes[canopy.hub]);
        if off > TOLERANCE * size {
            return Err(off);
        }
        self.place(cut_web, turn, packed);
        Ok(turn)
    }

    /// Places the plate's nodes about its hub, with this rotation against the flat web.
    pub(super) fn place(&self, cut_web: &CutWeb, turn: DMat3, packed: &mut [DVec3]) {
        let hub = cut_web.web.canopies[self.canopy].hub;
        let middle = packed[hub];
        for &node in &self.nodes {
            packed[node] = middle + turn * (cut_web.nodes[node] - cut_web.nodes[hub]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::longest_stretch;
    use super::*;
    use crate::{Bag, Cutting, Pattern, Scale, cut, space};

    fn net() -> (CutWeb, Vec<StiffPlate>) {
        let net = cut(&space(2.5, 0.14).unwrap(), &Cutting::SegmentLength(0.1)).unwrap();
        let plates = net.web.canopies.iter().enumerate();
        let plates = plates.map(|(canopy, c)| StiffPlate { canopy, nodes: c.rim.to_vec() }).collect();
        (net, plates)
    }

    #[test]
    fn in_scaled_webs_and_bags_plates_keep_their_shape_and_no_rope_is_stretched() {
        let (net, plates) = net();
        for pattern in [
            Pattern::Scale(Scale { factor: 0.01 }),
            Pattern::Scale(Scale { factor: 0.6 }),
            Pattern::Scale(Scale { factor: 1.0 }),
            Pattern::Bag(Bag { depth: Some(0.38), ..Bag::of_radius(0.24) }),
            Pattern::Bag(Bag { depth: Some(1.0), ..Bag::of_radius(0.5) }),
        ] {
            let mut packed = pattern.pack(&net).unwrap();
            StiffPlate::lay(&plates, &net, &mut packed);
            for canopy in &net.web.canopies {
                for k in 0..6 {
                    let side = packed[canopy.rim[k]].distance(packed[canopy.rim[(k + 1) % 6]]);
                    assert!((side - 0.14).abs() < 1e-12);
                }
            }
            assert!(longest_stretch(&net, &packed) < 1e-12, "{pattern:?}: {}", longest_stretch(&net, &packed));
        }
    }

    #[test]
    fn a_bag_too_deep_for_plates_stretches_ropes() {
        let (net, plates) = net();
        let mut packed = Pattern::Bag(Bag { depth: Some(2.4), ..Bag::of_radius(0.24) }).pack(&net).unwrap();
        StiffPlate::lay(&plates, &net, &mut packed);
        assert!(longest_stretch(&net, &packed) > 0.01);
    }

    #[test]
    fn a_plate_takes_the_attitude_of_its_given_corners_and_a_bent_one_is_refused() {
        let (net, plates) = net();
        let plate = StiffPlate { canopy: 4, nodes: net.web.canopies[4].rim.to_vec() };
        let turned = DMat3::from_cols(DVec3::Z, DVec3::X, DVec3::Y);
        let mut given: Vec<DVec3> = net.nodes.iter().map(|&node| turned * node + DVec3::ONE).collect();
        let exact = given.clone();
        let found = plate.fit(&net, &mut given).unwrap();
        assert!((found - turned).abs_diff_eq(DMat3::ZERO, 1e-12));
        assert!(exact.iter().zip(&given).all(|(one, other)| one.distance(*other) < 1e-12));

        given[net.web.canopies[4].rim[2]] += 0.01 * DVec3::X;
        let off = plates[4].fit(&net, &mut given).unwrap_err();
        assert!(off > 0.005 && off < 0.02, "{off}");
    }
}

//! Places plates (stiff canopies) in a folded web, and draws the web in about them so that no rope is stretched.
//!
//! A plate within one leg of a fold moves with the leg. A plate across a bend takes the place and the attitude that fit
//! its bent corners best. Its corners are then not where the fold has put them, and ropes tied to them may be
//! stretched. The nodes around the plate are therefore drawn towards it; tractors do not move.

use glam::{DMat3, DVec3};

use super::projection::Projection;
use crate::CutWeb;
use crate::packing::StiffPlate;
use crate::packing::distance_limits::{self, DistanceLimit};

impl StiffPlate {
    /// Places plates in a folded web with positions `packed`, m, (nodes,). Returns the rotation of each plate against
    /// the flat web, (plates,).
    pub fn lay_in_folds(plates: &[StiffPlate], cut_web: &CutWeb, packed: &mut [DVec3]) -> Vec<DMat3> {
        if plates.is_empty() {
            return Vec::new();
        }
        let folded = packed.to_vec();
        let mut turns = vec![DMat3::IDENTITY; plates.len()];
        for (plate, turn) in plates.iter().zip(&mut turns) {
            *turn = plate.fit_corners(cut_web, *turn, packed);
            plate.place(cut_web, *turn, packed);
        }
        // the nodes inside a rope move with its knots
        let displacement = |knot: usize, packed: &[DVec3]| packed[knot] - folded[knot];
        for (rope, cut) in cut_web.web.ropes.iter().zip(&cut_web.ropes) {
            let (a, b) = (displacement(rope.a, packed), displacement(rope.b, packed));
            for (node, place) in cut.interior().zip(1..) {
                packed[node] += a.lerp(b, f64::from(place) / cut.segments as f64);
            }
        }
        // masses are not known here: every node has the same weight, but tractors outside plates do not move
        let mut inverse_mass = vec![1.0; packed.len()];
        for &knot in &cut_web.web.tractors {
            if !plates.iter().any(|plate| plate.nodes.contains(&knot)) {
                inverse_mass[knot] = 0.0;
            }
        }
        let limits: Vec<DistanceLimit> = distance_limits::of_ropes(cut_web).collect();
        Projection { cut_web, limits: &limits, plates, inverse_mass: &inverse_mass }.draw_in(&mut turns, packed);
        turns
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packing::longest_stretch;
    use crate::{Container, Cutting, Folded, Folding, Mouth, Pattern, cut, space};

    const SIDE: f64 = 0.14;

    fn net() -> (CutWeb, Vec<StiffPlate>) {
        let web = space(2.5, SIDE).unwrap().with_traction(1.7, 1).unwrap();
        let net = cut(&web, &Cutting::SegmentLength(0.1)).unwrap();
        let plates = net.web.canopies.iter().enumerate();
        let plates = plates.map(|(canopy, c)| {
            let nodes = c.rim.into_iter().chain([c.hub]).collect();
            StiffPlate { canopy, nodes }
        });
        let plates = plates.collect();
        (net, plates)
    }

    #[test]
    fn with_every_folding_plates_keep_their_shape_and_no_rope_is_stretched() {
        let (net, plates) = net();
        let rooms = [
            Container::Cylinder { radius: 0.6, height: 1.0 },
            Container::Box { width: 1.0, breadth: 1.1, height: 0.9 },
        ];
        for container in rooms {
            for folding in
                [Folding::Rings, Folding::Lines, Folding::Layers, Folding::Roll, Folding::Star { arms: None }]
            {
                let folded = Folded { folding, container, spacing: 0.01, mouth: Mouth::default() };
                let mut packed = Pattern::Folded(folded).pack(&net).unwrap();
                let tractors: Vec<DVec3> = net.web.tractors.iter().map(|&knot| packed[knot]).collect();
                let turns = StiffPlate::lay_in_folds(&plates, &net, &mut packed);
                let case = format!("{folding:?} in {container}");
                let longest = longest_stretch(&net, &packed);
                assert!(longest < 1e-10, "{case}: {longest}");
                for (plate, turn) in plates.iter().zip(turns) {
                    let hub = net.web.canopies[plate.canopy].hub;
                    assert!((turn.determinant() - 1.0).abs() < 1e-12);
                    for &node in &plate.nodes {
                        let place = packed[hub] + turn * (net.nodes[node] - net.nodes[hub]);
                        assert!(place.distance(packed[node]) < 1e-12, "{case}");
                    }
                }
                assert!(net.web.tractors.iter().zip(tractors).all(|(&knot, place)| packed[knot] == place));
            }
        }
    }

    #[test]
    fn a_plate_within_one_leg_moves_with_the_leg() {
        let (net, plates) = net();
        let turned = DMat3::from_cols(DVec3::Z, DVec3::NEG_Y, DVec3::X);
        let mut packed: Vec<DVec3> = net.nodes.iter().map(|&node| turned * node + DVec3::ONE).collect();
        let exact = packed.clone();
        for turn in StiffPlate::lay_in_folds(&plates, &net, &mut packed) {
            assert!(turn.abs_diff_eq(turned, 1e-12));
        }
        assert!(exact.iter().zip(&packed).all(|(one, other)| one.distance(*other) < 1e-12));
    }
}

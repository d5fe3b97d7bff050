//! Stiff canopies in a folded web: laid into its layers, and what that stretches drawn in.
//!
//! A fold moves a plate that lies within one leg as it is. Where a bend goes through a plate, the plate takes the place
//! and the attitude that fit its bent corners best; then its corners are not where the fold has put them, and ropes may
//! be too short. So the web is drawn in about such plates (`ties.rs`). Tractors stay.
//!
//! The attitude is the orthogonal factor of M = sum x q* over the corners, q in the flat plate and x as they are, both
//! from their means: R = M (M* M)^(-1/2), the rotation that is nearest in least squares.

use glam::{DMat2, DMat3, DVec2, DVec3, dvec2};

use super::plate::StiffPlate;
use super::ties::{self, Drawn, Tie};
use crate::CutWeb;

/// Corners nearer to one line than that, relative, do not say how a plate is turned about it.
const FLAT: f64 = 1e-9;

/// By how much it then leans to how it was turned before, relative.
const LEAN: f64 = 1e-6;

impl StiffPlate {
    /// Puts plates into a web that has been folded, and says how each is turned against the flat web, in their order.
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
        // ropes follow their ends
        let moved = |knot: usize, packed: &[DVec3]| packed[knot] - folded[knot];
        for (rope, cut) in cut_web.web.ropes.iter().zip(&cut_web.ropes) {
            let (a, b) = (moved(rope.a, packed), moved(rope.b, packed));
            for (node, place) in cut.interior().zip(1..) {
                packed[node] += a.lerp(b, f64::from(place) / cut.segments as f64);
            }
        }
        let mut ease = vec![1.0; packed.len()];
        let is_on_a_plate = |knot: &usize| plates.iter().any(|plate| plate.nodes.contains(knot));
        cut_web.web.tractors.iter().filter(|&knot| !is_on_a_plate(knot)).for_each(|&knot| ease[knot] = 0.0);
        let ties: Vec<Tie> = ties::of_ropes(cut_web).collect();
        Drawn { cut_web, ties: &ties, plates, ease: &ease }.draw_in(&mut turns, packed);
        turns
    }
}

impl StiffPlate {
    /// Moves its hub to the mean of its corners, and says which attitude fits these best; where a fold in half leaves that
    /// open, the one nearest to `before`.
    pub(super) fn fit_corners(&self, cut_web: &CutWeb, before: DMat3, packed: &mut [DVec3]) -> DMat3 {
        let canopy = &cut_web.web.canopies[self.canopy];
        let middle = canopy.rim.iter().map(|&knot| packed[knot]).sum::<DVec3>() / canopy.rim.len() as f64;
        let mut columns = [DVec3::ZERO; 2];
        for &knot in &canopy.rim {
            let flat = (cut_web.nodes[knot] - cut_web.nodes[canopy.hub]).truncate();
            columns[0] += flat.x * (packed[knot] - middle);
            columns[1] += flat.y * (packed[knot] - middle);
        }
        packed[canopy.hub] = middle;
        let size = columns[0].length() + columns[1].length();
        let leaning = [columns[0] + LEAN * size * before.x_axis, columns[1] + LEAN * size * before.y_axis];
        nearest_rotation(columns).or_else(|| nearest_rotation(leaning)).unwrap_or(before)
    }
}

/// The rotation whose first two columns are nearest to these; none where they lie along one line.
fn nearest_rotation([a, b]: [DVec3; 2]) -> Option<DMat3> {
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    // (M* M)^(-1/2) of a matrix of two rows in closed form
    let root = (aa * bb - ab * ab).max(0.0).sqrt();
    if root <= FLAT * (aa + bb) {
        return None;
    }
    let scale = 1.0 / (root * (aa + bb + 2.0 * root).sqrt());
    let inverse = DMat2::from_cols(dvec2(bb + root, -ab), dvec2(-ab, aa + root)) * scale;
    let column = |c: DVec2| c.x * a + c.y * b;
    let (x, y) = (column(inverse.x_axis), column(inverse.y_axis));
    // once more by hand, for rounding
    let x = x.normalize();
    let z = x.cross(y).normalize();
    Some(DMat3::from_cols(x, z.cross(x), z))
}

#[cfg(test)]
mod tests {
    use super::super::longest_stretch;
    use super::*;
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
    fn in_every_fold_plates_keep_their_shape_and_no_rope_is_stretched() {
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
    fn a_plate_that_lies_in_one_leg_goes_with_it() {
        let (net, plates) = net();
        let turned = DMat3::from_cols(DVec3::Z, DVec3::NEG_Y, DVec3::X);
        let mut packed: Vec<DVec3> = net.nodes.iter().map(|&node| turned * node + DVec3::ONE).collect();
        let exact = packed.clone();
        for turn in StiffPlate::lay_in_folds(&plates, &net, &mut packed) {
            assert!(turn.abs_diff_eq(turned, 1e-12));
        }
        assert!(exact.iter().zip(&packed).all(|(one, other)| one.distance(*other) < 1e-12));
    }

    #[test]
    fn the_nearest_rotation_has_the_least_squares() {
        let m = [DVec3::new(1.0, 0.3, -0.2), DVec3::new(0.1, 0.7, 0.5)];
        let found = nearest_rotation(m).unwrap();
        let distance = |r: DMat3| r.x_axis.distance_squared(m[0]) + r.y_axis.distance_squared(m[1]);
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            for angle in [-1e-4, 1e-4] {
                assert!(distance(DMat3::from_axis_angle(axis, angle) * found) > distance(found));
            }
        }
        assert_eq!(nearest_rotation([DVec3::X, 2.0 * DVec3::X]), None);
    }
}

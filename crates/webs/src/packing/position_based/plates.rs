//! Fits a plate to its displaced corners: finds its place and its attitude by least squares.
//!
//! The attitude is the orthogonal factor R = M (M* M)^(-1/2) of M = sum x q* over the corners. Here q is a corner in
//! the flat plate and x the displaced corner, both relative to their means. (Müller et al. 2005, see the
//! [module](super).)

use glam::{DMat2, DMat3, DVec2, DVec3, dvec2};

use crate::CutWeb;
use crate::packing::StiffPlate;

/// Corners this close to one line, relative, do not determine the rotation about the line.
const FLAT: f64 = 1e-9;

/// Relative weight of the previous rotation in this case.
const PREVIOUS_WEIGHT: f64 = 1e-6;

impl StiffPlate {
    /// Moves the hub to the mean of the corners. Returns the rotation against the flat web that fits the corners best.
    /// If the corners lie on one line, as in a plate folded in half, the `previous` rotation decides.
    pub(super) fn fit_corners(&self, cut_web: &CutWeb, previous: DMat3, packed: &mut [DVec3]) -> DMat3 {
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
        let weight = PREVIOUS_WEIGHT * size;
        let weighted = [columns[0] + weight * previous.x_axis, columns[1] + weight * previous.y_axis];
        nearest_rotation(columns).or_else(|| nearest_rotation(weighted)).unwrap_or(previous)
    }
}

/// The rotation with its first two columns nearest to these two vectors; none if these lie along one line.
fn nearest_rotation([a, b]: [DVec3; 2]) -> Option<DMat3> {
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    // (M* M)^(-1/2) of a 2 x 2 matrix in closed form
    let root = (aa * bb - ab * ab).max(0.0).sqrt();
    if root <= FLAT * (aa + bb) {
        return None;
    }
    let scale = 1.0 / (root * (aa + bb + 2.0 * root).sqrt());
    let inverse = DMat2::from_cols(dvec2(bb + root, -ab), dvec2(-ab, aa + root)) * scale;
    let column = |c: DVec2| c.x * a + c.y * b;
    let (x, y) = (column(inverse.x_axis), column(inverse.y_axis));
    // orthogonal once more, against rounding
    let x = x.normalize();
    let z = x.cross(y).normalize();
    Some(DMat3::from_cols(x, z.cross(x), z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_rotation_minimises_the_sum_of_squares() {
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

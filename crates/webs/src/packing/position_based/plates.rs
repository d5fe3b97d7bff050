//! Plates whose corners have moved: the place and the attitude that fit a plate's corners best.
//!
//! The attitude is the orthogonal factor of M = sum x q* over the corners. Here q is a corner in the flat plate and x the
//! same corner as it lies, both from their means. R = M (M* M)^(-1/2) is the rotation that is nearest in least squares.

use glam::{DMat2, DMat3, DVec2, DVec3, dvec2};

use crate::CutWeb;
use crate::packing::StiffPlate;

/// Corners that lie nearer to one line, relative, do not determine the rotation about it.
const FLAT: f64 = 1e-9;

/// How much the rotation before weighs then, relative.
const LEAN: f64 = 1e-6;

impl StiffPlate {
    /// Moves the hub to the mean of the corners. Returns the rotation against the flat web that fits the corners best;
    /// where a plate folded in half leaves it open, the one nearest to `before`.
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

/// The rotation whose first two columns are nearest to these two; none where these lie along one line.
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
    // orthogonal once more, against rounding
    let x = x.normalize();
    let z = x.cross(y).normalize();
    Some(DMat3::from_cols(x, z.cross(x), z))
}

#[cfg(test)]
mod tests {
    use super::*;

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

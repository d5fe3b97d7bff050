//! The directions that pictures of a net are drawn from.
//!
//! Every projection is orthographic: a metre has the same length all over a picture, so that a scale bar holds.

use glam::{DVec2, DVec3};

/// A viewing direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum View {
    /// From the side, the launch axis up. The line of sight is level; for a vertical launch it runs along world y.
    Side,
    /// As [`View::Side`], turned by 16° around the axis and raised by 23° towards the direction of flight.
    ThreeQuarter,
    /// From ahead, back along the launch axis.
    Ahead,
}

/// An orthographic camera.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Camera {
    right: DVec3,
    up: DVec3,
}

/// Sine and cosine of the angle around the axis, 16.3°. Rational, so that pictures are the same on all machines.
const AROUND: (f64, f64) = (7.0 / 25.0, 24.0 / 25.0);

/// Sine and cosine of the angle above the plane normal to the axis, 22.6°, rational too.
const RAISED: (f64, f64) = (5.0 / 13.0, 12.0 / 13.0);

impl Camera {
    /// A camera for a launch along `axis`, a unit vector.
    pub fn new(view: View, axis: DVec3) -> Self {
        // the direction from the side towards the viewer is level, and -y where the axis is vertical
        let toward = DVec3::Z.cross(axis).try_normalize().map_or(DVec3::NEG_Y, |level| -level);
        let right = axis.cross(toward);
        match view {
            View::Side => Self { right, up: axis },
            View::Ahead => Self { right, up: axis.cross(right) },
            View::ThreeQuarter => {
                let turned = AROUND.1 * toward - AROUND.0 * right;
                Self { right: AROUND.1 * right + AROUND.0 * toward, up: RAISED.1 * axis - RAISED.0 * turned }
            }
        }
    }

    /// A point in the camera's plane: right and up, m.
    pub fn project(&self, point: DVec3) -> DVec2 {
        DVec2::new(self.right.dot(point), self.up.dot(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_directions_of_a_camera_are_orthonormal() {
        for axis in [DVec3::Z, DVec3::X, DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.48, 0.64, 0.6), DVec3::NEG_Z] {
            for view in [View::Side, View::ThreeQuarter, View::Ahead] {
                let Camera { right, up } = Camera::new(view, axis);
                assert!((right.length() - 1.0).abs() < 1e-15 && (up.length() - 1.0).abs() < 1e-15, "{view:?} {axis}");
                assert!(right.dot(up).abs() < 1e-15, "{view:?} {axis}");
            }
        }
    }

    #[test]
    fn the_axis_points_up_or_at_the_viewer() {
        for axis in [DVec3::Z, DVec3::new(0.6, 0.0, 0.8)] {
            assert_eq!(Camera::new(View::Side, axis).project(axis).y, 1.0);
            let seen = Camera::new(View::ThreeQuarter, axis).project(axis);
            assert!(seen.x.abs() < 1e-15 && (seen.y - 12.0 / 13.0).abs() < 1e-15, "{seen}");
            assert!(Camera::new(View::Ahead, axis).project(axis).length() < 1e-15);
        }
        // for a vertical launch, x points right from the side and y points up from ahead
        assert_eq!(Camera::new(View::Side, DVec3::Z).project(DVec3::X), DVec2::X);
        assert_eq!(Camera::new(View::Ahead, DVec3::Z).project(DVec3::Y), DVec2::Y);
        // a point nearer to a raised viewer is lower in the picture
        assert!(Camera::new(View::ThreeQuarter, DVec3::Z).project(DVec3::NEG_Y).y < 0.0);
    }
}

//! Rigid bodies: a centre of mass that moves as a node does, and a rotation about it.
//!
//! A body's centre is a node of its own, with the body's mass. Ropes and sheets are tied to it at *ties*: nodes without
//! mass that the body carries, at fixed arms from its centre. The forces on its ties act on the body, as a force on its
//! centre and as a torque. A centre that is held makes the body turn about a fixed point; its inertia then is that
//! about this point.
//!
//! Between two torques the body turns freely: its angular momentum L in the world frame stays, and its orientation
//! follows a splitting of the rotational energy into its three principal parts, each of which turns about one principal
//! axis at a constant rate (Dullweber, Leimkuhler, McLachlan, J. Chem. Phys. 107, 1997, section III; McLachlan 1993):
//!
//! ```text
//! R+ = R  Rx(dt/2) Ry(dt/2) Rz(dt) Ry(dt/2) Rx(dt/2),    each by its own angle  dt (R^T L)_k / I_k
//! ```
//!
//! Symplectic, time-reversible, second order; |L| is kept to rounding, whatever the step. docs/theory/rigid-body.md.

use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// A rigid body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The node at its centre of mass, which has its mass.
    pub centre: usize,
    /// Moments of inertia about its principal axes, kg m^2. A rod has a small one about itself, not none.
    pub inertia: DVec3,
    /// Where it is tied.
    pub ties: Vec<Tie>,
}

/// A node that a body carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tie {
    /// The node; it has no mass.
    pub node: usize,
    /// From the body's centre, along its principal axes, m.
    pub arm: DVec3,
}

/// How a body is turned and turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rotation {
    /// From the body's principal axes to the world, a unit quaternion.
    pub orientation: DQuat,
    /// Angular momentum about the centre in the world frame, kg m^2/s.
    pub angular_momentum: DVec3,
}

impl Body {
    /// How it is turned by `orientation` and turns at `angular_velocity`, rad/s, in the world frame.
    pub fn turning(&self, orientation: DQuat, angular_velocity: DVec3) -> Rotation {
        let along_axes = orientation.inverse() * angular_velocity;
        Rotation { orientation, angular_momentum: orientation * (self.inertia * along_axes) }
    }

    /// Angular velocity in the world frame, rad/s.
    pub fn angular_velocity(&self, rotation: &Rotation) -> DVec3 {
        let along_axes = rotation.orientation.inverse() * rotation.angular_momentum;
        rotation.orientation * (along_axes / self.inertia)
    }

    /// Kinetic energy of rotation, J.
    pub fn rotational_energy(&self, rotation: &Rotation) -> f64 {
        0.5 * rotation.angular_momentum.dot(self.angular_velocity(rotation))
    }

    /// The orientation after turning freely for `dt` seconds.
    pub fn turned(&self, rotation: &Rotation, dt: f64) -> DQuat {
        let momentum = rotation.angular_momentum;
        let mut orientation = rotation.orientation;
        for (axis, share) in [(0, 0.5), (1, 0.5), (2, 1.0), (1, 0.5), (0, 0.5)] {
            let along_axis = (orientation.inverse() * momentum)[axis];
            orientation *= about(axis, share * dt * along_axis / self.inertia[axis]);
        }
        orientation.normalize()
    }
}

/// A rotation by `angle` about a coordinate axis.
fn about(axis: usize, angle: f64) -> DQuat {
    let (sin, cos) = libm::sincos(0.5 * angle);
    let mut part = DVec3::ZERO;
    part[axis] = sin;
    DQuat::from_xyzw(part.x, part.y, part.z, cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(inertia: [f64; 3]) -> Body {
        Body { centre: 0, inertia: inertia.into(), ties: Vec::new() }
    }

    /// Turns a body freely for `time` seconds in `steps` steps.
    fn free(body: &Body, mut rotation: Rotation, time: f64, steps: usize) -> Rotation {
        for _ in 0..steps {
            rotation.orientation = body.turned(&rotation, time / steps as f64);
        }
        rotation
    }

    #[test]
    fn a_symmetric_body_precesses_as_euler_says() {
        // I1 = I2: the axis of symmetry circles the angular momentum at the rate |L| / I1
        let body = body([2.0, 2.0, 3.0]);
        let start = body.turning(DQuat::IDENTITY, DVec3::new(1.0, 0.0, 4.0));
        let rate = start.angular_momentum.length() / 2.0;
        let quarter = 0.5 * std::f64::consts::PI / rate;
        let along = start.angular_momentum.normalize();
        let axis = free(&body, start, quarter, 2000).orientation * DVec3::Z;
        let across = DVec3::Z - along * DVec3::Z.dot(along);
        let expected = along * DVec3::Z.dot(along) + along.cross(across);
        assert!((axis - expected).length() < 1e-5, "{axis} instead of {expected}");
    }

    #[test]
    fn it_is_of_second_order_and_time_reversible() {
        let body = body([1.0, 2.0, 3.5]);
        let start = body.turning(DQuat::IDENTITY, DVec3::new(1.0, 2.0, 3.0));
        let exact = free(&body, start, 1.0, 20_000).orientation;
        let error = |steps| free(&body, start, 1.0, steps).orientation.angle_between(exact);
        let ratio = error(50) / error(100);
        assert!((ratio - 4.0).abs() < 0.2, "halving the step divides the error by {ratio}");

        let there = free(&body, start, 1.0, 50);
        let back = free(&body, there, -1.0, 50);
        assert!(back.orientation.angle_between(start.orientation) < 1e-12);
    }

    #[test]
    fn turning_about_the_middle_axis_tumbles_and_keeps_its_energy() {
        let body = body([1.0, 2.0, 3.0]);
        let start = body.turning(DQuat::IDENTITY, DVec3::new(1e-3, 5.0, 0.0));
        let mut rotation = start;
        let (mut lowest, mut worst) = (1.0, 0.0f64);
        for _ in 0..20_000 {
            rotation.orientation = body.turned(&rotation, 1e-3);
            lowest = f64::min(lowest, (rotation.orientation * DVec3::Y).y);
            let energy = body.rotational_energy(&rotation) / body.rotational_energy(&start);
            worst = worst.max((energy - 1.0).abs());
        }
        assert!(lowest < -0.99, "the middle axis never turned over: {lowest}");
        assert!(worst < 1e-4, "{worst}");
    }
}

//! How a tractor is thrown, and the launch frame.

use std::f64::consts::FRAC_PI_2;

use glam::{DMat3, DVec3};
use netcast_dynamics::launcher::Push;
use netcast_scenario::{Launch, Scenario};

/// How one tractor is thrown, with its scatter.
#[derive(Debug, Clone, PartialEq)]
pub struct Throw {
    /// The corner that it is tied to, from 1.
    pub corner: u32,
    /// Its node; the centre of a tractor that is a rigid body.
    pub node: usize,
    /// Time until it starts, s.
    pub delay: f64,
    /// Direction of its flight, a unit vector in the world frame; the launch axis for a tractor at rest.
    pub direction: DVec3,
    /// The cause of its motion.
    pub by: Thrown,
    /// Its launcher in the system; none where it has its velocity from the start.
    pub launcher: Option<usize>,
}

impl Throw {
    /// The angle between its direction and the launch axis, rad.
    pub fn angle_to(&self, axis: DVec3) -> f64 {
        libm::atan2(self.direction.cross(axis).length(), self.direction.dot(axis))
    }
}

/// The cause of a tractor's motion.
#[derive(Debug, Clone, PartialEq)]
pub enum Thrown {
    /// It starts with this velocity, m/s, world frame.
    At(DVec3),
    /// A force drives it through a tube.
    From {
        /// The stroke of the tube, m.
        stroke: f64,
        /// The force along the stroke or over time.
        push: Push,
    },
}

/// Rotation from the launch frame to the world frame: z to the launch axis. The identity without a launch.
pub fn frame(scenario: &Scenario) -> DMat3 {
    launch_frame(&scenario.launch.clone().unwrap_or_default())
}

/// Rotation first about y by the angle from the vertical, then about z by the azimuth.
pub(super) fn launch_frame(launch: &Launch) -> DMat3 {
    let tilt = FRAC_PI_2 - launch.elevation.si();
    let azimuth = launch.azimuth.si();
    let (ct, st) = (libm::cos(tilt), libm::sin(tilt));
    let (ca, sa) = (libm::cos(azimuth), libm::sin(azimuth));
    let about_y = DMat3::from_cols(DVec3::new(ct, 0.0, -st), DVec3::Y, DVec3::new(st, 0.0, ct));
    let about_z = DMat3::from_cols(DVec3::new(ca, sa, 0.0), DVec3::new(-sa, ca, 0.0), DVec3::Z);
    about_z * about_y
}

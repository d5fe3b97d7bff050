//! How a tractor is thrown, and the frame in which it is.

use std::f64::consts::FRAC_PI_2;

use glam::{DMat3, DVec3};
use netcast_dynamics::launcher::Push;
use netcast_scenario::{Launch, Scenario};

/// How one tractor is thrown: as the scenario says, and as chance has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Throw {
    /// The corner that it is tied to, from 1.
    pub corner: u32,
    /// Its node; a rigid body's centre.
    pub node: usize,
    /// How long it stays where it is, s.
    pub delay: f64,
    /// The way it goes, a unit vector in the world frame; the launch axis where it goes nowhere.
    pub direction: DVec3,
    /// What sets it in motion.
    pub by: Thrown,
    /// Its launcher in the system; none where it is thrown at the start.
    pub launcher: Option<usize>,
}

impl Throw {
    /// The angle between its way and the launch axis, rad.
    pub fn angle_to(&self, axis: DVec3) -> f64 {
        libm::atan2(self.direction.cross(axis).length(), self.direction.dot(axis))
    }
}

/// What sets a tractor in motion.
#[derive(Debug, Clone, PartialEq)]
pub enum Thrown {
    /// It has this velocity, m/s, world frame.
    At(DVec3),
    /// A force, along so many metres of tube.
    From {
        /// The length of its way, m.
        stroke: f64,
        /// The force.
        push: Push,
    },
}

/// Turns the launch frame to the world: z to (azimuth, elevation).
pub fn frame(scenario: &Scenario) -> DMat3 {
    turned(&scenario.launch.clone().unwrap_or_default())
}

/// First about y by the angle from the vertical, then about z by the azimuth.
pub(super) fn turned(launch: &Launch) -> DMat3 {
    let tilt = FRAC_PI_2 - launch.elevation.si();
    let azimuth = launch.azimuth.si();
    let (ct, st) = (libm::cos(tilt), libm::sin(tilt));
    let (ca, sa) = (libm::cos(azimuth), libm::sin(azimuth));
    let about_y = DMat3::from_cols(DVec3::new(ct, 0.0, -st), DVec3::Y, DVec3::new(st, 0.0, ct));
    let about_z = DMat3::from_cols(DVec3::new(ca, sa, 0.0), DVec3::new(-sa, ca, 0.0), DVec3::Z);
    about_z * about_y
}

//! The net as an observer sees it: after a step, and at a record time.

use crate::body::Rotation;
use crate::energy::Ledger;
use crate::time::step::Stepper;
use glam::DVec3;

/// The net after a step, for measures that must not miss one. Nothing is computed until asked for.
pub struct Live<'s, 'a> {
    /// Positions are those of this time, s.
    pub position_time: f64,
    /// Velocities are those of this time, half a step earlier, s.
    pub velocity_time: f64,
    /// Tensions are those of this time, a step earlier, s.
    pub tension_time: f64,
    /// Step, s.
    pub dt: f64,
    /// The net.
    pub net: &'s Stepper<'a>,
}

/// The whole net at one time.
pub struct Frame<'s> {
    /// Time, s.
    pub time: f64,
    /// Step number.
    pub step: u64,
    /// Positions, m, (nodes,).
    pub position: &'s [DVec3],
    /// Velocities, m/s, (nodes,).
    pub velocity: &'s [DVec3],
    /// Rotations of rigid bodies, (bodies,).
    pub rotation: &'s [Rotation],
    /// Tensions, N, (segments,); NaN where a segment is broken.
    pub tension: &'s [f64],
    /// The energy balance.
    pub ledger: Ledger,
    /// Residual of the balance since the start, J.
    pub residual: f64,
    /// The net between its forces and its advance, for what is not in the fields above, such as the forces of one effect.
    pub net: &'s Stepper<'s>,
}

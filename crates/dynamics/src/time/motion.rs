//! The state on which a step depends.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::effects::Memory;
use crate::moving::Turning;
use crate::rope_state::RopeState;

/// Positions, velocities and memory of a net between two steps: a [`Stepper`](super::step::Stepper) started from it computes the same bits as the one it
/// was taken from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Motion {
    /// Positions, m, (nodes,).
    pub position: Vec<DVec3>,
    /// Velocities half a step before the positions, m/s, (nodes,).
    pub half_step_velocity: Vec<DVec3>,
    /// Velocities extrapolated to the positions, m/s, (nodes,).
    pub extrapolated: Vec<DVec3>,
    /// How rigid bodies turn, (bodies,).
    pub turning: Vec<Turning>,
    /// Memory of effects.
    pub effects: Memory,
    /// Steps taken.
    pub step: u64,
    /// State of segments' laws, and which are broken; those that break in this step are still whole.
    pub ropes: RopeState,
}

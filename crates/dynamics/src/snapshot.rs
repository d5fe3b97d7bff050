//! Where a run stands: all that its future depends on.
//!
//! A snapshot is taken at a record, after the observer has seen it and before the step goes on. Positions, half-step
//! velocities and extrapolated velocities fix the forces, so neither forces nor tensions are kept: they are computed
//! again, to the same bits. The work that ropes lose is summed from one length to the next; it is in the losses already
//! when the snapshot is taken, and over an unchanged length there is none to add. See docs/restart.md.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::energy::{Balance, Ledger, Losses};
use crate::limits::Excess;
use crate::simulate::Schedule;
use crate::system::System;

/// What moves, by node: a [`Stepper`](crate::time::step::Stepper) started from it computes the same bits as the one it
/// was taken from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Motion {
    /// Positions, m, (nodes,).
    pub position: Vec<DVec3>,
    /// Velocities half a step before the positions, m/s, (nodes,).
    pub half_step_velocity: Vec<DVec3>,
    /// Velocities extrapolated to the positions, m/s, (nodes,).
    pub extrapolated: Vec<DVec3>,
}

/// A run at a record time. It goes on by [`resume`](crate::simulate::resume).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    pub(crate) step: u64,
    pub(crate) motion: Motion,
    pub(crate) losses: Losses,
    pub(crate) balance: Balance,
    pub(crate) ledger: Ledger,
    pub(crate) exceeded: Option<Excess>,
}

/// Why a run cannot go on from a snapshot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SnapshotError {
    /// It is one of another system.
    #[error("the snapshot has {what} of {found} nodes, the system has {expected}")]
    Nodes {
        /// Which quantity.
        what: &'static str,
        /// Number of nodes in the snapshot.
        found: usize,
        /// Number of nodes of the system.
        expected: usize,
    },
    /// It is one of another schedule.
    #[error("the snapshot was taken at step {step}, which is no record before the last")]
    Step {
        /// Its step.
        step: u64,
    },
}

impl Snapshot {
    /// The step that is next.
    pub fn step(&self) -> u64 {
        self.step
    }

    /// Whether a run of `system` along `schedule` can go on from here.
    ///
    /// # Errors
    /// [`SnapshotError`] where it is a snapshot of something else.
    pub fn check(&self, system: &System, schedule: &Schedule) -> Result<(), SnapshotError> {
        let Motion { position, half_step_velocity, extrapolated } = &self.motion;
        let expected = system.mass().len();
        let arrays = [
            ("positions", position.len()),
            ("half-step velocities", half_step_velocity.len()),
            ("extrapolated velocities", extrapolated.len()),
        ];
        if let Some((what, found)) = arrays.into_iter().find(|(_, found)| *found != expected) {
            return Err(SnapshotError::Nodes { what, found, expected });
        }
        match self.step < schedule.count && schedule.records(self.step) {
            true => Ok(()),
            false => Err(SnapshotError::Step { step: self.step }),
        }
    }
}

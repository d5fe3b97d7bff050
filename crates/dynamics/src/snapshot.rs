//! A snapshot of a run: all that the future of the run depends on.
//!
//! A snapshot is taken at a record, after the observer has seen it and before the step goes on. Positions, half-step
//! velocities, extrapolated velocities and the state of ropes determine the forces. So neither forces nor tensions are kept:
//! they are computed again, to the same bits. The losses of ropes are summed over changes of length. They are complete when the
//! snapshot is taken, and the first forces after it add nothing, since no length has changed. See docs/restart.md.

use serde::{Deserialize, Serialize};

use crate::energy::{Balance, Ledger, Losses};
use crate::forces::breaking::Break;
use crate::limits::Excess;
use crate::rope_state::RopeState;
use crate::schedule::Schedule;
use crate::system::System;
use crate::time::motion::Motion;

/// A run at a record; [`resume`](crate::simulate::resume) continues it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    pub(crate) motion: Motion,
    pub(crate) losses: Losses,
    pub(crate) balance: Balance,
    pub(crate) ledger: Ledger,
    pub(crate) exceeded: Option<Excess>,
    pub(crate) breaks: Vec<Break>,
}

/// Why a run cannot go on from a snapshot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SnapshotError {
    /// It was taken of another system.
    #[error("the snapshot has {found} {what}, the system has {expected}")]
    Shape {
        /// Which quantity.
        what: &'static str,
        /// How many the snapshot has.
        found: usize,
        /// How many the system has.
        expected: usize,
    },
    /// It was taken on another schedule: this one has no record at its step.
    #[error("the snapshot was taken at step {step}, where the schedule has no record")]
    Step {
        /// The step of the snapshot.
        step: u64,
    },
}

impl Snapshot {
    /// The next step.
    pub fn step(&self) -> u64 {
        self.motion.step
    }

    /// Whether a run of `system` along `schedule` can go on from here.
    ///
    /// # Errors
    /// [`SnapshotError`] where it is a snapshot of something else.
    pub fn check(&self, system: &System, schedule: &Schedule) -> Result<(), SnapshotError> {
        let Motion { position, half_step_velocity, extrapolated, turning, effects, step, ropes } = &self.motion;
        let RopeState { memory, broken } = ropes;
        let (nodes, segments) = (system.mass().len(), system.segments().len());
        let arrays = [
            ("positions of nodes", position.len(), nodes),
            ("half-step velocities of nodes", half_step_velocity.len(), nodes),
            ("extrapolated velocities of nodes", extrapolated.len(), nodes),
            ("rotations of bodies", turning.len(), system.bodies().len()),
            ("segments", broken.len(), segments),
            ("segments that remember", memory.len(), if system.remembers() { segments } else { 0 }),
        ];
        let array = arrays.into_iter().find(|(_, found, expected)| found != expected);
        if let Some((what, found, expected)) = array.or_else(|| effects.misfit(system.parts())) {
            return Err(SnapshotError::Shape { what, found, expected });
        }
        if *step <= schedule.count && schedule.records(*step) {
            Ok(())
        } else {
            Err(SnapshotError::Step { step: *step })
        }
    }
}

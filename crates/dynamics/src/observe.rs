//! The interface through which a caller watches a run.

use crate::frame::{Frame, Live};
use crate::limits::Limits;
use crate::snapshot::Snapshot;

/// Watches a run; it may be called from another thread than the one that started the run.
pub trait Observer: Send {
    /// After every step.
    fn step(&mut self, live: &Live);
    /// At every record time, the start and the end among them.
    fn record(&mut self, frame: &Frame);
    /// Limits of the run, asked at its start.
    fn limits(&self) -> Limits {
        Limits::NONE
    }
    /// The names of the effects whose forces it wants to see, asked at its start; [`crate::effects::EFFECTS`] has them.
    /// They are in [`Stepper::forces_of`](crate::time::step::Stepper::forces_of) of every step.
    fn watches(&self) -> Vec<&'static str> {
        Vec::new()
    }
    /// Asked at every record time but the last: whether to stop here.
    fn interrupted(&self) -> bool {
        false
    }
    /// Asked at every record time but the last: whether [`Observer::snapshot`] should be called now.
    fn wants_snapshot(&mut self) -> bool {
        false
    }
    /// Where the run stands, after the record: when it was wanted, and before an interrupted run stops.
    fn snapshot(&mut self, _: &Snapshot) {}
}

//! The interface through which a caller watches a run.

use crate::frame::{Frame, Live};
use crate::limits::Limits;
use crate::snapshot::Snapshot;

/// Watches a run; it may be called from another thread than the one that started the run.
pub trait Observer: Send {
    /// After every step.
    fn step(&mut self, live: &Live);
    /// At every record, the start and the end among them.
    fn record(&mut self, frame: &Frame);
    /// At every check, the start and the end among them. Checks do not depend on what is recorded.
    fn check(&mut self, _: &Frame) {}
    /// Asked after every step: whether [`Observer::moment`] should see the net as it now lies.
    fn wants_moment(&mut self) -> bool {
        false
    }
    /// The whole net at a step that was wanted.
    fn moment(&mut self, _: &Frame) {}
    /// Limits of the run, asked at its start.
    fn limits(&self) -> Limits {
        Limits::NONE
    }
    /// The names of the effects whose forces it wants to see, asked at its start; [`crate::effects::EFFECTS`] has them.
    /// They are in [`Stepper::forces_of`](crate::time::step::Stepper::forces_of) of every step.
    fn watches(&self) -> Vec<&'static str> {
        Vec::new()
    }
    /// Asked at every record but the last: whether to stop here.
    fn interrupted(&self) -> bool {
        false
    }
    /// Asked at every record but the last: whether [`Observer::snapshot`] should be called now.
    fn wants_snapshot(&mut self) -> bool {
        false
    }
    /// Asked at the last record of a run that went well: whether [`Observer::snapshot`] should be called there too.
    fn wants_last_snapshot(&mut self) -> bool {
        false
    }
    /// Where the run stands, after the record: when it was wanted, and before an interrupted run stops.
    fn snapshot(&mut self, _: &Snapshot) {}
}

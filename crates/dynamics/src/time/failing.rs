//! The segments that break at the last forces, by their numbers in the system.

use super::blocks::Ropes;
use super::rupture::Failing;
use crate::system::System;

/// A segment that breaks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BreakingSegment {
    /// Which segment.
    pub segment: usize,
    /// Its tension, N, which acts for the last time.
    pub tension: f64,
    /// Elastic energy that it holds, J.
    pub energy: f64,
}

/// The segments that break under the last tensions of these blocks.
pub(super) fn failing<'r>(ropes: &'r [Ropes], system: &'r System) -> impl Iterator<Item = BreakingSegment> + use<'r> {
    ropes.iter().zip(system.layout().blocks()).flat_map(|(ropes, plan)| {
        let segment = |slot: usize| plan.slots[slot].segment.expect("only segments break");
        let failure =
            move |f: &Failing| BreakingSegment { segment: segment(f.slot), tension: f.tension, energy: f.energy };
        ropes.failing.iter().map(failure)
    })
}

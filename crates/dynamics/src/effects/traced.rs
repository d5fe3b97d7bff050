//! A force whose work is integrated from step to step.

use glam::DVec3;

/// A force and where it acted at the last forces. Before the first forces of a run it holds zeros: their work is ignored.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct TracedWork {
    force: DVec3,
    place: DVec3,
}

impl TracedWork {
    /// The work, J, between the forces before and these, `force`, N, at `place`, m: force times way, trapezoidal rule.
    pub fn work(&mut self, force: DVec3, place: DVec3) -> f64 {
        let before = std::mem::replace(self, TracedWork { force, place });
        0.5 * (before.force + force).dot(place - before.place)
    }

    /// Whether there was a force.
    pub fn is_acting(&self) -> bool {
        self.force != DVec3::ZERO
    }
}

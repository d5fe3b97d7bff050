//! A load: a given force on a node, there from the start or brought up evenly in time.
//!
//! ```text
//! F(t) = F min(t / t_r, 1)        t_r the ramp, s; 0: F from the start
//! ```
//!
//! The energy of a load that is there from the start is -F.x, relative to the origin. One that is brought up has none
//! that a state could tell: what it has done is counted on the way, by the trapezoidal rule.

use glam::DVec3;

/// A force on a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Which node.
    pub node: usize,
    /// Force in the world frame, N.
    pub force: DVec3,
    /// Time over which it is brought up, s; 0 where it is there from the start.
    pub ramp: f64,
}

impl Load {
    /// The force at a time of at least 0 s, N.
    pub fn at(&self, time: f64) -> DVec3 {
        if time >= self.ramp { self.force } else { (time / self.ramp) * self.force }
    }

    /// Whether it is there from the start.
    pub fn is_steady(&self) -> bool {
        self.ramp == 0.0
    }
}

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

/// Adds the loads at `time`, s, to `force`, N, (nodes,).
pub fn add_force(loads: &[Load], time: f64, force: &mut [DVec3]) {
    for load in loads {
        force[load.node] += load.at(time);
    }
}

/// Potential energy of all loads that are there from the start, relative to the origin, J; `position` in m, (nodes,).
pub fn energy(loads: &[Load], position: &[DVec3]) -> f64 {
    let steady = loads.iter().filter(|load| load.is_steady());
    0.0 - steady.map(|load| load.force.dot(position[load.node])).sum::<f64>()
}

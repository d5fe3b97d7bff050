//! A load: a constant force on a node.
//!
//! Its energy is -F.x, relative to the origin.

use glam::DVec3;

/// A constant force on a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Which node.
    pub node: usize,
    /// Force in the world frame, N.
    pub force: DVec3,
}

/// Adds the loads to `force`, N, (nodes,).
pub fn add_force(loads: &[Load], force: &mut [DVec3]) {
    for load in loads {
        force[load.node] += load.force;
    }
}

/// Potential energy of all loads relative to the origin, J; `position` in m, (nodes,).
pub fn energy(loads: &[Load], position: &[DVec3]) -> f64 {
    0.0 - loads.iter().map(|load| load.force.dot(position[load.node])).sum::<f64>()
}

//! All that evolves: where the nodes are and how fast they move.

use glam::DVec3;

/// Positions and velocities of all nodes at one time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct State {
    /// Positions, m; shape (nodes,).
    pub position: Vec<DVec3>,
    /// Velocities, m/s; shape (nodes,).
    pub velocity: Vec<DVec3>,
}

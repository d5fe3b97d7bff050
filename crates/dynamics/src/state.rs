//! All that evolves: where the nodes are and how fast they move, how bodies are turned and turn.

use glam::DVec3;

use crate::body::Rotation;

/// The whole net at one time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct State {
    /// Positions, m; shape (nodes,).
    pub position: Vec<DVec3>,
    /// Velocities, m/s; shape (nodes,).
    pub velocity: Vec<DVec3>,
    /// Rotations of rigid bodies; shape (bodies,). Their ties are where these say, whatever stands in `position`.
    pub rotation: Vec<Rotation>,
}

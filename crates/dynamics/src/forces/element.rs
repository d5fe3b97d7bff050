//! An element: a few nodes, and a force of its own among them. What a segment is for ropes, for everything else.
//!
//! Bending joins three nodes, a piece of sheet three, a hinge between two of them four. An element says what it does at
//! one instant; [`crate::time`] gathers its nodes, sums what it does to them, and counts what it loses.

use glam::DVec3;

/// What an element does to its nodes at one instant, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress<const N: usize> {
    /// The part that derives from its elastic energy.
    pub elastic: [DVec3; N],
    /// The rest, whose work is lost.
    pub friction: [DVec3; N],
}

/// An element between `N` nodes.
pub trait Element<const N: usize>: Sync {
    /// Its nodes.
    fn nodes(&self) -> [usize; N];

    /// What it does to its nodes, which are at `x`, m, and move at `w`, m/s.
    fn pull(&self, x: [DVec3; N], w: [DVec3; N]) -> Stress<N>;

    /// What it has stored, J, with its nodes at `x`, m.
    fn elastic_energy(&self, x: [DVec3; N]) -> f64;

    /// A bound on its stiffness, N/m, node by node: for any displacements u of its nodes the second derivative of its
    /// energy along u is at most the sum of 2 k |u|^2. A segment's is its k at each end.
    fn stiffness(&self) -> [f64; N];

    /// The same for its damping, N s/m.
    fn damping(&self) -> [f64; N];
}

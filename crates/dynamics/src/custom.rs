//! An effect of the caller's own: a force that netcast does not know, added to a system without a change to this crate.

use std::fmt::Debug;

use glam::DVec3;

use crate::moving::Net;

/// A force on nodes, asked for at every step. Put it into [`SystemParts::custom`](crate::parts::SystemParts::custom).
///
/// Its work is summed along the way of each node by the trapezoidal rule, as that of every other force; it is the channel
/// `custom` of the energy balance. The same bits come out on any number of threads as long as it computes the same.
///
/// An example is `examples/magnet.rs` of this crate.
pub trait CustomEffect: Debug + Send + Sync {
    /// Its name where a caller asks for its forces.
    fn name(&self) -> &str;

    /// The nodes that it may exert a force on, each once.
    fn nodes(&self) -> Vec<usize>;

    /// Adds its force on each node at `time`, s, to `force`, N, (nodes,). `net` tells where a node is and how it moves.
    ///
    /// It may be asked more than once at the same time and place: at a record, and where a run goes on. Its state
    /// must then be the same as after one call.
    fn act(&mut self, time: f64, net: &dyn Net, force: &mut [DVec3]);

    /// A bound on how stiff it makes a node, N/m, and how much it damps one, N s/m: the largest change of its force
    /// against position and against velocity. The step has to resolve it. Nothing for a force that hardly changes.
    fn bound(&self) -> Vec<(usize, f64, f64)> {
        Vec::new()
    }

    /// State that it needs, beside the positions of nodes, to go on after an interruption.
    fn memory(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Restores its state.
    fn remember(&mut self, _memory: &[f64]) {}

    /// A copy of its own. `Box::new(self.clone())` for what is `Clone`.
    fn boxed_clone(&self) -> Box<dyn CustomEffect>;
}

impl Clone for Box<dyn CustomEffect> {
    fn clone(&self) -> Self {
        self.boxed_clone()
    }
}

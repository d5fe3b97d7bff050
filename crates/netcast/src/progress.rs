//! The progress of a run, reported while it goes on.

/// The progress of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Progress {
    /// The search for the equilibrium.
    Relaxing {
        /// Iterations so far.
        iterations: u64,
        /// Largest unbalanced force over the largest tension, bending force or load.
        residual: f64,
        /// The residual that ends the search.
        tolerance: f64,
    },
    /// The run in time.
    Running {
        /// Simulated time so far, s.
        time_s: f64,
        /// Time at which the run ends, s.
        end_s: f64,
    },
}

/// A callback for the progress of a run.
pub(crate) type Tell<'s> = dyn FnMut(Progress) + Send + 's;
/// A function that returns true once a run should stop.
pub(crate) type Interrupted<'s> = dyn Fn() -> bool + Sync + 's;

//! How far a run is, told while it goes on.

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Progress {
    /// On the way to its equilibrium.
    Relaxing {
        /// Iterations so far.
        iterations: u64,
        /// Largest force out of balance, over the largest tension or load.
        residual: f64,
        /// The residual that is asked for.
        tolerance: f64,
    },
    /// In time.
    Running {
        /// Time simulated so far, s.
        time_s: f64,
        /// Time at which the run ends, s.
        end_s: f64,
    },
}

/// Hears how far a run is.
pub(crate) type Tell<'s> = dyn FnMut(Progress) + Send + 's;
/// Whether a run should stop.
pub(crate) type Interrupted<'s> = dyn Fn() -> bool + Sync + 's;

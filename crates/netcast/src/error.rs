//! Why there is no result.

use std::path::PathBuf;

use netcast_report::ReportError;
use netcast_results::ResultError;
use netcast_scenario::Diagnostics;

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The input is wrong.
    #[error(transparent)]
    Input(#[from] Diagnostics),
    /// The results cannot be written.
    #[error(transparent)]
    Result(#[from] ResultError),
    /// The report cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The run that should be resumed was one of other inputs.
    #[error("{} was a run of other inputs: {differences}", folder.display())]
    OtherInputs {
        /// Where it is.
        folder: PathBuf,
        /// What differs.
        differences: String,
    },
    /// The results of a run could not be written to their end.
    #[error("{source}; what was computed is in {}", folder.display())]
    CutOff {
        /// What went wrong.
        source: Box<RunError>,
        /// Where the results are, as far as they could be written.
        folder: PathBuf,
    },
}

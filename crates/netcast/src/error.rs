//! The errors of a run that gives no result.

use std::path::PathBuf;

use netcast_report::ReportError;
use netcast_results::ResultError;
use netcast_scenario::Diagnostics;

/// A run that gives no result, or only a part of one.
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
    /// The run to resume has other inputs than the scenario.
    #[error("{} holds a run with other inputs: {differences}", folder.display())]
    OtherInputs {
        /// The folder of the run.
        folder: PathBuf,
        /// The differences, in words.
        differences: String,
    },
    /// Writing the results failed during the run.
    #[error("{source}; what was computed is in {}", folder.display())]
    CutOff {
        /// The cause.
        source: Box<RunError>,
        /// The folder that holds the results up to then.
        folder: PathBuf,
    },
}

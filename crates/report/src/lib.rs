//! A result folder as one HTML page that works offline.
//!
//! ```text
//!  summary.json ──▶ words    what happened, in a designer's words ─┐
//!               ──▶ tables   the numbers                           ├─▶ page ──▶ report.html
//!  history.csv  ──▶ figures  the curves                            │
//!  fields.vtkhdf ─▶ replay   the net in three dimensions           │
//!  manifest.json ─▶ provenance                                    ─┘
//! ```
//!
//! The page contains its charting library, and its security policy blocks the network. The report reads the result
//! folder alone, so it also works on results of other versions: a missing or null value is left out.

mod compare;
mod error;
mod figures;
mod format;
mod page;
mod pictures;
mod replay;
mod results;
mod tables;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

pub use compare::write_comparison;
pub use error::ReportError;
pub use pictures::write_pictures;
pub use words::words;

use netcast_results::{SummaryFile, folder};

use results::Results;

/// Reads all files of a run that a report needs.
///
/// # Errors
/// [`ReportError`] names the first that is missing, malformed or cut off.
pub fn check_results(result_dir: &Path) -> Result<(), ReportError> {
    let results = Results::read(result_dir)?;
    let last_row = results.column("time_s").and_then(|times| times.into_iter().flatten().last());
    let last_frame = results.scene.as_ref().and_then(|scene| scene.fields.times.last().copied());
    if last_row.is_none() || last_frame > last_row {
        return Err(ReportError::CutHistory { path: result_dir.join(folder::HISTORY) });
    }
    Ok(())
}

/// Writes `report.html` into `result_dir` from the `summary.json`, `history.csv` and `manifest.json` there, and returns
/// its path. For the folder of a comparison it calls [`write_comparison`].
///
/// # Errors
/// [`ReportError`] names the file that is missing, malformed or cannot be written.
pub fn write_report(result_dir: &Path) -> Result<PathBuf, ReportError> {
    if SummaryFile::read(result_dir)?.is_of_comparison() {
        return write_comparison(result_dir);
    }
    let results = Results::read(result_dir)?;
    let path = result_dir.join(folder::REPORT);
    fs::write(&path, page::html(&results)).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    Ok(path)
}

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

//! A result folder as one HTML page that works offline.
//!
//! ```text
//!  summary.json ──▶ words    what happened, in a designer's words ─┐
//!               ──▶ tables   the numbers                           ├─▶ page ──▶ report.html
//!  history.csv  ──▶ figures  the curves                            │
//!  manifest.json ─▶ provenance                                    ─┘
//! ```
//!
//! The page carries its charting library with it and forbids itself the network. It reads the folder and nothing else,
//! so any result can be reported anew, by whatever version wrote it: what is missing or null is left out.

mod error;
mod figures;
mod format;
mod page;
mod results;
mod tables;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

pub use error::ReportError;
pub use words::words;

use results::Results;

/// Writes `report.html` into `result_dir` from the `summary.json`, `history.csv` and `manifest.json` there, and returns
/// its path.
///
/// # Errors
/// [`ReportError`] names the file that is missing, malformed or cannot be written.
pub fn write_report(result_dir: &Path) -> Result<PathBuf, ReportError> {
    let results = Results::read(result_dir)?;
    let path = result_dir.join("report.html");
    fs::write(&path, page::html(&results)).map_err(|source| ReportError::Write { path: path.clone(), source })?;
    Ok(path)
}

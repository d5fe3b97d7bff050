//! Names of the files and folders in a result folder, and what may stand under them.

use std::fs;
use std::path::Path;

use crate::ResultError;

/// The resolved scenario, with the files it names.
pub const INPUTS: &str = "inputs";
/// The numbers of the run.
pub const SUMMARY: &str = "summary.json";
/// The table of a comparison.
pub const SUMMARY_CSV: &str = "summary.csv";
/// One row for each record step.
pub const HISTORY: &str = "history.csv";
/// Every node and rope at every record step.
pub const FIELDS: &str = "fields.vtkhdf";
/// Names of nodes and segments in the fields.
pub const LANDMARKS: &str = "landmarks.json";
/// The report as an HTML page.
pub const REPORT: &str = "report.html";
/// Pictures for documents, where the user asked for them.
pub const PICTURES: &str = "pictures";
/// Program, inputs, machine and time of the run.
pub const MANIFEST: &str = "manifest.json";

/// The state from which a run that did not end can go on.
pub const CHECKPOINT: &str = "checkpoint";
/// The fields of a run that has not ended.
pub const FIELDS_PART: &str = "fields.part";
/// The lock that a run holds on its folder, which keeps other runs out.
pub const LOCK: &str = "lock";

/// All names that netcast writes into a result folder, except for the folders of the designs of a comparison.
pub const OURS: [&str; 12] = [
    INPUTS,
    SUMMARY,
    SUMMARY_CSV,
    HISTORY,
    FIELDS,
    LANDMARKS,
    REPORT,
    PICTURES,
    MANIFEST,
    CHECKPOINT,
    FIELDS_PART,
    LOCK,
];

/// Checks that what stands in `folder` under our names is a file or a folder: whoever opens a named pipe may wait for ever.
/// `with_links` says whether it may also be a link to one; where netcast writes it may not, since the write would go
/// through the link.
///
/// # Errors
/// [`ResultError::NotAFile`].
pub fn require_files(folder: &Path, with_links: bool) -> Result<(), ResultError> {
    for path in OURS.iter().map(|name| folder.join(name)) {
        let found = if with_links { fs::metadata(&path) } else { fs::symlink_metadata(&path) };
        if found.is_ok_and(|found| !found.is_file() && !found.is_dir()) {
            return Err(ResultError::NotAFile { path });
        }
    }
    Ok(())
}

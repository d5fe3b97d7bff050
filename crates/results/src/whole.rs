//! Files that are either complete or absent: written under another name, synced, then renamed.

use std::ffi::OsString;
use std::fs::{self, File};
use std::path::Path;

use crate::ResultError;

/// Suffix of the name of a file until the file is complete.
pub const UNFINISHED: &str = ".new";

/// Replaces the file at `path` by the one that `make` writes to the path it is given.
///
/// # Errors
/// Those of `make`, or [`ResultError::Write`]. An older file at `path` then stays.
pub fn write(path: &Path, make: impl FnOnce(&Path) -> Result<(), ResultError>) -> Result<(), ResultError> {
    let mut name = OsString::from(path.file_name().unwrap_or_default());
    name.push(UNFINISHED);
    let unfinished = path.with_file_name(name);
    let written = make(&unfinished).and_then(|()| {
        let synced = File::open(&unfinished).and_then(|file| file.sync_all());
        synced.and_then(|()| fs::rename(&unfinished, path)).map_err(ResultError::write(path))
    });
    if written.is_err() {
        // the first error is the one to report
        let _ = fs::remove_file(&unfinished);
    }
    written
}

/// Syncs the list of names in a folder, if the system can, so that a rename survives a loss of power.
pub fn sync_folder(folder: &Path) {
    // a failure has no remedy, and the files themselves are synced
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// Syncs every file below `folder`.
///
/// # Errors
/// [`ResultError::Write`].
pub fn sync_all(folder: &Path) -> Result<(), ResultError> {
    for entry in fs::read_dir(folder).map_err(ResultError::read(folder))? {
        let path = entry.map_err(ResultError::read(folder))?.path();
        if path.is_dir() {
            sync_all(&path)?;
        } else {
            File::open(&path).and_then(|file| file.sync_all()).map_err(ResultError::write(&path))?;
        }
    }
    sync_folder(folder);
    Ok(())
}

//! Errors of writing and reading result folders.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

/// A result could not be written, or could not be read back.
#[derive(Debug, Error)]
pub enum ResultError {
    /// The result folder's path names a file.
    #[error("{} is a file: results need a folder", path.display())]
    TargetIsFile {
        /// The path asked for.
        path: PathBuf,
    },
    /// The folder holds files of other programs; netcast does not replace them.
    #[error("{} is not empty and was not written by netcast: empty it or choose another folder", path.display())]
    TargetNotOurs {
        /// The path asked for.
        path: PathBuf,
    },
    /// The folder is the current folder or holds it: a swap would leave the shell in a folder that no longer exists.
    #[error("{} is the current folder or holds it: name a folder inside it", path.display())]
    TargetHoldsCurrent {
        /// The path asked for.
        path: PathBuf,
    },
    /// The disk is too small for the files of the run.
    #[error(
        "{} needs about {:.0} MB, and its disk has {:.0} MB to give: record less often (record.every, \
         record.fields_every)", path.display(), (1e-6 * needed).ceil(), (1e-6 * available).floor()
    )]
    DiskTooSmall {
        /// The folder wanted.
        path: PathBuf,
        /// Bytes that its run writes.
        needed: f64,
        /// Bytes free on the disk.
        available: f64,
    },
    /// The folder, or one that it lies in, cannot be made.
    #[error("cannot make the folder {}: {source}", path.display())]
    TargetUnwritable {
        /// The path asked for.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// Another run is at work on this folder.
    #[error("{} is being written by another run: wait for its end, or choose another folder", path.display())]
    InUse {
        /// The folder of that run.
        path: PathBuf,
    },
    /// The folder holds the results of an unfinished run, which can be resumed.
    #[error(
        "{} holds a run that did not end: go on with it by --resume, or remove that folder to start anew",
        path.display()
    )]
    LeftBehind {
        /// The folder of that run.
        path: PathBuf,
    },
    /// No run can be resumed.
    #[error("there is nothing to resume: {} {what}", path.display())]
    NothingToResume {
        /// The result folder.
        path: PathBuf,
        /// The reason, with the folder as its subject.
        what: &'static str,
    },
    /// Under a name of ours stands a link, a named pipe or a device.
    #[error("{} is a link, a named pipe or a device: results are plain files", path.display())]
    NotAFile {
        /// Its path.
        path: PathBuf,
    },
    /// A checkpoint is cut short, damaged or of another system.
    #[error("{} is cut short, damaged, or no checkpoint of this run: run it anew", path.display())]
    NotCheckpoint {
        /// The file.
        path: PathBuf,
    },
    /// A checkpoint was written by a program that may compute other bits.
    #[error("{} was written by {wrote}, and this is {this}: resume with that, or run anew", path.display())]
    OtherProgram {
        /// The file.
        path: PathBuf,
        /// Which program wrote it.
        wrote: String,
        /// Which program this is.
        this: String,
    },
    /// A file ends before its first complete part.
    #[error("{}: {what}", path.display())]
    Cut {
        /// The file.
        path: PathBuf,
        /// How much is missing.
        what: String,
    },
    /// A file has changed since the checkpoint.
    #[error("{} is shorter or other than it was at the checkpoint: the run cannot go on, run it anew", path.display())]
    Changed {
        /// The file.
        path: PathBuf,
    },
    /// The operating system refused a write.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// What was being written.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// The operating system refused a read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// What was being read.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// A JSON file does not have the expected content.
    #[error("{} is not a valid result: {key}{source}", path.display())]
    Json {
        /// The file.
        path: PathBuf,
        /// The key that cannot be read, with a colon after it; empty where the file is no JSON at all.
        key: String,
        /// The cause.
        source: serde_json::Error,
    },
    /// A number of the summary is infinite or not a number; JSON cannot write it, and null would hide it.
    #[error("a number under `{section}` of the summary is not finite")]
    NotFinite {
        /// The summary's section.
        section: &'static str,
    },
    /// A CSV file is malformed.
    #[error("{} is not a valid table: {source}", path.display())]
    Csv {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: csv::Error,
    },
    /// A cell of a table is neither empty nor a number.
    #[error("{}, line {line}, column {column}: expected a number, found `{text}`", path.display())]
    NotANumber {
        /// The file.
        path: PathBuf,
        /// Line in the file, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// The text of the cell.
        text: String,
    },
    /// The field file could not be written or read.
    #[error("{}: {source}", path.display())]
    Fields {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: hdf5_pure::Error,
    },
    /// The field file is sound but holds no netcast result.
    #[error("{}: {what}", path.display())]
    NotFields {
        /// The file.
        path: PathBuf,
        /// What is missing or inconsistent.
        what: String,
    },
    /// An array or a row has the wrong length.
    #[error("{what}: expected {expected} values, found {found}")]
    Length {
        /// The array.
        what: &'static str,
        /// Its length by the topology or the columns.
        expected: usize,
        /// The length it came with.
        found: usize,
    },
}

impl ResultError {
    /// An [`ResultError::Write`] at `path`, for `map_err`.
    pub fn write(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::Write { path: path.to_path_buf(), source }
    }

    /// An [`ResultError::Read`] at `path`, for `map_err`.
    pub fn read(path: &Path) -> impl FnOnce(io::Error) -> Self {
        move |source| Self::Read { path: path.to_path_buf(), source }
    }

    pub(crate) fn csv(path: &Path) -> impl FnOnce(csv::Error) -> Self {
        move |source| Self::Csv { path: path.to_path_buf(), source }
    }

    pub(crate) fn fields(path: &Path) -> impl FnOnce(hdf5_pure::Error) -> Self {
        move |source| Self::Fields { path: path.to_path_buf(), source }
    }

    pub(crate) fn length(what: &'static str, expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self::Length { what, expected, found }) }
    }
}

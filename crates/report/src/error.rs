//! Why a report could not be made.

use std::io;
use std::path::PathBuf;

use thiserror::Error;

/// A report could not be made.
#[derive(Debug, Error)]
pub enum ReportError {
    /// A file of the result folder cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: io::Error,
    },
    /// A JSON file of the result folder is malformed.
    #[error("{} is not a valid result: {source}", path.display())]
    Json {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: serde_json::Error,
    },
    /// The history is no table.
    #[error("{} is not a valid table: {source}", path.display())]
    Csv {
        /// The file.
        path: PathBuf,
        /// The reason given.
        source: csv::Error,
    },
    /// A cell of the history is neither empty nor a number.
    #[error("{}, line {line}, column {column}: expected a number, found `{text}`", path.display())]
    NotANumber {
        /// The file.
        path: PathBuf,
        /// Line in the file, from 1.
        line: u64,
        /// The column's name.
        column: String,
        /// What stands there.
        text: String,
    },
    /// The page cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The page.
        path: PathBuf,
        /// The reason given.
        source: io::Error,
    },
}

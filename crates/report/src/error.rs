//! Why a report could not be made.

use std::io;
use std::path::PathBuf;

use netcast_results::ResultError;
use thiserror::Error;

/// A report could not be made.
#[derive(Debug, Error)]
pub enum ReportError {
    /// A file of the result folder cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// A file of the result folder is malformed.
    #[error(transparent)]
    Result(ResultError),
    /// The history ends before the frames of the run.
    #[error("{} is cut off: it ends before the run", path.display())]
    CutHistory {
        /// The file.
        path: PathBuf,
    },
    /// The landmarks name a node that the fields do not have.
    #[error("{} names node {node}, but the fields hold {nodes} nodes: they come from another run", path.display())]
    UnknownNode {
        /// The file of the landmarks.
        path: PathBuf,
        /// The node.
        node: usize,
        /// Number of nodes of the fields.
        nodes: usize,
    },
    /// A page or a picture cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The cause.
        source: io::Error,
    },
    /// Pictures are asked of the folder of a comparison.
    #[error(
        "{} holds a comparison, which has no pictures of its own: name the folder of one of its designs, {}",
        folder.display(), designs.join(", ")
    )]
    Comparison {
        /// The folder of the comparison.
        folder: PathBuf,
        /// The names of the designs' folders in it.
        designs: Vec<String>,
    },
    /// The result folder lacks a file that pictures need, or the file holds no frame.
    #[error("cannot draw pictures of {}: {missing}; run the scenario again to write it", folder.display())]
    NoFields {
        /// The result folder.
        folder: PathBuf,
        /// What is missing, as a clause for the message.
        missing: &'static str,
    },
}

impl From<ResultError> for ReportError {
    fn from(error: ResultError) -> Self {
        match error {
            ResultError::Read { path, source } => Self::Read { path, source },
            other => Self::Result(other),
        }
    }
}

//! A summary as its file has it.

use std::path::Path;

use serde_json::Value;

use super::Summary;
use crate::{ResultError, folder, json};

/// A summary read back, whatever version wrote it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SummaryFile {
    /// What this version knows of it.
    pub summary: Summary,
    /// All that it holds, with keys that a later version has added and without those that an older one lacks.
    pub values: Value,
}

impl SummaryFile {
    /// The summary in a result folder.
    ///
    /// # Errors
    /// [`ResultError::Read`], or [`ResultError::Json`] with line and column, or with the key that cannot be read.
    pub fn read(result: &Path) -> Result<Self, ResultError> {
        let path = result.join(folder::SUMMARY);
        Self::of(json::read(&path)?, &path)
    }

    /// The summary that a file at `path` holds with these values.
    ///
    /// # Errors
    /// [`ResultError::Json`] with the key that cannot be read.
    pub fn of(values: Value, path: &Path) -> Result<Self, ResultError> {
        Ok(Self { summary: json::of_value(&values, path)?, values })
    }

    /// Whether it is that of a comparison, which has designs in place of sections.
    pub fn is_of_comparison(&self) -> bool {
        self.values["designs"].is_array()
    }
}

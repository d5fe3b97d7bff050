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

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn read(text: &str) -> Result<SummaryFile, ResultError> {
        let result = tempfile::tempdir().unwrap();
        fs::write(result.path().join(folder::SUMMARY), text).unwrap();
        SummaryFile::read(result.path())
    }

    #[test]
    fn a_file_of_another_version_reads_with_what_it_has() {
        // as `recover` writes it, with a key that nobody knows yet
        let file = read(r#"{"title": "A net", "wall_time_s": null, "finished": false, "capture": {"held_s": 2.0}}"#);
        let SummaryFile { summary, values } = file.unwrap();
        assert_eq!((&summary.title[..], summary.finished), ("A net", false));
        // not 0, which would say that the balance closes
        assert!(summary.energy.closure.is_nan() && summary.tension.max_n.is_nan() && summary.wall_time_s.is_nan());
        assert_eq!(summary.opening, Default::default());
        assert_eq!(values["capture"]["held_s"], 2.0);
        assert!(read("{}").unwrap().summary.finished);
    }

    #[test]
    fn what_cannot_be_read_is_named_by_file_and_key() {
        let error = read(r#"{"opening": {"area_max_m2": "wide"}}"#).unwrap_err().to_string();
        assert!(error.contains("summary.json") && error.contains("opening.area_max_m2: "), "{error}");
        let error = read("{\"title\": \"A net\",\n").unwrap_err().to_string();
        assert!(error.contains("summary.json is not a valid result: EOF") && error.contains("line 2"), "{error}");
    }
}

//! A summary read from its file, with keys that this version does not know.

use std::path::Path;

use serde_json::Value;

use super::Summary;
use crate::{ResultError, folder, json};

/// A summary read from a file that any version may have written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SummaryFile {
    /// The part that this version knows.
    pub summary: Summary,
    /// All values of the file, also those of keys that this version does not know.
    pub values: Value,
}

impl SummaryFile {
    /// Reads the summary in the result folder `result`.
    ///
    /// # Errors
    /// [`ResultError::Read`], or [`ResultError::Json`] with line and column, or with the key that cannot be read.
    pub fn read(result: &Path) -> Result<Self, ResultError> {
        let path = result.join(folder::SUMMARY);
        Self::of(json::read(&path)?, &path)
    }

    /// The summary with these values, read from the file at `path`.
    ///
    /// # Errors
    /// [`ResultError::Json`] with the key that cannot be read.
    pub fn of(values: Value, path: &Path) -> Result<Self, ResultError> {
        Ok(Self { summary: json::of_value(&values, path)?, values })
    }

    /// Whether it is the summary of a comparison, which has designs instead of sections.
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
    fn a_summary_of_another_version_can_be_read() {
        // as `recover` writes it, with an unknown key
        let file = read(r#"{"title": "A net", "wall_time_s": null, "finished": false, "capture": {"held_s": 2.0}}"#);
        let SummaryFile { summary, values } = file.unwrap();
        assert_eq!((&summary.title[..], summary.finished), ("A net", false));
        // not 0, which would mean that the balance closes
        assert!(summary.energy.closure.is_nan() && summary.tension.max_n.is_nan() && summary.wall_time_s.is_nan());
        assert_eq!(summary.opening, Default::default());
        assert_eq!(values["capture"]["held_s"], 2.0);
        assert!(read("{}").unwrap().summary.finished);
    }

    #[test]
    fn an_unreadable_value_is_named_by_file_and_key() {
        let error = read(r#"{"opening": {"area_max_m2": "wide"}}"#).unwrap_err().to_string();
        assert!(error.contains("summary.json") && error.contains("opening.area_max_m2: "), "{error}");
        let error = read("{\"title\": \"A net\",\n").unwrap_err().to_string();
        assert!(error.contains("summary.json is not a valid result: EOF") && error.contains("line 2"), "{error}");
    }
}

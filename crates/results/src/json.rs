//! Reader of JSON files whose errors name the key.

use std::fs;
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

use crate::ResultError;

/// Reads the file at `path`.
///
/// # Errors
/// [`ResultError::Read`], or [`ResultError::Json`] with line, column and key.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<T, ResultError> {
    let text = fs::read_to_string(path).map_err(ResultError::read(path))?;
    let mut deserializer = serde_json::Deserializer::from_str(&text);
    let value = deserialize(&mut deserializer, path)?;
    deserializer.end().map_err(|source| ResultError::Json { path: path.to_path_buf(), key: String::new(), source })?;
    Ok(value)
}

/// Converts the values of the file at `path` into a `T`.
///
/// # Errors
/// [`ResultError::Json`] with the key.
pub fn of_value<T: DeserializeOwned>(values: &Value, path: &Path) -> Result<T, ResultError> {
    deserialize(values, path)
}

fn deserialize<'de, T, D>(deserializer: D, path: &Path) -> Result<T, ResultError>
where
    T: Deserialize<'de>,
    D: Deserializer<'de, Error = serde_json::Error>,
{
    serde_path_to_error::deserialize(deserializer).map_err(|error| {
        // serde_path_to_error writes `?` for a place without a key and `.` for the whole file
        let key = error.path().to_string();
        let key = key.trim_end_matches(['?', '.']);
        let key = if key.is_empty() { String::new() } else { format!("{key}: ") };
        ResultError::Json { path: path.to_path_buf(), key, source: error.into_inner() }
    })
}

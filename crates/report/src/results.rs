//! What the report reads of a result folder.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::ReportError;

/// The three files of a result folder that a report is made of.
pub(crate) struct Results {
    pub summary: Value,
    pub manifest: Value,
    pub history: History,
}

/// A table of numbers by column; `None` is an empty cell.
pub(crate) struct History {
    columns: Vec<(String, Vec<Option<f64>>)>,
}

impl Results {
    pub(crate) fn read(folder: &Path) -> Result<Self, ReportError> {
        Ok(Self {
            summary: read_json(&folder.join("summary.json"))?,
            manifest: read_json(&folder.join("manifest.json"))?,
            history: History::read(&folder.join("history.csv"))?,
        })
    }
}

impl History {
    fn read(path: &Path) -> Result<Self, ReportError> {
        let malformed = |source: csv::Error| ReportError::Csv { path: path.to_path_buf(), source };
        let file = fs::File::open(path).map_err(|source| ReportError::Read { path: path.to_path_buf(), source })?;
        let mut reader = csv::Reader::from_reader(file);
        let header = reader.headers().map_err(malformed)?;
        let mut columns: Vec<(String, Vec<Option<f64>>)> =
            header.iter().map(|name| (name.to_owned(), Vec::new())).collect();
        for record in reader.records() {
            let record = record.map_err(malformed)?;
            for (cell, (name, values)) in record.iter().zip(&mut columns) {
                let value = if cell.is_empty() { Ok(None) } else { cell.parse().map(Some) };
                values.push(value.map_err(|_| ReportError::NotANumber {
                    path: path.to_path_buf(),
                    line: record.position().map_or(0, csv::Position::line),
                    column: name.clone(),
                    text: cell.to_owned(),
                })?);
            }
        }
        Ok(Self { columns })
    }

    /// The cells of the column of this name, where there is one with any number in it.
    pub(crate) fn column(&self, name: &str) -> Option<&[Option<f64>]> {
        self.filled().find(|(column, _)| *column == name).map(|(_, values)| values)
    }

    /// The columns that hold any number, in the order of the file.
    pub(crate) fn filled(&self) -> impl Iterator<Item = (&str, &[Option<f64>])> {
        self.columns
            .iter()
            .filter(|(_, values)| values.iter().any(Option::is_some))
            .map(|(name, values)| (name.as_str(), values.as_slice()))
    }
}

fn read_json(path: &Path) -> Result<Value, ReportError> {
    let text = fs::read_to_string(path).map_err(|source| ReportError::Read { path: path.to_path_buf(), source })?;
    serde_json::from_str(&text).map_err(|source| ReportError::Json { path: path.to_path_buf(), source })
}

//! `history.csv`: one row for each record step.
//!
//! Numbers are the shortest decimals that read back to the same bits. A cell is empty if the scenario does not have the
//! quantity. `row.rs` lists the columns in order.

use std::path::Path;

use crate::ResultError;

/// A table of numbers with named columns; `None` is an empty cell.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct History {
    columns: Vec<String>,
    rows: Vec<Vec<Option<f64>>>,
}

impl History {
    /// An empty table with these columns.
    pub fn new(columns: Vec<String>) -> Self {
        Self { columns, rows: Vec::new() }
    }

    /// Appends a row.
    ///
    /// # Errors
    /// [`ResultError::Length`] if the row does not have one cell for each column.
    pub fn push(&mut self, row: Vec<Option<f64>>) -> Result<(), ResultError> {
        ResultError::length("a row of the history", self.columns.len(), row.len())?;
        self.rows.push(row);
        Ok(())
    }

    /// The names of the columns, in order.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// The rows, in order of time. Shape (rows, columns).
    pub fn rows(&self) -> &[Vec<Option<f64>>] {
        &self.rows
    }

    /// Index of the column of this name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column == name)
    }

    /// The cells of the column of this name, in order of time; none without such a column.
    pub fn values(&self, name: &str) -> Option<impl Iterator<Item = Option<f64>> + '_> {
        let column = self.column(name)?;
        Some(self.rows.iter().map(move |row| row[column]))
    }

    /// Writes the table to `path`.
    ///
    /// # Errors
    /// [`ResultError::Csv`] or [`ResultError::Write`] if the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), ResultError> {
        let mut writer = csv::Writer::from_path(path).map_err(ResultError::csv(path))?;
        writer.write_record(&self.columns).map_err(ResultError::csv(path))?;
        for row in &self.rows {
            writer.write_record(cells(row)).map_err(ResultError::csv(path))?;
        }
        writer.flush().map_err(ResultError::write(path))
    }

    /// Reads a table from `path`.
    ///
    /// # Errors
    /// [`ResultError::Csv`] if the table is malformed; [`ResultError::NotANumber`] with line and column of the cell.
    pub fn read(path: &Path) -> Result<Self, ResultError> {
        let mut reader = csv::Reader::from_path(path).map_err(ResultError::csv(path))?;
        let header = reader.headers().map_err(ResultError::csv(path))?;
        let mut history = Self::new(header.iter().map(str::to_owned).collect());
        for record in reader.records() {
            let record = record.map_err(ResultError::csv(path))?;
            let mut row = Vec::with_capacity(history.columns.len());
            for (cell, column) in record.iter().zip(&history.columns) {
                row.push(parse(cell).map_err(|text| ResultError::NotANumber {
                    path: path.to_path_buf(),
                    line: record.position().map_or(0, csv::Position::line),
                    column: column.clone(),
                    text,
                })?);
            }
            history.push(row)?;
        }
        Ok(history)
    }
}

/// The cells of a row as text for the file.
pub(crate) fn cells(row: &[Option<f64>]) -> impl Iterator<Item = String> {
    row.iter().map(|cell| cell.map(decimal).unwrap_or_default())
}

/// The shortest decimal that reads back to the same bits; with an exponent only below 1e-5 and from 1e16 on.
pub(crate) fn decimal(value: f64) -> String {
    let mut text = format!("{value:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
    text
}

/// The number in a cell; the error is the text of a cell that is not a number.
fn parse(cell: &str) -> Result<Option<f64>, String> {
    if cell.is_empty() {
        return Ok(None);
    }
    cell.parse().map(Some).map_err(|_| cell.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_history_reads_back_to_the_last_bit() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        let mut history = History::new(vec!["time_s".into(), "B_speed_m_s".into()]);
        let awkward = [0.1 + 0.2, -0.0, 1e-7, 5e-324, f64::MAX, 123456789.0, 1.0 / 3.0];
        for (step, value) in awkward.into_iter().enumerate() {
            history.push(vec![Some(step as f64 * 1e-3), Some(value)]).unwrap();
        }
        history.push(vec![Some(1.0), None]).unwrap();
        history.write(&path).unwrap();

        let read_back = History::read(&path).unwrap();
        let bits = |history: &History| -> Vec<Option<u64>> {
            history.rows().iter().flatten().map(|cell| cell.map(f64::to_bits)).collect()
        };
        assert_eq!(bits(&read_back), bits(&history));
        assert_eq!(read_back.columns(), history.columns());
        assert_eq!(read_back.values("B_speed_m_s").unwrap().last(), Some(None));
        assert!(read_back.values("C_speed_m_s").is_none());
    }

    #[test]
    fn decimals_are_the_shortest() {
        let shortest = [
            (0.0, "0"),
            (50.0, "50"),
            (0.001, "0.001"),
            (0.1 + 0.2, "0.30000000000000004"),
            (1e-7, "1e-7"),
            (-2.5, "-2.5"),
            (1e16, "1e16"),
        ];
        for (value, text) in shortest {
            assert_eq!(decimal(value), text);
        }
    }

    #[test]
    fn a_bad_cell_is_named_by_line_and_column() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        std::fs::write(&path, "time_s,area_m2\n0,1\n0.001,wide\n").unwrap();
        let error = History::read(&path).unwrap_err().to_string();
        assert!(error.contains("line 3") && error.contains("area_m2") && error.contains("`wide`"), "{error}");
    }

    #[test]
    fn a_row_of_the_wrong_length_is_refused() {
        let mut history = History::new(vec!["time_s".into(), "area_m2".into()]);
        assert!(matches!(history.push(vec![None]), Err(ResultError::Length { expected: 2, found: 1, .. })));
    }
}

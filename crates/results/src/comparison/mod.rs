//! Comparison of designs: the differences of their inputs, and one table of their results.
//!
//! ```text
//!  inputs of each design  ──differences──▶ inputs that differ                  ─┐
//!  summary of each design ──table────────▶ a row for each quantity, best marked ├─▶ Comparison ─▶ summary.json,
//!  reported numbers ─────────────────────▶ a column for each design with any   ─┘                 summary.csv
//! ```
//!
//! The table has every number of the summaries under its path, also a number that a later version adds. The table of
//! quantities gives the direction in which each is better.

mod differences;
mod heading;
mod table;

use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::ResultError;
use crate::history::decimal;
use crate::summary::SummaryFile;

pub use differences::Difference;
pub use table::Row;

/// A design to be compared: its name, results and inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Entrant {
    /// Name, different from those of the others.
    pub name: String,
    /// The `summary.json` of its run.
    pub summary: SummaryFile,
    /// Resolved scenario: dotted paths with their values as written.
    pub inputs: Vec<(String, Value)>,
    /// Why its run failed; none if it did not.
    pub failure: Option<String>,
}

/// Reported numbers: from a paper, a test or another program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reported {
    /// Source of the numbers.
    pub source: String,
    /// The numbers.
    pub values: Vec<ReportedValue>,
}

/// One reported number.
#[derive(Debug, Clone, PartialEq)]
pub struct ReportedValue {
    /// Name of the design.
    pub design: String,
    /// Path in `summary.json`.
    pub quantity: String,
    /// The number, in SI, or the text.
    pub value: Value,
}

/// The comparison of some designs; fields have the order of the file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Comparison {
    /// The names of the designs in a phrase.
    pub title: String,
    /// Version of netcast that compared them.
    pub netcast: String,
    /// Whether every design was run to its end and closed its energy balance as asked.
    pub finished: bool,
    /// The designs, in the order in which the user named them.
    pub designs: Vec<Design>,
    /// Source of the reported numbers; none without such numbers.
    pub reported: Option<String>,
    /// Inputs that differ.
    pub differences: Vec<Difference>,
    /// Results: a row for each quantity.
    pub table: Vec<Row>,
}

/// A design of the comparison.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Design {
    /// Name in the table.
    pub name: String,
    /// Title of its scenario.
    pub title: String,
    /// Its result folder, relative to that of the comparison.
    pub folder: String,
    /// Whether its run reached its end.
    pub finished: bool,
    /// Why its run failed; none if it did not. A failed design is shown but is never the best.
    pub failure: Option<String>,
    /// Sentences that a reader needs before trusting its numbers.
    pub warnings: Vec<String>,
}

impl Design {
    fn of(entrant: &Entrant) -> Self {
        let summary = &entrant.summary.summary;
        Self {
            name: entrant.name.clone(),
            title: summary.title.clone(),
            folder: entrant.name.clone(),
            finished: summary.finished,
            failure: entrant.failure.clone(),
            warnings: summary.warnings.clone(),
        }
    }

    /// Whether its run reached its end and did not fail.
    pub fn is_sound(&self) -> bool {
        self.finished && self.failure.is_none()
    }
}

impl Comparison {
    /// Compares designs with each other and with reported numbers.
    pub fn of(entrants: &[Entrant], reported: Option<&Reported>) -> Self {
        let designs: Vec<Design> = entrants.iter().map(Design::of).collect();
        let names: Vec<&str> = entrants.iter().map(|entrant| &entrant.name[..]).collect();
        Self {
            title: phrase(&names),
            netcast: env!("CARGO_PKG_VERSION").to_owned(),
            finished: designs.iter().all(Design::is_sound),
            differences: differences::differences(entrants),
            table: table::table(entrants, &designs, reported),
            reported: reported.map(|reported| reported.source.clone()),
            designs,
        }
    }

    /// The comparison as JSON text with a final newline.
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self).expect("string keys and plain data");
        text.push('\n');
        text
    }

    /// Writes the comparison to `path` as JSON.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn write(&self, path: &Path) -> Result<(), ResultError> {
        fs::write(path, self.to_json()).map_err(ResultError::write(path))
    }

    /// Writes the table to `path` as CSV: quantity, unit, a column for each design, then a column for each design with
    /// reported numbers. A cell without a value is empty.
    ///
    /// # Errors
    /// [`ResultError::Csv`] or [`ResultError::Write`] if the file cannot be written.
    pub fn write_csv(&self, path: &Path) -> Result<(), ResultError> {
        let names = || self.designs.iter().map(|design| &design.name);
        let reported: Vec<&String> =
            names().filter(|name| self.table.iter().any(|row| row.reported.contains_key(*name))).collect();
        let mut writer = csv::Writer::from_path(path).map_err(ResultError::csv(path))?;
        let mut head = vec!["quantity".to_owned(), "unit".to_owned()];
        head.extend(names().map(|name| plain_text(name)));
        head.extend(reported.iter().map(|name| plain_text(&format!("{name}_reported"))));
        writer.write_record(&head).map_err(ResultError::csv(path))?;
        for row in &self.table {
            let mut cells = vec![row.quantity.clone(), row.unit.clone()];
            cells.extend(names().map(|name| cell(&row.values, name)));
            cells.extend(reported.iter().map(|name| cell(&row.reported, name)));
            writer.write_record(&cells).map_err(ResultError::csv(path))?;
        }
        writer.flush().map_err(ResultError::write(path))
    }
}

/// A text as a cell that no spreadsheet takes for a formula: with an apostrophe before the sign that begins one (OWASP, CSV
/// Injection).
fn plain_text(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']);
    if is_formula { format!("'{text}") } else { text.to_owned() }
}

/// Text of the cell of a design; empty without a value.
fn cell(values: &Map<String, Value>, design: &str) -> String {
    match values.get(design) {
        Some(Value::String(text)) => plain_text(text),
        Some(Value::Number(number)) if number.is_f64() => number.as_f64().map(decimal).unwrap_or_default(),
        Some(Value::Number(number)) => number.to_string(),
        _ => String::new(),
    }
}

/// The names as a phrase: `a, b and c`.
fn phrase(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [all_but_last @ .., last] => format!("{} and {last}", all_but_last.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn entrant(name: &str, summary: Value) -> Entrant {
        let inputs = vec![("web.square.mesh".to_owned(), json!(name))];
        let summary = SummaryFile::of(summary, Path::new("summary.json")).unwrap();
        Entrant { name: name.into(), summary, inputs, failure: None }
    }

    fn three() -> Vec<Entrant> {
        vec![
            entrant("coarse", json!({"title": "Coarse", "finished": true, "opening": {"area_max_m2": 20.5}})),
            entrant(
                "fine",
                json!({"title": "", "finished": true, "opening": {"area_max_m2": 21.0}, "warnings": ["x"]}),
            ),
            entrant("torn", json!({"title": "Torn", "finished": false, "opening": {"area_max_m2": 90.0}})),
        ]
    }

    #[test]
    fn a_failed_design_is_shown_and_is_never_the_best() {
        let comparison = Comparison::of(&three(), None);
        assert!(!comparison.finished);
        assert_eq!(comparison.title, "coarse, fine and torn");
        assert_eq!(comparison.designs[1].warnings, ["x"]);
        assert_eq!(comparison.table[0].values["torn"], json!(90.0));
        assert_eq!(comparison.table[0].best, ["fine"]);

        // a run that reached its end but missed its energy balance counts as failed
        let mut unbalanced = three();
        unbalanced[1].failure = Some("the energy balance misses its tolerance".into());
        unbalanced[2].summary.summary.finished = true;
        assert_eq!(Comparison::of(&unbalanced, None).table[0].best, ["torn"]);
    }

    #[test]
    fn the_csv_has_a_column_for_each_design_and_its_reported_numbers() {
        let known = ReportedValue { design: "fine".into(), quantity: "opening.area_max_m2".into(), value: json!(20) };
        let reported = Reported { source: "a test".into(), values: vec![known] };
        let mut entrants = three();
        entrants[0].summary.values["tension"] = json!({"max_n": null, "max_where": "ring, inner"});
        entrants[1].summary.values["tension"] = json!({"max_n": 1e-7});
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.csv");
        Comparison::of(&entrants, Some(&reported)).write_csv(&path).unwrap();
        assert_eq!(
            fs::read_to_string(path).unwrap(),
            "quantity,unit,coarse,fine,torn,fine_reported\n\
             opening.area_max_m2,m^2,20.5,21,90,20\n\
             tension.max_n,N,,1e-7,,\n\
             tension.max_where,,\"ring, inner\",,,\n"
        );
    }

    #[test]
    fn the_json_has_its_promised_keys() {
        let value: Value = serde_json::from_str(&Comparison::of(&three(), None).to_json()).unwrap();
        let keys: Vec<&String> = value.as_object().unwrap().keys().collect();
        assert_eq!(keys, ["title", "netcast", "finished", "designs", "reported", "differences", "table"]);
        assert_eq!(value["designs"][2]["finished"], json!(false));
        assert_eq!(value["differences"][0]["values"], json!({"coarse": "coarse", "fine": "fine", "torn": "torn"}));
        assert_eq!(value["table"][0]["better"], json!("higher"));
        assert_eq!(value["reported"], Value::Null);
    }
}

//! Designs side by side: what differs in their inputs, and one table of what came out.
//!
//! ```text
//!  inputs of each design  ──differences──▶ what was made or thrown otherwise ─┐
//!  summary of each design ──table────────▶ a row a quantity, its best marked  ├─▶ Comparison ─▶ summary.json,
//!  numbers known elsewhere ──────────────▶ columns beside them                ─┘                 summary.csv
//! ```
//!
//! The table takes every number of the summaries, under the same names: a number that a later version adds is compared
//! without a line here. The table of quantities says which of them a net designer wants large or small.

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

/// A design as it comes to the comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct Entrant {
    /// What it is called; unlike the others' names.
    pub name: String,
    /// Its `summary.json`.
    pub summary: SummaryFile,
    /// Its scenario as resolved: dotted paths with their values as written.
    pub inputs: Vec<(String, Value)>,
    /// Why its run failed.
    pub failure: Option<String>,
}

/// Numbers known from elsewhere: a paper, a test, another program.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reported {
    /// Where they come from.
    pub source: String,
    /// Each one.
    pub values: Vec<ReportedValue>,
}

/// One number known from elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct ReportedValue {
    /// Name of the design.
    pub design: String,
    /// Path in `summary.json`.
    pub quantity: String,
    /// The number, in SI, or the text.
    pub value: Value,
}

/// Designs side by side; fields stand in the order of the file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Comparison {
    /// The names of the designs in a phrase.
    pub title: String,
    /// Version of netcast that compared them.
    pub netcast: String,
    /// Whether every design was run to its end and closed its energy balance as asked.
    pub finished: bool,
    /// The designs, in the order they were named.
    pub designs: Vec<Design>,
    /// Where the reported numbers come from.
    pub reported: Option<String>,
    /// What differs in their inputs.
    pub differences: Vec<Difference>,
    /// What came out.
    pub table: Vec<Row>,
}

/// A design of the comparison.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Design {
    /// What it is called in the table.
    pub name: String,
    /// Its scenario's title.
    pub title: String,
    /// Its result folder, relative to the comparison's.
    pub folder: String,
    /// Whether its run reached its end.
    pub finished: bool,
    /// Why its run failed. Such a design is shown as far as it came; it is never the best.
    pub failure: Option<String>,
    /// What the reader should know before trusting its numbers.
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

    /// Whether its numbers are those of a whole run.
    pub fn is_sound(&self) -> bool {
        self.finished && self.failure.is_none()
    }
}

impl Comparison {
    /// Compares designs, with the numbers reported of them where there are any.
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

    /// The comparison as JSON text, with a newline at its end.
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

    /// Writes the table to `path` as CSV: quantity, unit, a column a design, then a column for each design that
    /// anything is reported of. An empty cell: none.
    ///
    /// # Errors
    /// [`ResultError::Csv`] where the file cannot be written.
    pub fn write_csv(&self, path: &Path) -> Result<(), ResultError> {
        let names = || self.designs.iter().map(|design| &design.name);
        let reported: Vec<&String> =
            names().filter(|name| self.table.iter().any(|row| row.reported.contains_key(*name))).collect();
        let mut writer = csv::Writer::from_path(path).map_err(ResultError::csv(path))?;
        let mut head = vec!["quantity".to_owned(), "unit".to_owned()];
        head.extend(names().cloned());
        head.extend(reported.iter().map(|name| format!("{name}_reported")));
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

fn cell(values: &Map<String, Value>, design: &str) -> String {
    match values.get(design) {
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) if number.is_f64() => number.as_f64().map(decimal).unwrap_or_default(),
        Some(Value::Number(number)) => number.to_string(),
        _ => String::new(),
    }
}

/// `a, b and c`.
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
    fn a_design_that_failed_is_shown_and_marked_and_never_the_best() {
        let comparison = Comparison::of(&three(), None);
        assert!(!comparison.finished);
        assert_eq!(comparison.title, "coarse, fine and torn");
        assert_eq!(comparison.designs[1].warnings, ["x"]);
        assert_eq!(comparison.table[0].values["torn"], json!(90.0));
        assert_eq!(comparison.table[0].best, ["fine"]);

        // a run that reached its end but missed its energy balance is no better
        let mut unbalanced = three();
        unbalanced[1].failure = Some("the energy balance misses its tolerance".into());
        unbalanced[2].summary.summary.finished = true;
        assert_eq!(Comparison::of(&unbalanced, None).table[0].best, ["torn"]);
    }

    #[test]
    fn the_table_is_csv_too() {
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
    fn json_has_what_a_script_reads() {
        let value: Value = serde_json::from_str(&Comparison::of(&three(), None).to_json()).unwrap();
        let keys: Vec<&String> = value.as_object().unwrap().keys().collect();
        assert_eq!(keys, ["title", "netcast", "finished", "designs", "reported", "differences", "table"]);
        assert_eq!(value["designs"][2]["finished"], json!(false));
        assert_eq!(value["differences"][0]["values"], json!({"coarse": "coarse", "fine": "fine", "torn": "torn"}));
        assert_eq!(value["table"][0]["better"], json!("higher"));
        assert_eq!(value["reported"], Value::Null);
    }
}

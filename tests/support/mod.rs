//! Helpers of the tests of this package: a scenario is run in a temporary folder and its results are read back.
#![allow(dead_code)] // each test program uses its own part

use std::path::{Path, PathBuf};

use netcast::results::{Fields, History, Summary, folder, read_fields};
use netcast::scenario::Source;
use netcast::{Case, Document, Model};
use tempfile::TempDir;

/// A run with its results, read back from the result folder.
pub struct Run {
    /// The model that was run.
    pub model: Model,
    /// summary.json.
    pub summary: Summary,
    /// history.csv.
    pub history: History,
    /// fields.vtkhdf.
    pub fields: Fields,
}

impl Run {
    /// Runs a shipped example, `folder/name.toml`, with overrides as after `--set`.
    ///
    /// # Panics
    /// If the scenario is wrong or the run fails.
    pub fn example(name: &str, overrides: &[&str]) -> Run {
        let overrides: Vec<String> = overrides.iter().map(|o| o.to_string()).collect();
        let document = Document::read(&examples().join(name), &overrides).unwrap_or_else(|e| panic!("{e}"));
        Run::of(&document)
    }

    /// Runs a graph web: `scenario` is TOML, with or without `web.graph`; `nodes` and `ropes` are the texts of its CSV
    /// files, nodes.csv and ropes.csv.
    ///
    /// # Panics
    /// If the scenario is wrong or the run fails.
    pub fn graph(scenario: &str, nodes: &str, ropes: &str) -> Run {
        let inputs = TempDir::new().expect("a temporary folder");
        for (name, text) in [("nodes.csv", nodes), ("ropes.csv", ropes)] {
            std::fs::write(inputs.path().join(name), text).expect("a file in a temporary folder");
        }
        let web = if scenario.contains("web.graph") {
            ""
        } else {
            "[web.graph]\nnodes = \"nodes.csv\"\nropes = \"ropes.csv\"\n"
        };
        let source = Source { name: "graph.toml".into(), text: format!("{scenario}{web}") };
        let document = Document::parse(source, inputs.path(), &[]).unwrap_or_else(|e| panic!("{e}"));
        Run::of(&document)
    }

    /// Runs a scenario.
    ///
    /// # Panics
    /// If it is wrong or the run fails.
    pub fn of(document: &Document) -> Run {
        let results = TempDir::new().expect("a temporary folder");
        let target = results.path().join("run");
        let case = Case::of(document.clone()).unwrap_or_else(|e| panic!("{e}"));
        let ran = case.simulation().threads(1).run_to(&target).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(ran.failure, None);
        Run {
            model: case.model().clone(),
            summary: ran.summary,
            history: History::read(&ran.folder.join(folder::HISTORY)).expect("a history"),
            fields: read_fields(&ran.folder.join(folder::FIELDS)).expect("fields"),
        }
    }

    /// A column of the history, (records,).
    ///
    /// # Panics
    /// If there is no such column, or a cell of it is empty.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let values = self.history.values(name).unwrap_or_else(|| panic!("no column {name}"));
        values.map(|cell| cell.unwrap_or_else(|| panic!("an empty cell in {name}"))).collect()
    }

    /// The last value of a column of the history.
    ///
    /// # Panics
    /// As [`Run::column`].
    pub fn last(&self, name: &str) -> f64 {
        *self.column(name).last().expect("a history has rows")
    }
}

/// The folder of the scenarios for tests of restarts, with the files that they name.
pub fn resume() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("resume")
}

/// The files directly in `folder` whose names end with `.kind`, sorted by name.
///
/// # Panics
/// If there is no such folder.
pub fn files_of_kind(folder: &Path, kind: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let paths = entries.map(|entry| entry.expect("an entry of a folder").path());
    let mut files: Vec<PathBuf> = paths.filter(|path| path.extension().is_some_and(|found| found == kind)).collect();
    files.sort();
    files
}

/// The folder of the shipped examples.
pub fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples")
}

/// Asserts that `found` lies within `tolerance` of `expected`, relative to `expected`.
///
/// # Panics
/// If it does not.
#[track_caller]
pub fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(error <= tolerance, "{what}: {found} instead of {expected}, off by {error:.2e}, at most {tolerance:.0e}");
}

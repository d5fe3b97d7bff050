//! What a user writes: scenarios, quantities, overrides, the CSV files of a graph, of a stowing and of a wind.

use std::path::{Path, PathBuf};

use netcast_model::Model;
use netcast_scenario::interval::{Any, Positive};
use netcast_scenario::path::Path as KeyPath;
use netcast_scenario::quantity::{Angle, Length, Number, Pressure, Quantity, Rate};
use netcast_scenario::tree::{Tree, Value};
use netcast_scenario::{Diagnostics, Document, Source, dimension, interval, resolved_toml};
use tempfile::TempDir;

use crate::refusal::check_diagnostics;
use crate::small::is_small;

/// A graph with every table that names one of its nodes: what the CSV files are tried on.
const GRAPH: &str = include_str!("../files/graph.toml");
/// A scenario with every kind of value: what overrides are tried on.
const SQUARE: &str = include_str!("../files/square.toml");

/// Lines of an input that are read as quantities: more are more of the same.
const MOST_LINES: usize = 10_000;

/// Between the CSV files in one input: ASCII's file separator.
const NEXT_FILE: char = '\u{1c}';

/// A scenario's text, read and made into a model; the files that it names are those of the folder `files`.
pub fn scenario(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    // a path could lead to anything on this machine, or to what never ends
    if names_other_files(text) {
        return;
    }
    let folder = files();
    lower(Document::parse(source(text), &folder, &[]), &folder);
}

/// Overrides, one a line, put into a scenario.
pub fn overrides(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let overrides: Vec<String> = text.lines().map(str::to_owned).collect();
    if overrides.iter().any(|text| text.contains("nodes") || text.contains("ropes") || text.contains("path")) {
        return;
    }
    let folder = files();
    lower(Document::parse(source(SQUARE), &folder, &overrides), &folder);
}

/// Quantities with their units, one a line.
pub fn units(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    for line in text.lines().take(MOST_LINES) {
        quantity::<dimension::unit::Metre, Any>(Length::from_text(line));
        quantity::<dimension::unit::Metre, Positive>(Length::from_text(line));
        quantity::<dimension::unit::Radian, Any>(Angle::from_text(line));
        quantity::<dimension::unit::Pascal, Any>(Pressure::from_text(line));
        quantity::<dimension::unit::PerSecond, Any>(Rate::from_text(line));
        quantity::<dimension::unit::One, Any>(Number::from_text(line));
    }
}

/// The air rests.
const NO_WIND: &[u8] = b"t,vx,vy,vz\n0,0,0,0\n";

/// The nodes, the ropes and the stowing of a graph and the wind it flies in, in one input with a file separator between
/// them; without a fourth file there is none.
pub fn graph_files(bytes: &[u8]) {
    let folder = TempDir::new().expect("a temporary folder");
    let mut files = bytes.split(|&byte| char::from(byte) == NEXT_FILE);
    for name in ["nodes.csv", "ropes.csv", "stowed.csv"] {
        std::fs::write(folder.path().join(name), files.next().unwrap_or_default()).expect("a temporary file");
    }
    std::fs::write(folder.path().join("wind.csv"), files.next().unwrap_or(NO_WIND)).expect("a temporary file");
    lower(Document::parse(source(GRAPH), folder.path(), &[]), folder.path());
}

/// The folder of the files that scenarios may name.
fn files() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("files")
}

fn source(text: &str) -> Source {
    Source { name: "fuzz.toml".into(), text: text.into() }
}

/// What reads can be drawn, cut and stowed, or is refused; what is resolved reads back.
fn lower(read: Result<Document, Diagnostics>, folder: &Path) {
    let document = match read {
        Ok(document) => document,
        Err(refused) => return check_diagnostics(&refused),
    };
    if !is_small(&document) {
        return;
    }
    match Model::new(&document) {
        Err(refused) => check_diagnostics(&refused),
        Ok(model) => {
            let resolved = resolved_toml(&model.scenario);
            let again = Document::parse(source(&resolved), folder, &[]);
            let again = again.unwrap_or_else(|refused| panic!("as resolved it is refused: {refused}\n{resolved}"));
            assert_eq!(again.scenario, model.scenario, "{resolved}");
        }
    }
}

/// What is read is finite and within its interval, and is written as it is read.
fn quantity<U: dimension::Measured, I: interval::Within>(read: Result<Quantity<U, I>, dimension::QuantityError>) {
    match read {
        Err(refused) => assert!(!refused.to_string().is_empty()),
        Ok(quantity) => {
            assert!(quantity.si().is_finite() && I::INTERVAL.contains(quantity.si()));
            let again = Quantity::<U, I>::from_text(&quantity.to_string()).expect("what was written is read");
            assert_eq!(again.si().to_bits(), quantity.si().to_bits(), "{quantity}");
        }
    }
}

/// Whether it names files beside those of this package.
fn names_other_files(text: &str) -> bool {
    let Ok(tree) = Tree::parse(text) else { return false };
    ["web.graph.nodes", "web.graph.ropes", "stow.file.path", "environment.wind.series.file"].iter().any(|path| {
        let value = tree.get(&KeyPath::parse(path)).map(|node| &node.value);
        value.and_then(Value::as_text).is_some_and(|name| Path::new(name).components().count() != 1 || name == "..")
    })
}

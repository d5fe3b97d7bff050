//! The CSV files that a scenario names: the nodes and ropes of `[web.graph]`, the positions of `[stow.file]`, the curves
//! of `[rope.law.table]`, the force of `[launch.tube]`, the paths of `[drive.NAME]`, the wind of
//! `[environment.wind.series]`. All in SI.

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroU32;
use std::path::PathBuf;
use std::sync::Arc;

use netcast_dynamics::forces::tabulated::Tabulated;
use netcast_webs::Class;

use crate::csv_table::{Cells, CsvTable, MOST_FAULTS};
use crate::diagnostic::Diagnostic;
use crate::drive::misplaced;
use crate::interval::{Any, NonNegative, Positive, Within};
use crate::nearest::nearest;
use crate::path::Path;
use crate::rules::{is_plain, ropes, unknown_rope};
use crate::tree::{Table, Value};
use crate::written::Written;

/// A row of the nodes of `[web.graph]`.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeRow {
    /// The node's id, unique.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
    /// Mass tied to the node beside that of its ropes, kg.
    pub mass_kg: f64,
    /// Whether it stays put.
    pub fixed: bool,
    /// Velocity x, y, z at the start, m/s.
    pub velocity_m_s: [f64; 3],
    /// Its line in the file, from 1.
    pub line: usize,
}

/// A row of the ropes of `[web.graph]`.
#[derive(Clone, Debug, PartialEq)]
pub struct RopeRow {
    /// The node it starts at, as an index into the nodes.
    pub a: usize,
    /// The node it ends at, as an index into the nodes.
    pub b: usize,
    /// Its name in `[ropes]`; none for that of its class.
    pub rope: Option<String>,
    /// Its link class.
    pub class: Option<Class>,
    /// Its rest length, m; none for the distance between its ends.
    pub rest_length_m: Option<f64>,
    /// Its tension as drawn, N; none for that of its rope.
    pub pretension_n: Option<f64>,
    /// How many segments it is cut into; none for what `[solve]` says.
    pub segments: Option<NonZeroU32>,
    /// Its line in the file, from 1.
    pub line: usize,
}

/// A row of `[stow.file]`.
#[derive(Clone, Debug, PartialEq)]
pub struct StowRow {
    /// The node's id, unique.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
    /// Its line in the file, from 1.
    pub line: usize,
}

/// A row of the file of a `[drive.NAME]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathRow {
    /// When the point is reached, s.
    pub time_s: f64,
    /// Displacement x, y, z from the start, m.
    pub displacement_m: [f64; 3],
}

/// A node as [`write_stow`] writes it.
#[derive(Clone, Debug, PartialEq)]
pub struct StowedNode {
    /// The node's id.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
}

/// Writes a file for `[stow.file]`. Decimals are the shortest that read back to the same bits.
///
/// # Errors
/// Where the file cannot be written.
pub fn write_stow(path: &std::path::Path, nodes: impl IntoIterator<Item = StowedNode>) -> Result<(), csv::Error> {
    let mut file = csv::Writer::from_path(path)?;
    file.write_record(["id", "x", "y", "z"])?;
    for StowedNode { id, position_m: [x, y, z] } in nodes {
        file.write_record([id, x.to_string(), y.to_string(), z.to_string()])?;
    }
    Ok(file.flush()?)
}

/// The nodes and ropes of `[web.graph]`.
#[derive(Clone, Debug, PartialEq)]
pub struct GraphFiles {
    /// The nodes.
    pub nodes: Vec<NodeRow>,
    /// The ropes.
    pub ropes: Vec<RopeRow>,
}

/// The laws of `[rope.law.table]` by the names of their files.
pub type RopeTables = BTreeMap<PathBuf, Arc<Tabulated>>;

/// Reads the files of `[web.graph]`; none where the scenario has another web or a file cannot be read.
pub(crate) fn read_graph(written: &Written, found: &mut Vec<Diagnostic>) -> Option<GraphFiles> {
    let nodes =
        CsvTable::read(written, "web.graph.nodes", &["id", "x", "y", "z"], &["mass", "fixed", "vx", "vy", "vz"], found);
    let ropes = CsvTable::read(
        written,
        "web.graph.ropes",
        &["a", "b"],
        &["rope", "class", "rest_length", "pretension", "segments"],
        found,
    );
    for (table, what) in [(&nodes, "no nodes"), (&ropes, "no ropes")] {
        found.extend(table.as_ref().filter(|table| table.is_empty()).map(|table| table.whole(what)));
    }
    let mut ids = Ids::default();
    // a node whose row is faulty still has its id: ropes may name it
    let nodes = nodes?.rows(found, |cells| {
        let id = ids.take(cells)?;
        let [position_m, velocity_m_s] = [position(cells), velocity(cells)];
        let mass = cells.optional_number("mass", &NonNegative::INTERVAL);
        let fixed = fixed(cells)?;
        let (position_m, velocity_m_s, mass_kg) = (position_m?, velocity_m_s?, mass?.unwrap_or(0.0));
        Some(NodeRow { id, position_m, mass_kg, fixed, velocity_m_s, line: cells.line() })
    });
    // without a node every name would be wrong, and that has been said
    if ids.0.is_empty() {
        return None;
    }
    check_names(written, &ids, found);
    let ropes = ropes?.rows(found, |cells| {
        let [a, b] = ["a", "b"].map(|column| ids.find(cells, column));
        if a.is_some() && a == b {
            cells.fault("a rope needs two different ends".into(), None);
        }
        let rope = cells.optional_text("rope");
        if let Some((message, help)) = rope.and_then(|name| unknown_rope(written, name)) {
            cells.fault_in("rope", message, Some(help));
        }
        let class = class(cells);
        let rest_length = cells.optional_number("rest_length", &Positive::INTERVAL);
        let pretension = cells.optional_number("pretension", &NonNegative::INTERVAL);
        let segments = segments(cells);
        Some(RopeRow {
            a: a?,
            b: b?,
            rope: rope.map(str::to_string),
            class: class?,
            rest_length_m: rest_length?,
            pretension_n: pretension?,
            segments: segments?,
            line: cells.line(),
        })
    });
    Some(GraphFiles { nodes, ropes })
}

/// Reads the file of `[stow.file]`; none where the web is packed in another way or the file cannot be read.
pub(crate) fn read_stow(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<StowRow>> {
    let mut table = CsvTable::read(written, "stow.file.path", &["id", "x", "y", "z"], &[], found)?;
    let mut ids = Ids::default();
    Some(table.rows(found, |cells| {
        let id = ids.take(cells)?;
        Some(StowRow { id, position_m: position(cells)?, line: cells.line() })
    }))
}

/// Reads the files of `[rope.law.table]`, each once however many ropes have it, by the name that the scenario gives it;
/// those that can be read.
pub(crate) fn read_rope_tables(written: &Written, found: &mut Vec<Diagnostic>) -> RopeTables {
    let mut read = RopeTables::new();
    let mut seen = BTreeSet::new();
    for rope in ropes(written) {
        let path = rope.key("law").key("table").key("file");
        let Some(file) = written.tree.get(&path).and_then(|node| node.value.as_text()) else { continue };
        if seen.insert(file) {
            read.extend(read_rope_table(written, &path, found).map(|law| (PathBuf::from(file), Arc::new(law))));
        }
    }
    read
}

fn read_rope_table(written: &Written, path: &Path, found: &mut Vec<Diagnostic>) -> Option<Tabulated> {
    let mut table = CsvTable::read(written, &path.to_string(), &["strain", "tension"], &["unloading"], found)?;
    let unloads = table.has("unloading");
    let before = found.len();
    let rows = table.rows(found, |cells| {
        let [strain, tension] = ["strain", "tension"].map(|column| cells.number(column));
        let unloading = if unloads { cells.number("unloading") } else { Some(0.0) };
        Some([strain?, tension?, unloading?])
    });
    if found.len() > before {
        return None;
    }
    let column = |index: usize| -> Vec<f64> { rows.iter().map(|row| row[index]).collect() };
    let unloading = unloads.then(|| column(2));
    let law = Tabulated::new(&column(0), &column(1), unloading.as_deref());
    law.map_err(|error| found.push(table.at_row(error.row().unwrap_or(0), &error.to_string()))).ok()
}

/// A row of the file of a force in `[launch.tube]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PushRow {
    /// Way in the tube, m, or time since firing, s.
    pub at: f64,
    /// Force, N.
    pub force_n: f64,
}

/// Reads the file of the force in `[launch.tube]`; none where it has none or the file cannot be read.
pub(crate) fn read_push(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<PushRow>> {
    let named = [("force_over_stroke", "stroke"), ("force_over_time", "time")];
    let mut read = |(key, column): (&str, &str)| {
        let path = format!("launch.tube.{key}.file");
        let mut table = CsvTable::read(written, &path, &[column, "force"], &[], found)?;
        if table.is_empty() {
            found.push(table.whole("no points"));
        }
        let mut last = None;
        Some(table.rows(found, |cells| {
            let (at, force) = (cells.number(column), cells.number("force"));
            let row = PushRow { at: at?, force_n: force? };
            if row.at < 0.0 || last.is_some_and(|last| row.at <= last) {
                cells.fault_in(column, format!("{column}: expected more than in the line before, from 0 on"), None);
            }
            if row.force_n < 0.0 {
                cells.fault_in("force", "force: a launcher pushes, and does not pull".into(), None);
            }
            last = Some(row.at);
            Some(row)
        }))
    };
    named.into_iter().find_map(&mut read)
}

/// Reads the files of `[drive.NAME]`, by name, or of another table of drives.
pub(crate) fn read_paths(
    written: &Written,
    drives: &str,
    found: &mut Vec<Diagnostic>,
) -> BTreeMap<String, Vec<PathRow>> {
    let drives = Path::parse(drives);
    let table = written.tree.get(&drives).and_then(|node| node.value.as_table());
    let names: Vec<&str> = table.into_iter().flat_map(Table::keys).collect();
    let mut paths = BTreeMap::new();
    for name in names {
        let file = drives.key(name).key("file").to_string();
        let Some(mut table) = CsvTable::read(written, &file, &["t", "x", "y", "z"], &[], found) else { continue };
        let mut before = None;
        let rows = table.rows(found, |cells| {
            let (time, by) = (cells.optional_number("t", &NonNegative::INTERVAL), position(cells));
            let row = PathRow { time_s: time?.unwrap_or(0.0), displacement_m: by? };
            if let Some(why) = misplaced(row.time_s, row.displacement_m, before) {
                cells.fault_in("t", format!("t: {why}"), None);
            }
            before = Some(row.time_s);
            Some(row)
        });
        paths.insert(name.to_owned(), rows);
    }
    paths
}

/// A row of the file of `[environment.wind.series]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindRow {
    /// Time since the start, s.
    pub time_s: f64,
    /// Velocity x, y, z of the air, m/s.
    pub velocity_m_s: [f64; 3],
}

/// Nobody measures a wind for longer, s.
const LONGEST_WIND: f64 = 1e9;

/// Reads the file of `[environment.wind.series]`; none where there is none or the file cannot be read.
pub(crate) fn read_wind(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<WindRow>> {
    let mut table = CsvTable::read(written, "environment.wind.series.file", &["t", "vx", "vy", "vz"], &[], found)?;
    if table.is_empty() {
        found.push(table.whole("no wind"));
    }
    let mut before = None;
    Some(table.rows(found, |cells| {
        let [time, vx, vy, vz] = ["t", "vx", "vy", "vz"].map(|column| cells.number(column));
        let row = WindRow { time_s: time?, velocity_m_s: [vx?, vy?, vz?] };
        if before.is_some_and(|before| row.time_s <= before) {
            cells.fault_in("t", "t: expected a time after that of the line before".into(), None);
        }
        if row.time_s.abs() > LONGEST_WIND {
            cells.fault_in("t", format!("t: expected a time within {LONGEST_WIND:e} s of the start"), None);
        }
        before = Some(row.time_s);
        Some(row)
    }))
}

/// The ids of the nodes, each with its line and its place in the file.
#[derive(Default)]
struct Ids(BTreeMap<String, (usize, usize)>);

impl Ids {
    fn take(&mut self, cells: &mut Cells) -> Option<String> {
        let id = cells.text("id", "a name")?.to_string();
        if let Some((line, _)) = self.0.get(&id) {
            cells.fault_in("id", format!("node {id:?} stands in line {line} already"), None);
            return None;
        }
        self.0.insert(id.clone(), (cells.line(), self.0.len()));
        Some(id)
    }

    fn find(&self, cells: &mut Cells, column: &str) -> Option<usize> {
        let id = cells.text(column, "the id of a node")?;
        match self.0.get(id) {
            Some((_, place)) => Some(*place),
            None => {
                let help = if cells.is_told() { self.suggest(id) } else { None };
                cells.fault_in(column, format!("{column}: unknown node {id:?}"), help);
                None
            }
        }
    }

    fn suggest(&self, id: &str) -> Option<String> {
        nearest(id, self.0.keys()).map(|near| format!("did you mean {near:?}?"))
    }
}

/// Checks the nodes that the scenario itself names.
fn check_names(written: &Written, ids: &Ids, found: &mut Vec<Diagnostic>) {
    let mut unknown = 0;
    for list in ["web.graph.outline", "web.graph.corners", "hold.nodes", "points"] {
        let path = Path::parse(list);
        let named: Vec<_> = match written.tree.get(&path).map(|node| &node.value) {
            Some(Value::Array(elements)) => {
                elements.iter().enumerate().map(|(index, node)| (path.index(index), &node.value)).collect()
            }
            Some(Value::Table(table)) => {
                table.0.iter().map(|entry| (path.key(&entry.key), &entry.node.value)).collect()
            }
            _ => continue,
        };
        for (path, id) in named.iter().filter_map(|(path, value)| Some((path, value.as_text()?))) {
            if !ids.0.contains_key(id) {
                unknown += 1;
                let help = if unknown <= MOST_FAULTS { ids.suggest(id) } else { None };
                found.push(written.at_value(path, format!("unknown node {id:?}")).with_help_if(help));
            }
        }
    }
}

fn position(cells: &mut Cells) -> Option<[f64; 3]> {
    let [x, y, z] = ["x", "y", "z"].map(|column| cells.number(column));
    Some([x?, y?, z?])
}

fn velocity(cells: &mut Cells) -> Option<[f64; 3]> {
    let [x, y, z] = ["vx", "vy", "vz"].map(|column| cells.optional_number(column, &Any::INTERVAL));
    Some([x?, y?, z?].map(|speed| speed.unwrap_or(0.0)))
}

fn fixed(cells: &mut Cells) -> Option<bool> {
    match cells.optional_text("fixed") {
        None | Some("0") => Some(false),
        Some("1") => Some(true),
        Some(other) => {
            cells.fault_in("fixed", format!("fixed: expected 0 or 1, found {other:?}"), None);
            None
        }
    }
}

/// The link class of a rope, by a name that is not taken for something else in the results.
fn class(cells: &mut Cells) -> Option<Option<Class>> {
    let Some(name) = cells.optional_text("class") else { return Some(None) };
    let class = Class::from_name(name);
    let why = match (&class, name) {
        (None, _) => "is kept for what is no rope",
        (Some(_), "tension") => "is kept for the largest tension of all ropes",
        (Some(_), name) if !is_plain(name) => "has other characters than letters, digits, spaces, `_`, `-` and `.`",
        _ => return Some(class),
    };
    cells.fault_in("class", format!("the link class {name:?} {why}"), Some("choose another name".into()));
    None
}

fn segments(cells: &mut Cells) -> Option<Option<NonZeroU32>> {
    let Some(text) = cells.optional_text("segments") else { return Some(None) };
    let segments = text.parse().ok();
    if segments.is_none() {
        cells.fault_in("segments", format!("segments: expected a whole number of at least 1, found {text:?}"), None);
    }
    segments.map(Some)
}

//! The two CSV files of `[web.graph]`: its nodes and its ropes, in SI units.

use std::num::NonZeroU32;

use netcast_webs::Class;

use crate::csv_table::{Cells, CsvTable, Ids, MOST_FAULTS};
use crate::diagnostic::Diagnostic;
use crate::dimension::{Measured, unit};
use crate::interval::{Any, NonNegative, Positive, Within};
use crate::path::Path;
use crate::rules::{is_plain, unknown_rope};
use crate::tree::Value;
use crate::written::Written;

/// A row of the nodes of `[web.graph]`.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeRow {
    /// The node's id, unique.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
    /// Mass at the node in addition to that of its ropes, kg.
    pub mass_kg: f64,
    /// Whether it is fixed in place.
    pub fixed: bool,
    /// Velocity x, y, z at the start, m/s.
    pub velocity_m_s: [f64; 3],
    /// Its line in the file, counted from 1.
    pub line: usize,
}

/// A row of the ropes of `[web.graph]`.
#[derive(Clone, Debug, PartialEq)]
pub struct RopeRow {
    /// The node at its start, as an index into the nodes.
    pub a: usize,
    /// The node at its end, as an index into the nodes.
    pub b: usize,
    /// Its rope in `[ropes]`; `None` for the rope of its class.
    pub rope: Option<String>,
    /// Its link class.
    pub class: Option<Class>,
    /// Its rest length, m; `None` for the distance between its ends.
    pub rest_length_m: Option<f64>,
    /// Its tension as drawn, N; `None` for the pretension of its rope.
    pub pretension_n: Option<f64>,
    /// Number of its segments; `None` to cut it as `[solve]` says.
    pub segments: Option<NonZeroU32>,
    /// Its line in the file, counted from 1.
    pub line: usize,
}

/// The nodes and ropes of `[web.graph]`.
#[derive(Clone, Debug, PartialEq)]
pub struct GraphFiles {
    /// The nodes.
    pub nodes: Vec<NodeRow>,
    /// The ropes.
    pub ropes: Vec<RopeRow>,
}

/// Reads the files of `[web.graph]`. `None` where the scenario has another web or a file cannot be read.
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
    // the id of a node is known even if its row has a fault, so that ropes can name it
    let nodes = nodes?.rows(found, |cells| {
        let id = ids.take(cells)?;
        let [position_m, velocity_m_s] = [cells.position(), velocity(cells)];
        let mass = cells.optional_number("mass", &NonNegative::INTERVAL, unit::Kilogram::KIND);
        let fixed = fixed(cells)?;
        let (position_m, velocity_m_s, mass_kg) = (position_m?, velocity_m_s?, mass?.unwrap_or(0.0));
        Some(NodeRow { id, position_m, mass_kg, fixed, velocity_m_s, line: cells.line() })
    });
    // without nodes every id would be unknown; the missing nodes are reported already
    if ids.is_empty() {
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
        let rest_length = cells.optional_number("rest_length", &Positive::INTERVAL, unit::Metre::KIND);
        let pretension = cells.optional_number("pretension", &NonNegative::INTERVAL, unit::Newton::KIND);
        if rest_length.flatten().is_some() && pretension.flatten().is_some() {
            let message = "a rest length and a pretension are two ways to say how far the rope is stretched as drawn";
            cells.fault_in("pretension", message.into(), Some("leave one of them empty".into()));
        }
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

/// Checks that the nodes exist that the scenario itself names.
fn check_names(written: &Written, ids: &Ids, found: &mut Vec<Diagnostic>) {
    let mut unknown = 0;
    for list in ["web.graph.outline", "web.graph.corners", "hold.nodes", "hold.clamped", "points"] {
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
            if !ids.has(id) {
                unknown += 1;
                let help = if unknown <= MOST_FAULTS { ids.suggest(id) } else { None };
                found.push(written.at_value(path, format!("unknown node {id:?}")).with_help_if(help));
            }
        }
    }
}

fn velocity(cells: &mut Cells) -> Option<[f64; 3]> {
    let speed = unit::MetrePerSecond::KIND;
    let [x, y, z] = ["vx", "vy", "vz"].map(|column| cells.optional_number(column, &Any::INTERVAL, speed));
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

/// The link class of a rope. Reports a fault where the results use its name for something else.
fn class(cells: &mut Cells) -> Option<Option<Class>> {
    let Some(name) = cells.optional_text("class") else { return Some(None) };
    let class = Class::from_name(name);
    let why = match (&class, name) {
        (None, _) => "is reserved for parts that are not ropes",
        (Some(_), "tension") => "is reserved for the largest tension of all ropes",
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

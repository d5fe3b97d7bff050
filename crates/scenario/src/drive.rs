//! `[drive.NAME]`: parts of the web that are moved along a given path, whatever pulls at them.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::interval::{NonNegative, Within};
use crate::path::Path;
use crate::quantity::{Length, Time};
use crate::selection::Selection;
use crate::tree::Table;
use crate::written::Written;

/// `[drive.NAME]`. The path is given by `path` or by a `file`: displacements from where a node is at the start, straight
/// and at constant speed from one point to the next. It begins at time 0, and the node rests after its last point. A
/// tractor or a canopy that is a rigid body is moved at its centre of mass, and turned by what pulls at it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["path", "file"]},
    "anyOf" = [{"required": ["file"]}, {"required": ["path"]}]
))]
pub struct Drive {
    /// The points of the path in the order of time.
    pub path: Option<Vec<Waypoint>>,
    /// CSV file of the path, relative to the scenario: columns t, x, y, z, in SI.
    #[schemars(extend("x-file" = true))]
    pub file: Option<PathBuf>,
    /// The nodes that are moved.
    // places in the file come from the schema's check, not from serde
    #[serde(flatten)]
    pub on: Selection,
}

/// A point of a path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Waypoint {
    /// When it is reached, s.
    pub time: Time<NonNegative>,
    /// Displacement from the start, x, y and z, m: in the world frame, of `[stow.prescribed]` in the launch frame.
    pub by: [Length; 3],
}

/// What is wrong with a point of a path at `time`, s, displaced by `by`, m, after one at the time `before`, s.
pub fn misplaced(time: f64, by: [f64; 3], before: Option<f64>) -> Option<&'static str> {
    if before.is_some_and(|before| time <= before) {
        Some("expected a time after that of the point before")
    } else if time == 0.0 && by != [0.0; 3] {
        Some("expected no displacement at time 0: a path begins where the node is")
    } else {
        None
    }
}

/// A row of the file of a `[drive.NAME]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathRow {
    /// When the point is reached, s.
    pub time_s: f64,
    /// Displacement x, y, z from the start, m.
    pub displacement_m: [f64; 3],
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
            let (time, by) = (cells.optional_number("t", &NonNegative::INTERVAL), cells.position());
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

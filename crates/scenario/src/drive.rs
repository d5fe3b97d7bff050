//! `[drive.NAME]`: nodes that are moved along a given path, whatever forces act on them.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Measured, unit};
use crate::interval::{Any, NonNegative, Within};
use crate::path::Path;
use crate::quantity::{Length, Number, Time};
use crate::selection::Selection;
use crate::shift::Shift;
use crate::tree::Table;
use crate::written::Written;

/// `[drive.NAME]`: nodes that are moved along a path, whatever forces act on them. The path is given by either `path`
/// or `file`, as displacements from where a node is at the start. A node moves in a straight line at constant speed
/// from one point to the next. The path begins at time 0; after its last point the node rests. A tractor or a canopy
/// that is a rigid body is moved at its centre of mass and turns freely.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[schemars(extend(
    "allOf" = [
        {"not": {"required": ["path", "file"]}},
        {"not": {"required": ["path", "time_offset"]}},
        {"not": {"required": ["path", "scale"]}}
    ],
    "anyOf" = [{"required": ["file"]}, {"required": ["path"]}]
))]
pub struct Drive {
    /// The points of the path in the order of time. Give this or `file`.
    pub path: Option<Vec<Waypoint>>,
    /// CSV file of the path, with columns t, x, y, z in SI units. The file path is relative to the scenario. Give
    /// this or `path`.
    #[schemars(extend("x-file" = true))]
    pub file: Option<PathBuf>,
    /// What is added to the times of the file, s. Default: 0 s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_offset: Option<Time>,
    /// What the displacements of the file are multiplied by. Default: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<Number>,
    /// The nodes that are moved.
    // flattening loses no place in the file: places come from the check of the schema
    #[serde(flatten)]
    pub on: Selection,
}

/// A point of a path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Waypoint {
    /// Time at which the node reaches the point, s.
    pub time: Time<NonNegative>,
    /// Displacement x, y, z from the start, m. It is in the world frame, or in the launch frame for
    /// `[stow.prescribed]`.
    pub by: [Length; 3],
}

/// The fault of a point of a path at `time`, s, with displacement `by`, m, after a point at the time `before`, s.
pub fn misplaced(time: f64, by: [f64; 3], before: Option<f64>) -> Option<&'static str> {
    if before.is_some_and(|before| time <= before) {
        Some("expected a time after that of the point before")
    } else if time == 0.0 && by != [0.0; 3] {
        Some("expected no displacement at time 0: a path begins where the node is")
    } else {
        None
    }
}

/// A row of the file of `[drive.NAME]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathRow {
    /// Time at which the node reaches the point, s.
    pub time_s: f64,
    /// Displacement x, y, z from the start, m.
    pub displacement_m: [f64; 3],
}

/// Reads the files of the drives in the table `drives`, by the names of the drives.
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
        let shift = Shift::beside(written, &Path::parse(&file));
        let mut before = None;
        let rows = table.rows(found, |cells| {
            let (time, by) = (cells.optional_number("t", &Any::INTERVAL, unit::Second::KIND), cells.position());
            let row = PathRow { time_s: shift.time(time?.unwrap_or(0.0)), displacement_m: shift.vector(by?) };
            if row.time_s < 0.0 {
                cells.fault_in("t", format!("t: expected a time of at least 0, found {} s", row.time_s), None);
            }
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

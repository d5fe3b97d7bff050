//! `[drive.NAME]`: parts of the web that are moved along a given path, whatever pulls at them.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::NonNegative;
use crate::quantity::{Length, Time};

/// `[drive.NAME]`. The path is given by `path` or by a `file`: displacements from where a node is at the start, straight
/// and at constant speed from one point to the next. It begins at time 0, and the node rests after its last point. A
/// tractor or a canopy that is a rigid body is moved at its centre of mass, and turned by what pulls at it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["path", "file"]},
    "anyOf" = [{"required": ["file"]}, {"required": ["path"]}]
))]
pub struct Drive {
    /// The points of the path in the order of time.
    pub path: Option<Vec<Waypoint>>,
    /// CSV file of the path, relative to the scenario: columns t, x, y, z, in SI.
    pub file: Option<PathBuf>,
    /// Whether each of the web's corners is moved.
    #[serde(default)]
    pub corners: bool,
    /// Whether each tractor is moved.
    #[serde(default)]
    pub tractors: bool,
    /// The ids of the nodes that are moved.
    #[serde(default)]
    pub nodes: Vec<String>,
    /// The names of the feature points that are moved.
    #[serde(default)]
    pub points: Vec<String>,
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

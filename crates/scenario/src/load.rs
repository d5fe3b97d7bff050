//! `[load.NAME]`: forces that act on the web all the time.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::{Force, ForcePerLength, Time};

/// `[load.NAME]`: either `force` on every node that is named, or `force_per_length` on every rope of a `class`. Components
/// are x, y and z in the world frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["force", "force_per_length"]},
    "anyOf" = [{"required": ["force_per_length", "class"]}, {"required": ["force"]}]
))]
pub struct Load {
    /// Force on each of the nodes, N.
    pub force: Option<[Force; 3]>,
    /// Force per length of rope without tension, N/m.
    pub force_per_length: Option<[ForcePerLength; 3]>,
    /// The link class on whose ropes `force_per_length` acts.
    pub class: Option<String>,
    /// Whether `force` acts on each of the web's corners.
    #[serde(default)]
    pub corners: bool,
    /// Whether `force` acts on each tractor.
    #[serde(default)]
    pub tractors: bool,
    /// The ids of nodes on which `force` acts.
    #[serde(default)]
    pub nodes: Vec<String>,
    /// The names of feature points on which `force` acts.
    #[serde(default)]
    pub points: Vec<String>,
    /// Time over which a run in time brings the load up from nothing, evenly, s. Left out: it is there from the start.
    pub ramp: Option<Time<Positive>>,
}

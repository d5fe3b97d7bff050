//! `[load.NAME]`: forces that act on the web all the time.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::{Force, ForcePerLength, Time};
use crate::selection::Selection;

/// `[load.NAME]`: either `force` on every node that is named, or `force_per_length` on every rope of a `class`. Components
/// are x, y and z in the world frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
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
    /// The nodes on which `force` acts.
    // places in the file come from the schema's check, not from serde
    #[serde(flatten)]
    pub on: Selection,
    /// Time over which a run in time brings the load up from nothing, evenly, s. Left out: it is there from the start.
    pub ramp: Option<Time<Positive>>,
}

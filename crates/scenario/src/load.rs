//! `[load.NAME]`: constant forces on the web.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::{Force, ForcePerLength, Time};
use crate::selection::Selection;

/// `[load.NAME]`: either a `force` on each selected node, or a `force_per_length` on the ropes of a `class`.
/// Components are x, y, z in the world frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["force", "force_per_length"]},
    "anyOf" = [{"required": ["force_per_length", "class"]}, {"required": ["force"]}]
))]
pub struct Load {
    /// Force on each of the selected nodes, N.
    pub force: Option<[Force; 3]>,
    /// Force per rest length of rope, N/m. It is given together with `class`.
    pub force_per_length: Option<[ForcePerLength; 3]>,
    /// The link class whose ropes `force_per_length` acts on.
    pub class: Option<String>,
    /// The nodes that `force` acts on.
    // flattening loses no place in the file: places come from the check of the schema
    #[serde(flatten)]
    pub on: Selection,
    /// Time over which a run increases the load evenly from zero, s. Default: none; the full load acts from the
    /// start.
    pub ramp: Option<Time<Positive>>,
}

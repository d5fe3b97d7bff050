//! What a load, a drive or a tie names: parts of the web by their place, their id or a name of the user's.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which nodes are meant.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Selection {
    /// Whether each of the web's corners is meant.
    #[serde(default)]
    pub corners: bool,
    /// Whether each tractor is meant.
    #[serde(default)]
    pub tractors: bool,
    /// The ids of nodes.
    #[serde(default)]
    pub nodes: Vec<String>,
    /// The names of feature points.
    #[serde(default)]
    pub points: Vec<String>,
}

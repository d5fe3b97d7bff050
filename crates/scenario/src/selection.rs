//! The nodes that a load, a drive or a break tie acts on: corners, tractors, nodes by their ids, feature points by
//! name.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A set of nodes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Selection {
    /// Whether the corners of the web are selected. Default: false.
    #[serde(default)]
    pub corners: bool,
    /// Whether the tractors are selected. Default: false.
    #[serde(default)]
    pub tractors: bool,
    /// Ids of the nodes that are selected. Default: none.
    #[serde(default)]
    pub nodes: Vec<String>,
    /// Names of the feature points that are selected. Default: none.
    #[serde(default)]
    pub points: Vec<String>,
}

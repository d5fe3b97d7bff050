//! `[hold]`: nodes that are fixed in place.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// `[hold]`: nodes that are fixed in place.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Hold {
    /// Whether the corners of the web are fixed. Default: false.
    pub corners: bool,
    /// Ids of the nodes that are fixed. Default: none.
    pub nodes: Vec<String>,
    /// Ids of the nodes that are fixed and at which ropes that resist bending keep the direction that they have at the
    /// start. Default: none; ropes turn freely where they are held.
    pub clamped: Vec<String>,
}

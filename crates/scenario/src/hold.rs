//! `[hold]`: nodes that stay put.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// `[hold]`
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Hold {
    /// Whether the web's corners stay put.
    pub corners: bool,
    /// The ids of the nodes that stay put.
    pub nodes: Vec<String>,
}

//! `[[covers]]`: covers that hold the web, or a part of it, as it is stowed until they open.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::Time;

/// A cover holds the web as it is stowed. It opens all at once, and the nodes under it start from rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cover {
    /// Time at which it opens, s.
    pub opens: Time<Positive>,
    /// Ids of the nodes under it. Default: the whole web, without tractors and traction ropes.
    pub nodes: Option<Vec<String>>,
}

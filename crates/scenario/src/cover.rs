//! `[[covers]]`: what holds the web, or a part of it, where it is stowed until it opens.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::Time;

/// A cover. It opens at once, and what it has held starts from rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cover {
    /// When it opens, s.
    pub opens: Time<Positive>,
    /// The ids of the nodes under it. Left out: the whole web, without its tractors and traction ropes.
    pub nodes: Option<Vec<String>>,
}

//! `[measure]`: what the web is measured against.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::Length;

/// `[measure]`
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Measure {
    /// Diameter of the target, m: results then state what share of a disc of this size, centred on the web, the web
    /// covers as seen along the launch axis. Left out: not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target_diameter: Option<Length<Positive>>,
}

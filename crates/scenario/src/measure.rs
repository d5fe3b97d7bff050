//! `[measure]`: what the web is measured against.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::Length;

/// `[measure]`: what the web is measured against.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Measure {
    /// Diameter of the target, m. The target is a disc centred on the web; results state the share of it that the web
    /// covers as seen along the launch axis. Default: none; coverage is not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub target_diameter: Option<Length<Positive>>,
}

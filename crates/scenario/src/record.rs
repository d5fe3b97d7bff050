//! `[record]`: how often results of a run are recorded.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::Time;

/// `[record]`: how often results are recorded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Record {
    /// Time between two rows of the history, s. Each is taken at the step nearest to its time. It changes no bit of the
    /// motion. Default: 1 ms.
    pub every: Time<Positive>,
    /// Time between two frames of the fields, s. Default: `every`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fields_every: Option<Time<Positive>>,
}

impl Default for Record {
    fn default() -> Self {
        Self { every: Time::constant(0.001), fields_every: None }
    }
}

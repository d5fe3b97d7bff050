//! `[environment]`: what surrounds the web.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::NonNegative;
use crate::quantity::{Acceleration, Rate};

/// `[environment]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Gravity, m/s^2, downwards along z.
    pub gravity: Acceleration<NonNegative>,
    /// Mass-proportional damping, 1/s: every node is slowed by damping x mass x velocity.
    pub damping: Rate<NonNegative>,
}

impl Default for Environment {
    fn default() -> Self {
        Self { gravity: Acceleration::constant(STANDARD_GRAVITY), damping: Rate::constant(0.0) }
    }
}

/// Standard gravity, m/s^2 (CGPM 1901).
const STANDARD_GRAVITY: f64 = 9.80665;

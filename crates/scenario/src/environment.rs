//! `[environment]`: what surrounds the web.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::air::Air;
use crate::interval::NonNegative;
use crate::quantity::{Acceleration, Rate};
use crate::wind::Wind;

/// `[environment]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Gravity, m/s^2, downwards along z.
    pub gravity: Acceleration<NonNegative>,
    /// Mass-proportional damping, 1/s: every node is slowed by damping x mass x velocity.
    pub damping: Rate<NonNegative>,
    /// The medium, and how it drags. Left out: none.
    pub air: Option<Air>,
    /// How that moves. Left out: not at all.
    pub wind: Option<Wind>,
}

impl Default for Environment {
    fn default() -> Self {
        Self { gravity: Acceleration::constant(STANDARD_GRAVITY), damping: Rate::constant(0.0), air: None, wind: None }
    }
}

/// Standard gravity, m/s^2 (CGPM 1901).
const STANDARD_GRAVITY: f64 = 9.80665;

//! `[environment]`: what surrounds the web.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::air::Air;
use crate::ground::Ground;
use crate::interval::NonNegative;
use crate::orbit::Orbit;
use crate::quantity::{Acceleration, Rate};
use crate::wind::Wind;

/// `[environment]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Gravity, m/s^2, downwards along z. Default: standard gravity; none in an orbit.
    pub gravity: Acceleration<NonNegative>,
    /// Mass-proportional damping, 1/s: every node is slowed by damping x mass x velocity.
    pub damping: Rate<NonNegative>,
    /// The medium, and how it drags. Left out: none.
    pub air: Option<Air>,
    /// How that moves. Left out: not at all.
    pub wind: Option<Wind>,
    /// What it starts from and lands on. Left out: nothing.
    pub ground: Option<Ground>,
    /// The orbit that it flies beside. Left out: none.
    pub orbit: Option<Orbit>,
}

impl Environment {
    /// Writes out what follows from what is given.
    pub(crate) fn complete(&mut self) {
        self.air.iter_mut().for_each(Air::complete);
        self.wind.iter_mut().for_each(Wind::complete);
        if self.orbit.is_some() {
            self.gravity = Acceleration::constant(0.0);
        }
    }
}

impl Default for Environment {
    fn default() -> Self {
        Self {
            gravity: Acceleration::constant(STANDARD_GRAVITY),
            damping: Rate::constant(0.0),
            air: None,
            wind: None,
            ground: None,
            orbit: None,
        }
    }
}

/// Standard gravity, m/s^2 (CGPM 1901).
pub(crate) const STANDARD_GRAVITY: f64 = 9.80665;

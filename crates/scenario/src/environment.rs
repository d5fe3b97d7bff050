//! `[environment]`: what surrounds the web.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::air::Air;
use crate::ground::Ground;
use crate::interval::NonNegative;
use crate::orbit::Orbit;
use crate::quantity::{Acceleration, Rate};
use crate::wind::Wind;

/// `[environment]`: what surrounds the web.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Environment {
    /// Gravity, m/s^2, downwards along z. Default: 9.80665 m/s^2; 0 with an orbit.
    pub gravity: Acceleration<NonNegative>,
    /// Mass-proportional damping, 1/s. It exerts the force damping x mass x velocity against the velocity of every
    /// node. Default: 0 1/s.
    pub damping: Rate<NonNegative>,
    /// The medium and its drag coefficients: the standard atmosphere, or a medium of constant `density` and
    /// `viscosity`, such as water. An empty table is the standard atmosphere with the muzzle at sea level. Default:
    /// none; there is no drag.
    pub air: Option<Air>,
    /// How the medium moves: a mean `speed`, uniform or with a profile, with optional gust and turbulence; or a
    /// measured `series`. Default: it is at rest.
    pub wind: Option<Wind>,
    /// The ground that the net starts from and lands on, a level plane. Knots and particles touch it as points, rigid
    /// bodies with their edges. Default: none.
    pub ground: Option<Ground>,
    /// The circular orbit that the net flies beside, by the equations of Clohessy & Wiltshire (1960). The muzzle
    /// moves on the orbit; z points away from the planet, x in the direction of the orbit. An orbit excludes air,
    /// wind, ground and uniform gravity. Default: none.
    pub orbit: Option<Orbit>,
}

impl Environment {
    /// Fills in every default that depends on other keys.
    pub(crate) fn complete(&mut self) {
        if let Some(air) = &mut self.air {
            air.complete();
        }
        if let Some(wind) = &mut self.wind {
            wind.complete();
        }
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

//! `[environment.ground]`: the ground that a net starts from and lands on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{NonNegative, Positive, Rebound};
use crate::quantity::{Length, Number, Time};

/// `[environment.ground]`: a level plane. Knots and particles touch it as points, rigid bodies with their edges. A
/// mass with a shape that is simulated as a point touches it at half its least size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Ground {
    /// Height of the plane above the muzzle, m; negative below the muzzle. Default: the lowest point of the net at
    /// the start.
    pub height: Option<Length>,
    /// Coefficient of friction. Default: 0.5.
    pub friction: Number<NonNegative>,
    /// Coefficient of restitution: speed of the rebound over speed of the impact, 0.14 to 1. Earth and turf have
    /// about 0.2, concrete and metal 0.5. Default: 0.2.
    pub restitution: Number<Rebound>,
    /// Duration of an impact, s. It sets the accuracy and is no property of the soil: a body that arrives at speed v
    /// sinks in by v contact_time / pi. Default: 1 ms.
    pub contact_time: Time<Positive>,
}

impl Default for Ground {
    fn default() -> Self {
        Self {
            height: None,
            friction: Number::constant(0.5),
            restitution: Number::constant(0.2),
            contact_time: Time::constant(1e-3),
        }
    }
}

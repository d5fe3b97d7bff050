//! `[environment.ground]`: what a web starts from and lands on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{NonNegative, Positive, Rebound};
use crate::quantity::{Length, Number, Time};

/// `[environment.ground]`: a level plane. Knots and masses touch it as points, rigid bodies with their edges, masses of
/// some shape with half their least size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Ground {
    /// Its height above the muzzle, m; below it, negative. Left out: the lowest point of all there is at the start.
    pub height: Option<Length>,
    /// Coefficient of friction.
    pub friction: Number<NonNegative>,
    /// Speed of the rebound over that of the impact, 0.14 to 1: earth and turf have some 0.2, concrete and metal 0.5.
    pub restitution: Number<Rebound>,
    /// How long what is dropped stays in contact, s: a matter of accuracy, not of the soil. What arrives at v sinks in by
    /// v contact_time / pi.
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

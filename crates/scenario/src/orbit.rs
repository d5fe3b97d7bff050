//! `[environment.orbit]`: a net that flies beside a circular orbit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{NonNegative, Positive};
use crate::quantity::{AngularSpeed, Length};

/// `[environment.orbit]`: weightless but for what differs from place to place (Clohessy & Wiltshire 1960). The muzzle is
/// on the orbit; z points away from the planet, x the way of the orbit. There is no gravity beside it, no air and no
/// ground.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend(
    "not" = {"required": ["altitude", "mean_motion"]},
    "anyOf" = [{"required": ["mean_motion"]}, {"required": ["altitude"]}]
))]
pub struct Orbit {
    /// Height above the Earth's equator, m.
    pub altitude: Option<Length<NonNegative>>,
    /// Mean motion, rad/s, about any planet.
    pub mean_motion: Option<AngularSpeed<Positive>>,
}

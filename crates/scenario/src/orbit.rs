//! `[environment.orbit]`: a net that moves relative to a circular orbit.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{OrbitHeight, Positive};
use crate::quantity::{AngularSpeed, Length};

/// `[environment.orbit]`: motion relative to a circular orbit, by the equations of Clohessy & Wiltshire (1960). The
/// muzzle moves on the orbit; z points away from the planet, x in the direction of the orbit. An orbit excludes air,
/// wind, ground and uniform gravity. Give either `altitude` or `mean_motion`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend(
    "not" = {"required": ["altitude", "mean_motion"]},
    "anyOf" = [{"required": ["mean_motion"]}, {"required": ["altitude"]}]
))]
pub struct Orbit {
    /// Height of the orbit above the Earth's equator, m. Give this or `mean_motion`.
    pub altitude: Option<Length<OrbitHeight>>,
    /// Mean motion of the orbit, rad/s, about any planet. Give this or `altitude`.
    pub mean_motion: Option<AngularSpeed<Positive>>,
}

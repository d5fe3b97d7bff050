//! `[traction_rope]`, `[[tractors]]`: what ties the tractors to the web, and what is different about one of them.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::body::{Cylinder, Particle};
use crate::interval::{NonNegative, QuarterTurns};
use crate::quantity::{Angle, Length, Speed};

/// `[traction_rope]`: from a web's corner to its tractor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TractionRope {
    /// Length, m; 0 ties the tractors straight to the web's corners.
    pub length: Length<NonNegative>,
    /// Parallel ropes a tractor.
    #[serde(default = "default_count")]
    pub count: NonZeroU32,
}

fn default_count() -> NonZeroU32 {
    NonZeroU32::MIN
}

/// `[[tractors]]`: what is different about one tractor. What is left out is as in `[tractor]` and `[launch]`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["cylinder", "particle"]}))]
pub struct TractorOverride {
    /// The corner it is tied to, from 1.
    pub corner: NonZeroU32,
    /// A solid cylinder.
    pub cylinder: Option<Cylinder>,
    /// A mass without size.
    pub particle: Option<Particle>,
    /// Speed along the launch axis, m/s.
    pub axial_speed: Option<Speed>,
    /// Speed away from the launch axis, m/s.
    pub radial_speed: Option<Speed>,
    /// Elevation of its axis above the horizontal.
    pub elevation: Option<Angle<QuarterTurns>>,
    /// Azimuth of its axis, anticlockwise from x.
    pub azimuth: Option<Angle>,
}

//! `[launch]`: how the tractors are thrown.

use std::f64::consts::FRAC_PI_2;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::QuarterTurns;
use crate::quantity::{Angle, Speed};
use crate::tractor::TractorOverride;

/// `[launch]`. Left out: nothing is launched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Launch {
    /// Speed of the tractors along the launch axis, m/s.
    pub axial_speed: Speed,
    /// Speed of the tractors away from the launch axis, along the web's own corner directions, m/s.
    pub radial_speed: Speed,
    /// Elevation of the launch axis above the horizontal.
    pub elevation: Angle<QuarterTurns>,
    /// Azimuth of the launch axis, anticlockwise from x.
    pub azimuth: Angle,
}

impl Default for Launch {
    fn default() -> Self {
        Self {
            axial_speed: Speed::constant(0.0),
            radial_speed: Speed::constant(0.0),
            elevation: Angle::constant(FRAC_PI_2),
            azimuth: Angle::constant(0.0),
        }
    }
}

impl Launch {
    /// The launch of a tractor with its own speeds and angles.
    pub(crate) fn with(&self, tractor: &TractorOverride) -> Self {
        Self {
            axial_speed: tractor.axial_speed.unwrap_or(self.axial_speed),
            radial_speed: tractor.radial_speed.unwrap_or(self.radial_speed),
            elevation: tractor.elevation.unwrap_or(self.elevation),
            azimuth: tractor.azimuth.unwrap_or(self.azimuth),
        }
    }
}

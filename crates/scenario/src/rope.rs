//! `[rope]`, `[ropes.NAME]`: what the web is tied from.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{Fraction, NonNegative, Positive};
use crate::quantity::{Density, Force, Length, Number, Pressure, Time};

/// A rope. At most one of `damping_time` and `damping_ratio` is given; with neither, the ratio is 0.05.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["damping_time", "damping_ratio"]}))]
pub struct Rope {
    /// Diameter, m.
    pub diameter: Length<Positive>,
    /// Density, kg/m^3.
    pub density: Density<Positive>,
    /// Elastic modulus E, Pa.
    pub elastic_modulus: Pressure<Positive>,
    /// Internal friction of the material t, s: the damper of a segment is c = E A t / rest length.
    pub damping_time: Option<Time<NonNegative>>,
    /// Numerical damping, as a fraction of critical: c = 2 ratio sqrt(k m), with k and m of the segment. Default: 0.05
    /// where `damping_time` is not given.
    pub damping_ratio: Option<Number<NonNegative>>,
    /// Tension of the rope as the web is drawn, N.
    #[serde(default = "default_pretension")]
    pub pretension: Force<NonNegative>,
    /// Breaking load, N: results then state the margin.
    pub strength: Option<Force<Positive>>,
    /// The share of its strength that knots and splices take from the rope, 0 to 1: utilisation then goes by what is
    /// left.
    pub knot_reduction: Option<Number<Fraction>>,
}

fn default_pretension() -> Force<NonNegative> {
    Force::constant(0.0)
}

/// The damping ratio of ropes and canopies for which none is given.
pub(crate) const DAMPING_RATIO: Number<NonNegative> = Number::constant(0.05);

/// How a rope is damped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damping {
    /// Internal friction t, s: c = E A t / rest length.
    Time(f64),
    /// Fraction of critical: c = 2 ratio sqrt(k m).
    Ratio(f64),
}

impl Rope {
    /// How the rope is damped, with the default where the scenario is silent.
    pub fn damping(&self) -> Damping {
        match (self.damping_time, self.damping_ratio) {
            (Some(time), _) => Damping::Time(time.si()),
            (None, ratio) => Damping::Ratio(ratio.unwrap_or(DAMPING_RATIO).si()),
        }
    }

    /// Writes the default damping out.
    pub(crate) fn complete(&mut self) {
        if self.damping_time.is_none() {
            self.damping_ratio.get_or_insert(DAMPING_RATIO);
        }
    }
}

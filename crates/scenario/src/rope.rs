//! `[rope]`, `[ropes.NAME]`: what the web is tied from.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{Fraction, NonNegative, Positive};
use crate::library::rope_names;
use crate::quantity::{BendingStiffness, Density, Force, Length, Number, Pressure, Time};
use crate::rope_law::{RopeBreaking, RopeLaw};

/// A rope. At most one of `damping_time` and `damping_ratio` is given; with neither, the ratio is 0.05. Density and
/// elastic modulus are given, or the material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["damping_time", "damping_ratio"]},
    "required" = ["diameter"],
    "anyOf" = [{"required": ["material"]}, {"required": ["density", "elastic_modulus"]}]
))]
pub struct Rope {
    /// A rope of the library: it has the density, elastic modulus and strength that are not written beside it.
    // none once a scenario is read: its values then stand in their own keys
    #[serde(default, skip_serializing)]
    #[schemars(schema_with = "rope_names")]
    pub material: Option<String>,
    /// Nominal diameter, m.
    pub diameter: Length<Positive>,
    /// Mass per length over the nominal section, kg/m^3.
    pub density: Density<Positive>,
    /// Elastic modulus E on the nominal section, Pa: that of the rope, which is less than that of its fibres.
    pub elastic_modulus: Pressure<Positive>,
    /// Internal friction of the material t, s: the damper of a segment is c = E A t / rest length.
    pub damping_time: Option<Time<NonNegative>>,
    /// Numerical damping, as a fraction of critical: c = 2 ratio sqrt(k m), with k and m of the segment, k by the elastic
    /// modulus. Default: 0.05
    /// where `damping_time` is not given.
    pub damping_ratio: Option<Number<NonNegative>>,
    /// Bending stiffness EI, N m^2, between the segments of a rope; knots turn freely. Left out: none. A solid rod has E
    /// pi d^4 / 64, a rope a small part of it.
    pub bending_stiffness: Option<BendingStiffness<Positive>>,
    /// Tension of the rope as the web is drawn, N.
    #[serde(default = "default_pretension")]
    pub pretension: Force<NonNegative>,
    /// How its tension follows from its stretch.
    #[serde(default)]
    pub law: RopeLaw,
    /// Breaking load, N: results then state the margin. The rope breaks only where `breaking` says so.
    pub strength: Option<Force<Positive>>,
    /// The share of its strength that knots and splices take from the rope, 0 to 1: utilisation then goes by what is
    /// left.
    pub knot_reduction: Option<Number<Fraction>>,
    /// At what it breaks.
    pub breaking: Option<RopeBreaking>,
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

impl Damping {
    /// That of the one of both that is given; with neither, the default ratio.
    pub(crate) fn of(time: Option<Time<NonNegative>>, ratio: Option<Number<NonNegative>>) -> Self {
        match (time, ratio) {
            (Some(time), _) => Self::Time(time.si()),
            (None, ratio) => Self::Ratio(ratio.unwrap_or(DAMPING_RATIO).si()),
        }
    }
}

impl Rope {
    /// How the rope is damped, with the default where the scenario is silent.
    pub fn damping(&self) -> Damping {
        Damping::of(self.damping_time, self.damping_ratio)
    }

    /// Writes the default damping and breaking load out; forgets the material, so that no other library can change the rope.
    pub(crate) fn complete(&mut self) {
        self.material = None;
        if self.damping_time.is_none() {
            self.damping_ratio.get_or_insert(DAMPING_RATIO);
        }
        if let Some(breaking) = &mut self.breaking {
            breaking.load = breaking.load.or(self.strength);
        }
    }
}

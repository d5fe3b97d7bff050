//! `[rope]`, `[ropes.NAME]`: the ropes that the web is made of.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{Fraction, NonNegative, Positive};
use crate::library::rope_names;
use crate::quantity::{BendingStiffness, Density, Force, Length, LinearDensity, Number, Pressure, Time};
use crate::rope_law::{RopeBreaking, RopeLaw};

/// A rope. Give `material`, or both its mass, by `density` or `linear_density`, and its stiffness, by `elastic_modulus` or
/// `axial_stiffness`. Give at most one of `damping_time` and `damping_ratio`; with neither, the damping ratio is 0.05.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "allOf" = [
        {"not": {"required": ["damping_time", "damping_ratio"]}},
        {"not": {"required": ["density", "linear_density"]}},
        {"not": {"required": ["elastic_modulus", "axial_stiffness"]}}
    ],
    "required" = ["diameter"],
    "anyOf" = [
        {"required": ["material"]},
        {"required": ["linear_density", "axial_stiffness"]},
        {"required": ["linear_density", "elastic_modulus"]},
        {"required": ["density", "axial_stiffness"]},
        {"required": ["density", "elastic_modulus"]}
    ]
))]
pub struct Rope {
    /// Name of a rope in the library of materials. It supplies the density, elastic modulus and strength that are not
    /// given here. Default: none.
    // none after reading: its values are then in keys of their own
    #[serde(default, skip_serializing)]
    #[schemars(schema_with = "rope_names")]
    pub material: Option<String>,
    /// Nominal diameter, m.
    pub diameter: Length<Positive>,
    /// Mass per length over the nominal section, kg/m^3. Default: that of `material`.
    pub density: Density<Positive>,
    /// Elastic modulus E of the rope on its nominal section, Pa. It is less than that of the fibres. Default: that of
    /// `material`.
    pub elastic_modulus: Pressure<Positive>,
    /// Mass per length, kg/m, as catalogues state it, in place of `density`, which is this over the nominal section. Default:
    /// none.
    // none after reading, as for `material`
    #[serde(default, skip_serializing)]
    pub linear_density: Option<LinearDensity<Positive>>,
    /// Axial stiffness EA, N, as catalogues state it, in place of `elastic_modulus`, which is this over the nominal section.
    /// Other moduli, of the rope's `law`, are over that section too. Default: none.
    #[serde(default, skip_serializing)]
    pub axial_stiffness: Option<Force<Positive>>,
    /// Damping by internal friction of the material, as a time t, s. The damper of a segment is c = E A t / rest
    /// length. Default: none; `damping_ratio` applies.
    pub damping_time: Option<Time<NonNegative>>,
    /// Damping of each segment as a fraction of critical damping: c = 2 ratio sqrt(k m), with its mass m and its
    /// stiffness k from the elastic modulus. Default: 0.05, unless `damping_time` is given.
    pub damping_ratio: Option<Number<NonNegative>>,
    /// Bending stiffness EI between the segments of a rope, N m^2. It acts at nodes inside the rope, at knots where just two
    /// such ropes meet in line, to 30 degrees, and at `hold.clamped`; other knots turn freely. A solid rod has
    /// E pi d^4 / 64, a rope a small part of that. Default: none.
    pub bending_stiffness: Option<BendingStiffness<Positive>>,
    /// Tension of the rope in the web as drawn, N. Default: 0 N.
    #[serde(default = "default_pretension")]
    pub pretension: Force<NonNegative>,
    /// How the tension of the rope follows from its stretch. Default: linear.
    #[serde(default)]
    pub law: RopeLaw,
    /// Breaking load, N. Results then state the margin. The rope breaks only where `breaking` is given. Default: that
    /// of `material`, or none.
    pub strength: Option<Force<Positive>>,
    /// Share of the strength that is lost at knots and splices, from 0 to less than 1. Utilisation is computed from
    /// the rest. Default: none.
    pub knot_reduction: Option<Number<Fraction>>,
    /// The load or strain at which the rope breaks. Default: it never breaks.
    pub breaking: Option<RopeBreaking>,
}

fn default_pretension() -> Force<NonNegative> {
    Force::constant(0.0)
}

/// The default damping ratio of ropes and canopies.
pub(crate) const DAMPING_RATIO: Number<NonNegative> = Number::constant(0.05);

/// How a rope is damped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damping {
    /// Internal friction, as a time t, s: c = E A t / rest length.
    Time(f64),
    /// Fraction of critical damping: c = 2 ratio sqrt(k m).
    Ratio(f64),
}

impl Damping {
    /// The damping by `time` or `ratio`, whichever is given; with neither, the default ratio.
    pub(crate) fn of(time: Option<Time<NonNegative>>, ratio: Option<Number<NonNegative>>) -> Self {
        match (time, ratio) {
            (Some(time), _) => Self::Time(time.si()),
            (None, ratio) => Self::Ratio(ratio.unwrap_or(DAMPING_RATIO).si()),
        }
    }
}

impl Rope {
    /// How the rope is damped, with the default where neither key is given.
    pub fn damping(&self) -> Damping {
        Damping::of(self.damping_time, self.damping_ratio)
    }

    /// Fills in the default damping and breaking load. Removes the material, so that a later library cannot change
    /// the rope.
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

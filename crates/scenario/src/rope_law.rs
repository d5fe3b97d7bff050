//! `[rope.law.LAW]`: how the tension of a rope follows from its stretch; `[rope.breaking]`: when it breaks.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{NonNegative, Positive};
use crate::quantity::{Force, Number, Pressure, Time};

/// The law of a rope: one table, named after it. Left out: `linear`. The rope's damping works beside each of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum RopeLaw {
    /// Tension in proportion to stretch, by the elastic modulus; the rope only pulls.
    Linear(LinearLaw),
    /// A second modulus beyond a strain. Elastic: it unloads along the same way.
    Bilinear(BilinearLaw),
    /// Tension against strain from a CSV file, with a path of its own for unloading if there is such a column. The elastic
    /// modulus then serves the damping alone.
    Table(TableLaw),
    /// Stiffer at first, relaxing to the elastic modulus with time: the standard linear solid.
    Viscoelastic(ViscoelasticLaw),
    /// Pulls and pushes: a bar hinged at its ends.
    Strut(StrutLaw),
}

impl Default for RopeLaw {
    fn default() -> Self {
        Self::Linear(LinearLaw {})
    }
}

/// `[rope.law.linear]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinearLaw {}

/// `[rope.law.strut]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StrutLaw {}

/// `[rope.law.bilinear]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BilinearLaw {
    /// Strain at the bend.
    pub strain: Number<NonNegative>,
    /// Modulus beyond it, Pa; larger or smaller than the elastic modulus.
    pub second_modulus: Pressure<Positive>,
}

/// `[rope.law.table]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TableLaw {
    /// CSV file: columns strain and tension, N, from 0 up; optionally unloading, the tension in N on the way back from the
    /// last row. Relative to the scenario.
    pub file: PathBuf,
}

/// `[rope.law.viscoelastic]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ViscoelasticLaw {
    /// Modulus at once, Pa; larger than the elastic modulus, to which it relaxes.
    pub instantaneous_modulus: Pressure<Positive>,
    /// Time in which what relaxes falls to 1/e at constant stretch, s.
    pub relaxation_time: Time<Positive>,
}

/// `[rope.breaking]`: the rope breaks, at a load, a strain or whichever comes first. Without this table it never does, and its
/// strength serves to state the margin.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RopeBreaking {
    /// Breaking load, N. Segments at a knot or a splice break at what `knot_reduction` leaves of it. Left out: `strength`.
    pub load: Option<Force<Positive>>,
    /// Breaking strain. Left out: none.
    pub strain: Option<Number<Positive>>,
}

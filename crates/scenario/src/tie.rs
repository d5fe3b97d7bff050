//! `[[break_ties]]`, `[[stitches]]`: threads that hold the web as it is stowed until they break.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::{Force, Length, Number};
use crate::selection::Selection;

/// Break ties: short threads that hold nodes where they are stowed, or hold two nodes together. A thread disappears
/// when its tension reaches the breaking load. It has no mass and no tension up to its length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BreakTie {
    /// Nodes that are tied to where they are stowed.
    // flattening loses no place in the file: places come from the check of the schema
    #[serde(flatten)]
    pub on: Selection,
    /// Pairs of node ids. The two nodes of a pair are tied to each other. Default: none.
    #[serde(default)]
    pub pairs: Vec<[String; 2]>,
    /// Tension at which a tie breaks, N.
    pub breaking_load: Force<Positive>,
    /// Strain at which it breaks. With the breaking load it sets the stiffness. Default: 10 %.
    #[serde(default = "default_breaking_strain")]
    pub breaking_strain: Number<Positive>,
    /// Rest length of a tie, m. Default: the distance that it spans in the stowed web, but at least 10 mm.
    pub length: Option<Length<Positive>>,
}

/// A row of tear stitches: threads that hold folds of rope together and rip one after the other. Give `pairs`; or
/// give `class` and `reach`, and nodes of the ropes of that class are stitched to the nearest node of another fold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["pairs", "class"]},
    "anyOf" = [{"required": ["pairs"]}, {"required": ["class", "reach"]}]
))]
pub struct Stitching {
    /// Pairs of node ids. Each stitch joins the two nodes of a pair.
    pub pairs: Option<Vec<[String; 2]>>,
    /// The link class whose ropes are stitched.
    pub class: Option<String>,
    /// Number of nodes along a rope from one stitch to the next. Default: 1; every node is stitched.
    pub every: Option<NonZeroU32>,
    /// Largest distance between two nodes that are stitched together, m. Nodes that are at most twice this distance
    /// apart along the ropes lie in the same fold and are not stitched.
    pub reach: Option<Length<Positive>>,
    /// Tension at which a stitch breaks, N.
    pub breaking_load: Force<Positive>,
    /// Strain at which it breaks. With the breaking load it sets the stiffness. Default: 10 %.
    #[serde(default = "default_breaking_strain")]
    pub breaking_strain: Number<Positive>,
    /// Rest length of a stitch, m. Default: the distance that it spans in the stowed web, but at least 10 mm.
    pub length: Option<Length<Positive>>,
}

impl Stitching {
    /// Fills in the default distance between stitches where `class` is given.
    pub(crate) fn complete(&mut self) {
        if self.class.is_some() {
            self.every.get_or_insert(NonZeroU32::MIN);
        }
    }
}

fn default_breaking_strain() -> Number<Positive> {
    Number::constant(0.1)
}

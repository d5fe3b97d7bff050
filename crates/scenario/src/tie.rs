//! `[[break_ties]]`, `[[stitches]]`: what holds the web as it is stowed until it has borne its load.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::{Force, Length, Number};
use crate::selection::Selection;

/// Break ties: short threads that hold nodes where these lie stowed, or two nodes together, until they bear their load;
/// then they are gone. A thread has no mass, and up to its length it does nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[schemars(deny_unknown_fields)]
pub struct BreakTie {
    /// Nodes, each of them tied to where it lies.
    // places in the file come from the schema's check, not from serde
    #[serde(flatten)]
    pub on: Selection,
    /// The ids of two nodes each that are tied to each other.
    #[serde(default)]
    pub pairs: Vec<[String; 2]>,
    /// What a tie bears, N.
    pub breaking_load: Force<Positive>,
    /// Its strain then: from it and the load follows how stiff it is.
    #[serde(default = "default_breaking_strain")]
    pub breaking_strain: Number<Positive>,
    /// Length of a tie without tension, m. Left out: the distance that it spans in the stowed web, 10 mm at least.
    pub length: Option<Length<Positive>>,
}

/// A row of tear stitches: threads that hold folds of rope together and rip one after the other. Either `pairs`, or
/// every so many nodes of the ropes of a `class`, each stitched to the nearest node of another fold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["pairs", "class"]},
    "anyOf" = [{"required": ["pairs"]}, {"required": ["class", "reach"]}]
))]
pub struct Stitching {
    /// The ids of the two nodes that each stitch joins.
    pub pairs: Option<Vec<[String; 2]>>,
    /// The link class whose ropes are stitched.
    pub class: Option<String>,
    /// Nodes along a rope from one stitch to the next. Left out: 1, every node is stitched.
    pub every: Option<NonZeroU32>,
    /// How far apart two nodes may lie that are stitched together, m. The way from one to the other along the ropes is more
    /// than twice that: they lie in different folds.
    pub reach: Option<Length<Positive>>,
    /// What a stitch bears, N.
    pub breaking_load: Force<Positive>,
    /// Its strain then: from it and the load follows how stiff it is.
    #[serde(default = "default_breaking_strain")]
    pub breaking_strain: Number<Positive>,
    /// Length of a stitch without tension, m. Left out: the distance that it spans in the stowed web, 10 mm at least.
    pub length: Option<Length<Positive>>,
}

impl Stitching {
    /// Writes the default of what is stitched by a class out.
    pub(crate) fn complete(&mut self) {
        if self.class.is_some() {
            self.every.get_or_insert(NonZeroU32::MIN);
        }
    }
}

fn default_breaking_strain() -> Number<Positive> {
    Number::constant(0.1)
}

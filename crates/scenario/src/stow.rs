//! `[stow.PATTERN]`: how the web is packed before it is thrown.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{NonNegative, Positive, UpToOne};
use crate::quantity::{Length, Number};

/// The packing: one table, named after its pattern. Left out: the web starts as drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Stow {
    /// The flat web shrunk about its centre, rest lengths kept.
    Scale(ScaleStow),
    /// Drawn in to a radius, the middle hanging below, the tractors on top.
    Bag(BagStow),
    /// Positions from a CSV file.
    File(FileStow),
}

/// `[stow.scale]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleStow {
    /// Stowed size over drawn size.
    pub factor: Number<UpToOne>,
}

/// `[stow.bag]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BagStow {
    /// Radius of the bag, m.
    pub radius: Length<Positive>,
    /// How far the middle hangs below the outline, m. Left out: as far as the ropes reach.
    pub depth: Option<Length<NonNegative>>,
    /// Radius of the circle the tractors stand on, m. Left out: that of the bag.
    pub tractor_radius: Option<Length<Positive>>,
    /// How far the tractors stand above the outline, m. Left out: as far as their ropes allow.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.file]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FileStow {
    /// CSV file of the stowed nodes: columns id, x, y, z, in m. Relative to the scenario.
    pub path: PathBuf,
}

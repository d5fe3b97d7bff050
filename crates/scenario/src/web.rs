//! `[web.KIND]`: the web that is thrown.

use std::num::NonZeroU32;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::Length;

/// The web: one table, named after its kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Web {
    /// A hexagon filled with square cells of rope.
    Traditional(Traditional),
    /// The space web's lattice with a closed hexagon of rope at every knot.
    Topological(Topological),
    /// A hexagonal lattice of triangles with double links and a canopy at every knot but the corners.
    Space(SpaceWeb),
    /// A square net of square meshes.
    Square(Square),
    /// Any net, from two CSV files.
    Graph(Graph),
}

/// `[web.traditional]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Traditional {
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
    /// Square cells along one side of the hexagon.
    #[serde(default = "default_cells_per_side")]
    pub cells_per_side: NonZeroU32,
}

fn default_cells_per_side() -> NonZeroU32 {
    const { NonZeroU32::new(6).unwrap() }
}

/// `[web.topological]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Topological {
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
    /// Side of the hexagon of rope at a knot, m.
    #[serde(default = "default_hexagon_side")]
    pub hexagon_side: Length<Positive>,
}

fn default_hexagon_side() -> Length<Positive> {
    Length::constant(0.14)
}

/// `[web.space]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpaceWeb {
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
}

/// `[web.square]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Square {
    /// Side of the net, m.
    pub side: Length<Positive>,
    /// Side of a mesh, m.
    pub mesh: Length<Positive>,
    /// Segments along one side of a mesh, instead of `solve.segment_length`.
    pub segments_per_mesh: Option<NonZeroU32>,
}

/// `[web.graph]`. Paths are relative to the scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Graph {
    /// CSV file of the nodes: columns id, x, y, z and optionally mass, fixed, vx, vy, vz, in SI; fixed is 0 or 1.
    pub nodes: PathBuf,
    /// CSV file of the ropes: columns a, b (node ids) and optionally rope, class, rest_length, pretension, segments,
    /// in SI.
    pub ropes: PathBuf,
    /// The closed outline, as node ids in order. Left out: areas are null.
    pub outline: Option<Vec<String>>,
    /// Where tractors are tied, as node ids; also what `hold.corners` holds.
    pub corners: Option<Vec<String>>,
}

//! `[web.KIND]`: the web that is thrown.

use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroU32;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{BelowOne, HalfTurn, NonNegative, Positive};
use crate::quantity::{Angle, Length, Number};

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
    /// A regular polygon filled with parallels of its sides and radials.
    Polygon(Polygon),
    /// Radials and rings, as of a spider's web.
    Radial(Radial),
    /// A net of rhombic meshes, as of knotted fishing nets, in a rectangular border.
    Diamond(Diamond),
    /// Any net, from two CSV files.
    Graph(Graph),
}

impl Web {
    /// The table that it is written in.
    pub fn table(&self) -> &'static str {
        match self {
            Self::Traditional(_) => "web.traditional",
            Self::Topological(_) => "web.topological",
            Self::Space(_) => "web.space",
            Self::Square(_) => "web.square",
            Self::Polygon(_) => "web.polygon",
            Self::Radial(_) => "web.radial",
            Self::Diamond(_) => "web.diamond",
            Self::Graph(_) => "web.graph",
        }
    }

    /// Writes out every default that depends on what else is given.
    pub(crate) fn complete(&mut self) {
        match self {
            Web::Radial(web) => drop(web.corners.get_or_insert(web.radials)),
            Web::Diamond(net) if net.hanging_ratio.is_none() => drop(net.angle.get_or_insert(RIGHT_ANGLE)),
            _ => {}
        }
    }
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
    /// A second rope along the border, of link class `gathering`. Left out: none.
    pub gathering: Option<Gathering>,
}

/// `[web.square.gathering]`: a drawstring, tied to some knots of the border where a real one slides in rings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gathering {
    /// From one tie to the next, in knots of the border: a divisor of the meshes along a side.
    pub every: NonZeroU32,
    /// By how much it is longer than the border, as a share of that.
    #[serde(default = "default_excess")]
    pub excess: Number<NonNegative>,
}

fn default_excess() -> Number<NonNegative> {
    Number::constant(0.0)
}

/// `[web.polygon]`. Its size is given by either `side` or `diameter`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["side", "diameter"]}))]
pub struct Polygon {
    /// Number of sides, 3 to 24.
    #[schemars(range(min = 3, max = 24))]
    pub sides: NonZeroU32,
    /// Length of a side, m.
    pub side: Option<Length<Positive>>,
    /// Diameter of the circle through the corners, m, instead of the side.
    pub diameter: Option<Length<Positive>>,
    /// Distance of the parallels, m, as nearly as a whole number of them comes; cells are about as wide.
    pub mesh: Length<Positive>,
}

impl Polygon {
    /// Length of a side, m: given, or of the diameter.
    pub fn side_m(&self) -> f64 {
        let across = |diameter: f64| diameter * libm::sin(PI / f64::from(self.sides.get()));
        match (self.side, self.diameter) {
            (Some(side), _) => side.si(),
            (None, diameter) => across(diameter.expect("a polygon without a size is refused").si()),
        }
    }
}

/// `[web.radial]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Radial {
    /// Diameter of the circle through the outline's corners, m.
    pub diameter: Length<Positive>,
    /// Number of radials, 3 to 360.
    pub radials: NonZeroU32,
    /// Number of rings, evenly spaced, the outline among them and the hub not.
    pub rings: NonZeroU32,
    /// Diameter of the circle through the corners of the hub, m: an open ring at which the radials end. Left out: they meet
    /// in a knot.
    pub hub_diameter: Option<Length<Positive>>,
    /// Number of radials whose ends are corners, where tractors are tied: a divisor of `radials`. Left out: all.
    pub corners: Option<NonZeroU32>,
}

/// `[web.diamond]`. The meshes' shape is given by either `angle` or `hanging_ratio`; with neither, the angle is 90 deg.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["angle", "hanging_ratio"]}))]
pub struct Diamond {
    /// Side of a mesh, from knot to knot, m: half a stretched mesh.
    pub mesh: Length<Positive>,
    /// Meshes across the width.
    pub meshes_wide: NonZeroU32,
    /// Meshes across the height.
    pub meshes_high: NonZeroU32,
    /// Angle of a mesh at its upper and lower knot, rad. Default: 90 deg where `hanging_ratio` is not given.
    pub angle: Option<Angle<HalfTurn>>,
    /// Width of a mesh over its width when stretched sideways, E = sin(angle / 2).
    pub hanging_ratio: Option<Number<BelowOne>>,
}

impl Diamond {
    /// The hanging ratio, given or of the angle.
    pub fn hanging_ratio(&self) -> f64 {
        match (self.hanging_ratio, self.angle) {
            (Some(ratio), _) => ratio.si(),
            (None, angle) => libm::sin(0.5 * angle.unwrap_or(RIGHT_ANGLE).si()),
        }
    }
}

const RIGHT_ANGLE: Angle<HalfTurn> = Angle::constant(FRAC_PI_2);

/// `[web.graph]`. Paths are relative to the scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Graph {
    /// CSV file of the nodes: columns id, x, y, z and optionally mass, fixed, vx, vy, vz, in SI; fixed is 0 or 1.
    #[schemars(extend("x-file" = true))]
    pub nodes: PathBuf,
    /// CSV file of the ropes: columns a, b (node ids) and optionally rope, class, rest_length, pretension, segments,
    /// in SI.
    #[schemars(extend("x-file" = true))]
    pub ropes: PathBuf,
    /// The closed outline, as node ids in order. Left out: areas are null.
    pub outline: Option<Vec<String>>,
    /// Where tractors are tied, as node ids; also what `hold.corners` holds.
    pub corners: Option<Vec<String>>,
}

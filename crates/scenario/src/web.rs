//! `[web.KIND]`: the web that is thrown.

use std::f64::consts::{FRAC_PI_2, PI};
use std::num::NonZeroU32;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{BelowOne, HalfTurn, NonNegative, Positive};
use crate::quantity::{Angle, Length, Number};

/// The web: one table, named after the kind of web.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Web {
    /// A hexagon filled with square cells of rope.
    Traditional(Traditional),
    /// The lattice of the space web with a closed hexagon of rope at every knot.
    Topological(Topological),
    /// A hexagonal lattice of triangles with double links, and a canopy at every knot except the corners.
    Space(SpaceWeb),
    /// A square net of square meshes.
    Square(Square),
    /// A regular polygon filled with radials and with ropes parallel to its sides.
    Polygon(Polygon),
    /// Radials and rings, as in a spider's web.
    Radial(Radial),
    /// A net of rhombic meshes in a rectangular border, as in knotted fishing nets.
    Diamond(Diamond),
    /// Any net, read from two CSV files.
    Graph(Graph),
}

impl Web {
    /// The path of its table in the scenario.
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

    /// Fills in every default that depends on other keys.
    pub(crate) fn complete(&mut self) {
        match self {
            Web::Radial(web) => drop(web.corners.get_or_insert(web.radials)),
            Web::Diamond(net) if net.hanging_ratio.is_none() => drop(net.angle.get_or_insert(RIGHT_ANGLE)),
            _ => {}
        }
    }
}

/// `[web.traditional]`: a hexagon filled with square cells of rope.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Traditional {
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
    /// Number of square cells along one side of the hexagon. Default: 6.
    #[serde(default = "default_cells_per_side")]
    pub cells_per_side: NonZeroU32,
}

fn default_cells_per_side() -> NonZeroU32 {
    const { NonZeroU32::new(6).unwrap() }
}

/// `[web.topological]`: the lattice of the space web with a closed hexagon of rope at every knot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Topological {
    /// Side of the web, which is a hexagon, m.
    pub side: Length<Positive>,
    /// Side of the hexagon of rope at a knot, m. Default: 0.14 m.
    #[serde(default = "default_hexagon_side")]
    pub hexagon_side: Length<Positive>,
}

fn default_hexagon_side() -> Length<Positive> {
    Length::constant(0.14)
}

/// `[web.space]`: a hexagonal lattice of triangles with double links, and a canopy at every knot except the corners.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpaceWeb {
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
}

/// `[web.square]`: a square net of square meshes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Square {
    /// Side of the net, m.
    pub side: Length<Positive>,
    /// Side of a mesh, m.
    pub mesh: Length<Positive>,
    /// Number of segments along one side of a mesh. Default: it follows from `solve.segment_length`.
    pub segments_per_mesh: Option<NonZeroU32>,
    /// A drawstring: a second rope along the border, of link class `gathering`, tied to knots of the border. Default:
    /// none.
    pub gathering: Option<Gathering>,
}

/// `[web.square.gathering]`: a drawstring along the border. A real drawstring slides in rings; here it is tied to
/// knots of the border.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gathering {
    /// Number of border knots from one tie to the next. It must divide the number of meshes along a side.
    pub every: NonZeroU32,
    /// Excess of the length of the drawstring over that of the border, as a share of the length of the border.
    /// Default: 0.
    #[serde(default = "default_excess")]
    pub excess: Number<NonNegative>,
}

fn default_excess() -> Number<NonNegative> {
    Number::constant(0.0)
}

/// `[web.polygon]`: a regular polygon filled with radials and with ropes parallel to its sides. Its size is given by
/// either `side` or `diameter`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["side", "diameter"]}))]
pub struct Polygon {
    /// Number of sides, 3 to 24.
    #[schemars(range(min = 3, max = 24))]
    pub sides: NonZeroU32,
    /// Length of a side, m. Give this or `diameter`.
    pub side: Option<Length<Positive>>,
    /// Diameter of the circle through the corners, m. Give this or `side`.
    pub diameter: Option<Length<Positive>>,
    /// Distance between neighbouring parallels, m. It is rounded so that a whole number of them fits; cells are about
    /// as wide.
    pub mesh: Length<Positive>,
}

impl Polygon {
    /// Length of a side, m, as given or computed from the diameter.
    pub fn side_m(&self) -> f64 {
        let across = |diameter: f64| diameter * libm::sin(PI / f64::from(self.sides.get()));
        match (self.side, self.diameter) {
            (Some(side), _) => side.si(),
            (None, diameter) => across(diameter.expect("a polygon without a size is refused").si()),
        }
    }
}

/// `[web.radial]`: radials and rings, as in a spider's web.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Radial {
    /// Diameter of the circle through the corners of the outline, m.
    pub diameter: Length<Positive>,
    /// Number of radials, 3 to 360.
    pub radials: NonZeroU32,
    /// Number of evenly spaced rings. The outline counts as a ring, the hub does not.
    pub rings: NonZeroU32,
    /// Diameter of the circle through the corners of the hub, m. The hub is an open ring at which the radials end.
    /// Default: no hub; the radials meet in a knot.
    pub hub_diameter: Option<Length<Positive>>,
    /// Number of radials that end in a corner, where a tractor is tied. It must divide `radials`. Default: all of
    /// them.
    pub corners: Option<NonZeroU32>,
}

/// `[web.diamond]`: a net of rhombic meshes in a rectangular border. The shape of a mesh is given by either `angle`
/// or `hanging_ratio`; with neither, the angle is 90 deg.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["angle", "hanging_ratio"]}))]
pub struct Diamond {
    /// Side of a mesh from knot to knot, m. This is half the length of a stretched mesh.
    pub mesh: Length<Positive>,
    /// Number of meshes across the width.
    pub meshes_wide: NonZeroU32,
    /// Number of meshes across the height.
    pub meshes_high: NonZeroU32,
    /// Angle of a mesh at its upper and lower knots, rad. Default: 90 deg, unless `hanging_ratio` is given.
    pub angle: Option<Angle<HalfTurn>>,
    /// Hanging ratio E of a mesh: its width over its width when stretched sideways, E = sin(angle / 2).
    pub hanging_ratio: Option<Number<BelowOne>>,
}

impl Diamond {
    /// The hanging ratio, as given or computed from the angle.
    pub fn hanging_ratio(&self) -> f64 {
        match (self.hanging_ratio, self.angle) {
            (Some(ratio), _) => ratio.si(),
            (None, angle) => libm::sin(0.5 * angle.unwrap_or(RIGHT_ANGLE).si()),
        }
    }
}

const RIGHT_ANGLE: Angle<HalfTurn> = Angle::constant(FRAC_PI_2);

/// `[web.graph]`: any net, read from two CSV files. File paths are relative to the scenario.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Graph {
    /// CSV file of the nodes, with columns id, x, y, z and optionally mass, fixed, vx, vy, vz. Values are in SI
    /// units; fixed is 0 or 1.
    #[schemars(extend("x-file" = true))]
    pub nodes: PathBuf,
    /// CSV file of the ropes, with columns a and b (node ids) and optionally rope, class, rest_length, pretension,
    /// segments. Values are in SI units.
    #[schemars(extend("x-file" = true))]
    pub ropes: PathBuf,
    /// The closed outline as node ids in order. Default: none; areas in the results are then null.
    pub outline: Option<Vec<String>>,
    /// The nodes where tractors are tied, as node ids. `hold.corners` holds these nodes. Default: none.
    pub corners: Option<Vec<String>>,
}

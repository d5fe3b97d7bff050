//! `[stow.PATTERN]`: how the web is packed before it is thrown.

use std::collections::BTreeMap;
use std::num::NonZeroU32;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::{CsvTable, Ids};
use crate::diagnostic::Diagnostic;
use crate::drive::Drive;
use crate::environment::STANDARD_GRAVITY;
use crate::interval::{BelowOne, Fraction, NonNegative, PackingTime, Positive, UpToOne, WholeTurn};
use crate::quantity::{Acceleration, Angle, Length, Number, Rate, Time};
use crate::written::Written;

/// `[stow]`: a pattern, and how the packed web differs from it. Default: the web starts as drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Stowage {
    /// The pattern.
    // flattening loses no place in the file: places come from the check of the schema
    #[serde(flatten)]
    pub pattern: Stow,
    /// Random and given deviations of the packed web from its pattern. Default: none.
    pub imperfection: Option<Imperfect>,
}

/// The packing: one table, named after its pattern.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Stow {
    /// The flat web, shrunk about its centre. Rest lengths do not change.
    Scale(ScaleStow),
    /// The web drawn in to a radius. Its middle hangs below the outline; the tractors are above it.
    Bag(BagStow),
    /// An accordion with upright layers, in a container.
    Zigzag(ZigzagStow),
    /// Radial folds wound around the middle.
    Star(StarStow),
    /// A band of upright layers, rolled up from its middle.
    Roll(FoldStow),
    /// Flat layers on top of each other.
    Layers(FoldStow),
    /// Knots led into a container along given paths; the rest of the web settles there.
    Prescribed(PrescribedStow),
    /// Positions from a CSV file.
    File(FileStow),
}

impl Stow {
    /// The path of its table in the scenario.
    pub fn table(&self) -> &'static str {
        match self {
            Self::Scale(_) => "stow.scale",
            Self::Bag(_) => "stow.bag",
            Self::Zigzag(_) => "stow.zigzag",
            Self::Star(_) => "stow.star",
            Self::Roll(_) => "stow.roll",
            Self::Layers(_) => "stow.layers",
            Self::Prescribed(_) => "stow.prescribed",
            Self::File(_) => "stow.file",
        }
    }

    /// Fills in the default distance between layers, which is the diameter `thickest` of the thickest rope.
    pub(crate) fn complete(&mut self, thickest: Length<Positive>) {
        let spacing = match self {
            Self::Zigzag(zigzag) => &mut zigzag.spacing,
            Self::Star(star) => &mut star.spacing,
            Self::Roll(fold) | Self::Layers(fold) => &mut fold.spacing,
            Self::Scale(_) | Self::Bag(_) | Self::Prescribed(_) | Self::File(_) => return,
        };
        spacing.get_or_insert(thickest);
    }
}

/// `[stow.scale]`: the flat web, shrunk about its centre. Rest lengths do not change.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleStow {
    /// Stowed size over drawn size, more than 0 and at most 1.
    pub factor: Number<UpToOne>,
}

/// `[stow.bag]`: the web drawn in to a radius. Its middle hangs below the outline; the tractors are above it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BagStow {
    /// Radius of the bag, m.
    pub radius: Length<Positive>,
    /// Depth of the middle below the outline, m. Default: 0.6 of the largest depth that the ropes allow.
    pub depth: Option<Length<NonNegative>>,
    /// Radius of the circle that the tractors stand on, m. Default: that of the bag.
    pub tractor_radius: Option<Length<Positive>>,
    /// Height of the tractors above the outline, m. Default: 0.6 of the length of the traction ropes, or less where
    /// that would stretch them.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// The container that a web is packed into. Its mouth points in the direction of the launch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Container {
    /// A tube about the launch axis.
    Cylinder(CylinderRoom),
    /// A box about the launch axis.
    Box(BoxRoom),
}

/// Inner sizes of a tube.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylinderRoom {
    /// Radius, m.
    pub radius: Length<Positive>,
    /// Height along the launch axis, m.
    pub height: Length<Positive>,
}

/// Inner sizes of a box.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxRoom {
    /// Size along the x axis of the flat web, m.
    pub width: Length<Positive>,
    /// Size along the y axis of the flat web, m.
    pub breadth: Length<Positive>,
    /// Height along the launch axis, m.
    pub height: Length<Positive>,
}

/// The direction of the folds of an accordion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Along {
    /// Rings around the middle. They stand one inside the other, and the middle lies on the floor.
    #[default]
    Rings,
    /// Parallel lines, folded a second time across.
    Lines,
}

/// `[stow.zigzag]`: an accordion with upright layers, in a container.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZigzagStow {
    /// The direction of the folds. Default: "rings".
    #[serde(default)]
    pub along: Along,
    /// The container that must hold the folded web, including the thickness of its ropes.
    pub container: Container,
    /// Distance between layers, m. Default: the diameter of the thickest rope, traction ropes excluded.
    pub spacing: Option<Length<Positive>>,
    /// Radius of the circle that the tractors stand on, m. Default: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// Height of the tractors above the packed web, m. Default: 0.6 of the length of the traction ropes, or less
    /// where that would stretch them.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.star]`: radial folds wound around the middle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StarStow {
    /// Number of arms. Default: the number of corners, or 6 where the web has fewer than 3.
    pub arms: Option<NonZeroU32>,
    /// The container that must hold the folded web, including the thickness of its ropes.
    pub container: Container,
    /// Distance between layers, m. Default: the diameter of the thickest rope, traction ropes excluded.
    pub spacing: Option<Length<Positive>>,
    /// Radius of the circle that the tractors stand on, m. Default: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// Height of the tractors above the packed web, m. Default: 0.6 of the length of the traction ropes, or less
    /// where that would stretch them.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.roll]`: a band of upright layers, rolled up from its middle. `[stow.layers]`: flat layers on top of each
/// other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FoldStow {
    /// The container that must hold the folded web, including the thickness of its ropes.
    pub container: Container,
    /// Distance between layers, m. Default: the diameter of the thickest rope, traction ropes excluded.
    pub spacing: Option<Length<Positive>>,
    /// Radius of the circle that the tractors stand on, m. Default: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// Height of the tractors above the packed web, m. Default: 0.6 of the length of the traction ropes, or less
    /// where that would stretch them.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.prescribed]`: some knots of the flat web are led along given paths. The rest follows under gravity and
/// damping until the web rests in a tube around the launch axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PrescribedStow {
    /// Radius of the container, m.
    pub radius: Length<Positive>,
    /// Depth of the floor of the container below the flat web, m. Default: none; there is no floor.
    pub depth: Option<Length<NonNegative>>,
    /// The knots that are led and their paths, by name. Displacements are in the launch frame, from where a knot lies
    /// in the flat web. A path ends within 1000 s. Default: the outline, led straight to a ring with the radius of
    /// the container.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drive: BTreeMap<String, Drive>,
    /// Time in which the outline is drawn in, s, where `drive` is left out. Default: 1 s.
    #[serde(default = "default_drawing_time")]
    pub time: Time<PackingTime>,
    /// Acceleration into the container, m/s^2. Default: 9.80665 m/s^2.
    #[serde(default = "default_packing_gravity")]
    pub gravity: Acceleration<NonNegative>,
    /// Mass-proportional damping, 1/s. Default: 5 1/s.
    #[serde(default = "default_packing_damping")]
    pub damping: Rate<NonNegative>,
    /// The web counts as resting when its kinetic energy has fallen to this share of its maximum. Default: 1e-4.
    #[serde(default = "default_resting_share")]
    pub rest: Number<BelowOne>,
    /// Time after which the packing ends even if the web does not rest, s. Default: 20 s.
    #[serde(default = "default_longest")]
    pub longest: Time<PackingTime>,
    /// Radius of the circle that the tractors stand on, m. Default: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// Height of the tractors above the packed web, m. Default: 0.6 of the length of the traction ropes, or less
    /// where that would stretch them.
    pub tractor_gap: Option<Length<NonNegative>>,
}

fn default_drawing_time() -> Time<PackingTime> {
    Time::constant(1.0)
}

fn default_packing_gravity() -> Acceleration<NonNegative> {
    Acceleration::constant(STANDARD_GRAVITY)
}

fn default_packing_damping() -> Rate<NonNegative> {
    Rate::constant(5.0)
}

fn default_resting_share() -> Number<BelowOne> {
    Number::constant(1e-4)
}

fn default_longest() -> Time<PackingTime> {
    Time::constant(20.0)
}

/// `[stow.imperfection]`: deviations of the packed web from its pattern. Random ones are drawn from a seed and are
/// the same on every machine. No deviation stretches a rope.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Imperfect {
    /// Standard deviation of each node's position along each of the two directions normal to the launch axis, m. A
    /// node moves less where a rope would stretch. Default: 0 m.
    pub scatter: Length<NonNegative>,
    /// Rotation of the lowest node about the launch axis, relative to the highest, rad. The web shrinks as far as the
    /// twist would stretch it. Default: 0 deg.
    pub twist: Angle,
    /// Share by which the web is shrunk before it is scattered, so that ropes have room to move. Default: 0.02.
    pub slack: Number<Fraction>,
    /// A sector of the web that stays where it is stowed until a given time. It is then released all at once and
    /// starts from rest. Default: none.
    pub late_sector: Option<LateSector>,
    /// Seed of the scatter and of the direction of a late sector. Default: 0.
    pub seed: u32,
}

/// `[stow.imperfection.late_sector]`: a sector that is caught in its container. It is released all at once and starts
/// from rest.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LateSector {
    /// Angle from edge to edge, about the launch axis, in the flat web, rad.
    pub width: Angle<WholeTurn>,
    /// Time of its release, s.
    pub until: Time<Positive>,
    /// Direction of its centre line, anticlockwise from the x axis of the flat web, rad. Default: random, from the
    /// seed.
    pub direction: Option<Angle>,
}

impl Default for Imperfect {
    fn default() -> Self {
        Self {
            scatter: Length::constant(0.0),
            twist: Angle::constant(0.0),
            slack: Number::constant(0.02),
            late_sector: None,
            seed: 0,
        }
    }
}

/// `[stow.file]`: positions from a CSV file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FileStow {
    /// CSV file of the stowed nodes, with columns id, x, y, z in m. The path is relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub path: PathBuf,
}

/// A row of the file of `[stow.file]`.
#[derive(Clone, Debug, PartialEq)]
pub struct StowRow {
    /// The node's id, unique.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
    /// The line of the file, counted from 1.
    pub line: usize,
}

/// A node that [`write_stow`] writes.
#[derive(Clone, Debug, PartialEq)]
pub struct StowedNode {
    /// The node's id.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
}

/// Writes a file for `[stow.file]`. Every decimal is the shortest that reads back to the same bits.
///
/// # Errors
/// Where the file cannot be written.
pub fn write_stow(path: &std::path::Path, nodes: impl IntoIterator<Item = StowedNode>) -> Result<(), csv::Error> {
    // nothing of the user's is written over
    let mut file = csv::Writer::from_writer(std::fs::File::create_new(path)?);
    file.write_record(["id", "x", "y", "z"])?;
    for StowedNode { id, position_m: [x, y, z] } in nodes {
        file.write_record([id, x.to_string(), y.to_string(), z.to_string()])?;
    }
    Ok(file.flush()?)
}

/// Reads the file of `[stow.file]`. `None` where the web is packed in another way or the file cannot be read.
pub(crate) fn read_stow(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<StowRow>> {
    let mut table = CsvTable::read(written, "stow.file.path", &["id", "x", "y", "z"], &[], found)?;
    let mut ids = Ids::default();
    Some(table.rows(found, |cells| {
        let id = ids.take(cells)?;
        Some(StowRow { id, position_m: cells.position()?, line: cells.line() })
    }))
}

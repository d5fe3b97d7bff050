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

/// `[stow]`: a pattern, and how the packed web differs from it. Left out: the web starts as drawn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Stowage {
    /// The pattern.
    // places in the file come from the schema's check, not from serde
    #[serde(flatten)]
    pub pattern: Stow,
    /// How the packed web differs from its pattern. Left out: it does not.
    pub imperfection: Option<Imperfect>,
}

/// The packing: one table, named after its pattern.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Stow {
    /// The flat web shrunk about its centre, rest lengths kept.
    Scale(ScaleStow),
    /// Drawn in to a radius, the middle hanging below, the tractors on top.
    Bag(BagStow),
    /// An accordion, its layers upright in a container.
    Zigzag(ZigzagStow),
    /// Radial folds wound round the middle.
    Star(StarStow),
    /// A band of upright layers, rolled up from its middle.
    Roll(FoldStow),
    /// Flat layers on one another.
    Layers(FoldStow),
    /// Led into a container along given paths, and settled there.
    Prescribed(PrescribedStow),
    /// Positions from a CSV file.
    File(FileStow),
}

impl Stow {
    /// The table that it is written in.
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

    /// Writes out the default of the distance between layers: the diameter of the thickest rope.
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

/// The room that a web is packed into, its mouth towards the launch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Container {
    /// A tube about the launch axis.
    Cylinder(CylinderRoom),
    /// A box about the launch axis.
    Box(BoxRoom),
}

/// A tube's inner sizes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CylinderRoom {
    /// Radius, m.
    pub radius: Length<Positive>,
    /// Height along the launch axis, m.
    pub height: Length<Positive>,
}

/// A box's inner sizes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BoxRoom {
    /// Size along x of the flat web, m.
    pub width: Length<Positive>,
    /// Size along y of the flat web, m.
    pub breadth: Length<Positive>,
    /// Height along the launch axis, m.
    pub height: Length<Positive>,
}

/// What the folds of an accordion follow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Along {
    /// Rings about the middle: walls one inside the other, the middle on the floor.
    #[default]
    Rings,
    /// Parallel lines, folded once more across.
    Lines,
}

/// `[stow.zigzag]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZigzagStow {
    /// What the folds follow. Default: rings.
    #[serde(default)]
    pub along: Along,
    /// The room that the web is folded into, ropes and all.
    pub container: Container,
    /// Distance between layers, m. Left out: the diameter of the thickest rope, traction ropes apart.
    pub spacing: Option<Length<Positive>>,
    /// Radius of the circle the tractors stand on, m. Left out: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// How far the tractors stand above the packed web, m. Left out: 0.6 of their ropes, or as far as these reach.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.star]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StarStow {
    /// How many arms. Left out: as many as corners, or 6 where there are fewer than 3.
    pub arms: Option<NonZeroU32>,
    /// The room that the web is folded into, ropes and all.
    pub container: Container,
    /// Distance between layers, m. Left out: the diameter of the thickest rope, traction ropes apart.
    pub spacing: Option<Length<Positive>>,
    /// Radius of the circle the tractors stand on, m. Left out: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// How far the tractors stand above the packed web, m. Left out: 0.6 of their ropes, or as far as these reach.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.roll]` and `[stow.layers]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FoldStow {
    /// The room that the web is folded into, ropes and all.
    pub container: Container,
    /// Distance between layers, m. Left out: the diameter of the thickest rope, traction ropes apart.
    pub spacing: Option<Length<Positive>>,
    /// Radius of the circle the tractors stand on, m. Left out: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// How far the tractors stand above the packed web, m. Left out: 0.6 of their ropes, or as far as these reach.
    pub tractor_gap: Option<Length<NonNegative>>,
}

/// `[stow.prescribed]`: some knots of the flat web are led along given paths, the rest follows under weight and damping,
/// until it rests in a tube about the launch axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PrescribedStow {
    /// Radius of the container, m.
    pub radius: Length<Positive>,
    /// How far the container's floor lies below the flat web, m. Left out: there is no floor.
    pub depth: Option<Length<NonNegative>>,
    /// What is led, by name; displacements are those in the launch frame, from where a knot lies in the flat web; a
    /// path ends within 1000 s. Left out: the outline, straight to a ring of the container's radius.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drive: BTreeMap<String, Drive>,
    /// In which time the outline is drawn in, s, where nothing else is led.
    #[serde(default = "drawing_in")]
    pub time: Time<PackingTime>,
    /// Acceleration into the container, m/s^2.
    #[serde(default = "standard_gravity")]
    pub gravity: Acceleration<NonNegative>,
    /// Mass-proportional damping, 1/s.
    #[serde(default = "strong_damping")]
    pub damping: Rate<NonNegative>,
    /// The web rests when its kinetic energy is this share of what it was at most.
    #[serde(default = "resting_share")]
    pub rest: Number<BelowOne>,
    /// After which time it is taken as it is, s.
    #[serde(default = "longest_settling")]
    pub longest: Time<PackingTime>,
    /// Radius of the circle the tractors stand on, m. Left out: that of the container.
    pub tractor_radius: Option<Length<Positive>>,
    /// How far the tractors stand above the packed web, m. Left out: 0.6 of their ropes, or as far as these reach.
    pub tractor_gap: Option<Length<NonNegative>>,
}

fn drawing_in() -> Time<PackingTime> {
    Time::constant(1.0)
}

fn standard_gravity() -> Acceleration<NonNegative> {
    Acceleration::constant(STANDARD_GRAVITY)
}

fn strong_damping() -> Rate<NonNegative> {
    Rate::constant(5.0)
}

fn resting_share() -> Number<BelowOne> {
    Number::constant(1e-4)
}

fn longest_settling() -> Time<PackingTime> {
    Time::constant(20.0)
}

/// `[stow.imperfection]`: drawn from a seed, the same on every machine; it stretches no rope.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Imperfect {
    /// Standard deviation of each node's place along each of the two directions normal to the launch axis, m; ropes that
    /// would be stretched by it shorten the way.
    pub scatter: Length<NonNegative>,
    /// Turn of the lowest node about the launch axis against the highest, rad; the web shrinks by what it would stretch.
    pub twist: Angle,
    /// By how much the web is shrunk beforehand, so that ropes have room to move.
    pub slack: Number<Fraction>,
    /// A sector of the web that stays where it is stowed for a while. Left out: none does.
    pub late_sector: Option<LateSector>,
    /// What the scatter, and a late sector's direction, are drawn from.
    pub seed: u32,
}

/// `[stow.imperfection.late_sector]`: it catches in its container, and starts from rest when that lets go of it at once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LateSector {
    /// From edge to edge, about the launch axis of the flat web, rad.
    pub width: Angle<WholeTurn>,
    /// When it is let go of, s.
    pub until: Time<Positive>,
    /// Direction of its middle line, anticlockwise from x of the flat web, rad. Left out: drawn from the seed.
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

/// `[stow.file]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FileStow {
    /// CSV file of the stowed nodes: columns id, x, y, z, in m. Relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub path: PathBuf,
}

/// A row of `[stow.file]`.
#[derive(Clone, Debug, PartialEq)]
pub struct StowRow {
    /// The node's id, unique.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
    /// Its line in the file, from 1.
    pub line: usize,
}

/// A node as [`write_stow`] writes it.
#[derive(Clone, Debug, PartialEq)]
pub struct StowedNode {
    /// The node's id.
    pub id: String,
    /// Position x, y, z, m.
    pub position_m: [f64; 3],
}

/// Writes a file for `[stow.file]`. Decimals are the shortest that read back to the same bits.
///
/// # Errors
/// Where the file cannot be written.
pub fn write_stow(path: &std::path::Path, nodes: impl IntoIterator<Item = StowedNode>) -> Result<(), csv::Error> {
    let mut file = csv::Writer::from_path(path)?;
    file.write_record(["id", "x", "y", "z"])?;
    for StowedNode { id, position_m: [x, y, z] } in nodes {
        file.write_record([id, x.to_string(), y.to_string(), z.to_string()])?;
    }
    Ok(file.flush()?)
}

/// Reads the file of `[stow.file]`; none where the web is packed in another way or the file cannot be read.
pub(crate) fn read_stow(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<StowRow>> {
    let mut table = CsvTable::read(written, "stow.file.path", &["id", "x", "y", "z"], &[], found)?;
    let mut ids = Ids::default();
    Some(table.rows(found, |cells| {
        let id = ids.take(cells)?;
        Some(StowRow { id, position_m: cells.position()?, line: cells.line() })
    }))
}

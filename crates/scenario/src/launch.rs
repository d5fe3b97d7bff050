//! `[launch]`: how the tractors are thrown.

use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::interval::{NonNegative, Positive, QuarterTurns};
use crate::quantity::{Angle, AngularSpeed, Force, Length, Number, Speed, Time};
use crate::tractor::TractorOverride;
use crate::written::Written;

/// `[launch]`. Left out: nothing is launched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Launch {
    /// Speed of the tractors along the launch axis, m/s.
    pub axial_speed: Speed,
    /// Speed of the tractors away from the launch axis, along the web's own corner directions, m/s.
    pub radial_speed: Speed,
    /// Elevation of the launch axis above the horizontal.
    pub elevation: Angle<QuarterTurns>,
    /// Azimuth of the launch axis, anticlockwise from x.
    pub azimuth: Angle,
    /// How fast all that is launched turns about the launch axis at the start, rad/s, anticlockwise seen from ahead.
    pub spin: AngularSpeed,
    /// Where the tractors point at the start.
    pub attitude: Attitude,
    /// The tubes that the tractors are launched from. Left out: they start at their speed.
    pub tube: Option<Tube>,
    /// How much the tractors' launches differ by chance. Left out: not at all.
    pub scatter: Option<Scatter>,
}

/// Where a body's z axis points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Attitude {
    /// The way it is launched; along the launch axis where it is not.
    #[default]
    Flight,
    /// Along the launch axis.
    Axis,
}

/// `[launch.tube]`: a straight tube from where each tractor is stowed. The force that pushes it along is given; what comes
/// out is its speed, and the recoil.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "anyOf" = [{"required": ["force_over_time"]}, {"required": ["force_over_stroke"]}],
    "not" = {"required": ["force_over_stroke", "force_over_time"]}
))]
pub struct Tube {
    /// How far it guides a tractor, m.
    pub stroke: Length<Positive>,
    /// Angle between the tube and the launch axis, outwards.
    #[serde(default = "no_angle")]
    pub cant: Angle,
    /// The force on a tractor over the way that it has gone in the tube: a spring, a gas that expands.
    pub force_over_stroke: Option<StrokeForce>,
    /// The force on a tractor over the time since it was fired.
    pub force_over_time: Option<TimeForce>,
}

/// A force over a way: points given here, or in a file. Straight between two points, constant before the first and after
/// the last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "anyOf" = [{"required": ["file"]}, {"required": ["at", "force"]}],
    "not" = {"required": ["at", "file"]}
))]
pub struct StrokeForce {
    /// Ways, m, ascending.
    pub at: Option<Vec<Length<NonNegative>>>,
    /// The force at each of them, N.
    pub force: Option<Vec<Force<NonNegative>>>,
    /// CSV file: columns stroke, in m, and force, in N. Relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: Option<PathBuf>,
}

/// A force over time: points given here, or in a file. Straight between two points, constant before the first and after
/// the last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "anyOf" = [{"required": ["file"]}, {"required": ["at", "force"]}],
    "not" = {"required": ["at", "file"]}
))]
pub struct TimeForce {
    /// Times since firing, s, ascending.
    pub at: Option<Vec<Time<NonNegative>>>,
    /// The force at each of them, N.
    pub force: Option<Vec<Force<NonNegative>>>,
    /// CSV file: columns time, in s, and force, in N. Relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: Option<PathBuf>,
}

/// `[launch.scatter]`: normally distributed, each tractor by itself; the same seed gives the same launch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Scatter {
    /// Standard deviation of a tractor's speed, as a share of it. In a tube the force is scaled such that the speed
    /// scatters so.
    pub speed: Number<NonNegative>,
    /// Standard deviation of a tractor's direction, along each of two axes across it.
    pub angle: Angle<NonNegative>,
    /// Standard deviation of the time at which a tractor is launched, s; the first to go does so at its own delay.
    pub delay: Time<NonNegative>,
    /// Which of all the launches that could be.
    pub seed: u32,
}

fn no_angle() -> Angle {
    Angle::constant(0.0)
}

impl Default for Launch {
    fn default() -> Self {
        Self {
            axial_speed: Speed::constant(0.0),
            radial_speed: Speed::constant(0.0),
            elevation: Angle::constant(FRAC_PI_2),
            azimuth: Angle::constant(0.0),
            spin: AngularSpeed::constant(0.0),
            attitude: Attitude::default(),
            tube: None,
            scatter: None,
        }
    }
}

impl Default for Scatter {
    fn default() -> Self {
        Self { speed: Number::constant(0.0), angle: Angle::constant(0.0), delay: Time::constant(0.0), seed: 0 }
    }
}

impl Launch {
    /// The launch of a tractor with its own speeds and angles.
    pub(crate) fn with(&self, tractor: &TractorOverride) -> Self {
        Self {
            axial_speed: tractor.axial_speed.unwrap_or(self.axial_speed),
            radial_speed: tractor.radial_speed.unwrap_or(self.radial_speed),
            elevation: tractor.elevation.unwrap_or(self.elevation),
            azimuth: tractor.azimuth.unwrap_or(self.azimuth),
            ..self.clone()
        }
    }
}

/// A row of the file of a force in `[launch.tube]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PushRow {
    /// Way in the tube, m, or time since firing, s.
    pub at: f64,
    /// Force, N.
    pub force_n: f64,
}

/// Reads the file of the force in `[launch.tube]`; none where it has none or the file cannot be read.
pub(crate) fn read_push(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<PushRow>> {
    let named = [("force_over_stroke", "stroke"), ("force_over_time", "time")];
    let mut read = |(key, column): (&str, &str)| {
        let path = format!("launch.tube.{key}.file");
        let mut table = CsvTable::read(written, &path, &[column, "force"], &[], found)?;
        if table.is_empty() {
            found.push(table.whole("no points"));
        }
        let mut last = None;
        Some(table.rows(found, |cells| {
            let (at, force) = (cells.number(column), cells.number("force"));
            let row = PushRow { at: at?, force_n: force? };
            if row.at < 0.0 || last.is_some_and(|last| row.at <= last) {
                cells.fault_in(column, format!("{column}: expected more than in the line before, from 0 on"), None);
            }
            if row.force_n < 0.0 {
                cells.fault_in("force", "force: a launcher pushes, and does not pull".into(), None);
            }
            last = Some(row.at);
            Some(row)
        }))
    };
    named.into_iter().find_map(&mut read)
}

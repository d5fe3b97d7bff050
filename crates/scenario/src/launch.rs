//! `[launch]`: how the tractors are thrown.

use std::f64::consts::FRAC_PI_2;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Kind, Measured, unit};
use crate::interval::{NonNegative, Positive, QuarterTurns, Splay};
use crate::path::Path;
use crate::quantity::{Angle, AngularSpeed, Force, Length, Number, Speed, Time};
use crate::shift::Shift;
use crate::tractor::TractorOverride;
use crate::written::Written;

/// `[launch]`: how the tractors are thrown. Default: nothing is launched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("not" = {"required": ["radial_speed", "spread"]}))]
pub struct Launch {
    /// Speed of the tractors along the launch axis, m/s. Default: 0 m/s.
    pub axial_speed: Speed,
    /// Speed of each tractor away from the launch axis, in the direction of its corner, m/s. Default: 0 m/s.
    pub radial_speed: Speed,
    /// Angle between the flight of each tractor and the launch axis, as of a launcher with splayed tubes, rad: the radial speed
    /// is then `axial_speed` times its tangent. A tube that is turned by its own force has `tube.cant` instead. Default: none;
    /// `radial_speed` applies.
    // none after reading: `radial_speed` then has its value
    #[serde(skip_serializing)]
    pub spread: Option<Angle<Splay>>,
    /// Elevation of the launch axis above the horizontal, rad. Default: 90 deg, straight up.
    pub elevation: Angle<QuarterTurns>,
    /// Azimuth of the launch axis, anticlockwise from x, rad. Default: 0 deg.
    pub azimuth: Angle,
    /// Angular speed of the packed net about the launch axis at the start, rad/s, anticlockwise as seen from ahead.
    /// Default: 0 rad/s.
    pub spin: AngularSpeed,
    /// Direction of the axes of the tractors at the start. Default: "flight".
    pub attitude: Attitude,
    /// Straight tubes from which the tractors are launched by a given force, in place of both speeds. Default: none;
    /// the tractors start with their speed.
    pub tube: Option<Tube>,
    /// Random deviations of the launches of the tractors. Default: none.
    pub scatter: Option<Scatter>,
}

/// Direction of the z axis of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Attitude {
    /// In the direction of its launch, or along the launch axis where it is not launched.
    #[default]
    Flight,
    /// Along the launch axis.
    Axis,
}

/// `[launch.tube]`: each tractor is launched from a straight tube by a given force. The force sets its speed and the
/// recoil. Give either `force_over_stroke` or `force_over_time`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "anyOf" = [{"required": ["force_over_time"]}, {"required": ["force_over_stroke"]}],
    "not" = {"required": ["force_over_stroke", "force_over_time"]}
))]
pub struct Tube {
    /// Length over which the tube guides a tractor, m.
    pub stroke: Length<Positive>,
    /// Angle between the tube and the launch axis, rad, positive outwards. Default: 0 deg.
    #[serde(default = "default_cant")]
    pub cant: Angle,
    /// Force on a tractor as a function of its distance in the tube, as of a spring or an expanding gas. Give this or
    /// `force_over_time`.
    pub force_over_stroke: Option<StrokeForce>,
    /// Force on a tractor as a function of the time since firing. Give this or `force_over_stroke`.
    pub force_over_time: Option<TimeForce>,
}

/// A force as a function of distance, given by points here or in a file. It is linear between two points, constant
/// before the first and after the last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "anyOf" = [{"required": ["file"]}, {"required": ["at", "force"]}],
    "allOf" = [{"not": {"required": ["at", "file"]}}, {"not": {"required": ["at", "scale"]}}]
))]
pub struct StrokeForce {
    /// Distances in the tube, m, in ascending order. Give `at` and `force`, or `file`.
    pub at: Option<Vec<Length<NonNegative>>>,
    /// Force at each of these distances, N.
    pub force: Option<Vec<Force<NonNegative>>>,
    /// CSV file with columns stroke, in m, and force, in N. The path is relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: Option<PathBuf>,
    /// What the forces of the file are multiplied by. Default: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<Number<NonNegative>>,
}

/// A force as a function of time, given by points here or in a file. It is linear between two points, constant before
/// the first and after the last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "anyOf" = [{"required": ["file"]}, {"required": ["at", "force"]}],
    "allOf" = [
        {"not": {"required": ["at", "file"]}},
        {"not": {"required": ["at", "time_offset"]}},
        {"not": {"required": ["at", "scale"]}}
    ]
))]
pub struct TimeForce {
    /// Times since firing, s, in ascending order. Give `at` and `force`, or `file`.
    pub at: Option<Vec<Time<NonNegative>>>,
    /// Force at each of these times, N.
    pub force: Option<Vec<Force<NonNegative>>>,
    /// CSV file with columns time, in s, and force, in N. The path is relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: Option<PathBuf>,
    /// What is added to the times of the file, s. Default: 0 s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_offset: Option<Time>,
    /// What the forces of the file are multiplied by. Default: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<Number<NonNegative>>,
}

/// `[launch.scatter]`: normally distributed deviations, independent for each tractor. The same seed gives the same
/// launch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Scatter {
    /// Standard deviation of a tractor's speed, as a share of it. In a tube the force is scaled so that the speed has
    /// this deviation. Default: 0.
    pub speed: Number<NonNegative>,
    /// Standard deviation of a tractor's direction, along each of two axes normal to it, rad. Default: 0 deg.
    pub angle: Angle<NonNegative>,
    /// Standard deviation of the launch time of a tractor, s. The first tractor is launched at its own delay.
    /// Default: 0 s.
    pub delay: Time<NonNegative>,
    /// Seed of the random numbers. Default: 0.
    pub seed: u32,
}

fn default_cant() -> Angle {
    Angle::constant(0.0)
}

impl Default for Launch {
    fn default() -> Self {
        Self {
            axial_speed: Speed::constant(0.0),
            radial_speed: Speed::constant(0.0),
            spread: None,
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

/// The radial speed, m/s, of a flight at this angle to the axis, rad.
fn radial(axial_speed: Speed, spread: Angle<Splay>) -> Speed {
    Speed::constant(axial_speed.si() * libm::tan(spread.si()))
}

/// Puts the radial speed of a tractor in the place of its spread, which is its own or that of `launch`.
pub(crate) fn complete_tractor(tractor: &mut TractorOverride, launch: Option<&Launch>) {
    let common = launch.and_then(|launch| launch.spread).filter(|_| tractor.radial_speed.is_none());
    if let Some(spread) = tractor.spread.take().or(common) {
        let axial_speed = tractor.axial_speed.or(launch.map(|launch| launch.axial_speed));
        tractor.radial_speed = Some(radial(axial_speed.unwrap_or(Speed::constant(0.0)), spread));
    }
}

impl Launch {
    /// Puts the radial speed in the place of a spread.
    pub(crate) fn complete(&mut self) {
        if let Some(spread) = self.spread.take() {
            self.radial_speed = radial(self.axial_speed, spread);
        }
    }

    /// The launch of `tractor`, with the speeds and angles that are given for it.
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
    /// Distance in the tube, m, or time since firing, s.
    pub at: f64,
    /// Force, N.
    pub force_n: f64,
}

/// Reads the file of the force in `[launch.tube]`. `None` where the scenario names none or the file cannot be read.
pub(crate) fn read_push(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<PushRow>> {
    let tables = [("force_over_stroke", "stroke", unit::Metre::KIND), ("force_over_time", "time", unit::Second::KIND)];
    let mut read = |(key, column, kind): (&str, &str, &Kind)| {
        let path = format!("launch.tube.{key}.file");
        let mut table = CsvTable::read(written, &path, &[column, "force"], &[], found)?;
        if table.is_empty() {
            found.push(table.whole("the file has no points"));
        }
        let shift = Shift::beside(written, &Path::parse(&path));
        let mut last = None;
        Some(table.rows(found, |cells| {
            let (at, force) = (cells.number(column, kind), cells.number("force", unit::Newton::KIND));
            let row = PushRow { at: shift.time(at?), force_n: shift.scale * force? };
            if row.at < 0.0 || last.is_some_and(|last| row.at <= last) {
                cells.fault_in(
                    column,
                    format!("{column}: expected a value of at least 0, larger than in the line before"),
                    None,
                );
            }
            if row.force_n < 0.0 {
                cells.fault_in("force", "force: expected a value of at least 0: a launcher does not pull".into(), None);
            }
            last = Some(row.at);
            Some(row)
        }))
    };
    tables.into_iter().find_map(&mut read)
}

//! `[environment.wind]`: how the air moves, depending on height and time.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Measured, unit};
use crate::interval::{BoundaryLayer, Fraction, NonNegative, Positive};
use crate::path::Path;
use crate::quantity::{Angle, Length, Number, Speed, Time};
use crate::shift::Shift;
use crate::written::Written;

/// `[environment.wind]`: a mean `speed`, uniform or with a profile, with optional gust and turbulence; or a measured
/// `series`. Give either `speed` or `series`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["power", "logarithmic"]},
    "anyOf" = [{"required": ["series"]}, {"required": ["speed"]}]
))]
pub struct Wind {
    /// Mean speed, m/s. With a profile it is the speed at the reference height. Give this or `series`.
    pub speed: Option<Speed<NonNegative>>,
    /// Direction that the wind blows to, anticlockwise from x, rad. Default: 0 deg, along x.
    pub azimuth: Option<Angle>,
    /// Height of the muzzle above the ground, m, for the profile. Default: its height above `[environment.ground]`,
    /// else 0 m.
    pub muzzle_height: Option<Length<BoundaryLayer>>,
    /// A mean speed that grows as a power of the height. It excludes `logarithmic`. Default: none; without a profile
    /// the mean speed is the same at any height.
    pub power: Option<PowerProfile>,
    /// A mean speed that grows as the logarithm of the height. It excludes `power`. Default: none.
    pub logarithmic: Option<LogarithmicProfile>,
    /// A gust on top of the mean wind. Default: none.
    pub gust: Option<Gust>,
    /// Turbulence on top of the mean wind. Default: none.
    pub turbulence: Option<Turbulence>,
    /// A measured wind. It replaces all other keys of the wind. Default: none.
    pub series: Option<WindSeries>,
}

impl Wind {
    /// Fills in the default direction of a wind that is not measured.
    pub(crate) fn complete(&mut self) {
        if self.series.is_none() {
            self.azimuth.get_or_insert(Angle::constant(0.0));
        }
    }
}

const REFERENCE_HEIGHT: Length<Positive> = Length::constant(10.0);

/// `[environment.wind.power]`: u(z) = speed (z / reference_height)^exponent.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct PowerProfile {
    /// The exponent: 1/7 over open land (Hellmann 1919), 0.1 over water, 0.25 to 0.4 over woods and towns. Default:
    /// 1/7.
    pub exponent: Number<Fraction>,
    /// Height above the ground at which the wind has its mean speed, m. Weather services measure at 10 m. Default: 10
    /// m.
    pub reference_height: Length<Positive>,
}

impl Default for PowerProfile {
    fn default() -> Self {
        Self { exponent: Number::constant(1.0 / 7.0), reference_height: REFERENCE_HEIGHT }
    }
}

/// `[environment.wind.logarithmic]`: u(z) = speed ln(z / roughness) / ln(reference_height / roughness).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct LogarithmicProfile {
    /// Roughness length of the ground, m: 0.2 mm for open water, 3 cm for grass, 0.1 to 0.5 m for fields with hedges,
    /// 1 m for woods and towns (Davenport's classes; Wieringa 1992). Default: 3 cm.
    pub roughness: Length<Positive>,
    /// Height above the ground at which the wind has its mean speed, m. Weather services measure at 10 m. Default: 10
    /// m.
    pub reference_height: Length<Positive>,
}

impl Default for LogarithmicProfile {
    fn default() -> Self {
        Self { roughness: Length::constant(0.03), reference_height: REFERENCE_HEIGHT }
    }
}

/// `[environment.wind.gust]`: a gust that rises and falls as (1 - cos) / 2, everywhere at the same time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gust {
    /// Largest speed that the gust adds, m/s.
    pub speed: Speed,
    /// Time at which the gust begins, s.
    pub at: Time<NonNegative>,
    /// Duration of the gust, s.
    pub duration: Time<Positive>,
    /// Direction that the gust blows to, anticlockwise from x, rad. Default: the direction of the wind.
    pub azimuth: Option<Angle>,
}

/// The turbulence: one table, named after its spectrum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Turbulence {
    /// Von Karman's spectrum. It falls as the frequency to the power -5/3.
    VonKarman(Eddies),
    /// Dryden's spectrum. It falls as the frequency to the power -2.
    Dryden(Eddies),
}

impl Turbulence {
    /// Strength and size of the eddies.
    pub fn eddies(&self) -> &Eddies {
        match self {
            Self::VonKarman(eddies) | Self::Dryden(eddies) => eddies,
        }
    }

    /// The path of its table in the scenario.
    pub fn table(&self) -> &'static str {
        match self {
            Self::VonKarman(_) => "environment.wind.turbulence.von_karman",
            Self::Dryden(_) => "environment.wind.turbulence.dryden",
        }
    }
}

/// `[environment.wind.turbulence.SPECTRUM]`: isotropic turbulence whose eddies travel with the mean speed of the
/// wind. Give either `intensity` or `deviation`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["deviation", "intensity"]},
    "anyOf" = [{"required": ["deviation"]}, {"required": ["intensity"]}]
))]
pub struct Eddies {
    /// Standard deviation of each velocity component over the mean speed. It is 0.1 to 0.2 near open ground. Give
    /// this or `deviation`.
    pub intensity: Option<Number<NonNegative>>,
    /// Standard deviation of each velocity component, m/s. Give this or `intensity`.
    pub deviation: Option<Speed<NonNegative>>,
    /// Length scale of the turbulence along the wind, m. It grows with the height above the ground.
    pub length_scale: Length<Positive>,
    /// Seed of the random numbers. The same seed gives the same wind. Default: 0.
    #[serde(default)]
    pub seed: u32,
}

/// `[environment.wind.series]`: a measured wind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WindSeries {
    /// CSV file of the wind, with columns t, the time since the start in s, and vx, vy, vz, the velocity in m/s in
    /// the world frame. The velocity is linear from row to row, constant before the first row and after the last. The
    /// path is relative to the scenario.
    #[schemars(extend("x-file" = true))]
    pub file: PathBuf,
    /// What is added to the times of the file, s: "-1000 s" for a clock that shows 1000 s at the start. Default: 0 s.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time_offset: Option<Time>,
    /// What the velocities of the file are multiplied by. Default: 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scale: Option<Number>,
}

/// A row of the file of `[environment.wind.series]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindRow {
    /// Time since the start, s.
    pub time_s: f64,
    /// Velocity x, y, z of the air, m/s.
    pub velocity_m_s: [f64; 3],
}

/// The largest time in a wind series, s. Larger ones are mistakes.
const LONGEST_WIND: f64 = 1e9;

/// Reads the file of `[environment.wind.series]`. `None` where the scenario names none or the file cannot be read.
pub(crate) fn read_wind(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<WindRow>> {
    let mut table = CsvTable::read(written, "environment.wind.series.file", &["t", "vx", "vy", "vz"], &[], found)?;
    if table.is_empty() {
        found.push(table.whole("the file has no rows"));
    }
    let shift = Shift::beside(written, &Path::parse("environment.wind.series.file"));
    let mut before = None;
    Some(table.rows(found, |cells| {
        let time = cells.number("t", unit::Second::KIND);
        let [vx, vy, vz] = ["vx", "vy", "vz"].map(|column| cells.number(column, unit::MetrePerSecond::KIND));
        let row = WindRow { time_s: shift.time(time?), velocity_m_s: shift.vector([vx?, vy?, vz?]) };
        if before.is_some_and(|before| row.time_s <= before) {
            cells.fault_in("t", "t: expected a time after that of the line before".into(), None);
        }
        if row.time_s.abs() > LONGEST_WIND {
            cells.fault_in("t", format!("t: expected a time within {LONGEST_WIND:e} s of the start"), None);
        }
        before = Some(row.time_s);
        Some(row)
    }))
}

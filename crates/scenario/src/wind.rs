//! `[environment.wind]`: how the air moves, by height and in the course of time.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::csv_table::CsvTable;
use crate::diagnostic::Diagnostic;
use crate::interval::{BoundaryLayer, Fraction, NonNegative, Positive};
use crate::quantity::{Angle, Length, Number, Speed, Time};
use crate::written::Written;

/// `[environment.wind]`: a mean `speed`, uniform or by a profile, with a gust and turbulence; or a measured `series`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["power", "logarithmic"]},
    "anyOf" = [{"required": ["series"]}, {"required": ["speed"]}]
))]
pub struct Wind {
    /// Mean speed, m/s; of a profile, at its reference height.
    pub speed: Option<Speed<NonNegative>>,
    /// Where it blows to, anticlockwise from x. Left out: along x.
    pub azimuth: Option<Angle>,
    /// Height of the muzzle above the ground, m, which a profile begins at. Left out: as [environment.ground] has it, or 0.
    pub muzzle_height: Option<Length<BoundaryLayer>>,
    /// The mean grows as a power of the height. Left out, and no `logarithmic` either: the mean is the same at any height.
    pub power: Option<PowerProfile>,
    /// The mean grows as the logarithm of the height.
    pub logarithmic: Option<LogarithmicProfile>,
    /// A gust.
    pub gust: Option<Gust>,
    /// Turbulence.
    pub turbulence: Option<Turbulence>,
    /// A measured wind, instead of all else.
    pub series: Option<WindSeries>,
}

impl Wind {
    /// Writes the direction of what is not measured out.
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
    /// The exponent: a seventh over open land (Hellmann 1919), 0.1 over water, 0.25 to 0.4 over woods and towns.
    pub exponent: Number<Fraction>,
    /// Height above the ground at which the wind has its speed, m: weather services measure at 10 m.
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
    /// Roughness length of the ground, m: 0.2 mm of open water, 3 cm of grass, 0.1 to 0.5 m of fields with hedges, 1 m of
    /// woods and towns (Davenport's classes; Wieringa 1992).
    pub roughness: Length<Positive>,
    /// Height above the ground at which the wind has its speed, m: weather services measure at 10 m.
    pub reference_height: Length<Positive>,
}

impl Default for LogarithmicProfile {
    fn default() -> Self {
        Self { roughness: Length::constant(0.03), reference_height: REFERENCE_HEIGHT }
    }
}

/// `[environment.wind.gust]`: it rises and falls as (1 - cos)/2, all over the net at once.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Gust {
    /// Largest speed that it adds, m/s.
    pub speed: Speed,
    /// When it begins, s.
    pub at: Time<NonNegative>,
    /// How long it lasts, s.
    pub duration: Time<Positive>,
    /// Where it blows to, anticlockwise from x. Left out: where the wind does.
    pub azimuth: Option<Angle>,
}

/// The turbulence: one table, named after its spectrum.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Turbulence {
    /// Von Karman's spectrum, which falls as the power -5/3 of the frequency.
    VonKarman(Eddies),
    /// Dryden's spectrum, which falls as its power -2.
    Dryden(Eddies),
}

impl Turbulence {
    /// How strong and how large its eddies are.
    pub fn eddies(&self) -> &Eddies {
        match self {
            Self::VonKarman(eddies) | Self::Dryden(eddies) => eddies,
        }
    }

    /// The table that it is written in.
    pub fn table(&self) -> &'static str {
        match self {
            Self::VonKarman(_) => "environment.wind.turbulence.von_karman",
            Self::Dryden(_) => "environment.wind.turbulence.dryden",
        }
    }
}

/// `[environment.wind.turbulence.SPECTRUM]`: isotropic; its eddies pass at the wind's `speed`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend(
    "not" = {"required": ["deviation", "intensity"]},
    "anyOf" = [{"required": ["deviation"]}, {"required": ["intensity"]}]
))]
pub struct Eddies {
    /// Standard deviation of each component over the wind's speed; 0.1 to 0.2 near open ground.
    pub intensity: Option<Number<NonNegative>>,
    /// Standard deviation of each component, m/s.
    pub deviation: Option<Speed<NonNegative>>,
    /// Length scale along the wind, m: the size of the eddies, which grows with the height above the ground.
    pub length_scale: Length<Positive>,
    /// Which of all the winds that could be: the same seed gives the same wind.
    #[serde(default)]
    pub seed: u32,
}

/// `[environment.wind.series]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WindSeries {
    /// CSV file of the wind, relative to the scenario: columns t, in s since the start, and vx, vy, vz, in m/s in the world
    /// frame. Straight from row to row, constant before the first and after the last.
    #[schemars(extend("x-file" = true))]
    pub file: PathBuf,
}

/// A row of the file of `[environment.wind.series]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindRow {
    /// Time since the start, s.
    pub time_s: f64,
    /// Velocity x, y, z of the air, m/s.
    pub velocity_m_s: [f64; 3],
}

/// Nobody measures a wind for longer, s.
const LONGEST_WIND: f64 = 1e9;

/// Reads the file of `[environment.wind.series]`; none where there is none or the file cannot be read.
pub(crate) fn read_wind(written: &Written, found: &mut Vec<Diagnostic>) -> Option<Vec<WindRow>> {
    let mut table = CsvTable::read(written, "environment.wind.series.file", &["t", "vx", "vy", "vz"], &[], found)?;
    if table.is_empty() {
        found.push(table.whole("no wind"));
    }
    let mut before = None;
    Some(table.rows(found, |cells| {
        let [time, vx, vy, vz] = ["t", "vx", "vy", "vz"].map(|column| cells.number(column));
        let row = WindRow { time_s: time?, velocity_m_s: [vx?, vy?, vz?] };
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

//! `summary.json`: the numbers of a run on one page.
//!
//! Fields have the order and the names of the keys in the file. `None` is written as `null`: the scenario has no such
//! thing (no outline, no tractor, nothing launched), or it never happened. A number that is not finite is refused,
//! because JSON would also write it as `null`.
//!
//! A file of another version can be read: missing keys take their defaults, unknown keys are ignored.

mod computation;
mod file;
mod flight;
mod launch;
mod opening;
mod ropes;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};

use crate::quantity::{Dimension, Quantity};
use crate::{ResultError, json};

pub use computation::{EnergyBalance, ModelSize, StepSize};
pub use file::SummaryFile;
pub use flight::{AirMet, Flight, Place, Places, PointExtremes, Reaction};
pub use launch::{Departure, Departures, Equilibrium, Recoil, StowedState};
pub use opening::{Mouth, Opening, Posture, TargetCoverage};
pub use ropes::{BrokenSegment, ClassTension, RopeUse, SheetStress, Tension};

/// The numbers of a run, in SI.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Summary {
    /// The scenario's title.
    pub title: String,
    /// Version of netcast that computed the run.
    pub netcast: String,
    /// Time that the computation took on the clock, s: the only number here that differs between two equal runs. NaN if
    /// it is unknown.
    #[serde(default = "unknown", deserialize_with = "number_or_unknown")]
    pub wall_time_s: f64,
    /// Whether the run reached its end.
    #[serde(default = "finished_by_default")]
    pub finished: bool,
    /// Size and mass of the model.
    pub model: ModelSize,
    /// The time step.
    #[serde(default = "missing_section")]
    pub step: StepSize,
    /// The equilibrium; none if the scenario asks for none.
    #[serde(rename = "static")]
    pub statics: Option<Equilibrium>,
    /// How the tractors were launched; none without a launch.
    pub launch: Option<Departures>,
    /// The medium and the wind; none without air.
    pub air: Option<AirMet>,
    /// How far and how long the web opened.
    pub opening: Opening,
    /// Where the web is when it opens, when it closes, when it is largest.
    pub places: Places,
    /// Extremes of each feature point and of `tractor`, `corner` and `centre`; `None` if the web has no such point.
    pub points: BTreeMap<String, Option<PointExtremes>>,
    /// The force of each support on what it holds or drives, and of all of them together, `supports`; empty where nothing is
    /// held.
    pub reactions: BTreeMap<String, Reaction>,
    /// Rope tension.
    #[serde(default = "missing_section")]
    pub tension: Tension,
    /// The segments that broke, in order of time.
    pub breaks: Vec<BrokenSegment>,
    /// When the middle trails the outline and when it leads.
    pub posture: Posture,
    /// Tilt and asymmetry of the mouth.
    pub mouth: Mouth,
    /// Share of the target that the web covers; none if the scenario states no target.
    pub target: Option<TargetCoverage>,
    /// Apex, hang time and landing of the web.
    pub flight: Flight,
    /// Stress of the canopies; none without sheets.
    pub canopies: Option<SheetStress>,
    /// The packed web at the start.
    pub stowed: StowedState,
    /// The energy ledger and how well it closes.
    #[serde(default = "missing_section")]
    pub energy: EnergyBalance,
    /// Sentences that a reader needs before trusting the numbers.
    pub warnings: Vec<String>,
}

impl Summary {
    /// Rows of the table of quantities for keys outside any section. `title`, `netcast`, `finished` and `warnings` tell
    /// about the run and are not quantities.
    pub(crate) const QUANTITIES: &'static [Quantity] = &[Quantity::new(
        "",
        "wall_time_s",
        "Computed in",
        Dimension::Duration,
        "Time that the computation took on the clock; differs between two equal runs.",
    )];

    /// The summary as JSON text with a final newline. Decimals are the shortest that read back equal.
    ///
    /// # Errors
    /// [`ResultError::NotFinite`] names the section that holds an infinity or a NaN.
    pub fn to_json(&self) -> Result<String, ResultError> {
        if !self.wall_time_s.is_finite() {
            return Err(ResultError::NotFinite { section: "wall_time_s" });
        }
        require_finite("model", &self.model)?;
        require_finite("step", &self.step)?;
        require_finite("launch", &self.launch)?;
        require_finite("air", &self.air)?;
        require_finite("static", &self.statics)?;
        require_finite("opening", &self.opening)?;
        require_finite("places", &self.places)?;
        require_finite("points", &self.points)?;
        require_finite("reactions", &self.reactions)?;
        require_finite("tension", &self.tension)?;
        require_finite("breaks", &self.breaks)?;
        require_finite("posture", &self.posture)?;
        require_finite("mouth", &self.mouth)?;
        require_finite("target", &self.target)?;
        require_finite("flight", &self.flight)?;
        require_finite("canopies", &self.canopies)?;
        require_finite("stowed", &self.stowed)?;
        require_finite("energy", &self.energy)?;
        let mut text = serde_json::to_string_pretty(self).expect("string keys and plain data");
        text.push('\n');
        Ok(text)
    }

    /// Writes the summary to `path`.
    ///
    /// # Errors
    /// [`ResultError::NotFinite`], or [`ResultError::Write`].
    pub fn write(&self, path: &Path) -> Result<(), ResultError> {
        fs::write(path, self.to_json()?).map_err(ResultError::write(path))
    }

    /// Reads a summary from `path`.
    ///
    /// # Errors
    /// [`ResultError::Read`], or [`ResultError::Json`] with line, column and key.
    pub fn read(path: &Path) -> Result<Self, ResultError> {
        json::read(path)
    }
}

/// A section that the file lacks: every key has its default.
fn missing_section<T: DeserializeOwned>() -> T {
    serde_json::from_str("{}").expect("every key has a default")
}

/// A number that the file lacks, where 0 would be mistaken for a value.
fn unknown() -> f64 {
    f64::NAN
}

fn number_or_unknown<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or_else(unknown))
}

/// An older file without the key is that of a finished run.
fn finished_by_default() -> bool {
    true
}

/// Requires that `value` reads back equal. serde_json writes a number that is not finite as `null`: that is an error
/// when read as a number, and `None`, hence unequal, when read as an optional number.
fn require_finite<T>(section: &'static str, value: &T) -> Result<(), ResultError>
where
    T: Serialize + for<'text> Deserialize<'text> + PartialEq,
{
    let read_back = serde_json::to_value(value).and_then(serde_json::from_value::<T>);
    match read_back {
        Ok(equal) if equal == *value => Ok(()),
        _ => Err(ResultError::NotFinite { section }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The keys that users' scripts rely on.
    const CONTRACT: &str = r#"{
      "title": "", "netcast": "0.1.0", "wall_time_s": 0.0, "finished": true,
      "model":   {"nodes": 0, "segments": 0, "rope_length_m": 0.0, "web_mass_kg": 0.0, "tractor_mass_kg": 0.0},
      "step":    {"dt_s": 0.0, "count": 0, "limited_by": "segment 12 of traction rope 3"},
      "opening": {"area_max_m2": 0.0, "area_max_time_s": 0.0, "reference_area_m2": 0.0, "vector_area_max_m2": 0.0,
                  "effective_from_s": 0.0, "effective_to_s": 0.0, "effective_duration_s": 0.0,
                  "tractor_area_max_m2": 0.0, "tractor_area_max_time_s": 0.0},
      "points":  {"A": {"peak_speed_m_s": 0.0, "peak_speed_time_s": 0.0, "peak_travel_m": 0.0,
                        "peak_travel_time_s": 0.0, "peak_height_m": 0.0, "starts_s": 0.0}},
      "tension": {"max_n": 0.0, "max_time_s": 0.0, "max_where": "traction", "bottom_max_n": 0.0, "bottom_mean_n": 0.0,
                  "by_class": {"traction": {"max_n": 0.0, "max_time_s": 0.0, "margin": null}}},
      "posture": {"concave_from_s": 0.0, "concave_to_s": 0.0, "convex_from_s": 0.0},
      "energy":  {"initial_j": 0.0, "final_j": 0.0, "closure": 0.0, "closure_web": 0.0, "channels": {}}
    }"#;

    fn sample() -> Summary {
        let mut summary = Summary { title: "A \"net\"".into(), netcast: "0.1.0".into(), ..Summary::default() };
        summary.points.insert("A".into(), Some(PointExtremes::default()));
        summary.tension.by_class.insert("traction".into(), ClassTension { max_n: 0.1 + 0.2, ..Default::default() });
        summary
    }

    fn assert_keys(expected: &serde_json::Value, found: &serde_json::Value, path: &str) {
        let serde_json::Value::Object(expected) = expected else { return };
        let found = found.as_object().unwrap_or_else(|| panic!("{path} is no object"));
        let common: Vec<&String> = found.keys().filter(|key| expected.contains_key(*key)).collect();
        assert_eq!(common, expected.keys().collect::<Vec<_>>(), "keys of {path}");
        for (key, value) in expected {
            assert_keys(value, &found[key], &format!("{path}.{key}"));
        }
    }

    #[test]
    fn every_promised_key_is_present_and_in_order_even_when_null() {
        let expected = serde_json::from_str(CONTRACT).unwrap();
        let found = serde_json::from_str(&sample().to_json().unwrap()).unwrap();
        assert_keys(&expected, &found, "summary");
    }

    #[test]
    fn numbers_read_back_to_the_last_bit_in_their_shortest_form() {
        let text = sample().to_json().unwrap();
        assert!(text.contains("0.30000000000000004"));
        assert_eq!(serde_json::from_str::<Summary>(&text).unwrap(), sample());
    }

    #[test]
    fn a_number_that_is_not_finite_is_refused_and_its_section_named() {
        let mut required = sample();
        required.energy.closure = f64::INFINITY;
        assert!(matches!(required.to_json(), Err(ResultError::NotFinite { section: "energy" })));

        let mut optional = sample();
        optional.opening.area_max_m2 = Some(f64::NAN);
        assert!(matches!(optional.to_json(), Err(ResultError::NotFinite { section: "opening" })));

        let mut nested = sample();
        nested.points.insert("B".into(), Some(PointExtremes { starts_s: Some(f64::NAN), ..Default::default() }));
        assert!(matches!(nested.to_json(), Err(ResultError::NotFinite { section: "points" })));
    }
}

//! `summary.json`: the run in a page of numbers.
//!
//! Fields stand in the order of the file and carry its names. `None` is written as `null`: the scenario has no such
//! thing (no outline, no tractor, nothing launched), or it never happened. A number that is not finite is refused,
//! since JSON would turn it into the same `null`.
//!
//! A file of another version reads too: keys that it lacks have their defaults, keys that it has beside are passed over.

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
pub use flight::{AirMet, Flight, PointExtremes};
pub use launch::{Departure, Departures, Equilibrium, Recoil, StowedState};
pub use opening::{Mouth, Opening, Posture, TargetCoverage};
pub use ropes::{BrokenSegment, ClassTension, RopeUse, SheetStress, Tension};

/// The run in numbers; SI throughout.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Summary {
    /// The scenario's title.
    pub title: String,
    /// Version of netcast that ran it.
    pub netcast: String,
    /// Time the computation took on the clock, s. The one number here that differs between two equal runs. Not a number
    /// where it is not known.
    #[serde(default = "unknown", deserialize_with = "number_or_unknown")]
    pub wall_time_s: f64,
    /// Whether the run reached its end.
    #[serde(default = "yes")]
    pub finished: bool,
    /// Size and mass of what was simulated.
    pub model: ModelSize,
    /// The time step.
    #[serde(default = "unread")]
    pub step: StepSize,
    /// How well forces are in balance; none where no equilibrium was asked for.
    #[serde(rename = "static")]
    pub statics: Option<Equilibrium>,
    /// How the tractors were launched; none where nothing is.
    pub launch: Option<Departures>,
    /// What the net flew through; none where there was no air.
    pub air: Option<AirMet>,
    /// How far and how long the web opened.
    pub opening: Opening,
    /// Extremes of each feature point, and of `tractor`, `corner` and `centre`; `None` where the web has no such point.
    pub points: BTreeMap<String, Option<PointExtremes>>,
    /// Rope tension.
    #[serde(default = "unread")]
    pub tension: Tension,
    /// The segments that broke, in order.
    pub breaks: Vec<BrokenSegment>,
    /// Whether the middle trails or leads.
    pub posture: Posture,
    /// How the mouth stands.
    pub mouth: Mouth,
    /// How much of the target the web covers; none where no target is stated.
    pub target: Option<TargetCoverage>,
    /// How long the web hangs about its apex.
    pub flight: Flight,
    /// What sheets bear; none where canopies are no sheets.
    pub canopies: Option<SheetStress>,
    /// The state at the start.
    pub stowed: StowedState,
    /// The energy ledger and how well it closes.
    #[serde(default = "unread")]
    pub energy: EnergyBalance,
    /// What the reader should know before trusting the numbers.
    pub warnings: Vec<String>,
}

impl Summary {
    /// Rows of the table of quantities for what stands in no section. `title`, `netcast`, `finished` and `warnings` say
    /// which run it is and how it ended, and are no quantities.
    pub(crate) const QUANTITIES: &'static [Quantity] = &[Quantity::new(
        "",
        "wall_time_s",
        "Computed in",
        Dimension::Duration,
        "Time that the computation took on the clock; differs between two equal runs.",
    )];

    /// The summary as JSON text, with a newline at its end. Decimals are the shortest that read back equal.
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
        require_finite("points", &self.points)?;
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

/// What stands for a section that a file does not have: each of its keys is missing.
fn unread<T: DeserializeOwned>() -> T {
    serde_json::from_str("{}").expect("every key has a default")
}

/// What stands for a number that a file does not have, where 0 would say something.
fn unknown() -> f64 {
    f64::NAN
}

fn number_or_unknown<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Ok(Option::deserialize(deserializer)?.unwrap_or_else(unknown))
}

fn yes() -> bool {
    true
}

/// Holds `value` to what reading it back gives: serde_json writes a number that is not finite as `null`, which is an
/// error for a number and `None`, so unequal, for an optional one.
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

    /// The keys a user's script relies on, from the contract.
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
    fn every_key_of_the_contract_is_present_and_in_order_even_when_null() {
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

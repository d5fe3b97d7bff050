//! `summary.json`: the run in a page of numbers.
//!
//! Fields stand in the order of the file and carry its names. `None` is written as `null`: the scenario has no such
//! thing (no outline, no tractor, nothing launched), or it never happened. A number that is not finite is refused,
//! since JSON would turn it into the same `null`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::ResultError;

/// The run in numbers; SI throughout.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Summary {
    /// The scenario's title.
    pub title: String,
    /// Version of netcast that ran it.
    pub netcast: String,
    /// Time the computation took on the clock, s. The one number here that differs between two equal runs.
    pub wall_time_s: f64,
    /// Whether the run reached its end.
    pub finished: bool,
    /// Size and mass of what was simulated.
    pub model: Model,
    /// The time step.
    pub step: Step,
    /// How well forces are in balance; none where no equilibrium was asked for.
    #[serde(rename = "static")]
    pub statics: Option<Statics>,
    /// How the tractors were launched; none where nothing is.
    pub launch: Option<Launch>,
    /// What the net flew through; none where there was no air.
    pub air: Option<Air>,
    /// How far and how long the web opened.
    pub opening: Opening,
    /// Extremes of each feature point, and of `tractor`, `corner` and `centre`; `None` where the web has no such point.
    pub points: BTreeMap<String, Option<PointExtremes>>,
    /// Rope tension.
    pub tension: Tension,
    /// The segments that broke, in order.
    pub breaks: Vec<Break>,
    /// Whether the middle trails or leads.
    pub posture: Posture,
    /// How the mouth stands.
    pub mouth: Mouth,
    /// How much of the target the web covers; none where no target is stated.
    pub target: Option<Target>,
    /// How long the web hangs about its apex.
    pub flight: Flight,
    /// What sheets bear; none where canopies are no sheets.
    pub canopies: Option<Cloth>,
    /// The state at the start.
    pub stowed: Stowed,
    /// The energy ledger and how well it closes.
    pub energy: Energy,
    /// What the reader should know before trusting the numbers.
    pub warnings: Vec<String>,
}

/// Size and mass of the model.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Model {
    /// Number of nodes.
    pub nodes: usize,
    /// Number of rope segments.
    pub segments: usize,
    /// Length of all ropes at rest, m.
    pub rope_length_m: f64,
    /// Mass of the web with its traction ropes, canopies and payloads, without tractors, kg.
    pub web_mass_kg: f64,
    /// Mass of all tractors, kg.
    pub tractor_mass_kg: Option<f64>,
}

/// The time step and what holds it down.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Step {
    /// Step size, s.
    pub dt_s: f64,
    /// Steps taken.
    pub count: u64,
    /// The stiffest or lightest place of the model, in words.
    pub limited_by: Option<String>,
    /// What would allow a larger one, in words.
    pub lifted_by: Option<String>,
}

/// How the tractors were launched, as meant and as chance had it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Launch {
    /// Angular speed of all that is launched at the start, rad/s.
    pub spin_rad_s: f64,
    /// Each tractor's departure, by the number of its corner.
    pub tractors: BTreeMap<u32, Departure>,
    /// What the tubes push back with.
    pub recoil: Option<Recoil>,
}

/// The medium and the wind.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Air {
    /// Density at the muzzle, kg/m³.
    pub density_kg_m3: f64,
    /// Dynamic viscosity, Pa s.
    pub viscosity_pa_s: f64,
    /// Wind at the muzzle at the start, x, y and z in the world frame, m/s.
    pub wind_m_s: [f64; 3],
    /// The largest wind that adds to the mean at any time, m/s: gusts, turbulence; the measured wind.
    pub wind_change_max_m_s: f64,
    /// The solidity by which ropes drag as a screen; none where each drags as if alone.
    pub solidity: Option<f64>,
}

/// How a tractor left: its muzzle where it has a tube, else where it was stowed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Departure {
    /// When, s; none where it never did.
    pub time_s: Option<f64>,
    /// Its speed then, m/s.
    pub speed_m_s: Option<f64>,
    /// Angle between its way and the launch axis, rad.
    pub angle_rad: f64,
}

/// The push of all tubes together on what carries them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Recoil {
    /// Largest force, N.
    pub peak_n: f64,
    /// When it occurred, s.
    pub peak_time_s: f64,
    /// Size of its impulse, N s.
    pub impulse_n_s: f64,
    /// Its impulse against the launch axis, N s.
    pub axial_impulse_n_s: f64,
}

/// The equilibrium, alone or at the start of a run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Statics {
    /// The largest force out of balance on a node that is free to move, N.
    pub residual_n: Option<f64>,
    /// The same over the largest tension or load.
    pub residual_relative: Option<f64>,
    /// The node on which it acts, in words.
    pub residual_where: Option<String>,
    /// The relative residual that was asked for.
    pub tolerance: f64,
    /// Iterations that it took.
    pub iterations: u64,
    /// Whether a run in time begins from it.
    pub then_run: bool,
}

/// How far the web opened, and for how long.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Opening {
    /// Largest outline area normal to the launch axis, m².
    pub area_max_m2: Option<f64>,
    /// When it occurred, s.
    pub area_max_time_s: Option<f64>,
    /// The outline area of the web as designed, flat, m².
    pub reference_area_m2: Option<f64>,
    /// Largest magnitude of the outline's vector area, m².
    pub vector_area_max_m2: Option<f64>,
    /// Start of the longest spell with at least 80 % of the reference area, s.
    pub effective_from_s: Option<f64>,
    /// End of that spell, s.
    pub effective_to_s: Option<f64>,
    /// All the time with at least 80 % of the reference area, s.
    pub effective_duration_s: Option<f64>,
    /// Largest area of the tractors' polygon normal to the launch axis, m².
    pub tractor_area_max_m2: Option<f64>,
    /// When it occurred, s.
    pub tractor_area_max_time_s: Option<f64>,
    /// Largest area of the silhouette along the launch axis at any record time, m².
    pub shadow_area_max_m2: Option<f64>,
    /// When it occurred, s.
    pub shadow_area_max_time_s: Option<f64>,
}

/// How the mouth stands, at record times.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Mouth {
    /// Angle between the mouth and the launch axis when the outline area is largest, rad.
    pub tilt_at_area_max_rad: Option<f64>,
    /// The largest of it while at least 80 % are open, rad.
    pub tilt_max_open_rad: Option<f64>,
    /// How unevenly the corners stand when the outline area is largest.
    pub asymmetry_at_area_max: Option<f64>,
    /// The largest of it while at least 80 % are open.
    pub asymmetry_max_open: Option<f64>,
}

/// How much of a target of stated size the web covers, at record times.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Target {
    /// Its diameter, m.
    pub diameter_m: f64,
    /// Largest share of it that is covered.
    pub coverage_max: Option<f64>,
    /// When it occurred, s.
    pub coverage_max_time_s: Option<f64>,
    /// Start of the longest spell with at least 99 % of it covered, s.
    pub covered_from_s: Option<f64>,
    /// End of that spell, s.
    pub covered_to_s: Option<f64>,
    /// All the time with at least 99 % of it covered, s.
    pub covered_duration_s: Option<f64>,
}

/// How long the web hangs about its apex, by its centre of mass at record times.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Flight {
    /// Greatest height of the web's centre of mass above the muzzle, m.
    pub apex_height_m: Option<f64>,
    /// When it occurred, s.
    pub apex_time_s: Option<f64>,
    /// Start of the longest spell with at least 95 % of that height, s.
    pub hang_from_s: Option<f64>,
    /// End of that spell, s.
    pub hang_to_s: Option<f64>,
    /// Its length, s.
    pub hang_time_s: Option<f64>,
    /// Whether it was cut off by the end of the run.
    pub still_up: Option<bool>,
    /// How far the centre of mass is from where it started, over the ground, at the last record, m.
    pub drift_m: Option<f64>,
    /// In which direction, anticlockwise from x, rad; none where it does not drift.
    pub drift_azimuth_rad: Option<f64>,
    /// The first record after the apex at which anything touches the ground that had left it, s; none without a ground.
    pub touches_down_s: Option<f64>,
    /// From which record on it stays within 5 cm of where it ends, on the ground, s.
    pub lies_from_s: Option<f64>,
}

/// What the sheets of canopies bear, at every step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Cloth {
    /// Largest principal stress (second Piola-Kirchhoff) of any triangle, Pa.
    pub max_principal_stress_pa: f64,
    /// When it occurred, s.
    pub max_time_s: Option<f64>,
    /// The canopy that bore it.
    pub max_where: Option<String>,
    /// What the cloth bears, Pa, where it is given.
    pub strength_pa: Option<f64>,
    /// Strength over largest stress.
    pub margin: Option<f64>,
}

/// The state at the start, looked over.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Stowed {
    /// Length over rest length less 1 of the member that is stretched most: negative where all are slack.
    pub longest_stretch: Option<f64>,
    /// Which member that is.
    pub longest_stretch_where: Option<String>,
    /// Number of members that are stretched.
    pub stretched: usize,
    /// Elastic energy, J.
    pub stored_energy_j: f64,
    /// Largest distance of a node from the launch axis, m.
    pub packed_radius_m: f64,
    /// From the lowest node to the highest along the launch axis, m.
    pub packed_height_m: f64,
    /// Mass of the web over the volume of the smallest cylinder about the launch axis that holds it, kg/m³; tractors and
    /// traction ropes are not counted.
    pub density_kg_m3: Option<f64>,
    /// Share of that cylinder that ropes, canopies and payloads fill.
    pub solid_fraction: Option<f64>,
    /// Least distance between centre lines of ropes that share no knot, m.
    pub closest_approach_m: Option<f64>,
    /// Which two segments come so near.
    pub closest_approach_where: Option<String>,
    /// Where, in the world, m.
    pub closest_approach_at_m: Option<[f64; 3]>,
    /// Pairs of segments of such ropes nearer than a diameter.
    pub nearer_than_a_diameter: Option<usize>,
}

/// Extremes of one point over every step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct PointExtremes {
    /// Highest speed, m/s.
    pub peak_speed_m_s: Option<f64>,
    /// When it occurred, s.
    pub peak_speed_time_s: Option<f64>,
    /// Farthest displacement along the launch axis, m.
    pub peak_travel_m: Option<f64>,
    /// When it occurred, s.
    pub peak_travel_time_s: Option<f64>,
    /// Greatest height above the muzzle, m.
    pub peak_height_m: Option<f64>,
    /// When the point first reached 1 % of its peak travel, s.
    pub starts_s: Option<f64>,
}

/// Rope tension, per rope, over every step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Tension {
    /// Highest tension, N.
    pub max_n: f64,
    /// When it occurred, s.
    pub max_time_s: Option<f64>,
    /// The link class of the rope that bore it.
    pub max_where: Option<String>,
    /// Highest tension in the segments that meet point B, N.
    pub bottom_max_n: Option<f64>,
    /// Their mean from B's start to the time of largest area, N.
    pub bottom_mean_n: Option<f64>,
    /// Number of segments of rope that broke; ties and stitches, which are made to, do not count.
    #[serde(default)]
    pub broken_segments: usize,
    /// When the first of them broke, s.
    #[serde(default)]
    pub first_break_time_s: Option<f64>,
    /// The extremes of each link class.
    pub by_class: BTreeMap<String, ClassTension>,
    /// What each kind of rope bears, by its name in the scenario.
    pub by_rope: BTreeMap<String, RopeUse>,
}

/// What one kind of rope bears. The largest tension is that of any step, smallest and mean are over all its segments at
/// all record times.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RopeUse {
    /// Smallest tension, N: 0 where any segment of it was slack at any time.
    pub min_n: Option<f64>,
    /// Mean tension, N.
    pub mean_n: Option<f64>,
    /// Highest tension, N.
    pub max_n: f64,
    /// When it occurred, s.
    pub max_time_s: Option<f64>,
    /// The link class where it occurred.
    pub max_where: Option<String>,
    /// Its breaking load, N, where it is given.
    pub strength_n: Option<f64>,
    /// The share of that which knots take, where it is given.
    pub knot_reduction: Option<f64>,
    /// Highest tension over the strength that knots leave.
    pub utilisation: Option<f64>,
    /// The inverse of it.
    pub margin: Option<f64>,
}

/// Highest tension in one link class.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ClassTension {
    /// Highest tension, N.
    pub max_n: f64,
    /// When it occurred, s.
    pub max_time_s: Option<f64>,
    /// Strength over highest tension, where a strength is given.
    pub margin: Option<f64>,
}

/// A segment that broke.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Break {
    /// When, s.
    pub time_s: f64,
    /// Which segment, in words.
    #[serde(rename = "where")]
    pub place: String,
    /// Its number in the fields.
    pub segment: usize,
    /// Its link class.
    pub class: String,
    /// Its tension then, N.
    pub tension_n: f64,
    /// Whether it was made to: a break tie, a tear stitch.
    #[serde(default)]
    pub released: bool,
}

/// When the middle trails the outline and when it leads.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Posture {
    /// Start of the longest spell in which the middle trails, s.
    pub concave_from_s: Option<f64>,
    /// End of that spell, s.
    pub concave_to_s: Option<f64>,
    /// The middle first leads, s.
    pub convex_from_s: Option<f64>,
}

/// The energy ledger at the end of the run.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Energy {
    /// Total at the start, J.
    pub initial_j: f64,
    /// Total at the end, J.
    pub final_j: f64,
    /// |residual| over the largest total energy of the run.
    pub closure: f64,
    /// |residual| over the largest elastic and kinetic energy of everything but the tractors.
    pub closure_web: Option<f64>,
    /// Each channel, integrated in its own right, J.
    pub channels: BTreeMap<String, f64>,
    /// What the channels leave unexplained at the end, J.
    pub residual_j: f64,
    /// The largest of it at any record time, J; what `closure` and `closure_web` go by.
    pub largest_residual_j: f64,
    /// The closure that the run was asked to reach.
    pub tolerance: f64,
    /// The closure of the web that it was asked to reach.
    pub tolerance_web: f64,
}

impl Summary {
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
    /// [`ResultError::Read`], or [`ResultError::Json`] with line and column.
    pub fn read(path: &Path) -> Result<Self, ResultError> {
        let text = fs::read_to_string(path).map_err(ResultError::read(path))?;
        serde_json::from_str(&text).map_err(ResultError::json(path))
    }
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

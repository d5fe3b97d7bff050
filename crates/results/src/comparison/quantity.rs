//! The quantities of a summary: what they are called, their units, and which of two values a net designer prefers.
//!
//! What the table in this file does not list is compared all the same, under a label and a unit read off its key.

use serde::Serialize;
use serde_json::Value;

/// What a net designer wants of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Better {
    /// The less, the better.
    Lower,
    /// The more, the better.
    Higher,
}

use Better::{Higher, Lower};

/// A quantity of `summary.json`.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Its path there, with dots: `tension.by_class.ring.max_n`.
    pub path: String,
    /// In a designer's words.
    pub label: String,
    /// Its unit, as a scenario writes it; empty for a plain number or a text.
    pub unit: &'static str,
    /// What it is about.
    pub group: String,
    /// Whether it is one of those that a designer looks for first.
    pub headline: bool,
    /// What is wanted of it, where either is better as such.
    pub better: Option<Better>,
    /// Whether the same inputs give the same value.
    pub reproducible: bool,
}

/// Keys of the summary that are no quantities: they say which run it is and how it ended.
const ABOUT_THE_RUN: [&str; 4] = ["title", "netcast", "finished", "warnings"];

/// Sections of the summary in the order of the table, with their titles; others stand before the last three.
const GROUPS: [(&str, &str); 12] = [
    ("opening", "Opening"),
    ("mouth", "Mouth"),
    ("target", "Target"),
    ("flight", "Flight"),
    ("tension", "Tension"),
    ("posture", "Posture"),
    ("points", "Feature points"),
    ("model", "Size and mass"),
    ("stowed", "Stowed"),
    ("energy", "Energy"),
    ("step", "Computation"),
    ("wall_time_s", "Computation"),
];

/// Place among [`GROUPS`] of a section that is not there.
const OTHERS: usize = 9;

/// Quantities by path, `*` for any key, which stands in the label for `{}`: what they are called, what is wanted of
/// them, and whether a designer looks for them first.
#[rustfmt::skip]
const NAMED: [(&str, &str, Option<Better>, bool); 86] = [
    ("opening.area_max_time_s", "Opens fully at", Some(Lower), true),
    ("opening.area_max_m2", "Largest area inside the outline", Some(Higher), true),
    ("opening.reference_area_m2", "Area of the flat web", None, false),
    ("opening.vector_area_max_m2", "Largest vector area of the outline", Some(Higher), false),
    ("opening.effective_from_s", "At least 80 % open from", Some(Lower), false),
    ("opening.effective_to_s", "At least 80 % open until", None, false),
    ("opening.effective_duration_s", "At least 80 % open for", Some(Higher), true),
    ("opening.tractor_area_max_m2", "Largest area of the tractors' polygon", None, true),
    ("opening.tractor_area_max_time_s", "Tractors' polygon is largest at", None, false),
    ("opening.shadow_area_max_m2", "Largest silhouette", Some(Higher), false),
    ("opening.shadow_area_max_time_s", "Silhouette is largest at", None, false),
    ("mouth.tilt_at_area_max_rad", "Tilt of the mouth when widest", Some(Lower), false),
    ("mouth.tilt_max_open_rad", "Largest tilt while open", Some(Lower), false),
    ("mouth.asymmetry_at_area_max", "Asymmetry of the mouth when widest", Some(Lower), false),
    ("mouth.asymmetry_max_open", "Largest asymmetry while open", Some(Lower), false),
    ("target.diameter_m", "Diameter of the target", None, false),
    ("target.coverage_max", "Largest share of the target covered", Some(Higher), true),
    ("target.coverage_max_time_s", "Covers most of the target at", None, false),
    ("target.covered_from_s", "Covers the target from", Some(Lower), false),
    ("target.covered_to_s", "Covers the target until", None, false),
    ("target.covered_duration_s", "Covers the target for", Some(Higher), true),
    ("flight.apex_height_m", "Greatest height of the web's centre of mass", Some(Higher), false),
    ("flight.apex_time_s", "Reached at", None, false),
    ("flight.hang_from_s", "Hangs about its apex from", None, false),
    ("flight.hang_to_s", "Hangs about its apex until", None, false),
    ("flight.hang_time_s", "Hangs about its apex for", Some(Higher), true),
    ("flight.still_up", "Still hangs at the end of the run", None, false),
    ("flight.drift_m", "Drift over the ground by the end of the run", None, false),
    ("flight.drift_azimuth_rad", "Direction of the drift", None, false),
    ("flight.touches_down_s", "Touches the ground at", None, false),
    ("flight.lies_from_s", "Lies still from", None, false),
    ("points.tractor.peak_travel_m", "Travel of the tractors", Some(Higher), true),
    ("points.B.peak_travel_m", "Travel of point B", Some(Higher), true),
    ("points.centre.peak_travel_m", "Travel of the centre", Some(Higher), false),
    ("points.B.peak_speed_m_s", "Peak speed of point B", None, true),
    ("points.*.peak_speed_m_s", "Peak speed of {}", None, false),
    ("points.*.peak_speed_time_s", "Peak speed of {} at", None, false),
    ("points.*.peak_travel_m", "Travel of {}", None, false),
    ("points.*.peak_travel_time_s", "Travel of {} is largest at", None, false),
    ("points.*.peak_height_m", "Greatest height of {}", None, false),
    ("points.*.starts_s", "Start of {}", None, false),
    ("tension.max_n", "Highest tension", Some(Lower), true),
    ("tension.max_time_s", "Highest tension at", None, false),
    ("tension.max_where", "Highest tension in", None, true),
    ("tension.bottom_max_n", "Highest tension in the bottom ropes", Some(Lower), true),
    ("tension.bottom_mean_n", "Mean tension in the bottom ropes", Some(Lower), false),
    ("tension.broken_segments", "Segments of rope that break", Some(Lower), true),
    ("tension.first_break_time_s", "First break of a rope at", Some(Higher), false),
    ("tension.by_class.*.max_n", "Highest tension, {}", Some(Lower), false),
    ("tension.by_class.*.max_time_s", "Highest tension, {}, at", None, false),
    ("tension.by_class.*.margin", "Margin, {}", Some(Higher), false),
    ("tension.by_rope.*.min_n", "Smallest tension, rope `{}`", None, false),
    ("tension.by_rope.*.mean_n", "Mean tension, rope `{}`", Some(Lower), false),
    ("tension.by_rope.*.max_n", "Highest tension, rope `{}`", Some(Lower), false),
    ("tension.by_rope.*.max_time_s", "Highest tension, rope `{}`, at", None, false),
    ("tension.by_rope.*.max_where", "Highest tension, rope `{}`, in", None, false),
    ("tension.by_rope.*.strength_n", "Strength, rope `{}`", None, false),
    ("tension.by_rope.*.knot_reduction", "Lost to knots, rope `{}`", None, false),
    ("tension.by_rope.*.utilisation", "Utilisation, rope `{}`", Some(Lower), true),
    ("tension.by_rope.*.margin", "Margin, rope `{}`", Some(Higher), false),
    ("posture.concave_from_s", "The middle trails from", None, false),
    ("posture.concave_to_s", "The middle trails until", None, true),
    ("posture.convex_from_s", "The middle leads from", None, false),
    ("model.nodes", "Nodes", None, false),
    ("model.segments", "Segments", None, false),
    ("model.rope_length_m", "Rope in all", Some(Lower), true),
    ("model.web_mass_kg", "Mass of the web", Some(Lower), true),
    ("model.tractor_mass_kg", "Mass of the tractors", Some(Lower), true),
    ("stowed.longest_stretch", "Largest strain when packed", None, false),
    ("stowed.longest_stretch_where", "Largest strain when packed, in", None, false),
    ("stowed.packed_radius_m", "Packed radius", Some(Lower), false),
    ("stowed.packed_height_m", "Packed height", Some(Lower), false),
    ("stowed.density_kg_m3", "Packed density", Some(Higher), false),
    ("stowed.solid_fraction", "Solid share when packed", Some(Higher), false),
    ("stowed.closest_approach_m", "Closest approach when packed", Some(Higher), false),
    ("stowed.closest_approach_where", "Closest approach when packed, of", None, false),
    ("stowed.nearer_than_a_diameter", "Pairs nearer than a diameter when packed", Some(Lower), false),
    ("energy.initial_j", "Total energy at the start", None, false),
    ("energy.final_j", "Total energy at the end", None, false),
    ("energy.closure", "Energy balance closes to", None, false),
    ("energy.closure_web", "Energy balance of the web closes to", None, false),
    ("energy.channels.*", "Energy at the end, {}", None, false),
    ("step.dt_s", "Time step", None, false),
    ("step.count", "Steps", None, false),
    ("step.limited_by", "Time step limited by", None, false),
    ("wall_time_s", "Computed in", None, false),
];

/// Units by the end of a key; the longest that fits counts.
const UNITS: [(&str, &str); 11] = [
    ("_kg_m3", "kg/m^3"),
    ("_m_s2", "m/s^2"),
    ("_m_s", "m/s"),
    ("_m2", "m^2"),
    ("_kg", "kg"),
    ("_deg", "deg"),
    ("_rad", "rad"),
    ("_m", "m"),
    ("_n", "N"),
    ("_j", "J"),
    ("_s", "s"),
];

/// What is wanted of a number that [`NAMED`] does not list, by what its key says.
const WANTED: [(&str, Better); 5] =
    [("margin", Higher), ("coverage", Higher), ("utilisation", Lower), ("tilt", Lower), ("asymmetry", Lower)];

impl Quantity {
    /// The quantity at a path of the summary.
    pub fn at(path: &str) -> Self {
        let keys = split(path);
        let section = &keys[0];
        let last = &keys[keys.len() - 1];
        let suffix = UNITS.iter().find(|(suffix, _)| last.ends_with(suffix));
        let named = NAMED.iter().find_map(|named| Some((named, matched(named.0, &keys)?)));
        let group = GROUPS.iter().find(|(known, _)| known == section);
        let (label, better, headline) = match named {
            Some((&(_, label, better, headline), any)) => (label.replace("{}", &spoken(any)), better, headline),
            None => {
                let stem = suffix.and_then(|(suffix, _)| last.strip_suffix(suffix)).unwrap_or(last);
                let mut words: Vec<&str> = keys[1..].iter().map(String::as_str).collect();
                words.pop();
                words.push(stem);
                let wanted = WANTED.iter().find(|(word, _)| last.contains(word)).map(|(_, better)| *better);
                (words.join(", ").replace('_', " "), wanted, false)
            }
        };
        Self {
            path: path.to_owned(),
            label,
            unit: if path.starts_with("energy.channels.") { "J" } else { suffix.map_or("", |(_, unit)| unit) },
            group: group.map_or_else(|| capitalised(section), |(_, title)| (*title).to_owned()),
            headline,
            better,
            reproducible: path != "wall_time_s",
        }
    }

    /// Its group's place in the table.
    pub(super) fn rank(&self) -> (usize, String) {
        let section = split(&self.path).swap_remove(0);
        match GROUPS.iter().position(|(known, _)| *known == section) {
            Some(place) => (2 * place + usize::from(place >= OTHERS), String::new()),
            // sections that nobody foresaw stay together
            None => (2 * OTHERS, section),
        }
    }
}

/// All numbers, texts and truths of a summary with their paths, in its order; null where the run has no such thing.
pub fn leaves(summary: &Value) -> Vec<(String, &Value)> {
    let mut leaves = Vec::new();
    for (key, value) in summary.as_object().into_iter().flatten() {
        if !ABOUT_THE_RUN.contains(&&key[..]) {
            collect(quoted(key), value, &mut leaves);
        }
    }
    leaves
}

fn collect<'v>(path: String, value: &'v Value, leaves: &mut Vec<(String, &'v Value)>) {
    match value {
        Value::Object(entries) => {
            entries.iter().for_each(|(key, value)| collect(format!("{path}.{}", quoted(key)), value, leaves));
        }
        // a list has no cell in a table
        Value::Array(_) => {}
        leaf => leaves.push((path, leaf)),
    }
}

/// A key as it stands in a path, which a key with a dot must not break.
fn quoted(key: &str) -> String {
    let bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
    if bare { key.to_owned() } else { format!("{key:?}") }
}

/// The keys of a path, without their quotes. At least one.
fn split(path: &str) -> Vec<String> {
    let (mut keys, mut key, mut within) = (Vec::new(), String::new(), false);
    let mut characters = path.chars();
    while let Some(character) = characters.next() {
        match character {
            '"' => within = !within,
            '\\' if within => key.extend(characters.next()),
            '.' if !within => keys.push(std::mem::take(&mut key)),
            other => key.push(other),
        }
    }
    keys.push(key);
    keys
}

/// The key that stands for `*` where the pattern fits; empty where it has none.
fn matched<'k>(pattern: &str, keys: &'k [String]) -> Option<&'k str> {
    let parts: Vec<&str> = pattern.split('.').collect();
    let fits = parts.len() == keys.len() && parts.iter().zip(keys).all(|(part, key)| *part == "*" || part == key);
    fits.then(|| parts.iter().position(|part| *part == "*").map_or("", |place| &keys[place][..]))
}

/// A point, a class or a channel as one speaks of it.
fn spoken(name: &str) -> String {
    match name {
        "tractor" => "the tractors".into(),
        "corner" => "the corners".into(),
        "centre" => "the centre".into(),
        // a feature point
        letter if letter.len() == 1 => format!("point {letter}"),
        other => other.replace('_', " "),
    }
}

fn capitalised(key: &str) -> String {
    let mut characters = key.chars();
    let first = characters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(characters).collect::<String>().replace('_', " ")
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::Summary;
    use crate::summary::{ClassTension, PointExtremes, RopeUse, Target};

    #[test]
    fn words_and_units_follow_from_the_path() {
        let told = |path: &str| {
            let quantity = Quantity::at(path);
            (quantity.label, quantity.unit, quantity.better)
        };
        assert_eq!(told("opening.area_max_time_s"), ("Opens fully at".into(), "s", Some(Lower)));
        assert_eq!(told("points.B.peak_speed_m_s"), ("Peak speed of point B".into(), "m/s", None));
        assert_eq!(told("points.tractor.starts_s"), ("Start of the tractors".into(), "s", None));
        assert_eq!(
            told("tension.by_class.rope_hexagon.max_n"),
            ("Highest tension, rope hexagon".into(), "N", Some(Lower))
        );
        assert_eq!(told("energy.channels.mass_damping"), ("Energy at the end, mass damping".into(), "J", None));
        assert_eq!(told("points.\"knot.3\".peak_travel_m"), ("Travel of knot.3".into(), "m", None));
        // nobody foresaw these
        assert_eq!(told("capture.of_target.coverage_mean"), ("of target, coverage mean".into(), "", Some(Higher)));
        assert_eq!(told("capture.closing_speed_m_s"), ("closing speed".into(), "m/s", None));
    }

    #[test]
    fn leaves_are_all_but_lists_and_what_names_the_run() {
        let summary = json!({
            "title": "x", "finished": true, "warnings": ["y"], "wall_time_s": 2.0,
            "points": {"A": null, "knot.3": {"starts_s": 0.5}}, "list": [1, 2], "flight": {"still_up": false}
        });
        let paths: Vec<String> = leaves(&summary).into_iter().map(|(path, _)| path).collect();
        assert_eq!(paths, ["wall_time_s", "points.A", "points.\"knot.3\".starts_s", "flight.still_up"]);
    }

    /// A summary with an entry in each of its tables.
    fn summary() -> Value {
        let mut summary = Summary { target: Some(Target::default()), ..Summary::default() };
        summary.points.insert("A".into(), Some(PointExtremes::default()));
        summary.tension.by_class.insert("ring".into(), ClassTension::default());
        summary.tension.by_rope.insert("rope".into(), RopeUse::default());
        summary.energy.channels.insert("elastic".into(), 0.0);
        serde_json::to_value(summary).unwrap()
    }

    #[test]
    fn every_name_is_that_of_a_quantity_which_a_summary_has() {
        let summary = summary();
        let leaves = leaves(&summary);
        for (pattern, ..) in NAMED {
            // points are named by the scenario
            let pattern = ["points.B.", "points.tractor.", "points.centre."]
                .iter()
                .fold(pattern.to_owned(), |pattern, point| pattern.replace(point, "points.A."));
            let known = leaves.iter().any(|(path, _)| matched(&pattern, &split(path)).is_some());
            assert!(known, "no quantity is called {pattern}");
        }
    }

    #[test]
    fn paths_are_split_as_they_are_put_together() {
        for keys in [vec!["a", "b"], vec!["a.b", "c"], vec!["say \"x\"", "\\", "µ"]] {
            let path: Vec<String> = keys.iter().map(|key| quoted(key)).collect();
            assert_eq!(split(&path.join(".")), keys);
        }
    }

    #[test]
    fn groups_stand_in_the_order_of_a_designers_interest() {
        let mut paths = ["wall_time_s", "model.nodes", "wind.gust_m_s", "opening.area_max_m2", "tension.max_n"];
        paths.sort_by_key(|path| Quantity::at(path).rank());
        assert_eq!(paths, ["opening.area_max_m2", "tension.max_n", "model.nodes", "wind.gust_m_s", "wall_time_s"]);
    }
}

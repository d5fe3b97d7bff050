//! The whole table of quantities: the rows of all sections of the summary.

use serde_json::Value;

use crate::landmarks::Landmarks;
use crate::quantity::Quantity;
use crate::row::channels;
use crate::summary::{
    AirMet, ClassTension, Departure, Departures, EnergyBalance, Equilibrium, Flight, ModelSize, Mouth, Opening, Place,
    Places, PointExtremes, Posture, Reaction, Recoil, RopeUse, SheetStress, StepSize, StowedState, Summary,
    TargetCoverage, Tension,
};

/// A section of the summary, with its rows of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// Key in `summary.json`.
    pub key: &'static str,
    /// Title.
    pub title: &'static str,
    /// Rows of the table; if two fit a path, the first counts.
    pub rows: &'static [&'static [Quantity]],
}

/// The sections, in the order of a designer's interest.
pub const SECTIONS: [Section; 18] = [
    Section { key: "opening", title: "Opening", rows: &[Opening::QUANTITIES] },
    Section { key: "places", title: "Where it is", rows: &[Place::QUANTITIES] },
    Section { key: "mouth", title: "Mouth", rows: &[Mouth::QUANTITIES] },
    Section { key: "target", title: "Target", rows: &[TargetCoverage::QUANTITIES] },
    Section { key: "flight", title: "Flight", rows: &[Flight::QUANTITIES] },
    Section {
        key: "tension",
        title: "Tension",
        rows: &[Tension::QUANTITIES, ClassTension::QUANTITIES, RopeUse::QUANTITIES],
    },
    Section { key: "reactions", title: "Supports", rows: &[Reaction::QUANTITIES] },
    Section { key: "posture", title: "Posture", rows: &[Posture::QUANTITIES] },
    Section {
        key: "points",
        title: "Feature points",
        rows: &[PointExtremes::SINGLE_POINTS, PointExtremes::QUANTITIES],
    },
    Section { key: "model", title: "Size and mass", rows: &[ModelSize::QUANTITIES] },
    Section { key: "stowed", title: "Stowed", rows: &[StowedState::QUANTITIES] },
    Section { key: "air", title: "Air", rows: &[AirMet::QUANTITIES] },
    Section { key: "canopies", title: "Canopies", rows: &[SheetStress::QUANTITIES] },
    Section {
        key: "launch",
        title: "Launch",
        rows: &[Departures::QUANTITIES, Departure::QUANTITIES, Recoil::QUANTITIES],
    },
    Section { key: "static", title: "Equilibrium", rows: &[Equilibrium::QUANTITIES] },
    Section { key: "energy", title: "Energy", rows: &[EnergyBalance::QUANTITIES] },
    Section { key: "step", title: "Computation", rows: &[StepSize::QUANTITIES] },
    Section { key: "wall_time_s", title: "Computation", rows: &[Summary::QUANTITIES] },
];

/// Keys of the summary that are not quantities: they tell which run it is and how it ended.
const ABOUT_THE_RUN: [&str; 4] = ["title", "netcast", "finished", "warnings"];

impl Section {
    /// The rows of this section.
    pub fn quantities(&self) -> impl Iterator<Item = &'static Quantity> {
        self.rows.iter().copied().flatten()
    }
}

/// All rows of the table.
pub fn quantities() -> impl Iterator<Item = &'static Quantity> {
    SECTIONS.iter().flat_map(Section::quantities)
}

/// The row for a path of the summary, and the name at `*` in the path, empty for a row without `*`. None if no row fits.
pub fn quantity_at(path: &str) -> Option<(&'static Quantity, String)> {
    let keys = split(path);
    quantities().find_map(|quantity| Some((quantity, matched(&quantity.path(), &keys)?.to_owned())))
}

/// The paths that the summary of a design with these landmarks will have, each with its row of the table.
/// `has_section` tells by its key whether the summary has a section.
pub fn expected(landmarks: &Landmarks, has_section: impl Fn(&str) -> bool) -> Vec<(String, &'static Quantity)> {
    let names = |path: &str| -> Vec<String> {
        let points = landmarks.points.iter().map(|point| &point.name[..]);
        match path.split_once(".*").map_or("", |(map, _)| map) {
            "points" => points.chain(Landmarks::ALWAYS_NAMED).map(str::to_owned).collect(),
            "places" => Places::MOMENTS.map(str::to_owned).to_vec(),
            "reactions" => landmarks.supports.iter().map(|support| support.name.clone()).collect(),
            "tension.by_class" => landmarks.classes.iter().map(|class| class.name.clone()).collect(),
            "tension.by_rope" => landmarks.ropes.iter().map(|rope| rope.name.clone()).collect(),
            "launch.tractors" => (1..=landmarks.corners.len()).map(|corner| corner.to_string()).collect(),
            "energy.channels" => channels().map(str::to_owned).collect(),
            // a path without `*`
            _ => vec![String::new()],
        }
    };
    let of_section = |section: &Section| section.quantities().collect::<Vec<_>>();
    let rows = SECTIONS.iter().filter(|section| has_section(section.key)).flat_map(of_section);
    rows.flat_map(|quantity| {
        let path = quantity.path();
        let paths = names(&path).into_iter().map(move |name| path.replacen('*', &quoted(&name), 1));
        paths.map(move |path| (path, quantity)).collect::<Vec<_>>()
    })
    .collect()
}

/// The value of every quantity of a summary with its path, in the order of the summary; null if the run does not have
/// the quantity.
pub fn leaves(summary: &Value) -> Vec<(String, &Value)> {
    let mut leaves = Vec::new();
    for (key, value) in summary.as_object().into_iter().flatten() {
        if !ABOUT_THE_RUN.contains(&&key[..]) {
            collect(quoted(key), value, &mut leaves);
        }
    }
    leaves
}

/// Appends the leaves of `value`, which stands at `path`.
fn collect<'v>(path: String, value: &'v Value, leaves: &mut Vec<(String, &'v Value)>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                collect(format!("{path}.{}", quoted(key)), value, leaves);
            }
        }
        // a table has no cell for a list
        Value::Array(_) => {}
        leaf => leaves.push((path, leaf)),
    }
}

/// A key as it stands in a path: in quotes if it has other characters than letters, digits, `_` and `-`.
fn quoted(key: &str) -> String {
    let bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '_' | '-'));
    if bare { key.to_owned() } else { format!("{key:?}") }
}

/// The keys of a path without quotes; at least one. Inverse of [`quoted`] keys joined by dots.
pub(crate) fn split(path: &str) -> Vec<String> {
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

/// The key at `*` of the pattern, empty for a pattern without `*`; none if the pattern does not fit.
fn matched<'k>(pattern: &str, keys: &'k [String]) -> Option<&'k str> {
    let parts: Vec<&str> = pattern.split('.').collect();
    let fits = parts.len() == keys.len() && parts.iter().zip(keys).all(|(part, key)| *part == "*" || part == key);
    fits.then(|| parts.iter().position(|part| *part == "*").map_or("", |place| &keys[place][..]))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use serde_json::json;

    use super::*;
    use crate::landmarks::{LinkClass, NamedRope};

    /// A summary with every section, and an entry in each of its tables.
    fn full() -> Value {
        let mut summary = Summary {
            statics: Some(Equilibrium::default()),
            launch: Some(Departures { recoil: Some(Recoil::default()), ..Departures::default() }),
            air: Some(AirMet::default()),
            target: Some(TargetCoverage::default()),
            canopies: Some(SheetStress::default()),
            ..Summary::default()
        };
        summary.launch.as_mut().unwrap().tractors.insert(1, Departure::default());
        for point in ["A", "B", "tractor", "centre"] {
            summary.points.insert(point.into(), Some(PointExtremes::default()));
        }
        summary.tension.by_class.insert("ring".into(), ClassTension::default());
        summary.tension.by_rope.insert("rope".into(), RopeUse::default());
        summary.energy.channels.insert("elastic".into(), 0.0);
        summary.reactions.insert("supports".into(), Reaction::default());
        serde_json::to_value(summary).unwrap()
    }

    /// Paths of all values, including lists.
    fn paths(values: &Value) -> Vec<String> {
        fn walk(path: &str, value: &Value, into: &mut Vec<String>) {
            match value {
                Value::Object(entries) => {
                    for (key, value) in entries {
                        walk(&format!("{path}.{}", quoted(key)), value, into);
                    }
                }
                _ => into.push(path[1..].to_owned()),
            }
        }
        let mut found = Vec::new();
        walk("", values, &mut found);
        // keys about the run and the list of broken segments are not quantities
        found.retain(|path| !ABOUT_THE_RUN.contains(&&path[..]) && path != "breaks");
        found
    }

    #[test]
    fn every_key_of_a_summary_has_a_row_and_every_row_a_key() {
        let paths = paths(&full());
        for path in &paths {
            assert!(quantity_at(path).is_some(), "{path} has no row in the table of quantities");
        }
        for quantity in quantities() {
            let pattern = quantity.path();
            let known = paths.iter().any(|path| matched(&pattern, &split(path)).is_some());
            assert!(known, "the row {pattern} stands for no key of a summary");
        }
    }

    #[test]
    fn every_row_occurs_once_and_in_its_own_section() {
        let mut seen = BTreeSet::new();
        for section in &SECTIONS {
            for quantity in section.quantities() {
                assert_eq!(quantity.section(), section.key, "{}", quantity.path());
                assert!(seen.insert(quantity.path()), "{} occurs twice", quantity.path());
                assert!(!quantity.definition().is_empty());
                // the name has a placeholder exactly if the path has one
                assert_eq!(quantity.path().contains('*'), quantity.name.contains("{}"), "{}", quantity.path());
            }
        }
    }

    #[test]
    fn a_key_names_the_unit_of_its_dimension() {
        for quantity in quantities().filter(|quantity| !quantity.by_name) {
            let unit = quantity.dimension.unit().replace("^", "").replace(['/', ' '], "_").to_lowercase();
            if !unit.is_empty() {
                assert!(quantity.key.ends_with(&format!("_{unit}")), "{} is in {unit}", quantity.path());
            }
        }
    }

    #[test]
    fn the_paths_of_a_design_are_known_before_its_run() {
        let landmarks = Landmarks {
            classes: vec![LinkClass { name: "rope.3".into(), is_rope: true, strength: None }],
            ropes: vec![NamedRope { name: "border".into(), strength: None, knot_reduction: None }],
            ..Landmarks::default()
        };
        let found = expected(&landmarks, |section| section != "target");
        let has = |path: &str| found.iter().any(|(known, _)| known == path);
        for path in [
            "mouth.tilt_max_open_rad",
            "points.B.peak_travel_m",
            "tension.by_class.\"rope.3\".max_n",
            "tension.by_rope.border.utilisation",
            "energy.channels.kinetic",
            "wall_time_s",
        ] {
            assert!(has(path), "{path}");
        }
        assert!(!has("target.diameter_m") && !has("tension.by_class.ring.max_n"));
    }

    #[test]
    fn leaves_leave_out_lists_and_keys_about_the_run() {
        let summary = json!({
            "title": "x", "finished": true, "warnings": ["y"], "wall_time_s": 2.0,
            "points": {"A": null, "knot.3": {"starts_s": 0.5}}, "list": [1, 2], "flight": {"still_up": false}
        });
        let paths: Vec<String> = leaves(&summary).into_iter().map(|(path, _)| path).collect();
        assert_eq!(paths, ["wall_time_s", "points.A", "points.\"knot.3\".starts_s", "flight.still_up"]);
    }

    #[test]
    fn a_path_is_split_into_the_keys_it_was_joined_from() {
        for keys in [vec!["a", "b"], vec!["a.b", "c"], vec!["say \"x\"", "\\", "µ"]] {
            let path: Vec<String> = keys.iter().map(|key| quoted(key)).collect();
            assert_eq!(split(&path.join(".")), keys);
        }
    }
}

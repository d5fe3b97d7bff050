//! Table of results: a row for each quantity, a column for each design.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::heading::Heading;
use super::{Design, Entrant, Reported};
use crate::measures::OPEN_SHARE;
use crate::quantities::leaves;
use crate::quantity::Better;
use crate::summary::Summary;

/// Values whose relative difference is at most this are equal. Their sums may differ by that much between machines.
const EQUAL_WITHIN: f64 = 1e-9;

/// One quantity of all designs.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Row {
    /// Path in `summary.json`.
    pub quantity: String,
    /// Name for the reader.
    pub label: String,
    /// Unit; empty for a plain number or a text.
    pub unit: String,
    /// Title of its section; rows of one group stand together.
    pub group: String,
    /// Whether a designer looks for it first.
    pub headline: bool,
    /// Direction of better; null where neither direction is better.
    pub better: Option<Better>,
    /// Whether equal inputs give equal values; false for time on the clock.
    pub reproducible: bool,
    /// Value in each design: a number, a text, or null if the design does not have the quantity.
    pub values: Map<String, Value>,
    /// All designs with the best value. Empty where neither direction is better, where fewer than two sound runs have a
    /// value, where all values are equal, and where the value grows with the length of the runs and these differ. A web that
    /// does not open has no best time of its largest area.
    pub best: Vec<String>,
    /// Reported values, by design.
    pub reported: Map<String, Value>,
    /// Value less reported value, in percent of the magnitude of the reported value; by design, where both are numbers.
    pub deviation_percent: Map<String, Value>,
}

/// The rows for which any design has a value, group by group.
pub(super) fn table(entrants: &[Entrant], designs: &[Design], reported: Option<&Reported>) -> Vec<Row> {
    let leaves: Vec<Vec<(String, &Value)>> = entrants.iter().map(|entrant| leaves(&entrant.summary.values)).collect();
    let paths = merged(leaves.iter().map(|leaves| leaves.iter().map(|(path, _)| path.as_str())));
    let mut headings: Vec<Heading> = paths.into_iter().map(Heading::of).collect();
    // a stable sort keeps the order of the summary within a group
    headings.sort_by_key(Heading::rank);
    let row = |heading: Heading| {
        let value = |leaves: &Vec<(String, &Value)>| {
            leaves.iter().find(|(path, _)| *path == heading.path).map_or(Value::Null, |(_, value)| (*value).clone())
        };
        let values: Map<String, Value> =
            entrants.iter().zip(&leaves).map(|(entrant, leaves)| (entrant.name.clone(), value(leaves))).collect();
        if values.values().all(Value::is_null) {
            return None;
        }
        let reported: Map<String, Value> = reported
            .iter()
            .flat_map(|reported| &reported.values)
            .filter(|known| known.quantity == heading.path)
            .map(|known| (known.design.clone(), known.value.clone()))
            .collect();
        Some(Row {
            best: heading.better.map_or(Vec::new(), |better| {
                best(better, &competing(&heading.path, better, entrants, designs), &values)
            }),
            deviation_percent: deviations(&values, &reported),
            reported,
            values,
            label: heading.label,
            unit: heading.unit.to_owned(),
            group: heading.group,
            headline: heading.headline,
            better: heading.better,
            reproducible: heading.reproducible,
            quantity: heading.path,
        })
    };
    headings.into_iter().filter_map(row).collect()
}

/// The names of the sound designs among which the best value of a quantity may be looked for.
///
/// The time of the largest area is an opening time only of webs that open. What grows as long as a web is watched can be
/// compared only between runs of equal length.
fn competing<'d>(path: &str, better: Better, entrants: &[Entrant], designs: &'d [Design]) -> Vec<&'d str> {
    let sound: Vec<(&Design, &Summary)> = designs
        .iter()
        .zip(entrants)
        .filter(|(design, _)| design.is_sound())
        .map(|(design, entrant)| (design, &entrant.summary.summary))
        .collect();
    let grows = better == Better::Higher && WATCHED.iter().any(|end| path.ends_with(end));
    let lengths = || sound.iter().map(|(_, summary)| summary.step.count as f64 * summary.step.dt_s);
    let (shortest, longest) = (lengths().fold(f64::INFINITY, f64::min), lengths().fold(0.0, f64::max));
    if grows && longest - shortest > ALIKE_WITHIN * longest {
        return Vec::new();
    }
    let opens = |summary: &Summary| match (summary.opening.area_max_m2, summary.opening.reference_area_m2) {
        (Some(area), Some(flat)) => area >= OPEN_SHARE * flat,
        _ => true,
    };
    let fits = sound.iter().filter(|(_, summary)| path != "opening.area_max_time_s" || opens(summary));
    fits.map(|(design, _)| &design.name[..]).collect()
}

/// Ends of the paths of quantities that grow with the length of a run.
const WATCHED: [&str; 5] =
    ["effective_duration_s", "covered_duration_s", "hang_time_s", "peak_travel_m", "first_break_time_s"];

/// Runs whose relative difference in length is at most this are equally long: their steps differ.
const ALIKE_WITHIN: f64 = 1e-3;

/// The designs among `competing` with the best value; see [`Row::best`].
fn best(better: Better, competing: &[&str], values: &Map<String, Value>) -> Vec<String> {
    let competing: Vec<(&str, f64)> =
        competing.iter().filter_map(|name| Some((*name, values.get(*name)?.as_f64()?))).collect();
    let pick = match better {
        Better::Lower => f64::min,
        Better::Higher => f64::max,
    };
    let Some(extreme) = competing.iter().map(|(_, value)| *value).reduce(pick) else { return Vec::new() };
    let equal = |value: f64| (value - extreme).abs() <= EQUAL_WITHIN * value.abs().max(extreme.abs());
    let best: Vec<String> =
        competing.iter().filter(|(_, value)| equal(*value)).map(|(name, _)| (*name).to_owned()).collect();
    // a value that all designs share distinguishes none of them
    if best.len() == competing.len() { Vec::new() } else { best }
}

/// Deviations from reported values, in percent; see [`Row::deviation_percent`].
fn deviations(values: &Map<String, Value>, reported: &Map<String, Value>) -> Map<String, Value> {
    let deviation = |(name, known): (&String, &Value)| {
        let (value, known) = (values.get(name)?.as_f64()?, known.as_f64()?);
        // a reported zero has no percentage
        (known != 0.0).then(|| (name.clone(), Value::from(100.0 * (value - known) / known.abs())))
    };
    reported.iter().filter_map(deviation).collect()
}

/// The keys of several lists, each once. A key that earlier lists lack is inserted before the first known key that
/// follows it in its own list, or else after the key that precedes it there.
pub(super) fn merged<'k>(lists: impl IntoIterator<Item = impl Iterator<Item = &'k str>>) -> Vec<&'k str> {
    let mut merged: Vec<&str> = Vec::new();
    for list in lists {
        let list: Vec<&str> = list.collect();
        let mut after = 0;
        for (index, key) in list.iter().enumerate() {
            let place_of = |key: &&str| merged.iter().position(|known| known == key);
            after = match place_of(key) {
                Some(known) => known,
                None => {
                    let place = list[index..].iter().find_map(place_of).unwrap_or(after);
                    merged.insert(place, key);
                    place
                }
            } + 1;
        }
    }
    merged
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use std::path::Path;

    use super::super::{Comparison, ReportedValue};
    use super::*;
    use crate::summary::SummaryFile;

    fn rows(summaries: &[(&str, Value)], reported: &[(&str, &str, Value)]) -> Vec<Row> {
        let entrants: Vec<Entrant> = summaries
            .iter()
            .map(|(name, summary)| Entrant {
                name: name.to_string(),
                summary: SummaryFile::of(summary.clone(), Path::new("summary.json")).unwrap(),
                inputs: Vec::new(),
                failure: None,
            })
            .collect();
        let values = reported.iter().map(|(design, quantity, value)| ReportedValue {
            design: design.to_string(),
            quantity: quantity.to_string(),
            value: value.clone(),
        });
        Comparison::of(&entrants, Some(&Reported { source: "a test".into(), values: values.collect() })).table
    }

    fn row<'t>(rows: &'t [Row], quantity: &str) -> &'t Row {
        rows.iter().find(|row| row.quantity == quantity).unwrap_or_else(|| panic!("no row {quantity}"))
    }

    #[test]
    fn the_best_is_earliest_widest_gentlest_and_lightest_and_ties_share_it() {
        let design = |time: f64, area: f64, tension: f64, mass: f64, margin: f64| {
            json!({
                "opening": {"area_max_time_s": time, "area_max_m2": area, "reference_area_m2": area},
                "tension": {"max_n": tension, "by_class": {"ring": {"margin": margin}}}, "model": {"web_mass_kg": mass}
            })
        };
        let rows = rows(
            &[
                ("a", design(0.12, 15.0, 9e4, 60.0, 1.5)),
                ("b", design(0.14, 16.0, 7e4, 50.0, 1.6)),
                ("c", design(0.12 * (1.0 + 1e-12), 14.0, 8e4, 50.0, 0.9)),
            ],
            &[],
        );
        let best = |quantity| row(&rows, quantity).best.join(" ");
        assert_eq!(best("opening.area_max_time_s"), "a c");
        assert_eq!(best("opening.area_max_m2"), "b");
        assert_eq!(best("tension.max_n"), "b");
        assert_eq!(best("model.web_mass_kg"), "b c");
        assert_eq!(best("tension.by_class.ring.margin"), "b");
        // the size of the flat web is a choice, not a merit
        assert_eq!(best("opening.reference_area_m2"), "");
    }

    #[test]
    fn a_null_is_never_best_and_a_row_of_nulls_is_left_out() {
        let rows = rows(
            &[
                ("a", json!({"tension": {"bottom_max_n": null, "max_n": 5.0, "by_class": {"ring": {"max_n": 4.0}}}})),
                ("b", json!({"tension": {"bottom_max_n": null, "max_n": null, "by_class": {}}, "points": {"A": null}})),
                ("c", json!({"tension": {"max_n": 3.0}})),
            ],
            &[],
        );
        assert_eq!(rows.len(), 2);
        assert_eq!(row(&rows, "tension.max_n").best, ["c"]);
        assert_eq!(Value::Object(row(&rows, "tension.max_n").values.clone()), json!({"a": 5.0, "b": null, "c": 3.0}));
        // a single value is not best
        assert_eq!(row(&rows, "tension.by_class.ring.max_n").best, Vec::<String>::new());
    }

    #[test]
    fn a_web_that_never_opens_is_not_the_first_to_open() {
        let design = |time: f64, area: f64| json!({"opening": {"area_max_time_s": time, "area_max_m2": area, "reference_area_m2": 10.0}});
        let designs = [("a", design(0.02, 2.0)), ("b", design(0.14, 9.0)), ("c", design(0.12, 9.5))];
        assert_eq!(row(&rows(&designs, &[]), "opening.area_max_time_s").best, ["c"]);
    }

    #[test]
    fn hang_times_of_runs_of_different_length_have_no_best() {
        let design = |hang: f64, steps: u64| json!({"flight": {"hang_time_s": hang}, "tension": {"max_n": hang}, "step": {"count": steps, "dt_s": 1e-5}});
        let best = |steps: u64| rows(&[("a", design(0.2, 100_000)), ("b", design(0.3, steps))], &[]);
        assert_eq!(row(&best(100_001), "flight.hang_time_s").best, ["b"]);
        assert!(row(&best(50_000), "flight.hang_time_s").best.is_empty());
        assert_eq!(row(&best(50_000), "tension.max_n").best, ["a"]);
    }

    #[test]
    fn equal_values_have_no_best() {
        let summary = json!({"model": {"tractor_mass_kg": 166.8}});
        assert!(rows(&[("a", summary.clone()), ("b", summary)], &[])[0].best.is_empty());
    }

    #[test]
    fn reported_numbers_are_listed_with_the_deviation_from_them() {
        let summary = json!({"opening": {"area_max_time_s": 0.132, "area_max_m2": null},
                             "points": {"B": {"starts_s": -2}},
                             "tension": {"max_where": "outline", "max_n": 10.0}});
        let rows = rows(
            &[("a", summary.clone()), ("b", summary)],
            &[
                ("a", "opening.area_max_time_s", json!(0.12)),
                ("b", "points.B.starts_s", json!(-4)),
                ("a", "tension.max_where", json!("traction")),
                ("a", "tension.max_n", json!(0.0)),
            ],
        );
        let time = row(&rows, "opening.area_max_time_s");
        assert!((time.deviation_percent["a"].as_f64().unwrap() - 10.0).abs() < 1e-9);
        assert!(!time.deviation_percent.contains_key("b"));
        // less negative than reported is a positive deviation
        assert_eq!(row(&rows, "points.B.starts_s").deviation_percent["b"], json!(50.0));
        let place = row(&rows, "tension.max_where");
        assert_eq!((&place.reported["a"], place.deviation_percent.len()), (&json!("traction"), 0));
        assert!(row(&rows, "tension.max_n").deviation_percent.is_empty());
    }

    #[test]
    fn a_number_outside_the_table_of_quantities_is_compared_too() {
        let rows = rows(&[("a", json!({"wind": {"gust": {"peak_m_s": 3.5}}})), ("b", json!({}))], &[]);
        assert_eq!((&rows[0].label[..], &rows[0].unit[..], &rows[0].group[..]), ("gust, peak", "m/s", "Wind"));
    }

    #[test]
    fn merged_lists_put_new_keys_beside_their_neighbours() {
        let lists = [vec!["a", "b", "d"], vec!["a", "c", "d", "e"], vec!["z", "a"]];
        assert_eq!(merged(lists.iter().map(|list| list.iter().copied())), ["z", "a", "b", "c", "d", "e"]);
    }
}

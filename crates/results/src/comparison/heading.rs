//! A path of a summary as the comparison shows it: by its row of the table of quantities, or, for what a later version
//! has added, under a name and a unit read off its key.

use crate::quantities::{SECTIONS, quantity_at, split};
use crate::quantity::Better::{self, Higher, Lower};

/// What a path of `summary.json` is to a comparison.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading {
    /// The path, with dots: `tension.by_class.ring.max_n`.
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

/// Sections of the table that stand after those that nobody foresaw.
const LAST: [&str; 3] = ["energy", "step", "wall_time_s"];

/// Units of keys without a row in the table, by their end; the longest that fits counts.
const UNITS: [(&str, &str); 12] = [
    ("_kg_m3", "kg/m^3"),
    ("_m_s2", "m/s^2"),
    ("_m_s", "m/s"),
    ("_m2", "m^2"),
    ("_kg", "kg"),
    ("_deg", "deg"),
    ("_rad", "rad"),
    ("_pa", "Pa"),
    ("_m", "m"),
    ("_n", "N"),
    ("_j", "J"),
    ("_s", "s"),
];

/// What is wanted of a number without a row in the table, by what its key says.
const WANTED: [(&str, Better); 5] =
    [("margin", Higher), ("coverage", Higher), ("utilisation", Lower), ("tilt", Lower), ("asymmetry", Lower)];

impl Heading {
    /// Of a path of the summary.
    pub fn of(path: &str) -> Self {
        let keys = split(path);
        let section = SECTIONS.iter().find(|section| section.key == keys[0]);
        let group = section.map_or_else(|| capitalised(&keys[0]), |section| section.title.to_owned());
        let reproducible = path != "wall_time_s";
        let path = path.to_owned();
        if let Some((quantity, thing)) = quantity_at(&path) {
            let label = quantity.name_of(&spoken(&thing));
            let (unit, headline, better) = (quantity.dimension.unit(), quantity.headline, quantity.better);
            return Self { path, label, unit, group, headline, better, reproducible };
        }
        let last = &keys[keys.len() - 1];
        let suffix = UNITS.iter().find(|(suffix, _)| last.ends_with(suffix));
        let stem = suffix.and_then(|(suffix, _)| last.strip_suffix(suffix)).unwrap_or(last);
        let mut words: Vec<&str> = keys[1..].iter().map(String::as_str).collect();
        words.pop();
        words.push(stem);
        let label = words.join(", ").replace('_', " ");
        let unit = suffix.map_or("", |(_, unit)| unit);
        let better = WANTED.iter().find(|(word, _)| last.contains(word)).map(|(_, better)| *better);
        Self { path, label, unit, group, headline: false, better, reproducible }
    }

    /// Its group's place in the table.
    pub(super) fn rank(&self) -> (usize, String) {
        let section = split(&self.path).swap_remove(0);
        match SECTIONS.iter().position(|known| known.key == section) {
            Some(place) => (2 * place, String::new()),
            // sections that nobody foresaw stay together
            None => (2 * (SECTIONS.len() - LAST.len()) - 1, section),
        }
    }
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
    use super::*;

    #[test]
    fn words_and_units_follow_from_the_path() {
        let told = |path: &str| {
            let heading = Heading::of(path);
            (heading.label, heading.unit, heading.better)
        };
        assert_eq!(told("opening.area_max_time_s"), ("Time of largest outline area".into(), "s", Some(Lower)));
        assert_eq!(told("points.B.peak_speed_m_s"), ("Peak speed of point B".into(), "m/s", None));
        assert_eq!(told("points.tractor.starts_s"), ("Start of the tractors".into(), "s", None));
        assert_eq!(
            told("tension.by_class.rope_hexagon.max_n"),
            ("Highest tension, rope hexagon".into(), "N", Some(Lower))
        );
        assert_eq!(told("energy.channels.mass_damping"), ("Energy at the end, mass damping".into(), "J", None));
        assert_eq!(told("points.\"knot.3\".peak_travel_m"), ("Peak travel of knot.3".into(), "m", None));
        // nobody foresaw these
        assert_eq!(told("capture.of_target.coverage_mean"), ("of target, coverage mean".into(), "", Some(Higher)));
        assert_eq!(told("capture.closing_speed_m_s"), ("closing speed".into(), "m/s", None));
    }

    #[test]
    fn groups_stand_in_the_order_of_a_designers_interest() {
        let mut paths = ["wall_time_s", "model.nodes", "gust.peak_m_s", "opening.area_max_m2", "tension.max_n"];
        paths.sort_by_key(|path| Heading::of(path).rank());
        assert_eq!(paths, ["opening.area_max_m2", "tension.max_n", "model.nodes", "gust.peak_m_s", "wall_time_s"]);
    }

    #[test]
    fn what_nobody_foresaw_stands_before_the_last_sections() {
        let last = &SECTIONS[SECTIONS.len() - LAST.len()..];
        assert!(last.iter().zip(LAST).all(|(section, key)| section.key == key));
    }
}

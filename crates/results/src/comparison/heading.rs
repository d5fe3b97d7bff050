//! Heading of a row of the comparison: name, unit and group of a path of the summary.
//!
//! They come from the table of quantities, or from the key itself for a path that is not in the table, such as one that
//! a later version has added.

use crate::quantities::{SECTIONS, quantity_at, split};
use crate::quantity::Better::{self, Higher, Lower};

/// Name, unit and group of a path of `summary.json`.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading {
    /// The path, with dots: `tension.by_class.ring.max_n`.
    pub path: String,
    /// Name for the reader.
    pub label: String,
    /// Unit as a scenario writes it; empty for a plain number or a text.
    pub unit: &'static str,
    /// Title of its section.
    pub group: String,
    /// Whether a designer looks for it first.
    pub headline: bool,
    /// Direction of better; none where neither direction is better.
    pub better: Option<Better>,
    /// Whether equal inputs give equal values.
    pub reproducible: bool,
}

/// Sections that stand after those that are not in the table of quantities.
const LAST: [&str; 3] = ["energy", "step", "wall_time_s"];

/// Units by the suffix of a key, for keys without a row in the table; the first that fits counts.
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

/// Directions of better by a word in the key, for keys without a row in the table.
const BETTER_BY_WORD: [(&str, Better); 5] =
    [("margin", Higher), ("coverage", Higher), ("utilisation", Lower), ("tilt", Lower), ("asymmetry", Lower)];

impl Heading {
    /// Heading of a path of the summary.
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
        let better = BETTER_BY_WORD.iter().find(|(word, _)| last.contains(word)).map(|(_, better)| *better);
        Self { path, label, unit, group, headline: false, better, reproducible }
    }

    /// Sort key: place of its section in the table of the comparison.
    pub(super) fn rank(&self) -> (usize, String) {
        let section = split(&self.path).swap_remove(0);
        match SECTIONS.iter().position(|known| known.key == section) {
            Some(place) => (2 * place, String::new()),
            // sections outside the table of quantities, sorted by key, stand before the last ones
            None => (2 * (SECTIONS.len() - LAST.len()) - 1, section),
        }
    }
}

/// Name of a point, a link class or a channel as it reads in a sentence.
fn spoken(name: &str) -> String {
    match name {
        "tractor" => "the tractors".into(),
        "corner" => "the corners".into(),
        "centre" => "the centre".into(),
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
    fn label_and_unit_follow_from_the_path() {
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
        // not in the table of quantities
        assert_eq!(told("capture.of_target.coverage_mean"), ("of target, coverage mean".into(), "", Some(Higher)));
        assert_eq!(told("capture.closing_speed_m_s"), ("closing speed".into(), "m/s", None));
    }

    #[test]
    fn groups_stand_in_the_order_of_the_sections() {
        let mut paths = ["wall_time_s", "model.nodes", "gust.peak_m_s", "opening.area_max_m2", "tension.max_n"];
        paths.sort_by_key(|path| Heading::of(path).rank());
        assert_eq!(paths, ["opening.area_max_m2", "tension.max_n", "model.nodes", "gust.peak_m_s", "wall_time_s"]);
    }

    #[test]
    fn the_last_sections_end_the_table_of_quantities() {
        let last = &SECTIONS[SECTIONS.len() - LAST.len()..];
        assert!(last.iter().zip(LAST).all(|(section, key)| section.key == key));
    }
}

//! The tables of a comparison: the inputs that differ, and the results with the best of each row marked.

use netcast_results::comparison::Row;
use netcast_results::{Better, Comparison};
use serde_json::{Map, Value};

use super::swatch;
use crate::format::{Scale, duration, escape, fixed, grouped, percent, prose, significant};

/// The cell of a quantity that a design lacks.
const NOTHING: &str = "<td class=\"nothing\">–</td>";

/// The inputs that differ, one row each.
pub(crate) fn differences(comparison: &Comparison) -> String {
    let rows = &comparison.differences;
    if rows.is_empty() {
        return "<p>Nothing: the designs have the same inputs.</p>".into();
    }
    let body: String = rows
        .iter()
        .map(|row| {
            let cells: String = designs(comparison)
                .map(|design| match row.values.get(design).and_then(input) {
                    Some(value) => format!("<td>{}</td>", escape(&value)),
                    None => "<td class=\"nothing\">absent</td>".into(),
                })
                .collect();
            format!("<tr><th scope=\"row\"><code>{}</code></th>{cells}</tr>\n", escape(&row.path))
        })
        .collect();
    let heads: String = designs(comparison).enumerate().map(|(index, name)| head(index, name)).collect();
    table("inputs", &format!("<th scope=\"col\">Input</th>{heads}"), &body)
}

/// The quantities that a designer looks for first, and all with a reported value.
pub(crate) fn headlines(comparison: &Comparison) -> String {
    let is_wanted = |row: &&Row| row.headline || !row.reported.is_empty();
    let rows: Vec<&Row> = comparison.table.iter().filter(is_wanted).collect();
    results(comparison, &rows)
}

/// All quantities, one table for each group.
pub(crate) fn all_quantities(comparison: &Comparison) -> String {
    let groups = comparison.table.chunk_by(|one, other| one.group == other.group);
    groups
        .map(|group| {
            let rows: Vec<&Row> = group.iter().collect();
            let title = escape(&group[0].group);
            format!("<details><summary><h3>{title}</h3></summary>\n{}</details>\n", results(comparison, &rows))
        })
        .collect()
}

/// A table of results. A design with any reported value has a second column for those.
fn results(comparison: &Comparison, rows: &[&Row]) -> String {
    let reported: Vec<bool> = designs(comparison).map(|design| is_reported(rows, design)).collect();
    let heads: String = designs(comparison)
        .enumerate()
        .map(|(index, name)| {
            let second = if reported[index] { "<th scope=\"col\" class=\"reported\">reported</th>" } else { "" };
            head(index, name) + second
        })
        .collect();
    let body: String = rows.iter().map(|row| result(comparison, row, &reported)).collect();
    table("results", &format!("<th scope=\"col\">Quantity</th>{heads}"), &body)
}

/// Whether any of the rows has a reported value of a design.
fn is_reported(rows: &[&Row], design: &str) -> bool {
    rows.iter().any(|row| row.reported.get(design).is_some_and(|value| !value.is_null()))
}

/// A row of the table of results; `reported` says for each design whether it has a second column.
fn result(comparison: &Comparison, row: &Row, reported: &[bool]) -> String {
    let display = Display::of(row);
    let best = alike(comparison, row, &display);
    let cells: String = designs(comparison)
        .zip(reported)
        .map(|(design, has_reported)| {
            let own = match display.text(&row.values, design) {
                Some(value) if best.contains(&design) => {
                    format!(
                        "<td class=\"best\"><span aria-hidden=\"true\">★ </span>{}<span class=\"said\"> (best)</span></td>",
                        escape(&value)
                    )
                }
                Some(value) => format!("<td>{}</td>", escape(&value)),
                None => NOTHING.into(),
            };
            let known = display.text(&row.reported, design).map_or("<td class=\"reported\"></td>".into(), |value| {
                let by = row.deviation_percent.get(design).and_then(Value::as_f64).map(deviation);
                let by = by.map_or(String::new(), |by| format!("<small>{by}</small>"));
                format!("<td class=\"reported\">{}{by}</td>", escape(&value))
            });
            if *has_reported { own + &known } else { own }
        })
        .collect();
    let wanted = match row.better {
        Some(Better::Lower) => "<span class=\"wanted\" title=\"lower is better\">↓</span>",
        Some(Better::Higher) => "<span class=\"wanted\" title=\"higher is better\">↑</span>",
        None => "",
    };
    let unit = if display.unit.is_empty() { String::new() } else { format!(", {}", display.unit) };
    let unsteady = if row.reproducible { "" } else { "<small>differs from run to run</small>" };
    format!(
        "<tr title=\"{}\"><th scope=\"row\">{}<span class=\"unit\">{}</span>{wanted}{unsteady}</th>{cells}</tr>\n",
        escape(&row.quantity),
        prose(&row.label),
        escape(&unit)
    )
}

/// The designs with a star: the best ones of the row, and sound ones whose value reads like theirs. None where all read
/// alike.
fn alike<'c>(comparison: &'c Comparison, row: &Row, display: &Display) -> Vec<&'c str> {
    let told = |name: &str| display.text(&row.values, name);
    let best: Vec<Option<String>> = row.best.iter().map(|name| told(name)).collect();
    let sound = comparison.designs.iter().filter(|design| design.is_sound()).map(|design| &design.name[..]);
    let competing: Vec<&str> = sound.filter(|name| told(name).is_some()).collect();
    let starred: Vec<&str> = competing.iter().copied().filter(|name| best.contains(&told(name))).collect();
    if competing.len() > 1 && starred.len() == competing.len() { Vec::new() } else { starred }
}

/// The format of the values of a row: one unit for all, so that they compare at a glance.
struct Display {
    unit: String,
    write: Box<dyn Fn(f64) -> String>,
}

impl Display {
    fn of(row: &Row) -> Self {
        let all = [&row.values, &row.reported].into_iter().flatten();
        let numbers: Vec<&Value> = all.map(|(_, value)| value).filter(|value| value.is_number()).collect();
        let largest = numbers.iter().filter_map(|value| value.as_f64()).fold(0.0, |most, v: f64| v.abs().max(most));
        let quantity = &row.quantity;
        let scaled = |factor: f64, unit: &str| Self {
            unit: unit.to_owned(),
            write: Box::new(move |value| significant(value * factor)),
        };
        let in_cell = |write: fn(f64) -> String| Self { unit: String::new(), write: Box::new(write) };
        match &row.unit[..] {
            "s" if quantity == "wall_time_s" || largest < 1e-3 => in_cell(duration),
            "s" => Self { unit: "s".into(), write: Box::new(|value| fixed(value, 3)) },
            unit @ ("N" | "J") => {
                let scale = Scale::fitting(largest, unit);
                scaled(1.0 / scale.divisor, &scale.unit)
            }
            "rad" => scaled(180.0 / std::f64::consts::PI, "°"),
            "" if quantity.starts_with("energy.closure") => in_cell(percent),
            "" if numbers.iter().all(|value| value.is_u64()) => in_cell(|value| grouped(value as u64)),
            unit => scaled(1.0, &unit.replace("^2", "²")),
        }
    }

    /// A design's value in a row as text; none where it has no value.
    fn text(&self, values: &Map<String, Value>, design: &str) -> Option<String> {
        match values.get(design)? {
            Value::Number(number) => number.as_f64().map(&self.write),
            Value::String(text) => Some(text.clone()),
            Value::Bool(yes) => Some(if *yes { "yes".into() } else { "no".into() }),
            _ => None,
        }
    }
}

/// The deviation from a reported number, given in percent.
fn deviation(percent: f64) -> String {
    match percent {
        near if near.abs() < 0.05 => "±0 %".into(),
        far if far.abs() >= 10.0 => format!("{far:+.0} %"),
        other => format!("{other:+.1} %"),
    }
}

/// A quantity in the unit that engineers use: a resolved scenario has `90000000000 Pa`, `1.5707963267948966 rad` and
/// `0.09860000000000001 m`.
fn readable(text: &str) -> String {
    let split = text.split_once(' ').and_then(|(number, unit)| Some((number, number.parse::<f64>().ok()?, unit)));
    let told = match split {
        Some((digits, number, "Pa")) if digits.len() > 8 => format!("{} GPa", twelve_digits(number * 1e-9)),
        Some((digits, number, "Pa")) if digits.len() > 5 => format!("{} MPa", twelve_digits(number * 1e-6)),
        Some((_, number, "rad")) => format!("{} deg", twelve_digits(number.to_degrees())),
        Some((_, number, unit)) => format!("{} {unit}", twelve_digits(number)),
        None => text.to_owned(),
    };
    told.replace("^2", "²").replace("^3", "³")
}

/// A number with twelve digits at most, which hide the rounding error of a conversion.
fn twelve_digits(number: f64) -> String {
    format!("{number:.11e}").parse().unwrap_or(number).to_string()
}

/// An input as text; none where it is null.
fn input(value: &Value) -> Option<String> {
    match value {
        Value::Null => None,
        Value::String(text) => Some(readable(text)),
        // an empty table: a variant without keys of its own
        Value::Object(_) => Some("as by default".into()),
        Value::Array(elements) => Some(elements.iter().filter_map(input).collect::<Vec<_>>().join(", ")),
        Value::Number(number) if number.is_f64() => number.as_f64().map(twelve_digits),
        other => Some(other.to_string()),
    }
}

fn designs(comparison: &Comparison) -> impl Iterator<Item = &str> {
    comparison.designs.iter().map(|design| &design.name[..])
}

fn head(index: usize, name: &str) -> String {
    // allow a line break after each underscore and hyphen of a long name
    let name = escape(name).replace('_', "_<wbr>").replace('-', "-<wbr>");
    format!("<th scope=\"col\">{}{name}</th>", swatch(index))
}

fn table(class: &str, heads: &str, body: &str) -> String {
    format!(
        "<div class=\"side-by-side\" tabindex=\"0\"><table class=\"{class}\">\n<thead><tr>{heads}</tr></thead>\n\
         <tbody>\n{body}</tbody></table></div>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_have_the_digits_that_their_author_wrote() {
        let told =
            ["0.09860000000000001 m", "90000000000 Pa", "1.5707963267948966 rad", "7 kg/m^3", "a b"].map(readable);
        assert_eq!(told, ["0.0986 m", "90 GPa", "90 deg", "7 kg/m³", "a b"]);
        assert_eq!(input(&serde_json::json!([0.30000000000000004, "0.1 m"])).unwrap(), "0.3, 0.1 m");
    }
}

//! The numbers of a summary as HTML tables: one row for each quantity with a value in the file.

use std::collections::BTreeMap;

use netcast_results::{Dimension, Quantity, SECTIONS, SummaryFile, quantities, quantity_at};
use serde_json::Value;

use crate::format::{
    Scale, duration, escape, fixed, grouped, percent, prose, share_of_flat, significant, time, with_prefix,
};
use crate::words::is_equilibrium;

/// The cell of a quantity that a scenario lacks.
const NOTHING: &str = "<td class=\"nothing\">–</td>";

/// All tables of a summary as one piece of HTML.
pub(crate) fn tables(file: &SummaryFile) -> String {
    let equilibrium = pairs("Equilibrium", &rows(file, &["static"]));
    let model = pairs("Model and step", &rows(file, &["model", "air", "step", "wall_time_s"]));
    if is_equilibrium(&file.summary) {
        return [equilibrium, tension(file), ropes(file), model].concat();
    }
    [
        equilibrium,
        pairs("Opening", &with_share(file, rows(file, &["opening", "posture"]))),
        points(file),
        tension(file),
        ropes(file),
        pairs("Mouth, target and flight", &rows(file, &["mouth", "target", "flight"])),
        pairs("Energy", &rows(file, &["energy"])),
        model,
    ]
    .concat()
}

/// The audit of the state at the start.
pub(crate) fn stowed(file: &SummaryFile) -> String {
    pairs("State at the start", &rows(file, &["stowed"]))
}

/// Names and values of the quantities of some sections, of those that belong in tables and have a value in the file.
fn rows(file: &SummaryFile, sections: &[&str]) -> Vec<(String, String)> {
    let of_section = |section: &str| {
        let value = &file.values[section];
        let keys = SECTIONS.iter().filter(|known| known.key == section).flat_map(|known| known.quantities());
        keys.filter(|quantity| quantity.in_table).flat_map(|quantity| entries(quantity, value)).collect::<Vec<_>>()
    };
    sections.iter().flat_map(|section| of_section(section)).collect()
}

/// Name and value of a quantity of a section; one entry for each object where the quantity is listed by name.
fn entries(quantity: &Quantity, section: &Value) -> Vec<(String, String)> {
    // a quantity without a parent is itself the whole section
    let value = if quantity.parent.is_empty() { section } else { &section[quantity.key] };
    if quantity.by_name {
        let is_channel = quantity.dimension == Dimension::Energy;
        // a channel that holds nothing is no row
        let named =
            value.as_object().into_iter().flatten().filter(|(_, value)| !is_channel || value.as_f64() != Some(0.0));
        let entries =
            named.map(|(name, value)| Some((quantity.name_of(&name.replace('_', " ")), written(quantity, value)?)));
        return entries.flatten().collect();
    }
    written(quantity, value).map(|value| (quantity.name.to_owned(), value)).into_iter().collect()
}

/// A value as text with its unit; none where the file has no value.
fn written(quantity: &Quantity, value: &Value) -> Option<String> {
    let number = |write: fn(f64) -> String| value.as_f64().map(write);
    let with_unit = |write: fn(f64) -> String| {
        let unit = quantity.dimension.unit().replace("^2", "²").replace("^3", "³");
        value.as_f64().map(|value| format!("{} {unit}", write(value)))
    };
    match quantity.dimension {
        Dimension::Time => number(time),
        Dimension::Duration => number(duration),
        Dimension::Force => number(|force| with_prefix(force, "N")),
        Dimension::Energy => number(|energy| with_prefix(energy, "J")),
        Dimension::Stress => number(|stress| with_prefix(stress, "Pa")),
        Dimension::Angle => number(|angle| format!("{}°", fixed(angle.to_degrees(), 2))),
        Dimension::Share => number(percent),
        Dimension::Error => number(|share| format!("{share:.1e}")),
        Dimension::Strain => number(strain),
        Dimension::Ratio => number(significant),
        Dimension::Count => value.as_u64().map(grouped),
        Dimension::Text => value.as_str().map(str::to_owned),
        Dimension::Truth => value.as_bool().map(|yes| if yes { "yes".into() } else { "no".into() }),
        Dimension::Velocity | Dimension::Place => {
            components(value).map(|text| format!("{text} {}", quantity.dimension.unit()))
        }
        Dimension::Length
        | Dimension::Area
        | Dimension::Speed
        | Dimension::AngularSpeed
        | Dimension::Mass
        | Dimension::Density
        | Dimension::Impulse
        | Dimension::Viscosity => with_unit(significant),
    }
}

/// A strain in words: longer or shorter than the rest length, in percent.
fn strain(strain: f64) -> String {
    match strain {
        s if s > 1e-9 => format!("{} too long", percent(s)),
        s if s > -1e-9 => "at its rest length".into(),
        s => format!("{} short of its rest length", percent(-s)),
    }
}

/// The components of a vector; none where it is zero.
fn components(value: &Value) -> Option<String> {
    let components: Vec<f64> = value.as_array()?.iter().filter_map(Value::as_f64).collect();
    let texts: Vec<String> = components.iter().map(|component| significant(*component)).collect();
    components.iter().any(|component| *component != 0.0).then(|| texts.join(", "))
}

/// The rows of the opening, with the ratio of the largest area to the flat area added: the summary lacks it.
fn with_share(file: &SummaryFile, mut rows: Vec<(String, String)>) -> Vec<(String, String)> {
    let opening = &file.summary.opening;
    if let (Some(area), Some(reference)) = (opening.area_max_m2, opening.reference_area_m2) {
        let reference_name = quantity_at("opening.reference_area_m2").map_or("", |(quantity, _)| quantity.name);
        let place = rows.iter().position(|(name, _)| name == reference_name).unwrap_or(rows.len());
        rows.insert(place, ("Share of the flat web".to_owned(), share_of_flat(area / reference)));
    }
    rows
}

/// A table of the named objects at `path`, one row for each object and one column for each quantity. The rows of `more`
/// follow. All forces have one unit.
fn by_name(
    file: &SummaryFile,
    heading: Heading,
    path: &str,
    more: impl FnOnce(&Scale) -> Vec<(String, Vec<String>)>,
) -> String {
    let of_each = format!("{path}.*");
    let columns: Vec<&Quantity> = quantities().filter(|row| row.parent == of_each && row.in_table).collect();
    let mut objects: BTreeMap<String, &Value> = BTreeMap::new();
    let mut values = &file.values;
    for key in path.split('.') {
        values = &values[key];
    }
    for (name, value) in values.as_object().into_iter().flatten().filter(|(_, value)| value.is_object()) {
        objects.insert(name.clone(), value);
    }
    let forces = columns.iter().filter(|column| column.dimension == Dimension::Force);
    let forces = forces.flat_map(|column| objects.values().filter_map(|object| object[column.key].as_f64()));
    let scale = Scale::fitting(forces.fold(0.0, f64::max), "N");
    let cell = |column: &Quantity, value: &Value| match column.dimension {
        Dimension::Time => value.as_f64().map(|seconds| fixed(seconds, 3)),
        Dimension::Share => value.as_f64().map(percent),
        Dimension::Force => value.as_f64().map(|force| significant(force / scale.divisor)),
        _ => value.as_f64().map(significant),
    };
    let row = |(name, object): (&String, &&Value)| {
        let cells = columns.iter().map(|column| cell(column, &object[column.key]).unwrap_or_default());
        (name.clone(), cells.collect())
    };
    let mut rows: Vec<(String, Vec<String>)> = objects.iter().map(row).collect();
    let heads: Vec<String> = columns
        .iter()
        .map(|column| match (column.dimension, column.dimension.unit()) {
            (Dimension::Force, _) => format!("{}, {}", column.head(), scale.unit),
            (_, "") => column.head(),
            (_, unit) => format!("{}, {unit}", column.head()),
        })
        .collect();
    rows.extend(more(&scale).into_iter().map(|(name, mut cells)| {
        cells.resize(columns.len(), String::new());
        (name, cells)
    }));
    grid(heading, &heads, rows)
}

/// The heading of a grid.
struct Heading {
    title: &'static str,
    /// Head of the first column, above the names.
    names: &'static str,
}

fn points(file: &SummaryFile) -> String {
    by_name(file, Heading { title: "Points", names: "Point" }, "points", |_| Vec::new())
}

fn tension(file: &SummaryFile) -> String {
    let tension = &file.summary.tension;
    // the values stand in the first column, the highest tension
    let bottom = |scale: &Scale| {
        let row = |path: &str, force: Option<f64>| {
            let force = force.map(|force| significant(force / scale.divisor)).unwrap_or_default();
            (quantity_at(path).map_or(String::new(), |(quantity, _)| quantity.name.to_owned()), vec![force])
        };
        if tension.bottom_max_n.is_none() {
            return Vec::new();
        }
        vec![row("tension.bottom_max_n", tension.bottom_max_n), row("tension.bottom_mean_n", tension.bottom_mean_n)]
    };
    by_name(file, Heading { title: "Tension per rope", names: "Ropes" }, "tension.by_class", bottom)
}

fn ropes(file: &SummaryFile) -> String {
    by_name(file, Heading { title: "Use of each rope", names: "Rope" }, "tension.by_rope", |_| Vec::new())
}

/// A table of names and values; empty text where there are no rows.
fn pairs(title: &str, rows: &[(String, String)]) -> String {
    let row = |(name, value): &(String, String)| {
        format!("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", prose(name), prose(value))
    };
    let rows: String = rows.iter().map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    format!("<section class=\"table\"><h3>{title}</h3>\n<table>\n{rows}</table></section>\n")
}

/// A table with a head and named rows; an empty cell shows a dash. Empty text where there are no rows.
fn grid(heading: Heading, heads: &[String], rows: Vec<(String, Vec<String>)>) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let heads: String = heads.iter().map(|head| format!("<th scope=\"col\">{}</th>", escape(head))).collect();
    let body: String = rows
        .iter()
        .map(|(name, cells)| {
            let cells: String = cells
                .iter()
                .map(|cell| if cell.is_empty() { NOTHING.into() } else { format!("<td>{}</td>", escape(cell)) })
                .collect();
            format!("<tr><th scope=\"row\">{}</th>{cells}</tr>\n", escape(name))
        })
        .collect();
    let Heading { title, names } = heading;
    format!(
        "<section class=\"table wide\"><h3>{title}</h3>\n<table>\n<thead><tr><th scope=\"col\">{names}</th>{heads}</tr>\
         </thead>\n<tbody>\n{body}</tbody></table></section>\n"
    )
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use serde_json::json;

    use super::*;

    #[test]
    fn null_is_a_dash_in_a_grid_and_no_row_elsewhere() {
        let tables = |summary: Value| tables(&SummaryFile::of(summary, Path::new("summary.json")).unwrap());
        let html = tables(json!({
            "opening": {"area_max_m2": null, "reference_area_m2": 16.0},
            "points": {"B": {"peak_speed_m_s": 112.0, "starts_s": null}, "tractor": null},
        }));
        assert!(html.contains("Area of the flat web") && !html.contains("Largest outline area"));
        assert!(html.contains("<th scope=\"row\">B</th><td>112</td>") && html.contains(NOTHING));
        assert!(!html.contains("<th scope=\"row\">tractor</th>"));
        assert_eq!(tables(json!({})), "");
    }
}

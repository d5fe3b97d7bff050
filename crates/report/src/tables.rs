//! The numbers of a summary as HTML tables.

use serde_json::Value;

use crate::format::{Scale, duration, escape, percent, significant, time, with_prefix};
use crate::words::is_equilibrium;

/// What stands where a scenario has no such thing.
const NOTHING: &str = "<td class=\"nothing\">–</td>";

/// All tables of a summary as one piece of HTML.
pub(crate) fn tables(summary: &Value) -> String {
    if is_equilibrium(summary) {
        return [equilibrium(summary), tension(summary), ropes(summary), model(summary)].concat();
    }
    [
        equilibrium(summary),
        opening(summary),
        points(summary),
        tension(summary),
        ropes(summary),
        mouth(summary),
        energy(summary),
        model(summary),
    ]
    .concat()
}

fn equilibrium(summary: &Value) -> String {
    let found = &summary["static"];
    if found.is_null() {
        return String::new();
    }
    let shares = |key: &str| found[key].as_f64().map(|share| format!("{share:.1e}"));
    pairs(
        "Equilibrium",
        &[
            ("Largest force out of balance", found["residual_n"].as_f64().map(|force| with_prefix(force, "N"))),
            ("It acts on", found["residual_where"].as_str().map(str::to_owned)),
            ("Over the largest tension or load", shares("residual_relative")),
            ("Asked for", shares("tolerance")),
            ("Iterations", found["iterations"].as_u64().map(|count| count.to_string())),
        ],
    )
}

fn opening(summary: &Value) -> String {
    let opening = &summary["opening"];
    let posture = &summary["posture"];
    let area = |key: &str| opening[key].as_f64().map(|area| format!("{} m²", significant(area)));
    let time_of = |section: &Value, key: &str| section[key].as_f64().map(time);
    let share = opening["area_max_m2"].as_f64().zip(opening["reference_area_m2"].as_f64());
    pairs(
        "Opening",
        &[
            ("Largest outline area", area("area_max_m2")),
            ("Time of largest outline area", time_of(opening, "area_max_time_s")),
            ("Share of the flat web", share.map(|(area, reference)| percent(area / reference))),
            ("Area of the flat web", area("reference_area_m2")),
            ("Largest vector area", area("vector_area_max_m2")),
            ("Largest silhouette", area("shadow_area_max_m2")),
            ("Time of largest silhouette", time_of(opening, "shadow_area_max_time_s")),
            ("At least 80 % open from", time_of(opening, "effective_from_s")),
            ("At least 80 % open until", time_of(opening, "effective_to_s")),
            ("At least 80 % open in all", time_of(opening, "effective_duration_s")),
            ("Largest tractors' polygon", area("tractor_area_max_m2")),
            ("Time of largest tractors' polygon", time_of(opening, "tractor_area_max_time_s")),
            ("The middle trails from", time_of(posture, "concave_from_s")),
            ("The middle trails until", time_of(posture, "concave_to_s")),
            ("The middle leads from", time_of(posture, "convex_from_s")),
        ],
    )
}

fn points(summary: &Value) -> String {
    let heads = [
        ("peak_speed_m_s", "Peak speed", "m/s"),
        ("peak_speed_time_s", "at", "s"),
        ("peak_travel_m", "Peak travel", "m"),
        ("peak_travel_time_s", "at", "s"),
        ("peak_height_m", "Peak height", "m"),
        ("starts_s", "Starts", "s"),
    ];
    let rows = entries(&summary["points"]).filter(|(_, point)| point.is_object()).map(|(name, point)| {
        let cells = heads.map(|(key, _, unit)| match (point[key].as_f64(), unit) {
            (Some(seconds), "s") => format!("{seconds:.3}"),
            (Some(value), _) => significant(value),
            (None, _) => String::new(),
        });
        (name.clone(), cells.to_vec())
    });
    grid("Points", "Point", &heads.map(|(_, title, unit)| format!("{title}, {unit}")), rows.collect())
}

fn tension(summary: &Value) -> String {
    let tension = &summary["tension"];
    let largest = tension["max_n"].as_f64().unwrap_or(0.0);
    let scale = Scale::fitting(largest, "N");
    let mut rows: Vec<(String, Vec<String>)> = Vec::new();
    let row = |name: &str, force: &Value, when: &Value, margin: &Value| {
        let force = force.as_f64().map(|force| significant(force / scale.divisor));
        let when = when.as_f64().map(|seconds| format!("{seconds:.3}"));
        let margin = margin.as_f64().map(significant);
        (name.to_owned(), [force, when, margin].map(Option::unwrap_or_default).to_vec())
    };
    for (class, values) in entries(&tension["by_class"]) {
        rows.push(row(class, &values["max_n"], &values["max_time_s"], &values["margin"]));
    }
    if tension["bottom_max_n"].is_number() {
        rows.push(row("at point B, highest", &tension["bottom_max_n"], &Value::Null, &Value::Null));
        rows.push(row("at point B, mean", &tension["bottom_mean_n"], &Value::Null, &Value::Null));
    }
    let heads = [format!("Highest, {}", scale.unit), "at, s".into(), "Margin".into()];
    grid("Tension per rope", "Ropes", &heads, rows)
}

fn ropes(summary: &Value) -> String {
    let ropes = || entries(&summary["tension"]["by_rope"]);
    let largest = ropes().flat_map(|(_, rope)| ["max_n", "strength_n"].map(|key| rope[key].as_f64().unwrap_or(0.0)));
    let scale = Scale::fitting(largest.fold(0.0, f64::max), "N");
    let rows = ropes().map(|(name, rope)| {
        let force = |key: &str| rope[key].as_f64().map(|force| significant(force / scale.divisor));
        let share = |key: &str| rope[key].as_f64().map(percent);
        let margin = rope["margin"].as_f64().map(significant);
        let cells = [
            force("min_n"),
            force("mean_n"),
            force("max_n"),
            force("strength_n"),
            share("knot_reduction"),
            share("utilisation"),
            margin,
        ];
        (name.clone(), cells.map(Option::unwrap_or_default).to_vec())
    });
    let force = |name: &str| format!("{name}, {}", scale.unit);
    let heads = [force("Least"), force("Mean"), force("Most"), force("Strength")];
    let heads = heads.into_iter().chain(["Knots take", "Used", "Margin"].map(str::to_owned));
    grid("Use of each rope", "Rope", &heads.collect::<Vec<_>>(), rows.collect())
}

fn mouth(summary: &Value) -> String {
    let (mouth, target, flight) = (&summary["mouth"], &summary["target"], &summary["flight"]);
    let degrees = |key: &str| mouth[key].as_f64().map(|tilt| format!("{:.2}°", tilt.to_degrees()));
    let share = |value: &Value| value.as_f64().map(percent);
    let metres = |value: &Value| value.as_f64().map(|length| format!("{} m", significant(length)));
    let seconds = |value: &Value| value.as_f64().map(time);
    pairs(
        "Mouth, target and flight",
        &[
            ("Tilt at the largest area", degrees("tilt_at_area_max_rad")),
            ("Largest tilt while 80 % open", degrees("tilt_max_open_rad")),
            ("Asymmetry at the largest area", share(&mouth["asymmetry_at_area_max"])),
            ("Largest asymmetry while 80 % open", share(&mouth["asymmetry_max_open"])),
            ("Target's diameter", metres(&target["diameter_m"])),
            ("Target covered at most", share(&target["coverage_max"])),
            ("Target covered from", seconds(&target["covered_from_s"])),
            ("Target covered until", seconds(&target["covered_to_s"])),
            ("Target covered in all", seconds(&target["covered_duration_s"])),
            ("Apex of the centre of mass", metres(&flight["apex_height_m"])),
            ("Time of the apex", seconds(&flight["apex_time_s"])),
            ("Hangs within 5 % of it for", seconds(&flight["hang_time_s"])),
        ],
    )
}

/// The audit of the state at the start.
pub(crate) fn stowed(summary: &Value) -> String {
    let stowed = &summary["stowed"];
    let metres = |key: &str| stowed[key].as_f64().map(|length| format!("{} m", significant(length)));
    let stretch = stowed["longest_stretch"].as_f64().map(|stretch| match stretch {
        s if s > 1e-9 => format!("{} too long", percent(s)),
        s if s > -1e-9 => "at its rest length".into(),
        s => format!("{} short of its rest length", percent(-s)),
    });
    pairs(
        "State at the start",
        &[
            ("Stretched members", stowed["stretched"].as_u64().map(grouped)),
            ("Nearest to stretched", stowed["longest_stretch_where"].as_str().map(str::to_owned)),
            ("which is", stretch),
            ("Stored energy", stowed["stored_energy_j"].as_f64().map(|energy| with_prefix(energy, "J"))),
            ("Packed radius", metres("packed_radius_m")),
            ("Packed height", metres("packed_height_m")),
            ("Density of the web", stowed["density_kg_m3"].as_f64().map(|d| format!("{} kg/m³", significant(d)))),
            ("of it solid", stowed["solid_fraction"].as_f64().map(percent)),
            ("Closest approach of untied ropes", metres("closest_approach_m")),
            ("between", stowed["closest_approach_where"].as_str().map(str::to_owned)),
            ("Pairs nearer than a diameter", stowed["nearer_than_a_diameter"].as_u64().map(grouped)),
        ],
    )
}

fn energy(summary: &Value) -> String {
    let energy = &summary["energy"];
    let joules = |value: &Value| value.as_f64().map(|value| with_prefix(value, "J"));
    let mut rows = vec![
        ("Total at the start".to_owned(), joules(&energy["initial_j"])),
        ("Total at the end".to_owned(), joules(&energy["final_j"])),
    ];
    for (channel, value) in entries(&energy["channels"]) {
        rows.push((channel.replace('_', " "), joules(value)));
    }
    rows.push(("Residual".to_owned(), joules(&energy["residual_j"])));
    rows.push(("Closure".to_owned(), energy["closure"].as_f64().map(percent)));
    rows.push(("Closure of the web".to_owned(), energy["closure_web"].as_f64().map(percent)));
    let rows: Vec<(&str, Option<String>)> = rows.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
    pairs("Energy", &rows)
}

fn model(summary: &Value) -> String {
    let (model, step) = (&summary["model"], &summary["step"]);
    let number = |value: &Value, unit: &str| value.as_f64().map(|value| format!("{} {unit}", significant(value)));
    let count = |value: &Value| value.as_u64().map(grouped);
    pairs(
        "Model and step",
        &[
            ("Nodes", count(&model["nodes"])),
            ("Segments", count(&model["segments"])),
            ("Rope length", number(&model["rope_length_m"], "m")),
            ("Mass of the web", number(&model["web_mass_kg"], "kg")),
            ("Mass of the tractors", number(&model["tractor_mass_kg"], "kg")),
            ("Density of the medium", number(&summary["air"]["density_kg_m3"], "kg/m³")),
            ("Wind at the muzzle at the start", wind(&summary["air"]["wind_m_s"])),
            ("Time step", step["dt_s"].as_f64().map(duration)),
            ("Steps", count(&step["count"])),
            ("Limited by", step["limited_by"].as_str().map(str::to_owned)),
            ("Larger with", step["lifted_by"].as_str().map(str::to_owned)),
            ("Computed in", summary["wall_time_s"].as_f64().map(duration)),
        ],
    )
}

/// The components of a wind that blows.
fn wind(components: &Value) -> Option<String> {
    let components: Vec<f64> = components.as_array()?.iter().filter_map(Value::as_f64).collect();
    let told: Vec<String> = components.iter().map(|along| significant(*along)).collect();
    components.iter().any(|along| *along != 0.0).then(|| format!("{} m/s", told.join(", ")))
}

/// The entries of an object, in the order of the file; none where there is no object.
fn entries(value: &Value) -> impl Iterator<Item = (&String, &Value)> {
    value.as_object().into_iter().flatten()
}

/// Thin spaces between the thousands.
pub(crate) fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// A table of names and values. Rows without a value are left out, and so is a table without rows.
fn pairs(title: &str, rows: &[(&str, Option<String>)]) -> String {
    let rows: String = rows
        .iter()
        .filter_map(|(name, value)| {
            let value = escape(value.as_ref()?);
            Some(format!("<tr><th scope=\"row\">{}</th><td>{value}</td></tr>\n", escape(name)))
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    format!("<section class=\"table\"><h3>{title}</h3>\n<table>\n{rows}</table></section>\n")
}

/// A table with a head and a row a thing; an empty cell is marked. Without rows there is no table.
fn grid(title: &str, thing: &str, heads: &[String], rows: Vec<(String, Vec<String>)>) -> String {
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
    format!(
        "<section class=\"table wide\"><h3>{title}</h3>\n<table>\n<thead><tr><th scope=\"col\">{thing}</th>{heads}</tr>\
         </thead>\n<tbody>\n{body}</tbody></table></section>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1\u{202f}000", "1\u{202f}234\u{202f}567"]);
    }

    #[test]
    fn null_is_a_dash_in_a_grid_and_no_row_elsewhere() {
        let html = tables(&json!({
            "opening": {"area_max_m2": null, "reference_area_m2": 16.0},
            "points": {"B": {"peak_speed_m_s": 112.0, "starts_s": null}, "tractor": null},
        }));
        assert!(html.contains("Area of the flat web") && !html.contains("Largest outline area"));
        assert!(html.contains("<th scope=\"row\">B</th><td>112</td>") && html.contains(NOTHING));
        assert!(!html.contains("<th scope=\"row\">tractor</th>"));
        assert_eq!(tables(&json!({})), "");
    }
}

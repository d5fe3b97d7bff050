//! Rules that the schema cannot express: how the sections of a scenario must fit each other.

use serde::Deserialize;

use crate::air_rules;
use crate::diagnostic::Diagnostic;
use crate::interval::NonNegative;
use crate::nearest::nearest;
use crate::path::Path;
use crate::quantity::Acceleration;
use crate::schema::{keys_at, keys_of};
use crate::selection::Selection;
use crate::tables::{ropes, table_at};
use crate::tree::{Node, Table, Value};
use crate::written::Written;

/// Every fault of `written` by these rules.
pub(crate) fn check(written: &Written) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    check_name_of_default_rope(written, &mut found);
    check_assigned_ropes(written, &mut found);
    check_knot_reduction(written, &mut found);
    check_breaking(written, &mut found);
    check_segments(written, &mut found);
    check_polygon(written, &mut found);
    check_canopies(written, &mut found);
    check_tractors(written, &mut found);
    check_spread(written, &mut found);
    check_run_and_statics(written, &mut found);
    check_orbit(written, &mut found);
    check_loads_and_drives(written, &mut found);
    check_stitches(written, &mut found);
    air_rules::check(written, &mut found);
    found
}

/// Whether a name has only characters that are safe in the header of a table and in a script.
pub fn is_plain(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || [' ', '_', '-', '.'].contains(&c))
}

/// Message and help where `name` is not one of `[ropes]`; `None` where it is.
pub(crate) fn unknown_rope(written: &Written, name: &str) -> Option<(String, String)> {
    let ropes: Vec<&str> = table_at(written, "ropes").into_iter().flat_map(Table::keys).collect();
    if ropes.contains(&name) {
        return None;
    }
    let help = match (nearest(name, &ropes), ropes.is_empty()) {
        (Some(near), _) => format!("did you mean {near:?}?"),
        (None, true) => format!("define it in [ropes.{name}]"),
        (None, false) => format!("known ropes: {}", ropes.join(", ")),
    };
    Some((format!("unknown rope {name:?}"), help))
}

fn check_name_of_default_rope(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::parse("ropes.rope");
    if written.tree.get(&path).is_some() {
        let message = "`rope` is the name of the default rope, [rope]";
        found.push(written.at_key(&path, message).with_help("choose another name"));
    }
}

fn check_assigned_ropes(written: &Written, found: &mut Vec<Diagnostic>) {
    for entry in table_at(written, "assign").into_iter().flat_map(|assign| &assign.0) {
        if let Some((message, help)) = entry.node.value.as_text().and_then(|name| unknown_rope(written, name)) {
            found.push(written.at_value(&Path::default().key("assign").key(&entry.key), message).with_help(help));
        }
    }
}

/// A spread turns the flight at an axial speed: without one it has no effect.
fn check_spread(written: &Written, found: &mut Vec<Diagnostic>) {
    let launch = Path::parse("launch");
    let given = |path: &Path| written.tree.get(path).is_some();
    let tractors = written.tree.get(&Path::parse("tractors")).and_then(|node| match &node.value {
        Value::Array(tractors) => Some(tractors.len()),
        _ => None,
    });
    let own = (0..tractors.unwrap_or(0)).map(|index| Path::parse("tractors").index(index));
    for table in [launch.clone()].into_iter().chain(own) {
        let spread = table.key("spread");
        if given(&spread) && !given(&table.key("axial_speed")) && !given(&launch.key("axial_speed")) {
            let message = "a spread turns the flight at `axial_speed`, which is not given";
            found.push(written.at_key(&spread, message));
        }
    }
}

fn check_breaking(written: &Written, found: &mut Vec<Diagnostic>) {
    for rope in ropes(written) {
        let given = |path: &Path| written.tree.get(path).is_some();
        let breaking = rope.key("breaking");
        let said = [rope.key("strength"), breaking.key("load"), breaking.key("strain")];
        if given(&breaking) && !said.iter().any(given) {
            let help = format!("give `{}`, `{}` or `{}`", said[0], said[1], said[2]);
            found.push(
                written
                    .at_value(&breaking, "expected a load or a strain at which this rope breaks, found none")
                    .with_help(help),
            );
        }
    }
}

fn check_knot_reduction(written: &Written, found: &mut Vec<Diagnostic>) {
    for rope in ropes(written) {
        let given = |key: &str| written.tree.get(&rope.key(key)).is_some();
        let breaks_at_a_load = written.tree.get(&rope.key("breaking").key("load")).is_some();
        if given("knot_reduction") && !given("strength") && !breaks_at_a_load {
            let message = "a reduction by knots has no effect without a strength";
            found.push(
                written.at_key(&rope.key("knot_reduction"), message).with_help(format!("give `{rope}.strength`")),
            );
        }
    }
}

fn check_segments(written: &Written, found: &mut Vec<Diagnostic>) {
    let by_mesh = Path::parse("web.square.segments_per_mesh");
    let by_length = Path::parse("solve.segment_length");
    if written.tree.get(&by_mesh).is_some() && written.tree.get(&by_length).is_some() {
        let message = format!("expected only one of `{by_mesh}` and `{by_length}`");
        found.push(written.at_key(&by_length, message));
    }
}

fn check_polygon(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::parse("web.polygon");
    let Some(polygon) = written.tree.get(&path).and_then(|node| node.value.as_table()) else { return };
    if polygon.get("side").is_none() && polygon.get("diameter").is_none() {
        let message = "missing key `side` or `diameter`";
        found.push(
            written
                .at_value(&path, message)
                .with_help("give the length of a side, or the diameter of the circle through the corners"),
        );
    }
}

fn check_canopies(written: &Written, found: &mut Vec<Diagnostic>) {
    let Some(web) = table_at(written, "web") else { return };
    // a misspelt kind is reported as such
    let ropes_only = keys_at("web").into_iter().any(|kind| kind != "space" && web.get(kind).is_some());
    if web.get("space").is_some() || !ropes_only {
        return;
    }
    for key in ["canopy", "payload", "sensor"] {
        let path = Path::default().key(key);
        if written.tree.get(&path).is_some() {
            let message = format!("only a space web has a {key}");
            found.push(written.at_key(&path, message).with_help(format!("leave [{key}] out, or choose [web.space]")));
        }
    }
}

fn check_orbit(written: &Written, found: &mut Vec<Diagnostic>) {
    let Some(environment) = table_at(written, "environment").filter(|table| table.get("orbit").is_some()) else {
        return;
    };
    let path = Path::default().key("environment");
    // a gravity of 0 is allowed: resolved scenarios state it
    let is_not_zero = |gravity: Acceleration<NonNegative>| gravity.si() != 0.0;
    let is_in_effect = |key: &str, node: &Node| match key {
        "gravity" => Acceleration::deserialize(node.value.to_toml()).is_ok_and(is_not_zero),
        _ => true,
    };
    for (key, what) in [("air", "air"), ("wind", "wind"), ("ground", "ground"), ("gravity", "uniform gravity")] {
        if environment.get(key).is_some_and(|node| is_in_effect(key, node)) {
            let message = format!("an orbit excludes {what}");
            found.push(written.at_key(&path.key(key), message).with_help("leave out this key, or [environment.orbit]"));
        }
    }
}

fn check_run_and_statics(written: &Written, found: &mut Vec<Diagnostic>) {
    let value = |path: &str| written.tree.get(&Path::parse(path)).map(|node| &node.value);
    let then_run = matches!(value("solve.static.then_run"), Some(Value::Boolean(true)));
    if then_run && value("solve.duration").is_none() {
        let message = "missing key `duration`";
        let help = "solve.static.then_run asks for a run in time: give its duration";
        found.push(written.at_value(&Path::parse("solve"), message).with_help(help));
    }
    if value("solve.static").is_none() || then_run {
        return;
    }
    let why = "there is no run in time: solve.static alone asks for the equilibrium";
    let help = "add solve.static.then_run = true";
    if let Some(drives) = table_at(written, "drive").filter(|drives| !drives.0.is_empty()) {
        let message = format!("the drive has no effect, as {why}");
        let first = drives.keys().next().unwrap_or_default();
        found.push(written.at_key(&Path::default().key("drive").key(first), message).with_help(help));
    }
    for (path, load) in named_tables(written, "load") {
        if load.get("ramp").is_some() {
            let message = format!("the ramp has no effect, as {why}");
            found.push(written.at_key(&path.key("ramp"), message).with_help(help));
        }
    }
}

/// The tables with names of the user in the table at `of`, each with its path.
fn named_tables<'a>(written: &'a Written, of: &str) -> Vec<(Path, &'a Table)> {
    let named = table_at(written, of).into_iter().flat_map(|table| &table.0);
    let tables = named.filter_map(|entry| Some((Path::parse(of).key(&entry.key), entry.node.value.as_table()?)));
    tables.collect()
}

fn check_loads_and_drives(written: &Written, found: &mut Vec<Diagnostic>) {
    let known = keys_of::<Selection>();
    let tables = ["load", "drive", "stow.prescribed.drive"].map(|of| named_tables(written, of));
    for (path, table) in tables.into_iter().flatten() {
        let selectors = known.iter().filter(|key| table.get(key).is_some());
        match (table.get("force_per_length"), table.get("class")) {
            (Some(_), _) => {
                for key in selectors {
                    let message = format!("`force_per_length` acts on the ropes of a class, not on `{key}`");
                    found.push(written.at_key(&path.key(key), message).with_help("give `force` instead"));
                }
            }
            (None, Some(_)) => {
                let message = "`force` acts on nodes, not on a class";
                found.push(written.at_key(&path.key("class"), message).with_help("give `force_per_length` instead"));
            }
            (None, None) if selectors.count() == 0 => {
                let help = format!(
                    "give one of {}",
                    known.iter().map(|key| format!("`{path}.{key}`")).collect::<Vec<_>>().join(", ")
                );
                found.push(written.at_value(&path, "no nodes are named for it to act on").with_help(help));
            }
            (None, None) => {}
        }
    }
}

fn check_stitches(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::default().key("stitches");
    let rows = written.tree.get(&path).and_then(|node| node.value.as_array()).unwrap_or_default();
    for (index, row) in rows.iter().enumerate() {
        let Some(row) = row.value.as_table().filter(|row| row.get("pairs").is_some()) else { continue };
        for key in ["reach", "every"].into_iter().filter(|key| row.get(key).is_some()) {
            let message = format!("expected only one of `pairs` and `{key}`: a `{key}` belongs to a `class`");
            found.push(written.at_key(&path.index(index).key(key), message));
        }
    }
}

fn check_tractors(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::default().key("tractors");
    let Some(tractors) = written.tree.get(&path).and_then(|node| node.value.as_array()) else { return };
    let shapes = keys_at("tractor");
    let mut seen = Vec::new();
    for (index, tractor) in tractors.iter().enumerate() {
        let Some(tractor) = tractor.value.as_table() else { continue };
        let here = path.index(index);
        if let Some(Value::Integer(corner)) = tractor.get("corner").map(|node| &node.value) {
            if seen.contains(corner) {
                let message = format!("corner {corner} already has an entry in [[tractors]]");
                found.push(written.at_value(&here.key("corner"), message));
            }
            seen.push(*corner);
        }
        let bodies: Vec<&str> = tractor.keys().filter(|key| shapes.contains(key)).collect();
        if let [first, other, ..] = bodies[..] {
            let message = format!("expected only one of `{first}` and `{other}`");
            found.push(written.at_key(&here.key(other), message));
        }
        if bodies.is_empty() && table_at(written, "tractor").is_none() {
            let help = "add [tractor.cylinder] or [tractor.particle] for all, or [tractors.cylinder] for this one";
            found.push(written.at_value(&here, "there is no tractor at this corner").with_help(help));
        }
    }
}

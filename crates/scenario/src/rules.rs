//! What the schema cannot say: how the parts of a scenario must fit each other.

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

/// Everything in `written` that does not fit the rest of it.
pub(crate) fn check(written: &Written) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    the_default_rope_has_its_name_alone(written, &mut found);
    assigned_ropes_exist(written, &mut found);
    knots_weaken_a_strength(written, &mut found);
    what_breaks_has_a_strength(written, &mut found);
    segments_are_cut_in_one_way(written, &mut found);
    a_polygon_has_a_size(written, &mut found);
    canopies_belong_to_the_space_web(written, &mut found);
    tractors_are_told_apart(written, &mut found);
    a_run_has_an_end(written, &mut found);
    an_orbit_is_empty(written, &mut found);
    what_is_loaded_or_driven_is_named(written, &mut found);
    named_stitches_are_all_there_are(written, &mut found);
    air_rules::check(written, &mut found);
    found
}

/// Whether a name can stand in the header of a table and in a script.
pub fn is_plain(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || [' ', '_', '-', '.'].contains(&c))
}

/// That `name` is one of `[ropes]`; says so at `path` where it is not.
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

fn the_default_rope_has_its_name_alone(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::parse("ropes.rope");
    if written.tree.get(&path).is_some() {
        let message = "`rope` is what the default rope, [rope], is called";
        found.push(written.at_key(&path, message).with_help("choose another name"));
    }
}

fn assigned_ropes_exist(written: &Written, found: &mut Vec<Diagnostic>) {
    for entry in table_at(written, "assign").into_iter().flat_map(|assign| &assign.0) {
        if let Some((message, help)) = entry.node.value.as_text().and_then(|name| unknown_rope(written, name)) {
            found.push(written.at_value(&Path::default().key("assign").key(&entry.key), message).with_help(help));
        }
    }
}

fn what_breaks_has_a_strength(written: &Written, found: &mut Vec<Diagnostic>) {
    for rope in ropes(written) {
        let given = |path: &Path| written.tree.get(path).is_some();
        let breaking = rope.key("breaking");
        let said = [rope.key("strength"), breaking.key("load"), breaking.key("strain")];
        if given(&breaking) && !said.iter().any(given) {
            let help = format!("give `{}`, `{}` or `{}`", said[0], said[1], said[2]);
            found.push(written.at_value(&breaking, "nothing says at what this rope breaks").with_help(help));
        }
    }
}

fn knots_weaken_a_strength(written: &Written, found: &mut Vec<Diagnostic>) {
    for rope in ropes(written) {
        let given = |key: &str| written.tree.get(&rope.key(key)).is_some();
        let breaks_at_a_load = written.tree.get(&rope.key("breaking").key("load")).is_some();
        if given("knot_reduction") && !given("strength") && !breaks_at_a_load {
            let message = "a reduction by knots says nothing without a strength";
            found.push(
                written.at_key(&rope.key("knot_reduction"), message).with_help(format!("give `{rope}.strength`")),
            );
        }
    }
}

fn segments_are_cut_in_one_way(written: &Written, found: &mut Vec<Diagnostic>) {
    let by_mesh = Path::parse("web.square.segments_per_mesh");
    let by_length = Path::parse("solve.segment_length");
    if written.tree.get(&by_mesh).is_some() && written.tree.get(&by_length).is_some() {
        let message = format!("expected only one of `{by_mesh}` and `{by_length}`");
        found.push(written.at_key(&by_length, message));
    }
}

fn a_polygon_has_a_size(written: &Written, found: &mut Vec<Diagnostic>) {
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

fn canopies_belong_to_the_space_web(written: &Written, found: &mut Vec<Diagnostic>) {
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

fn an_orbit_is_empty(written: &Written, found: &mut Vec<Diagnostic>) {
    let Some(environment) = table_at(written, "environment").filter(|table| table.get("orbit").is_some()) else {
        return;
    };
    let path = Path::default().key("environment");
    // none at all may be written, as it is where defaults are written out
    let pulls = |gravity: Acceleration<NonNegative>| gravity.si() != 0.0;
    let is_there = |key: &str, node: &Node| match key {
        "gravity" => Acceleration::deserialize(node.value.to_toml()).is_ok_and(pulls),
        _ => true,
    };
    for (key, what) in [("air", "air"), ("wind", "wind"), ("ground", "ground"), ("gravity", "other gravity")] {
        if environment.get(key).is_some_and(|node| is_there(key, node)) {
            let message = format!("beside an orbit there is no {what}");
            found.push(written.at_key(&path.key(key), message).with_help("leave it out, or [environment.orbit]"));
        }
    }
}

fn a_run_has_an_end(written: &Written, found: &mut Vec<Diagnostic>) {
    let value = |path: &str| written.tree.get(&Path::parse(path)).map(|node| &node.value);
    let then_run = matches!(value("solve.static.then_run"), Some(Value::Boolean(true)));
    if then_run && value("solve.duration").is_none() {
        let message = "missing key `duration`";
        let help = "a run in time begins from the equilibrium, as solve.static.then_run says: how long is it?";
        found.push(written.at_value(&Path::parse("solve"), message).with_help(help));
    }
    if value("solve.static").is_none() || then_run {
        return;
    }
    let still = "there is no run in time: solve.static alone asks for the equilibrium";
    let help = "add solve.static.then_run = true";
    if let Some(drives) = table_at(written, "drive").filter(|drives| !drives.0.is_empty()) {
        let message = format!("nothing is moved, as {still}");
        let first = drives.keys().next().unwrap_or_default();
        found.push(written.at_key(&Path::default().key("drive").key(first), message).with_help(help));
    }
    for (path, load) in named_tables(written, "load") {
        if load.get("ramp").is_some() {
            let message = format!("the load is never brought up, as {still}");
            found.push(written.at_key(&path.key("ramp"), message).with_help(help));
        }
    }
}

/// The tables that a user has named in the table `of`, each with its path.
fn named_tables<'a>(written: &'a Written, of: &str) -> Vec<(Path, &'a Table)> {
    let named = table_at(written, of).into_iter().flat_map(|table| &table.0);
    let tables = named.filter_map(|entry| Some((Path::parse(of).key(&entry.key), entry.node.value.as_table()?)));
    tables.collect()
}

fn what_is_loaded_or_driven_is_named(written: &Written, found: &mut Vec<Diagnostic>) {
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
                found.push(written.at_value(&path, "nothing is named on which it acts").with_help(help));
            }
            (None, None) => {}
        }
    }
}

fn named_stitches_are_all_there_are(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::default().key("stitches");
    let rows = written.tree.get(&path).and_then(|node| node.value.as_array()).unwrap_or_default();
    for (index, row) in rows.iter().enumerate() {
        let Some(row) = row.value.as_table().filter(|row| row.get("pairs").is_some()) else { continue };
        for key in ["reach", "every"].into_iter().filter(|key| row.get(key).is_some()) {
            let message = format!("expected only one of `pairs` and `{key}`, which goes with a `class`");
            found.push(written.at_key(&path.index(index).key(key), message));
        }
    }
}

fn tractors_are_told_apart(written: &Written, found: &mut Vec<Diagnostic>) {
    let path = Path::default().key("tractors");
    let Some(tractors) = written.tree.get(&path).and_then(|node| node.value.as_array()) else { return };
    let shapes = keys_at("tractor");
    let mut seen = Vec::new();
    for (index, tractor) in tractors.iter().enumerate() {
        let Some(tractor) = tractor.value.as_table() else { continue };
        let here = path.index(index);
        if let Some(Value::Integer(corner)) = tractor.get("corner").map(|node| &node.value) {
            if seen.contains(corner) {
                let message = format!("corner {corner} has an entry in [[tractors]] already");
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

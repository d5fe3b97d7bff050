//! Notes on the lists of a graph: rows that say a thing twice, nodes that nearly coincide, velocities that do not act.

use std::collections::BTreeMap;

use netcast_scenario::{GraphFiles, Scenario};

/// Two knots of a rope that lie nearer than this share of its segments' length are one knot, more likely than two.
pub const NEARLY_ONE: f64 = 1e-3;

/// The most rows that a note names.
const NAMED: usize = 3;

/// The notes on the files of a graph.
pub fn notes(scenario: &Scenario, files: &GraphFiles) -> Vec<String> {
    [twice(files), velocities_of_fixed_nodes(files), velocities_of_driven_nodes(scenario, files)]
        .into_iter()
        .flatten()
        .collect()
}

/// Ropes between the same two nodes of one class: two ropes side by side, or one that is listed twice.
fn twice(files: &GraphFiles) -> Option<String> {
    let mut first: BTreeMap<(usize, usize, String), usize> = BTreeMap::new();
    let mut pairs = Vec::new();
    for row in &files.ropes {
        let class = row.class.as_ref().map_or(String::new(), |class| class.name().to_owned());
        let line = *first.entry((row.a.min(row.b), row.a.max(row.b), class)).or_insert(row.line);
        if line != row.line {
            pairs.push(format!("lines {line} and {}", row.line));
        }
    }
    let what = "web.graph.ropes lists ropes of one class between the same two nodes";
    (!pairs.is_empty()).then(|| format!("{what}, which pull side by side: {}", some_of(&pairs)))
}

/// Fixed nodes with a velocity.
fn velocities_of_fixed_nodes(files: &GraphFiles) -> Option<String> {
    let fixed = files.nodes.iter().filter(|row| row.fixed && row.velocity_m_s != [0.0; 3]);
    let names: Vec<String> = fixed.map(|row| row.id.clone()).collect();
    (!names.is_empty()).then(|| format!("the velocity of fixed nodes does not act: {}", some_of(&names)))
}

/// Nodes with a velocity, or fixed ones, that drives name by their ids.
fn velocities_of_driven_nodes(scenario: &Scenario, files: &GraphFiles) -> Option<String> {
    let driven = |id: &String| scenario.drive.values().any(|drive| drive.on.nodes.contains(id));
    let rows = files.nodes.iter().filter(|row| (row.fixed || row.velocity_m_s != [0.0; 3]) && driven(&row.id));
    let names: Vec<String> = rows.map(|row| row.id.clone()).collect();
    let what = "drives move nodes that web.graph.nodes fixes or gives a velocity, which does not act";
    (!names.is_empty()).then(|| format!("{what}: {}", some_of(&names)))
}

/// The first few of a list, and how many more.
fn some_of(all: &[String]) -> String {
    let more = all.len().saturating_sub(NAMED);
    let named = all[..all.len().min(NAMED)].join(", ");
    if more == 0 { named } else { format!("{named}, and {more} more") }
}

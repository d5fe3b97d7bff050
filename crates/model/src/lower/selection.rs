//! Selections of nodes: for loads, drives and ties, and the nodes that are held.

use netcast_scenario::path::Path;
use netcast_scenario::{Diagnostic, Diagnostics, Document, Selection, nearest};
use netcast_webs::CutWeb;

use super::draft::Draft;

/// The nodes of a selection, each once, ascending.
///
/// # Errors
/// Names that the web does not have, each at its key below `path`.
pub fn resolve(
    selection: &Selection,
    document: &Document,
    cut: &CutWeb,
    path: &Path,
) -> Result<Vec<usize>, Diagnostics> {
    let (web, mut found) = (&cut.web, Vec::new());
    let mut nodes = Vec::new();
    for (key, asked, named) in
        [("corners", selection.corners, &web.corners), ("tractors", selection.tractors, &web.tractors)]
    {
        if asked && named.is_empty() {
            found.push(document.diagnostic(&path.key(key).to_string(), format!("the web has no {key}")));
        }
        nodes.extend(named.iter().filter(|_| asked));
    }
    for (index, id) in selection.nodes.iter().enumerate() {
        match web.knot_named(id) {
            Some(knot) => nodes.push(knot),
            None => found.push(unknown_knot(document, &path.key("nodes").index(index).to_string(), id, cut)),
        }
    }
    for (index, name) in selection.points.iter().enumerate() {
        match web.points.get(name) {
            Some(&site) => nodes.push(cut.node_of(site)),
            None => {
                let path = path.key("points").index(index).to_string();
                let near = nearest(name, web.points.keys()).map(|near| format!("did you mean {near:?}?"));
                let diagnostic = document.diagnostic(&path, format!("unknown feature point {name:?}"));
                found.push(diagnostic.with_help_if(near));
            }
        }
    }
    Diagnostics::fail_if_any(found)?;
    nodes.sort_unstable();
    nodes.dedup();
    Ok(nodes)
}

/// Finds the held nodes, from `[hold]` and from a graph's file.
///
/// # Errors
/// An unknown node, or a node of a rigid body.
pub fn hold(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, canopies, parts, .. } = draft;
    let (bound, held) = (&canopies.bound, &mut parts.held);
    *held = vec![false; cut.nodes.len()];
    for (node, row) in document.files.graph.iter().flat_map(|g| &g.nodes).enumerate() {
        held[node] = row.fixed;
    }
    let Some(hold) = &scenario.hold else { return Ok(()) };
    let mut found = Vec::new();
    if hold.corners {
        if cut.web.corners.is_empty() {
            found.push(document.diagnostic("hold.corners", "the web names no corners"));
        }
        for &corner in &cut.web.corners {
            held[corner] = true;
        }
    }
    for (list, index, id) in [("nodes", &hold.nodes), ("clamped", &hold.clamped)]
        .into_iter()
        .flat_map(|(list, ids)| ids.iter().enumerate().map(move |(index, id)| (list, index, id)))
    {
        let is_bound = |knot: usize| bound.iter().flat_map(|bound| &bound.body.ties).any(|tie| tie.node == knot);
        match cut.web.knot_named(id) {
            Some(knot) if is_bound(knot) => {
                let message = format!("{id:?} is a part of a rigid body, which cannot be held at one of its points");
                found.push(document.diagnostic(&format!("hold.{list}.{index}"), message));
            }
            Some(knot) => held[knot] = true,
            // the stage of the clamps reports those that it does not know
            None if list == "clamped" => {}
            None => found.push(unknown_knot(document, &format!("hold.nodes.{index}"), id, cut)),
        }
    }
    Diagnostics::fail_if_any(found)
}

/// The diagnostic that there is no knot `id`, with the nearest name as help.
pub fn unknown_knot(document: &Document, path: &str, id: &str, cut: &CutWeb) -> Diagnostic {
    let known: Vec<&str> = cut.web.knots.iter().map(|k| &k.name[..]).collect();
    let diagnostic = document.diagnostic(path, format!("unknown node {id:?}"));
    match nearest(id, &known) {
        Some(near) => diagnostic.with_help(format!("did you mean {near:?}?")),
        None => diagnostic.with_help("`netcast stow --write FILE.csv` lists the names of all nodes"),
    }
}

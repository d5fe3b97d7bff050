//! Break ties and stitches: segments of two classes of their own, added to those of the web.
//!
//! They have no mass, are not ropes and are not in the drawing: they change neither the bill of the web nor its pieces. A
//! node that is tied to its place is tied to a new, held node there.

use std::cmp::{Ordering, Reverse};
use std::collections::{BTreeSet, BinaryHeap};

use glam::DVec3;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::state::State;
use netcast_dynamics::system::{Segment, SystemParts};
use netcast_scenario::interval::Positive;
use netcast_scenario::path::Path;
use netcast_scenario::quantity::{Force, Length, Number};
use netcast_scenario::{Diagnostic, Diagnostics, Document, Scenario, Stitching};
use netcast_webs::{Class, CutWeb};

use super::draft::Draft;
use super::loads::unknown_class;
use super::members::{Group, Member, Part};
use super::selection::{resolve, unknown_knot};

/// Least default length of a thread, m.
const SHORTEST: f64 = 0.01;

/// Share of its length by which a thread may be stretched at the start: rounding.
const ROUNDING: f64 = 1e-9;

/// Adds the ties and stitches of a scenario to the stowed web.
///
/// # Errors
/// Unknown names, a tie between held nodes, a thread shorter than its span.
pub fn tie(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, members, groups, parts, state, .. } = draft;
    let mut found = Vec::new();
    let mut rests = parts.held.clone();
    for drive in &parts.drives {
        rests[drive.node] = false;
    }
    let ties = break_ties(document, cut, scenario, &mut found);
    let stitches = stitches(document, cut, scenario, groups, &state.position, &mut found);
    for (class, threads) in [(Class::Tie, ties), (Class::Stitch, stitches)] {
        let mut weakest = f64::INFINITY;
        for thread in &threads {
            let node = thread.ends[0];
            if thread.ends.iter().all(|&end| rests[end]) {
                let message = format!("{} is held already: nothing pulls at this tie", cut.node_label(node));
                found.push(document.diagnostic(&thread.path, message));
                continue;
            }
            let ends = if thread.ends == [node; 2] { [node, add_anchor(node, parts, state)] } else { thread.ends };
            match thread.segment(ends, &state.position, groups.len()) {
                Ok(segment) => {
                    parts.segments.push(segment);
                    members.push(Member { segment, part: thread.part });
                    weakest = weakest.min(segment.breaking.load);
                }
                Err(why) => found.push(document.diagnostic(&thread.path, why)),
            }
        }
        if !threads.is_empty() {
            parts.laws.push(Law::Linear);
            groups.push(Group::of_threads(class, Breaking { load: weakest, ..Breaking::NEVER }));
        }
    }
    Diagnostics::fail_if_any(found)
}

/// Adds a held node without mass at the place of `node`, and returns it.
fn add_anchor(node: usize, parts: &mut SystemParts, state: &mut State) -> usize {
    parts.mass.push(0.0);
    parts.held.push(true);
    parts.tractor.push(false);
    state.position.push(state.position[node]);
    state.velocity.push(DVec3::ZERO);
    parts.mass.len() - 1
}

/// Load and strain at which a thread breaks.
#[derive(Clone, Copy)]
struct Rupture {
    /// N.
    load: f64,
    strain: f64,
}

impl Rupture {
    fn new(load: Force<Positive>, strain: Number<Positive>) -> Rupture {
        Rupture { load: load.si(), strain: strain.si() }
    }
}

/// A break tie or a stitch.
struct Thread {
    part: Part,
    /// Its path in the scenario.
    path: String,
    /// The nodes that it joins; twice the same for a node that is tied to its place.
    ends: [usize; 2],
    rupture: Rupture,
    /// Its length, m; by default that of its span.
    length: Option<f64>,
}

impl Thread {
    fn new(part: Part, path: &Path, ends: [usize; 2], rupture: Rupture, length: Option<Length<Positive>>) -> Thread {
        let length = length.map(|length| length.si());
        Thread { part, path: path.to_string(), ends, rupture, length }
    }

    /// The segment between `ends`; `position` of all nodes in m.
    ///
    /// # Errors
    /// A span longer than the thread, in words.
    fn segment(&self, ends: [usize; 2], position: &[DVec3], group: usize) -> Result<Segment, String> {
        let span = position[ends[0]].distance(position[ends[1]]);
        let rest_length = self.length.unwrap_or(span.max(SHORTEST));
        if span > rest_length * (1.0 + ROUNDING) {
            return Err(format!("its ends lie {span:.4} m apart, more than its length, {rest_length} m"));
        }
        let Rupture { load, strain } = self.rupture;
        let stiffness = load / (strain * rest_length);
        let breaking = Breaking { load, ..Breaking::NEVER };
        Ok(Segment { ends, rest_length, stiffness, damping: 0.0, group, breaking })
    }
}

/// The break ties in the order of the scenario.
fn break_ties(document: &Document, cut: &CutWeb, scenario: &Scenario, found: &mut Vec<Diagnostic>) -> Vec<Thread> {
    let mut ties = Vec::new();
    for (index, tie) in scenario.break_ties.iter().enumerate() {
        let path = Path::default().key("break_ties").index(index);
        let mut spans = match resolve(&tie.on, document, cut, &path) {
            Ok(nodes) => nodes.into_iter().map(|node| [node; 2]).collect(),
            Err(Diagnostics(wrong)) => {
                found.extend(wrong);
                Vec::new()
            }
        };
        spans.extend(pairs(document, cut, &path, &tie.pairs, found));
        if spans.is_empty() && found.is_empty() {
            let help = "give one of `corners`, `tractors`, `nodes`, `points`, `pairs`";
            found.push(document.diagnostic(&path.to_string(), "no node is named for this tie").with_help(help));
        }
        let rupture = Rupture::new(tie.breaking_load, tie.breaking_strain);
        for ends in spans {
            let part = Part::Tie { number: ties.len() };
            ties.push(Thread::new(part, &path, ends, rupture, tie.length));
        }
    }
    ties
}

/// The stitches of a scenario, row by row.
fn stitches(
    document: &Document,
    cut: &CutWeb,
    scenario: &Scenario,
    groups: &[Group],
    position: &[DVec3],
    found: &mut Vec<Diagnostic>,
) -> Vec<Thread> {
    let mut stitches = Vec::new();
    for (row, stitching) in scenario.stitches.iter().enumerate() {
        let path = Path::default().key("stitches").index(row);
        let spans = match (&stitching.pairs, &stitching.class, stitching.reach) {
            (Some(named), ..) if named.is_empty() => {
                found
                    .push(document.diagnostic(&path.key("pairs").to_string(), "no nodes are named for these stitches"));
                continue;
            }
            (Some(named), ..) => pairs(document, cut, &path, named, found),
            (_, Some(class), _) if !groups.iter().any(|g| g.rope.is_some() && g.class.name() == class) => {
                found.push(unknown_class(document, &path, class, groups));
                continue;
            }
            (_, Some(class), Some(reach)) => folds(cut, class, stitching, reach.si(), position),
            // the schema requires `pairs` or `class` with `reach`
            _ => continue,
        };
        if spans.is_empty() && found.is_empty() {
            let message = "no stitch is made: no node lies within reach of another fold";
            found.push(document.diagnostic(&path.key("reach").to_string(), message));
        }
        let rupture = Rupture::new(stitching.breaking_load, stitching.breaking_strain);
        for (number, ends) in spans.into_iter().enumerate() {
            stitches.push(Thread::new(Part::Stitch { row, number }, &path, ends, rupture, stitching.length));
        }
    }
    stitches
}

/// The pairs of nodes that `named` lists below `path`. Reports unknown nodes to `found`.
fn pairs(
    document: &Document,
    cut: &CutWeb,
    path: &Path,
    named: &[[String; 2]],
    found: &mut Vec<Diagnostic>,
) -> Vec<[usize; 2]> {
    let mut pairs = Vec::new();
    for (index, ids) in named.iter().enumerate() {
        let path = path.key("pairs").index(index);
        let nodes = ids.each_ref().map(|id| cut.web.knot_named(id));
        match nodes {
            [Some(a), Some(b)] if a != b => pairs.push([a, b]),
            [Some(_), Some(_)] => {
                found.push(document.diagnostic(&path.to_string(), "a node cannot be tied to itself"));
            }
            _ => {
                let unknown = ids.iter().zip(nodes).enumerate().filter(|(_, (_, node))| node.is_none());
                let told = unknown.map(|(end, (id, _))| unknown_knot(document, &path.index(end).to_string(), id, cut));
                found.extend(told);
            }
        }
    }
    pairs
}

/// The stitches of one row, as pairs of nodes. Every n-th node of the ropes of `class` is joined to the nearest node of
/// another fold within `reach`, m: a node more than twice as far along the ropes. The row never returns to nodes that it
/// has passed, so that of three folds in line each is stitched to the next.
fn folds(cut: &CutWeb, class: &str, stitching: &Stitching, reach: f64, position: &[DVec3]) -> Vec<[usize; 2]> {
    let mut neighbours = vec![Vec::new(); cut.nodes.len()];
    for segment in cut.segments() {
        neighbours[segment.a].push((segment.b, segment.rest_length));
        neighbours[segment.b].push((segment.a, segment.rest_length));
    }
    // sorted along one axis, so that few nodes are compared
    let mut along: Vec<usize> = (0..cut.nodes.len()).filter(|&node| !neighbours[node].is_empty()).collect();
    along.sort_by(|&a, &b| position[a].x.total_cmp(&position[b].x));
    let every = stitching.every.map_or(1, |every| every.get() as usize);
    let mut passed = vec![false; cut.nodes.len()];
    let mut spans = Vec::new();
    let ropes = (0..cut.ropes.len()).filter(|&rope| cut.web.ropes[rope].class.name() == class);
    for (place, node) in ropes.flat_map(|rope| cut.nodes_of(rope).into_iter().enumerate()) {
        if std::mem::replace(&mut passed[node], true) || !place.is_multiple_of(every) {
            continue;
        }
        let same_fold = within(2.0 * reach, node, &neighbours);
        let at = position[node];
        let first = along.partition_point(|&other| position[other].x < at.x - reach);
        let near = along[first..].iter().take_while(|&&other| position[other].x <= at.x + reach);
        let free = near.filter(|other| !passed[**other] && !same_fold.contains(other));
        let distances = free.map(|&other| (position[other].distance(at), other)).filter(|(far, _)| *far <= reach);
        if let Some((_, other)) = distances.min_by(|(one, a), (two, b)| one.total_cmp(two).then(a.cmp(b))) {
            spans.push([node, other]);
        }
    }
    spans
}

/// The nodes, `start` included, within `way` m of rope from `start` (Dijkstra, Numer. Math. 1, 1959).
fn within(way: f64, start: usize, neighbours: &[Vec<(usize, f64)>]) -> BTreeSet<usize> {
    let mut settled = BTreeSet::new();
    let mut open = BinaryHeap::from([Reverse(Reached { along: 0.0, node: start })]);
    while let Some(Reverse(Reached { along, node })) = open.pop() {
        if settled.insert(node) {
            let on = neighbours[node].iter().map(|&(next, length)| Reached { along: along + length, node: next });
            open.extend(on.filter(|on| on.along <= way && !settled.contains(&on.node)).map(Reverse));
        }
    }
    settled
}

/// A node with the way along the ropes to it, m, ordered by that way.
struct Reached {
    along: f64,
    node: usize,
}

impl Ord for Reached {
    fn cmp(&self, other: &Self) -> Ordering {
        self.along.total_cmp(&other.along).then(self.node.cmp(&other.node))
    }
}

impl PartialOrd for Reached {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Reached {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Reached {}

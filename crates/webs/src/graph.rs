//! A web of any shape, from a user's list of nodes and ropes.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::rope_list::RopeList;
use crate::{Class, Knot, Rope, Site, Web, WebError};

/// Two knots are equally near to the middle if their distances differ by less than this share of the web's radius.
const SAME_DISTANCE: f64 = 1e-9;

/// A node of a listed net: a knot of the web.
#[derive(Debug, Clone, PartialEq)]
pub struct GraphNode {
    /// Id, unique in the net.
    pub id: String,
    /// Position, m.
    pub position: DVec3,
}

/// A rope of a listed net.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GraphRope {
    /// Id of the node at its beginning.
    pub a: String,
    /// Id of the node at its end.
    pub b: String,
    /// Link class; none: outline between two neighbours of the outline, else inner.
    pub class: Option<Class>,
    /// Name in messages; none: its class and its number in the class, as in "inner rope 7".
    pub label: Option<String>,
    /// Rest length, m; none: the distance between its nodes.
    pub rest_length: Option<f64>,
    /// Number of segments; none: [`crate::Cutting`] decides.
    pub segments: Option<usize>,
}

/// A list of nodes and ropes, with the outline, the corners and the feature points.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Graph {
    /// Nodes; they become the first knots of the web, in this order.
    pub nodes: Vec<GraphNode>,
    /// Ropes; they become the first ropes of the web, in this order.
    pub ropes: Vec<GraphRope>,
    /// Ids along the closed outline, in order; the first may be repeated at the end. Without an outline the web has no
    /// area.
    pub outline: Vec<String>,
    /// Ids of the nodes for tractors.
    pub corners: Vec<String>,
    /// Feature points: the id of a node by the name of the point.
    pub points: BTreeMap<String, String>,
}

/// Draws the web of a listed net, with its nodes where the user put them. The web's middle is the mean of its outline
/// or, without an outline, of its nodes. Its centre is the node nearest to the middle, or all nodes that are equally
/// near.
///
/// # Errors
/// All faults of the net. First ids that are doubled or unknown, and an outline with fewer than three nodes; if there
/// are none of these, the faults that [`Web::check`] finds.
pub fn graph(graph: &Graph) -> Result<Web, Vec<WebError>> {
    let mut problems = Vec::new();
    let mut index: BTreeMap<&str, usize> = BTreeMap::new();
    for (second, node) in graph.nodes.iter().enumerate() {
        match index.get(node.id.as_str()) {
            Some(&first) => problems.push(WebError::DuplicateId { id: node.id.clone(), first, second }),
            None => {
                index.insert(&node.id, second);
            }
        }
    }

    let mut ends = Vec::new();
    for (row, rope) in graph.ropes.iter().enumerate() {
        let mut find = |id: &String| {
            let knot = index.get(id.as_str()).copied();
            if knot.is_none() {
                problems.push(WebError::UnknownNode { row, id: id.clone() });
            }
            knot
        };
        let (a, b) = (find(&rope.a), find(&rope.b));
        ends.extend(a.zip(b));
    }

    let closed = match graph.outline.split_last() {
        Some((last, rest)) if rest.first() == Some(last) => rest,
        _ => &graph.outline,
    };
    let outline = known("outline", closed, &index, &mut problems);
    if (1..3).contains(&closed.len()) {
        problems.push(WebError::OutlineTooShort { count: closed.len() });
    }
    let corners = known("corners", &graph.corners, &index, &mut problems);
    let mut points = BTreeMap::new();
    for (name, id) in &graph.points {
        match index.get(id.as_str()) {
            Some(&knot) => {
                points.insert(name.clone(), Site::Knot(knot));
            }
            None => problems.push(WebError::UnknownReference { list: "points", id: id.clone() }),
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }

    let knot =
        |node: &GraphNode| Knot { name: node.id.clone(), label: format!("knot {}", node.id), position: node.position };
    let knots = graph.nodes.iter().map(knot).collect();
    let mut web = Web { knots, ropes: tie(graph, &ends, &outline), ..Web::default() };
    let everywhere: Vec<usize> = (0..web.knots.len()).collect();
    let around = if outline.is_empty() { &everywhere } else { &outline };
    if !around.is_empty() {
        web.middle = web.mean_position(around);
    }
    web.outline = outline.into_iter().map(|knot| vec![knot]).collect();
    web.corners = corners;
    web.points = points;
    web.centre = nearest_to_middle(&web);

    let problems = web.check();
    if problems.is_empty() { Ok(web) } else { Err(problems) }
}

/// The knots with the ids of a list. Ids that are unknown or named twice are added to `problems`.
fn known(
    list: &'static str,
    ids: &[String],
    index: &BTreeMap<&str, usize>,
    problems: &mut Vec<WebError>,
) -> Vec<usize> {
    let mut knots = Vec::new();
    for id in ids {
        match index.get(id.as_str()) {
            None => problems.push(WebError::UnknownReference { list, id: id.clone() }),
            Some(knot) if knots.contains(knot) => problems.push(WebError::Repeated { list, id: id.clone() }),
            Some(&knot) => knots.push(knot),
        }
    }
    knots
}

/// The ropes of the web. `ends` are the two knots of each rope, (ropes,).
fn tie(graph: &Graph, ends: &[(usize, usize)], outline: &[usize]) -> Vec<Rope> {
    // each knot's place along the outline
    let place: BTreeMap<usize, usize> = outline.iter().enumerate().map(|(place, &knot)| (knot, place)).collect();
    let are_neighbours = |a: usize, b: usize| match (place.get(&a), place.get(&b)) {
        (Some(&a), Some(&b)) => a.abs_diff(b) == 1 || a.abs_diff(b) + 1 == outline.len(),
        _ => false,
    };
    let mut list = RopeList::default();
    for (rope, &(a, b)) in graph.ropes.iter().zip(ends) {
        let class = if are_neighbours(a, b) { Class::Outline } else { Class::Inner };
        list.tie(a, b, rope.class.clone().unwrap_or(class));
    }
    let mut ropes = list.into_ropes();
    for (tied, listed) in ropes.iter_mut().zip(&graph.ropes) {
        tied.rest_length = listed.rest_length;
        tied.segments = listed.segments;
        if let Some(label) = &listed.label {
            tied.label.clone_from(label);
        }
    }
    ropes
}

/// The knot nearest to the middle, or all knots that are equally near.
fn nearest_to_middle(web: &Web) -> Vec<usize> {
    let distance = |knot: &usize| web.knots[*knot].position.distance(web.middle);
    let knots = 0..web.knots.len();
    let nearest = knots.clone().map(|knot| distance(&knot)).fold(f64::INFINITY, f64::min);
    let limit = nearest + SAME_DISTANCE * web.radius();
    knots.filter(|knot| distance(knot) <= limit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of four ropes, with a knot in its middle that two more ropes hold.
    fn kite() -> Graph {
        let node = |id: &str, x: f64, y: f64| GraphNode { id: id.into(), position: DVec3::new(x, y, 1.0) };
        let rope = |a: &str, b: &str| GraphRope { a: a.into(), b: b.into(), ..GraphRope::default() };
        Graph {
            nodes: vec![
                node("e", 12.0, 5.0),
                node("n", 10.0, 7.0),
                node("w", 8.0, 5.0),
                node("s", 10.0, 3.0),
                node("m", 10.0, 5.0),
            ],
            ropes: vec![rope("e", "n"), rope("w", "n"), rope("w", "s"), rope("s", "e"), rope("m", "e"), rope("w", "m")],
            outline: ["e", "n", "w", "s", "e"].map(String::from).to_vec(),
            corners: ["e", "w", "n", "s"].map(String::from).to_vec(),
            points: BTreeMap::from([("B".into(), "m".into())]),
        }
    }

    #[test]
    fn a_kite_has_the_middle_area_and_labels_that_its_list_implies() {
        let web = graph(&kite()).unwrap();
        assert_eq!(web.middle, DVec3::new(10.0, 5.0, 1.0));
        assert_eq!(web.centre, [4]);
        assert!((web.reference_area().unwrap() - 8.0).abs() < 1e-12);
        let labels: Vec<&str> = web.ropes.iter().map(|rope| rope.label.as_str()).collect();
        assert_eq!(
            labels[..5],
            ["outline rope 1", "outline rope 2", "outline rope 3", "outline rope 4", "inner rope 1"]
        );
        assert_eq!(web.points["B"], Site::Knot(4));
        assert_eq!(web.knot_named("w"), Some(2));
    }

    #[test]
    fn the_ring_of_tractors_does_not_depend_on_the_order_of_the_corners() {
        let web = graph(&kite()).unwrap().with_traction(1.0, 1).unwrap();
        // the corners are listed as east, west, north, south; the square of tractors has a half diagonal of 3 m
        assert_eq!(web.tractor_ring(), [0, 2, 1, 3].map(|corner: usize| web.tractors[corner]));
        assert!((web.tractor_area().unwrap() - 18.0).abs() < 1e-12);
    }

    #[test]
    fn without_an_outline_there_is_no_area() {
        let mut net = kite();
        net.outline.clear();
        let web = graph(&net).unwrap();
        assert_eq!(web.reference_area(), None);
        assert!(web.ropes.iter().all(|rope| rope.class == Class::Inner));
    }

    #[test]
    fn all_unknown_and_doubled_ids_are_reported_at_once() {
        let mut net = kite();
        net.nodes[1].id = "e".into();
        net.corners.push("x".into());
        net.points.insert("D".into(), "y".into());
        let problems = graph(&net).unwrap_err();
        assert!(problems.contains(&WebError::DuplicateId { id: "e".into(), first: 0, second: 1 }));
        assert!(problems.contains(&WebError::UnknownNode { row: 0, id: "n".into() }));
        assert!(problems.contains(&WebError::UnknownNode { row: 1, id: "n".into() }));
        assert!(problems.contains(&WebError::UnknownReference { list: "corners", id: "x".into() }));
        assert!(problems.contains(&WebError::UnknownReference { list: "points", id: "y".into() }));
    }

    #[test]
    fn faults_of_ropes_and_separate_pieces_are_reported_at_once() {
        let mut net = kite();
        net.nodes[3].position = net.nodes[2].position;
        net.ropes[0].b = "e".into();
        net.ropes.truncate(4);
        net.ropes[1].rest_length = Some(-1.0);
        let problems = graph(&net).unwrap_err();
        let found = |test: fn(&WebError) -> bool| problems.iter().any(test);
        assert!(found(|problem| matches!(problem, WebError::SelfLoop { rope: 0, .. })));
        assert!(found(|problem| matches!(problem, WebError::RestLength { rope: 1, .. })));
        assert!(found(|problem| matches!(problem, WebError::ZeroLength { rope: 2, .. })));
        assert!(found(|problem| matches!(problem, WebError::Disconnected { pieces: 2, .. })));
    }

    #[test]
    fn an_empty_net_is_refused() {
        assert_eq!(graph(&Graph::default()), Err(vec![WebError::Empty { knots: 0, ropes: 0 }]));
    }
}

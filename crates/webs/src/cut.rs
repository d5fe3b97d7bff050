//! Cuts the ropes of a web into straight segments between nodes.
//!
//! Order of nodes: first the knots (node k is knot k), then the nodes inside ropes, rope by rope and from `a` to `b`,
//! then the nodes that a model adds, such as those inside sheets.

use std::ops::Range;

use glam::DVec3;

use crate::{Rope, Site, Web};

/// Largest number of segments of a cut web.
pub const MOST_SEGMENTS: usize = 50_000_000;

/// How ropes are cut into segments of equal length.
#[derive(Debug, Clone, PartialEq)]
pub enum Cutting {
    /// Desired length of a segment, m. The number of segments of a rope is its rest length over this length, rounded,
    /// and at least 1; [`Rope::segments`] overrules it.
    SegmentLength(f64),
    /// Number of segments of each rope, (ropes,).
    Counts(Vec<usize>),
}

/// Why a web cannot be cut.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CutError {
    /// The segment length is not positive and finite; its value, m.
    #[error("the segment length must be a positive length, not {0} m")]
    SegmentLength(f64),
    /// The list of numbers of segments is longer or shorter than the list of ropes.
    #[error("{counts} numbers of segments were given for {ropes} ropes")]
    Counts {
        /// Length of the list.
        counts: usize,
        /// Number of ropes of the web.
        ropes: usize,
    },
    /// The number of segments of a rope is 0; the rope's label.
    #[error("{0}: a rope has at least 1 segment, not 0")]
    NoSegments(String),
    /// The web would have more than [`MOST_SEGMENTS`] segments.
    #[error("the web would have {segments:.3e} segments; at most {MOST_SEGMENTS} are allowed")]
    TooMany {
        /// The number of segments.
        segments: f64,
    },
}

/// A rope that is cut into segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutRope {
    /// The first of the `segments` - 1 nodes inside the rope.
    pub first_interior: usize,
    /// Number of segments.
    pub segments: usize,
    /// Rest length of each segment, m.
    pub segment_length: f64,
}

impl CutRope {
    /// The nodes inside the rope, without its knots.
    pub fn interior(&self) -> Range<usize> {
        self.first_interior..self.first_interior + self.segments - 1
    }
}

/// A straight piece of a rope between two nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutSegment {
    /// Node at its beginning.
    pub a: usize,
    /// Node at its end.
    pub b: usize,
    /// Its rope, as an index into [`Web::ropes`].
    pub rope: usize,
    /// Number of the segment in its rope, from 0.
    pub place: usize,
    /// Rest length, m.
    pub rest_length: f64,
}

/// A web cut into segments.
#[derive(Debug, Clone, PartialEq)]
pub struct CutWeb {
    /// The web as designed.
    pub web: Web,
    /// Positions of all nodes in the flat web, m, (nodes,).
    pub nodes: Vec<DVec3>,
    /// The cut ropes in the order of the web's ropes, (ropes,).
    pub ropes: Vec<CutRope>,
    /// Canopy and label of each node that a model has added.
    added: Vec<(usize, String)>,
}

/// Cuts every rope into segments of equal length.
///
/// # Errors
/// [`CutError`]: a segment length that is not positive, a list of another length than the ropes, a rope without
/// segments, or more than [`MOST_SEGMENTS`] segments.
pub fn cut(web: &Web, cutting: &Cutting) -> Result<CutWeb, CutError> {
    let counts = segment_counts(web, cutting)?;
    let mut nodes: Vec<DVec3> = web.knots.iter().map(|knot| knot.position).collect();
    let mut ropes = Vec::with_capacity(counts.len());
    for (rope, segments) in web.ropes.iter().zip(counts) {
        let first_interior = nodes.len();
        ropes.push(CutRope { first_interior, segments, segment_length: web.rest_length(rope) / segments as f64 });
        let (a, b) = (nodes[rope.a], nodes[rope.b]);
        nodes.extend((1..segments).map(|node| a + (b - a) * (node as f64 / segments as f64)));
    }
    Ok(CutWeb { web: web.clone(), nodes, ropes, added: Vec::new() })
}

fn segment_counts(web: &Web, cutting: &Cutting) -> Result<Vec<usize>, CutError> {
    let counts: Vec<f64> = match cutting {
        Cutting::SegmentLength(length) => {
            if !(*length > 0.0 && length.is_finite()) {
                return Err(CutError::SegmentLength(*length));
            }
            let by_length = |rope: &Rope| (web.rest_length(rope) / length).round().max(1.0);
            web.ropes.iter().map(|rope| rope.segments.map_or_else(|| by_length(rope), |count| count as f64)).collect()
        }
        Cutting::Counts(counts) if counts.len() == web.ropes.len() => {
            counts.iter().map(|&count| count as f64).collect()
        }
        Cutting::Counts(counts) => return Err(CutError::Counts { counts: counts.len(), ropes: web.ropes.len() }),
    };
    if let Some(rope) = counts.iter().position(|&count| count < 1.0) {
        return Err(CutError::NoSegments(web.ropes[rope].label.clone()));
    }
    let segments: f64 = counts.iter().sum();
    if segments > MOST_SEGMENTS as f64 {
        return Err(CutError::TooMany { segments });
    }
    Ok(counts.into_iter().map(|count| count as usize).collect())
}

impl CutWeb {
    /// Adds a node to a canopy and returns its index. `position` is in the flat web, m; `label` is its name in
    /// messages. No rope runs through the node.
    pub fn add_node(&mut self, canopy: usize, position: DVec3, label: String) -> usize {
        self.nodes.push(position);
        self.added.push((canopy, label));
        self.nodes.len() - 1
    }

    /// The nodes of each canopy, (canopies,): its hub, its corners, and the nodes that a model has added.
    pub(crate) fn canopy_nodes(&self) -> Vec<Vec<usize>> {
        let canopies = self.web.canopies.iter();
        let mut nodes: Vec<Vec<usize>> =
            canopies.map(|canopy| [canopy.hub].into_iter().chain(canopy.rim).collect()).collect();
        let first_added = self.nodes.len() - self.added.len();
        for (node, (canopy, _)) in (first_added..).zip(&self.added) {
            nodes[*canopy].push(node);
        }
        nodes
    }

    /// The nodes of a rope from its knot `a` to its knot `b`.
    pub fn nodes_of(&self, rope: usize) -> Vec<usize> {
        let Rope { a, b, .. } = self.web.ropes[rope];
        std::iter::once(a).chain(self.ropes[rope].interior()).chain([b]).collect()
    }

    /// All segments, rope by rope, each rope from `a` to `b`.
    pub fn segments(&self) -> impl Iterator<Item = CutSegment> + '_ {
        self.ropes.iter().enumerate().flat_map(|(rope, cut)| {
            let Rope { a, b, .. } = self.web.ropes[rope];
            let node = move |place: usize| match place {
                0 => a,
                _ if place == cut.segments => b,
                _ => cut.first_interior + place - 1,
            };
            let rest_length = cut.segment_length;
            (0..cut.segments).map(move |place| CutSegment {
                a: node(place),
                b: node(place + 1),
                rope,
                place,
                rest_length,
            })
        })
    }

    /// Whether each node belongs to the web itself, (nodes,): false inside traction ropes and for the tractors at their
    /// ends.
    pub fn is_web(&self) -> Vec<bool> {
        let mut is_web = vec![true; self.nodes.len()];
        for (tractor, ropes) in self.web.traction.iter().enumerate() {
            is_web[self.web.tractors[tractor]] = false;
            for &rope in ropes {
                is_web[self.ropes[rope].interior()].fill(false);
            }
        }
        is_web
    }

    /// Number of segments.
    pub fn segment_count(&self) -> usize {
        self.ropes.iter().map(|rope| rope.segments).sum()
    }

    /// The node nearest to a site of the web, along its rope.
    pub fn node_of(&self, site: Site) -> usize {
        match site {
            Site::Knot(knot) => knot,
            Site::OnRope { rope, fraction } => {
                let nodes = self.nodes_of(rope);
                let along = (fraction * (nodes.len() - 1) as f64).round().max(0.0) as usize;
                nodes[along.min(nodes.len() - 1)]
            }
        }
    }

    /// A node's name in messages: the label of its knot, "node 3 of traction rope 1" inside a rope (counted from 1), or
    /// the label of an added node.
    pub fn node_label(&self, node: usize) -> String {
        if let Some(knot) = self.web.knots.get(node) {
            return knot.label.clone();
        }
        let first_added = self.nodes.len() - self.added.len();
        if node >= first_added {
            return self.added[node - first_added].1.clone();
        }
        // the last rope whose first node inside comes no later: a rope of one segment has no node of its own there
        let rope = self.ropes.partition_point(|rope| rope.first_interior <= node) - 1;
        format!("node {} of {}", node - self.ropes[rope].first_interior + 1, self.web.ropes[rope].label)
    }

    /// A segment's name in messages: "segment 12 of traction rope 3", counted from 1.
    pub fn segment_label(&self, segment: &CutSegment) -> String {
        format!("segment {} of {}", segment.place + 1, self.web.ropes[segment.rope].label)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{square, traditional};

    fn cut_net() -> CutWeb {
        let web = square(2.0, 1.0).unwrap().with_traction(1.0, 1).unwrap();
        cut(&web, &Cutting::SegmentLength(0.25)).unwrap()
    }

    #[test]
    fn knots_come_first_and_the_nodes_of_a_rope_lie_together() {
        let net = cut_net();
        assert!(net.web.knots.iter().zip(&net.nodes).all(|(knot, node)| knot.position == *node));
        assert_eq!(net.nodes.len(), 9 + 4 + (12 + 4) * 3);
        assert_eq!(net.nodes_of(0), [0, 13, 14, 15, 1]);
        for rope in 0..net.ropes.len() {
            for pair in net.nodes_of(rope).windows(2) {
                assert!((net.nodes[pair[0]].distance(net.nodes[pair[1]]) - 0.25).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn labels_name_the_rope_and_count_its_nodes_and_segments_from_1() {
        let net = cut_net();
        let last = net.nodes.len() - 1;
        assert_eq!(net.node_label(last), "node 3 of traction rope 4");
        assert_eq!(net.node_label(last - 3), "node 3 of traction rope 3");
        assert_eq!(net.node_label(4), "knot 5");
        assert_eq!(net.node_label(12), "tractor 4");
        assert_eq!(
            net.segments().last().map(|segment| net.segment_label(&segment)).unwrap(),
            "segment 4 of traction rope 4"
        );
    }

    #[test]
    fn labels_skip_ropes_of_one_segment() {
        let web = square(1.0, 0.5).unwrap();
        let mut counts = vec![1; web.ropes.len()];
        counts[3] = 3;
        let net = cut(&web, &Cutting::Counts(counts)).unwrap();
        assert_eq!(net.node_label(9), format!("node 1 of {}", web.ropes[3].label));
        assert_eq!(net.node_label(10), format!("node 2 of {}", web.ropes[3].label));
    }

    #[test]
    fn a_site_on_a_rope_is_found_at_the_nearest_node() {
        let net = cut_net();
        let on = |fraction| net.node_of(Site::OnRope { rope: 0, fraction });
        assert_eq!([on(0.0), on(0.1), on(0.5), on(0.9), on(1.0)], [0, 0, 14, 1, 1]);
    }

    #[test]
    fn a_rope_s_own_number_of_segments_and_rest_length_are_used() {
        let mut web = square(1.0, 0.5).unwrap();
        web.ropes[0].segments = Some(7);
        web.ropes[1].rest_length = Some(1.5);
        let net = cut(&web, &Cutting::SegmentLength(0.25)).unwrap();
        assert_eq!(net.ropes[0].segments, 7);
        assert_eq!((net.ropes[1].segments, net.ropes[1].segment_length), (6, 0.25));
    }

    #[test]
    fn wrong_lengths_and_numbers_of_segments_are_refused() {
        let web = square(1.0, 0.5).unwrap();
        assert!(matches!(cut(&web, &Cutting::SegmentLength(0.0)), Err(CutError::SegmentLength(_))));
        assert!(matches!(cut(&web, &Cutting::SegmentLength(f64::NAN)), Err(CutError::SegmentLength(_))));
        assert!(matches!(cut(&web, &Cutting::SegmentLength(1e-300)), Err(CutError::TooMany { .. })));
        assert!(matches!(cut(&web, &Cutting::Counts(vec![1])), Err(CutError::Counts { .. })));
        assert!(matches!(cut(&web, &Cutting::Counts(vec![0; 12])), Err(CutError::NoSegments(_))));
    }

    proptest! {
        #[test]
        fn any_cut_keeps_the_length_of_rope(segment_length in 0.02..20.0_f64, cells in 2..9_usize) {
            let web = traditional(2.5, cells).unwrap().with_traction(1.0355, 2).unwrap();
            let net = cut(&web, &Cutting::SegmentLength(segment_length)).unwrap();
            let drawn: f64 = net.segments().map(|segment| net.nodes[segment.a].distance(net.nodes[segment.b])).sum();
            let rest: f64 = net.segments().map(|segment| segment.rest_length).sum();
            let whole: f64 = web.rope_length_by_class().values().sum();
            prop_assert!((drawn - whole).abs() < 1e-9);
            prop_assert!((rest - whole).abs() < 1e-9);
            prop_assert_eq!(net.segments().count(), net.segment_count());
            prop_assert_eq!(net.nodes.len(), web.knots.len() + net.segment_count() - web.ropes.len());
        }
    }
}

//! Chooses the nodes and segments that a replay draws: all, or every n-th node inside a rope.
//!
//! Knots, ends and nodes that a landmark names always stay. The segments between two kept nodes become one drawn
//! segment with the largest of their tensions.

use std::collections::BTreeSet;

use netcast_results::Landmarks;

use crate::results::Scene;

/// A segment of the drawing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct DrawnSegment {
    /// Its ends, indices into [`Drawn::nodes`].
    pub ends: [u32; 2],
    /// Its link class.
    pub class: u32,
    /// The segments of the run that it stands for.
    pub parts: Vec<usize>,
}

/// The nodes and segments that are drawn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drawn {
    /// The nodes of the run that are drawn, in their order.
    pub nodes: Vec<usize>,
    /// The segments between them.
    pub segments: Vec<DrawnSegment>,
}

impl Drawn {
    /// The drawing that keeps every `stride`-th node inside a rope; with a stride of one, everything.
    pub(crate) fn of(scene: &Scene, stride: usize) -> Self {
        let topology = &scene.fields.topology;
        let thinned =
            thin(topology.nodes, &topology.segments, &topology.classes, &meaningful(&scene.landmarks), stride);
        // drop the nodes at which no drawn segment ends
        let mut place = vec![u32::MAX; topology.nodes];
        let used: BTreeSet<usize> =
            thinned.iter().flat_map(|(ends, _)| *ends).chain(meaningful(&scene.landmarks)).collect();
        for (new, &old) in used.iter().enumerate() {
            place[old] = new as u32;
        }
        let segments = thinned
            .into_iter()
            .map(|(ends, parts)| DrawnSegment {
                ends: ends.map(|node| place[node]),
                class: topology.classes[parts[0]],
                parts,
            })
            .collect();
        Self { nodes: used.into_iter().collect(), segments }
    }
}

/// The nodes that a landmark names.
fn meaningful(landmarks: &Landmarks) -> BTreeSet<usize> {
    let groups = landmarks.outline.iter().chain(landmarks.points.iter().map(|point| &point.nodes));
    let canopies = landmarks.canopies.iter().flat_map(|canopy| canopy.faces()).flatten();
    groups
        .flatten()
        .chain(&landmarks.corners)
        .chain(&landmarks.tractors)
        .chain(&landmarks.centre)
        .chain(landmarks.bodies.iter().map(|body| &body.node))
        .copied()
        .chain(canopies)
        .collect()
}

/// Pairs of kept nodes, each with the segments between them. Inside a rope every `stride`-th node is kept; `kept` holds
/// further nodes to keep.
fn thin(
    nodes: usize,
    segments: &[[u32; 2]],
    classes: &[u32],
    kept: &BTreeSet<usize>,
    stride: usize,
) -> Vec<([usize; 2], Vec<usize>)> {
    let mut meeting = vec![Vec::new(); nodes];
    for (segment, ends) in segments.iter().enumerate() {
        for &node in ends {
            meeting[node as usize].push(segment);
        }
    }
    // a node inside a rope has exactly two segments, of one class
    let inside = |node: usize| {
        let two = &meeting[node];
        two.len() == 2 && classes[two[0]] == classes[two[1]] && !kept.contains(&node)
    };
    let mut taken = vec![false; segments.len()];
    let mut drawn = Vec::new();
    // follow ropes from their ends first; the rest are loops without a knot
    let from_knots = |segment: &usize| segments[*segment].iter().any(|&node| !inside(node as usize));
    let (first, loops): (Vec<usize>, Vec<usize>) = (0..segments.len()).partition(from_knots);
    for start in first.into_iter().chain(loops) {
        if taken[start] {
            continue;
        }
        let [one, other] = segments[start].map(|node| node as usize);
        let (mut from, mut to) = if inside(one) && !inside(other) { (other, one) } else { (one, other) };
        let (mut segment, mut parts) = (start, Vec::new());
        loop {
            taken[segment] = true;
            parts.push(segment);
            let next = inside(to).then(|| meeting[to].iter().copied().find(|&next| !taken[next])).flatten();
            if parts.len() == stride || next.is_none() {
                drawn.push(([from, to], std::mem::take(&mut parts)));
                from = to;
            }
            let Some(next) = next else { break };
            let [one, other] = segments[next].map(|node| node as usize);
            (segment, to) = (next, if one == to { other } else { one });
        }
    }
    drawn
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rope of six segments from knot 0 to knot 6, where two ropes of another class begin.
    fn rope() -> (Vec<[u32; 2]>, Vec<u32>) {
        let mut segments: Vec<[u32; 2]> = (0..6).map(|node| [node, node + 1]).collect();
        segments.extend([[6, 7], [6, 8]]);
        (segments, vec![0, 0, 0, 0, 0, 0, 1, 1])
    }

    #[test]
    fn a_stride_of_one_draws_every_segment() {
        let (segments, classes) = rope();
        let drawn = thin(9, &segments, &classes, &BTreeSet::new(), 1);
        assert_eq!(drawn.len(), segments.len());
        assert!(drawn.iter().all(|(_, parts)| parts.len() == 1));
    }

    #[test]
    fn knots_and_meaningful_nodes_stay() {
        let (segments, classes) = rope();
        let drawn = thin(9, &segments, &classes, &BTreeSet::from([3]), 4);
        let ends: Vec<[usize; 2]> = drawn.iter().map(|(ends, _)| *ends).collect();
        assert_eq!(ends, [[0, 3], [3, 6], [6, 7], [6, 8]]);
        assert_eq!(drawn[0].1, [0, 1, 2]);
    }

    #[test]
    fn a_loop_without_a_knot_is_drawn_once() {
        let segments: Vec<[u32; 2]> = (0..6).map(|node| [node, (node + 1) % 6]).collect();
        let drawn = thin(6, &segments, &[0; 6], &BTreeSet::new(), 2);
        let mut parts: Vec<usize> = drawn.iter().flat_map(|(_, parts)| parts.clone()).collect();
        parts.sort_unstable();
        assert_eq!((drawn.len(), parts), (3, vec![0, 1, 2, 3, 4, 5]));
    }
}

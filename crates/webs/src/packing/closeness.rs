//! Closeness: the least distance between two ropes that share no knot.
//!
//! The distance is that of the centre lines of two segments (Ericson, Real-Time Collision Detection, 2005, 5.1.9). A
//! tree of bounding boxes finds the pairs of segments that are near each other.

use glam::DVec3;
use parry3d_f64::bounding_volume::{Aabb, BoundingVolume};
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy};
use parry3d_f64::query::details::closest_points_segment_segment_with_locations_nD;
use parry3d_f64::shape::Segment;

use crate::CutWeb;

/// Largest number of pairs of segments to compare, which takes a second or two.
const MOST_PAIRS: usize = 50_000_000;

/// How close ropes without a common knot are to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closeness {
    /// The closest two segments, the first of equals; none if every two ropes share a knot.
    pub closest: Option<Approach>,
    /// Number of pairs of segments that touch: their distance is less than the mean diameter of their ropes.
    pub touching: usize,
}

/// The least distance between two segments, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// The two segments, by their places in [`CutWeb::segments`].
    pub segments: [usize; 2],
    /// Distance between their centre lines, m.
    pub distance: f64,
    /// The point half way between their nearest points, m.
    pub place: DVec3,
}

/// Closeness of a web at these positions, m, (nodes,), with ropes of these diameters, m, (ropes,). None if more than
/// 50 million pairs of segments lie near each other.
pub fn closeness(cut_web: &CutWeb, positions: &[DVec3], diameters: &[f64]) -> Option<Closeness> {
    let strands: Vec<Strand> = cut_web
        .segments()
        .map(|cut| {
            let segment = Segment::new(positions[cut.a], positions[cut.b]);
            let rope = &cut_web.web.ropes[cut.rope];
            Strand { segment, radius: 0.5 * diameters[cut.rope], knots: [rope.a, rope.b] }
        })
        .collect();
    let boxes: Vec<Aabb> = strands.iter().map(|strand| strand.segment.local_aabb()).collect();
    let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
    let size = if boxes.is_empty() { 0.0 } else { tree.root_aabb().extents().length() };
    // the tree finds the pairs within a margin; the margin grows until it holds the closest pair
    let mut margin = diameters.iter().copied().fold(0.0, f64::max);
    let mut budget = MOST_PAIRS;
    loop {
        let near = compare(&strands, &boxes, &tree, margin, &mut budget)?;
        // a pair farther apart than the margin need not be the closest one
        let is_closest = near.closest.is_some_and(|closest| closest.distance <= margin);
        if is_closest || margin >= size {
            return Some(near);
        }
        margin = (4.0 * margin).max(1e-3 * size);
    }
}

/// A segment with its rope.
struct Strand {
    segment: Segment,
    /// Radius of its rope, m.
    radius: f64,
    /// The two knots of its rope.
    knots: [usize; 2],
}

/// Closeness of the pairs whose bounding boxes are within `margin` of each other, m. Takes one from `budget` for each
/// pair; none if the budget is spent.
fn compare(strands: &[Strand], boxes: &[Aabb], tree: &Bvh, margin: f64, budget: &mut usize) -> Option<Closeness> {
    let mut found = Closeness { closest: None, touching: 0 };
    for (first, strand) in strands.iter().enumerate() {
        let around = boxes[first].loosened(margin);
        let others = tree.intersect_aabb(&around).map(|other| other as usize).filter(|&other| other > first);
        for second in others {
            *budget = budget.checked_sub(1)?;
            let other = &strands[second];
            if strand.knots.iter().any(|knot| other.knots.contains(knot)) {
                continue;
            }
            let (place, distance) = nearest(&strand.segment, &other.segment);
            found.touching += usize::from(distance < strand.radius + other.radius);
            let approach = Approach { segments: [first, second], distance, place };
            // the order of pairs from the tree is not defined, so equal distances are decided by the segments
            let key = |approach: &Approach| (approach.distance, approach.segments);
            if found.closest.is_none_or(|closest| key(&approach) < key(&closest)) {
                found.closest = Some(approach);
            }
        }
    }
    Some(found)
}

/// The point half way between the nearest points of two segments, and the distance between these points, m.
fn nearest(one: &Segment, other: &Segment) -> (DVec3, f64) {
    let places = closest_points_segment_segment_with_locations_nD((&one.a, &one.b), (&other.a, &other.b));
    let (a, b) = (one.point_at(&places.0), other.point_at(&places.1));
    (0.5 * (a + b), a.distance(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cutting, Scale, cut, packing::Pattern, square};

    fn net() -> CutWeb {
        cut(&square(2.0, 1.0).unwrap(), &Cutting::SegmentLength(0.25)).unwrap()
    }

    #[test]
    fn ropes_of_a_flat_net_without_a_common_knot_are_a_mesh_apart() {
        let net = net();
        let found = closeness(&net, &net.nodes, &vec![0.01; net.ropes.len()]).unwrap();
        let closest = found.closest.unwrap();
        assert!((closest.distance - 1.0).abs() < 1e-12, "{closest:?}");
        assert_eq!(found.touching, 0);
        // a tenth of the size, with ropes a little thicker than the meshes are wide
        let small = Pattern::Scale(Scale { factor: 0.1 }).pack(&net).unwrap();
        let found = closeness(&net, &small, &vec![0.101; net.ropes.len()]).unwrap();
        assert!((found.closest.unwrap().distance - 0.1).abs() < 1e-12);
        assert!(found.touching > 0);
    }

    #[test]
    fn the_tree_finds_what_a_comparison_of_all_pairs_finds() {
        let net = net();
        let jumbled: Vec<DVec3> = (0..net.nodes.len())
            .map(|node| DVec3::new((node * 7 % 11) as f64, (node * 5 % 13) as f64, (node * 3 % 17) as f64))
            .collect();
        let diameter = 1.3;
        let found = closeness(&net, &jumbled, &vec![diameter; net.ropes.len()]).unwrap();
        let segments: Vec<_> = net.segments().collect();
        let (mut least, mut touching) = (f64::INFINITY, 0);
        for (one, a) in segments.iter().enumerate() {
            for b in &segments[one + 1..] {
                let [p, q] = [a, b].map(|cut| &net.web.ropes[cut.rope]);
                if [p.a, p.b].iter().any(|knot| [q.a, q.b].contains(knot)) {
                    continue;
                }
                let [s, t] = [a, b].map(|cut| Segment::new(jumbled[cut.a], jumbled[cut.b]));
                let (_, distance) = nearest(&s, &t);
                least = least.min(distance);
                touching += usize::from(distance < diameter);
            }
        }
        assert_eq!((found.closest.unwrap().distance, found.touching), (least, touching));
        assert!(touching > 10);
    }

    #[test]
    fn crossing_parallel_and_collinear_segments_have_their_distances() {
        let segment = |a: [f64; 3], b: [f64; 3]| Segment::new(a.into(), b.into());
        let along = segment([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
        for (other, distance) in [
            (segment([0.5, -1.0, 0.25], [0.5, 1.0, 0.25]), 0.25),
            (segment([0.2, 0.3, 0.0], [2.0, 0.3, 0.0]), 0.3),
            (segment([1.3, 0.4, 0.0], [2.0, 5.0, 0.0]), 0.5),
            (segment([3.0, 0.0, 0.0], [4.0, 0.0, 0.0]), 2.0),
        ] {
            assert!((nearest(&along, &other).1 - distance).abs() < 1e-12, "{other:?}");
        }
    }
}

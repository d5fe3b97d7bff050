//! Distance limits: the largest distance between two nodes of a packed web.
//!
//! The ends of a rope can be nearer to each other than its length, where the rope is slack, but not farther apart. The
//! same holds for two knots of one canopy.

use crate::CutWeb;

/// A pair of nodes with the largest distance allowed between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DistanceLimit {
    /// The two nodes.
    pub ends: [usize; 2],
    /// The largest distance, m.
    pub length: f64,
}

/// One limit for every segment of rope: its rest length.
pub(super) fn of_ropes(cut_web: &CutWeb) -> impl Iterator<Item = DistanceLimit> {
    cut_web.segments().map(|segment| DistanceLimit { ends: [segment.a, segment.b], length: segment.rest_length })
}

/// One limit for every pair of knots of a canopy: their distance in the flat web.
pub(super) fn of_canopies(cut_web: &CutWeb) -> impl Iterator<Item = DistanceLimit> {
    let mut limits = Vec::new();
    for canopy in &cut_web.web.canopies {
        let knots: Vec<usize> = canopy.rim.into_iter().chain([canopy.hub]).collect();
        for (number, &a) in knots.iter().enumerate() {
            for &b in &knots[..number] {
                let length = cut_web.nodes[a].distance(cut_web.nodes[b]);
                limits.push(DistanceLimit { ends: [a, b], length });
            }
        }
    }
    limits.into_iter()
}

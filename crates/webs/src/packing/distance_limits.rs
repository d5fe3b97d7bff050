//! Distance limits: how far apart two nodes of a packed web may be.
//!
//! A rope bears no compression, so that its ends may be nearer to each other than its length, and never farther. The
//! same holds for two knots of one canopy.

use crate::CutWeb;

/// Two nodes and their largest distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DistanceLimit {
    /// The two nodes.
    pub ends: [usize; 2],
    /// Their largest distance, m.
    pub length: f64,
}

/// The limit of every segment of rope: its rest length.
pub(super) fn of_ropes(cut_web: &CutWeb) -> impl Iterator<Item = DistanceLimit> {
    cut_web.segments().map(|segment| DistanceLimit { ends: [segment.a, segment.b], length: segment.rest_length })
}

/// The limit of every pair of knots of one canopy: their distance in the flat web.
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

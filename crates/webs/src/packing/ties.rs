//! Ties: pairs of nodes that may not come farther apart than a length, and how what stretches them is drawn in.
//!
//! Sweep by sweep the ends of each tie that is too long move towards each other, and each plate then goes where its
//! corners have been drawn (position-based dynamics: Müller, Heidelberger, Hennix, Ratcliff, J. Vis. Commun. Image R. 18,
//! 2007).

use glam::{DMat3, DVec3};

use super::plate::StiffPlate;
use crate::CutWeb;

/// Two nodes and how far they may be apart, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tie {
    pub ends: [usize; 2],
    pub length: f64,
}

/// A stretch that is none, relative.
const ROUNDING: f64 = 1e-12;

/// How much shorter than it may be a tie becomes that was too long, relative: sweeps then come to an end.
const AIM: f64 = 1e-3;

/// Sweeps at most.
const MOST_SWEEPS: usize = 20_000;

/// Each segment of rope.
pub(super) fn of_ropes(cut_web: &CutWeb) -> impl Iterator<Item = Tie> {
    cut_web.segments().map(|segment| Tie { ends: [segment.a, segment.b], length: segment.rest_length })
}

/// Each pair of knots of one canopy.
pub(super) fn of_canopies(cut_web: &CutWeb) -> impl Iterator<Item = Tie> {
    cut_web.web.canopies.iter().flat_map(|canopy| {
        let knots: Vec<usize> = canopy.rim.into_iter().chain([canopy.hub]).collect();
        let pairs = (0..knots.len()).flat_map(|one| (0..one).map(move |other| (one, other)));
        let ends = pairs.map(|(one, other)| [knots[one], knots[other]]).collect::<Vec<_>>();
        ends.into_iter().map(|[a, b]| Tie { ends: [a, b], length: cut_web.nodes[a].distance(cut_web.nodes[b]) })
    })
}

/// A web that is drawn in.
pub(super) struct Drawn<'a> {
    pub cut_web: &'a CutWeb,
    pub ties: &'a [Tie],
    pub plates: &'a [StiffPlate],
    /// How easily each node is moved, (nodes,): 0 where it stays, else the inverse of its mass or any other measure.
    pub ease: &'a [f64],
}

impl Drawn<'_> {
    /// One sweep over all ties, the last one first if it is `backwards`: each that is too long becomes shorter than it
    /// may be by the share `aim`. Says whether there was one.
    pub fn sweep(&self, backwards: bool, aim: f64, turns: &mut [DMat3], packed: &mut [DVec3]) -> bool {
        let mut was_stretched = false;
        for place in 0..self.ties.len() {
            let place = if backwards { self.ties.len() - 1 - place } else { place };
            let Tie { ends: [a, b], length } = self.ties[place];
            let between = packed[b] - packed[a];
            let excess = between.length() - length;
            let ease = self.ease[a] + self.ease[b];
            if excess <= ROUNDING * length || ease == 0.0 {
                continue;
            }
            was_stretched = true;
            let way = (excess + aim * length) / ease * between.normalize_or_zero();
            packed[a] += self.ease[a] * way;
            packed[b] -= self.ease[b] * way;
        }
        if was_stretched {
            self.place_plates(turns, packed);
        }
        was_stretched
    }

    /// Puts every plate where its corners are, or where its middle stays.
    pub fn place_plates(&self, turns: &mut [DMat3], packed: &mut [DVec3]) {
        for (plate, turn) in self.plates.iter().zip(turns) {
            let hub = self.cut_web.web.canopies[plate.canopy].hub;
            let middle = packed[hub];
            *turn = plate.fit_corners(self.cut_web, *turn, packed);
            if self.ease[hub] == 0.0 {
                packed[hub] = middle;
            }
            plate.place(self.cut_web, *turn, packed);
        }
    }

    /// Sweeps until nothing is stretched; what still is after very many stays so, for the audit to tell.
    pub fn draw_in(&self, turns: &mut [DMat3], packed: &mut [DVec3]) {
        (0..MOST_SWEEPS).any(|sweep| !self.sweep(sweep % 2 == 1, AIM, turns, packed));
    }
}

//! The check of a web that a user has listed: it finds all faults at once.

use crate::{Web, WebError};

impl Web {
    /// All faults of the web: no knots or no ropes, coordinates that are not finite, ropes without a length or without
    /// segments, ropes with both ends at one knot, and pieces that neither a rope nor a canopy joins.
    pub fn check(&self) -> Vec<WebError> {
        if self.knots.is_empty() || self.ropes.is_empty() {
            return vec![WebError::Empty { knots: self.knots.len(), ropes: self.ropes.len() }];
        }
        let mut problems = Vec::new();
        for knot in self.knots.iter().filter(|knot| !knot.position.is_finite()) {
            problems.push(WebError::NotFinite { knot: knot.label.clone() });
        }
        for rope in 0..self.ropes.len() {
            problems.extend(self.check_rope(rope));
        }
        problems.extend(self.check_connected());
        problems
    }

    /// The first fault of a rope.
    fn check_rope(&self, index: usize) -> Option<WebError> {
        let rope = &self.ropes[index];
        let label = rope.label.clone();
        let (a, b) = (&self.knots[rope.a], &self.knots[rope.b]);
        if rope.a == rope.b {
            return Some(WebError::SelfLoop { rope: index, label, knot: a.label.clone() });
        }
        if rope.segments == Some(0) {
            return Some(WebError::NoSegments { rope: index, label });
        }
        match rope.rest_length {
            Some(value) if !(value > 0.0 && value.is_finite()) => {
                Some(WebError::RestLength { rope: index, label, value })
            }
            None if a.position == b.position => {
                Some(WebError::ZeroLength { rope: index, label, a: a.label.clone(), b: b.label.clone() })
            }
            _ => None,
        }
    }

    /// An error if the web is in several pieces.
    fn check_connected(&self) -> Option<WebError> {
        let mut pieces = Pieces::new(self.knots.len());
        for rope in &self.ropes {
            pieces.join(rope.a, rope.b);
        }
        for canopy in &self.canopies {
            for &corner in &canopy.rim {
                pieces.join(canopy.hub, corner);
            }
        }
        let first = pieces.root(0);
        let apart = (0..self.knots.len()).find(|&knot| pieces.root(knot) != first)?;
        let count = (0..self.knots.len()).filter(|&knot| pieces.root(knot) == knot).count();
        let label = |knot: usize| self.knots[knot].label.clone();
        Some(WebError::Disconnected { a: label(0), b: label(apart), pieces: count })
    }
}

/// Connected pieces of a web: disjoint sets of knots, each represented by its first knot (union-find with path halving:
/// Tarjan and van Leeuwen, J. ACM 31 (1984) 245-281).
#[derive(Debug, Clone)]
pub struct Pieces {
    parent: Vec<usize>,
}

impl Pieces {
    /// `count` knots, each a piece of its own.
    pub fn new(count: usize) -> Pieces {
        Pieces { parent: (0..count).collect() }
    }

    /// The first knot of the piece to which `knot` belongs.
    pub fn root(&mut self, mut knot: usize) -> usize {
        while self.parent[knot] != knot {
            // halve the path on the way up
            self.parent[knot] = self.parent[self.parent[knot]];
            knot = self.parent[knot];
        }
        knot
    }

    /// Joins the pieces of two knots.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }
}

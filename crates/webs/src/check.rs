//! Whether a web can be made: all that is wrong with it, at once.

use crate::{Pieces, Web, WebError};

impl Web {
    /// Everything that is wrong with the web: no knots or ropes, coordinates that are no numbers, ropes without a
    /// length, loops, and pieces that nothing joins (ropes and canopies do).
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

    fn check_connected(&self) -> Option<WebError> {
        let mut pieces = Pieces::new(self.knots.len());
        for rope in &self.ropes {
            pieces.join(rope.a, rope.b);
        }
        for canopy in &self.canopies {
            canopy.rim.iter().for_each(|&corner| pieces.join(canopy.hub, corner));
        }
        let first = pieces.root(0);
        let stranger = (0..self.knots.len()).find(|&knot| pieces.root(knot) != first)?;
        let count = (0..self.knots.len()).filter(|&knot| pieces.root(knot) == knot).count();
        let label = |knot: usize| self.knots[knot].label.clone();
        Some(WebError::Disconnected { a: label(0), b: label(stranger), pieces: count })
    }
}

//! Which knots hang together.

/// Disjoint sets of knots, each known by its first.
#[derive(Debug, Clone)]
pub struct Pieces {
    parent: Vec<usize>,
}

impl Pieces {
    /// Every knot alone.
    pub fn new(count: usize) -> Pieces {
        Pieces { parent: (0..count).collect() }
    }

    /// The first knot of those that a knot is joined to.
    pub fn root(&mut self, mut knot: usize) -> usize {
        while self.parent[knot] != knot {
            // halve the path on the way up
            self.parent[knot] = self.parent[self.parent[knot]];
            knot = self.parent[knot];
        }
        knot
    }

    /// Makes one of the sets of two knots.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }
}

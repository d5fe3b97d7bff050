//! A piece of rope between two nodes: what its law needs to know of it.

use glam::DVec3;

use super::breaking::Breaking;

/// A piece of rope between two nodes: spring and damper along one line, pulling only (the paper's Figure 6) unless the law
/// of its group says otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The two nodes that it joins.
    pub ends: [usize; 2],
    /// Length without tension, m.
    pub rest_length: f64,
    /// Stiffness k = EA / rest length, N/m.
    pub stiffness: f64,
    /// Damping c against the rate of stretch, N s/m.
    pub damping: f64,
    /// Group, an index below [`System::group_count`](crate::system::System::group_count).
    pub group: usize,
    /// The load and the strain at which it breaks.
    pub breaking: Breaking,
}

impl Segment {
    /// The other end of this segment, seen from `node`.
    pub fn other_end(&self, node: usize) -> usize {
        if self.ends[0] == node { self.ends[1] } else { self.ends[0] }
    }

    /// Its stretch with all nodes at `position`, m.
    pub fn stretch(&self, position: &[DVec3]) -> f64 {
        let [a, b] = self.ends;
        (position[b] - position[a]).length() - self.rest_length
    }
}

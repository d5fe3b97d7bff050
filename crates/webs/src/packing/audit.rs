//! The audit of a stowed web: which members are stretched, how much energy they store, and the size of the packed web.

use std::f64::consts::PI;

use glam::DVec3;

/// A tension member between two nodes: a segment of rope or a member of canopy fabric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StowedSegment {
    /// Node at its beginning.
    pub a: usize,
    /// Node at its end.
    pub b: usize,
    /// Rest length, m.
    pub rest_length: f64,
    /// Stiffness EA / rest length, N/m.
    pub stiffness: f64,
}

/// The member with the largest relative stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LongestStretch {
    /// Its index among the members audited.
    pub segment: usize,
    /// Stowed length over rest length, less 1: positive where stretched, negative where slack.
    pub stretch: f64,
}

/// Size of the smallest cylinder about the launch axis that holds all nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Largest distance of a node from the launch axis, m.
    pub radius: f64,
    /// Distance along the launch axis from the lowest node to the highest, m.
    pub height: f64,
}

impl Size {
    /// The size for nodes at these positions in the launch frame, m; zero without nodes.
    pub fn of(positions: impl Iterator<Item = DVec3>) -> Size {
        let (mut radius, mut least, mut most) = (0.0_f64, f64::INFINITY, f64::NEG_INFINITY);
        for position in positions {
            radius = radius.max(position.truncate().length());
            (least, most) = (least.min(position.z), most.max(position.z));
        }
        Size { radius, height: (most - least).max(0.0) }
    }

    /// Volume of the cylinder, m^3.
    pub fn volume(&self) -> f64 {
        PI * self.radius * self.radius * self.height
    }
}

/// Stretch, stored energy and size of a stowed web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Audit {
    /// The member with the largest stretch, the first of equals; none without members.
    pub longest: Option<LongestStretch>,
    /// Number of members that are stretched by more than [`Audit::TOLERANCE`].
    pub stretched: usize,
    /// Elastic energy of all stretched members, J: the sum of k d^2 / 2 over stretches d > 0.
    pub stored_energy: f64,
    /// Largest distance of a node from the launch axis, m.
    pub packed_radius: f64,
    /// Distance along the launch axis from the lowest node to the highest, m.
    pub packed_height: f64,
}

impl Audit {
    /// Largest relative stretch that is ascribed to rounding.
    pub const TOLERANCE: f64 = 1e-9;

    /// Whether no member is stretched.
    pub fn is_slack(&self) -> bool {
        self.stretched == 0
    }
}

/// Audits the members between nodes at these positions in the launch frame, m, (nodes,).
///
/// # Panics
/// If a member names a node without a position.
pub fn audit(positions: &[DVec3], segments: impl IntoIterator<Item = StowedSegment>) -> Audit {
    let mut longest: Option<LongestStretch> = None;
    let (mut stretched, mut stored_energy) = (0, 0.0);
    for (segment, StowedSegment { a, b, rest_length, stiffness }) in segments.into_iter().enumerate() {
        let extension = positions[a].distance(positions[b]) - rest_length;
        let stretch = extension / rest_length;
        if longest.is_none_or(|longest| stretch > longest.stretch) {
            longest = Some(LongestStretch { segment, stretch });
        }
        stretched += usize::from(stretch > Audit::TOLERANCE);
        stored_energy += 0.5 * stiffness * extension.max(0.0) * extension.max(0.0);
    }
    let Size { radius: packed_radius, height: packed_height } = Size::of(positions.iter().copied());
    Audit { longest, stretched, stored_energy, packed_radius, packed_height }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_stretch_the_stored_energy_and_the_size_are_found() {
        let positions = [DVec3::ZERO, DVec3::new(3.0, 0.0, -4.0), DVec3::new(3.0, 4.0, 1.0)];
        let member = |a, b, rest_length| StowedSegment { a, b, rest_length, stiffness: 1000.0 };
        let audit = audit(&positions, [member(0, 1, 10.0), member(0, 1, 4.0), member(1, 2, 7.0)]);
        assert_eq!(audit.longest, Some(LongestStretch { segment: 1, stretch: 0.25 }));
        assert_eq!((audit.stretched, audit.is_slack()), (1, false));
        assert!((audit.stored_energy - 500.0).abs() < 1e-9);
        assert_eq!((audit.packed_radius, audit.packed_height), (5.0, 5.0));
    }

    #[test]
    fn a_stretch_by_rounding_does_not_count() {
        let positions = [DVec3::ZERO, DVec3::X * (1.0 + 1e-14)];
        let audit = audit(&positions, [StowedSegment { a: 0, b: 1, rest_length: 1.0, stiffness: 1e6 }]);
        assert!(audit.is_slack());
        assert!(audit.stored_energy < 1e-20);
    }
}

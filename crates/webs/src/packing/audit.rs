//! The audit of a stowed web: whether anything is stretched, what energy that stores, and how much room the web
//! takes.

use std::f64::consts::PI;

use glam::DVec3;

/// A tension member between two nodes, whether rope or canopy fabric.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StowedSegment {
    /// Node it begins at.
    pub a: usize,
    /// Node it ends at.
    pub b: usize,
    /// Length without tension, m.
    pub rest_length: f64,
    /// Stiffness EA / rest length, N/m.
    pub stiffness: f64,
}

/// The member that is nearest to being stretched, or stretched most.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LongestStretch {
    /// Its index among the members audited.
    pub segment: usize,
    /// Its stowed length over its rest length, less 1: positive where stretched, negative where slack.
    pub stretch: f64,
}

/// The smallest cylinder about the launch axis that holds some nodes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    /// Largest distance of a node from the launch axis, m.
    pub radius: f64,
    /// Distance along the launch axis from the lowest node to the highest, m.
    pub height: f64,
}

impl Size {
    /// That of nodes at these positions in the launch frame, m; 0 where there are none.
    pub fn of(positions: impl Iterator<Item = DVec3>) -> Size {
        let (mut radius, mut least, mut most) = (0.0_f64, f64::INFINITY, f64::NEG_INFINITY);
        for position in positions {
            radius = radius.max(position.truncate().length());
            (least, most) = (least.min(position.z), most.max(position.z));
        }
        Size { radius, height: (most - least).max(0.0) }
    }

    /// Its volume, m^3.
    pub fn volume(&self) -> f64 {
        PI * self.radius * self.radius * self.height
    }
}

/// What a stowed web is like.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Audit {
    /// The member stretched most; none where there are no members. The first of equals.
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
    /// A stretch (relative) that rounding explains.
    pub const TOLERANCE: f64 = 1e-9;

    /// Whether no member is stretched.
    pub fn is_slack(&self) -> bool {
        self.stretched == 0
    }
}

/// Audits positions in the launch frame, m, and the members between them.
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
    fn one_stretched_and_one_slack_member() {
        let positions = [DVec3::ZERO, DVec3::new(3.0, 0.0, -4.0), DVec3::new(3.0, 4.0, 1.0)];
        let member = |a, b, rest_length| StowedSegment { a, b, rest_length, stiffness: 1000.0 };
        let audit = audit(&positions, [member(0, 1, 10.0), member(0, 1, 4.0), member(1, 2, 7.0)]);
        assert_eq!(audit.longest, Some(LongestStretch { segment: 1, stretch: 0.25 }));
        assert_eq!((audit.stretched, audit.is_slack()), (1, false));
        assert!((audit.stored_energy - 500.0).abs() < 1e-9);
        assert_eq!((audit.packed_radius, audit.packed_height), (5.0, 5.0));
    }

    #[test]
    fn rounding_is_no_stretch() {
        let positions = [DVec3::ZERO, DVec3::X * (1.0 + 1e-14)];
        let audit = audit(&positions, [StowedSegment { a: 0, b: 1, rest_length: 1.0, stiffness: 1e6 }]);
        assert!(audit.is_slack());
        assert!(audit.stored_energy < 1e-20);
    }
}

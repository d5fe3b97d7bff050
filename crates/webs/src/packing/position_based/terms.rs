//! What a prescribed packing is given, and how it says that it came to rest.

use glam::DVec3;

use crate::packing::{Mouth, StiffPlate};

/// How a web is brought into its container. Lengths in m, times in s.
#[derive(Debug, Clone, PartialEq)]
pub struct Prescribed {
    /// Radius of the container.
    pub radius: f64,
    /// How far its floor lies below the flat web; none: it has no floor.
    pub depth: Option<f64>,
    /// The driven nodes and their paths; none: the outline is drawn in, to a ring of the container's radius.
    pub paths: Vec<DrivenNode>,
    /// Time in which the outline is drawn in.
    pub time: f64,
    /// Acceleration into the container, m/s^2.
    pub gravity: f64,
    /// Mass-proportional damping, 1/s.
    pub damping: f64,
    /// The web is at rest when its kinetic energy is at most this share of its largest kinetic energy.
    pub rest: f64,
    /// The motion ends at this time even if the web is not at rest, but not before the last path ends.
    pub longest: f64,
    /// Mass of each node, kg, (nodes,).
    pub mass: Vec<f64>,
    /// The canopies that keep their shape.
    pub plates: Vec<StiffPlate>,
    /// Where the tractors stand.
    pub mouth: Mouth,
}

/// A node and the path that it is driven along.
#[derive(Debug, Clone, PartialEq)]
pub struct DrivenNode {
    /// Which node.
    pub node: usize,
    /// Times, s, ascending, and displacements from its place in the flat web, m, in the launch frame. The node moves
    /// straight and at constant speed from one point to the next. It rests before the first and after the last.
    pub path: Vec<(f64, DVec3)>,
}

/// How a packing came to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settled {
    /// When the motion ended, s.
    pub time: f64,
    /// The kinetic energy then, as a share of its largest value.
    pub share: f64,
}

impl DrivenNode {
    /// The displacement at a time, m.
    pub(super) fn at(&self, time: f64) -> DVec3 {
        let after = self.path.partition_point(|&(t, _)| t <= time);
        match (after, self.path.get(after)) {
            (_, None) => self.path[after - 1].1,
            (0, Some(first)) => first.1,
            (_, Some(&(t1, by))) => {
                let (t0, from) = self.path[after - 1];
                from + (time - t0) / (t1 - t0) * (by - from)
            }
        }
    }

    /// When the path ends, s.
    pub(super) fn end(&self) -> f64 {
        self.path[self.path.len() - 1].0
    }
}

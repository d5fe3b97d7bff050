//! Input of a prescribed packing, and how it came to rest.

use glam::DVec3;

use crate::packing::{Mouth, StiffPlate};

/// Input of a prescribed packing. Lengths in m, times in s.
#[derive(Debug, Clone, PartialEq)]
pub struct Prescribed {
    /// Radius of the container.
    pub radius: f64,
    /// Distance from the container's floor up to the flat web; none: there is no floor.
    pub depth: Option<f64>,
    /// Driven nodes and their paths. Empty: the outline is drawn in to a ring of the container's radius.
    pub paths: Vec<DrivenNode>,
    /// Duration of drawing in the outline.
    pub time: f64,
    /// Acceleration of gravity into the container, m/s^2.
    pub gravity: f64,
    /// Mass-proportional damping, 1/s.
    pub damping: f64,
    /// Share of its largest kinetic energy at or below which the web is at rest.
    pub rest: f64,
    /// Longest duration of the motion: it ends then even if the web is not at rest, but not before the last path ends.
    pub longest: f64,
    /// Mass of each node, kg, (nodes,).
    pub mass: Vec<f64>,
    /// Stiff canopies.
    pub plates: Vec<StiffPlate>,
    /// Places of the tractors.
    pub mouth: Mouth,
}

/// A node and the path that it is driven along.
#[derive(Debug, Clone, PartialEq)]
pub struct DrivenNode {
    /// Index of the node.
    pub node: usize,
    /// Points of the path: ascending times, s, and displacements from the flat web in the launch frame, m; at least
    /// one. The node moves straight and at constant speed from point to point. It rests before the first and after the
    /// last point.
    pub path: Vec<(f64, DVec3)>,
}

/// How a packing came to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settled {
    /// Time at which the motion ended, s.
    pub time: f64,
    /// Kinetic energy at that time, as a share of its largest value.
    pub share: f64,
}

impl DrivenNode {
    /// Displacement at a time, s, in m.
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

    /// Time at which the path ends, s.
    pub(super) fn end(&self) -> f64 {
        self.path[self.path.len() - 1].0
    }
}

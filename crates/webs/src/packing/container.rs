//! The container of a packed web: a tube or a box.

use std::f64::consts::SQRT_2;
use std::fmt;

use glam::DVec3;

/// A container about the launch axis, open at the top. Sizes are inside sizes, in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Container {
    /// A tube.
    Cylinder {
        /// Radius.
        radius: f64,
        /// Its height along the launch axis.
        height: f64,
    },
    /// A box.
    Box {
        /// Size along x.
        width: f64,
        /// Size along y.
        breadth: f64,
        /// Its height along the launch axis.
        height: f64,
    },
}

impl Container {
    /// Height along the launch axis, m.
    pub fn height(&self) -> f64 {
        let (Container::Cylinder { height, .. } | Container::Box { height, .. }) = *self;
        height
    }

    /// Radius of the largest circle in the cross-section, m.
    pub fn radius(&self) -> f64 {
        match *self {
            Container::Cylinder { radius, .. } => radius,
            Container::Box { width, breadth, .. } => 0.5 * width.min(breadth),
        }
    }

    /// Width and breadth of the largest rectangle in the cross-section, m.
    pub(super) fn rectangle(&self) -> [f64; 2] {
        match *self {
            Container::Cylinder { radius, .. } => [SQRT_2 * radius; 2],
            Container::Box { width, breadth, .. } => [width, breadth],
        }
    }

    /// Whether the container holds all points if its mouth lies at the height of the highest point, up to rounding.
    pub(super) fn holds(&self, points: impl Iterator<Item = DVec3>) -> bool {
        let room = 1.0 + 1e-9;
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        for point in points {
            let is_within = match *self {
                Container::Cylinder { radius, .. } => point.truncate().length() <= radius * room,
                Container::Box { width, breadth, .. } => {
                    point.x.abs() <= 0.5 * width * room && point.y.abs() <= 0.5 * breadth * room
                }
            };
            if !is_within {
                return false;
            }
            (lowest, highest) = (lowest.min(point.z), highest.max(point.z));
        }
        highest - lowest <= self.height() * room
    }

    /// The container with each size, m, replaced by `change` of it.
    pub(super) fn with_sizes(&self, change: impl Fn(f64) -> f64) -> Container {
        match *self {
            Container::Cylinder { radius, height } => {
                Container::Cylinder { radius: change(radius), height: change(height) }
            }
            Container::Box { width, breadth, height } => {
                Container::Box { width: change(width), breadth: change(breadth), height: change(height) }
            }
        }
    }

    /// The room for the centre lines of ropes of this thickness, m: half a thickness away from every wall.
    pub(super) fn for_centre_lines(&self, thickness: f64) -> Container {
        match *self {
            Container::Cylinder { radius, height } => Container::Cylinder {
                radius: (radius - 0.5 * thickness).max(0.0),
                height: (height - thickness).max(0.0),
            },
            Container::Box { .. } => self.with_sizes(|size| (size - thickness).max(0.0)),
        }
    }
}

impl fmt::Display for Container {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Container::Cylinder { radius, height } => {
                write!(formatter, "a cylinder of radius {radius} m and height {height} m")
            }
            Container::Box { width, breadth, height } => {
                write!(formatter, "a box of width {width} m, breadth {breadth} m and height {height} m")
            }
        }
    }
}

//! The medium that a net flies through: its density, its viscosity and its wind.

pub mod atmosphere;
pub mod turbulence;
pub mod wind;

use glam::{DQuat, DVec3};

use crate::forces::body_drag::Shape;
use crate::forces::rope_drag::RopeDrag;
use crate::forces::sheet_drag::SheetDrag;
use atmosphere::Medium;
use wind::Wind;

/// The medium around a net, its wind, and the parts of the net that have drag.
#[derive(Debug, Clone, PartialEq)]
pub struct Air {
    /// Density and viscosity.
    pub medium: Medium,
    /// Velocity of the medium over height and time.
    pub wind: Wind,
    /// Drag of the ropes of each group; `None` for a group without drag. Shape (groups,).
    pub ropes: Vec<Option<RopeDrag>>,
    /// Triangles of sheets that have drag.
    pub sheets: Vec<SheetDrag>,
    /// Bodies and point masses that have drag.
    pub bodies: Vec<BodyDrag>,
    /// Added mass of ropes for motion across them, over the mass of the displaced medium; 0 for none.
    pub added_mass: f64,
    /// Largest speed of the wind relative to the net at which the step must be stable, m/s.
    pub fastest: f64,
}

/// The drag of a rigid body, or of a point mass with a shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyDrag {
    /// The node at its centre.
    pub node: usize,
    /// Its orientation.
    pub attitude: Attitude,
    /// Its shape, along its own axes.
    pub shape: Shape,
}

/// Orientation of a shape that has drag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attitude {
    /// Constant: rotation from the axes of the shape to the world's.
    Fixed(DQuat),
    /// That of a rigid body, an index in [`SystemParts::bodies`](crate::parts::SystemParts::bodies).
    Body(usize),
}

impl Air {
    /// Velocity, m/s, at a `height` above the muzzle, m. `gust`: velocity added to the mean, m/s.
    #[inline(always)]
    pub(crate) fn wind(&self, height: f64, gust: DVec3) -> DVec3 {
        self.wind.direction * self.wind.mean.at(height) + gust
    }

    /// A medium with wind, in which no part of the net has drag yet.
    pub fn new(medium: Medium, wind: Wind) -> Air {
        Air { medium, wind, ropes: Vec::new(), sheets: Vec::new(), bodies: Vec::new(), added_mass: 0.0, fastest: 0.0 }
    }
}

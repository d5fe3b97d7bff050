//! The medium that a net flies through: how dense it is, how viscous, how it moves.

pub mod atmosphere;
pub mod turbulence;
pub mod wind;

use glam::{DQuat, DVec3};

use crate::forces::body_drag::Shape;
use crate::forces::rope_drag::RopeDrag;
use crate::forces::sheet_drag::SheetDrag;
use atmosphere::Medium;
use wind::Wind;

/// The medium around a net, how it moves, and which parts of the net have drag.
#[derive(Debug, Clone, PartialEq)]
pub struct Air {
    /// Density and viscosity.
    pub medium: Medium,
    /// How it moves.
    pub wind: Wind,
    /// How the ropes of each link class drag; none where a class does not. Shape (classes,).
    pub ropes: Vec<Option<RopeDrag>>,
    /// Triangles that drag.
    pub sheets: Vec<SheetDrag>,
    /// Bodies that drag.
    pub bodies: Vec<BodyDrag>,
    /// Added mass of ropes across their length, over the mass of the medium that they displace; 0 leaves it out.
    pub added_mass: f64,
    /// The fastest wind relative to the net for which the step has to be stable, m/s.
    pub fastest: f64,
}

/// A body, or a mass of some shape, that drags.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyDrag {
    /// The node at its centre.
    pub node: usize,
    /// How it is turned.
    pub attitude: Attitude,
    /// Its shape, along its own axes.
    pub shape: Shape,
}

/// How what drags is turned to the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attitude {
    /// Always like this.
    Fixed(DQuat),
    /// As this rigid body, an index in [`SystemParts::bodies`](crate::parts::SystemParts::bodies).
    Body(usize),
}

impl Air {
    /// Velocity, m/s, at a height above the muzzle, m, with what is added to the mean then.
    #[inline(always)]
    pub(crate) fn wind(&self, height: f64, gust: DVec3) -> DVec3 {
        self.wind.direction * self.wind.mean.at(height) + gust
    }

    /// Nothing that drags as yet, in a medium that moves.
    pub fn new(medium: Medium, wind: Wind) -> Air {
        Air { medium, wind, ropes: Vec::new(), sheets: Vec::new(), bodies: Vec::new(), added_mass: 0.0, fastest: 0.0 }
    }
}

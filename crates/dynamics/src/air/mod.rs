//! The medium that a net flies through: how dense it is, how viscous, how it moves.

pub mod atmosphere;
pub mod turbulence;
pub mod wind;

use glam::DVec3;

use atmosphere::Medium;
use wind::Wind;

/// What surrounds a net and drags at it.
#[derive(Debug, Clone, PartialEq)]
pub struct Air {
    /// Density and viscosity.
    pub medium: Medium,
    /// How it moves.
    pub wind: Wind,
}

impl Air {
    /// Density, kg/m^3, at a height above the muzzle, m.
    #[inline(always)]
    pub fn density(&self, height: f64) -> f64 {
        self.medium.density(height)
    }

    /// Velocity, m/s, at a height above the muzzle, m, and a time, s.
    pub fn velocity(&self, height: f64, time: f64) -> DVec3 {
        self.wind.at(height, time)
    }
}

//! `[payload.SHAPE]`, `[sensor.SHAPE]`, `[tractor.SHAPE]`: the solid bodies that the web carries.

use std::f64::consts::PI;

use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::Positive;
use crate::quantity::{Density, Length, Mass};

/// A solid body: one table, named after its shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Body {
    /// A solid cylinder.
    Cylinder(Cylinder),
    /// A mass without size.
    Particle(Particle),
}

/// A solid cylinder. What is left out is that of a payload (60 mm x 66 mm, 2710 kg/m^3) or of a tractor (0.1 m x 0.2 m,
/// 17700 kg/m^3). Its mass follows from its density, or is given instead.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["density", "mass"]}))]
pub struct Cylinder {
    /// Diameter, m. Default: 60 mm for a payload or sensor, 0.1 m for a tractor.
    pub diameter: Option<Length<Positive>>,
    /// Height, m. Default: 66 mm for a payload or sensor, 0.2 m for a tractor.
    pub height: Option<Length<Positive>>,
    /// Density, kg/m^3. Default, where no mass is given: 2710 for a payload or sensor, 17700 for a tractor.
    pub density: Option<Density<Positive>>,
    /// Mass, kg, instead of the density.
    pub mass: Option<Mass<Positive>>,
}

/// A mass without size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Particle {
    /// Mass, kg.
    pub mass: Mass<Positive>,
}

/// The size and density of a cylinder for which nothing is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CylinderDefaults {
    diameter: Length<Positive>,
    height: Length<Positive>,
    density: Density<Positive>,
}

impl CylinderDefaults {
    /// A payload or sensor: aluminium.
    pub(crate) const PAYLOAD: Self =
        Self { diameter: Length::constant(0.06), height: Length::constant(0.066), density: Density::constant(2710.0) };

    /// A tractor: tungsten alloy.
    pub(crate) const TRACTOR: Self =
        Self { diameter: Length::constant(0.1), height: Length::constant(0.2), density: Density::constant(17700.0) };
}

/// A body with everything that was left out filled in, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// A solid cylinder.
    Cylinder {
        /// Diameter, m.
        diameter_m: f64,
        /// Height, m.
        height_m: f64,
        /// Mass, kg.
        mass_kg: f64,
    },
    /// A mass without size.
    Particle {
        /// Mass, kg.
        mass_kg: f64,
    },
}

impl Solid {
    /// Mass, kg.
    pub fn mass_kg(&self) -> f64 {
        match *self {
            Self::Cylinder { mass_kg, .. } | Self::Particle { mass_kg } => mass_kg,
        }
    }

    /// Moments of inertia about its axes through its centre, the last its own axis, kg m^2; none for a particle.
    pub fn inertia_kg_m2(&self) -> Option<DVec3> {
        match *self {
            Self::Cylinder { diameter_m: d, height_m: h, mass_kg } => {
                let across = d * d / 16.0 + h * h / 12.0;
                Some(mass_kg * DVec3::new(across, across, d * d / 8.0))
            }
            Self::Particle { .. } => None,
        }
    }

    /// How far it reaches from its axis, m; 0 for a particle.
    pub fn radius_m(&self) -> f64 {
        match *self {
            Self::Cylinder { diameter_m, .. } => 0.5 * diameter_m,
            Self::Particle { .. } => 0.0,
        }
    }

    /// Volume, m^3; 0 for a particle.
    pub fn volume_m3(&self) -> f64 {
        match *self {
            Self::Cylinder { diameter_m, height_m, .. } => cylinder_volume(diameter_m, height_m),
            Self::Particle { .. } => 0.0,
        }
    }
}

fn cylinder_volume(diameter: f64, height: f64) -> f64 {
    PI / 4.0 * diameter * diameter * height
}

impl Body {
    /// The body with `defaults` for what was left out.
    pub(crate) fn solid(&self, defaults: &CylinderDefaults) -> Solid {
        match self {
            Self::Particle(particle) => Solid::Particle { mass_kg: particle.mass.si() },
            Self::Cylinder(cylinder) => {
                let diameter_m = cylinder.diameter.unwrap_or(defaults.diameter).si();
                let height_m = cylinder.height.unwrap_or(defaults.height).si();
                let density = cylinder.density.unwrap_or(defaults.density).si();
                let volume = cylinder_volume(diameter_m, height_m);
                let mass_kg = cylinder.mass.map_or(density * volume, |mass| mass.si());
                Solid::Cylinder { diameter_m, height_m, mass_kg }
            }
        }
    }

    /// Writes the defaults of a cylinder out.
    pub(crate) fn complete(&mut self, defaults: &CylinderDefaults) {
        let Self::Cylinder(cylinder) = self else { return };
        cylinder.diameter.get_or_insert(defaults.diameter);
        cylinder.height.get_or_insert(defaults.height);
        if cylinder.mass.is_none() {
            cylinder.density.get_or_insert(defaults.density);
        }
    }
}

impl Cylinder {
    /// This cylinder, with what it leaves out taken from `base`.
    pub(crate) fn over(&self, base: &Self) -> Self {
        let says_mass = self.density.is_some() || self.mass.is_some();
        Self {
            diameter: self.diameter.or(base.diameter),
            height: self.height.or(base.height),
            density: if says_mass { self.density } else { base.density },
            mass: if says_mass { self.mass } else { base.mass },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mass_kg(body: Body, defaults: &CylinderDefaults) -> f64 {
        body.solid(defaults).mass_kg()
    }

    #[test]
    fn the_papers_payload_and_tractor_weigh_what_they_should() {
        let payload = mass_kg(Body::Cylinder(Cylinder::default()), &CylinderDefaults::PAYLOAD);
        let tractor = mass_kg(Body::Cylinder(Cylinder::default()), &CylinderDefaults::TRACTOR);
        assert!((payload - 0.506).abs() < 0.0005, "{payload}");
        assert!((tractor - 27.80).abs() < 0.005, "{tractor}");
    }

    #[test]
    fn a_given_mass_replaces_the_density() {
        let given = Cylinder { mass: Some(Mass::constant(3.0)), ..Cylinder::default() };
        let base = Cylinder { density: Some(Density::constant(1000.0)), ..Cylinder::default() };
        assert_eq!(mass_kg(Body::Cylinder(given.over(&base)), &CylinderDefaults::TRACTOR), 3.0);
        assert_eq!(given.over(&base).density, None);
    }
}

//! `[payload.SHAPE]`, `[sensor.SHAPE]`, `[tractor.SHAPE]`: the solid bodies that the web carries.
//!
//! A body has axes x, y, z of its own, and its height lies along z. The z axis of a tractor points in the direction
//! of flight.

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
    /// A solid sphere.
    Sphere(Sphere),
    /// A solid box.
    Box(Cuboid),
    /// A mass without size.
    Particle(Particle),
}

/// A solid cylinder. Its mass is given by either `density` or `mass`. The defaults are those of a payload (60 mm x 66
/// mm, 2710 kg/m^3) or of a tractor (0.1 m x 0.2 m, 17700 kg/m^3).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["density", "mass"]}))]
pub struct Cylinder {
    /// Diameter, m. Default: 60 mm for a payload or sensor, 0.1 m for a tractor.
    pub diameter: Option<Length<Positive>>,
    /// Height, m. Default: 66 mm for a payload or sensor, 0.2 m for a tractor.
    pub height: Option<Length<Positive>>,
    /// Density, kg/m^3. Default, unless `mass` is given: 2710 for a payload or sensor, 17700 for a tractor.
    pub density: Option<Density<Positive>>,
    /// Mass, kg. It replaces the density.
    pub mass: Option<Mass<Positive>>,
}

/// A solid sphere. Its mass is given by either `density` or `mass`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["density", "mass"]}))]
pub struct Sphere {
    /// Diameter, m.
    pub diameter: Length<Positive>,
    /// Density, kg/m^3. Default, unless `mass` is given: 2710 for a payload or sensor, 17700 for a tractor.
    pub density: Option<Density<Positive>>,
    /// Mass, kg. It replaces the density.
    pub mass: Option<Mass<Positive>>,
}

/// A solid box. Its mass is given by either `density` or `mass`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["density", "mass"]}))]
pub struct Cuboid {
    /// Size along its x axis, m. The x axis of a tractor points away from the launch axis.
    pub width: Length<Positive>,
    /// Size along its y axis, m. The y axis of a tractor points around the launch axis.
    pub depth: Length<Positive>,
    /// Size along its z axis, m. The z axis of a tractor points in the direction of flight.
    pub height: Length<Positive>,
    /// Density, kg/m^3. Default, unless `mass` is given: 2710 for a payload or sensor, 17700 for a tractor.
    pub density: Option<Density<Positive>>,
    /// Mass, kg. It replaces the density.
    pub mass: Option<Mass<Positive>>,
}

/// A mass without size.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Particle {
    /// Mass, kg.
    pub mass: Mass<Positive>,
    /// Diameter of the sphere as which the air acts on it, m. Default: none; the air does not act on it.
    pub diameter: Option<Length<Positive>>,
}

/// Defaults for the density of a body and for the sizes of a cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyDefaults {
    diameter: Length<Positive>,
    height: Length<Positive>,
    density: Density<Positive>,
}

impl BodyDefaults {
    /// A payload or sensor: aluminium.
    pub(crate) const PAYLOAD: Self =
        Self { diameter: Length::constant(0.06), height: Length::constant(0.066), density: Density::constant(2710.0) };

    /// A tractor: tungsten alloy.
    pub(crate) const TRACTOR: Self =
        Self { diameter: Length::constant(0.1), height: Length::constant(0.2), density: Density::constant(17700.0) };
}

/// The shape of a body, with its sizes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A cylinder about its z axis: diameter and height, m.
    Cylinder {
        /// Diameter, m.
        diameter_m: f64,
        /// Height, m.
        height_m: f64,
    },
    /// A sphere.
    Sphere {
        /// Diameter, m.
        diameter_m: f64,
    },
    /// A box.
    Box {
        /// Size along its axes x, y, z, m.
        size_m: [f64; 3],
    },
    /// A mass without size.
    Particle {
        /// Diameter of the sphere as which the air acts on it, m.
        diameter_m: Option<f64>,
    },
}

/// A body with every default filled in, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// Its shape and sizes.
    pub shape: Shape,
    /// Mass, kg.
    pub mass_kg: f64,
}

impl Shape {
    /// Largest distance of its surface from its z axis, m; 0 for a particle.
    pub fn radius_m(&self) -> f64 {
        match *self {
            Self::Cylinder { diameter_m, .. } | Self::Sphere { diameter_m } => 0.5 * diameter_m,
            Self::Box { size_m: [x, y, _] } => 0.5 * (x * x + y * y).sqrt(),
            Self::Particle { .. } => 0.0,
        }
    }

    /// Least distance of its surface from its centre, m; 0 for a particle without a diameter.
    pub fn least_reach_m(&self) -> f64 {
        match *self {
            Self::Cylinder { diameter_m, height_m } => 0.5 * diameter_m.min(height_m),
            Self::Sphere { diameter_m } => 0.5 * diameter_m,
            Self::Box { size_m } => 0.5 * size_m.into_iter().fold(f64::INFINITY, f64::min),
            Self::Particle { diameter_m } => 0.5 * diameter_m.unwrap_or(0.0),
        }
    }

    /// Volume, m^3; 0 for a particle.
    pub fn volume_m3(&self) -> f64 {
        match *self {
            Self::Cylinder { diameter_m, height_m } => PI / 4.0 * diameter_m * diameter_m * height_m,
            Self::Sphere { diameter_m } => PI / 6.0 * diameter_m * diameter_m * diameter_m,
            Self::Box { size_m: [x, y, z] } => x * y * z,
            Self::Particle { .. } => 0.0,
        }
    }

    /// Moments of inertia about its axes x, y, z through its centre, over its mass, m^2. `None` for a particle.
    fn gyration_squared(&self) -> Option<DVec3> {
        match *self {
            Self::Cylinder { diameter_m: d, height_m: h } => {
                let across = d * d / 16.0 + h * h / 12.0;
                Some(DVec3::new(across, across, d * d / 8.0))
            }
            Self::Sphere { diameter_m: d } => Some(DVec3::splat(d * d / 10.0)),
            Self::Box { size_m } => {
                let [x, y, z] = size_m.map(|size| size * size / 12.0);
                Some(DVec3::new(y + z, z + x, x + y))
            }
            Self::Particle { .. } => None,
        }
    }

    /// The shape that air acts on: for a particle, the sphere of its diameter, or `None` where it has none.
    pub fn in_air(&self) -> Option<Shape> {
        match *self {
            Self::Particle { diameter_m } => diameter_m.map(|diameter_m| Self::Sphere { diameter_m }),
            solid => Some(solid),
        }
    }

    /// Distance of its surface from its centre along the z axis, m.
    pub fn half_height_m(&self) -> f64 {
        match *self {
            Self::Cylinder { height_m, .. } => 0.5 * height_m,
            Self::Sphere { diameter_m } => 0.5 * diameter_m,
            Self::Box { size_m: [_, _, z] } => 0.5 * z,
            Self::Particle { .. } => 0.0,
        }
    }
}

impl Solid {
    /// Moments of inertia about its axes x, y, z through its centre, kg m^2. `None` for a particle.
    pub fn inertia_kg_m2(&self) -> Option<DVec3> {
        self.shape.gyration_squared().map(|squared| self.mass_kg * squared)
    }
}

impl Body {
    /// The body as a solid, with `defaults` for what is left out.
    pub(crate) fn solid(&self, defaults: &BodyDefaults) -> Solid {
        let (shape, density, mass) = match self {
            Self::Particle(Particle { mass, diameter }) => {
                (Shape::Particle { diameter_m: diameter.map(|diameter| diameter.si()) }, None, Some(*mass))
            }
            Self::Cylinder(Cylinder { diameter, height, density, mass }) => {
                let diameter_m = diameter.unwrap_or(defaults.diameter).si();
                let height_m = height.unwrap_or(defaults.height).si();
                (Shape::Cylinder { diameter_m, height_m }, *density, *mass)
            }
            Self::Sphere(Sphere { diameter, density, mass }) => {
                (Shape::Sphere { diameter_m: diameter.si() }, *density, *mass)
            }
            Self::Box(Cuboid { width, depth, height, density, mass }) => {
                (Shape::Box { size_m: [width, depth, height].map(|size| size.si()) }, *density, *mass)
            }
        };
        let density = density.unwrap_or(defaults.density).si();
        let mass_kg = mass.map_or_else(|| density * shape.volume_m3(), |mass| mass.si());
        Solid { shape, mass_kg }
    }

    /// Fills in `defaults` for what is left out.
    pub(crate) fn complete(&mut self, defaults: &BodyDefaults) {
        let (density, mass) = match self {
            Self::Particle(_) => return,
            Self::Cylinder(Cylinder { diameter, height, density, mass }) => {
                diameter.get_or_insert(defaults.diameter);
                height.get_or_insert(defaults.height);
                (density, mass)
            }
            Self::Sphere(Sphere { density, mass, .. }) | Self::Box(Cuboid { density, mass, .. }) => (density, mass),
        };
        if mass.is_none() {
            density.get_or_insert(defaults.density);
        }
    }
}

impl Cylinder {
    /// This cylinder, with what is left out taken from `base`.
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

    fn mass_kg(body: Body, defaults: &BodyDefaults) -> f64 {
        body.solid(defaults).mass_kg
    }

    #[test]
    fn the_default_payload_and_tractor_have_the_masses_of_the_paper() {
        let payload = mass_kg(Body::Cylinder(Cylinder::default()), &BodyDefaults::PAYLOAD);
        let tractor = mass_kg(Body::Cylinder(Cylinder::default()), &BodyDefaults::TRACTOR);
        assert!((payload - 0.506).abs() < 0.0005, "{payload}");
        assert!((tractor - 27.80).abs() < 0.005, "{tractor}");
    }

    #[test]
    fn a_given_mass_replaces_the_density() {
        let given = Cylinder { mass: Some(Mass::constant(3.0)), ..Cylinder::default() };
        let base = Cylinder { density: Some(Density::constant(1000.0)), ..Cylinder::default() };
        assert_eq!(mass_kg(Body::Cylinder(given.over(&base)), &BodyDefaults::TRACTOR), 3.0);
        assert_eq!(given.over(&base).density, None);
    }

    /// Volume, m^3, and second moments about the axes x, y, z, m^5, summed over small cells.
    fn summed(shape: Shape) -> (f64, DVec3) {
        const N: i32 = 60;
        let (half, inside): (DVec3, Box<dyn Fn(DVec3) -> bool>) = match shape {
            Shape::Cylinder { diameter_m: d, height_m: h } => {
                (0.5 * DVec3::new(d, d, h), Box::new(move |x| x.truncate().length() < 0.5 * d))
            }
            Shape::Sphere { diameter_m: d } => (DVec3::splat(0.5 * d), Box::new(move |x| x.length() < 0.5 * d)),
            Shape::Box { size_m } => (0.5 * DVec3::from_array(size_m), Box::new(|_| true)),
            Shape::Particle { .. } => panic!("a particle has no volume"),
        };
        let (mut volume, mut moments) = (0.0, DVec3::ZERO);
        let cell = 8.0 * half.element_product() / f64::from(N * N * N);
        let middle = |i: i32| (f64::from(2 * i + 1) / f64::from(N)) - 1.0;
        for (i, j, k) in (0..N).flat_map(|i| (0..N).flat_map(move |j| (0..N).map(move |k| (i, j, k)))) {
            let x = half * DVec3::new(middle(i), middle(j), middle(k));
            if inside(x) {
                let s = x * x;
                volume += cell;
                moments += cell * DVec3::new(s.y + s.z, s.z + s.x, s.x + s.y);
            }
        }
        (volume, moments)
    }

    #[test]
    fn volume_and_inertia_are_those_of_the_shape_summed_piece_by_piece() {
        let shapes = [
            Shape::Cylinder { diameter_m: 0.1, height_m: 0.3 },
            Shape::Sphere { diameter_m: 0.2 },
            Shape::Box { size_m: [0.1, 0.2, 0.4] },
        ];
        for shape in shapes {
            let (volume, moments) = summed(shape);
            let solid = Solid { shape, mass_kg: 7.0 };
            assert!((shape.volume_m3() / volume - 1.0).abs() < 5e-3, "{shape:?}");
            let ratio = solid.inertia_kg_m2().unwrap() / (7.0 / volume * moments);
            assert!((ratio - DVec3::ONE).abs().max_element() < 1e-2, "{shape:?}: {ratio}");
        }
    }
}

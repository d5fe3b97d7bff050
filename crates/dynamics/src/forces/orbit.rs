//! An orbit: what a net feels that flies beside a circular one (Clohessy & Wiltshire, J. Aerospace Sci. 27, 1960; Hill 1878).
//!
//! ```text
//! x'' = 3 n^2 x + 2 n y'        x away from the planet
//! y'' = -2 n x'                 y the way of the orbit
//! z'' = -n^2 z                  z across it
//! ```
//!
//! from a point on the orbit, in axes that turn with it; n is the mean motion. Valid for distances small against the
//! orbit's radius. Per mass it has the energy -(3 n^2 x^2 - n^2 z^2)/2; the Coriolis part does no work.

use glam::DVec3;

/// A circular orbit through the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// Mean motion n, rad/s.
    pub mean_motion: f64,
    /// Away from the planet, a unit vector in the world frame.
    pub radial: DVec3,
    /// The way of the orbit, a unit vector across it.
    pub along: DVec3,
}

/// Earth's gravitational parameter, m^3/s^2 (WGS 84), and its mean equatorial radius, m.
const EARTH: (f64, f64) = (3.986_004_418e14, 6.378_137e6);

/// Mean motion, rad/s, of a circular orbit about the Earth at this altitude, m: sqrt(GM/r^3).
pub fn mean_motion(altitude: f64) -> f64 {
    let radius = EARTH.1 + altitude;
    (EARTH.0 / (radius * radius * radius)).sqrt()
}

impl Orbit {
    /// Acceleration, m/s^2, at `x`, m, of what moves at `v`, m/s.
    pub fn acceleration(&self, x: DVec3, v: DVec3) -> DVec3 {
        let (n, Orbit { radial, along, .. }) = (self.mean_motion, self);
        let across = radial.cross(*along);
        (3.0 * n * n * x.dot(*radial) + 2.0 * n * v.dot(*along)) * radial
            - 2.0 * n * v.dot(*radial) * along
            - n * n * x.dot(across) * across
    }

    /// Energy of a mass, kg, at `x`, m, in J.
    pub fn energy(&self, mass: f64, x: DVec3) -> f64 {
        let (n, across) = (self.mean_motion, self.radial.cross(self.along));
        let (away, aside) = (x.dot(self.radial), x.dot(across));
        -0.5 * mass * n * n * (3.0 * away * away - aside * aside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_low_orbit_takes_an_hour_and_a_half() {
        // 400 km: 92.4 to 92.6 min
        let period = 2.0 * std::f64::consts::PI / mean_motion(400e3) / 60.0;
        assert!((period - 92.56).abs() < 0.05, "{period} min");
    }

    #[test]
    fn coriolis_does_no_work() {
        let orbit = Orbit { mean_motion: 1e-3, radial: DVec3::Z, along: DVec3::X };
        let v = DVec3::new(3.0, -2.0, 5.0);
        assert!(orbit.acceleration(DVec3::ZERO, v).dot(v).abs() < 1e-18);
    }
}

//! Weight: m g on every node, g uniform (m/s^2).
//!
//! The energy is -m g.x, relative to the origin. Valid where the height flown through is small against the Earth's
//! radius.

use glam::DVec3;

/// Weight of a mass, kg, in N.
#[inline]
pub fn force(gravity: DVec3, mass: f64) -> DVec3 {
    mass * gravity
}

/// Work that the weight of a mass, kg, does on its way from the origin to `x`, m, in J.
#[inline]
pub fn work(gravity: DVec3, mass: f64, x: DVec3) -> f64 {
    mass * gravity.dot(x)
}

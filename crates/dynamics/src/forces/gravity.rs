//! Weight: m g on every node, g uniform (m/s^2).
//!
//! The energy is -m g.x, relative to the origin. Valid where the height flown through is small against the Earth's
//! radius.

use glam::DVec3;

/// Adds every node's weight to `force`, N; `mass` in kg; both (nodes,).
pub fn add_force(gravity: DVec3, mass: &[f64], force: &mut [DVec3]) {
    for (f, &m) in force.iter_mut().zip(mass) {
        *f += m * gravity;
    }
}

/// Potential energy of all nodes relative to the origin, J.
pub fn energy(gravity: DVec3, mass: &[f64], position: &[DVec3]) -> f64 {
    0.0 - position.iter().zip(mass).map(|(x, m)| m * gravity.dot(*x)).sum::<f64>()
}

//! Added mass: the medium that a rope takes along when it moves across its length.
//!
//! ```text
//! M a = F,    M = (m + sum s) 1 - sum s t t^T,    s = C_a rho (pi d^2 / 4) L0 / 2
//! ```
//!
//! at a node of mass m, summed over the segments that meet there; t is a segment's direction, s the mass that half of
//! it takes along, C_a = 1 for a circle (Lamb, Hydrodynamics, 1932, art. 68). It is the founding paper's eqs. (13) to
//! (16) with their matrices in the right order, node by node; docs/theory/air.md. Beside the other forces F it acts as
//! one more, f = m a - F, whose work is told: so M may turn with the rope. The medium itself is taken not to
//! accelerate, and what a rigid body's ties or a tube's push would have to do with it is left out. In air it is 0.07 %
//! of a rope's mass, in water half of it and more.

use glam::{DMat3, DVec3};

/// The force of the medium's inertia, N, on a node of `mass`, kg, on which the others sum to `force`, N. `taken_along`:
/// each segment's mass, kg, and span, m.
pub fn force(mass: f64, force: DVec3, taken_along: impl Iterator<Item = (f64, DVec3)>) -> DVec3 {
    let mut matrix = DMat3::from_diagonal(DVec3::splat(mass));
    for (s, span) in taken_along {
        let t = span.normalize_or_zero();
        matrix += s * (DMat3::IDENTITY - DMat3::from_cols(t * t.x, t * t.y, t * t.z));
    }
    mass * (matrix.inverse() * force) - force
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_rope_is_heavier_across_and_not_along() {
        let arms = || [(0.5, DVec3::X), (0.5, -2.0 * DVec3::X)].into_iter();
        let across = force(1.0, DVec3::Y, arms());
        assert!((across + 0.5 * DVec3::Y).length() < 1e-15, "{across}");
        assert!(force(1.0, DVec3::X, arms()).length() < 1e-15);
        // aslant: each part by its own mass
        let aslant = force(1.0, DVec3::new(3.0, 4.0, 0.0), arms());
        assert!((aslant - DVec3::new(0.0, -2.0, 0.0)).length() < 1e-15, "{aslant}");
    }
}

//! A bar that pulls and pushes.
//!
//! ```text
//! T = k d + c d'          U = k d^2/2          whatever the sign of d
//! ```
//!
//! Hinged at both ends: it has no bending stiffness and does not buckle, so it holds as long as its compression stays
//! below Euler's load, pi^2 EI/L^2, L its whole length between knots; cut into several segments it folds. (Euler 1744;
//! Timoshenko, Gere, Theory of Elastic Stability, 1961, section 2.1.) It is for the stays of a frame, and for rods.

use super::rope_tension::{AxialMotion, Pull};

pub(super) fn pull(along: &AxialMotion, stiffness: f64, damping: f64) -> Pull {
    // one that is broken has no stiffness, and no stretch to speak of
    let elastic = if stiffness > 0.0 { stiffness * along.stretch } else { 0.0 };
    along.with(elastic + damping * along.stretch_rate, elastic)
}

pub(super) fn elastic_energy(stretch: f64, stiffness: f64) -> f64 {
    0.5 * stiffness * stretch * stretch
}

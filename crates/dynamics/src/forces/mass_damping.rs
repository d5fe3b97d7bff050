//! Damping in proportion to mass: -alpha m v on every node, alpha in 1/s.
//!
//! The founding paper's stand-in for air (its section 5.1). It slows everything at the same rate, in the world frame,
//! whatever its size: a body thrown up at v0 rises to v0/alpha - (g/alpha^2) ln(1 + alpha v0/g). It is no model of
//! drag.
//!
//! The step takes it at the middle of the interval (implicitly), which leaves it second order and stable for any alpha:
//!
//! ```text
//! v+ = p v- + q F/m,    p = (1 - alpha dt/2)/(1 + alpha dt/2),    q = dt/(1 + alpha dt/2)
//! ```

/// The factors (p, q) of a step of `dt` seconds; (1, dt) without damping.
pub fn step_factors(damping: f64, dt: f64) -> (f64, f64) {
    let half = 0.5 * damping * dt;
    ((1.0 - half) / (1.0 + half), dt / (1.0 + half))
}

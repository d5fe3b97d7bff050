//! The clock: the scheme, the step, its size.
//!
//! The scheme is the leapfrog (Störmer-Verlet, kick-drift form): velocities live half a step apart from positions.
//!
//! ```text
//! a_n     = F(x_n, w_n)/m                      w_n = v_(n-1/2) + (v_(n-1/2) - v_(n-3/2))/2, velocity extrapolated to n
//! v_(n+1/2) = p v_(n-1/2) + q a_n              p = 1, q = dt without mass damping, see forces::mass_damping
//! x_(n+1) = x_n + dt v_(n+1/2)
//! ```
//!
//! Explicit, one evaluation of forces a step, second order. Where forces do not depend on velocity it is symplectic
//! and time-reversible: nothing is lost, nothing drifts. The extrapolated w_n keeps second order where ropes have
//! internal damping. The velocity *at* n is the mean of its two neighbours. (Hairer, Lubich, Wanner, Geometric
//! Numerical Integration, 2006, section I.1.4; Verlet 1967.)

mod airborne;
pub mod attached;
mod blocks;
mod dragging;
pub(crate) mod elements;
mod grounded;
pub mod launching;
mod lawful;
pub mod readable;
mod rupture;
pub mod step;
pub mod step_size;
mod traced;

use crate::forces::mass_damping;

/// The constants of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepFactors {
    /// Step, s.
    pub dt: f64,
    /// What a half-step velocity keeps.
    pub p: f64,
    /// What an acceleration adds to it, s.
    pub q: f64,
}

impl StepFactors {
    /// The factors of a step of `dt` seconds under mass-proportional `damping`, 1/s.
    pub fn new(dt: f64, damping: f64) -> StepFactors {
        let (p, q) = mass_damping::step_factors(damping, dt);
        StepFactors { dt, p, q }
    }

    /// One kick and drift of one component: (v+, x+, w+) from v-, x and the acceleration a.
    #[inline(always)]
    pub(crate) fn advance(self, velocity: f64, position: f64, acceleration: f64) -> [f64; 3] {
        let next = self.p * velocity + self.q * acceleration;
        [next, position + self.dt * next, 1.5 * next - 0.5 * velocity]
    }

    /// The half-step velocity before a start at velocity `v` with acceleration `a`, so that their mean at the start
    /// is `v`.
    pub(crate) fn before_start(self, velocity: f64, acceleration: f64) -> f64 {
        (2.0 * velocity - self.q * acceleration) / (1.0 + self.p)
    }

    /// The velocity at the step, from the one half a step before and the acceleration.
    pub(crate) fn at_step(self, before: f64, acceleration: f64) -> f64 {
        0.5 * (before + (self.p * before + self.q * acceleration))
    }
}

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

mod any_law;
mod blocks;
mod dragging;
mod failing;
pub mod motion;
mod passes;
pub mod readable;
mod rope_forces;
mod rupture;
mod start;
pub mod step;

pub use crate::moving::StepFactors;

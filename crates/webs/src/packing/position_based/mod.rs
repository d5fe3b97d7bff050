//! Position-based dynamics: packings that are computed as a motion, not as a map of the flat web.
//!
//! This module is the only place of the crate that knows mass, gravity and time. It finds where a web lies once it has
//! come to rest in its container. A run takes positions from it and nothing else: no velocity, force or energy.
//!
//! # What is solved
//!
//! Node i has the position x_i (m), the velocity v_i (m/s) and the mass m_i (kg); g is the acceleration into the
//! container (m/s^2), c the damping (1/s), z the launch axis. A step takes dt = 2 ms:
//!
//! ```text
//! predict    v = exp(-c dt) (v - g dt z)       y = x + dt v
//! project    y -> the constraints, in ten sweeps, each constraint for itself (Gauss-Seidel)
//! update     v = (y - x) / dt                  x = y
//! ```
//!
//! The constraints are
//!
//! ```text
//! ropes and cloth    |x_a - x_b| <= l                        `distance_limits.rs`, `projection.rs`
//! plates             x_k = x_hub + R (X_k - X_hub)           `plates.rs`; X: in the flat web, R: the nearest rotation
//! wall               sqrt(x^2 + y^2) <= r(t)                 `walls.rs`
//! floor              z >= -depth                             `walls.rs`
//! driven nodes       x_k = X_k + u_k(t)                      `prescribed.rs`; u: the prescribed path, m
//! ```
//!
//! A distance limit that is exceeded moves its two nodes along the line between them, in inverse proportion to their
//! masses; a driven node is not moved. Once the kinetic energy has fallen to a small share of its largest value, sweeps
//! go on without gravity until no rope is longer than its rest length.
//!
//! [`StiffPlate::lay_in_folds`](super::StiffPlate::lay_in_folds) uses the same projection without any motion: plates in
//! a folded web pull the ropes around them after them.
//!
//! # What it is not
//!
//! It is not the model that a run integrates, which is the crate `dynamics`. Ropes are inextensible and have no bending
//! stiffness. They have no thickness, pass through one another, and slide on wall and floor without friction. How fast a
//! web settles depends on the step and on the number of sweeps; where it rests does so little: a rope whose ends are
//! brought together hangs as the catenary does, to 0.5 % in sag.
//!
//! # Sources
//!
//! Müller, Heidelberger, Hennix, Ratcliff: Position based dynamics. J. Vis. Commun. Image R. 18 (2007) 109-118.
//! Müller, Heidelberger, Teschner, Gross: Meshless deformations based on shape matching. ACM Trans. Graph. 24 (2005)
//! 471-478, for the plates.

mod folded_plates;
mod plates;
mod prescribed;
mod projection;
mod rope_pieces;
mod solver;
mod terms;
mod walls;

pub use terms::{DrivenNode, Prescribed, Settled};

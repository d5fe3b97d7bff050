//! Position-based dynamics: computes a packing as a motion of the web into its container.
//!
//! This is the only module of the crate with mass, gravity and time. It finds the positions at which a web comes to
//! rest in its container. A run takes only these positions from it, no velocity, force or energy.
//!
//! # What is solved
//!
//! Node i has the position x_i (m), the velocity v_i (m/s) and the mass m_i (kg); g is the acceleration into the
//! container (m/s^2), c the damping (1/s), z the launch axis. A step takes dt = 2 ms:
//!
//! ```text
//! predict    v = exp(-c dt) (v - g dt z)       y = x + dt v
//! project    y onto the constraints, one after the other, in ten sweeps (Gauss-Seidel)
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
//! masses; a driven node is not moved. The motion ends when the kinetic energy is a small share of its largest value.
//! Further sweeps without gravity then shorten ropes until none is longer than its rest length.
//!
//! [`StiffPlate::lay_in_folds`](super::StiffPlate::lay_in_folds) uses the same projection without a motion: it draws
//! the nodes around the plates of a folded web towards them.
//!
//! # Limits
//!
//! A run integrates another model, in the crate `dynamics`. Here ropes are inextensible, without bending stiffness and
//! without thickness. They pass through one another and slide on wall and floor without friction. The time in which a
//! web settles depends on the step and on the number of sweeps. Its rest position depends on them only a little: the
//! sag of a rope between two points is that of the catenary to 0.5 %.
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

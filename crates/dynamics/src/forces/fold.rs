//! The elastic energy of the angle between two directions, for bends of ropes and hinges of sheets.
//!
//! ```text
//! W = K |t_b - t_a|^2 / 2 = K (1 - cos phi) = 2 K sin^2(phi/2),        t = v/|v|
//! ```
//!
//! K is the stiffness against the angle phi, N m. v are two vectors: segments of a rope, or normals of triangles. The chord
//! |t_b - t_a| = 2 sin(phi/2) replaces phi, with which it agrees to second order. The moment K sin phi is bounded and its
//! slope is largest at phi = 0, so one step is stable for every angle. It is finite even at phi = pi, where the net lies
//! folded back on itself. (The curvature binormal 2 tan(phi/2) of Bergou et al. 2008 is no nearer to phi and has a pole
//! there.)
//!
//! **Short vectors.** The direction of a vector of length 0 is not defined. So t = v r(|v|)/|v|, with r = 1 while |v| is
//! more than 0.8 of its rest length, and r = |v| / (0.64 rest lengths) below 0.48 of it. A parabola joins both smoothly.
//! Force and stiffness stay finite even where nodes coincide.
//!
//! **Damping** acts against the rate of the chord: the power lost is K time (d|t_b - t_a|/dt)^2, W. A rotation of both
//! vectors together does not change the chord, so it is not damped. Derivation: docs/theory/bending.md.

use glam::DVec3;

/// A short vector is divided by this share of its rest length.
pub(super) const FLOOR: f64 = 0.64;

/// Half the width of the parabola over `FLOOR` rest lengths.
const ROUND: f64 = 0.25;

/// A rotational spring and damper between the directions of two vectors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fold {
    /// K, N m.
    stiffness: f64,
    /// Damping over stiffness, s.
    damping_time: f64,
    /// The length by which each vector is divided when it is short, in the vectors' unit.
    floor: [f64; 2],
}

/// The direction t of a vector v, and its derivative.
struct Direction {
    t: DVec3,
    axis: DVec3,
    /// dt/dv along the vector and across it.
    along: f64,
    across: f64,
}

impl Direction {
    fn of(v: DVec3, floor: f64) -> Self {
        let length = v.length();
        let x = length / floor;
        if x <= 1.0 - ROUND {
            let across = 1.0 / floor;
            return Self { t: v * across, axis: DVec3::ZERO, along: across, across };
        }
        let beyond = (x - (1.0 - ROUND)).min(2.0 * ROUND);
        let share = if x < 1.0 + ROUND { x - beyond * beyond / (4.0 * ROUND) } else { 1.0 };
        let axis = v / length;
        Self { t: axis * share, axis, along: (1.0 - beyond / (2.0 * ROUND)) / floor, across: share / length }
    }

    /// dt/dv applied to `p`; symmetric.
    fn turn(&self, p: DVec3) -> DVec3 {
        self.across * p + (self.along - self.across) * self.axis.dot(p) * self.axis
    }
}

impl Fold {
    /// `stiffness`: K, N m. `damping_time`: damping over stiffness, s. `rest`: lengths of the two vectors at rest.
    pub fn new(stiffness: f64, damping_time: f64, rest: [f64; 2]) -> Self {
        Self { stiffness, damping_time, floor: rest.map(|length| FLOOR * length) }
    }

    fn directions(&self, v: [DVec3; 2]) -> [Direction; 2] {
        [Direction::of(v[0], self.floor[0]), Direction::of(v[1], self.floor[1])]
    }

    /// Energy, J.
    pub fn energy(&self, v: [DVec3; 2]) -> f64 {
        let [a, b] = self.directions(v);
        0.5 * self.stiffness * (b.t - a.t).length_squared()
    }

    /// Elastic and dissipative forces on the vectors `v`, which change at `rate`, N m per unit of the vectors. The elastic
    /// forces are minus the gradient of the energy.
    pub fn pull(&self, v: [DVec3; 2], rate: [DVec3; 2]) -> ([DVec3; 2], [DVec3; 2]) {
        let [a, b] = self.directions(v);
        let gap = b.t - a.t;
        let slope = [a.turn(gap), b.turn(gap)];
        let elastic = [self.stiffness * slope[0], -self.stiffness * slope[1]];
        let squared = gap.length_squared();
        if self.damping_time == 0.0 || squared < f64::MIN_POSITIVE {
            return (elastic, [DVec3::ZERO; 2]);
        }
        // K time (gap . gap') / |gap|^2 along the elastic force
        let opening = slope[1].dot(rate[1]) - slope[0].dot(rate[0]);
        let dissipative = self.damping_time * self.stiffness * opening / squared;
        (elastic, [dissipative * slope[0], -dissipative * slope[1]])
    }
}

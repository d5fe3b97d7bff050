//! The energy of an angle between two directions: what bends in a rope and at a hinge.
//!
//! ```text
//! W = K |t_b - t_a|^2 / 2 = K (1 - cos phi) = 2 K sin^2(phi/2),        t = v/|v|
//! ```
//!
//! K is the stiffness against the angle, N m; v the vectors that fold, segments of a rope or normals of triangles.
//! The chord |t_b - t_a| = 2 sin(phi/2) stands for the angle phi: to second order they agree, the moment K sin phi is
//! bounded and its slope is nowhere larger than at phi = 0, so that one step is stable for every fold, and nothing is
//! singular where a net lies folded back on itself. (2 tan(phi/2), the binormal of Bergou et al. 2008, is no nearer
//! to phi and has a pole there.)
//!
//! **Vectors that lose their length** lose their direction: t = v r(|v|)/|v| with r = 1 while |v| is more than
//! 0.8 of its rest length, r = |v| / (0.64 rest lengths) below 0.48 of it, and a parabola between that joins both
//! smoothly. Force and stiffness stay finite to where nodes coincide.
//!
//! **Damping** takes the rate of the chord and nothing else, W = K time (d|t_b - t_a|/dt)^2: an angle is all that two
//! directions know of each other that does not turn with them. Derivation: docs/theory/bending.md.

use glam::DVec3;

/// Share of its rest length by which a short vector is divided.
pub(super) const FLOOR: f64 = 0.64;

/// Half the width of the parabola, in floors.
const ROUND: f64 = 0.25;

/// A stiffness between two directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fold {
    /// K, N m.
    stiffness: f64,
    /// Damping over stiffness, s.
    damping_time: f64,
    /// Lengths by which short vectors are divided, in the vectors' unit.
    floor: [f64; 2],
}

/// A direction and how it follows from its vector.
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
    /// `stiffness` in N m, `damping_time` in s, `rest` the lengths of the two vectors at rest.
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

    /// Minus the slope of the energy against the vectors, and the dissipative at their `rate`: (elastic, dissipative), N m
    /// per unit of the vectors.
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

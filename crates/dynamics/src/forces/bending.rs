//! Bending of a rope at a node between two segments: a discrete elastic rod, straight at rest, without torsional
//! stiffness.
//!
//! ```text
//! W = (EI / l) |t_2 - t_1|^2 / 2        t_i: directions of the segments; l: mean of their rest lengths, m
//! ```
//!
//! EI is the bending stiffness, N m^2; |t_2 - t_1| / l is the curvature at the node. Source: Bergou, Wardetzky,
//! Robinson, Audoly, Grinspun, "Discrete elastic rods", ACM Transactions on Graphics 27 (2008) 63, section 4.2. The chord
//! replaces their curvature binormal, for the reasons in `fold.rs`; both are of second order in l. The law is valid where
//! the diameter of the rope is small against l and l is small against the radius of curvature. A slack rope still has
//! bending moments, but no force keeps its length.
//!
//! Derivation, bound and tests: docs/theory/bending.md.

use super::element::{Element, ElementError, ElementForces, Property, distinct, not_negative, positive};
use super::fold::{FLOOR, Fold};
use glam::DVec3;

/// The bending element between two segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bending {
    nodes: [usize; 3],
    fold: Fold,
    stiffness: [f64; 3],
    damping_time: f64,
}

impl Bending {
    /// The element at the second of three nodes along a rope. `rest_lengths`: of the segments before and after that node,
    /// m. `bending_stiffness`: EI, N m^2. `damping_time`: damping over stiffness, s.
    ///
    /// # Errors
    /// A node that occurs twice; a property that is out of range or not a number.
    pub fn new(
        nodes: [usize; 3],
        rest_lengths: [f64; 2],
        bending_stiffness: f64,
        damping_time: f64,
    ) -> Result<Self, ElementError> {
        distinct(nodes)?;
        for length in rest_lengths {
            positive(Property::RestLength, length)?;
        }
        positive(Property::BendingStiffness, bending_stiffness)?;
        not_negative(Property::DampingTime, damping_time)?;

        let [before, after] = rest_lengths;
        let angular = bending_stiffness / (0.5 * (before + after));
        // slopes of the angle of a straight rope against its nodes, 1/m
        let slopes = [1.0 / before, 1.0 / before + 1.0 / after, 1.0 / after];
        let sum: f64 = slopes.iter().sum();
        Ok(Self {
            nodes,
            fold: Fold::new(angular, damping_time, rest_lengths),
            stiffness: slopes.map(|slope| SHARPEST * 0.5 * angular * slope * sum),
            damping_time,
        })
    }
}

/// The bending element at a clamped end of a rope: between a direction that stays fixed in space and the first segment.
///
/// The clamp has half a segment of rope to bend, so its angular stiffness is 2 EI / l: then sums over the nodes are the
/// trapezoidal rule along the rope, and a cantilever's deflection is of second order in l, as inside a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clamp {
    nodes: [usize; 2],
    /// The first segment as the clamp holds it, m.
    held: DVec3,
    fold: Fold,
    stiffness: f64,
    damping_time: f64,
}

impl Clamp {
    /// The clamp of the first of two nodes along a rope. `direction`: of the rope at the clamp, away from it; any length.
    /// `rest_length`: of the segment between the nodes, m. `bending_stiffness`: EI, N m^2. `damping_time`: damping over
    /// stiffness, s.
    ///
    /// # Errors
    /// A node that occurs twice; a direction without length; a property that is out of range or not a number.
    pub fn new(
        nodes: [usize; 2],
        direction: DVec3,
        rest_length: f64,
        bending_stiffness: f64,
        damping_time: f64,
    ) -> Result<Self, ElementError> {
        distinct(nodes)?;
        positive(Property::RestLength, rest_length)?;
        positive(Property::BendingStiffness, bending_stiffness)?;
        not_negative(Property::DampingTime, damping_time)?;
        positive(Property::Edge, direction.length())?;
        let angular = 2.0 * bending_stiffness / rest_length;
        // against a direction that is fixed, the second derivative is largest in line with it where the parabola of the
        // short segment begins: r'^2 - (1 - r) r'' = 1 + 2/4, over that of a collapsed segment
        Ok(Self {
            nodes,
            held: direction / direction.length() * rest_length,
            fold: Fold::new(angular, damping_time, [rest_length; 2]),
            stiffness: 1.5 * SHARPEST * angular / (rest_length * rest_length),
            damping_time,
        })
    }
}

impl Element<2> for Clamp {
    fn nodes(&self) -> [usize; 2] {
        self.nodes
    }

    fn pull(&self, [a, b]: [DVec3; 2], [of_a, of_b]: [DVec3; 2]) -> ElementForces<2> {
        let (elastic, dissipative) = self.fold.pull([self.held, b - a], [DVec3::ZERO, of_b - of_a]);
        let on_nodes = |[_, second]: [DVec3; 2]| [-second, second];
        ElementForces { elastic: on_nodes(elastic), dissipative: on_nodes(dissipative) }
    }

    fn elastic_energy(&self, [a, b]: [DVec3; 2]) -> f64 {
        self.fold.energy([self.held, b - a])
    }

    fn stiffness(&self) -> [f64; 2] {
        [self.stiffness; 2]
    }

    fn damping(&self) -> [f64; 2] {
        [self.stiffness * self.damping_time; 2]
    }
}

/// Largest stiffness in any shape, over that of the straight rope. It occurs where segments have shortened to nothing.
const SHARPEST: f64 = 1.0 / (FLOOR * FLOOR);

fn segments([a, b, c]: [DVec3; 3]) -> [DVec3; 2] {
    [b - a, c - b]
}

fn on_nodes([first, second]: [DVec3; 2]) -> [DVec3; 3] {
    [-first, first - second, second]
}

impl Element<3> for Bending {
    fn nodes(&self) -> [usize; 3] {
        self.nodes
    }

    fn pull(&self, position: [DVec3; 3], velocity: [DVec3; 3]) -> ElementForces<3> {
        let (elastic, dissipative) = self.fold.pull(segments(position), segments(velocity));
        ElementForces { elastic: on_nodes(elastic), dissipative: on_nodes(dissipative) }
    }

    fn elastic_energy(&self, position: [DVec3; 3]) -> f64 {
        self.fold.energy(segments(position))
    }

    fn stiffness(&self) -> [f64; 3] {
        self.stiffness
    }

    fn damping(&self) -> [f64; 3] {
        self.stiffness.map(|k| k * self.damping_time)
    }
}

#[cfg(test)]
mod tests {
    use super::super::conformance;
    use super::*;
    use proptest::prelude::*;

    const BENDING_STIFFNESS: f64 = 2.0;

    fn point(reach: f64) -> impl Strategy<Value = DVec3> {
        (-reach..reach, -reach..reach, -reach..reach).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    fn uneven() -> Bending {
        Bending::new([4, 2, 9], [0.5, 0.7], BENDING_STIFFNESS, 0.02).unwrap()
    }

    /// An element with rest lengths of 1 m, and its nodes with segments of these lengths, m, at this angle, rad.
    fn even(lengths: [f64; 2], angle: f64) -> (Bending, [DVec3; 3]) {
        let bend = Bending::new([0, 1, 2], [1.0, 1.0], BENDING_STIFFNESS, 0.02).unwrap();
        let (sin, cos) = libm::sincos(angle);
        (bend, [DVec3::NEG_X * lengths[0], DVec3::ZERO, lengths[1] * DVec3::new(cos, sin, 0.0)])
    }

    #[test]
    fn a_fold_stores_k_times_one_minus_its_cosine_whatever_its_length() {
        for angle in [0.0, 1e-3, -0.4, 1.0, 2.0, std::f64::consts::PI] {
            let expected = 2.0 * BENDING_STIFFNESS * libm::pow(libm::sin(0.5 * angle), 2.0);
            for lengths in [[1.0, 1.0], [0.81, 1.3]] {
                let (bend, x) = even(lengths, angle);
                assert!((bend.elastic_energy(x) - expected).abs() < 1e-14, "{angle}");
            }
        }
    }

    #[test]
    fn forces_stay_finite_where_nodes_coincide_or_the_rope_lies_folded_back() {
        let w = [DVec3::X, DVec3::NEG_Y, DVec3::Z];
        let most = 10.0 * BENDING_STIFFNESS;
        for (lengths, angle) in [([0.0, 0.0], 0.0), ([1.0, 0.0], 0.0), ([1.0, 1.0], std::f64::consts::PI)] {
            let (bend, x) = even(lengths, angle);
            let forces = bend.pull(x, w);
            for force in forces.elastic.iter().chain(&forces.dissipative) {
                assert!(force.is_finite() && force.length() < most);
            }
        }
    }

    #[test]
    fn the_bound_is_sharp_for_the_straight_rope() {
        let (bend, x) = even([1.0, 1.0], 0.0);
        assert!((conformance::used_bound(&bend, x, 1e-6) * SHARPEST - 1.0).abs() < 1e-9);
    }

    #[test]
    fn wrong_nodes_lengths_and_properties_are_refused() {
        assert!(Bending::new([0, 1, 0], [1.0, 1.0], 1.0, 0.0).is_err());
        assert!(Bending::new([0, 1, 2], [1.0, 0.0], 1.0, 0.0).is_err());
        assert!(Bending::new([0, 1, 2], [1.0, 1.0], f64::INFINITY, 0.0).is_err());
        assert!(Bending::new([0, 1, 2], [1.0, 1.0], 1.0, f64::NAN).is_err());
    }

    #[test]
    fn a_clamp_stores_2_k_times_one_minus_the_cosine_of_its_angle() {
        for angle in [0.0, 1e-3, -0.4, 1.0, 2.0, std::f64::consts::PI] {
            let (clamp, x) = clamped(0.5, angle);
            let expected = 4.0 * BENDING_STIFFNESS / 0.5 * libm::pow(libm::sin(0.5 * angle), 2.0);
            assert!((clamp.elastic_energy(x) - expected).abs() < 1e-13, "{angle}");
        }
        assert!(Clamp::new([0, 1], DVec3::ZERO, 0.5, BENDING_STIFFNESS, 0.0).is_err());
    }

    /// A clamp along x, and its nodes with a segment of this length, m, at this angle, rad.
    fn clamped(length: f64, angle: f64) -> (Clamp, [DVec3; 2]) {
        let clamp = Clamp::new([0, 1], DVec3::X, 0.5, BENDING_STIFFNESS, 0.02).unwrap();
        let (sin, cos) = libm::sincos(angle);
        (clamp, [DVec3::ONE, DVec3::ONE + length * DVec3::new(cos, sin, 0.0)])
    }

    proptest! {
        #[test]
        fn the_force_of_a_clamp_is_the_gradient_of_its_energy_within_its_bound(
            x in prop::array::uniform2(point(0.7)),
            length in 0.0..1.0,
            angle in 0.0..3.2,
        ) {
            let (clamp, bent) = clamped(length, angle);
            conformance::force_is_the_gradient(&clamp, x, 1e-5, 100.0 * BENDING_STIFFNESS, 1e-6);
            prop_assert!(conformance::used_bound(&clamp, bent, 1e-6) < 1.0 + 1e-6);
            prop_assert!(conformance::used_damping_bound(&clamp, bent) < 1.0 + 1e-9);
        }

        #[test]
        fn the_bound_holds_where_segments_fold_and_collapse(
            first in 0.0..1.3,
            second in 0.0..1.3,
            angle in 0.0..3.2,
        ) {
            let (bend, x) = even([first, second], angle);
            prop_assert!(conformance::used_bound(&bend, x, 1e-6) < 1.0 + 1e-6);
            prop_assert!(conformance::used_damping_bound(&bend, x) < 1.0 + 1e-9);
        }

        #[test]
        fn forces_are_gradients_and_internal_and_turn_with_the_nodes(
            x in prop::array::uniform3(point(0.7)),
            w in prop::array::uniform3(point(1.0)),
        ) {
            let bend = uneven();
            conformance::force_is_the_gradient(&bend, x, 1e-5, 10.0 * BENDING_STIFFNESS, 1e-6);
            conformance::forces_are_internal(&bend, x, w);
            conformance::turns_with_its_nodes(&bend, x, w);
        }
    }
}

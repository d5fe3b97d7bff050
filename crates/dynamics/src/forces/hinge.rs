//! Bending of a sheet at the edge between two triangles: a hinge that is flat at rest.
//!
//! ```text
//! W = K |n_2 - n_1|^2 / 2 = K (1 - cos theta),        K = D |e|^2 / (A_1 + A_2)
//! ```
//!
//! theta is the dihedral angle (0 where flat), n are the unit normals, e is the edge and A are the areas at rest. D = E t^3 /
//! (12 (1 - nu^2)), N m, is the flexural rigidity. Sources: Grinspun, Hirani, Desbrun, Schroeder, "Discrete shells",
//! Symposium on Computer Animation 2003, whose energy is 3 k |e|^2 theta^2 / A; here k = D/6, and the chord replaces the
//! angle. The energy in the normals is that of Seung and Nelson, Physical Review A 38 (1988) 1005, where K = 2 D / sqrt(3).
//!
//! **On a mesh of equilateral triangles** K = 2 D / sqrt(3) for every edge. A sheet that is bent to a cylinder about any
//! axis stores D kappa^2 / 2 per area, so the rigidity is D in every direction. The stiffness against Gaussian curvature is
//! that of a Poisson ratio of -1/3 for any material; this matters only where edges are free. On other meshes the rigidity
//! depends on direction. Derivation, bound and tests: docs/theory/plate.md.

use super::element::{Element, ElementError, ElementForces, Property, checked, distinct, not_negative, positive};
use super::fold::Fold;
use glam::{DVec2, DVec3};

/// D = E t^3 / (12 (1 - nu^2)) of an isotropic plate, N m. `elastic_modulus` in Pa, `thickness` in m.
pub fn flexural_rigidity(elastic_modulus: f64, poisson_ratio: f64, thickness: f64) -> f64 {
    elastic_modulus * thickness * thickness * thickness / (12.0 * (1.0 - poisson_ratio * poisson_ratio))
}

/// The hinge between two triangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    nodes: [usize; 4],
    fold: Fold,
    stiffness: [f64; 4],
    damping_time: f64,
}

impl Hinge {
    /// The hinge along the edge from the first node to the second. Seen from above, the third node lies to the left of the
    /// edge and the fourth to the right. `rest`: places of the nodes in the flat sheet, m. `rigidity`: D, N m.
    /// `damping_time`: damping over stiffness, s.
    ///
    /// # Errors
    /// A node occurs twice, a triangle lies on the wrong side of the edge, or a property is out of range.
    pub fn new(nodes: [usize; 4], rest: [DVec2; 4], rigidity: f64, damping_time: f64) -> Result<Self, ElementError> {
        distinct(nodes)?;
        positive(Property::FlexuralRigidity, rigidity)?;
        not_negative(Property::DampingTime, damping_time)?;
        let edge = rest[1] - rest[0];
        let left = positive(Property::AreaLeft, edge.perp_dot(rest[2] - rest[0]))?;
        let right = positive(Property::AreaRight, (rest[3] - rest[0]).perp_dot(edge))?;
        let length = checked(Property::Edge, edge.length(), true)?;
        let angular = rigidity * length * length / (0.5 * (left + right));

        // gradient of the angle of the flat sheet, 1/m: 1/height at the far nodes, shared by the lever at those of the edge
        let along = |point: usize| edge.dot(rest[point] - rest[0]) / (length * length);
        let far = [length / left, length / right];
        let slopes = [
            ((1.0 - along(2)) * far[0] + (1.0 - along(3)) * far[1]).abs(),
            (along(2) * far[0] + along(3) * far[1]).abs(),
            far[0],
            far[1],
        ];
        let sum: f64 = slopes.iter().sum();
        Ok(Self {
            nodes,
            fold: Fold::new(angular, damping_time, [left, right]),
            stiffness: slopes.map(|slope| SHARPEST * 0.5 * angular * slope * sum),
            damping_time,
        })
    }
}

/// Largest stiffness over that of the flat sheet, where triangles shrink, collapse and fold but no side is longer than 1.05
/// times its rest length. A search over 400 000 shapes found 5.85.
const SHARPEST: f64 = 6.0;

/// The normals of the two triangles; their lengths are twice the areas, m^2.
fn normals([a, b, left, right]: [DVec3; 4]) -> [DVec3; 2] {
    let edge = b - a;
    [edge.cross(left - a), (right - a).cross(edge)]
}

/// Rates of the normals, m^2/s.
fn rates([a, b, left, right]: [DVec3; 4], [va, vb, v_left, v_right]: [DVec3; 4]) -> [DVec3; 2] {
    let (edge, rate) = (b - a, vb - va);
    [rate.cross(left - a) + edge.cross(v_left - va), (v_right - va).cross(edge) + (right - a).cross(rate)]
}

/// Forces on the nodes from forces on the normals.
fn on_nodes([a, b, left, right]: [DVec3; 4], [first, second]: [DVec3; 2]) -> [DVec3; 4] {
    let edge = b - a;
    let (on_left, on_right) = (first.cross(edge), edge.cross(second));
    let on_b = (left - a).cross(first) + second.cross(right - a);
    [-(on_b + on_left + on_right), on_b, on_left, on_right]
}

impl Element<4> for Hinge {
    fn nodes(&self) -> [usize; 4] {
        self.nodes
    }

    fn pull(&self, position: [DVec3; 4], velocity: [DVec3; 4]) -> ElementForces<4> {
        let (elastic, dissipative) = self.fold.pull(normals(position), rates(position, velocity));
        ElementForces { elastic: on_nodes(position, elastic), dissipative: on_nodes(position, dissipative) }
    }

    fn elastic_energy(&self, position: [DVec3; 4]) -> f64 {
        self.fold.energy(normals(position))
    }

    fn stiffness(&self) -> [f64; 4] {
        self.stiffness
    }

    fn damping(&self) -> [f64; 4] {
        self.stiffness.map(|k| k * self.damping_time)
    }
}

#[cfg(test)]
mod tests {
    use super::super::conformance;
    use super::*;
    use proptest::prelude::*;

    const RIGIDITY: f64 = 3.0;

    fn point(reach: f64) -> impl Strategy<Value = DVec3> {
        (-reach..reach, -reach..reach, -reach..reach).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    /// Two triangles of different shape, and the same folded by an angle.
    fn uneven(angle: f64) -> (Hinge, [DVec3; 4]) {
        let rest = [DVec2::new(0.1, 0.0), DVec2::new(0.1, 1.0), DVec2::new(-0.6, 0.7), DVec2::new(0.9, 0.2)];
        let hinge = Hinge::new([3, 5, 8, 1], rest, RIGIDITY, 0.01).unwrap();
        let mut x = rest.map(|p| p.extend(0.0));
        let out = rest[3].x - rest[0].x;
        x[3] = DVec3::new(rest[0].x + out * libm::cos(angle), rest[3].y, out * libm::sin(angle));
        (hinge, x)
    }

    fn equilateral(side: f64) -> (Hinge, [DVec3; 4]) {
        let height = side * 0.75_f64.sqrt();
        let rest = [(0.0, -0.5 * side), (0.0, 0.5 * side), (-height, 0.0), (height, 0.0)].map(DVec2::from);
        (Hinge::new([0, 1, 2, 3], rest, RIGIDITY, 0.01).unwrap(), rest.map(|p| p.extend(0.0)))
    }

    #[test]
    fn a_fold_stores_k_times_one_minus_its_cosine() {
        for angle in [0.0, 1e-3, -0.4, 1.0, 2.0, std::f64::consts::PI] {
            let (hinge, x) = uneven(angle);
            let stiffness = RIGIDITY / (0.5 * (0.7 + 0.8));
            let expected = 2.0 * stiffness * libm::pow(libm::sin(0.5 * angle), 2.0);
            assert!((hinge.elastic_energy(x) - expected).abs() < 1e-13, "{angle}");
        }
        // Seung and Nelson's lattice
        let (hinge, mut x) = equilateral(0.2);
        x[3] = DVec3::new(0.0, 0.0, 0.3_f64.sqrt());
        assert!((hinge.elastic_energy(x) - 2.0 * RIGIDITY / 3.0_f64.sqrt()).abs() < 1e-13);
    }

    #[test]
    fn forces_stay_finite_where_nodes_coincide() {
        let (hinge, flat) = equilateral(1.0);
        let most = 10.0 * RIGIDITY;
        for x in [[DVec3::ZERO; 4], [flat[0], flat[0], flat[2], flat[3]], [flat[0], flat[1], flat[0], flat[3]]] {
            let forces = hinge.pull(x, flat);
            for force in forces.elastic.iter().chain(&forces.dissipative) {
                assert!(force.is_finite() && force.length() < most);
            }
        }
    }

    #[test]
    fn wrong_nodes_triangles_and_properties_are_refused() {
        let rest = [(0.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (1.0, 0.0)].map(DVec2::from);
        assert!(Hinge::new([0, 1, 2, 3], rest, 1.0, 0.0).is_ok());
        assert!(Hinge::new([0, 1, 2, 1], rest, 1.0, 0.0).is_err());
        assert!(Hinge::new([0, 1, 3, 2], [rest[0], rest[1], rest[3], rest[2]], 1.0, 0.0).is_err());
        assert!(Hinge::new([0, 1, 2, 3], rest, f64::NAN, 0.0).is_err());
        assert!(Hinge::new([0, 1, 2, 3], rest, 1.0, -1.0).is_err());
    }

    #[test]
    fn the_bound_is_sharp_for_the_flat_sheet() {
        let (hinge, flat) = equilateral(0.1);
        let used = conformance::used_bound(&hinge, flat, 1e-7);
        assert!((used * SHARPEST - 1.0).abs() < 1e-6);
    }

    proptest! {
        #[test]
        fn the_bound_holds_where_triangles_shrink_and_collapse(
            length in 0.0..1.05,
            left in (-0.75..0.75, 0.0..1.0_f64),
            right in (-0.75..0.75, 0.0..1.0_f64),
            angle in -3.2..3.2,
        ) {
            let (hinge, _) = equilateral(1.0);
            let (sin, cos) = libm::sincos(angle);
            let x = [
                DVec3::new(0.0, -0.5 * length, 0.0),
                DVec3::new(0.0, 0.5 * length, 0.0),
                DVec3::new(-left.1, left.0, 0.0),
                DVec3::new(right.1 * cos, right.0, right.1 * sin),
            ];
            let sides = [(0, 2), (0, 3), (1, 2), (1, 3)].map(|(i, j)| x[i].distance(x[j]));
            let longest = sides.into_iter().fold(0.0, f64::max);
            let x = x.map(|x| x * (1.05 / longest).min(1.0));
            let used = conformance::used_bound(&hinge, x, 1e-6);
            let damping = conformance::used_damping_bound(&hinge, x);
            prop_assert!(used < 1.0 && damping < 1.0, "{used} of the stiffness, {damping} of the damping");
        }

        #[test]
        fn forces_are_gradients_and_internal_and_turn_with_the_nodes(
            angle in -3.1..3.1,
            shift in prop::array::uniform4(point(0.3)),
            w in prop::array::uniform4(point(1.0)),
        ) {
            let (hinge, mut x) = uneven(angle);
            for (x, shift) in x.iter_mut().zip(shift) {
                *x += shift;
            }
            conformance::force_is_the_gradient(&hinge, x, 1e-5, 10.0 * RIGIDITY, 1e-6);
            conformance::forces_are_internal(&hinge, x, w);
            conformance::turns_with_its_nodes(&hinge, x, w);
        }
    }
}

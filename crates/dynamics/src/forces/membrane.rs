//! Tension of a sheet in its plane: a triangle of constant strain, large rotations, that wrinkles or is a plate.
//!
//! ```text
//! F = sum x_i g_i*            deformation gradient, 3 x 2; g_i slope of node i's share against the flat sheet, 1/m
//! e = (F*F - 1)/2             Green strain; it does not see rotations
//! f_i = -A t F S g_i          force on node i, N; S second Piola-Kirchhoff stress, Pa
//! ```
//!
//! A is the area at rest, m^2, t the thickness, m. S and its energy are those of [`super::tension_field`]. The element
//! is the linear triangle of finite elements (Zienkiewicz and Taylor, *The Finite Element Method*), total Lagrangian.
//!
//! **Damping** is that of the material, S_v = time dS/dt, along the relaxed stress: all of it where the sheet is taut,
//! along and about the tension where it is wrinkled, none where it is slack. As W_r is convex it never gives energy.
//!
//! Valid for strains as small as [`super::tension_field`] asks. The bound for the step is for stretches up to
//! [`LARGEST_STRETCH`]. Derivation, bound and tests: docs/theory/membrane.md.

use super::element::{Element, ElementError, ElementForces, Property, distinct, not_negative, positive};
use super::tension_field::{Elasticity, RelaxedStress, Tautness, TensionField};
use glam::{DVec2, DVec3};

/// Stretch up to which [`Element::stiffness`] is a bound.
pub const LARGEST_STRETCH: f64 = 1.1;

/// Material and thickness of a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fabric {
    /// Elasticity in its plane.
    pub elasticity: Elasticity,
    /// Thickness, m.
    pub thickness: f64,
    /// Whether it carries compression, as a plate does; cloth wrinkles.
    pub compresses: bool,
    /// Damping time of the material, s.
    pub damping_time: f64,
}

/// A triangle of sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Membrane {
    nodes: [usize; 3],
    /// Slopes of the nodes' shares in axes along and across the fibres, 1/m.
    slopes: [DVec2; 3],
    /// Volume at rest, m^3.
    volume: f64,
    law: TensionField,
    damping_time: f64,
    stiffness: [f64; 3],
}

/// Stress of a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetStress {
    /// Whether the sheet is taut, wrinkled or slack.
    pub tautness: Tautness,
    /// Second Piola-Kirchhoff stress, Pa: along the fibres, across them, shear.
    pub components: [f64; 3],
}

impl SheetStress {
    /// Principal stresses, Pa, the larger one first, and the angle of its direction from the fibres, rad.
    pub fn principal(&self) -> ([f64; 2], f64) {
        let (mean, deviation) = self.mean_and_deviation();
        let radius = deviation.length();
        ([mean + radius, mean - radius], 0.5 * libm::atan2(deviation.y, deviation.x))
    }

    /// The larger principal stress, Pa.
    pub fn largest(&self) -> f64 {
        let (mean, deviation) = self.mean_and_deviation();
        mean + deviation.length()
    }

    fn mean_and_deviation(&self) -> (f64, DVec2) {
        let [along, across, shear] = self.components;
        (0.5 * (along + across), DVec2::new(0.5 * (along - across), shear))
    }
}

impl Membrane {
    /// The triangle whose nodes lie at `rest` in the flat sheet, m, anticlockwise.
    ///
    /// # Errors
    /// A node that occurs twice; a triangle that has no area or runs clockwise; a property out of range.
    pub fn new(nodes: [usize; 3], rest: [DVec2; 3], fabric: &Fabric) -> Result<Self, ElementError> {
        distinct(nodes)?;
        let law = TensionField::new(&fabric.elasticity, fabric.compresses)?;
        positive(Property::Thickness, fabric.thickness)?;
        not_negative(Property::DampingTime, fabric.damping_time)?;
        let twice_area = positive(Property::RestArea, (rest[1] - rest[0]).perp_dot(rest[2] - rest[0]))?;
        let volume = 0.5 * twice_area * fabric.thickness;

        // a node's share falls from 1 to 0 towards the opposite side
        let (sin, cos) = libm::sincos(fabric.elasticity.fibre_angle);
        let slopes = std::array::from_fn(|i| {
            let slope = (rest[(i + 2) % 3] - rest[(i + 1) % 3]).perp() / twice_area;
            DVec2::new(cos * slope.x + sin * slope.y, cos * slope.y - sin * slope.x)
        });
        let stiffness = stiffness(&law, volume, slopes);
        Ok(Self { nodes, slopes, volume, law, damping_time: fabric.damping_time, stiffness })
    }

    /// Stress with the nodes at `position`, m.
    pub fn stress(&self, position: [DVec3; 3]) -> SheetStress {
        let RelaxedStress { tautness, components: stress } = self.law.stress(self.strain(self.gradient(position)));
        SheetStress { tautness, components: self.law.tensor(stress) }
    }

    /// Sum of x_i g_i*: the columns of F for positions, of its rate for velocities.
    fn gradient(&self, [a, b, c]: [DVec3; 3]) -> [DVec3; 2] {
        // differences first: far from the origin they keep their digits
        let ([_, g, h], b, c) = (self.slopes, b - a, c - a);
        [b * g.x + c * h.x, b * g.y + c * h.y]
    }

    fn strain(&self, [f, g]: [DVec3; 2]) -> DVec3 {
        self.law.components(0.5 * (f.dot(f) - 1.0), 0.5 * (g.dot(g) - 1.0), f.dot(g))
    }

    fn forces(&self, [f, g]: [DVec3; 2], stress: DVec3) -> [DVec3; 3] {
        let [along, across, shear] = self.law.tensor(stress);
        let (first, second) = (-self.volume * (along * f + shear * g), -self.volume * (shear * f + across * g));
        let on = |slope: DVec2| slope.x * first + slope.y * second;
        let (b, c) = (on(self.slopes[1]), on(self.slopes[2]));
        [-(b + c), b, c]
    }
}

/// Bound k_i: with the slopes' lengths as weights the stiffness at rest is a matrix of the three components of strain,
/// whose largest row sum it does not exceed; a stretch adds what it does to a rope of this material.
fn stiffness(law: &TensionField, volume: f64, slopes: [DVec2; 3]) -> [f64; 3] {
    let root = law.modulus().map(f64::sqrt);
    let mut matrix = [[0.0; 3]; 3];
    for slope in slopes {
        for motion in [DVec2::X, DVec2::Y] {
            let strain = slope * motion;
            let shear = slope.x * motion.y + slope.y * motion.x;
            let component = (root * law.components(strain.x, strain.y, shear)).to_array();
            for (row, a) in matrix.iter_mut().zip(component) {
                for (entry, b) in row.iter_mut().zip(component) {
                    *entry += volume * a * b / slope.length();
                }
            }
        }
    }
    let row_sum = |row: &[f64; 3]| row.iter().map(|entry| entry.abs()).sum::<f64>();
    let largest = matrix.iter().map(row_sum).fold(0.0, f64::max);
    let stretched = 0.5 * (3.0 * LARGEST_STRETCH * LARGEST_STRETCH - 1.0);
    slopes.map(|slope| 0.5 * stretched * largest * slope.length())
}

impl Element<3> for Membrane {
    fn nodes(&self) -> [usize; 3] {
        self.nodes
    }

    fn pull(&self, position: [DVec3; 3], velocity: [DVec3; 3]) -> ElementForces<3> {
        let [f, g] = self.gradient(position);
        let strain = self.strain([f, g]);
        let stress = self.law.stress(strain);
        let elastic = self.forces([f, g], stress.components);
        if self.damping_time == 0.0 {
            return ElementForces { elastic, dissipative: [DVec3::ZERO; 3] };
        }
        let [f_rate, g_rate] = self.gradient(velocity);
        let rate = self.law.components(f.dot(f_rate), g.dot(g_rate), f.dot(g_rate) + g.dot(f_rate));
        let viscous = self.damping_time * self.law.stress_rate(strain, stress, rate);
        ElementForces { elastic, dissipative: self.forces([f, g], viscous) }
    }

    fn elastic_energy(&self, position: [DVec3; 3]) -> f64 {
        // wrinkles do no work: S : e is S : e*
        let strain = self.strain(self.gradient(position));
        0.5 * self.volume * self.law.stress(strain).components.dot(strain)
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

    const E: f64 = 2.0e9;
    const NU: f64 = 0.3;
    const THICKNESS: f64 = 1e-4;

    fn cloth(elasticity: Elasticity) -> Fabric {
        Fabric { elasticity, thickness: THICKNESS, compresses: false, damping_time: 1e-6 }
    }

    fn isotropic() -> Fabric {
        cloth(Elasticity::isotropic(E, NU))
    }

    /// A cloth twenty times as stiff along its fibres, soft in shear, its fibres at an angle.
    fn woven() -> Fabric {
        cloth(Elasticity { moduli: [E, 0.05 * E], poisson_ratio: 0.9, shear_modulus: 0.02 * E, fibre_angle: 0.4 })
    }

    fn plate() -> Fabric {
        Fabric { compresses: true, ..isotropic() }
    }

    const REST: [DVec2; 3] = [DVec2::new(0.1, 0.2), DVec2::new(0.4, 0.25), DVec2::new(0.2, 0.5)];

    fn membrane(fabric: &Fabric) -> Membrane {
        Membrane::new([7, 2, 4], REST, fabric).unwrap()
    }

    /// The triangle deformed by F = [a, b] in the plane of the first two axes, then turned and moved in space.
    fn deformed(a: DVec2, b: DVec2) -> [DVec3; 3] {
        let turn = glam::DQuat::from_xyzw(0.3, 0.7, -0.2, 0.4).normalize();
        REST.map(|p| turn * (p.x * a + p.y * b).extend(0.0) + DVec3::new(1.0, 2.0, 3.0))
    }

    /// F = 1 + strain, symmetric.
    fn strained(along: f64, across: f64, half_shear: f64) -> [DVec3; 3] {
        deformed(DVec2::new(1.0 + along, half_shear), DVec2::new(half_shear, 1.0 + across))
    }

    fn green(stretch: f64) -> f64 {
        0.5 * (stretch * stretch - 1.0)
    }

    fn assert_stress(membrane: &Membrane, x: [DVec3; 3], tautness: Tautness, expected: [f64; 3]) {
        let stress = membrane.stress(x);
        assert_eq!(stress.tautness, tautness);
        for (found, expected) in stress.components.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-9 * E, "{:?}, expected {expected}", stress.components);
        }
    }

    #[test]
    fn biaxial_uniaxial_and_slack() {
        let m = membrane(&isotropic());
        let (e, f) = (green(1.01), green(1.004));
        let stiff = E / (1.0 - NU * NU);
        assert_stress(
            &m,
            strained(0.01, 0.004, 0.0),
            Tautness::Taut,
            [stiff * (e + NU * f), stiff * (f + NU * e), 0.0],
        );
        // held narrower than it would become by itself: it wrinkles, and pulls as a strip does
        assert_stress(&m, strained(0.01, -0.02, 0.0), Tautness::Wrinkled, [E * e, 0.0, 0.0]);
        assert_stress(&m, strained(-0.3, 0.01, 0.0), Tautness::Wrinkled, [0.0, E * e, 0.0]);
        assert_stress(&m, strained(-0.001, -0.002, 0.0), Tautness::Slack, [0.0; 3]);
        assert_stress(&m, [DVec3::ONE; 3], Tautness::Slack, [0.0; 3]);
        let p = membrane(&plate());
        let g = green(0.98);
        assert_stress(
            &p,
            strained(0.01, -0.02, 0.0),
            Tautness::Taut,
            [stiff * (e + NU * g), stiff * (g + NU * e), 0.0],
        );
    }

    #[test]
    fn it_wrinkles_when_it_contracts_more_than_by_its_poisson_ratio() {
        let m = membrane(&isotropic());
        let across = |share: f64| libm::sqrt(1.0 - 2.0 * share * NU * green(1.01)) - 1.0;
        assert_eq!(m.stress(strained(0.01, across(0.999), 0.0)).tautness, Tautness::Taut);
        assert_eq!(m.stress(strained(0.01, across(1.001), 0.0)).tautness, Tautness::Wrinkled);
    }

    #[test]
    fn simple_shear() {
        // F = 1 + gamma x (x) y: e12 = gamma/2, e22 = gamma^2/2, principal axes at half of atan2(2, -gamma) from x
        let gamma = 0.01;
        let x = deformed(DVec2::X, DVec2::new(gamma, 1.0));
        let (shear, across) = (0.5 * gamma, 0.5 * gamma * gamma);
        let stiff = E / (1.0 - NU * NU);
        let expected = [stiff * NU * across, stiff * across, E / (1.0 + NU) * shear];
        assert_stress(&membrane(&plate()), x, Tautness::Taut, expected);

        let stress = membrane(&isotropic()).stress(x);
        let ([first, second], angle) = stress.principal();
        let largest = 0.5 * across + (0.25 * across * across + shear * shear).sqrt();
        assert_eq!(stress.tautness, Tautness::Wrinkled);
        assert!((first / (E * largest) - 1.0).abs() < 1e-12 && second.abs() < 1e-12 * first);
        assert!((angle - 0.5 * libm::atan2(gamma, -0.5 * gamma * gamma)).abs() < 1e-12);
        // 45 degrees, and E gamma/2, to first order
        assert!((angle - std::f64::consts::FRAC_PI_4).abs() < gamma && (first / (0.5 * E * gamma) - 1.0).abs() < gamma);
    }

    #[test]
    fn a_stretched_sheet_wrinkles_when_shear_overcomes_its_tension() {
        // tension s in both directions and shear stress G gamma: the smaller principal stress s - G gamma reaches zero
        let (e, shear_modulus) = (green(1.002), E / (2.0 * (1.0 + NU)));
        let critical = E / (1.0 - NU) * e / shear_modulus;
        let state = |share: f64| {
            // F = sqrt(C) of equal stretches and 2 e12 = share * critical
            let (square, shear) = (1.0 + 2.0 * e, share * critical);
            let (plus, minus) = ((square + shear).sqrt(), (square - shear).sqrt());
            let (mean, half) = (0.5 * (plus + minus), 0.5 * (plus - minus));
            membrane(&isotropic()).stress(strained(mean - 1.0, mean - 1.0, half)).tautness
        };
        assert_eq!(state(0.999), Tautness::Taut);
        assert_eq!(state(1.001), Tautness::Wrinkled);
    }

    #[test]
    fn along_its_fibres_a_woven_cloth_pulls_as_a_strip_of_fibres() {
        let fabric = Fabric { elasticity: Elasticity { fibre_angle: 0.0, ..woven().elasticity }, ..woven() };
        let (m, e) = (membrane(&fabric), green(1.01));
        assert_stress(&m, strained(0.01, -0.3, 0.0), Tautness::Wrinkled, [E * e, 0.0, 0.0]);
        assert_stress(&m, strained(-0.3, 0.01, 0.0), Tautness::Wrinkled, [0.0, 0.05 * E * e, 0.0]);
    }

    #[test]
    fn relaxed_energy_is_the_largest_that_a_tension_in_one_direction_explains() {
        // second method, by duality: W = max over directions n of (n.e n)^2 E(n)/2, n.e n > 0, with E(n) from
        // Lekhnitskii's 1/E = c^4/E1 + (1/G - 2 nu/E1) s^2 c^2 + s^4/E2
        for fabric in [isotropic(), woven()] {
            let m = membrane(&fabric);
            let Elasticity { moduli: [e1, e2], poisson_ratio, shear_modulus, fibre_angle } = fabric.elasticity;
            let mut wrinkled = 0;
            for (along, across, shear) in
                [(0.01, -0.02, 0.0), (0.004, -0.01, 0.006), (-0.02, 0.003, -0.004), (0.0, 0.0, 0.01)]
            {
                let x = strained(along, across, shear);
                if m.stress(x).tautness != Tautness::Wrinkled {
                    continue;
                }
                wrinkled += 1;
                let (a, b) = (DVec2::new(1.0 + along, shear), DVec2::new(shear, 1.0 + across));
                let strain = [0.5 * (a.dot(a) - 1.0), 0.5 * (b.dot(b) - 1.0), a.dot(b)];
                let steps = 100_000;
                let best = (0..steps)
                    .map(|i| {
                        let angle = std::f64::consts::PI * f64::from(i) / f64::from(steps);
                        let (sin, cos) = libm::sincos(angle);
                        let pulled = strain[0] * cos * cos + strain[1] * sin * sin + strain[2] * sin * cos;
                        let (s, c) = libm::sincos(angle - fibre_angle);
                        let (s, c) = (s * s, c * c);
                        let compliance =
                            c * c / e1 + (1.0 / shear_modulus - 2.0 * poisson_ratio / e1) * s * c + s * s / e2;
                        0.5 * pulled.max(0.0).powi(2) / compliance
                    })
                    .fold(0.0, f64::max);
                let found = m.elastic_energy(x) / m.volume;
                assert!((found / best - 1.0).abs() < 1e-7, "{found} J/m^3, by directions {best}");
            }
            assert!(wrinkled >= 3);
        }
    }

    #[test]
    fn stress_is_continuous_across_the_borders_of_its_states() {
        for fabric in [isotropic(), woven()] {
            let m = membrane(&fabric);
            let stress = |s: f64| m.stress(strained(0.012 - 0.03 * s, 0.01 - 0.06 * s, 0.01 - 0.012 * s));
            let states: Vec<Tautness> = (0..=1000).map(|i| stress(f64::from(i) * 1e-3).tautness).collect();
            for state in [Tautness::Taut, Tautness::Wrinkled, Tautness::Slack] {
                assert!(states.contains(&state), "{state:?} is not met");
            }
            for i in 0..100_000 {
                let (here, next) = (stress(f64::from(i) * 1e-5), stress(f64::from(i + 1) * 1e-5));
                for (a, b) in here.components.iter().zip(next.components) {
                    assert!((a - b).abs() < 3e-6 * E, "a jump of {} Pa", (a - b).abs());
                }
            }
        }
    }

    #[test]
    fn the_stress_of_damping_is_the_rate_of_the_relaxed_stress() {
        let (mut elastic, mut states) = (isotropic(), vec![]);
        elastic.damping_time = 1.0;
        for fabric in [elastic, Fabric { damping_time: 1.0, ..woven() }] {
            let m = membrane(&fabric);
            for (along, across, shear) in
                [(0.01, 0.008, 0.001), (0.01, -0.02, 0.004), (-0.02, 0.004, -0.003), (-0.02, -0.01, 0.003)]
            {
                let x = m.strain(m.gradient(strained(along, across, shear)));
                let rate = DVec3::new(0.3, -0.7, 0.5);
                let h = 1e-7;
                let ahead = m.law.stress(x + h * rate).components;
                let behind = m.law.stress(x - h * rate).components;
                let stress = m.law.stress(x);
                states.push(stress.tautness);
                let found = m.law.stress_rate(x, stress, rate);
                assert!(found.distance((ahead - behind) / (2.0 * h)) < 1e-6 * E, "{:?}", stress.tautness);
            }
        }
        assert!(states.contains(&Tautness::Taut) && states.contains(&Tautness::Wrinkled));
        assert!(states.contains(&Tautness::Slack));
    }

    #[test]
    fn the_bound_is_sharp_for_an_equilateral_triangle_at_rest() {
        let rest = [(0.0, 0.0), (0.2, 0.0), (0.1, 0.2 * 0.75_f64.sqrt())].map(DVec2::from);
        let m = Membrane::new([0, 1, 2], rest, &plate()).unwrap();
        let used = conformance::used_bound(&m, rest.map(|p| p.extend(0.0)), 1e-7);
        let stretched = 0.5 * (3.0 * LARGEST_STRETCH * LARGEST_STRETCH - 1.0);
        assert!((used * stretched - 1.0).abs() < 1e-5, "{used}");
    }

    #[test]
    fn what_cannot_be_a_membrane_is_refused() {
        let refused = |fabric: Fabric| assert!(Membrane::new([0, 1, 2], REST, &fabric).is_err(), "{fabric:?}");
        assert!(Membrane::new([0, 2, 2], REST, &plate()).is_err());
        assert!(Membrane::new([0, 1, 2], [REST[0], REST[2], REST[1]], &plate()).is_err());
        refused(Fabric { thickness: 0.0, ..plate() });
        refused(Fabric { damping_time: f64::NAN, ..plate() });
        refused(cloth(Elasticity::isotropic(E, 1.0)));
        refused(cloth(Elasticity { moduli: [E, -E], ..Elasticity::isotropic(E, NU) }));
        // nu12^2 < E1/E2
        refused(cloth(Elasticity { moduli: [E, 4.0 * E], ..Elasticity::isotropic(E, 0.5) }));
    }

    fn point(reach: f64) -> impl Strategy<Value = DVec3> {
        (-reach..reach, -reach..reach, -reach..reach).prop_map(|(x, y, z)| DVec3::new(x, y, z))
    }

    proptest! {
        #[test]
        fn forces_are_what_they_must_be(
            which in 0..3,
            strain in (-0.05..0.05, -0.05..0.05, -0.03..0.03),
            w in prop::array::uniform3(point(1.0)),
        ) {
            let m = membrane(&[isotropic(), woven(), plate()][which as usize]);
            let x = strained(strain.0, strain.1, strain.2);
            conformance::force_is_the_gradient(&m, x, 1e-6, E * THICKNESS * 0.3, 1e-6);
            conformance::forces_are_internal(&m, x, w);
            conformance::turns_with_its_nodes(&m, x, w);
        }

        #[test]
        fn forces_are_the_gradient_however_the_triangle_lies(which in 0..3, x in prop::array::uniform3(point(0.3))) {
            let m = membrane(&[isotropic(), woven(), plate()][which as usize]);
            conformance::force_is_the_gradient(&m, x, 1e-5, E * THICKNESS * 0.3, 1e-6);
        }

        #[test]
        fn the_bound_holds_up_to_the_largest_stretch(
            which in 0..3,
            first in 0.0..LARGEST_STRETCH,
            second in 0.0..LARGEST_STRETCH,
            angle in 0.0..3.2,
        ) {
            let m = membrane(&[isotropic(), woven(), plate()][which as usize]);
            let (sin, cos) = libm::sincos(angle);
            // F = stretches along turned axes
            let (a, b) = (DVec2::new(cos, sin), DVec2::new(-sin, cos));
            let x = deformed(first * cos * a - second * sin * b, first * sin * a + second * cos * b);
            let used = conformance::used_bound(&m, x, 1e-7);
            let damping = conformance::used_damping_bound(&m, x);
            prop_assert!(used < 1.0 + 1e-3 && damping < 1.0 + 1e-6, "{used}, of the damping {damping}");
        }
    }
}

//! The stress of thin cloth that pulls and does not push: plane stress of a St. Venant-Kirchhoff material, isotropic
//! or orthotropic, relaxed by tension-field theory.
//!
//! A wrinkle lets the cloth shorten at no cost. The relaxed energy is the least that wrinkles can reach (Pipkin, IMA
//! Journal of Applied Mathematics 36 (1986) 85; for a convex W of the Green strain, Pipkin, ibid. 52 (1994) 297),
//!
//! ```text
//! W_r(e) = min over positive semidefinite A of  e* : C : e* / 2,    e* = e + A
//! ```
//!
//! with A the strain that the wrinkles take up (Epstein and Forcinito, International Journal of Solids and Structures
//! 38 (2001) 5253, for orthotropic membranes). The stress is the exact slope, S = C : e*, never compressive:
//!
//! | state | where | S |
//! |---|---|---|
//! | taut | C : e has no negative principal value | C : e |
//! | slack | e has no positive principal value | 0 |
//! | wrinkled | else | uniaxial, s n n, with no strain across that would need compression |
//!
//! In an isotropic sheet wrinkled means e_2 <= -nu e_1 and e_1 > 0, and s = E e_1. Across the borders S is continuous,
//! so W_r has a continuous slope. How the orthotropic case becomes one increasing equation in one unknown:
//! docs/theory/membrane.md.
//!
//! Valid for cloth without bending stiffness worth speaking of, and for strains small enough that the material is
//! linear in the Green strain. The wrinkles themselves, their length and height, are not resolved.

use super::element::{ElementError, Property, checked, positive};
use glam::{DVec2, DVec3};

/// An elastic sheet in its plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elasticity {
    /// Elastic moduli along the fibres and across them, Pa.
    pub moduli: [f64; 2],
    /// Poisson ratio nu12: contraction across over stretch along the fibres, under tension along them.
    pub poisson_ratio: f64,
    /// Shear modulus, Pa.
    pub shear_modulus: f64,
    /// Direction of the fibres from the first axis of the sheet, rad.
    pub fibre_angle: f64,
}

impl Elasticity {
    /// The same in every direction: modulus E in Pa, Poisson ratio nu.
    pub fn isotropic(elastic_modulus: f64, poisson_ratio: f64) -> Self {
        Self {
            moduli: [elastic_modulus; 2],
            poisson_ratio,
            shear_modulus: elastic_modulus / (2.0 * (1.0 + poisson_ratio)),
            fibre_angle: 0.0,
        }
    }
}

/// State of a piece of sheet under its strain.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tautness {
    /// It pulls in every direction, or it is a plate.
    Taut,
    /// It pulls in one direction.
    Wrinkled,
    /// It does not pull.
    Slack,
}

/// The relaxed stress at a strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RelaxedStress {
    pub tautness: Tautness,
    /// Mean, difference and shear, Pa; see [`TensionField`].
    pub components: DVec3,
}

/// Strain to stress.
///
/// Symmetric tensors are written in three components (mean, difference, shear) of axes along the fibres that are
/// scaled so that the sheet is as stiff across as along: there stiffness is diagonal, and a tensor is positive
/// semidefinite where its first component is at least as large as the other two are long.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TensionField {
    /// By which strain along the fibres is multiplied, and strain across divided.
    balance: f64,
    /// Stiffness of the three components, Pa.
    modulus: DVec3,
    compresses: bool,
}

impl TensionField {
    /// Prepares the law. A sheet that `compresses` is a plate: it does not wrinkle.
    ///
    /// # Errors
    /// A modulus that is not positive; a Poisson ratio with which the sheet would not be stable, nu12^2 >= E1/E2.
    pub fn new(elasticity: &Elasticity, compresses: bool) -> Result<Self, ElementError> {
        let [along, across] = elasticity.moduli;
        positive(Property::ModulusAlong, along)?;
        positive(Property::ModulusAcross, across)?;
        positive(Property::ShearModulus, elasticity.shear_modulus)?;
        checked(Property::FibreAngle, elasticity.fibre_angle, true)?;
        let poisson = elasticity.poisson_ratio * (across / along).sqrt();
        checked(Property::PoissonRatio, elasticity.poisson_ratio, poisson.abs() < 1.0)?;

        let modulus = (along * across).sqrt();
        let modulus =
            DVec3::new(modulus / (2.0 * (1.0 - poisson)), modulus / (2.0 * (1.0 + poisson)), elasticity.shear_modulus);
        Ok(Self { balance: (along / across).sqrt().sqrt(), modulus, compresses })
    }

    /// Stiffness of the three components, Pa.
    pub(super) fn modulus(&self) -> DVec3 {
        self.modulus
    }

    /// Components of a strain: along the fibres, across them, and the angle by which they shear.
    pub(super) fn components(&self, along: f64, across: f64, shear: f64) -> DVec3 {
        let (along, across) = (along * self.balance, across / self.balance);
        DVec3::new(along + across, along - across, shear)
    }

    /// The stress of these components: along the fibres, across them, and shear.
    pub(super) fn tensor(&self, stress: DVec3) -> [f64; 3] {
        [(stress.x + stress.y) * self.balance, (stress.x - stress.y) / self.balance, stress.z]
    }

    /// The relaxed stress, Pa.
    pub(super) fn stress(&self, strain: DVec3) -> RelaxedStress {
        let taut = self.modulus * strain;
        if self.compresses || taut.x >= DVec2::new(taut.y, taut.z).length() {
            return RelaxedStress { tautness: Tautness::Taut, components: taut };
        }
        let deviation = DVec2::new(strain.y, strain.z);
        if strain.x <= -deviation.length() {
            return RelaxedStress { tautness: Tautness::Slack, components: DVec3::ZERO };
        }
        let size = self.wrinkled(strain.x, deviation);
        let direction = (deviation / (self.lever() * size - strain.x)).normalize();
        let components = size * DVec3::new(1.0, direction.x, direction.y);
        RelaxedStress { tautness: Tautness::Wrinkled, components }
    }

    /// Rate of the relaxed `stress` at `strain`, Pa/s, if the strain changes at `rate`, 1/s.
    pub(super) fn stress_rate(&self, strain: DVec3, stress: RelaxedStress, rate: DVec3) -> DVec3 {
        match stress.tautness {
            Tautness::Taut => self.modulus * rate,
            Tautness::Slack => DVec3::ZERO,
            Tautness::Wrinkled => {
                // (lever size - mean) direction = deviation, differentiated along |direction| = 1
                let (size, lever) = (stress.components.x, self.lever());
                let n = DVec2::new(stress.components.y, stress.components.z) / size;
                let (turn, compliance) = (DVec2::new(rate.y, rate.z), (lever * size - strain.x).recip());
                let grows = (n * compliance).dot(turn + rate.x * n) / (n * compliance).dot(lever * n);
                let turns = (turn - n * (lever * grows - rate.x)) * compliance;
                let deviates = grows * n + size * turns;
                DVec3::new(grows, deviates.x, deviates.y)
            }
        }
    }

    /// Sums of the compliances of the mean and of each of the other two components, 1/Pa.
    fn lever(&self) -> DVec2 {
        let compliance = self.modulus.recip();
        DVec2::splat(compliance.x) + DVec2::new(compliance.y, compliance.z)
    }

    /// The size s of a uniaxial stress s (1, n): the root of |deviation / (lever s - mean)| = 1, Pa.
    ///
    /// The reciprocal of the left side is concave and grows with s, so that Newton's method climbs to the root from any
    /// smaller s. For an isotropic sheet the start is the root.
    fn wrinkled(&self, mean: f64, deviation: DVec2) -> f64 {
        let lever = self.lever();
        let mut size = (self.modulus.x * mean).max((mean + deviation.length()) / lever.max_element());
        for _ in 0..MOST_ITERATIONS {
            let gap = lever * size - mean;
            let n = deviation / gap;
            let length = n.length();
            let next = size + (length - 1.0) * length * length / n.dot(n * lever / gap);
            if next <= size {
                break;
            }
            size = next;
        }
        size
    }
}

/// Newton's method doubles its digits and the start is good: five have been enough for all that was tried.
const MOST_ITERATIONS: usize = 20;

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Least principal value of a symmetric tensor in the three components.
    fn least(tensor: DVec3) -> f64 {
        tensor.x - DVec2::new(tensor.y, tensor.z).length()
    }

    /// A strain's component: of any size, and zero.
    fn component() -> impl Strategy<Value = f64> {
        prop_oneof![-0.05..0.05, -1e-9..1e-9, -1e-20..1e-20, Just(0.0)]
    }

    proptest! {
        #[test]
        fn stress_and_wrinkles_meet_the_conditions_of_the_least_energy(
            stiffer in -5.0..5.0,
            share_of_poisson in -0.95..0.95,
            shear in -4.0..4.0,
            strain in (component(), component(), component()),
        ) {
            let (along, across) = (1e9 * libm::exp(stiffer), 1e9);
            let law = TensionField::new(
                &Elasticity {
                    moduli: [along, across],
                    poisson_ratio: share_of_poisson * (along / across).sqrt(),
                    shear_modulus: (along * across).sqrt() * libm::exp(shear),
                    fibre_angle: 0.0,
                },
                false,
            )
            .unwrap();
            // S >= 0, A >= 0, S : A = 0: the least of a convex energy, as there is no other
            let strain = law.components(strain.0, strain.1, strain.2);
            let stress = law.stress(strain).components;
            let wrinkles = stress / law.modulus - strain;
            let (force, length) = (law.modulus.max_element() * strain.length(), strain.length());
            prop_assert!(least(stress) >= -1e-12 * force, "S = {stress}");
            prop_assert!(least(wrinkles) >= -1e-12 * force / law.modulus.min_element(), "A = {wrinkles}");
            prop_assert!(stress.dot(wrinkles).abs() <= 1e-12 * force * length, "S : A = {}", stress.dot(wrinkles));
        }
    }
}

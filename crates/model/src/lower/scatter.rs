//! Scatter: random deviations of a tractor's launch from the intended one.

use std::f64::consts::TAU;

use glam::DVec3;
use netcast_scenario::Scatter;
use netcast_webs::chance::uniform_above_zero;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Random deviations of one tractor's launch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Chance {
    /// Deviation of its speed, as a share of it.
    pub speed: f64,
    /// Deviation of its direction along two axes across it, rad.
    angle: [f64; 2],
    /// Deviation of its delay, s.
    pub delay: f64,
}

impl Chance {
    /// Deviations of the tractor at `corner`, from 1. Each tractor has a random stream of its own: another tractor does not
    /// change it.
    pub fn of(scatter: &Scatter, corner: u32) -> Chance {
        let mut source = ChaCha8Rng::seed_from_u64(scatter.seed.into());
        source.set_stream(corner.into());
        let [speed, across, delay, along] = [normal_pair(&mut source), normal_pair(&mut source)].concat()[..] else {
            unreachable!("two pairs are four")
        };
        let angle = scatter.angle.si();
        Chance {
            speed: scatter.speed.si() * speed,
            angle: [angle * across, angle * along],
            delay: scatter.delay.si() * delay,
        }
    }

    /// `direction`, a unit vector or zero, turned by the deviation.
    pub fn turned(&self, direction: DVec3) -> DVec3 {
        let [a, b] = self.angle;
        let angle = (a * a + b * b).sqrt();
        if angle == 0.0 || direction == DVec3::ZERO {
            return direction;
        }
        let (one, other) = direction.any_orthonormal_pair();
        let (sin, cos) = libm::sincos(angle);
        (cos * direction + sin / angle * (a * one + b * other)).normalize()
    }
}

/// Two independent normally distributed numbers of mean 0 and deviation 1 (Box and Muller, Ann. Math. Stat. 29, 1958).
/// Uses `libm`: a library's distribution would use the logarithm of the machine.
fn normal_pair(source: &mut ChaCha8Rng) -> [f64; 2] {
    let radius = (-2.0 * libm::log(uniform_above_zero(source))).sqrt();
    let (sin, cos) = libm::sincos(TAU * uniform_above_zero(source));
    [radius * cos, radius * sin]
}

#[cfg(test)]
mod tests {
    use super::*;
    use netcast_scenario::quantity::{Angle, Number, Time};

    fn scatter(seed: u32) -> Scatter {
        Scatter { speed: Number::constant(0.1), angle: Angle::constant(0.02), delay: Time::constant(1e-3), seed }
    }

    #[test]
    fn mean_and_deviation_are_those_asked_for_and_the_four_are_independent() {
        const COUNT: u32 = 20_000;
        let all: Vec<[f64; 4]> = (0..COUNT)
            .map(|corner| Chance::of(&scatter(7), corner))
            .map(|c| [c.speed / 0.1, c.angle[0] / 0.02, c.angle[1] / 0.02, c.delay / 1e-3])
            .collect();
        let mean = |of: &dyn Fn(&[f64; 4]) -> f64| all.iter().map(of).sum::<f64>() / f64::from(COUNT);
        for i in 0..4 {
            assert!(mean(&|c| c[i]).abs() < 0.03, "mean of {i}");
            assert!((mean(&|c| c[i].powi(4)) / 3.0 - 1.0).abs() < 0.1, "no normal distribution: {i}");
            for j in 0..4 {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((mean(&|c| c[i] * c[j]) - expected).abs() < 0.04, "{i} and {j}");
            }
        }
    }

    #[test]
    fn one_seed_repeats_the_scatter_and_another_seed_or_tractor_changes_it() {
        assert_eq!(Chance::of(&scatter(1), 3), Chance::of(&scatter(1), 3));
        assert_ne!(Chance::of(&scatter(1), 3), Chance::of(&scatter(2), 3));
        assert_ne!(Chance::of(&scatter(1), 3), Chance::of(&scatter(1), 4));
    }

    #[test]
    fn a_direction_is_turned_by_the_length_of_both_angles() {
        let chance = Chance { angle: [0.03, -0.04], ..Chance::default() };
        let direction = DVec3::new(0.6, 0.0, 0.8);
        assert!((chance.turned(direction).angle_between(direction) - 0.05).abs() < 1e-9);
    }
}

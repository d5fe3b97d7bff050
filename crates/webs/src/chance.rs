//! Uniform random numbers: 53 bits from a seeded ChaCha8 generator, the same on every machine.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// Spacing of the random numbers: they are multiples of 2^-53.
const STEP: f64 = 1.0 / (1_u64 << 53) as f64;

/// A random number, uniform in [0, 1).
pub fn uniform(source: &mut ChaCha8Rng) -> f64 {
    (source.next_u64() >> 11) as f64 * STEP
}

/// A random number, uniform in (0, 1], so that it has a logarithm.
pub fn uniform_above_zero(source: &mut ChaCha8Rng) -> f64 {
    // exact: the sum has 53 bits too
    uniform(source) + STEP
}

#[cfg(test)]
mod tests {
    use rand_chacha::rand_core::SeedableRng;

    use super::*;

    #[test]
    fn numbers_are_uniform_and_those_above_zero_are_one_step_larger() {
        const COUNT: usize = 20_000;
        let (mut one, mut other) = (ChaCha8Rng::seed_from_u64(3), ChaCha8Rng::seed_from_u64(3));
        let numbers: Vec<f64> = (0..COUNT).map(|_| uniform(&mut one)).collect();
        assert!(numbers.iter().all(|number| (0.0..1.0).contains(number)));
        for &number in &numbers {
            let above = uniform_above_zero(&mut other);
            assert!(above > 0.0 && above <= 1.0 && above - number == STEP);
        }
        // four standard errors of the mean and of the mean square
        let mean = |power: i32| numbers.iter().map(|number| number.powi(power)).sum::<f64>() / COUNT as f64;
        assert!((mean(1) - 0.5).abs() < 0.009 && (mean(2) - 1.0 / 3.0).abs() < 0.009);
    }
}

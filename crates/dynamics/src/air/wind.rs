//! Wind: a mean speed that depends on height, and a fluctuation that depends on time.
//!
//! A net is small against the eddies that move it, so the fluctuation is the same all over the net. The mean is a table
//! over height and the fluctuation is a table over time; both are interpolated linearly, so every wind costs the same. The
//! functions here make profiles and gusts; [`turbulence`](super::turbulence) makes random winds.

use glam::DVec3;

/// Mean wind over height and fluctuation over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Wind {
    /// Direction of the mean, a unit vector.
    pub direction: DVec3,
    /// Mean speed, m/s, by height above the muzzle.
    pub mean: LinearTable<f64>,
    /// Velocity added to the mean, m/s, by time.
    pub fluctuation: LinearTable<DVec3>,
}

/// A table of equally spaced values, interpolated linearly; constant before the first and after the last.
#[derive(Debug, Clone, PartialEq)]
pub struct LinearTable<T> {
    /// Height, m, or time, s, of the first value.
    pub first: f64,
    /// Spacing between values, m or s.
    pub spacing: f64,
    /// The values, at least one.
    pub values: Vec<T>,
}

impl<T: Copy + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>> LinearTable<T> {
    /// A table of one value.
    pub fn constant(value: T) -> LinearTable<T> {
        LinearTable { first: 0.0, spacing: 1.0, values: vec![value] }
    }

    /// The value at a height, m, or a time, s.
    #[inline(always)]
    pub fn at(&self, place: f64) -> T {
        let last = self.values.len() - 1;
        let place = (place - self.first) / self.spacing;
        if place <= 0.0 || last == 0 {
            return self.values[0];
        }
        if place >= last as f64 {
            return self.values[last];
        }
        let index = place as usize;
        let share = place - index as f64;
        self.values[index] * (1.0 - share) + self.values[index + 1] * share
    }
}

impl Wind {
    /// No wind.
    pub fn none() -> Wind {
        Wind::uniform(DVec3::X, 0.0)
    }

    /// A wind of constant `speed`, m/s, along a unit vector.
    pub fn uniform(direction: DVec3, speed: f64) -> Wind {
        Wind { direction, mean: LinearTable::constant(speed), fluctuation: LinearTable::constant(DVec3::ZERO) }
    }

    /// Velocity, m/s, at a height above the muzzle, m, and a time, s.
    pub fn at(&self, height: f64, time: f64) -> DVec3 {
        self.direction * self.mean.at(height) + self.fluctuation.at(time)
    }
}

/// The mean speed, m/s, as a power of the height z above the ground: u (z/z_ref)^p (Hellmann 1919). `speed` u, m/s, at the
/// height `reference` z_ref, m. `muzzle` is the height of the muzzle above the ground, m. The table ends at `top`, m above
/// the muzzle.
pub fn power_law(speed: f64, reference: f64, power: f64, muzzle: f64, top: f64) -> LinearTable<f64> {
    profile(muzzle, top, |height| speed * libm::pow(height / reference, power))
}

/// The mean speed, m/s, as the logarithm of the height z above the ground: u ln(z/z0) / ln(z_ref/z0), and 0 below the
/// roughness length z0, m (Prandtl's law of the wall; neutral stability). The other parameters are those of [`power_law`].
pub fn logarithmic(speed: f64, reference: f64, roughness: f64, muzzle: f64, top: f64) -> LinearTable<f64> {
    let scale = speed / libm::log(reference / roughness);
    profile(muzzle, top, |height| if height > roughness { scale * libm::log(height / roughness) } else { 0.0 })
}

/// Spacing of the entries of a profile, m.
const PROFILE_SPACING: f64 = 0.1;

fn profile(muzzle: f64, top: f64, speed: impl Fn(f64) -> f64) -> LinearTable<f64> {
    let count = ((top + muzzle) / PROFILE_SPACING).ceil().max(1.0) as usize;
    let values = (0..=count).map(|i| speed(i as f64 * PROFILE_SPACING)).collect();
    LinearTable { first: -muzzle, spacing: PROFILE_SPACING, values }
}

/// The speed of a gust, m/s: from `start`, s, it rises to `speed`, m/s, and falls again as (1 - cos)/2 within `duration`, s.
/// This is the plain form of the discrete gust of IEC 61400-1 and CS-25.341. One entry every `spacing` seconds or less.
pub fn gust(speed: f64, start: f64, duration: f64, spacing: f64) -> LinearTable<f64> {
    let count = (duration / spacing).ceil().max(1.0) as usize;
    let spacing = duration / count as f64;
    let phase = |i: usize| 2.0 * std::f64::consts::PI * i as f64 / count as f64;
    let values = (0..=count).map(|i| 0.5 * speed * (1.0 - libm::cos(phase(i)))).collect();
    LinearTable { first: start, spacing, values }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_is_straight_between_its_values_and_constant_beyond() {
        let series = LinearTable { first: 1.0, spacing: 0.5, values: vec![2.0, 4.0, 3.0] };
        let at = [0.0, 1.0, 1.25, 1.5, 1.75, 2.0, 9.0].map(|place| series.at(place));
        assert_eq!(at, [2.0, 2.0, 3.0, 4.0, 3.5, 3.0, 3.0]);
    }

    #[test]
    fn profiles_have_their_reference_speed_at_their_reference_height() {
        // the muzzle is 2 m above the ground
        let power = power_law(5.0, 10.0, 1.0 / 7.0, 2.0, 100.0);
        let log = logarithmic(5.0, 10.0, 0.03, 2.0, 100.0);
        assert!((power.at(8.0) - 5.0).abs() < 1e-9 && (log.at(8.0) - 5.0).abs() < 1e-9);
        assert!((power.at(98.0) - 5.0 * libm::pow(10.0, 1.0 / 7.0)).abs() < 1e-4);
        assert!((log.at(98.0) - 5.0 * libm::log(100.0 / 0.03) / libm::log(10.0 / 0.03)).abs() < 1e-4);
        assert_eq!((power.at(-2.0), log.at(-2.0)), (0.0, 0.0));
    }

    #[test]
    fn a_gust_rises_to_its_speed_and_is_over() {
        let gust = gust(6.0, 1.0, 0.8, 1e-3);
        assert!((gust.at(1.4) - 6.0).abs() < 1e-9 && (gust.at(1.2) - 3.0).abs() < 1e-5);
        assert!(gust.at(0.5).abs() < 1e-12 && gust.at(2.0).abs() < 1e-12);
    }
}

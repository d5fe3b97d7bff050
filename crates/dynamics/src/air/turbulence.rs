//! Turbulence: a stationary random wind of a given spectrum, made of waves with random phases.
//!
//! One-sided spectra over the frequency f, with standard deviation s, length scale l, mean speed U and x = f l/U:
//!
//! ```text
//! von Karman   along   4 s^2 (l/U) / (1 + 70.8 x^2)^(5/6)          across  4 s^2 (l/U) (1 + 755.2 x^2)/(1 + 283.2 x^2)^(11/6)
//! Dryden       along   4 s^2 (l/U) / (1 + (2 pi x)^2)              across  2 s^2 (l/U) (1 + 3 (2 pi x)^2)/(1 + (2 pi x)^2)^2
//! ```
//!
//! (von Karman 1948, in the form of ESDU 85020; Dryden: MIL-F-8785C, 3.7.2.) The frequencies are divided into [`WAVES`]
//! bands of equal width in the logarithm. One wave carries the energy of one band (Shinozuka & Jan, J. Sound Vib. 25, 1972).
//! So only the variance beyond the last band is lost, and the wind does not repeat. Eddies pass at the mean speed (Taylor
//! 1938).

use glam::DVec3;

use super::wind::LinearTable;

/// Number of waves in each component.
pub const WAVES: usize = 160;

/// The shape of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spectrum {
    /// Von Karman's, which falls as f^(-5/3).
    VonKarman,
    /// Dryden's, which falls as f^-2.
    Dryden,
}

/// A turbulent wind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turbulence {
    /// The shape of its spectrum.
    pub spectrum: Spectrum,
    /// Standard deviations along the mean wind, across it and upwards, m/s.
    pub deviation: [f64; 3],
    /// Length scales of these components, m.
    pub scale: [f64; 3],
    /// Mean speed, at which eddies pass, m/s.
    pub speed: f64,
}

/// Highest frequency, 1/s: a net does not respond to faster changes of the wind.
const HIGHEST: f64 = 50.0;
/// Entries of the table in one period of the highest frequency.
const PER_PERIOD: f64 = 10.0;

impl Turbulence {
    /// One-sided spectrum, m^2/s, of a component (0 along the mean, 1 across it, 2 upwards) at frequency `f`, 1/s.
    pub fn density(&self, component: usize, f: f64) -> f64 {
        let time = self.scale[component] / self.speed;
        let (x, variance) = (f * time, self.deviation[component] * self.deviation[component]);
        let turn = 2.0 * std::f64::consts::PI * x;
        match (self.spectrum, component) {
            (Spectrum::VonKarman, 0) => 4.0 * variance * time / libm::pow(1.0 + 70.8 * x * x, 5.0 / 6.0),
            (Spectrum::VonKarman, _) => {
                4.0 * variance * time * (1.0 + 755.2 * x * x) / libm::pow(1.0 + 283.2 * x * x, 11.0 / 6.0)
            }
            (Spectrum::Dryden, 0) => 4.0 * variance * time / (1.0 + turn * turn),
            (Spectrum::Dryden, _) => {
                let sum = 1.0 + turn * turn;
                2.0 * variance * time * (1.0 + 3.0 * turn * turn) / (sum * sum)
            }
        }
    }

    /// Velocity that turbulence adds to the mean wind, m/s, during `duration` seconds. `axes` are the unit vectors of its
    /// components; `random` returns numbers between 0 and 1 and is called three times for each wave.
    pub fn series(&self, axes: [DVec3; 3], duration: f64, mut random: impl FnMut() -> f64) -> LinearTable<DVec3> {
        let spacing = 1.0 / (PER_PERIOD * HIGHEST);
        let count = (duration / spacing).ceil() as usize + 1;
        let mut values = vec![DVec3::ZERO; count + 1];
        for wave in 0..WAVES {
            for (component, axis) in axes.into_iter().enumerate() {
                let phase = 2.0 * std::f64::consts::PI * random();
                let (frequency, amplitude) = self.wave(component, wave);
                let rate = 2.0 * std::f64::consts::PI * frequency * spacing;
                for (i, value) in values.iter_mut().enumerate() {
                    *value += axis * (amplitude * libm::cos(rate * i as f64 + phase));
                }
            }
        }
        LinearTable { first: 0.0, spacing, values }
    }

    /// Frequency, 1/s, and amplitude, m/s, of a wave.
    fn wave(&self, component: usize, wave: usize) -> (f64, f64) {
        // the bands start far below the knee of the spectrum; the first reaches down to zero
        let lowest = 1e-3 * self.speed / self.scale[component];
        let ratio = libm::pow(HIGHEST / lowest, 1.0 / WAVES as f64);
        let to = lowest * libm::pow(ratio, wave as f64 + 1.0);
        let from = if wave == 0 { 0.0 } else { to / ratio };
        // Simpson's rule over the band
        let middle = 0.5 * (from + to);
        let ends = self.density(component, from) + self.density(component, to);
        let energy = (to - from) / 6.0 * (ends + 4.0 * self.density(component, middle));
        (middle, (2.0 * energy).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turbulence(spectrum: Spectrum) -> Turbulence {
        Turbulence { spectrum, deviation: [1.5, 1.2, 0.8], scale: [40.0, 20.0, 10.0], speed: 80.0 }
    }

    /// Numbers between 0 and 1 (Weyl's sequence: equidistributed, not random, which is enough here).
    fn numbers() -> impl FnMut() -> f64 {
        let mut last = 0.0;
        move || {
            last = (last + 0.754_877_666_246_692_7) % 1.0;
            last
        }
    }

    #[test]
    fn each_spectrum_integrates_to_the_variance() {
        for spectrum in [Spectrum::VonKarman, Spectrum::Dryden] {
            let turbulence = turbulence(spectrum);
            for component in 0..3 {
                // the integral over all frequencies, in the logarithm of frequency
                let steps = 200_000;
                let at = |i: usize| libm::exp(-14.0 + 32.0 * i as f64 / steps as f64);
                let sum: f64 =
                    (0..steps).map(|i| at(i) * turbulence.density(component, at(i)) * 32.0 / steps as f64).sum();
                let variance = turbulence.deviation[component] * turbulence.deviation[component];
                assert!((sum / variance - 1.0).abs() < 2e-3, "{spectrum:?} {component}: {}", sum / variance);
            }
        }
    }

    #[test]
    fn a_long_series_has_the_variance_and_the_spectrum() {
        for spectrum in [Spectrum::VonKarman, Spectrum::Dryden] {
            let turbulence = turbulence(spectrum);
            let series = turbulence.series([DVec3::X, DVec3::Y, DVec3::Z], 600.0, numbers());
            for component in 0..3 {
                let values: Vec<f64> = series.values.iter().map(|v| v[component]).collect();
                let n = values.len() as f64;
                let variance = values.iter().map(|v| v * v).sum::<f64>() / n;
                let asked = turbulence.deviation[component] * turbulence.deviation[component];
                assert!((variance / asked - 1.0).abs() < 0.1, "{spectrum:?} {component}: {}", variance / asked);
                // energy between two frequencies, by a discrete Fourier transform of those frequencies alone;
                // every tenth value is enough for it
                let values: Vec<f64> = values.into_iter().step_by(10).collect();
                let n = values.len() as f64;
                let (low, high, time) = (0.5, 1.5, n * 10.0 * series.spacing);
                let lines = (low * time) as usize..(high * time) as usize;
                let energy: f64 = lines
                    .map(|line| {
                        let rate = 2.0 * std::f64::consts::PI * line as f64 / n;
                        let (c, s) = values.iter().enumerate().fold((0.0, 0.0), |(c, s), (i, v)| {
                            let (sin, cos) = libm::sincos(rate * i as f64);
                            (c + v * cos, s + v * sin)
                        });
                        2.0 * (c * c + s * s) / (n * n)
                    })
                    .sum();
                let expected: f64 =
                    (0..1000).map(|i| turbulence.density(component, low + (i as f64 + 0.5) * 1e-3) * 1e-3).sum();
                assert!((energy / expected - 1.0).abs() < 0.1, "{spectrum:?} {component}: {}", energy / expected);
            }
        }
    }
}

//! A rope that becomes stiffer, or softer, beyond a strain.
//!
//! ```text
//! T = k d                        0 < d <= d1,   d1 = e1 L0                tension, N
//! T = k d1 + r k (d - d1)        d > d1,        r = E2/E
//! U = k d^2/2 + (r - 1) k max(0, d - d1)^2/2                              elastic energy, J
//! ```
//!
//! e1 is the strain at the bend, E and E2 the moduli below and above it, k = EA/L0 (N/m). Twisted and braided ropes
//! settle first and stiffen then (r > 1: McKenna, Hearle, O'Hear, Handbook of Fibre Rope Technology, 2004); some
//! fibres yield (r < 1). It is elastic: it unloads along the way it was loaded, so it is no model of plastic
//! yielding, for which a table with an unloading path is. Both branches are ramps, and each gets the correction of
//! [`rope_tension`](super::rope_tension) where it begins, so that the work of a step across the bend is exact.

use super::rope_tension::ramp;

/// The parameters of the law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bilinear {
    /// Strain e1 at the bend; at least 0.
    pub strain: f64,
    /// Second stiffness over the first, r; at least 0.
    pub ratio: f64,
}

impl Bilinear {
    /// Tension at a stretch of a segment that changes its length by `swept` in a step, N; lengths in m.
    pub(crate) fn tension(&self, stretch: f64, swept: f64, rest_length: f64, stiffness: f64) -> f64 {
        let beyond = ramp(stretch - self.strain * rest_length, swept);
        stiffness * (ramp(stretch, swept) + (self.ratio - 1.0) * beyond)
    }

    pub(crate) fn elastic_energy(&self, stretch: f64, rest_length: f64, stiffness: f64) -> f64 {
        let stretch = stretch.max(0.0);
        let beyond = (stretch - self.strain * rest_length).max(0.0);
        0.5 * stiffness * (stretch * stretch + (self.ratio - 1.0) * beyond * beyond)
    }

    pub(crate) fn largest_stiffness(&self, stiffness: f64) -> f64 {
        stiffness * self.ratio.max(1.0)
    }

    pub(crate) fn strain_under(&self, tension: f64, axial_stiffness: f64) -> f64 {
        let strain = tension / axial_stiffness;
        if strain > self.strain { self.strain + (strain - self.strain) / self.ratio } else { strain }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STIFFENING: Bilinear = Bilinear { strain: 0.02, ratio: 4.0 };

    #[test]
    fn tension_and_energy_are_those_of_two_straight_lines() {
        // L0 2 m, k 1 kN/m: the bend at 40 mm and 40 N; at 100 mm 40 + 4 * 60 = 280 N
        assert!((STIFFENING.tension(0.1, 0.0, 2.0, 1e3) - 280.0).abs() < 1e-10);
        // 40 N * 40 mm / 2 + (40 + 280) N * 60 mm / 2
        assert!((STIFFENING.elastic_energy(0.1, 2.0, 1e3) - (0.8 + 9.6)).abs() < 1e-12);
        assert!((STIFFENING.strain_under(280.0, 2e3) - 0.05).abs() < 1e-15);
        assert_eq!((STIFFENING.tension(-0.1, 0.0, 2.0, 1e3), STIFFENING.elastic_energy(-0.1, 2.0, 1e3)), (0.0, 0.0));
    }

    #[test]
    fn the_work_of_steps_across_both_bends_is_the_energy_stored() {
        let (sweep, mut stretch, mut work) = (0.007, -0.0031, 0.0);
        let tension = |stretch: f64| STIFFENING.tension(stretch, sweep, 2.0, 1e3);
        for _ in 0..14 {
            work += 0.5 * (tension(stretch) + tension(stretch + sweep)) * sweep;
            stretch += sweep;
        }
        let stored = STIFFENING.elastic_energy(stretch, 2.0, 1e3);
        assert!((work / stored - 1.0).abs() < 1e-12, "{work} J of work, {stored} J stored");
    }
}

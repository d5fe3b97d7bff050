//! Spells: the intervals of time in which a quantity is at or above a threshold.

use serde::{Deserialize, Serialize};

/// Finds the spells in which a quantity is at least zero; crossings are interpolated linearly.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Spells {
    last: Option<(f64, f64)>,
    open: Option<f64>,
    first: Option<f64>,
    longest: Option<(f64, f64)>,
    total: f64,
}

impl Spells {
    /// Adds a value at `time`, s; times ascend. A value that is not finite is ignored.
    pub fn add(&mut self, time: f64, value: f64) {
        if !value.is_finite() {
            return;
        }
        let crossing = |(t, v): (f64, f64)| t + (time - t) * (v / (v - value));
        match (self.open, value >= 0.0) {
            (None, true) => {
                let start = self.last.map_or(time, crossing);
                self.open = Some(start);
                self.first.get_or_insert(start);
            }
            (Some(start), false) => {
                let end = self.last.map_or(time, crossing);
                self.close(start, end);
                self.open = None;
            }
            _ => {}
        }
        self.last = Some((time, value));
    }

    /// Whether a spell has begun and not ended.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Start of the first spell, s.
    pub fn first(&self) -> Option<f64> {
        self.first
    }

    /// Start and end of the longest spell, and the total length of all, s. An open spell ends with the last value.
    pub fn finish(mut self) -> (Option<(f64, f64)>, f64) {
        if let (Some(start), Some((end, _))) = (self.open, self.last) {
            self.close(start, end);
        }
        (self.longest, self.total)
    }

    fn close(&mut self, start: f64, end: f64) {
        self.total += end - start;
        if self.longest.is_none_or(|(a, b)| end - start > b - a) {
            self.longest = Some((start, end));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spells_of_a_sine_have_its_crossings_and_lengths() {
        // sin(t) - 1/2 on [0, 4 pi]: above zero from pi/6 to 5 pi/6, twice
        let mut spells = Spells::default();
        let pi = std::f64::consts::PI;
        for i in 0..=40_000 {
            let t = 4.0 * pi * i as f64 / 40_000.0;
            spells.add(t, libm::sin(t) - 0.5);
        }
        assert!((spells.first().unwrap() - pi / 6.0).abs() < 1e-7);
        let (longest, total) = spells.finish();
        let (from, to) = longest.unwrap();
        assert!((to - from - 2.0 * pi / 3.0).abs() < 1e-6 && (total - 4.0 * pi / 3.0).abs() < 1e-6);
    }

    #[test]
    fn an_open_spell_ends_with_the_last_value_and_without_values_there_is_no_spell() {
        let mut spells = Spells::default();
        spells.add(0.0, 1.0);
        spells.add(2.0, 3.0);
        assert_eq!(spells.finish(), (Some((0.0, 2.0)), 2.0));
        let mut never = Spells::default();
        never.add(0.0, -1.0);
        assert_eq!(never.finish(), (None, 0.0));
    }
}

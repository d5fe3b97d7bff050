//! The largest value of a quantity and when it occurred.

use serde::{Deserialize, Serialize};

/// A largest value and its time.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Peak(Option<(f64, f64)>);

impl Peak {
    /// Whether `value` is the largest so far. Of a run that diverges only the finite part counts.
    pub fn add(&mut self, time: f64, value: f64) -> bool {
        let larger = value.is_finite() && self.0.is_none_or(|(largest, _)| value > largest);
        if larger {
            self.0 = Some((value, time));
        }
        larger
    }

    /// The largest value and its time, s.
    pub fn get(&self) -> Option<(f64, f64)> {
        self.0
    }

    /// The largest value.
    pub fn value(&self) -> Option<f64> {
        self.0.map(|(value, _)| value)
    }

    /// When it occurred, s.
    pub fn time(&self) -> Option<f64> {
        self.0.map(|(_, time)| time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_peak_keeps_the_first_of_equals() {
        let mut peak = Peak::default();
        assert!(peak.add(0.0, 1.0) && peak.add(1.0, 2.0) && !peak.add(2.0, 2.0));
        assert_eq!((peak.value(), peak.time()), (Some(2.0), Some(1.0)));
    }
}

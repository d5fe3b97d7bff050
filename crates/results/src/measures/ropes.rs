//! Tensions of each kind of rope, and its utilisation: largest tension over strength.

use serde::{Deserialize, Serialize};

use crate::landmarks::Landmarks;
use crate::summary::{RopeUse, Summary};

/// Statistics of the tensions of each kind of rope over all checks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RopeMeasures {
    /// Smallest, N, sum, N, and number of tensions; (kinds,).
    kinds: Vec<(f64, f64, f64)>,
}

/// A largest tension, N, its time, s, and its link class.
pub type LargestTension<'l> = Option<(f64, f64, &'l str)>;

impl RopeMeasures {
    /// For `kinds` kinds of rope.
    pub fn new(kinds: usize) -> RopeMeasures {
        RopeMeasures { kinds: vec![(f64::MAX, 0.0, 0.0); kinds] }
    }

    /// Whether the number of kinds is that of `landmarks`.
    pub fn fit(&self, landmarks: &Landmarks) -> bool {
        self.kinds.len() == landmarks.ropes.len()
    }

    /// Adds the tensions at a check, N, not finite for a broken segment. Both (segments,); `groups`: group of each segment.
    pub fn add(&mut self, landmarks: &Landmarks, tension: &[f64], groups: &[usize]) {
        for (&tension, &group) in tension.iter().zip(groups).filter(|(tension, _)| tension.is_finite()) {
            if let Some(rope) = landmarks.groups[group].rope {
                let (least, sum, count) = &mut self.kinds[rope];
                (*least, *sum, *count) = (least.min(tension), *sum + tension, *count + 1.0);
            }
        }
    }

    /// Writes the use of each kind of rope into the summary. `largest`: its largest tension over all steps, by kind.
    pub fn finish<'l>(
        &self,
        landmarks: &Landmarks,
        largest: impl Fn(usize) -> LargestTension<'l>,
        summary: &mut Summary,
    ) {
        for (index, (rope, (least, sum, count))) in landmarks.ropes.iter().zip(&self.kinds).enumerate() {
            let largest = largest(index);
            let max_n = largest.map_or(0.0, |(tension, _, _)| tension);
            let effective_strength =
                rope.strength.map(|strength| strength * (1.0 - rope.knot_reduction.unwrap_or(0.0)));
            let used = RopeUse {
                min_n: (*count > 0.0).then_some(*least),
                mean_n: (*count > 0.0).then(|| sum / count),
                max_n,
                max_time_s: largest.filter(|_| max_n > 0.0).map(|(_, time, _)| time),
                max_where: largest.filter(|_| max_n > 0.0).map(|(_, _, class)| class.to_owned()),
                strength_n: rope.strength,
                knot_reduction: rope.knot_reduction,
                utilisation: effective_strength.map(|strength| max_n / strength),
                margin: effective_strength.filter(|_| max_n > 0.0).map(|strength| strength / max_n),
            };
            summary.tension.by_rope.insert(rope.name.clone(), used);
        }
    }
}

//! What each kind of rope bears, and what share of its strength that takes.

use serde::{Deserialize, Serialize};

use crate::landmarks::Landmarks;
use crate::summary::{RopeUse, Summary};

/// Tensions of each kind of rope at checks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RopeMeasures {
    /// Smallest, sum and number of tensions, by rope.
    kinds: Vec<(f64, f64, f64)>,
}

/// A largest tension, N, its time, s, and the link class where it occurred.
pub type LargestTension<'l> = Option<(f64, f64, &'l str)>;

impl RopeMeasures {
    /// Of so many kinds of rope.
    pub fn new(kinds: usize) -> RopeMeasures {
        RopeMeasures { kinds: vec![(f64::MAX, 0.0, 0.0); kinds] }
    }

    /// Whether these are measures of a web with such landmarks.
    pub fn fit(&self, landmarks: &Landmarks) -> bool {
        self.kinds.len() == landmarks.ropes.len()
    }

    /// The tensions of all segments at a check, N, with the group of each; those that are gone have none.
    pub fn add(&mut self, landmarks: &Landmarks, tension: &[f64], groups: &[usize]) {
        for (&tension, &group) in tension.iter().zip(groups).filter(|(tension, _)| tension.is_finite()) {
            if let Some(rope) = landmarks.groups[group].rope {
                let (least, sum, count) = &mut self.kinds[rope];
                (*least, *sum, *count) = (least.min(tension), *sum + tension, *count + 1.0);
            }
        }
    }

    /// Writes the use of each rope, by its name, into the summary; `largest` is what it bore at any step.
    pub fn finish<'l>(
        &self,
        landmarks: &Landmarks,
        largest: impl Fn(usize) -> LargestTension<'l>,
        summary: &mut Summary,
    ) {
        for (index, (rope, (least, sum, count))) in landmarks.ropes.iter().zip(&self.kinds).enumerate() {
            let largest = largest(index);
            let max_n = largest.map_or(0.0, |(tension, _, _)| tension);
            let bears = rope.strength.map(|strength| strength * (1.0 - rope.knot_reduction.unwrap_or(0.0)));
            let used = RopeUse {
                min_n: (*count > 0.0).then_some(*least),
                mean_n: (*count > 0.0).then(|| sum / count),
                max_n,
                max_time_s: largest.filter(|_| max_n > 0.0).map(|(_, time, _)| time),
                max_where: largest.filter(|_| max_n > 0.0).map(|(_, _, class)| class.to_owned()),
                strength_n: rope.strength,
                knot_reduction: rope.knot_reduction,
                utilisation: bears.map(|bears| max_n / bears),
                margin: bears.filter(|_| max_n > 0.0).map(|bears| bears / max_n),
            };
            summary.tension.by_rope.insert(rope.name.clone(), used);
        }
    }
}

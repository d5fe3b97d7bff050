//! Tensions of each kind of rope, and its utilisation: largest tension over strength.

use netcast_dynamics::simulate::Live;
use serde::{Deserialize, Serialize};

use crate::landmarks::Landmarks;
use crate::summary::{RopeUse, Summary};

/// The largest strain of a group, at the steps of its highest tensions.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
struct Strained {
    /// The highest tension so far and that of the last look at the strains, N.
    highest: f64,
    seen: f64,
    /// Strain, time, s, and segment.
    largest: Option<(f64, f64, usize)>,
}

/// How much a tension must grow until the strains of its group are looked at again.
const GROWTH: f64 = 1.01;

impl Strained {
    /// Takes a step into account. A tension is the highest of its segment about when its strain is, so the strains are looked
    /// at when the tension has grown by another part, and when it begins to fall.
    fn add(&mut self, group: usize, tension: f64, live: &Live) {
        let falls = tension < self.highest && self.highest > self.seen;
        self.highest = self.highest.max(tension);
        if !falls && tension <= GROWTH * self.seen {
            return;
        }
        self.seen = self.highest;
        if let Some((segment, strain)) = live.net.largest_strain(group)
            && self.largest.is_none_or(|(largest, ..)| strain > largest)
        {
            self.largest = Some((strain, live.tension_time, segment));
        }
    }
}

/// Statistics of the tensions of each kind of rope over all checks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RopeMeasures {
    /// Smallest, N, sum, N, and number of tensions; (kinds,).
    kinds: Vec<(f64, f64, f64)>,
    /// (groups,).
    strained: Vec<Strained>,
}

/// A largest tension, N, its time, s, and its link class.
pub type LargestTension<'l> = Option<(f64, f64, &'l str)>;

impl RopeMeasures {
    /// No step yet.
    pub fn new(landmarks: &Landmarks) -> RopeMeasures {
        RopeMeasures {
            kinds: vec![(f64::MAX, 0.0, 0.0); landmarks.ropes.len()],
            strained: vec![Strained::default(); landmarks.groups.len()],
        }
    }

    /// Takes the strains of a step into account. `largest`: highest tension of each group, N, (groups,).
    pub fn step(&mut self, largest: &[f64], live: &Live) {
        for (group, (strained, &tension)) in self.strained.iter_mut().zip(largest).enumerate() {
            strained.add(group, tension, live);
        }
    }

    /// Whether the number of kinds is that of `landmarks`.
    pub fn fit(&self, landmarks: &Landmarks) -> bool {
        self.kinds.len() == landmarks.ropes.len() && self.strained.len() == landmarks.groups.len()
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
            let groups = landmarks.groups.iter().zip(&self.strained).filter(|(group, _)| group.rope == Some(index));
            let strained = groups.filter_map(|(group, strained)| Some((strained.largest?, group.class)));
            let strained = strained.max_by(|one, other| one.0.0.total_cmp(&other.0.0)).filter(|_| max_n > 0.0);
            let used = RopeUse {
                min_n: (*count > 0.0).then_some(*least),
                mean_n: (*count > 0.0).then(|| sum / count),
                max_n,
                max_time_s: largest.filter(|_| max_n > 0.0).map(|(_, time, _)| time),
                max_where: largest.filter(|_| max_n > 0.0).map(|(_, _, class)| class.to_owned()),
                strain_max: strained.map(|((strain, ..), _)| strain),
                strain_max_time_s: strained.map(|((_, time, _), _)| time),
                strain_max_where: strained.map(|(_, class)| landmarks.classes[class].name.clone()),
                strength_n: rope.strength,
                knot_reduction: rope.knot_reduction,
                utilisation: effective_strength.map(|strength| max_n / strength),
                margin: effective_strength.filter(|_| max_n > 0.0).map(|strength| strength / max_n),
            };
            summary.tension.by_rope.insert(rope.name.clone(), used);
        }
    }
}

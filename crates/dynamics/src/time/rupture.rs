//! Segments of a block that break. A block that does not break pays one comparison a step.

use crate::forces::breaking::Breaking;

/// Breaking load, N, breaking length, m, and time of the cut, s, of each slot's segment, and the least of each; (slots,).
#[derive(Debug, Clone, Default)]
pub(super) struct Strength {
    load: Vec<f64>,
    length: Vec<f64>,
    cut_at: Vec<f64>,
    /// Infinite where none ever breaks.
    least_load: f64,
    least_length: f64,
    first_cut: f64,
}

/// A segment that breaks: its last tension acts, and from the next forces on it is gone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Failing {
    pub slot: usize,
    /// N.
    pub tension: f64,
    /// Elastic energy that it held, J.
    pub energy: f64,
}

impl Strength {
    /// From rest length and strength of each slot's segment; slots without one never break.
    pub fn new(slots: &[Option<(f64, Breaking)>]) -> Strength {
        let by_slot = |value: fn(&(f64, Breaking)) -> f64| -> Vec<f64> {
            slots.iter().map(|slot| slot.as_ref().map_or(f64::INFINITY, value)).collect()
        };
        let load = by_slot(|(_, breaking)| breaking.load);
        let length = by_slot(|(rest_length, breaking)| breaking.length(*rest_length));
        let cut_at = by_slot(|(_, breaking)| breaking.cut_at);
        let (least_load, least_length, first_cut) = (least(&load), least(&length), least(&cut_at));
        Strength { load, length, cut_at, least_load, least_length, first_cut }
    }

    /// Whether none can break at this time, s, where the largest tension is this, N.
    pub fn holds(&self, time: f64, max_tension: f64) -> bool {
        max_tension <= self.least_load && self.least_length == f64::INFINITY && time < self.first_cut
    }

    /// The slots whose segments break at this time, s, these tensions, N, and lengths, m.
    pub fn exceeded<'s>(
        &'s self,
        time: f64,
        tension: &'s [f64],
        length: &'s [f64],
    ) -> impl Iterator<Item = usize> + 's {
        let breaks = move |&slot: &usize| {
            tension[slot] > self.load[slot] || length[slot] > self.length[slot] || time >= self.cut_at[slot]
        };
        (0..self.load.len()).filter(breaks)
    }

    /// Removes the segment of this slot.
    pub fn remove(&mut self, slot: usize) {
        for of_slot in [&mut self.load, &mut self.length, &mut self.cut_at] {
            of_slot[slot] = f64::INFINITY;
        }
        (self.least_load, self.least_length) = (least(&self.load), least(&self.length));
        self.first_cut = least(&self.cut_at);
    }
}

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

//! Segments of a block that break. A block that does not break pays one comparison a step.

use super::blocks::Ropes;
use crate::forces::breaking::Breaking;
use crate::forces::law::Axial;

/// What the segments of a block bear at most; no entries where none ever breaks.
#[derive(Debug, Clone, Default)]
pub(super) struct Strength {
    load: Vec<f64>,
    length: Vec<f64>,
    /// Infinite where none ever breaks.
    least_load: f64,
    least_length: f64,
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
        let each = |value: fn(&(f64, Breaking)) -> f64| -> Vec<f64> {
            slots.iter().map(|slot| slot.as_ref().map_or(f64::INFINITY, value)).collect()
        };
        let load = each(|(_, breaking)| breaking.load);
        let length = each(|(rest_length, breaking)| breaking.length(*rest_length));
        Strength { least_load: least(&load), least_length: least(&length), load, length }
    }
}

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

impl Ropes {
    /// Lets go what broke at the forces before, unless these are the same again.
    pub fn let_go(&mut self, moved: bool) {
        for Failing { slot, .. } in std::mem::take(&mut self.failing) {
            if moved {
                self.remove(slot);
            }
        }
    }

    /// The segment of this slot is no more.
    pub fn remove(&mut self, slot: usize) {
        let Axial { rest_length, stiffness, damping } = Axial::GONE;
        (self.rest_length[slot], self.stiffness[slot], self.damping[slot]) = (rest_length, stiffness, damping);
        self.dragging.iter_mut().for_each(|dragging| dragging.remove(slot));
        let Strength { load, length, least_load, least_length } = &mut self.strength;
        (load[slot], length[slot]) = (f64::INFINITY, f64::INFINITY);
        (*least_load, *least_length) = (least(load), least(length));
    }

    /// Finds what breaks under the tensions just computed.
    pub fn yield_to_loads(&mut self) {
        let Strength { load, length, least_load, least_length } = &self.strength;
        if self.max_tension <= *least_load && *least_length == f64::INFINITY {
            return;
        }
        for slot in 0..load.len() {
            if self.tension[slot] > load[slot] || self.length[slot] > length[slot] {
                let (axial, memory) = (self.axial(slot), self.memory.get(slot).copied().unwrap_or_default());
                let energy = self.law.elastic_energy(self.length[slot] - axial.rest_length, &axial, &memory);
                self.failing.push(Failing { slot, tension: self.tension[slot], energy });
                // nothing takes back what its last tension does
                self.friction[slot] = self.tension[slot];
            }
        }
    }

    /// Whether the segment of this slot is gone.
    pub fn is_gone(&self, slot: usize) -> bool {
        self.rest_length[slot] == Axial::GONE.rest_length
    }
}

//! Projection: moves nodes until no distance limit is exceeded, and plates after their corners.
//!
//! One sweep visits every limit in turn. A limit that is exceeded moves its two nodes towards each other, and each plate
//! then takes the place and the attitude that fit its corners best.

use glam::{DMat3, DVec3};

use crate::CutWeb;
use crate::packing::StiffPlate;
use crate::packing::distance_limits::DistanceLimit;

/// An excess that rounding explains, relative to the limit.
const ROUNDING: f64 = 1e-12;

/// How much shorter than its limit a distance becomes in [`Projection::draw_in`], relative: without that, sweeps come
/// near an end and never reach it.
const AIM: f64 = 1e-3;

/// Sweeps at most.
const MOST_SWEEPS: usize = 20_000;

/// What a projection keeps.
pub(super) struct Projection<'a> {
    pub cut_web: &'a CutWeb,
    /// How far nodes may be apart.
    pub limits: &'a [DistanceLimit],
    /// The canopies that keep their shape.
    pub plates: &'a [StiffPlate],
    /// 1/kg, or any other weight, (nodes,): a node moves in proportion to it, and stays where it is 0.
    pub inverse_mass: &'a [f64],
}

impl Projection<'_> {
    /// One sweep over all limits, in reverse order if `backwards`. A distance that exceeds its limit becomes shorter than
    /// this by the share `aim`. Returns whether there was one.
    pub fn sweep(&self, backwards: bool, aim: f64, turns: &mut [DMat3], packed: &mut [DVec3]) -> bool {
        let mut was_exceeded = false;
        for number in 0..self.limits.len() {
            let number = if backwards { self.limits.len() - 1 - number } else { number };
            let DistanceLimit { ends: [a, b], length } = self.limits[number];
            let between = packed[b] - packed[a];
            let excess = between.length() - length;
            let inverse_mass = self.inverse_mass[a] + self.inverse_mass[b];
            if excess <= ROUNDING * length || inverse_mass == 0.0 {
                continue;
            }
            was_exceeded = true;
            let way = (excess + aim * length) / inverse_mass * between.normalize_or_zero();
            packed[a] += self.inverse_mass[a] * way;
            packed[b] -= self.inverse_mass[b] * way;
        }
        if was_exceeded {
            self.place_plates(turns, packed);
        }
        was_exceeded
    }

    /// Fits every plate to its corners; a hub that stays keeps its place.
    pub fn place_plates(&self, turns: &mut [DMat3], packed: &mut [DVec3]) {
        for (plate, turn) in self.plates.iter().zip(turns) {
            let hub = self.cut_web.web.canopies[plate.canopy].hub;
            let middle = packed[hub];
            *turn = plate.fit_corners(self.cut_web, *turn, packed);
            if self.inverse_mass[hub] == 0.0 {
                packed[hub] = middle;
            }
            plate.place(self.cut_web, *turn, packed);
        }
    }

    /// Sweeps until no limit is exceeded. A distance that still exceeds its limit after very many sweeps stays as it is:
    /// the audit reports it.
    pub fn draw_in(&self, turns: &mut [DMat3], packed: &mut [DVec3]) {
        for sweep in 0..MOST_SWEEPS {
            if !self.sweep(sweep % 2 == 1, AIM, turns, packed) {
                break;
            }
        }
    }
}

//! Projection: moves nodes until no distance limit is exceeded, and fits plates to their corners.
//!
//! One sweep visits every limit in turn and moves the two nodes towards each other where it is exceeded. Then every
//! plate takes the place and the attitude that fit its corners best.

use glam::{DMat3, DVec3};

use crate::CutWeb;
use crate::packing::StiffPlate;
use crate::packing::distance_limits::DistanceLimit;

/// Largest excess over a limit that is ascribed to rounding, relative to the limit.
const ROUNDING: f64 = 1e-12;

/// Relative amount by which [`Projection::draw_in`] makes a distance shorter than its limit. Without it, the excess
/// over the limits shrinks from sweep to sweep but never vanishes.
const AIM: f64 = 1e-3;

/// Largest number of sweeps of [`Projection::draw_in`].
const MOST_SWEEPS: usize = 20_000;

/// The constraints of a projection.
pub(super) struct Projection<'a> {
    pub cut_web: &'a CutWeb,
    /// Largest distances between nodes.
    pub limits: &'a [DistanceLimit],
    /// Stiff canopies.
    pub plates: &'a [StiffPlate],
    /// Inverse mass of each node, 1/kg or in any other unit, (nodes,). A node moves in proportion to it; 0: not at all.
    pub inverse_mass: &'a [f64],
}

impl Projection<'_> {
    /// One sweep over all limits, in reverse order if `backwards`. A distance that exceeds its limit is set to the
    /// limit times (1 - `aim`). `turns` are the rotations of the plates, (plates,), `packed` the positions, m,
    /// (nodes,). Returns whether any limit was exceeded.
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

    /// Fits every plate to its corners. A hub with an inverse mass of 0 keeps its place.
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

    /// Sweeps until no limit is exceeded, or [`MOST_SWEEPS`] times; the audit reports ropes that are then still
    /// stretched.
    pub fn draw_in(&self, turns: &mut [DMat3], packed: &mut [DVec3]) {
        for sweep in 0..MOST_SWEEPS {
            if !self.sweep(sweep % 2 == 1, AIM, turns, packed) {
                break;
            }
        }
    }
}

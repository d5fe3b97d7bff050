//! Tension and drag of all segments, one by one: the form of the readable step.

use glam::DVec3;

use crate::forces::rope_tension::{Pull, dissipative_work};
use crate::lanes::{LANES, sum_lanes};
use crate::layout::Address;
use crate::rope_state::RopeState;
use crate::system::System;

/// Writes what every segment does to `pulls`, (segments,), each from its slot to the next, and lets `ropes` remember. `dt`
/// is the step, `elapsed` the time since the forces before, s.
pub(super) fn pull_all(
    system: &System,
    position: &[DVec3],
    velocity: &[DVec3],
    dt: f64,
    elapsed: f64,
    ropes: &mut RopeState,
    pulls: &mut [Pull],
) {
    for block in system.layout().blocks() {
        for pair in block.slots.windows(2) {
            if let Some(index) = pair[0].segment {
                let (law, [a, b]) = (system.law(&system.segments()[index]), [pair[0].node, pair[1].node]);
                let (span, rate) = (position[b] - position[a], velocity[b] - velocity[a]);
                let (axial, mut memory, decay) =
                    (ropes.axial(system, index), ropes.memory_of(index), law.decay(elapsed));
                pulls[index] = law.pull(span.into(), rate.into(), axial, &mut memory, dt, &decay);
                if let Some(kept) = ropes.memory.get_mut(index) {
                    *kept = memory;
                }
            }
        }
    }
}

/// The force of the segments before and after a slot on it, N.
pub(super) fn pull_at(system: &System, pulls: &[Pull], at: Address) -> DVec3 {
    let slots = &system.layout().blocks()[at.block].slots;
    let pull = |slot: usize| slots[slot].segment.map_or(DVec3::ZERO, |index| pulls[index].force.into());
    pull(at.slot) - at.slot.checked_sub(1).map_or(DVec3::ZERO, pull)
}

/// Work lost in each block as its segments go from one length and dissipative force to the next, J.
pub(super) fn lost_work(system: &System, before: &[Pull], after: &[Pull]) -> f64 {
    let mut sum = 0.0;
    for block in system.layout().blocks() {
        let mut lanes = [0.0; LANES];
        for (i, slot) in block.slots.iter().enumerate() {
            if let Some(index) = slot.segment {
                let Pull { length, dissipative, .. } = before[index];
                lanes[i % LANES] += dissipative_work(length, dissipative, &after[index]) + after[index].lost;
            }
        }
        sum += sum_lanes(lanes);
    }
    sum
}

/// Before there were any forces: nothing for each segment, (segments,); empty where there is no air.
pub(super) fn no_drag(system: &System) -> Vec<(DVec3, DVec3)> {
    let segments = if system.environment().air.is_some() { system.segments().len() } else { 0 };
    vec![(DVec3::ZERO, DVec3::ZERO); segments]
}

/// Writes half the drag of every segment, N, and its middle, m, to `drags`, (segments,), and returns the work done on
/// the air since those that were there, J. `broken` segments do not drag.
pub(super) fn drag_all(
    system: &System,
    time: f64,
    position: &[DVec3],
    velocity: &[DVec3],
    broken: &[bool],
    drags: &mut [(DVec3, DVec3)],
) -> f64 {
    let Some(air) = &system.environment().air else { return 0.0 };
    let (gust, viscosity, mut sum) = (air.wind.fluctuation.at(time), air.medium.viscosity(), 0.0);
    for block in system.layout().blocks() {
        let Some(rope) = air.ropes.get(block.group).copied().flatten() else { continue };
        let mut lanes = [0.0; LANES];
        for (i, pair) in block.slots.windows(2).enumerate() {
            let Some(index) = pair[0].segment else { continue };
            let [a, b] = [pair[0].node, pair[1].node];
            let (middle, mean) = (0.5 * (position[a] + position[b]), 0.5 * (velocity[a] + velocity[b]));
            let rest_length = if broken[index] { 0.0 } else { system.segments()[index].rest_length };
            let (relative, density) = (air.wind(middle.z, gust) - mean, air.medium.density(middle.z));
            let half = rope.half_force(position[b] - position[a], relative, rest_length, density, viscosity);
            let (last_half, last_middle) = std::mem::replace(&mut drags[index], (half, middle));
            lanes[i % LANES] -= (last_half + half).dot(middle - last_middle);
        }
        sum += sum_lanes(lanes);
    }
    sum
}

/// The drag that a slot has of the segments before and after it, N.
pub(super) fn drag_at(system: &System, drags: &[(DVec3, DVec3)], at: Address) -> DVec3 {
    let slots = &system.layout().blocks()[at.block].slots;
    let half = |slot: usize| slots[slot].segment.and_then(|index| drags.get(index)).map_or(DVec3::ZERO, |drag| drag.0);
    at.slot.checked_sub(1).map_or(DVec3::ZERO, half) + half(at.slot)
}

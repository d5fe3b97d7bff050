//! Tension of a segment of rope: a spring and a damper in parallel that pull and never push.
//!
//! ```text
//! d  = L - L0                      stretch, m             L = |x_b - x_a|                        (11), (10)
//! d' = (x_b - x_a).(v_b - v_a)/L   rate of stretch, m/s                                          (12) times L0
//! T  = max(0, k d + c d')  where d > 0,  else 0           tension, N                             (9)
//! ```
//!
//! k = EA/L0 is the stiffness (N/m), c the damping (N s/m); see [`damping_from_time`] and [`damping_from_ratio`]. The
//! elastic energy is k d^2/2 where d > 0. What else the tension does is lost, and counted as work of the remaining
//! force, T - k d.
//!
//! Source: the founding paper's equations (9)-(12), the "concentrated mass damping spring model". The lower bound of
//! zero, which (9) leaves out, keeps a rope from pushing while it shortens fast. Valid for strains small enough that
//! k does not change, and for ropes that bend freely. T jumps by c d' where a rope tautens.
//!
//! **In steps of dt.** A step that crosses from slack to taut sees either no force or all of it, and the spring takes
//! k d (|d'| dt - d)/2 more or less than it stores: the energy that explicit methods win or lose at every such event.
//! Within |d'| dt of the crossing the spring therefore pulls with
//!
//! ```text
//! k d (1 + d / (|d'| dt)) / 2            0 < d < |d'| dt
//! ```
//!
//! which makes the work exact where d' is constant over two steps. It changes nothing as dt goes to 0, nor anywhere
//! else. Derivation and measurement: docs/theory/slack-taut.md.

use crate::layout::Address;
use crate::system::System;
use glam::DVec3;

/// What a segment does at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull {
    /// Tension, N.
    pub tension: f64,
    /// Force on the segment's first node, N; its second node gets the opposite.
    pub force: [f64; 3],
    /// Length, m.
    pub length: f64,
    /// The part of the tension that is not the spring's, N: damping, and what the lower bound of zero takes away.
    pub friction: f64,
}

/// Keeps 1/L finite where two nodes coincide; such a segment is slack and its direction is of no account.
const LEAST_LENGTH_SQUARED: f64 = 1e-200;

/// The law. `span` = x_b - x_a, m; `rate` = v_b - v_a, m/s; `dt` the step, s.
///
/// Written without branches on purpose: the fused step runs it on several segments at a time.
#[inline(always)]
pub fn pull(span: [f64; 3], rate: [f64; 3], rest_length: f64, stiffness: f64, damping: f64, dt: f64) -> Pull {
    let length_squared = span[0] * span[0] + span[1] * span[1] + span[2] * span[2];
    let bounded = if length_squared > LEAST_LENGTH_SQUARED { length_squared } else { LEAST_LENGTH_SQUARED };
    let length = bounded.sqrt();
    let per_length = 1.0 / length;
    let stretch = length - rest_length;
    let stretch_rate = (span[0] * rate[0] + span[1] * rate[1] + span[2] * rate[2]) * per_length;

    // next to a slack-taut crossing the spring gives its mean over the step
    let swept = stretch_rate.abs() * dt;
    let mean = 0.5 * (stretch + stretch * (stretch / swept));
    let sprung = if stretch < swept { mean } else { stretch };
    let elastic = if stretch > 0.0 { stiffness * sprung } else { 0.0 };
    let total = elastic + damping * stretch_rate;
    let pulls = if total > 0.0 { total } else { 0.0 };
    let tension = if stretch > 0.0 { pulls } else { 0.0 };

    let along = tension * per_length;
    Pull { tension, force: [span[0] * along, span[1] * along, span[2] * along], length, friction: tension - elastic }
}

/// Elastic energy of a segment with ends at `a` and `b`, J.
pub fn elastic_energy(a: DVec3, b: DVec3, rest_length: f64, stiffness: f64) -> f64 {
    let stretch = (b - a).length() - rest_length;
    if stretch > 0.0 { 0.5 * stiffness * stretch * stretch } else { 0.0 }
}

/// c = EA t / L0: internal friction of a material with damping time `time`, s. With it the damping of a rope does not
/// depend on how it is cut.
pub fn damping_from_time(axial_stiffness: f64, time: f64, rest_length: f64) -> f64 {
    axial_stiffness * time / rest_length
}

/// c = 2 ratio sqrt(k m), with k the segment's stiffness and m its mass: a fraction of a single segment's critical
/// damping, for numerical purposes.
pub fn damping_from_ratio(ratio: f64, stiffness: f64, mass: f64) -> f64 {
    2.0 * ratio * (stiffness * mass).sqrt()
}

/// Writes what every segment does to `pulls`, (segments,), each from its slot to the next. `dt` is the step, s.
pub fn pull_all(system: &System, position: &[DVec3], velocity: &[DVec3], dt: f64, pulls: &mut [Pull]) {
    for block in system.layout().blocks() {
        for pair in block.slots.windows(2) {
            if let Some(index) = pair[0].segment {
                let (s, [a, b]) = (system.segments()[index], [pair[0].node, pair[1].node]);
                let (span, rate) = (position[b] - position[a], velocity[b] - velocity[a]);
                pulls[index] = pull(span.into(), rate.into(), s.rest_length, s.stiffness, s.damping, dt);
            }
        }
    }
}

/// Adds the pull of every segment to `force`, N, (nodes,).
///
/// Forces on a node are summed over its slots in the layout's order; see [`crate::layout`].
pub fn add_force(system: &System, pulls: &[Pull], force: &mut [DVec3]) {
    for block in system.layout().blocks() {
        let mut left = DVec3::ZERO;
        for slot in &block.slots {
            let right = slot.segment.map_or(DVec3::ZERO, |index| pulls[index].force.into());
            force[slot.node] += right - left;
            left = right;
        }
    }
}

/// The force of the segments before and after a slot on it, N.
pub fn force_at(system: &System, pulls: &[Pull], at: Address) -> DVec3 {
    let slots = &system.layout().blocks()[at.block].slots;
    let pull = |slot: usize| slots[slot].segment.map_or(DVec3::ZERO, |index| pulls[index].force.into());
    pull(at.slot) - at.slot.checked_sub(1).map_or(DVec3::ZERO, pull)
}

/// Work lost in each block as its segments go from one length and friction to the next, J. Trapezoidal rule over the
/// way itself.
pub fn lost_work(system: &System, before: &[Pull], after: &[Pull]) -> f64 {
    let mut sum = 0.0;
    for block in system.layout().blocks() {
        let mut lanes = [0.0; LANES];
        for (i, slot) in block.slots.iter().enumerate() {
            if let Some(index) = slot.segment {
                lanes[i % LANES] += friction_work(before[index].length, before[index].friction, &after[index]);
            }
        }
        sum += sum_lanes(lanes);
    }
    sum
}

/// Work of friction between an earlier length and friction, and those of `now`, J.
#[inline(always)]
pub(crate) fn friction_work(length: f64, friction: f64, now: &Pull) -> f64 {
    0.5 * (friction + now.friction) * (now.length - length)
}

/// Sums over segments run in so many interleaved parts, whatever the width of the machine's vectors.
pub(crate) const LANES: usize = 8;

/// The parts of a sum in a fixed order.
#[inline(always)]
pub(crate) fn sum_lanes(lanes: [f64; LANES]) -> f64 {
    ((lanes[0] + lanes[4]) + (lanes[2] + lanes[6])) + ((lanes[1] + lanes[5]) + (lanes[3] + lanes[7]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A segment along y of length `l`, whose far end moves away at `rate`.
    fn along_y(l: f64, rate: f64, rest_length: f64, stiffness: f64, damping: f64, dt: f64) -> Pull {
        pull([0.0, l, 0.0], [7.0, rate, 1.0], rest_length, stiffness, damping, dt)
    }

    #[test]
    fn a_taut_segment_pulls_with_spring_and_damper() {
        // 2.5 m long, 0.1 m stretched, stretching at 3 m/s: T = 100 * 0.1 + 2 * 3 = 16 N, of which 6 N are friction
        let p = along_y(2.5, 3.0, 2.4, 100.0, 2.0, 1e-3);
        assert!((p.tension - 16.0).abs() < 1e-12 && (p.friction - 6.0).abs() < 1e-12);
        assert!((p.force[1] - 16.0).abs() < 1e-12 && p.force[0] == 0.0);
    }

    #[test]
    fn it_never_pushes() {
        let slack = along_y(1.0, 50.0, 1.001, 1e6, 1e3, 1e-6);
        assert_eq!((slack.tension, slack.friction), (0.0, 0.0));
        // taut but shortening fast: no force, and the spring's 1000 N are friction
        let closing = along_y(1.0, -50.0, 0.999, 1e6, 1e3, 1e-6);
        assert_eq!(closing.tension, 0.0);
        assert!((closing.friction + 1000.0).abs() < 1e-6);
    }

    #[test]
    fn coinciding_nodes_are_slack_and_finite() {
        assert_eq!(pull([0.0; 3], [1.0, 2.0, 3.0], 0.1, 1e6, 1e3, 1e-6).force, [0.0; 3]);
    }

    #[test]
    fn work_is_exact_across_a_crossing_at_constant_rate() {
        // from 0.37 mm slack to taut in steps of 1 mm: the trapezoidal work of the tension is the energy stored
        let (k, dt, rate) = (1e4, 1e-3, 1.0);
        let tension = |stretch: f64| along_y(1.0 + stretch, rate, 1.0, k, 0.0, dt).tension;
        let (mut work, mut stretch) = (0.0, -0.00037);
        for _ in 0..6 {
            work += 0.5 * (tension(stretch) + tension(stretch + rate * dt)) * rate * dt;
            stretch += rate * dt;
        }
        let stored = elastic_energy(DVec3::ZERO, DVec3::Y * (1.0 + stretch), 1.0, k);
        assert!((work / stored - 1.0).abs() < 1e-9, "{work} J of work, {stored} J stored");
    }
}

//! The largest step that is stable.
//!
//! For an oscillator of frequency omega and damping ratio xi the scheme of [`crate::time`] obeys
//!
//! ```text
//! x_(n+1) - 2 x_n + x_(n-1) = -W^2 x_n - 2 xi W (3 x_n - 4 x_(n-1) + x_(n-2))/2,      W = omega dt
//! ```
//!
//! whose root leaves the unit circle at z = -1, where W^2 + 8 xi W = 4. For a net this reads: dt^2 K + 4 dt C - 4 M
//! must be negative definite. By Gershgorin's theorem, node by node, with sums over the segments that meet there
//! (each counts twice, once for itself and once for the coupling):
//!
//! ```text
//! 2 dt^2 sum(k) + 8 dt sum(c) <= 4 m,    dt = m / (C + sqrt(C^2 + K m/2)),    K = sum(k), C = sum(c)
//! ```
//!
//! It holds for any shape of the net, as all its segments may come to lie along one line. Inside a rope it is exact:
//! dt = segment length / wave speed. See docs/theory/step-size.md for the derivation.

use crate::system::System;

/// A bound on the step and what sets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimit {
    /// Largest stable step, s; infinite where nothing is stiff.
    pub dt: f64,
    /// The node that sets it.
    pub node: usize,
    /// The stiffest segment that meets there.
    pub segment: Option<usize>,
    /// The limit that this node would set without damping, s.
    pub without_damping: f64,
    /// The limit that all nodes set where no segment of that one's class meets, s.
    pub elsewhere: f64,
}

/// The stability limit of `system`.
pub fn step_limit(system: &System) -> StepLimit {
    let nodes = system.mass().len();
    let mut stiffness = vec![0.0; nodes];
    let mut damping = vec![0.0; nodes];
    let mut stiffest: Vec<Option<usize>> = vec![None; nodes];
    for (i, s) in system.segments().iter().enumerate() {
        for node in s.ends {
            stiffness[node] += s.stiffness;
            damping[node] += s.damping;
            if stiffest[node].is_none_or(|other| s.stiffness > system.segments()[other].stiffness) {
                stiffest[node] = Some(i);
            }
        }
    }
    // what pulls at a body's ties, at once a push and a turn: a tie at r from the centre moves by at most
    // sqrt(1 + r^2/g^2) times what the body does, with its least radius of gyration g as the measure of turning
    for body in system.bodies() {
        let gyration_squared = body.inertia.min_element() / system.mass()[body.centre].max(f64::MIN_POSITIVE);
        for tie in &body.ties {
            let lever = 1.0 + tie.arm.length_squared() / gyration_squared;
            let pulled = stiffest[tie.node];
            stiffness[body.centre] += lever * std::mem::take(&mut stiffness[tie.node]);
            damping[body.centre] += lever * std::mem::take(&mut damping[tie.node]);
            stiffest[body.centre] = stiffest[body.centre].or(pulled);
        }
    }
    let bound = |node: usize, c: f64| {
        let (mass, k) = (system.mass()[node], stiffness[node]);
        mass / (c + (c * c + 0.5 * k * mass).sqrt())
    };
    let free: Vec<usize> = (0..nodes).filter(|&n| !system.held()[n] && stiffness[n] > 0.0).collect();
    let smallest = |one: (usize, f64), other: (usize, f64)| if other.1 < one.1 { other } else { one };
    let least = free.iter().map(|&node| (node, bound(node, damping[node]))).reduce(smallest);
    let Some((node, dt)) = least else {
        let (dt, without_damping, elsewhere) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        return StepLimit { dt, node: 0, segment: None, without_damping, elsewhere };
    };
    let segment = stiffest[node];
    let class = segment.map(|s| system.segments()[s].class);
    let mut touched = vec![false; nodes];
    for s in system.segments().iter().filter(|s| Some(s.class) == class) {
        s.ends.iter().for_each(|&end| touched[end] = true);
    }
    let others = free.iter().filter(|&&node| !touched[node]).map(|&node| bound(node, damping[node]));
    StepLimit { dt, node, segment, without_damping: bound(node, 0.0), elsewhere: others.fold(f64::INFINITY, f64::min) }
}

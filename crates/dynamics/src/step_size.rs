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
//! k is the largest stiffness that the segment's law can show ([`Law::largest_stiffness`](crate::forces::law::Law)).
//! Drag at the fastest wind that is expected, of slope c, is a damper between a node and the world: it counts once.
//! It holds for any shape of the net, as all its segments may come to lie along one line. Inside a rope it is exact:
//! dt = segment length / wave speed. See docs/theory/step-size.md for the derivation.

pub use crate::effects::Stiff;
use crate::effects::{self, Bound};
use crate::system::System;

/// A bound on the step and what sets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimit {
    /// Largest stable step, s; infinite where nothing is stiff.
    pub dt: f64,
    /// The node that sets it.
    pub node: usize,
    /// The stiffest segment or effect at that node.
    pub stiffest: Option<Stiff>,
    /// The limit that this node would set without damping, s.
    pub without_damping: f64,
    /// The limit set by the nodes where no segment of the same group, or no part of the same effect, acts, s.
    pub elsewhere: f64,
}

/// Stiffness and damping at each node of a system, summed over segments and effects.
fn bound_of(system: &System) -> Bound {
    let mut bound = Bound::new(system.mass().len());
    for (i, s) in system.segments().iter().enumerate() {
        let stiffness = system.law(s).largest_stiffness(&s.into());
        for node in s.ends {
            bound.add(node, stiffness, s.damping, Stiff::Segment(i));
        }
    }
    effects::bound(system.parts(), &mut bound);
    bound
}

/// The mass of each node, kg, (nodes,), at which it would set a limit of `dt` seconds; zero where nothing is stiff.
pub fn limiting_mass(system: &System, dt: f64) -> Vec<f64> {
    let Bound { stiffness, damping, .. } = bound_of(system);
    stiffness.iter().zip(damping).map(|(k, c)| 0.5 * dt * dt * k + 2.0 * dt * c).collect()
}

/// The stability limit of `system`.
pub fn step_limit(system: &System) -> StepLimit {
    let nodes = system.mass().len();
    let at = bound_of(system);
    let mut mass: Vec<f64> =
        system.mass().iter().zip(system.held()).map(|(m, held)| if *held { 0.0 } else { *m }).collect();
    for body in system.bodies().iter().filter(|body| system.held()[body.centre]) {
        mass[body.centre] = effects::turning_mass(system.parts(), body);
    }
    let bound = |node: usize, c: f64| {
        let (mass, k) = (mass[node], at.stiffness[node]);
        mass / (c + (c * c + 0.5 * k * mass).sqrt())
    };
    let is_free = |node: &usize| mass[*node] > 0.0 && at.stiffness[*node] + at.damping[*node] > 0.0;
    let free: Vec<usize> = (0..nodes).filter(is_free).collect();
    let smaller = |best: (usize, f64), next: (usize, f64)| if next.1 < best.1 { next } else { best };
    let least = free.iter().map(|&node| (node, bound(node, at.damping[node]))).reduce(smaller);
    let Some((node, dt)) = least else {
        let (dt, without_damping, elsewhere) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        return StepLimit { dt, node: 0, stiffest: None, without_damping, elsewhere };
    };
    let stiffest = at.stiffest(node, mass[node]);
    let touched = touched(system, &at, stiffest);
    let others = free.iter().filter(|&&node| !touched[node]).map(|&node| bound(node, at.damping[node]));
    let elsewhere = others.fold(f64::INFINITY, f64::min);
    StepLimit { dt, node, stiffest, without_damping: bound(node, 0.0), elsewhere }
}

/// Whether each node touches a segment of the same group, or the same effect, as `what`; (nodes,).
fn touched(system: &System, at: &Bound, what: Option<Stiff>) -> Vec<bool> {
    let mut touched = vec![false; system.mass().len()];
    match what {
        Some(Stiff::Segment(segment)) => {
            let group = system.segments()[segment].group;
            for node in system.segments().iter().filter(|s| s.group == group).flat_map(|s| s.ends) {
                touched[node] = true;
            }
        }
        Some(Stiff::Effect { name, .. }) => match at.share_of(name) {
            Some(share) => {
                for (touched, share) in touched.iter_mut().zip(share) {
                    *touched = *share > 0.0;
                }
            }
            None => effects::nodes(system.parts(), Some(name), &mut |node| touched[node] = true),
        },
        None => {}
    }
    touched
}

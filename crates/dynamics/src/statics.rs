//! Equilibrium under weight, loads and pretension, by dynamic relaxation with kinetic damping.
//!
//! A net of fictitious masses is released at its start and runs in time. Whenever its kinetic energy has passed a maximum
//! all velocities are set to zero, and it is released again from where it was then: a single oscillator is then at rest,
//! for its energy is largest where its force vanishes. A little friction in segments, c = b k, takes the fast motions
//! of single nodes away, whose maxima would stop the slow ones again and again. Masses are such that the stable step is
//! the same at every node, and the stiffest and the softest part of a net take equally long:
//!
//! ```text
//! m = K (dt/f)^2 / 2 + 2 C dt/f        K, C: sums of k and c over what meets at a node; f: the share of the stable step
//! ```
//!
//! A body turns with the moment of inertia m r^2, r being its longest arm. Weight acts as loads. Forces out of balance
//! are measured with all velocities zero: on a node, the force; on a body, the force on its centre and the torque over
//! its longest arm.
//!
//! The step is that of [`crate::time`], hence every force that it knows, and the same bits on any number of threads.
//! Every effect says what of it a relaxation sees: the ground bears and does not rub; an orbit is left out; wind blows as
//! it does at the start, and the drag of the fictitious motion goes with it.
//! Ropes have the tensions that last ([`Law::lasting`]), and do not break.
//!
//! Sources: Cundall, Explicit finite-difference methods in geomechanics, 1976 (kinetic damping); Barnes, Int. J. Space
//! Struct. 14, 1999, 89-104. Derivation and measurements: docs/theory/statics.md.

use glam::DVec3;

use crate::body::Body;
use crate::effects::{self, Resting};
use crate::forces::breaking::Breaking;
use crate::forces::element::Element;
use crate::forces::law::Law;
use crate::forces::load::Load;
use crate::forces::segment::Segment;
use crate::parts::{Environment, SystemParts};
use crate::state::State;
use crate::step_size::limiting_mass;
use crate::system::System;
use crate::time::step::Stepper;

/// When an equilibrium has been found, and when it is given up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// Largest [`Residual::relative`].
    pub tolerance: f64,
    /// Steps of the fictitious net at most.
    pub max_iterations: u64,
}

/// Force that is out of balance.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Residual {
    /// The largest force out of balance on a node that is free to move, N.
    pub force: f64,
    /// The node on which it acts.
    pub node: usize,
    /// The largest tension, force of a bend or load in the net, N.
    pub largest: f64,
}

impl Residual {
    /// The force over that largest one.
    pub fn relative(&self) -> f64 {
        if self.force == 0.0 { 0.0 } else { self.force / self.largest }
    }
}

/// Result of a relaxation.
#[derive(Debug, Clone, PartialEq)]
pub struct Relaxed {
    /// Positions and orientations; nothing moves.
    pub state: State,
    /// Force that is still out of balance.
    pub residual: Residual,
    /// Steps that it took.
    pub iterations: u64,
    /// Why this is no equilibrium, if it is none.
    pub stopped: Option<StaticsError>,
}

/// How far a relaxation is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relaxing {
    /// Steps so far.
    pub iterations: u64,
    /// Force out of balance when velocities were last set to zero.
    pub residual: Residual,
}

/// A part of the net that bears a load and that neither what is held nor the ground holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unsupported {
    /// A node of it.
    pub node: usize,
    /// The sum of its loads and its weight, N.
    pub load: f64,
}

/// Why no equilibrium was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum StaticsError {
    /// Forces were not in balance after as many steps as were allowed.
    #[error("no equilibrium after {iterations} iterations")]
    NotConverged {
        /// Steps taken.
        iterations: u64,
    },
    /// A force is no longer a finite number.
    #[error("the relaxation diverged: a force is not finite after {iterations} iterations")]
    NotFinite {
        /// Steps taken.
        iterations: u64,
    },
    /// The caller asked for it when it was told of the progress.
    #[error("interrupted after {iterations} iterations")]
    Interrupted {
        /// Steps taken.
        iterations: u64,
    },
}

/// The step, s. Which one does not matter, as masses go with it.
const STEP: f64 = 1.0;

/// The share f of the stable step that is taken.
const STEP_SHARE: f64 = 0.95;

/// Friction b of segments, s, in steps of 1 s. Measured: with slack ropes about a net settles ten times slower without
/// any, or not at all; from 0.02 to 0.1 it makes little difference (docs/theory/statics.md).
const FRICTION: f64 = 0.05;

/// With any at all the step adds up the kinetic energy; this much takes nothing from it.
const LEAST_DAMPING: f64 = 1e-12;

/// Steps between two words of progress.
const STEPS_PER_WORD: u64 = 1000;

/// Looks for the equilibrium of `system` that is reached from `state`, on at most `threads` threads; what comes out is
/// the same for any number. Driven nodes stay where their paths begin, and what moves in `state` or has a launcher is held
/// until then.
/// `progress` says whether to go on.
///
/// A part of the net that is [`unsupported`] falls for ever, and is given up after `max_iterations`.
pub fn relax(
    system: &System,
    state: &State,
    accuracy: &Accuracy,
    threads: usize,
    progress: &mut (dyn FnMut(Relaxing) -> bool + Send),
) -> Relaxed {
    let resting = resting(system, state);
    let fictitious_net = fictitious(system, &resting);
    let (mut state, mut turned) = (at_rest(system, state), Vec::new());
    // the fictitious net has only the bodies that may turn
    std::mem::swap(&mut state.rotation, &mut turned);
    state.rotation = resting.turning.iter().map(|&body| turned[body]).collect();
    let mut net = Stepper::new(&fictitious_net, &state, STEP, threads);
    let with_rotations = |mut state: State| {
        for (&body, rotation) in resting.turning.iter().zip(&state.rotation) {
            turned[body] = *rotation;
        }
        state.rotation = turned;
        state
    };
    net.team().lead(|| {
        let mut iterations = 0;
        loop {
            // forces out of balance, with all velocities zero
            let residual = residual(&net);
            let stopped = if !residual.force.is_finite() {
                Some(StaticsError::NotFinite { iterations })
            } else if residual.relative() > accuracy.tolerance && iterations >= accuracy.max_iterations {
                Some(StaticsError::NotConverged { iterations })
            } else {
                None
            };
            if stopped.is_some() || residual.relative() <= accuracy.tolerance {
                return Relaxed { state: with_rotations(state), residual, iterations, stopped };
            }
            // step until kinetic energy has passed a maximum
            let mut energy = 0.0;
            while iterations < accuracy.max_iterations {
                if iterations.is_multiple_of(STEPS_PER_WORD) && !progress(Relaxing { iterations, residual }) {
                    let stopped = Some(StaticsError::Interrupted { iterations });
                    return Relaxed { state: with_rotations(state), residual, iterations, stopped };
                }
                let last = std::mem::replace(&mut energy, net.step().mass_power);
                iterations += 1;
                if energy < last || !energy.is_finite() {
                    break;
                }
            }
            // start again at rest from where the maximum was
            net.midway(&mut state);
            stop(&mut state);
            net.restart(&state);
        }
    })
}

/// Nodes and bodies that stay fixed in a relaxation of a system from a state.
fn resting(system: &System, state: &State) -> Resting {
    let mut thrown: Vec<bool> = state.velocity.iter().map(|velocity| *velocity != DVec3::ZERO).collect();
    for launcher in system.launchers() {
        thrown[launcher.node] = true;
    }
    let mut held: Vec<bool> = system.held().iter().zip(&thrown).map(|(held, thrown)| *held || *thrown).collect();
    let bodies = system.bodies();
    for tie in bodies.iter().filter(|body| thrown[body.centre]).flat_map(|body| &body.ties) {
        held[tie.node] = true;
    }
    Resting {
        held,
        turning: (0..bodies.len()).filter(|&body| !thrown[bodies[body].centre]).collect(),
        turned: state.rotation.iter().map(|rotation| rotation.orientation).collect(),
        damping_time: FRICTION,
    }
}

/// Weights of all that is free to move, as loads.
fn weights(system: &System, resting: &Resting) -> impl Iterator<Item = Load> {
    let gravity = system.environment().gravity;
    let weights = system.mass().iter().enumerate();
    let weights = weights.map(move |(node, &mass)| Load { node, force: mass * gravity, ramp: 0.0 });
    weights.filter(|load| !resting.held[load.node])
}

/// Effects of a system that act in a relaxation, and its weight as loads. Loads that are zero are left out.
fn effects_at_rest(system: &System, resting: &Resting) -> SystemParts {
    let mut rest = SystemParts::default();
    effects::at_rest(system.parts(), resting, &mut rest);
    rest.loads.extend(weights(system, resting));
    rest.loads.retain(|load| load.force != DVec3::ZERO);
    rest
}

/// The same net with fictitious masses, and nothing that moves by itself.
fn fictitious(system: &System, resting: &Resting) -> System {
    let slow_body = |body: &Body| Body { inertia: DVec3::splat(arm_squared(body)), ..body.clone() };
    let bodies: Vec<Body> = resting.turning.iter().map(|&body| slow_body(&system.bodies()[body])).collect();
    // unit masses first, to find the mass that each node needs
    let mut unit_mass = vec![1.0; system.mass().len()];
    for tie in bodies.iter().flat_map(|body| &body.ties) {
        unit_mass[tie.node] = 0.0;
    }
    let rest = effects_at_rest(system, resting);
    let mut parts = SystemParts {
        mass: unit_mass,
        held: resting.held.clone(),
        tractor: system.tractor().to_vec(),
        segments: system.segments().iter().map(|s| damped_segment(system, s)).collect(),
        laws: system.laws().iter().map(Law::lasting).collect(),
        bodies,
        environment: Environment { mass_damping: LEAST_DAMPING, ..rest.environment.clone() },
        ..rest
    };
    let limiting = limiting_mass(&parts.clone().build().expect("what is left of a system is one"), STEP / STEP_SHARE);
    // masses for which every node allows the same step
    for (mass, limiting) in parts.mass.iter_mut().zip(limiting).filter(|(mass, limiting)| **mass * limiting > 0.0) {
        *mass = limiting;
    }
    for body in &mut parts.bodies {
        body.inertia *= parts.mass[body.centre];
    }
    parts.build().expect("masses and inertias are positive")
}

/// A segment with friction that never breaks.
fn damped_segment(system: &System, segment: &Segment) -> Segment {
    let stiffness = system.law(segment).lasting().largest_stiffness(&segment.into());
    Segment { damping: FRICTION * stiffness, breaking: Breaking::NEVER, ..*segment }
}

/// The square of a body's longest arm, m^2; 1 where it is tied at its centre only, and nothing turns it.
fn arm_squared(body: &Body) -> f64 {
    let longest = body.ties.iter().map(|tie| tie.arm.length_squared()).fold(0.0, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// The first part of the net that bears a load and is held nowhere, if there is one; see [`relax`]. What the ground can
/// touch it bears, but for what pulls along it.
pub fn unsupported(system: &System, state: &State) -> Option<Unsupported> {
    let nodes = system.mass().len();
    let mut parts = ConnectedParts((0..nodes).collect());
    for s in system.segments() {
        parts.join(s.ends[0], s.ends[1]);
    }
    effects::joins(system.parts(), &mut |a, b| parts.join(a, b));
    let mut held = vec![false; nodes];
    let resting = resting(system, state);
    for node in (0..nodes).filter(|&node| resting.held[node]) {
        held[parts.root(node)] = true;
    }
    let loads = effects_at_rest(system, &resting).loads;
    let mut sums = vec![DVec3::ZERO; nodes];
    for load in &loads {
        sums[parts.root(load.node)] += load.force;
    }
    // a support from below takes all downward load
    effects::bears(system.parts(), &mut |node| {
        let sum = &mut sums[parts.root(node)];
        sum.z = sum.z.max(0.0);
    });
    // loads in balance among themselves sum to zero within rounding
    let rounding = 1e-12 * loads.iter().map(|load| load.force.length()).sum::<f64>();
    let loaded = sums.iter().map(|sum| sum.length()).enumerate();
    let mut falling = loaded.filter(|&(node, load)| !held[node] && load > rounding);
    falling.next().map(|(node, load)| Unsupported { node, load })
}

/// Connected parts of a net, each represented by one of its nodes (union-find).
struct ConnectedParts(Vec<usize>);

impl ConnectedParts {
    /// The node that stands for the part to which `node` belongs.
    fn root(&mut self, mut node: usize) -> usize {
        while self.0[node] != node {
            self.0[node] = self.0[self.0[node]];
            node = self.0[node];
        }
        node
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}

/// The start of a relaxation: what is driven is where its path begins, ties are where their bodies are, and nothing
/// moves.
fn at_rest(system: &System, state: &State) -> State {
    let mut state = state.clone();
    for drive in system.drives() {
        state.position[drive.node] = drive.at(0.0);
    }
    for (body, rotation) in system.bodies().iter().zip(&state.rotation) {
        for tie in &body.ties {
            state.position[tie.node] = state.position[body.centre] + rotation.orientation * tie.arm;
        }
    }
    stop(&mut state);
    state
}

/// Sets all velocities to zero.
fn stop(state: &mut State) {
    state.velocity.fill(DVec3::ZERO);
    for rotation in &mut state.rotation {
        rotation.angular_momentum = DVec3::ZERO;
    }
}

/// Force out of balance at the last forces of a net at rest.
fn residual(net: &Stepper) -> Residual {
    let system = net.system();
    let on_nodes = (0..system.mass().len()).map(|node| (node, net.force(node).length()));
    let torques = net.torques().iter().zip(system.bodies());
    let on_bodies = torques.map(|(torque, body)| (body.centre, torque.length() / arm_squared(body).sqrt()));
    let loads = system.loads().iter().map(|load| load.force.length());
    let tensions = (0..system.segments().len()).map(|segment| net.tension(segment).abs());
    // a stiff rope bears loads by bending where it bears next to no tension
    let at_rest = |node: usize| net.position(node);
    let bends = system.parts().bends.iter().flat_map(|b| b.pull(b.nodes().map(at_rest), [DVec3::ZERO; 3]).elastic);
    let clamps = system.parts().clamps.iter().flat_map(|c| c.pull(c.nodes().map(at_rest), [DVec3::ZERO; 2]).elastic);
    let bent = bends.chain(clamps).map(DVec3::length);
    let largest = loads.chain(tensions).chain(bent).fold(0.0, f64::max);
    let mut residual = Residual { force: 0.0, node: 0, largest };
    for (node, force) in on_nodes.chain(on_bodies) {
        // a force that is not a number stays
        if force > residual.force || force.is_nan() {
            (residual.force, residual.node) = (force, node);
        }
    }
    residual
}

#[cfg(test)]
mod tests;

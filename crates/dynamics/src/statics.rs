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
mod tests {
    use super::*;
    use crate::body::Rotation;
    use crate::body::Tie;
    use crate::drive::Drive;
    use crate::launcher::{Launcher, Means};
    use glam::DQuat;

    const TIGHT: Accuracy = Accuracy { tolerance: 1e-10, max_iterations: 1_000_000 };

    fn rope(ends: [usize; 2], rest_length: f64, stiffness: f64) -> Segment {
        Segment { ends, rest_length, stiffness, damping: 0.3, group: 0, breaking: Breaking::NEVER }
    }

    fn load(node: usize, force: DVec3) -> Load {
        Load { node, force, ramp: 0.0 }
    }

    /// Nodes at `position` of which those with mass 0 are held, and ropes between them, under a gravity of 10 m/s^2.
    fn net(mass: &[f64], position: &[DVec3], segments: Vec<Segment>) -> (SystemParts, State) {
        let parts = SystemParts {
            mass: mass.to_vec(),
            held: mass.iter().map(|&mass| mass == 0.0).collect(),
            tractor: vec![false; mass.len()],
            segments,
            laws: vec![Law::Linear],
            environment: Environment {
                gravity: DVec3::new(0.0, 0.0, -10.0),
                mass_damping: 0.5,
                ..Environment::default()
            },
            ..SystemParts::default()
        };
        let velocity = vec![DVec3::ZERO; mass.len()];
        (parts, State { position: position.to_vec(), velocity, ..State::default() })
    }

    fn rest(parts: SystemParts, state: &State) -> Relaxed {
        relax(&parts.build().unwrap(), state, &TIGHT, 1, &mut |_| true)
    }

    #[test]
    fn a_weight_on_a_rope_stretches_it_by_what_it_weighs() {
        // slack and beside its place at first: it comes to hang below, 3 kg * 10 m/s^2 / (600 N/m) lower than unloaded
        let (parts, state) = net(&[0.0, 3.0], &[DVec3::ZERO, 0.7 * DVec3::X], vec![rope([0, 1], 1.0, 600.0)]);
        let found = rest(parts, &state);
        assert_eq!(found.stopped, None);
        assert!((found.state.position[1] - DVec3::new(0.0, 0.0, -1.05)).length() < 1e-6, "{:?}", found.state.position);
        assert!((found.residual.largest - 30.0).abs() < 1e-8 && found.state.velocity == [DVec3::ZERO; 2]);
    }

    #[test]
    fn loads_in_balance_need_no_support() {
        let (mut parts, state) = net(&[1.0, 1.0], &[DVec3::ZERO, DVec3::X], vec![rope([0, 1], 1.0, 200.0)]);
        parts.environment.gravity = DVec3::ZERO;
        parts.loads = vec![load(0, -8.0 * DVec3::X), load(1, 8.0 * DVec3::X)];
        assert_eq!(unsupported(&parts.clone().build().unwrap(), &state), None);
        let found = rest(parts, &state);
        assert!((found.state.position[1] - found.state.position[0] - 1.04 * DVec3::X).length() < 1e-9);
    }

    #[test]
    fn what_nothing_holds_is_found_with_what_it_bears() {
        let ropes = vec![rope([0, 1], 1.0, 600.0), rope([2, 3], 1.0, 600.0)];
        let (mut parts, state) = net(&[0.0, 1.0, 2.0, 2.0], &[DVec3::ZERO; 4], ropes);
        parts.loads = vec![load(3, 10.0 * DVec3::Z)];
        let system = parts.build().unwrap();
        assert_eq!(unsupported(&system, &state), Some(Unsupported { node: 2, load: 30.0 }));
        let few = Accuracy { max_iterations: 3000, ..TIGHT };
        let found = relax(&system, &state, &few, 1, &mut |_| true);
        assert_eq!(found.stopped, Some(StaticsError::NotConverged { iterations: 3000 }));
        assert!(found.residual.force > 9.9 && found.residual.relative() > 0.3);
        let stopped = relax(&system, &state, &few, 1, &mut |so_far| so_far.iterations < 2000).stopped;
        assert_eq!(stopped, Some(StaticsError::Interrupted { iterations: 2000 }));
    }

    #[test]
    fn a_body_hangs_with_its_centre_below_the_point_that_it_hangs_by() {
        // tied off its centre by one rope, and started upside down but for a little
        let (mut parts, mut state) =
            net(&[0.0, 2.0, 0.0], &[DVec3::ZERO, DVec3::Z, DVec3::Z], vec![rope([0, 2], 1.0, 4000.0)]);
        parts.held[2] = false;
        let arm = DVec3::new(0.3, 0.0, 0.4);
        parts.bodies = vec![Body { centre: 1, inertia: DVec3::new(1.0, 2.0, 3.0), ties: vec![Tie { node: 2, arm }] }];
        state.rotation =
            vec![Rotation { orientation: DQuat::from_xyzw(0.6, 0.0, 0.0, 0.8), angular_momentum: DVec3::X }];
        let found = rest(parts, &state);
        assert_eq!(found.stopped, None);
        let [_, centre, tie] = found.state.position[..] else { unreachable!() };
        assert!((tie - DVec3::new(0.0, 0.0, -1.005)).length() < 1e-6, "{tie}");
        assert!((centre - DVec3::new(0.0, 0.0, -1.505)).length() < 1e-6, "{centre}");
    }

    #[test]
    fn what_is_thrown_later_is_held_until_then() {
        let ropes = vec![rope([0, 1], 1.0, 600.0), rope([1, 2], 1.0, 600.0)];
        let (parts, mut state) = net(&[1.0, 3.0, 1.0], &[DVec3::ZERO, DVec3::X, DVec3::X], ropes);
        state.velocity[0] = 5.0 * DVec3::Z;
        let found = rest(parts, &state);
        assert_eq!((found.stopped, found.state.position[0]), (None, DVec3::ZERO));
        assert!((found.state.position[1].z + 1.0 + 40.0 / 600.0).abs() < 1e-6);
    }

    #[test]
    fn a_body_in_its_launcher_keeps_its_attitude() {
        // from a tie beside its middle hangs a weight: it would turn if it could
        let ropes = vec![rope([1, 2], 1.0, 600.0)];
        let (mut parts, mut state) = net(&[2.0, 0.0, 3.0], &[DVec3::Z, DVec3::ZERO, DVec3::ZERO], ropes);
        parts.held[1] = false;
        let tie = Tie { node: 1, arm: 0.5 * DVec3::X };
        parts.bodies = vec![Body { centre: 0, inertia: DVec3::ONE, ties: vec![tie] }];
        parts.launchers = vec![Launcher { node: 0, at: 1.0, by: Means::Velocity(DVec3::X) }];
        let attitude = Rotation { orientation: DQuat::IDENTITY, angular_momentum: DVec3::ZERO };
        state.rotation = vec![attitude];
        let found = rest(parts, &state);
        assert_eq!((found.stopped, &found.state.rotation[..]), (None, &[attitude][..]));
        assert!((found.state.position[2] - DVec3::new(0.5, 0.0, -0.05)).length() < 1e-6);
    }

    #[test]
    fn driven_nodes_wait_where_their_paths_begin() {
        let (mut parts, state) = net(&[0.0, 3.0], &[DVec3::X, 0.7 * DVec3::X], vec![rope([0, 1], 1.0, 600.0)]);
        parts.drives = vec![Drive { node: 0, path: vec![(0.0, DVec3::Y), (1.0, DVec3::X)] }];
        let found = rest(parts, &state);
        assert!((found.state.position[1] - DVec3::new(0.0, 1.0, -1.05)).length() < 1e-6);
    }
}

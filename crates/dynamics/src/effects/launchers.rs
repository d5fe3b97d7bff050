//! Launchers in a run: which nodes are held, in their tube, or free, and the recoil on the launchers.
//!
//! A held node gets the force that balances all others on it. A node in its tube gets the force that balances what acts
//! across the tube, and the push along it. Both are forces like any other, so positions, velocities, the balance of
//! energy and the bodies' motion follow from the step itself; the work is summed along the way, trapezoidal rule.
//!
//! The end of a tube lies somewhere between two steps. The last push is scaled so that its share of the work, by the same
//! rule, is that of the way that was left: the muzzle speed is of second order, as the step is.
//!
//! A node that is released gets its half-step velocity as at the start of a run, so that its velocity is the given one at
//! the step at which it leaves; the work is the energy that it then has.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::bound::Bound;
use super::contract::{Effect, Forces, Net, Now};
use crate::channel::Channel;
use crate::forces::gravity;
use crate::launcher::{Launcher, Means, Push, Tube};
use crate::moving::{Moving, StepFactors};
use crate::parts::{PartKind, SystemError, SystemParts};

/// Launchers in motion.
#[derive(Debug, Clone)]
pub(super) struct Launchers {
    launching: Launching,
    /// Force of each launcher at the last forces.
    thrusts: Vec<Thrust>,
    /// The body whose centre each launcher has.
    bodies: Vec<Option<usize>>,
}

impl Launchers {
    /// State of the launch.
    pub fn launching(&self) -> &Launching {
        &self.launching
    }
}

impl Effect for Launchers {
    const NAME: &'static str = "launcher";
    const CHANNELS: &'static [Channel] = &[Channel::Launch];
    type Memory = Launching;

    fn of(parts: &SystemParts) -> Option<Self> {
        if parts.launchers.is_empty() {
            return None;
        }
        let body_at = |node: usize| parts.bodies.iter().position(|body| body.centre == node);
        Some(Launchers {
            launching: Launching::starting(&parts.launchers),
            thrusts: vec![Thrust::default(); parts.launchers.len()],
            bodies: parts.launchers.iter().map(|launcher| body_at(launcher.node)).collect(),
        })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        let nodes = parts.mass.len();
        let mut taken = vec![false; nodes];
        for tie in parts.bodies.iter().flat_map(|body| &body.ties) {
            taken[tie.node] = true;
        }
        for (index, launcher) in parts.launchers.iter().enumerate() {
            let node = launcher.node;
            if node >= nodes || parts.held[node] || std::mem::replace(&mut taken[node], true) {
                let why = "does not exist, is held, carried or launched twice";
                return Err(SystemError::attached(PartKind::Launcher, index, node, why));
            }
            if let Some(why) = launcher.fault() {
                return Err(SystemError::attached(PartKind::Launcher, index, node, why));
            }
        }
        Ok(())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for launcher in &parts.launchers {
            act_on(launcher.node);
        }
    }

    /// A spring between the launcher and its node.
    fn bound_carried(parts: &SystemParts, bound: &mut Bound) {
        for launcher in &parts.launchers {
            if let Means::Tube(Tube { push: Push::OverStroke(curve), .. }) = &launcher.by {
                bound.stiffness[launcher.node] += 0.5 * curve.steepest();
            }
        }
    }

    fn couple<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        let (parts, factors) = (now.parts, now.factors);
        let mut work = 0.0;
        let launchers = parts.launchers.iter().zip(&mut self.thrusts).zip(&self.bodies);
        for (((launcher, last), body), launched) in launchers.zip(&self.launching.nodes) {
            let (node, phase) = (launcher.node, launched.phase);
            if phase == Phase::Free && last.force == DVec3::ZERO {
                continue;
            }
            // the launcher answers all other forces on its node
            let mass = parts.mass[node];
            let weight = gravity::force(parts.environment.gravity, mass);
            let pulled = net.with_ropes(node, out.force[node]) + weight;
            let thrust = thrust(launcher, phase, net.node(node), mass, pulled, now.time, factors);
            // its work along the way, trapezoidal rule
            work -= 0.5 * (last.force + thrust.force).dot(thrust.place - last.place);
            out.force[node] += thrust.force;
            *last = thrust;
            // a released node starts at the given velocity; the energy that it gets is the launcher's work
            if let (Phase::Leaving, Means::Velocity(velocity)) = (phase, &launcher.by) {
                let before = |k| factors.before_start(velocity[k], pulled[k] / mass);
                out.released.push((node, DVec3::from_array(std::array::from_fn(before))));
                work -= 0.5 * mass * velocity.length_squared();
            }
            // a guided body keeps its attitude
            if let Some(body) = body.filter(|_| phase.is_guided()) {
                out.torque[body] = DVec3::ZERO;
            }
        }
        out.work[Channel::Launch] += work;
    }

    fn moved(&mut self, now: &Now, node: &dyn Fn(usize) -> Moving, out: &mut Forces) {
        self.launching.advance(&now.parts.launchers, &self.thrusts, now, |released, velocity| {
            out.carried.push((released, Moving { w: velocity, ..node(released) }));
        });
    }

    fn memory(&self) -> Launching {
        self.launching.clone()
    }

    fn remember(&mut self, memory: &Launching) {
        self.launching = memory.clone();
    }

    fn remembered(memory: &Launching) -> usize {
        memory.nodes.len()
    }

    fn to_remember(parts: &SystemParts) -> usize {
        parts.launchers.len()
    }
}

/// How a launch stands: all that its future depends on, and what has come of it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Launching {
    /// Each launcher's node, (launchers,).
    pub nodes: Vec<Launched>,
    /// Recoil on the tubes so far.
    pub recoil: Recoil,
}

/// How far a launched node is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Launched {
    /// Whether it is on its way.
    pub phase: Phase,
    /// Time at which it left, s, and its speed then, m/s; none before.
    pub left: Option<(f64, f64)>,
}

/// Where a launched node is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Phase {
    /// Held where it is.
    Held,
    /// In its tube.
    Guided,
    /// Let go at this step.
    Leaving,
    /// On its own.
    Free,
}

/// The push of all tubes together on what carries them.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Recoil {
    /// Its impulse so far, N s, world frame.
    pub impulse: DVec3,
    /// The largest force, N, and its time, s.
    pub peak: (f64, f64),
}

/// Force of a launcher on its node at one evaluation of forces.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Thrust {
    /// All of it, N.
    pub force: DVec3,
    /// Of that, the push along the tube.
    push: DVec3,
    /// Where the node is, m.
    pub place: DVec3,
    /// The time until it leaves the tube, s, and its speed then, m/s, where it does so in this step.
    leaves: Option<(f64, f64)>,
}

impl Launching {
    /// Before the first step.
    fn starting(launchers: &[Launcher]) -> Launching {
        let phase = |launcher: &Launcher| match (&launcher.by, launcher.at > 0.0) {
            (Means::Tube(_), false) => Phase::Guided,
            _ => Phase::Held,
        };
        let nodes = launchers.iter().map(|launcher| Launched { phase: phase(launcher), left: None });
        Launching { nodes: nodes.collect(), recoil: Recoil::default() }
    }

    /// After a step, whose end is [`Now::time`]: who goes on. Calls `release` with each node that leaves at a given
    /// velocity.
    fn advance(
        &mut self,
        launchers: &[Launcher],
        thrusts: &[Thrust],
        &Now { time, factors, is_first, .. }: &Now,
        mut release: impl FnMut(usize, DVec3),
    ) {
        let before = time - factors.dt;
        let push: DVec3 = thrusts.iter().map(|thrust| thrust.push).sum();
        // a run's first kick is half a step long
        self.recoil.impulse -= if is_first { 0.5 } else { 1.0 } * factors.dt * push;
        // the last push of a tube stands for less or more than a step
        let is_whole = thrusts.iter().all(|thrust| thrust.leaves.is_none());
        if is_whole && push.length() > self.recoil.peak.0 {
            self.recoil.peak = (push.length(), before);
        }
        for ((launcher, thrust), Launched { phase, left }) in launchers.iter().zip(thrusts).zip(&mut self.nodes) {
            match (*phase, &launcher.by) {
                // steps are where they are to rounding only
                (Phase::Held, by) if time + 1e-6 * factors.dt >= launcher.at => match by {
                    Means::Tube(_) => *phase = Phase::Guided,
                    Means::Velocity(velocity) => {
                        (*phase, *left) = (Phase::Leaving, Some((time, velocity.length())));
                        release(launcher.node, *velocity);
                    }
                },
                (Phase::Guided, _) => {
                    if let Some((after, speed)) = thrust.leaves {
                        (*phase, *left) = (Phase::Free, Some((before + after, speed)));
                    }
                }
                (Phase::Leaving, _) => *phase = Phase::Free,
                (Phase::Held | Phase::Free, _) => {}
            }
        }
    }
}

impl Phase {
    /// Whether a body keeps its attitude, whatever torque there is.
    fn is_guided(self) -> bool {
        matches!(self, Phase::Held | Phase::Guided)
    }
}

/// Force of a launcher on its node of `mass`, kg, in this phase. All other forces on the node sum to `pulled`, N, at
/// `time`, s.
fn thrust(
    launcher: &Launcher,
    phase: Phase,
    node: Moving,
    mass: f64,
    pulled: DVec3,
    time: f64,
    factors: StepFactors,
) -> Thrust {
    let none = Thrust { place: node.x, ..Thrust::default() };
    match (phase, &launcher.by) {
        (Phase::Held, _) => Thrust { force: -pulled, ..none },
        (Phase::Guided, Means::Tube(tube)) => tube.thrust(node, mass, pulled, time - launcher.at, factors),
        _ => none,
    }
}

impl Tube {
    fn thrust(&self, node: Moving, mass: f64, pulled: DVec3, time: f64, factors: StepFactors) -> Thrust {
        let (way, speed, along) =
            ((node.x - self.breech).dot(self.direction), node.v.dot(self.direction), pulled.dot(self.direction));
        let mut push = self.push.at(way, time);
        if way <= 0.0 && speed <= 0.0 && push + along <= 0.0 {
            // it rests on the breech
            return Thrust { force: -pulled, place: node.x, ..Thrust::default() };
        }
        // speed after this step under the whole push
        let next_speed = factors.p * speed + factors.q * ((push + along) / mass);
        let left = self.stroke - way;
        // the node passes the muzzle within the step: scale the push to the way that is left
        let leaves = (factors.dt * next_speed >= left).then(|| {
            let (last, next) = ((factors.dt * speed).max(0.0), factors.dt * next_speed);
            let mean = self.push.at(way + 0.5 * left, time);
            push = (push * last + 2.0 * mean * left) / (last + next);
            let speed = factors.p * speed + factors.q * ((push + along) / mass);
            (left / next * factors.dt, speed)
        });
        // the tube balances all force across its axis
        let across = pulled - along * self.direction;
        let push = push * self.direction;
        Thrust { force: push - across, push, place: node.x, leaves }
    }
}

//! The step in readable form: forces of ropes and effects, then kick and drift, node by node.
//!
//! Slower than [`crate::time::step`], which must give the same bits; a test holds them together. Read this one.

use glam::DVec3;

use super::rope_forces::{drag_all, drag_at, lost_work, no_drag, pull_all, pull_at};
use super::start::started;
use crate::channel::{ByChannel, Channel};
use crate::effects::Effects;
use crate::forces::gravity;
use crate::forces::rope_tension::Pull;
use crate::layout::Address;
use crate::moving::{Moving, Net, StepFactors, Turning};
use crate::rope_state::RopeState;
use crate::state::State;
use crate::system::System;
use crate::team::Team;

/// A net in motion, in arrays by node and by segment.
pub struct Readable<'a> {
    system: &'a System,
    factors: StepFactors,
    /// Positions, m, (nodes,).
    pub position: Vec<DVec3>,
    /// Half-step velocities, m/s, (nodes,).
    pub velocity: Vec<DVec3>,
    /// Velocities extrapolated to the step, m/s, (nodes,).
    pub extrapolated: Vec<DVec3>,
    /// Tension and force of each segment at the last forces, (segments,).
    pub pulls: Vec<Pull>,
    /// Work between the last two forces, J, by the channel that it goes to.
    pub work: ByChannel,
    /// Half the drag of each segment, N, and its middle, m, at the last forces; (segments,), or empty without air.
    drags: Vec<(DVec3, DVec3)>,
    effects: Effects<'a>,
    /// All slots of each node, (nodes,).
    slots: Vec<Vec<Address>>,
    taken: u64,
    /// State of segments' laws, and which are broken.
    pub ropes: RopeState,
    /// The segments that broke at the last forces; they are gone from the next on.
    pub failing: Vec<usize>,
    /// Whether nodes have moved since the last forces.
    moved: bool,
}

impl<'a> Readable<'a> {
    /// Starts from `state` with steps of `dt` seconds.
    pub fn new(system: &'a System, state: &State, dt: f64) -> Readable<'a> {
        let State { position, velocity, rotation } = started(system, state, dt);
        let factors = StepFactors::new(dt, system.environment().mass_damping);
        let mut net = Readable {
            system,
            factors,
            extrapolated: velocity.clone(),
            velocity,
            pulls: vec![Pull::NONE; system.segments().len()],
            work: ByChannel::default(),
            drags: no_drag(system),
            ropes: RopeState::at_rest(system, &position),
            position,
            failing: Vec::new(),
            moved: false,
            effects: Effects::new(system.parts(), factors),
            slots: system.layout().slots_by_node(),
            taken: 0,
        };
        net.effects.turn(rotation.iter().copied().map(Turning::starting).collect());
        net.effects.placed(|node| moving(&net.position, &net.velocity, &net.velocity, node));
        let acceleration = net.accelerations();
        for node in (0..acceleration.len()).filter(|&n| is_free(system, n)) {
            for k in 0..3 {
                net.velocity[node][k] = net.factors.before_start(net.velocity[node][k], acceleration[node][k]);
            }
        }
        net.effects.before_start(&rotation);
        net
    }

    /// One step: forces, kick, drift, then nodes that effects carry.
    pub fn step(&mut self) {
        let acceleration = self.accelerations();
        for node in (0..acceleration.len()).filter(|&n| is_free(self.system, n)) {
            for k in 0..3 {
                let (v, x, a) = (self.velocity[node][k], self.position[node][k], acceleration[node][k]);
                let [v, x, w] = self.factors.advance(v, x, a);
                (self.velocity[node][k], self.position[node][k], self.extrapolated[node][k]) = (v, x, w);
            }
        }
        self.moved = true;
        self.taken += 1;
        self.carry();
    }

    /// The sum of all forces over the mass. Mass-proportional damping is in the factors of the step.
    fn accelerations(&mut self) -> Vec<DVec3> {
        // ropes: those that broke are gone; tension, drag, and which break now
        self.pull_ropes();
        // effects: forces by place and motion, what breaks with a segment, then forces that answer all others
        self.act();
        // all together, slot by slot, and weight
        let mut force = self.effects.forces().force.clone();
        self.add_ropes(&mut force);
        for (force, &mass) in force.iter_mut().zip(self.system.mass()) {
            *force += gravity::force(self.system.environment().gravity, mass);
        }
        self.moved = false;
        force.iter().zip(self.system.mass()).map(|(f, m)| *f * (1.0 / m)).collect()
    }

    fn pull_ropes(&mut self) {
        let (system, dt, before) = (self.system, self.factors.dt, self.pulls.clone());
        for segment in std::mem::take(&mut self.failing) {
            self.ropes.broken[segment] = self.moved;
        }
        let (x, w) = (&self.position, &self.extrapolated);
        let elapsed = if self.moved { dt } else { 0.0 };
        pull_all(system, x, w, dt, elapsed, &mut self.ropes, &mut self.pulls);
        self.work = ByChannel::default();
        self.work[Channel::RopeDamping] = lost_work(system, &before, &self.pulls);
        self.work[Channel::Air] = drag_all(system, self.time(), x, w, &self.ropes.broken, &mut self.drags);
        self.failing = failing(system, self.time(), &self.ropes, &mut self.pulls);
    }

    fn act(&mut self) {
        let (time, team) = (self.time(), Team::default());
        let Readable { system, position, velocity, extrapolated, slots, pulls, drags, .. } = self;
        let net = Arrays { system, position, velocity, extrapolated, slots, pulls, drags };
        self.effects.act(&team, time, &net);
        self.effects.part(self.failing.iter().copied());
        self.effects.couple(&team, time, &net);
        let forces = self.effects.forces();
        for &(node, before) in &forces.released {
            self.velocity[node] = before;
        }
        self.work += forces.work;
    }

    /// Adds tension and drag of segments to `force`, N, (nodes,), slot by slot in the layout's order; see
    /// [`crate::layout`].
    fn add_ropes(&self, force: &mut [DVec3]) {
        let layout = self.system.layout();
        for (block, plan) in layout.blocks().iter().enumerate() {
            for (slot, content) in plan.slots.iter().enumerate() {
                let (at, force) = (Address { block, slot }, &mut force[content.node]);
                let (pull, drag) = (pull_at(self.system, &self.pulls, at), drag_at(self.system, &self.drags, at));
                // at home the drag goes with what came from elsewhere
                let is_home = at == layout.homes()[content.node];
                *force = if is_home { (*force + drag) + pull } else { *force + (pull + drag) };
            }
        }
    }

    /// Bodies turn and take their ties along, driven nodes go on, launchers release.
    fn carry(&mut self) {
        let (time, (x, v, w)) = (self.time(), (&mut self.position, &mut self.velocity, &mut self.extrapolated));
        for &(node, moving) in self.effects.moved(time, |node| moving(x, v, w, node)) {
            (x[node], v[node], w[node]) = (moving.x, moving.v, moving.w);
        }
    }

    /// Time of the next forces, s.
    fn time(&self) -> f64 {
        self.taken as f64 * self.factors.dt
    }
}

/// The net in arrays, as effects see it.
struct Arrays<'s> {
    system: &'s System,
    position: &'s [DVec3],
    velocity: &'s [DVec3],
    extrapolated: &'s [DVec3],
    slots: &'s [Vec<Address>],
    pulls: &'s [Pull],
    drags: &'s [(DVec3, DVec3)],
}

impl Net for Arrays<'_> {
    fn node(&self, node: usize) -> Moving {
        moving(self.position, self.velocity, self.extrapolated, node)
    }

    fn with_ropes(&self, node: usize, force: DVec3) -> DVec3 {
        let slot_force = |at: &Address| pull_at(self.system, self.pulls, *at) + drag_at(self.system, self.drags, *at);
        self.slots[node].iter().map(slot_force).fold(force, |force, of_slot| force + of_slot)
    }
}

fn moving(position: &[DVec3], velocity: &[DVec3], extrapolated: &[DVec3], node: usize) -> Moving {
    Moving { x: position[node], v: velocity[node], w: extrapolated[node] }
}

/// The segments that break under the tensions just computed, in the layout's order: the energy that breaking takes is added
/// up in it.
fn failing(system: &System, time: f64, ropes: &RopeState, pulls: &mut [Pull]) -> Vec<usize> {
    let mut failing = Vec::new();
    let slots = system.layout().blocks().iter().flat_map(|block| &block.slots);
    for index in slots.filter_map(|slot| slot.segment) {
        let (s, pull) = (&system.segments()[index], &mut pulls[index]);
        if !ropes.broken[index] && s.breaking.happens(time, s.rest_length, pull.tension, pull.length) {
            failing.push(index);
            // the work of its last tension is lost, so all of that tension is dissipative
            pull.dissipative = pull.tension;
        }
    }
    failing
}

/// Whether a node goes where forces take it.
fn is_free(system: &System, node: usize) -> bool {
    !system.held()[node] && system.mass()[node] > 0.0
}

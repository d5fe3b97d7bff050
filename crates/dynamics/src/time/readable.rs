//! The step as one reads it: a call an effect, then kick and drift, node by node.
//!
//! Slower than [`crate::time::step`], which must give the same bits; a test holds them together. Read this one.

use glam::DVec3;

use super::StepFactors;
use super::attached::{Attached, Moving, Turning, started};
use super::launching::Launching;
use super::step::Team;
use crate::forces::gravity;
use crate::forces::law::{self, RopeState};
use crate::forces::rope_drag;
use crate::forces::rope_tension::Pull;
use crate::layout::Address;
use crate::state::State;
use crate::system::System;

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
    /// What each segment did at the last forces, (segments,).
    pub pulls: Vec<Pull>,
    /// Work lost inside ropes between the last two forces, J.
    pub rope_work: f64,
    /// Half the drag of each segment, N, and its middle, m, at the last forces; (segments,), or empty without air.
    drags: Vec<(DVec3, DVec3)>,
    /// Work done on the air between the last two forces, J.
    pub air_work: f64,
    attached: Option<Attached<'a>>,
    /// All slots of each node, (nodes,).
    slots: Vec<Vec<Address>>,
    taken: u64,
    /// What segments remember, and which are gone.
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
        let turning = rotation.iter().copied().map(Turning::starting).collect();
        let ropes = RopeState::at_rest(system, &position);
        let mut net = Readable {
            system,
            factors,
            position,
            extrapolated: velocity.clone(),
            velocity,
            pulls: vec![Pull::NONE; system.segments().len()],
            rope_work: 0.0,
            drags: rope_drag::none(system),
            air_work: 0.0,
            ropes,
            failing: Vec::new(),
            moved: false,
            attached: Attached::new(system, factors, turning, Launching::starting(system), 0.0),
            slots: system.layout().slots_by_node(),
            taken: 0,
        };
        let (x, v) = (&net.position, &net.velocity);
        let placed = |node: usize| Moving { x: x[node], v: v[node], w: v[node] };
        net.attached.iter_mut().for_each(|attached| attached.place(placed));
        let acceleration = net.accelerations();
        for node in (0..acceleration.len()).filter(|&n| is_free(system, n)) {
            for k in 0..3 {
                net.velocity[node][k] = net.factors.before_start(net.velocity[node][k], acceleration[node][k]);
            }
        }
        net.attached.iter_mut().for_each(|attached| attached.before_start(&rotation));
        net
    }

    /// One step: forces, kick, drift.
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

    /// The sum of all effects over the mass. Mass-proportional damping is in the factors of the step.
    fn accelerations(&mut self) -> Vec<DVec3> {
        let (system, before) = (self.system, self.pulls.clone());
        for segment in std::mem::take(&mut self.failing) {
            self.ropes.broken[segment] = self.moved;
        }
        let (x, w, dt) = (&self.position, &self.extrapolated, self.factors.dt);
        let elapsed = if self.moved { dt } else { 0.0 };
        law::pull_all(system, x, w, dt, elapsed, &mut self.ropes, &mut self.pulls);
        self.rope_work = law::lost_work(system, &before, &self.pulls);
        let time = self.taken as f64 * dt;
        self.air_work = rope_drag::drag_all(system, time, x, w, &self.ropes.broken, &mut self.drags);
        self.failing = failing(system, &self.ropes, &mut self.pulls);

        let mut force = vec![DVec3::ZERO; x.len()];
        if let Some(attached) = &mut self.attached {
            let velocity = &mut self.velocity;
            let moving = |node: usize| Moving { x: x[node], v: velocity[node], w: w[node] };
            attached.act(&Team::default(), time, moving);
            attached.part(self.failing.iter().copied());
            let (pulls, drags) = (&self.pulls, &self.drags);
            let pull_at = |at: &Address| law::force_at(system, pulls, *at) + rope_drag::force_at(system, drags, *at);
            attached.couple(
                |node, force| self.slots[node].iter().map(pull_at).fold(force, |force, pull| force + pull),
                moving,
            );
            force.copy_from_slice(attached.force());
            attached.let_go().iter().for_each(|&(node, before)| velocity[node] = before);
            self.rope_work += attached.sums().bending_work;
            self.air_work += attached.sums().air_work;
        }
        self.add_ropes(&mut force);
        self.moved = false;
        gravity::add_force(system.environment().gravity, system.mass(), &mut force);
        force.iter().zip(system.mass()).map(|(f, m)| *f * (1.0 / m)).collect()
    }

    /// Adds tension and drag of segments to `force`, N, (nodes,), slot by slot in the layout's order; see
    /// [`crate::layout`].
    fn add_ropes(&self, force: &mut [DVec3]) {
        let layout = self.system.layout();
        for (block, plan) in layout.blocks().iter().enumerate() {
            for (slot, content) in plan.slots.iter().enumerate() {
                let (at, force) = (Address { block, slot }, &mut force[content.node]);
                let pull = law::force_at(self.system, &self.pulls, at);
                let drag = rope_drag::force_at(self.system, &self.drags, at);
                // at home the drag goes with what came from elsewhere
                *force = match at == layout.homes()[content.node] {
                    true => (*force + drag) + pull,
                    false => *force + (pull + drag),
                };
            }
        }
    }

    /// Bodies turn and take their ties along, driven nodes go on.
    fn carry(&mut self) {
        let Some(attached) = &mut self.attached else { return };
        let (x, v, w) = (&mut self.position, &mut self.velocity, &mut self.extrapolated);
        let time = self.taken as f64 * self.factors.dt;
        for &(node, moving) in attached.carry(time, |node| Moving { x: x[node], v: v[node], w: w[node] }) {
            (x[node], v[node], w[node]) = (moving.x, moving.v, moving.w);
        }
    }
}

/// The segments that break under the tensions just computed.
fn failing(system: &System, ropes: &RopeState, pulls: &mut [Pull]) -> Vec<usize> {
    let mut failing = Vec::new();
    for (index, (s, pull)) in system.segments().iter().zip(pulls).enumerate() {
        if !ropes.broken[index] && s.breaking.happens(s.rest_length, pull.tension, pull.length) {
            failing.push(index);
            // nothing takes back what its last tension does
            pull.friction = pull.tension;
        }
    }
    failing
}

/// Whether a node goes where forces take it.
fn is_free(system: &System, node: usize) -> bool {
    !system.held()[node] && system.mass()[node] > 0.0
}

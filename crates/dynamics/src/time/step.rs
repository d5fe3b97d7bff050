//! One step: forces, kick, drift. The fused form of [`crate::time::readable`], equal to it bit for bit.

use glam::DVec3;

use super::blocks::{KnotState, Nodes, Ropes, blocks};
pub use super::failing::BreakingSegment;
use super::failing::failing;
use super::motion::Motion;
use super::passes::AirNow;
pub use super::passes::Vectors;
use super::start::started;
use crate::channel::{ByChannel, Channel};
use crate::effects::{self, EffectForces, Effects, Launching, carried_velocities};
use crate::energy::Ledger;
use crate::layout::Address;
use crate::moving::{Moving, Net, StepFactors, Turning};
use crate::rope_state::RopeState;
use crate::state::State;
use crate::system::System;
use crate::team::Team;

/// With fewer slots than this, threads wait longer than they work, and one thread does everything.
pub const LEAST_SLOTS_FOR_THREADS: usize = 20_000;

/// Threads and vectors on which a step runs; no choice changes a bit of the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Engine {
    /// Threads at most.
    pub threads: usize,
    /// Widest vectors.
    pub vectors: Vectors,
    /// Slots below which one thread does all.
    pub least_slots_for_threads: usize,
}

impl Default for Engine {
    fn default() -> Self {
        Engine { threads: 1, vectors: Vectors::Widest, least_slots_for_threads: LEAST_SLOTS_FOR_THREADS }
    }
}

/// Sums of a step over the whole net.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StepSums {
    /// Work since the forces before, J, by the channel that it goes to; that of breaking segments apart.
    pub work: ByChannel,
    /// Power lost to mass-proportional damping at the step before, W.
    pub mass_power: f64,
    /// Number of segments that break in this step; [`Stepper::failing`] says which.
    pub failing: usize,
}

/// A net in motion, stored in blocks of slots: it advances positions and half-step velocities by whole steps.
pub struct Stepper<'a> {
    system: &'a System,
    factors: StepFactors,
    gravity: [f64; 3],
    nodes: Vec<Nodes>,
    ropes: Vec<Ropes>,
    /// State of the knots of each block, sent from their homes to their other slots.
    knot_states: Vec<Vec<KnotState>>,
    /// Forces beside those of ropes; none where there are no effects.
    effects: Option<Effects<'a>>,
    /// All slots of each node, (nodes,), where effects act.
    slots: Vec<Vec<Address>>,
    /// Steps taken.
    taken: u64,
    /// Whether nodes have moved since the last forces.
    moved: bool,
    team: Team,
    vectors: Vectors,
}

impl<'a> Stepper<'a> {
    /// Starts from `state` with steps of `dt` seconds, on at most `threads` threads. The result is the same for any
    /// number.
    pub fn new(system: &'a System, state: &State, dt: f64, threads: usize) -> Stepper<'a> {
        Stepper::on(Engine { threads, ..Engine::default() }, system, state, dt)
    }

    /// As [`Stepper::new`], on a chosen engine. The result is the same on any.
    pub fn on(engine: Engine, system: &'a System, state: &State, dt: f64) -> Stepper<'a> {
        let mut stepper = Stepper::empty(engine, system, dt, 0);
        stepper.turn(state.rotation.iter().copied().map(Turning::starting).collect());
        stepper.start(state);
        stepper
    }

    /// Goes on from where [`Stepper::motion`] left off, between two steps, on at most `threads` threads. The first
    /// forces tell no work lost in ropes: they do not know the lengths before.
    pub fn resume(system: &'a System, motion: &Motion, dt: f64, threads: usize) -> Stepper<'a> {
        let engine = Engine { threads, ..Engine::default() };
        let mut stepper = Stepper::empty(engine, system, dt, motion.step);
        stepper.turn(motion.turning.clone());
        if let Some(effects) = &mut stepper.effects {
            effects.remember(&motion.effects, motion.step == 0);
        }
        stepper.put_all(&motion.position, &motion.half_step_velocity, &motion.extrapolated);
        stepper.put_ropes(&motion.ropes);
        stepper
    }

    /// The state on which a step depends: forces and tensions follow from it, and the rest never changes.
    pub fn motion(&self) -> Motion {
        // taken apart field by field, so that what is new cannot be forgotten here
        let Stepper { system, nodes, effects, taken, .. } = self;
        let Stepper {
            factors: _, gravity: _, ropes: _, knot_states: _, slots: _, moved: _, team: _, vectors: _, ..
        } = self;
        // segments that break now still pull in this step: they are kept as whole, and break again on resuming
        let mut ropes = self.ropes();
        for failing in self.failing() {
            ropes.broken[failing.segment] = false;
        }
        let by_node = |value: fn(&Nodes, usize) -> [f64; 3]| {
            let homes = system.layout().homes().iter();
            homes.map(|&Address { block, slot }| value(&nodes[block], slot).into()).collect()
        };
        Motion {
            position: by_node(|nodes, slot| nodes.x.each_ref().map(|x| x[slot])),
            half_step_velocity: by_node(|nodes, slot| nodes.v.each_ref().map(|v| v[slot])),
            extrapolated: by_node(|nodes, slot| nodes.w.each_ref().map(|w| w[slot])),
            turning: effects.as_ref().map_or(Vec::new(), |effects| effects.turning().to_vec()),
            effects: effects.as_ref().map_or(effects::Memory::default(), Effects::memory),
            step: *taken,
            ropes,
        }
    }

    /// State of segments' laws, and which segments are broken, at the last forces.
    pub fn ropes(&self) -> RopeState {
        let segments = || self.system.layout().segment_slots().iter().map(|at| (&self.ropes[at.block], at.slot));
        let memory = segments().map(|(ropes, slot)| ropes.memory.get(slot).copied().unwrap_or_default());
        let mut state = RopeState {
            memory: if self.system.remembers() { memory.collect() } else { Vec::new() },
            broken: segments().map(|(ropes, slot)| ropes.is_gone(slot)).collect(),
        };
        for failing in self.failing() {
            state.broken[failing.segment] = true;
        }
        state
    }

    /// The segments that break under the last tensions.
    pub fn failing(&self) -> impl Iterator<Item = BreakingSegment> {
        failing(&self.ropes, self.system)
    }

    /// A net without a state yet.
    fn empty(engine: Engine, system: &'a System, dt: f64, taken: u64) -> Stepper<'a> {
        let mut acted_on = vec![false; system.mass().len()];
        effects::nodes(system.parts(), None, &mut |node| acted_on[node] = true);
        let (nodes, ropes) = blocks(system, &acted_on);
        let Engine { threads, vectors, least_slots_for_threads } = engine;
        let worth_it = threads > 1 && system.layout().slot_count() >= least_slots_for_threads;
        let factors = StepFactors::new(dt, system.environment().mass_damping);
        let effects = Some(Effects::new(system.parts(), factors)).filter(|effects| !effects.is_empty());
        Stepper {
            system,
            factors,
            gravity: system.environment().gravity.into(),
            knot_states: nodes.iter().map(|block| vec![KnotState::default(); block.home_count()]).collect(),
            nodes,
            ropes,
            slots: system.layout().slots_by_node(),
            effects,
            taken,
            moved: false,
            team: if worth_it { Team::of(threads) } else { Team::default() },
            vectors,
        }
    }

    /// Sets how bodies turn, (bodies,).
    fn turn(&mut self, turning: Vec<Turning>) {
        if let Some(effects) = &mut self.effects {
            effects.turn(turning);
        }
    }

    /// Starts again from another state. The forces are then those of that state.
    pub fn restart(&mut self, state: &State) {
        self.turn(state.rotation.iter().copied().map(Turning::starting).collect());
        self.start(state);
    }

    /// Sets the state and the half-step velocities before it.
    fn start(&mut self, state: &State) {
        let system = self.system;
        let State { position, velocity, rotation } = started(system, state, self.factors.dt);
        // forces at the start follow from positions and velocities there
        self.put_all(&position, &velocity, &velocity);
        self.put_ropes(&RopeState::at_rest(system, &position));
        self.forces();
        // half-step velocities such that the mean about the start is the velocity asked for
        for (node, &home) in system.layout().homes().iter().enumerate() {
            if !system.held()[node] && system.mass()[node] > 0.0 {
                let (v, a) = (velocity[node], self.acceleration(node));
                let before = std::array::from_fn(|k| self.factors.before_start(v[k], a[k]));
                self.nodes[home.block].put(home.slot, position[node].into(), before, v.into());
            }
        }
        if let Some(effects) = &mut self.effects {
            effects.before_start(&rotation);
        }
    }

    /// Writes every node into all of its slots. Positions, m, and velocities, m/s; each (nodes,).
    fn put_all(&mut self, position: &[DVec3], half_step_velocity: &[DVec3], extrapolated: &[DVec3]) {
        for (block, plan) in self.system.layout().blocks().iter().enumerate() {
            for (slot, content) in plan.slots.iter().enumerate() {
                let value = |values: &[DVec3]| values[content.node].to_array();
                self.nodes[block].put(slot, value(position), value(half_step_velocity), value(extrapolated));
            }
        }
        for (nodes, sent) in self.nodes.iter().zip(&mut self.knot_states) {
            nodes.send_knots(sent);
        }
        if let Some(effects) = &mut self.effects {
            effects.placed(|node| Moving { x: position[node], v: half_step_velocity[node], w: extrapolated[node] });
        }
    }

    /// Sets the state of segments' laws, and removes broken segments.
    fn put_ropes(&mut self, state: &RopeState) {
        for (segment, &Address { block, slot }) in self.system.layout().segment_slots().iter().enumerate() {
            let ropes = &mut self.ropes[block];
            if let Some(memory) = ropes.memory.get_mut(slot) {
                *memory = state.memory_of(segment);
            }
            if state.broken[segment] {
                ropes.remove(slot);
            }
        }
        if let Some(effects) = &mut self.effects {
            effects.put_broken(&state.broken);
        }
    }

    /// One whole step. Afterwards positions are those of the next step, velocities half a step behind them, tensions
    /// those of the step just taken.
    pub fn step(&mut self) -> StepSums {
        self.pull();
        self.advance()
    }

    /// The first part of [`Stepper::step`]: tensions and forces where the nodes are now, so that a caller can inspect
    /// forces before the kick.
    pub fn forces(&mut self) -> StepSums {
        self.pull();
        let (ropes, of_effects) =
            (&self.ropes, self.effects.as_ref().map_or(&[][..], |effects| &effects.forces().force));
        self.team.for_each(&mut self.nodes, &mut self.knot_states, |block, nodes, _| {
            nodes.collect(ropes, of_effects, block);
        });
        self.sums()
    }

    /// The second part of [`Stepper::step`].
    pub fn advance(&mut self) -> StepSums {
        let (factors, gravity, ropes, vectors) = (self.factors, self.gravity, &self.ropes, self.vectors);
        let of_effects = self.effects.as_ref().map_or(&[][..], |effects| &effects.forces().force);
        self.team.for_each(&mut self.nodes, &mut self.knot_states, |block, nodes, sent| {
            // collect forces, kick and drift, send knots to their other slots
            nodes.collect(ropes, of_effects, block);
            vectors.advance_nodes(nodes, &ropes[block], factors, gravity);
            nodes.send_knots(sent);
        });
        self.taken += 1;
        self.carry();
        self.moved = true;
        self.sums()
    }

    /// Tension and drag of ropes, then the forces of effects.
    fn pull(&mut self) {
        let (dt, sent, vectors, moved) = (self.factors.dt, &self.knot_states, self.vectors, self.moved);
        let time = self.taken as f64 * dt;
        let air_now = self.system.environment().air.as_ref().map(|air| AirNow::at(air, time));
        // ropes, block by block, after knots have received their new state
        self.team.for_each(&mut self.nodes, &mut self.ropes, |_, nodes, ropes| {
            nodes.receive_knots(sent);
            ropes.forces(nodes, vectors, time, dt, moved, air_now);
        });
        self.moved = false;
        let Some(effects) = &mut self.effects else { return };
        let homes = self.system.layout().homes();
        let net = Blocks { nodes: &self.nodes, ropes: &self.ropes, slots: &self.slots, homes };
        // effects: forces from place and motion, breaking segments, forces that answer all others
        effects.act(&self.team, time, &net);
        effects.part(failing(&self.ropes, self.system).map(|failure| failure.segment));
        effects.couple(&self.team, time, &net);
        // released nodes start with their launch velocity
        for &(node, before) in &effects.forces().released {
            let Address { block, slot } = homes[node];
            for (v, before) in self.nodes[block].v.iter_mut().zip(before.to_array()) {
                v[slot] = before;
            }
        }
    }

    /// Moves the nodes that effects carry, and sends their state to their other slots.
    fn carry(&mut self) {
        let Some(effects) = &mut self.effects else { return };
        let (homes, nodes) = (self.system.layout().homes(), &mut self.nodes);
        let time = self.taken as f64 * self.factors.dt;
        for &(node, moving) in effects.moved(time, |node| nodes[homes[node].block].moving(homes[node].slot)) {
            nodes[homes[node].block].carry(homes[node].slot, moving, &mut self.knot_states[homes[node].block]);
        }
    }

    fn sums(&self) -> StepSums {
        let squares: f64 = self.nodes.iter().map(|nodes| nodes.mass_velocity_squared).sum();
        let mut work = ByChannel::default();
        work[Channel::RopeDamping] = self.ropes.iter().map(|ropes| ropes.rope_work).sum();
        let dragging = self.ropes.iter().filter_map(|ropes| ropes.dragging.as_ref());
        work[Channel::Air] = dragging.map(|drag| drag.work).sum();
        let mut turning = 0.0;
        if let Some(effects) = &self.effects {
            work += effects.forces().work;
            turning = effects.forces().turning;
        }
        StepSums {
            work,
            mass_power: self.system.environment().mass_damping * (squares + turning),
            failing: self.ropes.iter().map(|ropes| ropes.failing.len()).sum(),
        }
    }

    /// Energy that the state stores at the last forces, J; only between [`Stepper::forces`] and [`Stepper::advance`].
    pub(crate) fn stored(&self, state: &State) -> Ledger {
        Ledger::of(self.system, state, &self.ropes(), self.effects.as_ref())
    }

    /// Keeps, from the next forces on, the forces of the effects of these names; [`effects::EFFECTS`] has the names.
    pub fn watch(&mut self, names: &[&str]) {
        if let Some(effects) = &mut self.effects {
            effects.watch(names);
        }
    }

    /// Forces of an effect on nodes and bodies at the last forces; none where it is absent or not watched.
    pub fn forces_of(&self, name: &str) -> Option<&EffectForces> {
        self.effects.as_ref()?.watched(name)
    }

    /// Acceleration of a node, m/s^2, at the last forces; only between [`Stepper::forces`] and [`Stepper::advance`].
    fn acceleration(&self, node: usize) -> [f64; 3] {
        let Address { block, slot } = self.system.layout().homes()[node];
        let nodes = &self.nodes[block];
        let (force, (mass, per_mass)) = (nodes.force(&self.ropes[block], slot), nodes.mass(slot));
        std::array::from_fn(|k| (force[k] + mass * self.gravity[k]) * per_mass)
    }

    /// The threads on which the net is advanced.
    pub fn team(&self) -> Team {
        self.team.clone()
    }

    /// The system that moves.
    pub fn system(&self) -> &'a System {
        self.system
    }

    /// Step, s.
    pub fn dt(&self) -> f64 {
        self.factors.dt
    }

    /// State of the launch.
    pub fn launching(&self) -> Launching {
        self.effects.as_ref().map_or(Launching::default(), Effects::launching)
    }

    /// Position of a node, m.
    pub fn position(&self, node: usize) -> DVec3 {
        let Address { block, slot } = self.system.layout().homes()[node];
        self.nodes[block].x.each_ref().map(|x| x[slot]).into()
    }

    /// Velocity of a node half a step before its position, m/s.
    pub fn half_step_velocity(&self, node: usize) -> DVec3 {
        let Address { block, slot } = self.system.layout().homes()[node];
        self.nodes[block].v.each_ref().map(|v| v[slot]).into()
    }

    /// The state at the last forces; only between [`Stepper::forces`] and [`Stepper::advance`].
    pub fn state(&self, state: &mut State) {
        let (system, State { position, velocity, rotation }) = (self.system, state);
        let nodes = 0..system.mass().len();
        position.clear();
        position.extend(nodes.clone().map(|node| self.position(node)));
        velocity.clear();
        velocity.extend(nodes.map(|node| self.velocity(node)));
        *rotation = self.effects.as_ref().map_or(Vec::new(), Effects::rotations);
        carried_velocities(system.bodies(), rotation, position, velocity);
    }

    /// Where nodes were half a step before the step that was taken last, midway between two of their positions, and
    /// how bodies are turned now. Ties follow from the latter.
    pub fn midway(&self, state: &mut State) {
        let dt = self.factors.dt;
        for (position, Address { block, slot }) in state.position.iter_mut().zip(self.system.layout().homes()) {
            let Moving { x, v, w } = self.nodes[*block].moving(*slot);
            // w = 3/2 v - 1/2 u, u the half-step velocity before v
            *position = x - dt * (2.5 * v - w);
        }
        state.rotation = self.effects.as_ref().map_or(Vec::new(), Effects::rotations);
    }

    /// Velocity of a node at its position, m/s, those of ties apart.
    fn velocity(&self, node: usize) -> DVec3 {
        let Address { block, slot } = self.system.layout().homes()[node];
        if self.system.mass()[node] == 0.0 || self.system.held()[node] {
            // at rest, or driven
            return self.nodes[block].moving(slot).w;
        }
        let (before, a) = (self.half_step_velocity(node), self.acceleration(node));
        DVec3::from_array(std::array::from_fn(|k| self.factors.at_step(before[k], a[k])))
    }

    /// The force on a node at the last forces, N; zero on one that is held or carried. Only between [`Stepper::forces`]
    /// and [`Stepper::advance`].
    pub fn force(&self, node: usize) -> DVec3 {
        let Address { block, slot } = self.system.layout().homes()[node];
        let (mass, _) = self.nodes[block].mass(slot);
        mass * DVec3::from_array(self.acceleration(node))
    }

    /// The force with which its support acts on a held or driven node, N: it balances ropes, effects and weight at the last
    /// forces.
    pub fn reaction(&self, node: usize) -> DVec3 {
        let of_effects = self.effects.as_ref().map_or(DVec3::ZERO, |effects| effects.forces().force[node]);
        // ropes do not tell each other of a node that rests: it is asked for in every slot
        let homes = self.system.layout().homes();
        let net = Blocks { nodes: &self.nodes, ropes: &self.ropes, slots: &self.slots, homes };
        let weight = self.system.mass()[node] * self.system.environment().gravity;
        -(net.with_ropes(node, of_effects) + weight)
    }

    /// The torque on each body at the last forces, N m, (bodies,).
    pub fn torques(&self) -> &[DVec3] {
        self.effects.as_ref().map_or(&[][..], |effects| &effects.forces().torque)
    }

    /// Tension of a segment at the last forces, N.
    pub fn tension(&self, segment: usize) -> f64 {
        let Address { block, slot } = self.system.layout().segment_slots()[segment];
        self.ropes[block].tension[slot]
    }

    /// Whether a segment broke before the last forces.
    pub fn is_gone(&self, segment: usize) -> bool {
        let Address { block, slot } = self.system.layout().segment_slots()[segment];
        self.ropes[block].is_gone(slot)
    }

    /// Largest tension of each group at the last forces, N; `largest` has shape (groups,).
    pub fn largest_tensions(&self, largest: &mut [f64]) {
        largest.fill(0.0);
        for ropes in &self.ropes {
            // lone nodes are of no group
            if let Some(most) = largest.get_mut(ropes.group) {
                *most = most.max(ropes.max_tension);
            }
        }
    }

    /// The segment of a group that is strained most at the last forces, and its strain; none where none pulls.
    pub fn largest_strain(&self, group: usize) -> Option<(usize, f64)> {
        let blocks = self.ropes.iter().zip(self.system.layout().blocks()).filter(|(ropes, _)| ropes.group == group);
        let strains = blocks.flat_map(|(ropes, plan)| {
            let segments = plan.slots.iter().enumerate().filter(|(slot, _)| !ropes.is_gone(*slot));
            segments.filter_map(|(slot, content)| Some((content.segment?, ropes.strain(slot))))
        });
        strains.max_by(|one, other| one.1.total_cmp(&other.1))
    }
}

/// The net in blocks, as effects see it.
struct Blocks<'s> {
    nodes: &'s [Nodes],
    ropes: &'s [Ropes],
    slots: &'s [Vec<Address>],
    homes: &'s [Address],
}

impl Net for Blocks<'_> {
    #[inline(always)]
    fn node(&self, node: usize) -> Moving {
        let Address { block, slot } = self.homes[node];
        self.nodes[block].moving(slot)
    }

    #[inline(always)]
    fn with_ropes(&self, node: usize, force: DVec3) -> DVec3 {
        self.slots[node].iter().fold(force, |force, at| force + self.ropes[at.block].force_on(at.slot))
    }
}

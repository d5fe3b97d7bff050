//! One step: forces, kick, drift. The fused form of [`crate::time::readable`], equal to it bit for bit.

use glam::DVec3;
use rayon::prelude::*;

use super::StepFactors;
use super::blocks::{Block, advance_nodes, pull_segments};
use crate::layout::Home;
use crate::state::State;
use crate::system::System;

/// Below so many slots a thread spends longer waiting than working, and one thread does all.
pub const LEAST_SLOTS_FOR_THREADS: usize = 20_000;

/// A node that several runs share, or that is held: it is advanced here and copied into the blocks.
#[derive(Debug, Clone, Copy, Default)]
struct Shared {
    x: [f64; 3],
    v: [f64; 3],
    w: [f64; 3],
    mass: f64,
    per_mass: f64,
    held: bool,
    mass_velocity_squared: f64,
}

/// What a step adds up over the whole net.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StepSums {
    /// Work lost inside ropes since the forces before, J.
    pub rope_work: f64,
    /// Power lost to mass-proportional damping at the step before, W.
    pub mass_power: f64,
}

/// A net in motion.
pub struct Stepper<'a> {
    system: &'a System,
    factors: StepFactors,
    gravity: [f64; 3],
    blocks: Vec<Block>,
    shared: Vec<Shared>,
    threads: Option<rayon::ThreadPool>,
}

impl<'a> Stepper<'a> {
    /// Starts from `state` with steps of `dt` seconds, on at most `threads` threads. The result is the same for any
    /// number.
    pub fn new(system: &'a System, state: &State, dt: f64, threads: usize) -> Stepper<'a> {
        let layout = system.layout();
        let mut copies = vec![Vec::new(); layout.blocks().len()];
        for (shared, slots) in layout.copies().iter().enumerate() {
            for &(block, slot) in slots {
                copies[block].push((slot, shared));
            }
        }
        let blocks = layout.blocks().iter().zip(copies).map(|(plan, c)| Block::new(plan, system, c)).collect();
        let shared = layout.shared().iter().map(|&node| {
            let (mass, held) = (system.mass()[node], system.held()[node]);
            Shared { mass, held, per_mass: if held { 0.0 } else { 1.0 / mass }, ..Shared::default() }
        });
        let worth_it = threads > 1 && layout.slot_count() >= LEAST_SLOTS_FOR_THREADS;
        let mut stepper = Stepper {
            system,
            factors: StepFactors::new(dt, system.environment().mass_damping),
            gravity: system.environment().gravity.into(),
            blocks,
            shared: shared.collect(),
            threads: worth_it.then(|| rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()).flatten(),
        };
        stepper.start(state);
        stepper
    }

    /// Sets the state and the half-step velocities before it.
    fn start(&mut self, state: &State) {
        for node in 0..state.position.len() {
            let velocity = if self.system.held()[node] { DVec3::ZERO } else { state.velocity[node] };
            self.put(node, state.position[node].into(), velocity.into(), velocity.into());
        }
        self.forces();
        for node in 0..state.position.len() {
            if !self.system.held()[node] {
                let (v, a) = (state.velocity[node], self.acceleration(node));
                let before = std::array::from_fn(|k| self.factors.before_start(v[k], a[k]));
                self.put(node, state.position[node].into(), before, v.into());
            }
        }
    }

    fn put(&mut self, node: usize, x: [f64; 3], v: [f64; 3], w: [f64; 3]) {
        match self.system.layout().homes()[node] {
            Home::Private { block, slot } => {
                let b = &mut self.blocks[block];
                for k in 0..3 {
                    (b.x[k][slot], b.v[k][slot], b.w[k][slot]) = (x[k], v[k], w[k]);
                }
            }
            Home::Shared(i) => (self.shared[i].x, self.shared[i].v, self.shared[i].w) = (x, v, w),
        }
    }

    /// One whole step. Afterwards positions are those of the next step, velocities half a step behind them, tensions
    /// those of the step just taken.
    pub fn step(&mut self) -> StepSums {
        let (factors, gravity, shared) = (self.factors, self.gravity, &self.shared);
        let dt = factors.dt;
        self.threads.for_each(&mut self.blocks, |block| {
            copy_shared(block, shared);
            pull_segments(block, dt);
            advance_nodes(block, factors, gravity);
        });
        self.advance_shared();
        self.sums()
    }

    /// The first part of [`Stepper::step`]: tensions and forces where the nodes are now, for who wants to look before
    /// going on.
    pub fn forces(&mut self) -> StepSums {
        let (dt, shared) = (self.factors.dt, &self.shared);
        self.threads.for_each(&mut self.blocks, |block| {
            copy_shared(block, shared);
            pull_segments(block, dt);
        });
        self.sums()
    }

    /// The second part of [`Stepper::step`].
    pub fn advance(&mut self) -> StepSums {
        let (factors, gravity) = (self.factors, self.gravity);
        self.threads.for_each(&mut self.blocks, |block| advance_nodes(block, factors, gravity));
        self.advance_shared();
        self.sums()
    }

    /// Kick and drift of the shared nodes, each from the forces in its slots in ascending order.
    fn advance_shared(&mut self) {
        let (factors, gravity, blocks) = (self.factors, self.gravity, &self.blocks);
        for (node, copies) in self.shared.iter_mut().zip(self.system.layout().copies()) {
            if node.held {
                continue;
            }
            let acceleration = shared_acceleration(node, copies, blocks, gravity);
            let mut squares = 0.0;
            for k in 0..3 {
                let before = node.v[k];
                [node.v[k], node.x[k], node.w[k]] = factors.advance(before, node.x[k], acceleration[k]);
                let at_step = 0.5 * (before + node.v[k]);
                squares += at_step * at_step;
            }
            node.mass_velocity_squared = node.mass * squares;
        }
    }

    fn sums(&self) -> StepSums {
        let squares = self.blocks.iter().map(|b| b.sums.mass_velocity_squared).sum::<f64>()
            + self.shared.iter().map(|s| s.mass_velocity_squared).sum::<f64>();
        StepSums {
            rope_work: self.blocks.iter().map(|b| b.sums.rope_work).sum(),
            mass_power: self.system.environment().mass_damping * squares,
        }
    }

    fn acceleration(&self, node: usize) -> [f64; 3] {
        match self.system.layout().homes()[node] {
            Home::Private { block, slot } => {
                let (b, mass) = (&self.blocks[block], self.system.mass()[node]);
                let force = b.slot_force(slot);
                std::array::from_fn(|k| (force[k] + mass * self.gravity[k]) * b.per_mass(slot))
            }
            Home::Shared(i) => {
                shared_acceleration(&self.shared[i], &self.system.layout().copies()[i], &self.blocks, self.gravity)
            }
        }
    }

    /// The system that moves.
    pub fn system(&self) -> &'a System {
        self.system
    }

    /// Step, s.
    pub fn dt(&self) -> f64 {
        self.factors.dt
    }

    /// Position of a node, m.
    pub fn position(&self, node: usize) -> DVec3 {
        match self.system.layout().homes()[node] {
            Home::Private { block, slot } => self.blocks[block].x.each_ref().map(|x| x[slot]).into(),
            Home::Shared(i) => self.shared[i].x.into(),
        }
    }

    /// Velocity of a node half a step before its position, m/s.
    pub fn half_step_velocity(&self, node: usize) -> DVec3 {
        match self.system.layout().homes()[node] {
            Home::Private { block, slot } => self.blocks[block].v.each_ref().map(|v| v[slot]).into(),
            Home::Shared(i) => self.shared[i].v.into(),
        }
    }

    /// Velocity of a node at its position, m/s; only between [`Stepper::forces`] and [`Stepper::advance`].
    pub fn velocity(&self, node: usize) -> DVec3 {
        if self.system.held()[node] {
            return DVec3::ZERO;
        }
        let (before, a) = (self.half_step_velocity(node), self.acceleration(node));
        DVec3::from_array(std::array::from_fn(|k| self.factors.at_step(before[k], a[k])))
    }

    /// Tension of a segment at the last forces, N.
    pub fn tension(&self, segment: usize) -> f64 {
        let (block, slot) = self.system.layout().segment_slots()[segment];
        self.blocks[block].tension[slot]
    }

    /// Largest tension of each class at the last forces, N; `largest` has shape (classes,).
    pub fn largest_tensions(&self, largest: &mut [f64]) {
        largest.fill(0.0);
        for block in &self.blocks {
            let most = &mut largest[block.class];
            *most = most.max(block.sums.max_tension);
        }
    }
}

/// Brings the shared nodes' values into a block's slots.
fn copy_shared(block: &mut Block, shared: &[Shared]) {
    for &(slot, node) in &block.copies {
        let node = &shared[node];
        for k in 0..3 {
            block.x[k][slot] = node.x[k];
            block.w[k][slot] = node.w[k];
        }
    }
}

fn shared_acceleration(node: &Shared, copies: &[(usize, usize)], blocks: &[Block], gravity: [f64; 3]) -> [f64; 3] {
    let mut force = [0.0; 3];
    for &(block, slot) in copies {
        let part = blocks[block].slot_force(slot);
        for k in 0..3 {
            force[k] += part[k];
        }
    }
    std::array::from_fn(|k| (force[k] + node.mass * gravity[k]) * node.per_mass)
}

/// Work over blocks, on a pool where there is one.
trait ForEachBlock {
    fn for_each(&self, blocks: &mut [Block], work: impl Fn(&mut Block) + Sync + Send);
}

impl ForEachBlock for Option<rayon::ThreadPool> {
    fn for_each(&self, blocks: &mut [Block], work: impl Fn(&mut Block) + Sync + Send) {
        match self {
            Some(pool) => pool.install(|| blocks.par_iter_mut().for_each(work)),
            None => blocks.iter_mut().for_each(work),
        }
    }
}

//! A block of slots as arrays: its nodes, its ropes, and what it exchanges with other blocks.
//!
//! Every component of every quantity has an array of its own, padded to whole groups of [`LANES`] slots, so that the
//! loops over them in [`super::passes`] become vector instructions.

use std::ops::Range;

use glam::DVec3;

use super::dragging::Dragging;
use super::rupture::{Failing, Strength};
use crate::forces::law::{Axial, Law, Memory};
use crate::forces::segment::Segment;
use crate::lanes::{Components, LANES, zeros};
use crate::layout::{Address, BlockPlan};
use crate::moving::Moving;
use crate::system::System;

/// The nodes of a block: state, mass, and where they exchange with other slots.
#[derive(Debug, Clone)]
pub(super) struct Nodes {
    pub x: Components,
    /// Half-step velocity.
    pub v: Components,
    /// Velocity extrapolated to the step.
    pub w: Components,
    /// At the home of a knot, the force of its other slots, N; zero elsewhere. With air, at every slot, its drag as well.
    pub elsewhere: Components,
    /// Zero where a node is held or has its home in another slot: the pass over nodes then leaves it alone.
    pub mass: Vec<f64>,
    pub per_mass: Vec<f64>,
    /// Scratch: the terms of a sum over the block, one for each slot.
    pub terms: Vec<f64>,
    /// Sum of m v^2 at the step, J.
    pub mass_velocity_squared: f64,
    exchange: Exchange,
    /// Homes of nodes on which effects may act: slot, node.
    acted_on: Vec<(u32, u32)>,
}

/// The segments of a block: each joins a slot to the next.
#[derive(Debug, Clone)]
pub(super) struct Ropes {
    pub group: usize,
    pub law: Law,
    /// Law state of each slot's segment; empty where the law has none.
    pub memory: Vec<Memory>,
    pub strength: Strength,
    /// Segments that break under the last tensions.
    pub failing: Vec<Failing>,
    /// Force of the segment *before* each slot on its own first node: entry i + 1 belongs to segment i, entry 0 is
    /// zero.
    pub pull: Components,
    pub tension: Vec<f64>,
    /// Length and dissipative force of each segment at the pass before.
    pub length: Vec<f64>,
    pub dissipative: Vec<f64>,
    /// Scratch: the terms of a sum over the block, one for each slot.
    pub terms: Vec<f64>,
    pub rest_length: Vec<f64>,
    pub stiffness: Vec<f64>,
    pub damping: Vec<f64>,
    /// Their drag, if there is any.
    pub dragging: Option<Dragging>,
    /// Largest tension, N.
    pub max_tension: f64,
    /// Work lost inside ropes since the pass before, J.
    pub rope_work: f64,
}

/// Position and extrapolated velocity of a knot, sent from its home to its other slots.
pub(super) type KnotState = [f64; 6];

/// Where a block sends the state of its knots and from where it collects their forces.
#[derive(Debug, Clone, Default)]
struct Exchange {
    /// Homes of knots, ascending: slot, and its part of `others`.
    homes: Vec<(u32, Range<u32>)>,
    /// The other slots of these knots: block and slot.
    others: Vec<(u32, u32)>,
    /// Slots whose home is elsewhere: slot, block of the home, and its place among that block's homes.
    guests: Vec<(u32, u32, u32)>,
}

impl Nodes {
    fn new(plan: &BlockPlan, block: usize, system: &System, exchange: Exchange, is_acted_on: &[bool]) -> Nodes {
        let (filled, padded) = padding(plan);
        let (mut mass, mut acted_on) = (vec![0.0; filled], Vec::new());
        for (i, slot) in plan.slots.iter().enumerate() {
            // a node has mass only in its home, so that it is advanced once
            let is_home = system.layout().homes()[slot.node] == Address { block, slot: i };
            if is_home && !system.held()[slot.node] {
                mass[i] = system.mass()[slot.node];
            }
            if is_home && is_acted_on[slot.node] {
                acted_on.push((i as u32, slot.node as u32));
            }
        }
        Nodes {
            x: zeros(padded),
            v: zeros(padded),
            w: zeros(padded),
            elsewhere: zeros(filled),
            terms: vec![0.0; filled],
            mass_velocity_squared: 0.0,
            per_mass: mass.iter().map(|&m| if m > 0.0 { 1.0 / m } else { 0.0 }).collect(),
            mass,
            exchange,
            acted_on,
        }
    }

    /// Number of knots that have their home here.
    pub fn home_count(&self) -> usize {
        self.exchange.homes.len()
    }

    /// Copies the state of knots into those of their slots that are not their home.
    pub fn receive_knots(&mut self, sent: &[Vec<KnotState>]) {
        let n = self.x[0].len();
        let [x, y, z] = &mut self.x;
        let [u, v, w] = &mut self.w;
        let (x, y, z, u, v, w) = (&mut x[..n], &mut y[..n], &mut z[..n], &mut u[..n], &mut v[..n], &mut w[..n]);
        for &(slot, block, place) in &self.exchange.guests {
            let (slot, state) = (slot as usize, &sent[block as usize][place as usize]);
            [x[slot], y[slot], z[slot], u[slot], v[slot], w[slot]] = *state;
        }
    }

    /// Writes the state of the knots that have their home here to `sent`.
    pub fn send_knots(&self, sent: &mut [KnotState]) {
        let n = self.x[0].len();
        let ([x, y, z], [u, v, w]) = (&self.x, &self.w);
        let (x, y, z, u, v, w) = (&x[..n], &y[..n], &z[..n], &u[..n], &v[..n], &w[..n]);
        for ((slot, _), state) in self.exchange.homes.iter().zip(sent) {
            let slot = *slot as usize;
            *state = [x[slot], y[slot], z[slot], u[slot], v[slot], w[slot]];
        }
    }

    /// Sums into `elsewhere` the forces of knots' other slots, those of effects, N, (nodes,), and the drag of this `block`.
    pub fn collect(&mut self, ropes: &[Ropes], of_effects: &[DVec3], block: usize) {
        match &ropes[block].dragging {
            None => self.collect_at_knots(ropes, of_effects),
            Some(dragging) => {
                // clear first: slots that are not knots would keep the last step's drag
                for force in &mut self.elsewhere {
                    force.fill(0.0);
                }
                self.collect_at_knots(ropes, of_effects);
                dragging.add_to(&mut self.elsewhere);
            }
        }
    }

    fn collect_at_knots(&mut self, ropes: &[Ropes], of_effects: &[DVec3]) {
        let n = self.mass.len();
        let [fx, fy, fz] = &mut self.elsewhere;
        let (fx, fy, fz) = (&mut fx[..n], &mut fy[..n], &mut fz[..n]);
        let alone = self.acted_on.is_empty();
        if !alone {
            // zero at every home, then the forces of effects
            let homes = self.exchange.homes.iter().map(|(home, _)| (*home as usize, DVec3::ZERO));
            let acted_on = self.acted_on.iter().map(|&(slot, node)| (slot as usize, of_effects[node as usize]));
            homes.chain(acted_on).for_each(|(slot, force)| (fx[slot], fy[slot], fz[slot]) = force.into());
        }
        // add the forces of each knot's other slots, in ascending order
        for (home, others) in &self.exchange.homes {
            let at = *home as usize;
            let mut force = if alone { [0.0; 3] } else { [fx[at], fy[at], fz[at]] };
            for &(block, slot) in &self.exchange.others[others.start as usize..others.end as usize] {
                let part = ropes[block as usize].slot_force(slot as usize);
                for k in 0..3 {
                    force[k] += part[k];
                }
            }
            (fx[at], fy[at], fz[at]) = (force[0], force[1], force[2]);
        }
    }

    /// The force of all ropes on the node that has its home in `slot`, N.
    pub fn force(&self, ropes: &Ropes, slot: usize) -> [f64; 3] {
        let own = ropes.pull_on(slot);
        std::array::from_fn(|axis| self.elsewhere[axis][slot] + own[axis])
    }

    /// Position and velocities of the node in `slot`.
    #[inline]
    pub fn moving(&self, slot: usize) -> Moving {
        let vector = |components: &Components| components.each_ref().map(|values| values[slot]).into();
        Moving { x: vector(&self.x), v: vector(&self.v), w: vector(&self.w) }
    }

    /// Writes the state of a node into one of its slots: position, m, half-step and extrapolated velocity, m/s.
    pub fn put(&mut self, slot: usize, x: [f64; 3], v: [f64; 3], w: [f64; 3]) {
        for k in 0..3 {
            (self.x[k][slot], self.v[k][slot], self.w[k][slot]) = (x[k], v[k], w[k]);
        }
    }

    /// Moves the node that has its home in `slot`, and sends its new state to its other slots.
    pub fn carry(&mut self, slot: usize, moving: Moving, sent: &mut [KnotState]) {
        let Moving { x, v, w } = moving;
        self.put(slot, x.into(), v.into(), w.into());
        if let Ok(place) = self.exchange.homes.binary_search_by_key(&(slot as u32), |(home, _)| *home) {
            sent[place] = [x.x, x.y, x.z, w.x, w.y, w.z];
        }
    }

    /// Mass of the node that has its home in `slot`, and its inverse; zero where it is held.
    pub fn mass(&self, slot: usize) -> (f64, f64) {
        (self.mass[slot], self.per_mass[slot])
    }
}

impl Ropes {
    fn new(plan: &BlockPlan, system: &System) -> Ropes {
        let (filled, padded) = padding(plan);
        // one entry for each slot, none where no segment begins
        let segments = plan.slots.iter().map(|slot| slot.segment.map(|segment| &system.segments()[segment]));
        let segments: Vec<_> = segments.chain(std::iter::repeat(None)).take(filled).collect();
        let of_segments = |value: fn(&Axial) -> f64| {
            // between runs there is no segment: one that is never taut
            let axial = |segment: &Option<&Segment>| segment.map_or(Axial::GONE, Axial::from);
            segments.iter().map(|segment| value(&axial(segment))).collect()
        };
        let strengths: Vec<_> = segments.iter().map(|s| s.map(|s| (s.rest_length, s.breaking))).collect();
        // lone nodes are of no group
        let law = system.laws().get(plan.group).cloned().unwrap_or_default();
        let air = system.environment().air.as_ref();
        Ropes {
            group: plan.group,
            memory: if law.remembers() { vec![Memory::default(); filled] } else { Vec::new() },
            law,
            strength: Strength::new(&strengths),
            failing: Vec::new(),
            pull: zeros(padded),
            tension: vec![0.0; filled],
            length: vec![0.0; filled],
            dissipative: vec![0.0; filled],
            terms: vec![0.0; filled],
            dragging: air.and_then(|air| {
                let rope = air.ropes.get(plan.group).copied().flatten()?;
                let rest_length: Vec<_> = segments.iter().map(|segment| segment.map(|s| s.rest_length)).collect();
                Some(Dragging::new(rope, air, &rest_length))
            }),
            rest_length: of_segments(|axial| axial.rest_length),
            stiffness: of_segments(|axial| axial.stiffness),
            damping: of_segments(|axial| axial.damping),
            max_tension: 0.0,
            rope_work: 0.0,
        }
    }

    /// Strain of a slot's segment at the last forces.
    pub fn strain(&self, slot: usize) -> f64 {
        (self.length[slot] - self.rest_length[slot]) / self.rest_length[slot]
    }

    /// Force of a slot's two segments on it, their drag included, N.
    #[inline]
    pub fn force_on(&self, slot: usize) -> DVec3 {
        self.slot_force(slot).into()
    }

    /// Removes the segments that broke at the forces before, if nodes have `moved` since then.
    pub fn remove_failed(&mut self, moved: bool) {
        for Failing { slot, .. } in std::mem::take(&mut self.failing) {
            if moved {
                self.remove(slot);
            }
        }
    }

    /// Removes the segment of this slot.
    pub fn remove(&mut self, slot: usize) {
        let Axial { rest_length, stiffness, damping } = Axial::GONE;
        (self.rest_length[slot], self.stiffness[slot], self.damping[slot]) = (rest_length, stiffness, damping);
        if let Some(dragging) = &mut self.dragging {
            dragging.remove(slot);
        }
        self.strength.remove(slot);
    }

    /// Finds the segments that break at this time, s, under the tensions just computed. A block that does not break pays two
    /// comparisons a step.
    pub fn break_now(&mut self, time: f64) {
        if self.strength.holds(time, self.max_tension) {
            return;
        }
        for slot in self.strength.exceeded(time, &self.tension, &self.length).collect::<Vec<_>>() {
            let (axial, memory) = (self.axial(slot), self.memory.get(slot).copied().unwrap_or_default());
            let energy = self.law.elastic_energy(self.length[slot] - axial.rest_length, &axial, &memory);
            self.failing.push(Failing { slot, tension: self.tension[slot], energy });
            // the work of its last tension is lost, so all of that tension is dissipative
            self.dissipative[slot] = self.tension[slot];
        }
    }

    /// Whether the segment of this slot is gone.
    pub fn is_gone(&self, slot: usize) -> bool {
        self.rest_length[slot] == Axial::GONE.rest_length
    }

    /// Rest length, stiffness and damping of a slot's segment.
    pub fn axial(&self, slot: usize) -> Axial {
        let (rest_length, stiffness, damping) = (self.rest_length[slot], self.stiffness[slot], self.damping[slot]);
        Axial { rest_length, stiffness, damping }
    }

    /// The force of a slot's two segments on it, their drag included, N.
    #[inline(always)]
    fn slot_force(&self, slot: usize) -> [f64; 3] {
        let pull = self.pull_on(slot);
        match &self.dragging {
            None => pull,
            Some(dragging) => {
                let drag = dragging.slot_force(slot);
                std::array::from_fn(|k| pull[k] + drag[k])
            }
        }
    }

    /// The tensions of a slot's two segments on it, N.
    #[inline(always)]
    fn pull_on(&self, slot: usize) -> [f64; 3] {
        let n = self.pull[0].len();
        let [x, y, z] = &self.pull;
        let (x, y, z) = (&x[..n], &y[..n], &z[..n]);
        [x[slot + 1] - x[slot], y[slot + 1] - y[slot], z[slot + 1] - z[slot]]
    }
}

/// Nodes and ropes of every block of a system. `acted_on`, (nodes,): whether effects may act on a node.
pub(super) fn blocks(system: &System, acted_on: &[bool]) -> (Vec<Nodes>, Vec<Ropes>) {
    let layout = system.layout();
    let mut exchanges = vec![Exchange::default(); layout.blocks().len()];
    // tell the home of each knot about its other slots, and these about the home
    for slots in layout.knots() {
        let (home, others) = slots.split_last().expect("a knot has slots");
        let place = exchanges[home.block].homes.len() as u32;
        let at_home = &mut exchanges[home.block];
        let first = at_home.others.len() as u32;
        at_home.others.extend(others.iter().map(|other| (other.block as u32, other.slot as u32)));
        at_home.homes.push((home.slot as u32, first..at_home.others.len() as u32));
        for other in others {
            exchanges[other.block].guests.push((other.slot as u32, home.block as u32, place));
        }
    }
    let plans = layout.blocks().iter().enumerate().zip(exchanges);
    let nodes = plans.map(|((block, plan), exchange)| Nodes::new(plan, block, system, exchange, acted_on)).collect();
    (nodes, layout.blocks().iter().map(|plan| Ropes::new(plan, system)).collect())
}

/// Slots of a block filled up to whole groups of [`LANES`], and with one group more.
fn padding(plan: &BlockPlan) -> (usize, usize) {
    let groups = plan.slots.len().div_ceil(LANES);
    (groups * LANES, (groups + 1) * LANES)
}

//! A block of slots as arrays, and the two loops that run over it. All that is hot is here.
//!
//! Every component of every quantity has an array of its own, padded to whole groups of [`LANES`] slots. The loops
//! have no branches, so that the compiler turns them into vector instructions; which ones is chosen when the program
//! runs. Neither wider vectors nor threads change a bit: sums run in [`LANES`] interleaved parts whatever the width,
//! and multiplications and additions are never contracted.

use std::ops::Range;

use glam::DVec3;

use super::attached::Moving;
use super::dragging::{Breeze, Dragging, drag_pass, meet_pass};
use super::rupture::{Failing, Strength};
use crate::forces::law::{Axial, Law, Memory};
use crate::forces::rope_tension::{self, LANES, sum_lanes};
use crate::layout::{Address, BlockPlan};
use crate::system::{Segment, System};
use crate::time::StepFactors;

/// One value a slot for each of x, y, z.
pub(super) type Components = [Vec<f64>; 3];

/// The nodes of a block: state, mass, and where they exchange with other slots.
#[derive(Debug, Clone)]
pub(super) struct Nodes {
    pub x: Components,
    /// Half-step velocity.
    pub v: Components,
    /// Velocity extrapolated to the step.
    pub w: Components,
    /// At the home of a knot, the force of its other slots, N; zero elsewhere. With air, at every slot, its drag as well.
    elsewhere: Components,
    /// Zero where a node is held or has its home in another slot: the pass over nodes then leaves it alone.
    mass: Vec<f64>,
    per_mass: Vec<f64>,
    /// Scratch: one term a slot of what is summed.
    each: Vec<f64>,
    /// Sum of m v^2 at the step, J.
    pub mass_velocity_squared: f64,
    exchange: Exchange,
    /// Homes of nodes on which something beside ropes may act: slot and node.
    attached: Vec<(u32, u32)>,
}

/// The segments of a block: each joins a slot to the next.
#[derive(Debug, Clone)]
pub(super) struct Ropes {
    pub class: usize,
    pub law: Law,
    /// Of each slot's segment; none where the law does not remember.
    pub memory: Vec<Memory>,
    pub strength: Strength,
    /// What breaks under the last tensions.
    pub failing: Vec<Failing>,
    /// Force of the segment *before* each slot on its own first node: entry i + 1 belongs to segment i, entry 0 is
    /// zero.
    pub pull: Components,
    pub tension: Vec<f64>,
    /// Length and friction of each segment at the pass before.
    pub length: Vec<f64>,
    pub friction: Vec<f64>,
    /// Scratch: one term a slot of what is summed.
    pub each: Vec<f64>,
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

/// Position and extrapolated velocity of a knot, as its other slots get it.
pub(super) type Told = [f64; 6];

/// What a block exchanges with others and within itself, knot by knot.
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
    fn new(plan: &BlockPlan, block: usize, system: &System, exchange: Exchange, touched: &[bool]) -> Nodes {
        let (filled, padded) = padding(plan);
        let (mut mass, mut attached) = (vec![0.0; filled], Vec::new());
        for (i, slot) in plan.slots.iter().enumerate() {
            let at_home = system.layout().homes()[slot.node] == Address { block, slot: i };
            if at_home && !system.held()[slot.node] {
                mass[i] = system.mass()[slot.node];
            }
            if at_home && touched[slot.node] {
                attached.push((i as u32, slot.node as u32));
            }
        }
        Nodes {
            x: zeros(padded),
            v: zeros(padded),
            w: zeros(padded),
            elsewhere: zeros(filled),
            each: vec![0.0; filled],
            mass_velocity_squared: 0.0,
            per_mass: mass.iter().map(|&m| if m > 0.0 { 1.0 / m } else { 0.0 }).collect(),
            mass,
            exchange,
            attached,
        }
    }

    /// Number of knots that have their home here.
    pub fn home_count(&self) -> usize {
        self.exchange.homes.len()
    }

    /// Brings what knots were told into the slots that are not their home.
    pub fn hear(&mut self, told: &[Vec<Told>]) {
        let n = self.x[0].len();
        let [x, y, z] = &mut self.x;
        let [u, v, w] = &mut self.w;
        let (x, y, z, u, v, w) = (&mut x[..n], &mut y[..n], &mut z[..n], &mut u[..n], &mut v[..n], &mut w[..n]);
        for &(slot, block, place) in &self.exchange.guests {
            let (slot, told) = (slot as usize, &told[block as usize][place as usize]);
            [x[slot], y[slot], z[slot], u[slot], v[slot], w[slot]] = *told;
        }
    }

    /// Tells the values of the knots that have their home here.
    pub fn tell(&self, told: &mut [Told]) {
        let n = self.x[0].len();
        let ([x, y, z], [u, v, w]) = (&self.x, &self.w);
        let (x, y, z, u, v, w) = (&x[..n], &y[..n], &z[..n], &u[..n], &v[..n], &w[..n]);
        for ((slot, _), told) in self.exchange.homes.iter().zip(told) {
            let slot = *slot as usize;
            *told = [x[slot], y[slot], z[slot], u[slot], v[slot], w[slot]];
        }
    }

    /// Collects at their homes the forces of knots' other slots, those `attached` to nodes, N, (nodes,), and of the
    /// drag of this `block`.
    pub fn collect(&mut self, ropes: &[Ropes], attached: &[DVec3], block: usize) {
        match &ropes[block].dragging {
            None => self.collect_at_knots(ropes, attached),
            Some(dragging) => {
                // what was added at the slots that are no knots stays there else
                self.elsewhere.iter_mut().for_each(|force| force.fill(0.0));
                self.collect_at_knots(ropes, attached);
                dragging.add_to(&mut self.elsewhere);
            }
        }
    }

    fn collect_at_knots(&mut self, ropes: &[Ropes], attached: &[DVec3]) {
        let n = self.mass.len();
        let [fx, fy, fz] = &mut self.elsewhere;
        let (fx, fy, fz) = (&mut fx[..n], &mut fy[..n], &mut fz[..n]);
        let alone = self.attached.is_empty();
        if !alone {
            let homes = self.exchange.homes.iter().map(|(home, _)| (*home as usize, DVec3::ZERO));
            let attached = self.attached.iter().map(|&(slot, node)| (slot as usize, attached[node as usize]));
            homes.chain(attached).for_each(|(slot, force)| (fx[slot], fy[slot], fz[slot]) = force.into());
        }
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

    /// How the node in `slot` moves.
    pub fn moving(&self, slot: usize) -> Moving {
        let of = |components: &Components| components.each_ref().map(|values| values[slot]).into();
        Moving { x: of(&self.x), v: of(&self.v), w: of(&self.w) }
    }

    /// Puts the node that has its home in `slot` somewhere else, and tells its other slots.
    pub fn carry(&mut self, slot: usize, moving: Moving, told: &mut [Told]) {
        let Moving { x, v, w } = moving;
        for k in 0..3 {
            (self.x[k][slot], self.v[k][slot], self.w[k][slot]) = (x[k], v[k], w[k]);
        }
        if let Ok(place) = self.exchange.homes.binary_search_by_key(&(slot as u32), |(home, _)| *home) {
            told[place] = [x.x, x.y, x.z, w.x, w.y, w.z];
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
        let segments = plan.slots.iter().map(|slot| slot.segment.map(|segment| &system.segments()[segment]));
        let segments: Vec<_> = segments.chain(std::iter::repeat(None)).take(filled).collect();
        let of_segments = |value: fn(&Axial) -> f64| {
            // between runs there is no segment: one that is never taut
            let axial = |segment: &Option<&Segment>| segment.map_or(Axial::GONE, Axial::from);
            segments.iter().map(|segment| value(&axial(segment))).collect()
        };
        let strengths: Vec<_> = segments.iter().map(|s| s.map(|s| (s.rest_length, s.breaking))).collect();
        // lone nodes are of no class
        let law = system.laws().get(plan.class).cloned().unwrap_or_default();
        let air = system.environment().air.as_ref();
        Ropes {
            class: plan.class,
            memory: if law.remembers() { vec![Memory::default(); filled] } else { Vec::new() },
            law,
            strength: Strength::new(&strengths),
            failing: Vec::new(),
            pull: zeros(padded),
            tension: vec![0.0; filled],
            length: vec![0.0; filled],
            friction: vec![0.0; filled],
            each: vec![0.0; filled],
            dragging: air.and_then(|air| {
                let rope = air.ropes.get(plan.class).copied().flatten()?;
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

    /// The same as a vector.
    pub fn force_on(&self, slot: usize) -> DVec3 {
        self.slot_force(slot).into()
    }

    /// Tensions, pulls and drag of all segments, `dt` being the step, s; `moved`, whether one has passed since the
    /// forces before.
    pub fn forces(&mut self, nodes: &Nodes, vectors: Vectors, dt: f64, moved: bool, breeze: Option<Breeze>) {
        self.let_go(moved);
        if let Some(breeze) = breeze {
            self.drag(nodes, vectors, breeze);
        }
        match self.law {
            Law::Linear => vectors.pull_segments(nodes, self, dt),
            _ => self.pull_by_law(nodes, dt, moved),
        }
        self.yield_to_loads();
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

/// The blocks of a system, in which something beside ropes may act on the nodes that are `touched`.
pub(super) fn blocks(system: &System, touched: &[usize]) -> (Vec<Nodes>, Vec<Ropes>) {
    let layout = system.layout();
    let mut exchanges = vec![Exchange::default(); layout.blocks().len()];
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
    let mut is_touched = vec![false; system.mass().len()];
    touched.iter().for_each(|&node| is_touched[node] = true);
    let plans = layout.blocks().iter().enumerate().zip(exchanges);
    let nodes = plans.map(|((block, plan), exchange)| Nodes::new(plan, block, system, exchange, &is_touched)).collect();
    (nodes, layout.blocks().iter().map(|plan| Ropes::new(plan, system)).collect())
}

/// Slots of a block filled up to whole groups of [`LANES`], and with one group more.
fn padding(plan: &BlockPlan) -> (usize, usize) {
    let groups = plan.slots.len().div_ceil(LANES);
    (groups * LANES, (groups + 1) * LANES)
}

pub(super) fn zeros(length: usize) -> Components {
    std::array::from_fn(|_| vec![0.0; length])
}

/// Tensions and pulls of all segments of the block from `x` and `w`.
#[inline(always)]
fn pull_pass(nodes: &Nodes, ropes: &mut Ropes, dt: f64) {
    let Nodes { x, w, .. } = nodes;
    let Ropes { pull, tension, length, friction, each, rest_length, stiffness, damping, .. } = ropes;
    let [px, py, pz] = pull;
    pull_each(
        [&x[0], &x[1], &x[2]],
        [&w[0], &w[1], &w[2]],
        [rest_length, stiffness, damping],
        &mut px[1..],
        &mut py[1..],
        &mut pz[1..],
        tension,
        length,
        friction,
        each,
        dt,
    );
    ropes.rope_work = sum(&ropes.each);
    ropes.max_tension = max(&ropes.tension);
}

/// The loop of [`pull_pass`]. Each array that is written is an argument of its own: only so does the compiler
/// know that they do not overlap, without which there are no vectors.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn pull_each(
    [x, y, z]: [&[f64]; 3],
    [u, v, w]: [&[f64]; 3],
    [rest_length, stiffness, damping]: [&[f64]; 3],
    px: &mut [f64],
    py: &mut [f64],
    pz: &mut [f64],
    tension: &mut [f64],
    length: &mut [f64],
    friction: &mut [f64],
    work: &mut [f64],
    dt: f64,
) {
    // slices of known length: no bounds are checked inside the loop
    let n = tension.len();
    let (x0, y0, z0, x1, y1, z1) = (&x[..n], &y[..n], &z[..n], &x[1..n + 1], &y[1..n + 1], &z[1..n + 1]);
    let (u0, v0, w0, u1, v1, w1) = (&u[..n], &v[..n], &w[..n], &u[1..n + 1], &v[1..n + 1], &w[1..n + 1]);
    let (rest_length, stiffness, damping) = (&rest_length[..n], &stiffness[..n], &damping[..n]);
    let (px, py, pz) = (&mut px[..n], &mut py[..n], &mut pz[..n]);
    let (length, friction, work) = (&mut length[..n], &mut friction[..n], &mut work[..n]);
    for i in 0..n {
        let span = [x1[i] - x0[i], y1[i] - y0[i], z1[i] - z0[i]];
        let rate = [u1[i] - u0[i], v1[i] - v0[i], w1[i] - w0[i]];
        let p = rope_tension::pull(span, rate, rest_length[i], stiffness[i], damping[i], dt);
        work[i] = rope_tension::friction_work(length[i], friction[i], &p);
        (tension[i], length[i], friction[i]) = (p.tension, p.length, p.friction);
        (px[i], py[i], pz[i]) = (p.force[0], p.force[1], p.force[2]);
    }
}

/// Kick and drift of all nodes that have their home in the block. Slots without a home stay, and are written anew before
/// they are read.
#[inline(always)]
fn advance_pass(nodes: &mut Nodes, ropes: &Ropes, factors: StepFactors, gravity: [f64; 3]) {
    let Nodes { x, v, w, elsewhere, mass, per_mass, each, .. } = nodes;
    let ([x, y, z], [vx, vy, vz], [wx, wy, wz]) = (x, v, w);
    let masses = [&mass[..], &per_mass[..]];
    let [px, py, pz] = &ropes.pull;
    let [ex, ey, ez] = &*elsewhere;
    // without mass damping nobody asks for m v^2, which costs a sixth of the pass
    match factors.p == 1.0 {
        true => {
            advance_each::<NOT>([px, ex], masses, factors, gravity[0], x, vx, wx, each);
            advance_each::<NOT>([py, ey], masses, factors, gravity[1], y, vy, wy, each);
            advance_each::<NOT>([pz, ez], masses, factors, gravity[2], z, vz, wz, each);
        }
        false => {
            advance_each::<SET>([px, ex], masses, factors, gravity[0], x, vx, wx, each);
            advance_each::<ADD>([py, ey], masses, factors, gravity[1], y, vy, wy, each);
            advance_each::<ADD>([pz, ez], masses, factors, gravity[2], z, vz, wz, each);
            nodes.mass_velocity_squared = sum(&nodes.each);
        }
    }
}

/// What [`advance_each`] does with m v^2 of its axis.
const NOT: u8 = 0;
const SET: u8 = 1;
const ADD: u8 = 2;

/// The loop of [`advance_pass`] for one axis; what is written is apart, as in [`pull_each`].
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn advance_each<const SQUARES: u8>(
    [pull, elsewhere]: [&[f64]; 2],
    [mass, per_mass]: [&[f64]; 2],
    factors: StepFactors,
    gravity: f64,
    x: &mut [f64],
    v: &mut [f64],
    w: &mut [f64],
    squares: &mut [f64],
) {
    let n = squares.len();
    let (before, after, elsewhere) = (&pull[..n], &pull[1..n + 1], &elsewhere[..n]);
    let (mass, per_mass) = (&mass[..n], &per_mass[..n]);
    let (x, v, w) = (&mut x[..n], &mut v[..n], &mut w[..n]);
    for i in 0..n {
        let force = (elsewhere[i] + (after[i] - before[i])) + mass[i] * gravity;
        let last = v[i];
        [v[i], x[i], w[i]] = factors.advance(last, x[i], force * per_mass[i]);
        if SQUARES != NOT {
            let at_step = 0.5 * (last + v[i]);
            let square = mass[i] * (at_step * at_step);
            squares[i] = if SQUARES == SET { square } else { squares[i] + square };
        }
    }
}

/// The widest vectors that the passes over blocks may use. All give the same bits; the machine decides which of them it
/// has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Vectors {
    /// Whatever the machine has.
    #[default]
    Widest,
    /// At most AVX2: 256 bits.
    Avx2,
    /// At most AVX: 256 bits.
    Avx,
    /// What every machine of its kind has; on x86-64, SSE2: 128 bits.
    Baseline,
}

impl Vectors {
    /// Every choice.
    pub const ALL: [Vectors; 4] = [Vectors::Widest, Vectors::Avx2, Vectors::Avx, Vectors::Baseline];

    /// Their width on this machine, bits.
    pub fn bits(self) -> u32 {
        #[cfg(target_arch = "x86_64")]
        {
            let avx512 = is_x86_feature_detected!("avx512f")
                && is_x86_feature_detected!("avx512vl")
                && is_x86_feature_detected!("avx512dq");
            if self == Vectors::Widest && avx512 {
                return 512;
            }
            if self != Vectors::Baseline && is_x86_feature_detected!("avx") {
                return 256;
            }
        }
        128
    }

    /// Tensions and pulls of all segments of a block.
    fn pull_segments(self, nodes: &Nodes, ropes: &mut Ropes, dt: f64) {
        match self {
            Vectors::Widest => widest::pull_segments(nodes, ropes, dt),
            Vectors::Avx2 => avx2::pull_segments(nodes, ropes, dt),
            Vectors::Avx => avx::pull_segments(nodes, ropes, dt),
            Vectors::Baseline => pull_pass(nodes, ropes, dt),
        }
    }

    /// What the segments of a block meet of the wind.
    pub(super) fn meet_wind(self, nodes: &Nodes, dragging: &mut Dragging, breeze: Breeze) {
        match self {
            Vectors::Widest => widest::meet_wind(nodes, dragging, breeze),
            Vectors::Avx2 => avx2::meet_wind(nodes, dragging, breeze),
            Vectors::Avx => avx::meet_wind(nodes, dragging, breeze),
            Vectors::Baseline => meet_pass(nodes, dragging, breeze),
        }
    }

    /// Drag of all segments of a block.
    pub(super) fn drag_segments(self, nodes: &Nodes, dragging: &mut Dragging, breeze: Breeze) {
        match self {
            Vectors::Widest => widest::drag_segments(nodes, dragging, breeze),
            Vectors::Avx2 => avx2::drag_segments(nodes, dragging, breeze),
            Vectors::Avx => avx::drag_segments(nodes, dragging, breeze),
            Vectors::Baseline => drag_pass(nodes, dragging, breeze),
        }
    }

    /// Kick and drift of all nodes that have their home in a block.
    pub(super) fn advance_nodes(self, nodes: &mut Nodes, ropes: &Ropes, factors: StepFactors, gravity: [f64; 3]) {
        match self {
            Vectors::Widest => widest::advance_nodes(nodes, ropes, factors, gravity),
            Vectors::Avx2 => avx2::advance_nodes(nodes, ropes, factors, gravity),
            Vectors::Avx => avx::advance_nodes(nodes, ropes, factors, gravity),
            Vectors::Baseline => advance_pass(nodes, ropes, factors, gravity),
        }
    }
}

/// The passes, compiled for each of some targets and for the baseline; which one runs is chosen on the machine.
macro_rules! passes {
    ($module:ident: $($target:literal),*) => {
        mod $module {
            use multiversion::multiversion;

            use super::{Breeze, Dragging, Nodes, Ropes, StepFactors};

            #[multiversion(targets($($target),*))]
            pub fn pull_segments(nodes: &Nodes, ropes: &mut Ropes, dt: f64) {
                super::pull_pass(nodes, ropes, dt);
            }

            #[multiversion(targets($($target),*))]
            pub fn meet_wind(nodes: &Nodes, dragging: &mut Dragging, breeze: Breeze) {
                super::meet_pass(nodes, dragging, breeze);
            }

            #[multiversion(targets($($target),*))]
            pub fn drag_segments(nodes: &Nodes, dragging: &mut Dragging, breeze: Breeze) {
                super::drag_pass(nodes, dragging, breeze);
            }

            #[multiversion(targets($($target),*))]
            pub fn advance_nodes(nodes: &mut Nodes, ropes: &Ropes, factors: StepFactors, gravity: [f64; 3]) {
                super::advance_pass(nodes, ropes, factors, gravity);
            }
        }
    };
}

passes!(widest: "x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2", "x86_64+avx");
passes!(avx2: "x86_64+avx2");
passes!(avx: "x86_64+avx");

/// Sum over a block, in [`LANES`] interleaved parts.
#[inline(always)]
pub(super) fn sum(values: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for group in values.chunks_exact(LANES) {
        for l in 0..LANES {
            lanes[l] += group[l];
        }
    }
    sum_lanes(lanes)
}

/// Largest of a block; at least zero.
#[inline(always)]
pub(super) fn max(values: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for group in values.chunks_exact(LANES) {
        for l in 0..LANES {
            lanes[l] = if group[l] > lanes[l] { group[l] } else { lanes[l] };
        }
    }
    lanes.into_iter().fold(0.0, f64::max)
}

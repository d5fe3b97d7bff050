//! A block of slots as arrays, and the two loops that run over it. All that is hot is here.
//!
//! Every component of every quantity has an array of its own, padded to whole groups of [`LANES`] slots. The loops
//! have no branches, so that the compiler turns them into vector instructions; which ones is chosen when the program
//! runs. Neither wider vectors nor threads change a bit: sums run in [`LANES`] interleaved parts whatever the width,
//! and multiplications and additions are never contracted.

use multiversion::multiversion;

use crate::forces::rope_tension::{self, LANES, sum_lanes};
use crate::layout::BlockPlan;
use crate::system::System;
use crate::time::StepFactors;

/// One value a slot for each of x, y, z.
pub(super) type Components = [Vec<f64>; 3];

/// What a pass over a block adds up.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct BlockSums {
    /// Largest tension, N.
    pub max_tension: f64,
    /// Work lost inside ropes since the pass before, J.
    pub rope_work: f64,
    /// Sum of m v^2 over private nodes at the step, J.
    pub mass_velocity_squared: f64,
}

/// Slots of one class: state, segments and scratch.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub class: usize,
    /// (slot, shared node) of the copies in this block.
    pub copies: Vec<(usize, usize)>,
    pub x: Components,
    /// Half-step velocity.
    pub v: Components,
    /// Velocity extrapolated to the step.
    pub w: Components,
    /// Force of the segment *before* each slot on its own first node: entry i + 1 belongs to segment i, entry 0 is
    /// zero.
    pub pull: Components,
    pub tension: Vec<f64>,
    /// Length and friction of each segment at the pass before.
    length: Vec<f64>,
    friction: Vec<f64>,
    /// Scratch: one term a slot of whatever is summed next.
    each: Vec<f64>,
    pub sums: BlockSums,
    rest_length: Vec<f64>,
    stiffness: Vec<f64>,
    damping: Vec<f64>,
    /// Zero for copies, which makes the node pass leave them alone.
    mass: Vec<f64>,
    per_mass: Vec<f64>,
}

impl Block {
    pub fn new(plan: &BlockPlan, system: &System, copies: Vec<(usize, usize)>) -> Block {
        let groups = plan.slots.len().div_ceil(LANES);
        let (filled, padded) = (groups * LANES, (groups + 1) * LANES);
        let zeros = || std::array::from_fn(|_| vec![0.0; padded]);
        let of_segments = |value: fn(&crate::system::Segment) -> f64, none: f64| {
            let mut values = vec![none; filled];
            for (i, slot) in plan.slots.iter().enumerate() {
                if let Some(s) = slot.segment {
                    values[i] = value(&system.segments()[s]);
                }
            }
            values
        };
        let mut mass = vec![0.0; filled];
        for (i, slot) in plan.slots.iter().enumerate() {
            mass[i] = system.mass()[slot.node];
        }
        for &(slot, _) in &copies {
            mass[slot] = 0.0;
        }
        Block {
            class: plan.class,
            copies,
            x: zeros(),
            v: zeros(),
            w: zeros(),
            pull: zeros(),
            tension: vec![0.0; filled],
            length: vec![0.0; filled],
            friction: vec![0.0; filled],
            each: vec![0.0; filled],
            sums: BlockSums::default(),
            // between runs there is no segment: one that is never taut
            rest_length: of_segments(|s| s.rest_length, f64::MAX),
            stiffness: of_segments(|s| s.stiffness, 0.0),
            damping: of_segments(|s| s.damping, 0.0),
            per_mass: mass.iter().map(|&m| if m > 0.0 { 1.0 / m } else { 0.0 }).collect(),
            mass,
        }
    }

    /// The force of this slot's two segments on it, N.
    #[inline(always)]
    pub fn slot_force(&self, slot: usize) -> [f64; 3] {
        std::array::from_fn(|axis| self.pull[axis][slot + 1] - self.pull[axis][slot])
    }

    /// 1/m of a slot; zero for copies.
    pub fn per_mass(&self, slot: usize) -> f64 {
        self.per_mass[slot]
    }
}

/// Tensions and pulls of all segments of the block from `x` and `w`.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2", "x86_64+avx"))]
pub(super) fn pull_segments(block: &mut Block, dt: f64) {
    let Block { x, w, pull, tension, length, friction, each, rest_length, stiffness, damping, .. } = block;
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
    block.sums.rope_work = sum(&block.each);
    block.sums.max_tension = max(&block.tension);
}

/// The loop of [`pull_segments`]. Each array that is written is an argument of its own: only so does the compiler
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

/// Kick and drift of all private nodes of the block. Copies of shared nodes come out wrong and are written anew
/// before they are read.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512dq", "x86_64+avx2", "x86_64+avx"))]
pub(super) fn advance_nodes(block: &mut Block, factors: StepFactors, gravity: [f64; 3]) {
    let n = block.mass.len();
    let Block { x, v, w, pull, mass, per_mass, each, .. } = block;
    let (mass, per_mass, squares) = (&mass[..n], &per_mass[..n], &mut each[..n]);
    squares.fill(0.0);
    for axis in 0..3 {
        let (before, after) = (&pull[axis][..n], &pull[axis][1..n + 1]);
        let (x, v, w) = (&mut x[axis][..n], &mut v[axis][..n], &mut w[axis][..n]);
        for i in 0..n {
            let force = (after[i] - before[i]) + mass[i] * gravity[axis];
            let last = v[i];
            [v[i], x[i], w[i]] = factors.advance(last, x[i], force * per_mass[i]);
            let at_step = 0.5 * (last + v[i]);
            squares[i] += mass[i] * (at_step * at_step);
        }
    }
    block.sums.mass_velocity_squared = sum(&block.each);
}

/// Sum over a block, in [`LANES`] interleaved parts.
#[inline(always)]
fn sum(values: &[f64]) -> f64 {
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
fn max(values: &[f64]) -> f64 {
    let mut lanes = [0.0; LANES];
    for group in values.chunks_exact(LANES) {
        for l in 0..LANES {
            lanes[l] = if group[l] > lanes[l] { group[l] } else { lanes[l] };
        }
    }
    lanes.into_iter().fold(0.0, f64::max)
}

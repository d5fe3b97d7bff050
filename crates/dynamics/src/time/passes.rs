//! The loops over a block, in which a run spends most of its time.
//!
//! They have no branches, so that the compiler turns them into vector instructions; which ones is chosen when the program
//! runs. Neither wider vectors nor threads change a bit: sums run in [`LANES`](crate::lanes::LANES) interleaved parts
//! whatever the width, and multiplications and additions are never contracted.

use super::blocks::{Nodes, Ropes};
pub(super) use super::dragging::AirNow;
use super::dragging::{Dragging, drag_pass, meet_pass};
use crate::forces::law::Law;
use crate::forces::rope_tension;
use crate::lanes::{max, sum};
use crate::moving::StepFactors;

impl Ropes {
    /// Tensions, pulls and drag of all segments at `time`, s, `dt` being the step, s; `moved`, whether one has passed since
    /// the forces before.
    pub fn forces(
        &mut self,
        nodes: &Nodes,
        vectors: Vectors,
        time: f64,
        dt: f64,
        moved: bool,
        air_now: Option<AirNow>,
    ) {
        // segments that broke before, drag, tension, segments that break now
        self.remove_failed(moved);
        if let Some(air_now) = air_now {
            self.drag(nodes, vectors, air_now);
        }
        match self.law {
            Law::Linear => vectors.pull_segments(nodes, self, dt),
            _ => self.pull_by_law(nodes, dt, moved),
        }
        self.break_now(time);
    }

    /// The drag of all segments of the block.
    fn drag(&mut self, nodes: &Nodes, vectors: Vectors, air_now: AirNow) {
        let Some(dragging) = &mut self.dragging else { return };
        dragging.find_wind(&nodes.x, air_now.air);
        if dragging.goes_by_reynolds() {
            vectors.meet_wind(nodes, dragging, air_now);
            dragging.find_others();
        } else {
            dragging.set_coefficient();
            vectors.meet_wind(nodes, dragging, air_now);
        }
        vectors.drag_segments(nodes, dragging, air_now);
    }
}

/// Tensions and pulls of all segments of the block from `x` and `w`.
#[inline(always)]
fn pull_pass(nodes: &Nodes, ropes: &mut Ropes, dt: f64) {
    let Nodes { x, w, .. } = nodes;
    let Ropes { pull, tension, length, dissipative, terms, rest_length, stiffness, damping, .. } = ropes;
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
        dissipative,
        terms,
        dt,
    );
    ropes.rope_work = sum(&ropes.terms);
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
    dissipative: &mut [f64],
    work: &mut [f64],
    dt: f64,
) {
    // slices of known length: no bounds are checked inside the loop
    let n = tension.len();
    let (x0, y0, z0, x1, y1, z1) = (&x[..n], &y[..n], &z[..n], &x[1..n + 1], &y[1..n + 1], &z[1..n + 1]);
    let (u0, v0, w0, u1, v1, w1) = (&u[..n], &v[..n], &w[..n], &u[1..n + 1], &v[1..n + 1], &w[1..n + 1]);
    let (rest_length, stiffness, damping) = (&rest_length[..n], &stiffness[..n], &damping[..n]);
    let (px, py, pz) = (&mut px[..n], &mut py[..n], &mut pz[..n]);
    let (length, dissipative, work) = (&mut length[..n], &mut dissipative[..n], &mut work[..n]);
    for i in 0..n {
        let span = [x1[i] - x0[i], y1[i] - y0[i], z1[i] - z0[i]];
        let rate = [u1[i] - u0[i], v1[i] - v0[i], w1[i] - w0[i]];
        let p = rope_tension::pull(span, rate, rest_length[i], stiffness[i], damping[i], dt);
        work[i] = rope_tension::dissipative_work(length[i], dissipative[i], &p);
        (tension[i], length[i], dissipative[i]) = (p.tension, p.length, p.dissipative);
        (px[i], py[i], pz[i]) = (p.force[0], p.force[1], p.force[2]);
    }
}

/// Kick and drift of all nodes that have their home in the block. Slots without a home stay, and are written anew before
/// they are read.
#[inline(always)]
fn advance_pass(nodes: &mut Nodes, ropes: &Ropes, factors: StepFactors, gravity: [f64; 3]) {
    let Nodes { x, v, w, elsewhere, mass, per_mass, terms, .. } = nodes;
    let ([x, y, z], [vx, vy, vz], [wx, wy, wz]) = (x, v, w);
    let masses = [&mass[..], &per_mass[..]];
    let [px, py, pz] = &ropes.pull;
    let [ex, ey, ez] = &*elsewhere;
    // without mass damping nobody asks for m v^2, which costs a sixth of the pass
    if factors.p == 1.0 {
        advance_each::<NOT>([px, ex], masses, factors, gravity[0], x, vx, wx, terms);
        advance_each::<NOT>([py, ey], masses, factors, gravity[1], y, vy, wy, terms);
        advance_each::<NOT>([pz, ez], masses, factors, gravity[2], z, vz, wz, terms);
    } else {
        advance_each::<SET>([px, ex], masses, factors, gravity[0], x, vx, wx, terms);
        advance_each::<ADD>([py, ey], masses, factors, gravity[1], y, vy, wy, terms);
        advance_each::<ADD>([pz, ez], masses, factors, gravity[2], z, vz, wz, terms);
        nodes.mass_velocity_squared = sum(&nodes.terms);
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
    /// Vectors that every machine of its kind has; on x86-64, SSE2: 128 bits.
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

    /// Density, Reynolds number and normal coefficient of all segments of a block.
    fn meet_wind(self, nodes: &Nodes, dragging: &mut Dragging, air_now: AirNow) {
        match self {
            Vectors::Widest => widest::meet_wind(nodes, dragging, air_now),
            Vectors::Avx2 => avx2::meet_wind(nodes, dragging, air_now),
            Vectors::Avx => avx::meet_wind(nodes, dragging, air_now),
            Vectors::Baseline => meet_pass(&nodes.x, &nodes.w, dragging, air_now),
        }
    }

    /// Drag of all segments of a block.
    fn drag_segments(self, nodes: &Nodes, dragging: &mut Dragging, air_now: AirNow) {
        match self {
            Vectors::Widest => widest::drag_segments(nodes, dragging, air_now),
            Vectors::Avx2 => avx2::drag_segments(nodes, dragging, air_now),
            Vectors::Avx => avx::drag_segments(nodes, dragging, air_now),
            Vectors::Baseline => drag_pass(&nodes.x, &nodes.w, dragging, air_now),
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

            use super::{AirNow, Dragging, Nodes, Ropes, StepFactors};

            #[multiversion(targets($($target),*))]
            pub fn pull_segments(nodes: &Nodes, ropes: &mut Ropes, dt: f64) {
                super::pull_pass(nodes, ropes, dt);
            }

            #[multiversion(targets($($target),*))]
            pub fn meet_wind(nodes: &Nodes, dragging: &mut Dragging, air_now: AirNow) {
                super::meet_pass(&nodes.x, &nodes.w, dragging, air_now);
            }

            #[multiversion(targets($($target),*))]
            pub fn drag_segments(nodes: &Nodes, dragging: &mut Dragging, air_now: AirNow) {
                super::drag_pass(&nodes.x, &nodes.w, dragging, air_now);
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

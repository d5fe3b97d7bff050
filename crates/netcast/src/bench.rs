//! Measures the speed of the simulator on this machine, and compares it with a limit.
//!
//! An *update* advances one segment by one step with all physics of a plain launch: tension, damping, gravity, mass
//! damping, the sums of the energy ledger. The *limit* comes from one rope without knots and with as many segments. Its
//! arithmetic and vector width are the same, on contiguous data. It is the rate of one thread times the threads.

use std::time::{Duration, Instant};

use glam::DVec3;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::state::State;
use netcast_dynamics::system::{Segment, System, SystemParts};
use netcast_dynamics::time::step::{LEAST_SLOTS_FOR_THREADS, Stepper, Vectors};
use netcast_model::Model;
use netcast_scenario::Diagnostics;
use rayon::prelude::*;
use serde::Serialize;

use crate::case::Case;
use crate::sections::{Body, Launch, Rope, Stow, Web};

/// Meshes along a side of the nets that are measured: 840, 3968, 29 928 and 119 024 segments.
pub const MESHES: [usize; 4] = [14, 31, 86, 172];

/// Rounds that measure net and limit in turn. The best of each counts, because disturbances only slow a machine.
const ROUNDS: usize = 7;

/// Least time of one measurement.
const MEASURED: Duration = Duration::from_millis(120);

/// One line of the bench.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measurement {
    /// Segments of the net.
    pub segments: usize,
    /// Threads used.
    pub threads: usize,
    /// Simultaneous runs; with several, each has one of the threads.
    pub runs: usize,
    /// Updates of all runs, 1/s.
    pub updates_per_s: f64,
    /// Updates of a rope without knots on one thread, times the threads, 1/s.
    pub limit_updates_per_s: f64,
    /// `updates_per_s` over `limit_updates_per_s`.
    pub fraction_of_limit: f64,
    /// Width of the vectors that the engine uses here.
    pub vector_bits: u32,
}

/// Whether one run of the net with `meshes` meshes along a side is shared among threads; a smaller net uses one.
///
/// # Errors
/// As [`measure`].
pub fn is_shared(meshes: usize) -> Result<bool, Diagnostics> {
    Ok(net(meshes)?.model().system.layout().slot_count() >= LEAST_SLOTS_FOR_THREADS)
}

/// Measures a square net of `meshes` by `meshes` meshes, with two segments in each mesh side, on `threads` threads: one
/// run on all of them, or `runs` simultaneous runs with one thread each.
///
/// # Errors
/// [`Diagnostics`] where the scenario of the bench is wrong; no user can cause that.
pub fn measure(meshes: usize, threads: usize, runs: usize) -> Result<Measurement, Diagnostics> {
    let case = net(meshes)?;
    let net = case.model();
    let segments = net.system.segments().len();
    let rope = rope(net, segments);
    let (mut updates, mut limit) = (0.0, 0.0);
    let dt = net.largest_dt();
    let mut nets: Vec<Stepper> = (0..runs).map(|_| Stepper::new(&net.system, &net.state, dt, threads / runs)).collect();
    let mut rope = [Stepper::new(&rope.0, &rope.1, dt, 1)];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads can be started");
    for _ in 0..ROUNDS {
        updates = f64::max(updates, pool.install(|| rate(&mut nets)));
        limit = f64::max(limit, threads as f64 * rate(&mut rope));
    }
    Ok(Measurement {
        segments,
        threads,
        runs,
        updates_per_s: updates,
        limit_updates_per_s: limit,
        fraction_of_limit: updates / limit,
        vector_bits: Vectors::Widest.bits(),
    })
}

/// Updates of simultaneous steppers in all, 1/s.
fn rate(steppers: &mut [Stepper]) -> f64 {
    let one = |stepper: &mut Stepper| {
        let segments = stepper.system().segments().len();
        // read the clock so rarely that reading it costs nothing
        let between = (200_000 / segments).max(1);
        let (clock, mut steps) = (Instant::now(), 0);
        while clock.elapsed() < MEASURED {
            for _ in 0..between {
                std::hint::black_box(stepper.step());
            }
            steps += between;
        }
        (steps * segments) as f64 / clock.elapsed().as_secs_f64()
    };
    match steppers {
        [only] => only.team().lead(|| one(only)),
        several => several.par_iter_mut().map(one).sum(),
    }
}

/// The thrown square net of `meshes` by `meshes` meshes that is measured.
///
/// # Errors
/// As [`measure`].
pub fn net(meshes: usize) -> Result<Case, Diagnostics> {
    net_with(meshes, &[])
}

/// As [`net`], with overrides of the scenario, each `path=value`, as after `--set`.
///
/// # Errors
/// [`Diagnostics`] where an override is wrong.
pub fn net_with(meshes: usize, overrides: &[String]) -> Result<Case, Diagnostics> {
    Case::new(Web::square(0.5 * meshes as f64, 0.5).set("segments_per_mesh", 2))
        .rope(Rope::new(0.002, 1440.0, 70e9).damping_ratio(0.05))
        .tractor(Body::particle(0.5))
        .stow(Stow::scale(0.25))
        .launch(Launch::new(20.0, 10.0))
        .damping(0.1)
        .duration(0.6)
        .record_every(0.01)
        .overrides(overrides)
        .build()
}

/// One rope without knots, of `segments` segments like those of the net, with its nodes at a quarter of their distance.
fn rope(net: &Model, segments: usize) -> (System, State) {
    let segment = net.system.segments()[0];
    let mass = 2.0 * segment.stiffness * net.limit.dt * net.limit.dt;
    let nodes = segments + 1;
    let system = SystemParts {
        mass: vec![mass; nodes],
        held: vec![false; nodes],
        tractor: vec![false; nodes],
        segments: (0..segments).map(|i| Segment { ends: [i, i + 1], group: 0, ..segment }).collect(),
        laws: vec![Law::Linear],
        environment: net.system.environment().clone(),
        ..SystemParts::default()
    };
    let along = |node: usize| node as f64 / segments as f64;
    let state = State {
        position: (0..nodes).map(|node| DVec3::X * (0.25 * segment.rest_length * node as f64)).collect(),
        velocity: (0..nodes).map(|node| DVec3::new(along(node), 0.0, (node % 5) as f64) * 10.0).collect(),
        ..State::default()
    };
    (system.build().expect("a rope is a system"), state)
}

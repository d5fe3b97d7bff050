//! A force that netcast does not know, added without a change to it: a magnet that draws iron beads on a line.
//!
//! A line of beads hangs from a held end. A magnet below pulls each bead towards itself with c / r^3, more and more as they
//! come near, and at most as if at a distance of 0.2 m. The run prints how far the lowest bead is, what the magnet does to
//! it, and how the energy balance closes.
//!
//!     cargo run --release -p netcast-dynamics --example magnet

use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::custom::CustomEffect;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::moving::Net;
use netcast_dynamics::simulate::{Frame, Live, Observer, Schedule, simulate};
use netcast_dynamics::state::State;
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::{Environment, Segment, SystemError, SystemParts};

/// Number of beads, and the distance from one to the next, m.
const BEADS: usize = 10;
const SPACING: f64 = 0.1;

/// A magnet: strength c, N m^3, place, m, and the beads that it draws.
#[derive(Debug, Clone)]
struct Magnet {
    strength: f64,
    place: DVec3,
    beads: Vec<usize>,
}

/// Nearer than this, m, the pull grows no more.
const NEAREST: f64 = 0.2;

impl CustomEffect for Magnet {
    fn name(&self) -> &str {
        "magnet"
    }

    fn nodes(&self) -> Vec<usize> {
        self.beads.clone()
    }

    fn act(&mut self, _time: f64, net: &dyn Net, force: &mut [DVec3]) {
        for &bead in &self.beads {
            let way = self.place - net.node(bead).x;
            let distance = way.length().max(NEAREST);
            force[bead] += self.strength / distance.powi(4) * way;
        }
    }

    fn bound(&self) -> Vec<(usize, f64, f64)> {
        // the steepest slope of c / r^3 is 3 c / r^4 at the nearest
        let stiffness = 3.0 * self.strength / NEAREST.powi(4);
        self.beads.iter().map(|&bead| (bead, stiffness, 0.0)).collect()
    }

    fn boxed_clone(&self) -> Box<dyn CustomEffect> {
        Box::new(self.clone())
    }
}

/// Prints the lowest bead at every record.
struct Print;

impl Observer for Print {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        let pull = frame.net.forces_of("custom").map_or(0.0, |forces| forces.force[BEADS].length());
        println!("{:.2} s: lowest bead at {:.4} m, drawn by {pull:.3} N", frame.time, frame.position[BEADS].z);
    }

    fn watches(&self) -> Vec<&'static str> {
        vec!["custom"]
    }
}

fn main() -> Result<(), SystemError> {
    let (stiffness, damping, breaking) = (5e3, 0.5, Breaking::NEVER);
    let link = |i| Segment { ends: [i, i + 1], rest_length: SPACING, stiffness, damping, group: 0, breaking };
    let magnet = Magnet { strength: 0.05, place: DVec3::new(0.3, 0.0, -1.3), beads: (1..=BEADS).collect() };
    let system = SystemParts {
        mass: vec![0.05; BEADS + 1],
        held: (0..=BEADS).map(|node| node == 0).collect(),
        tractor: vec![false; BEADS + 1],
        segments: (0..BEADS).map(link).collect(),
        laws: vec![Law::Linear],
        custom: vec![Box::new(magnet)],
        environment: Environment { gravity: DVec3::new(0.0, 0.0, -9.81), ..Environment::default() },
        ..SystemParts::default()
    }
    .build()?;
    let position = (0..=BEADS).map(|node| -SPACING * node as f64 * DVec3::Z).collect();
    let state = State { position, velocity: vec![DVec3::ZERO; BEADS + 1], ..State::default() };
    let schedule = Schedule::new(1.0, 0.1, 0.3 * step_limit(&system).dt);
    let outcome = simulate(&system, &state, &schedule, 1, &mut Print);
    let done = -outcome.ledger[Channel::Custom];
    println!("the magnet has done {done:.4} J; the balance closes to {:.1e}", outcome.balance.closure());
    Ok(())
}

//! Effects from outside: one of the caller's own, and what an observer is told of the forces of each.

use crate::nets::{Net, paper_rope};
use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::custom::CustomEffect;
use netcast_dynamics::effects::EFFECTS;
use netcast_dynamics::forces::ground::{Footing, Ground, Spring};
use netcast_dynamics::forces::load::Load;
use netcast_dynamics::moving;
use netcast_dynamics::simulate::{Frame, Live, Observer, Schedule, resume, simulate};
use netcast_dynamics::snapshot::Snapshot;
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::{Environment, PartKind, SystemError};

/// A spring from some nodes to the origin, N/m, that is a little softer the farther they have been.
#[derive(Debug, Clone)]
struct ToOrigin {
    stiffness: f64,
    nodes: Vec<usize>,
    farthest: f64,
}

/// By how much softer a metre away makes it.
const SOFTER: f64 = 1e-3;

impl ToOrigin {
    fn of(stiffness: f64, nodes: &[usize]) -> Box<dyn CustomEffect> {
        Box::new(ToOrigin { stiffness, nodes: nodes.to_vec(), farthest: 0.0 })
    }
}

impl CustomEffect for ToOrigin {
    fn name(&self) -> &str {
        "to the origin"
    }

    fn nodes(&self) -> Vec<usize> {
        self.nodes.clone()
    }

    fn act(&mut self, _: f64, net: &dyn moving::Net, force: &mut [DVec3]) {
        for &node in &self.nodes {
            self.farthest = self.farthest.max(net.node(node).x.length());
        }
        let stiffness = self.stiffness / (1.0 + SOFTER * self.farthest);
        for &node in &self.nodes {
            force[node] -= stiffness * net.node(node).x;
        }
    }

    fn bound(&self) -> Vec<(usize, f64, f64)> {
        self.nodes.iter().map(|&node| (node, self.stiffness, 0.0)).collect()
    }

    fn memory(&self) -> Vec<f64> {
        vec![self.farthest]
    }

    fn remember(&mut self, memory: &[f64]) {
        self.farthest = memory[0];
    }

    fn boxed_clone(&self) -> Box<dyn CustomEffect> {
        Box::new(self.clone())
    }
}

/// What an observer sees of the effects of some names at the last record, and the last snapshot before that.
#[derive(Default)]
struct Watching {
    names: Vec<&'static str>,
    forces: Vec<Vec<DVec3>>,
    position: Vec<DVec3>,
    snapshot: Option<Snapshot>,
}

impl Observer for Watching {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        let of = |name: &&str| frame.net.forces_of(name).map_or(Vec::new(), |forces| forces.force.clone());
        self.forces = self.names.iter().map(of).collect();
        self.position = frame.position.to_vec();
    }

    fn watches(&self) -> Vec<&'static str> {
        self.names.clone()
    }

    fn wants_snapshot(&mut self) -> bool {
        self.snapshot.is_none()
    }

    fn snapshot(&mut self, snapshot: &Snapshot) {
        self.snapshot = Some(snapshot.clone());
    }
}

/// A mass on a spring of the caller's swings as cos(sqrt(k/m) t), and its work closes the balance.
#[test]
fn a_force_of_the_callers_own_swings_its_mass_and_closes_the_balance() {
    let mut net = Net::default();
    net.node(DVec3::X, DVec3::ZERO);
    net.parts.mass = vec![2.0];
    net.parts.custom = vec![ToOrigin::of(50.0, &[0])];
    let system = net.build();
    assert_eq!(system.channels().last(), Some(Channel::Custom));
    let mut watching = Watching { names: vec!["custom"], ..Watching::default() };
    let schedule = Schedule::new(1.0, 0.5, 1e-4);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut watching);
    // it has been 1 m away from the start
    let stiffness = 50.0 / (1.0 + SOFTER);
    let exact = libm::cos((stiffness / 2.0_f64).sqrt());
    assert!((watching.position[0].x - exact).abs() < 1e-6, "{} and not {exact}", watching.position[0].x);
    assert!((watching.forces[0][0].x + stiffness * watching.position[0].x).abs() < 1e-9, "{:?}", watching.forces);
    assert!(outcome.balance.closure() < 1e-6 && outcome.ledger[Channel::Custom] != 0.0, "{:?}", outcome.balance);
}

/// Its stiffness is in the bound: between a node and the world dt = 2 sqrt(m/k).
#[test]
fn a_force_of_the_callers_own_bounds_the_step() {
    let mut net = Net::default();
    net.node(DVec3::X, DVec3::ZERO);
    net.parts.mass = vec![2.0];
    net.parts.custom = vec![ToOrigin::of(50.0, &[0])];
    assert!((step_limit(&net.build()).dt - 2.0 * f64::sqrt(2.0 / 50.0)).abs() < 1e-12);
}

#[test]
fn a_force_of_the_callers_own_goes_on_after_an_interruption_to_the_same_bits() {
    let mut net = Net::rope(2.0, 8, paper_rope(0.05));
    net.parts.held[0] = true;
    net.parts.custom = vec![ToOrigin::of(200.0, &[3, 8]), ToOrigin::of(100.0, &[5])];
    let system = net.build();
    let schedule = Schedule::new(4e-3, 1e-3, 0.3 * step_limit(&system).dt);
    let mut whole = Watching::default();
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut whole);
    let mut rest = Watching { snapshot: whole.snapshot.clone(), ..Watching::default() };
    let resumed = resume(&system, &whole.snapshot.expect("a snapshot"), &schedule, 1, &mut rest);
    assert_eq!((whole.position, outcome.ledger), (rest.position, resumed.ledger));
}

#[test]
fn a_force_of_the_callers_own_on_a_node_that_is_not_there_is_refused() {
    let mut net = Net::rope(1.0, 2, paper_rope(0.05));
    net.parts.custom = vec![ToOrigin::of(1.0, &[7])];
    assert!(matches!(net.parts.build(), Err(SystemError::Attached { part: PartKind::Custom, node: 7, index: 0, .. })));
}

/// A load and the ground under a mass that lies: the forces of each are asked for apart, and balance the weight.
#[test]
fn an_observer_is_told_the_forces_of_the_effects_that_it_names() {
    let mut net = Net::default();
    net.node(DVec3::ZERO, DVec3::ZERO);
    net.parts.mass = vec![3.0];
    net.parts.loads = vec![Load { node: 0, force: DVec3::new(0.0, 0.0, -4.0), ramp: 0.0 }];
    let spring = Spring { stiffness: 1e4, damping: 200.0, mass: 3.0 };
    let nodes = vec![Footing { node: 0, radius: 0.0, spring }];
    let ground = Some(Ground { height: 0.0, friction: 0.0, nodes, hulls: Vec::new() });
    net.parts.environment = Environment { gravity: DVec3::new(0.0, 0.0, -10.0), ground, ..Environment::default() };
    let system = net.build();
    let mut watching = Watching { names: vec!["load", "ground", "orbit"], ..Watching::default() };
    simulate(&system, &net.state, &Schedule::new(2.0, 1.0, 1e-4), 1, &mut watching);
    assert_eq!(watching.forces[0], [DVec3::new(0.0, 0.0, -4.0)]);
    // 3 kg at 10 m/s^2 and 4 N of load
    assert!((watching.forces[1][0] - 34.0 * DVec3::Z).length() < 1e-6, "{:?}", watching.forces[1]);
    // beside no orbit nothing acts that one could be told of
    assert!(watching.forces[2].iter().all(|force| *force == DVec3::ZERO));
}

/// The documents list every effect with its channels.
#[test]
fn the_page_of_effects_lists_every_effect_with_its_channels() {
    let page = include_str!("../../../../docs/theory/effects.md");
    for (name, channels) in EFFECTS {
        let names: Vec<&str> = channels.iter().map(|channel| channel.name()).collect();
        let row = page.lines().find(|line| line.starts_with(&format!("| {name} |")));
        let row = row.unwrap_or_else(|| panic!("docs/theory/effects.md has no row for {name}"));
        assert!(row.contains(&format!("| {} |", names.join(", "))), "{name}: {} in {row}", names.join(", "));
    }
}

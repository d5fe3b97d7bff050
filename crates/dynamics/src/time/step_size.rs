//! The largest step that is stable.
//!
//! For an oscillator of frequency omega and damping ratio xi the scheme of [`crate::time`] obeys
//!
//! ```text
//! x_(n+1) - 2 x_n + x_(n-1) = -W^2 x_n - 2 xi W (3 x_n - 4 x_(n-1) + x_(n-2))/2,      W = omega dt
//! ```
//!
//! whose root leaves the unit circle at z = -1, where W^2 + 8 xi W = 4. For a net this reads: dt^2 K + 4 dt C - 4 M
//! must be negative definite. By Gershgorin's theorem, node by node, with sums over the segments that meet there
//! (each counts twice, once for itself and once for the coupling):
//!
//! ```text
//! 2 dt^2 sum(k) + 8 dt sum(c) <= 4 m,    dt = m / (C + sqrt(C^2 + K m/2)),    K = sum(k), C = sum(c)
//! ```
//!
//! k is the largest stiffness that the segment's law can show ([`Law::largest_stiffness`](crate::forces::law::Law)).
//! Drag at the fastest wind that is expected, of slope c, is a damper between a node and the world: it counts once.
//! It holds for any shape of the net, as all its segments may come to lie along one line. Inside a rope it is exact:
//! dt = segment length / wave speed. See docs/theory/step-size.md for the derivation.

use crate::body::Body;
use crate::forces::element::Element;
use crate::forces::ground::Spring;
use crate::launcher::{Means, Push, Tube};
use crate::system::{Environment, System};

/// A bound on the step and what sets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimit {
    /// Largest stable step, s; infinite where nothing is stiff.
    pub dt: f64,
    /// The node that sets it.
    pub node: usize,
    /// The stiffest of what meets there.
    pub stiffest: Option<Stiff>,
    /// The limit that this node would set without damping, s.
    pub without_damping: f64,
    /// The limit that all nodes set where nothing of that one's kind meets, s.
    pub elsewhere: f64,
}

/// What makes a node stiff, with its index in the system where it has one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stiff {
    /// A segment.
    Segment(usize),
    /// The bending of a rope.
    Bending(usize),
    /// A triangle of a sheet.
    Membrane(usize),
    /// A hinge of a sheet.
    Hinge(usize),
    /// The ground.
    Ground,
    /// The drag of the medium.
    Air,
}

/// What meets at each node.
struct Meeting {
    /// Sums of stiffness, N/m, and damping, N s/m.
    stiffness: Vec<f64>,
    damping: Vec<f64>,
    stiffest: Vec<Option<(f64, Stiff)>>,
    /// The shares of the ground in the stiffness and of the medium in the damping.
    of_ground: Vec<f64>,
    of_air: Vec<f64>,
}

impl Meeting {
    fn of(system: &System) -> Meeting {
        let nodes = system.mass().len();
        let none = || vec![0.0; nodes];
        let (stiffest, of_ground, of_air) = (vec![None; nodes], none(), none());
        let mut at = Meeting { stiffness: none(), damping: none(), stiffest, of_ground, of_air };
        for (i, s) in system.segments().iter().enumerate() {
            let stiffness = system.law(s).largest_stiffness(&s.into());
            s.ends.iter().for_each(|&node| at.add(node, stiffness, s.damping, Stiff::Segment(i)));
        }
        system.bends().iter().enumerate().for_each(|(i, bend)| at.add_element(bend, Stiff::Bending(i)));
        system.membranes().iter().enumerate().for_each(|(i, membrane)| at.add_element(membrane, Stiff::Membrane(i)));
        system.hinges().iter().enumerate().for_each(|(i, hinge)| at.add_element(hinge, Stiff::Hinge(i)));
        // what pulls at a body's ties, at once a push and a turn: a tie at r from the centre moves by at most
        // sqrt(1 + r^2/g^2) times what the body does, with its least radius of gyration g as the measure of turning
        // or, where the centre does not give way, by what it turns
        // drag and ground are between a node and the world: they count once, where what joins two nodes counts twice
        let Environment { air, ground, .. } = system.environment();
        if let Some(air) = air {
            air.damping(system, |node, damping| {
                at.damping[node] += 0.5 * damping;
                at.of_air[node] += 0.5 * damping;
            });
        }
        for footing in ground.iter().flat_map(|ground| &ground.nodes) {
            at.add_ground(footing.node, 0.5, &footing.spring);
        }
        for body in system.bodies() {
            for tie in &body.ties {
                at.pass(tie.node, body.centre, lever(system, body, tie.arm.length()));
            }
        }
        for hull in ground.iter().flat_map(|ground| &ground.hulls) {
            let body = &system.bodies()[hull.body];
            at.add_ground(body.centre, 0.5 * lever(system, body, hull.reach()), &hull.spring);
        }
        // a spring between the launcher and its node: counted once, where one between two nodes counts twice
        for launcher in system.launchers() {
            if let Means::Tube(Tube { push: Push::OverStroke(curve), .. }) = &launcher.by {
                at.stiffness[launcher.node] += 0.5 * curve.steepest();
            }
        }
        at
    }

    fn add(&mut self, node: usize, stiffness: f64, damping: f64, what: Stiff) {
        self.stiffness[node] += stiffness;
        self.damping[node] += damping;
        if self.stiffest[node].is_none_or(|(other, _)| stiffness > other) {
            self.stiffest[node] = Some((stiffness, what));
        }
    }

    fn add_ground(&mut self, node: usize, share: f64, spring: &Spring) {
        self.stiffness[node] += share * spring.stiffness;
        self.damping[node] += share * spring.damping;
        self.of_ground[node] += share * spring.stiffness;
    }

    /// What meets at a tie acts on the body, with this lever.
    fn pass(&mut self, tie: usize, centre: usize, lever: f64) {
        for of in [&mut self.stiffness, &mut self.damping, &mut self.of_air] {
            of[centre] += lever * of[tie];
        }
        if let Some((stiffness, what)) = self.stiffest[tie]
            && self.stiffest[centre].is_none_or(|(other, _)| lever * stiffness > other)
        {
            self.stiffest[centre] = Some((lever * stiffness, what));
        }
    }

    /// What makes a node of this mass, kg, stiff.
    fn stiffest(&self, node: usize, mass: f64) -> Option<Stiff> {
        let (stiffness, damping) = (self.stiffness[node], self.damping[node]);
        if self.of_ground[node] > 0.5 * stiffness {
            return Some(Stiff::Ground);
        }
        if self.of_air[node] > 0.5 * damping && damping * damping > 0.5 * stiffness * mass {
            return Some(Stiff::Air);
        }
        self.stiffest[node].map(|(_, what)| what)
    }

    fn add_element<E: Element<N>, const N: usize>(&mut self, element: &E, what: Stiff) {
        let (stiffness, damping) = (element.stiffness(), element.damping());
        for (k, node) in element.nodes().into_iter().enumerate() {
            self.add(node, stiffness[k], damping[k], what);
        }
    }
}

/// By how much what pulls at a point `reach` metres from a body's centre moves it more than what pulls at the centre: at
/// once a push and a turn, 1 + r^2/g^2, with its least radius of gyration g as the measure of turning. A centre that is
/// held is turned only.
fn lever(system: &System, body: &Body, reach: f64) -> f64 {
    let gyration_squared = body.inertia.min_element() / turning_mass(system, body);
    let pushed = if system.held()[body.centre] { 0.0 } else { 1.0 };
    pushed + reach * reach / gyration_squared
}

/// The mass at whose radius of gyration a body's inertia stands for it, kg: its own, or at a metre where it has none.
fn turning_mass(system: &System, body: &Body) -> f64 {
    match system.mass()[body.centre] {
        0.0 => body.inertia.min_element(),
        mass => mass,
    }
}

/// The mass of each node, kg, (nodes,), at which it would set a limit of `dt` seconds; zero where nothing is stiff.
pub fn limiting_mass(system: &System, dt: f64) -> Vec<f64> {
    let Meeting { stiffness, damping, .. } = Meeting::of(system);
    stiffness.iter().zip(damping).map(|(k, c)| 0.5 * dt * dt * k + 2.0 * dt * c).collect()
}

/// The stability limit of `system`.
pub fn step_limit(system: &System) -> StepLimit {
    let nodes = system.mass().len();
    let at = Meeting::of(system);
    let mut mass: Vec<f64> =
        system.mass().iter().zip(system.held()).map(|(m, held)| if *held { 0.0 } else { *m }).collect();
    for body in system.bodies().iter().filter(|body| system.held()[body.centre]) {
        mass[body.centre] = turning_mass(system, body);
    }
    let bound = |node: usize, c: f64| {
        let (mass, k) = (mass[node], at.stiffness[node]);
        mass / (c + (c * c + 0.5 * k * mass).sqrt())
    };
    let is_free = |node: &usize| mass[*node] > 0.0 && at.stiffness[*node] + at.damping[*node] > 0.0;
    let free: Vec<usize> = (0..nodes).filter(is_free).collect();
    let smallest = |one: (usize, f64), other: (usize, f64)| if other.1 < one.1 { other } else { one };
    let least = free.iter().map(|&node| (node, bound(node, at.damping[node]))).reduce(smallest);
    let Some((node, dt)) = least else {
        let (dt, without_damping, elsewhere) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
        return StepLimit { dt, node: 0, stiffest: None, without_damping, elsewhere };
    };
    let stiffest = at.stiffest(node, mass[node]);
    let touched = touched(system, &at, stiffest);
    let others = free.iter().filter(|&&node| !touched[node]).map(|&node| bound(node, at.damping[node]));
    let elsewhere = others.fold(f64::INFINITY, f64::min);
    StepLimit { dt, node, stiffest, without_damping: bound(node, 0.0), elsewhere }
}

/// Nodes at which something of the kind of `what` meets: for a segment its class.
fn touched(system: &System, at: &Meeting, what: Option<Stiff>) -> Vec<bool> {
    let mut touched = vec![false; system.mass().len()];
    let mut touch = |nodes: &[usize]| nodes.iter().for_each(|&node| touched[node] = true);
    match what {
        Some(Stiff::Segment(segment)) => {
            let class = system.segments()[segment].class;
            system.segments().iter().filter(|s| s.class == class).for_each(|s| touch(&s.ends));
        }
        Some(Stiff::Bending(_)) => system.bends().iter().for_each(|bend| touch(&bend.nodes())),
        Some(Stiff::Membrane(_)) => system.membranes().iter().for_each(|membrane| touch(&membrane.nodes())),
        Some(Stiff::Hinge(_)) => system.hinges().iter().for_each(|hinge| touch(&hinge.nodes())),
        Some(Stiff::Ground) => (0..touched.len()).for_each(|node| touched[node] = at.of_ground[node] > 0.0),
        Some(Stiff::Air) => (0..touched.len()).for_each(|node| touched[node] = at.of_air[node] > 0.0),
        None => {}
    }
    touched
}

//! What acts beside the ropes: loads, elements, rigid bodies, driven nodes. Both steps call it in the same order.
//!
//! ```text
//! act      forces of loads and elements on their nodes, where these are now
//! couple   bodies collect what pulls at their ties; drives count what pulls at them; launchers hold, guide, push
//! carry    after nodes have moved: launchers let go, bodies turn and take their ties along, drives go on
//! ```
//!
//! Nodes are reached through closures, for each step keeps them in its own way. Forces are summed in the order of the
//! system's lists, whatever the number of threads.

use std::collections::BTreeSet;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::StepFactors;
use super::airborne::{Airborne, as_seen};
use super::elements::Elements;
use super::grounded::Grounded;
use super::launching::{Launching, Phase, Thrust, thrust};
use super::step::Team;
use super::traced::Traced;
use crate::body::{Body, Rotation};
use crate::forces::element::Element;
use crate::forces::ground::Hull;
use crate::forces::load;
use crate::launcher::Means;
use crate::state::State;
use crate::system::System;

/// A node as a step has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moving {
    /// Position, m.
    pub x: DVec3,
    /// Half-step velocity, m/s.
    pub v: DVec3,
    /// Velocity extrapolated to the step, m/s.
    pub w: DVec3,
}

/// How a body turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Turning {
    /// Orientation at the step, and angular momentum half a step before, kg m^2/s.
    pub half_step: Rotation,
    /// Angular momentum extrapolated to the step, kg m^2/s.
    pub extrapolated: DVec3,
}

/// All that is attached to a net, in motion.
pub(super) struct Attached<'a> {
    system: &'a System,
    factors: StepFactors,
    /// Force on each node, N, (nodes,); that of ropes is not in it.
    force: Vec<DVec3>,
    /// The nodes of elements, each once, and position and velocity of those, (nodes,): each is asked for once a step, for
    /// a node of a sheet has six triangles and twelve hinges.
    of_elements: Vec<usize>,
    moving: Vec<(DVec3, DVec3)>,
    bends: Elements<3>,
    membranes: Elements<3>,
    hinges: Elements<4>,
    airborne: Option<Airborne<'a>>,
    grounded: Option<Grounded<'a>>,
    turning: Vec<Turning>,
    /// Torque on each body at the last forces, N m.
    torque: Vec<DVec3>,
    /// Each load, and what pulls at each driven node.
    loaded: Vec<Traced>,
    driven: Vec<Traced>,
    launching: Launching,
    /// What each launcher does at the last forces.
    thrusts: Vec<Thrust>,
    /// The body whose centre each launcher has.
    launched_body: Vec<Option<usize>>,
    /// Half-step velocities of nodes that are let go at the last forces, m/s.
    let_go: Vec<(usize, DVec3)>,
    /// Time of the step that is next, s.
    time: f64,
    sums: AttachedSums,
    /// What is carried, ties and then driven nodes, and how it moves now; after them, what is let go now.
    carried: Vec<(usize, Moving)>,
    /// Number of ties and driven nodes.
    carried_always: usize,
}

/// What is summed over all that is attached, from the forces before to these.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct AttachedSums {
    /// Work that the net has done on what drives it, J.
    pub drive_work: f64,
    /// Power lost by turning bodies to mass-proportional damping, over its factor: the sum of L . omega, J.
    pub turning: f64,
    /// Work of the loads that are brought up in time, J.
    pub load_work: f64,
    /// Work lost where ropes bend, J.
    pub bending_work: f64,
    /// Work lost inside sheets, J.
    pub sheet_work: f64,
    /// Work that the net has done on its launchers, J.
    pub launch_work: f64,
    /// Work that sheets and bodies have done on the air, J.
    pub air_work: f64,
    /// Work done on the inertia of the medium, J.
    pub added_mass_work: f64,
    /// Work lost to the ground, J.
    pub ground_work: f64,
    /// Elastic energy of the bends that go with segments which break, J.
    pub rupture: f64,
}

impl<'a> Attached<'a> {
    /// None where a system has nothing of the kind. It goes on from `time`, s.
    pub fn new(
        system: &'a System,
        factors: StepFactors,
        turning: Vec<Turning>,
        launching: Launching,
        time: f64,
    ) -> Option<Self> {
        let elements = system.bends().len() + system.membranes().len() + system.hinges().len();
        let moved = system.bodies().len() + system.drives().len() + system.launchers().len();
        let body_at = |node: usize| system.bodies().iter().position(|body| body.centre == node);
        let (airborne, grounded) = (Airborne::new(system), Grounded::new(system));
        let surrounded = airborne.is_some() || grounded.is_some() || system.environment().orbit.is_some();
        (elements + system.loads().len() + moved > 0 || surrounded).then(|| Attached {
            system,
            factors,
            force: vec![DVec3::ZERO; system.mass().len()],
            of_elements: of_elements(system),
            moving: vec![(DVec3::ZERO, DVec3::ZERO); system.mass().len()],
            bends: Elements::new(system.bends().iter().map(Element::nodes).collect()),
            membranes: Elements::new(system.membranes().iter().map(Element::nodes).collect()),
            hinges: Elements::new(system.hinges().iter().map(Element::nodes).collect()),
            airborne,
            grounded,
            turning,
            torque: vec![DVec3::ZERO; system.bodies().len()],
            loaded: vec![Traced::default(); system.loads().len()],
            driven: vec![Traced::default(); system.drives().len()],
            launching,
            thrusts: vec![Thrust::default(); system.launchers().len()],
            launched_body: system.launchers().iter().map(|launcher| body_at(launcher.node)).collect(),
            let_go: Vec::new(),
            time,
            sums: AttachedSums::default(),
            carried: Vec::new(),
            carried_always: 0,
        })
    }

    /// Force on each node beside that of ropes, N, (nodes,).
    pub fn force(&self) -> &[DVec3] {
        &self.force
    }

    /// How each body turns.
    pub fn turning(&self) -> &[Turning] {
        &self.turning
    }

    /// How the launch stands.
    pub fn launching(&self) -> &Launching {
        &self.launching
    }

    /// Nodes that are let go at the last forces and their half-step velocities before, m/s.
    pub fn let_go(&self) -> &[(usize, DVec3)] {
        &self.let_go
    }

    /// Torque on each body at the last forces, N m.
    pub fn torques(&self) -> &[DVec3] {
        &self.torque
    }

    /// Bodies turn as in `rotations`, whatever they did before.
    pub fn restart(&mut self, rotations: &[Rotation]) {
        self.turning = rotations.iter().copied().map(Turning::starting).collect();
    }

    /// Sums of the last forces.
    pub fn sums(&self) -> AttachedSums {
        self.sums
    }

    /// The nodes on which something beside ropes may act.
    pub fn touched(system: &System) -> impl Iterator<Item = usize> {
        let loads = system.loads().iter().map(|load| load.node);
        let centres = system.bodies().iter().map(|body| body.centre);
        let launched = system.launchers().iter().map(|launcher| launcher.node);
        let everywhere = if system.environment().orbit.is_some() { 0..system.mass().len() } else { 0..0 };
        let surrounded = Airborne::touched(system).chain(Grounded::touched(system)).chain(everywhere);
        element_nodes(system).chain(loads).chain(centres).chain(launched).chain(surrounded)
    }

    /// The forces of loads and elements at `time`, s. `node` tells where a node is and how it moves.
    pub fn act(&mut self, team: &Team, time: f64, node: impl Fn(usize) -> Moving + Sync) {
        for &index in &self.of_elements {
            self.moving[index] = as_seen(node(index));
        }
        let (system, moving) = (self.system, &self.moving);
        let at = |index: usize| moving[index];
        let force = &mut self.force;
        force.fill(DVec3::ZERO);
        load::add_force(self.system.loads(), time, force);
        let mut load_work = 0.0;
        let loads = self.system.loads().iter().zip(&mut self.loaded).filter(|(load, _)| !load.is_steady());
        for (load, traced) in loads {
            load_work += traced.work(load.at(time), node(load.node).x);
        }
        self.sums = AttachedSums {
            load_work,
            bending_work: self.bends.pull(team, |i, x, w| system.bends()[i].pull(x, w), at, force),
            sheet_work: self.membranes.pull(team, |i, x, w| system.membranes()[i].pull(x, w), at, force)
                + self.hinges.pull(team, |i, x, w| system.hinges()[i].pull(x, w), at, force),
            ..AttachedSums::default()
        };
        if let Some(grounded) = &mut self.grounded {
            self.sums.ground_work = grounded.push(team, self.factors.dt, |index| as_seen(node(index)), force);
        }
        if let Some(orbit) = system.environment().orbit {
            for (index, (force, &mass)) in force.iter_mut().zip(system.mass()).enumerate() {
                let Moving { x, v: _, w } = node(index);
                *force += mass * orbit.acceleration(x, w);
            }
        }
        if let Some(airborne) = &mut self.airborne {
            let turned = |body: usize| self.turning[body].half_step.orientation;
            self.sums.air_work = airborne.drag(team, time, at, |index| as_seen(node(index)), turned, force);
        }
    }

    /// Lets bends go with the segments that break at these forces; they have acted for the last time.
    pub fn part(&mut self, failing: impl IntoIterator<Item = usize>) {
        for segment in failing {
            for &bend in self.system.bends_over(segment) {
                let place = self.bends.leave(bend);
                self.sums.rupture += place.map_or(0.0, |place| self.system.bends()[bend].elastic_energy(place));
            }
            self.airborne.iter_mut().for_each(|airborne| airborne.leave(segment));
        }
    }

    /// Takes out the bends over segments that are broken, (segments,).
    pub fn put_broken(&mut self, broken: &[bool]) {
        let broken = (0..broken.len()).filter(|&segment| broken[segment]);
        self.airborne.iter_mut().for_each(|airborne| broken.clone().for_each(|segment| airborne.remove(segment)));
        broken.flat_map(|segment| self.system.bends_over(segment)).for_each(|&bend| self.bends.remove(bend));
    }

    /// The force of a body's ties on it, of nodes on their drives, of launchers on their nodes. `pull` tells the force
    /// of ropes on a node, added to what is given; `moving` tells where a node is, and its half-step velocity.
    pub fn couple(&mut self, pull: impl Fn(usize, DVec3) -> DVec3, moving: impl Fn(usize) -> Moving) {
        let at = |node: usize| moving(node).x;
        for (body, torque) in self.system.bodies().iter().zip(&mut self.torque) {
            *torque = DVec3::ZERO;
            for tie in &body.ties {
                let force = pull(tie.node, self.force[tie.node]);
                self.force[body.centre] += force;
                *torque += (at(tie.node) - at(body.centre)).cross(force);
            }
        }
        if let Some(grounded) = &mut self.grounded {
            let (system, turning, all, torque) = (self.system, &self.turning, &mut self.force, &mut self.torque);
            let moving = |hull: &Hull| {
                let Moving { x, v: _, w } = moving(system.bodies()[hull.body].centre);
                let Turning { half_step, extrapolated } = turning[hull.body];
                (x, w, Rotation { angular_momentum: extrapolated, ..half_step })
            };
            self.sums.ground_work += grounded.push_hulls(system, self.factors.dt, moving, |hull, arm, force| {
                all[system.bodies()[hull.body].centre] += force;
                torque[hull.body] += arm.cross(force);
            });
        }
        if let Some(airborne) = &mut self.airborne {
            self.sums.added_mass_work = airborne.take_along(&pull, at, &mut self.force);
        }
        for (drive, traced) in self.system.drives().iter().zip(&mut self.driven) {
            self.sums.drive_work += traced.work(pull(drive.node, self.force[drive.node]), at(drive.node));
        }
        self.launch(pull, moving);
        for (body, rotation) in self.system.bodies().iter().zip(self.rotations()) {
            self.sums.turning += rotation.angular_momentum.dot(body.angular_velocity(&rotation));
        }
    }

    /// What launchers do. Comes last, when all other forces on their nodes are known.
    fn launch(&mut self, pull: impl Fn(usize, DVec3) -> DVec3, moving: impl Fn(usize) -> Moving) {
        let (system, factors) = (self.system, self.factors);
        self.let_go.clear();
        let launchers = system.launchers().iter().zip(&mut self.thrusts).zip(&self.launched_body);
        for (((launcher, last), body), launched) in launchers.zip(&self.launching.nodes) {
            let (node, phase) = (launcher.node, launched.phase);
            if phase == Phase::Free && last.force == DVec3::ZERO {
                continue;
            }
            let mass = system.mass()[node];
            let pulled = pull(node, self.force[node]) + mass * system.environment().gravity;
            let now = thrust(launcher, phase, moving(node), mass, pulled, self.time, factors);
            self.sums.launch_work -= 0.5 * (last.force + now.force).dot(now.place - last.place);
            self.force[node] += now.force;
            *last = now;
            if let (Phase::Leaving, Means::Velocity(velocity)) = (phase, &launcher.by) {
                let before = |k| factors.before_start(velocity[k], pulled[k] / mass);
                self.let_go.push((node, DVec3::from_array(std::array::from_fn(before))));
                self.sums.launch_work -= 0.5 * mass * velocity.length_squared();
            }
            if let Some(body) = body.filter(|_| phase.is_guided()) {
                self.torque[body] = DVec3::ZERO;
            }
        }
    }

    /// How each body turns at the step of the last forces.
    pub fn rotations(&self) -> Vec<Rotation> {
        let at_step = |(turning, torque): (&Turning, &DVec3)| {
            let Rotation { orientation, angular_momentum } = turning.half_step;
            let momentum = |k| self.factors.at_step(angular_momentum[k], torque[k]);
            Rotation { orientation, angular_momentum: DVec3::from_array(std::array::from_fn(momentum)) }
        };
        self.turning.iter().zip(&self.torque).map(at_step).collect()
    }

    /// The start: half-step angular momenta such that bodies turn as in `rotations` at the step of the last forces.
    pub fn before_start(&mut self, rotations: &[Rotation]) {
        for ((turning, torque), start) in self.turning.iter_mut().zip(&self.torque).zip(rotations) {
            for k in 0..3 {
                turning.half_step.angular_momentum[k] = self.factors.before_start(start.angular_momentum[k], torque[k]);
            }
        }
    }

    /// Says how what is carried moves before the first step.
    pub fn place(&mut self, node: impl Fn(usize) -> Moving) {
        let ties = self.system.bodies().iter().flat_map(|body| &body.ties).map(|tie| tie.node);
        let all = ties.chain(self.system.drives().iter().map(|drive| drive.node));
        self.carried = all.map(|carried| (carried, node(carried))).collect();
        self.carried_always = self.carried.len();
    }

    /// Lets go of what is launched, turns bodies, moves driven nodes to their places at `time`, s, and returns what is
    /// carried and how it moves now. `moving` tells how a node moves after this step.
    pub fn carry(&mut self, time: f64, moving: impl Fn(usize) -> Moving) -> &[(usize, Moving)] {
        let (system, dt) = (self.system, self.factors.dt);
        self.bends.let_go();
        self.airborne.iter_mut().for_each(Airborne::let_go);
        let mut let_go = Vec::new();
        let when = (time, self.time == 0.0);
        self.launching.advance(system.launchers(), &self.thrusts, self.factors, when, |node, velocity| {
            let_go.push((node, Moving { w: velocity, ..moving(node) }));
        });
        self.time = time;
        self.carried.truncate(self.carried_always);
        let ties = self.carried_always - system.drives().len();
        let (ties, driven) = self.carried.split_at_mut(ties);
        for (drive, (_, driven)) in system.drives().iter().zip(driven.iter_mut()) {
            let x = drive.at(time);
            let v = (x - driven.x) / dt;
            *driven = Moving { x, v, w: 1.5 * v - 0.5 * driven.v };
        }
        let centre = |node: usize| {
            let own = driven.iter().chain(&let_go).find(|(own, _)| *own == node);
            own.map_or_else(|| moving(node), |(_, moving)| *moving)
        };
        let mut ties = ties.iter_mut().map(|(_, moving)| moving);
        let mut next = || ties.next().expect("every tie has a place");
        for ((body, turning), torque) in system.bodies().iter().zip(&mut self.turning).zip(&self.torque) {
            turning.turn(body, *torque, self.factors);
            for_each_tie(body, turning, centre(body.centre), |_, moving| {
                let tie = next();
                *tie = Moving { v: (moving.x - tie.x) / dt, ..moving };
            });
        }
        self.carried.extend(let_go);
        &self.carried
    }
}

/// The nodes of elements, each once.
fn of_elements(system: &System) -> Vec<usize> {
    BTreeSet::from_iter(element_nodes(system)).into_iter().collect()
}

/// The nodes of elements and of sheets that drag, as often as they occur.
fn element_nodes(system: &System) -> impl Iterator<Item = usize> {
    let bends = system.bends().iter().flat_map(|bend| bend.nodes());
    let membranes = system.membranes().iter().flat_map(|membrane| membrane.nodes());
    let hinges = system.hinges().iter().flat_map(|hinge| hinge.nodes());
    let air = system.environment().air.iter().flat_map(|air| &air.sheets);
    bends.chain(membranes).chain(hinges).chain(air.flat_map(|sheet| sheet.nodes))
}

impl Turning {
    /// A body that turns like this, whatever half a step before.
    pub fn starting(rotation: Rotation) -> Turning {
        Turning { half_step: rotation, extrapolated: rotation.angular_momentum }
    }

    /// Kick and drift of a rotation.
    fn turn(&mut self, body: &Body, torque: DVec3, factors: StepFactors) {
        let momentum = &mut self.half_step.angular_momentum;
        for k in 0..3 {
            // the third of them is the extrapolation, the second is for what has a place
            [momentum[k], _, self.extrapolated[k]] = factors.advance(momentum[k], 0.0, torque[k]);
        }
        self.half_step.orientation = body.turned(&self.half_step, factors.dt);
    }
}

/// The state at the start as a step needs it: what is held rests, ties are where their bodies are, driven nodes on their
/// way.
pub(super) fn started(system: &System, state: &State, dt: f64) -> State {
    let mut state = state.clone();
    for (velocity, _) in state.velocity.iter_mut().zip(system.held()).filter(|(_, held)| **held) {
        *velocity = DVec3::ZERO;
    }
    for drive in system.drives() {
        let first = drive.at(0.0);
        (state.position[drive.node], state.velocity[drive.node]) = (first, (drive.at(dt) - first) / dt);
    }
    for (body, rotation) in system.bodies().iter().zip(&state.rotation) {
        let (x, v) = (state.position[body.centre], state.velocity[body.centre]);
        let centre = Moving { x, v, w: v };
        for_each_tie(body, &Turning::starting(*rotation), centre, |tie, moving| {
            (state.position[tie], state.velocity[tie]) = (moving.x, moving.w);
        });
    }
    state
}

/// The velocities of ties at a step, m/s, (nodes,): those of their bodies.
pub(super) fn carried_velocities(system: &System, rotation: &[Rotation], position: &[DVec3], velocity: &mut [DVec3]) {
    for (body, rotation) in system.bodies().iter().zip(rotation) {
        let spin = body.angular_velocity(rotation);
        for tie in &body.ties {
            velocity[tie.node] = velocity[body.centre] + spin.cross(position[tie.node] - position[body.centre]);
        }
    }
}

/// Where a body's ties are and how they move at a step, with the centre as it is then; both velocities are those of the
/// step.
fn for_each_tie(body: &Body, turning: &Turning, centre: Moving, mut put: impl FnMut(usize, Moving)) {
    let orientation = turning.half_step.orientation;
    let spin = body.angular_velocity(&Rotation { orientation, angular_momentum: turning.extrapolated });
    for tie in &body.ties {
        let arm = orientation * tie.arm;
        let w = centre.w + spin.cross(arm);
        put(tie.node, Moving { x: centre.x + arm, v: w, w });
    }
}

//! What air does beside the drag of ropes: to sheets, to bodies, and by its own inertia.

use glam::{DQuat, DVec3};

use super::attached::Moving;
use super::elements::Elements;
use super::step::Team;
use super::traced::Traced;
use crate::air::{Air, Attitude};
use crate::forces::added_mass::{self, Arm};
use crate::forces::element::Stress;
use crate::forces::sheet_drag;
use crate::system::System;

/// Sheets and bodies that drag, and ropes that take the medium along.
pub(super) struct Airborne<'a> {
    system: &'a System,
    air: &'a Air,
    sheets: Elements<3>,
    /// The drag of each body.
    bodies: Vec<Traced>,
    /// Segments at each node, (nodes,); empty where nothing is taken along.
    arms: Vec<Vec<Arm>>,
    /// The segments that break at the last forces.
    leaving: Vec<usize>,
    /// The force of the medium's inertia on each node, (nodes,).
    inertia: Vec<Traced>,
}

impl<'a> Airborne<'a> {
    /// None where air does nothing of the kind.
    pub fn new(system: &'a System) -> Option<Self> {
        let air = system.environment().air.as_ref()?;
        let arms = if air.added_mass > 0.0 { added_mass::arms(system, air) } else { Vec::new() };
        (!air.sheets.is_empty() || !air.bodies.is_empty() || !arms.is_empty()).then(|| Airborne {
            system,
            air,
            sheets: Elements::new(air.sheets.iter().map(|sheet| sheet.nodes).collect()),
            bodies: vec![Traced::default(); air.bodies.len()],
            inertia: vec![Traced::default(); arms.len()],
            arms,
            leaving: Vec::new(),
        })
    }

    /// A segment breaks: it takes the medium along for the last time.
    pub fn leave(&mut self, segment: usize) {
        self.leaving.push(segment);
    }

    /// Nodes have moved.
    pub fn let_go(&mut self) {
        std::mem::take(&mut self.leaving).into_iter().for_each(|segment| self.remove(segment));
    }

    /// A segment is no more.
    pub fn remove(&mut self, segment: usize) {
        for end in self.system.segments()[segment].ends {
            self.arms.get_mut(end).into_iter().for_each(|arms| arms.retain(|arm| arm.segment != segment));
        }
    }

    /// The nodes on which it acts, those of sheets apart.
    pub fn touched(system: &System) -> impl Iterator<Item = usize> {
        system.environment().air.iter().flat_map(|air| {
            let taking_along = if air.added_mass > 0.0 { 0..system.mass().len() } else { 0..0 };
            air.bodies.iter().map(|body| body.node).chain(taking_along)
        })
    }

    /// Adds the drag of sheets and bodies at `time`, s, to `force`, N, (nodes,), and returns the work done on the air
    /// since the forces before, J. `of_sheet` tells where a node of a sheet is and how it moves, `moving` any node,
    /// `turned` how a rigid body is turned.
    pub fn drag(
        &mut self,
        team: &Team,
        time: f64,
        of_sheet: impl Fn(usize) -> (DVec3, DVec3) + Sync,
        moving: impl Fn(usize) -> (DVec3, DVec3),
        turned: impl Fn(usize) -> DQuat,
        force: &mut [DVec3],
    ) -> f64 {
        // those that the forces before were the last of are told again if these are the same
        self.leaving.clear();
        let (air, gust) = (self.air, self.air.wind.fluctuation.at(time));
        let pressed = |index: usize, x: [DVec3; 3], w: [DVec3; 3]| {
            let height = (x[0].z + x[1].z + x[2].z) / 3.0;
            let (wind, density) = (air.wind(height, gust), air.medium.density(height));
            let third = sheet_drag::force(x, w, wind, density, air.sheets[index].coefficient) / 3.0;
            Stress { elastic: [DVec3::ZERO; 3], friction: [third; 3] }
        };
        let mut work = self.sheets.pull(team, pressed, of_sheet, force);
        for (body, traced) in air.bodies.iter().zip(&mut self.bodies) {
            let (place, velocity) = moving(body.node);
            let orientation = match body.attitude {
                Attitude::Fixed(orientation) => orientation,
                Attitude::Body(index) => turned(index),
            };
            let relative = orientation.inverse() * (air.wind(place.z, gust) - velocity);
            let (density, viscosity) = (air.medium.density(place.z), air.medium.viscosity());
            let drag = orientation * body.shape.force(relative, density, viscosity);
            force[body.node] += drag;
            work -= traced.work(drag, place);
        }
        work
    }

    /// Adds the force of the medium's inertia to `force`, N, (nodes,), and returns the work done on it since the forces
    /// before, J. `all` tells all other forces on a node, N; `place` where a node is, m.
    pub fn take_along(
        &mut self,
        all: impl Fn(usize, DVec3) -> DVec3,
        place: impl Fn(usize) -> DVec3,
        force: &mut [DVec3],
    ) -> f64 {
        let (system, mut work) = (self.system, 0.0);
        for (node, (arms, traced)) in self.arms.iter().zip(&mut self.inertia).enumerate() {
            // what has lost its last segment has pulled until now
            if arms.is_empty() && !traced.is_acting() {
                continue;
            }
            let (mass, at) = (system.mass()[node], place(node));
            let others = all(node, force[node]) + mass * system.environment().gravity;
            let spans = arms.iter().map(|arm| (arm.taken_along, place(arm.to) - at));
            let inertia = if arms.is_empty() { DVec3::ZERO } else { added_mass::force(mass, others, spans) };
            force[node] += inertia;
            work -= traced.work(inertia, at);
        }
        work
    }
}

/// How a node moves, as elements ask for it.
pub(super) fn as_seen(Moving { x, v: _, w }: Moving) -> (DVec3, DVec3) {
    (x, w)
}

//! What air does beside the drag of ropes: to sheets, to bodies, and by its own inertia.

use std::collections::BTreeSet;

use glam::{DQuat, DVec3};

use super::attached::Moving;
use super::elements::Elements;
use super::step::Team;
use crate::air::{Air, Attitude};
use crate::forces::added_mass::{self, Arm};
use crate::forces::element::Stress;
use crate::forces::sheet_drag;
use crate::system::System;

/// Sheets and bodies that drag, and ropes that take the medium along.
pub(super) struct Airborne<'a> {
    air: &'a Air,
    sheets: Elements<3>,
    /// Drag of each body, N, and where it was, m, at the last forces.
    bodies: Vec<(DVec3, DVec3)>,
    /// Segments at each node, (nodes,); empty where nothing is taken along.
    arms: Vec<Vec<Arm>>,
    /// The segments that break at the last forces.
    leaving: Vec<usize>,
    /// Force of the medium's inertia on each node, N, and where it was, m, at the last forces, (nodes,).
    inertia: Vec<(DVec3, DVec3)>,
}

impl<'a> Airborne<'a> {
    /// None where air does nothing of the kind.
    pub fn new(system: &'a System) -> Option<Self> {
        let air = system.environment().air.as_ref()?;
        let arms = if air.added_mass > 0.0 { added_mass::arms(system, air) } else { Vec::new() };
        (!air.sheets.is_empty() || !air.bodies.is_empty() || !arms.is_empty()).then(|| Airborne {
            air,
            sheets: Elements::new(air.sheets.iter().map(|sheet| sheet.nodes).collect()),
            bodies: vec![(DVec3::ZERO, DVec3::ZERO); air.bodies.len()],
            inertia: vec![(DVec3::ZERO, DVec3::ZERO); arms.len()],
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
        self.arms.iter_mut().for_each(|arms| arms.retain(|arm| arm.segment != segment));
    }

    /// The nodes on which it acts.
    pub fn touched(system: &System) -> BTreeSet<usize> {
        let Some(air) = &system.environment().air else { return BTreeSet::new() };
        let taking_along = if air.added_mass > 0.0 { 0..system.mass().len() } else { 0..0 };
        let sheets = air.sheets.iter().flat_map(|sheet| sheet.nodes);
        sheets.chain(air.bodies.iter().map(|body| body.node)).chain(taking_along).collect()
    }

    /// Adds the drag of sheets and bodies at `time`, s, to `force`, N, (nodes,), and returns the work done on the air
    /// since the forces before, J. `moving` tells where a node is and how it moves, `turned` how a rigid body is turned.
    pub fn drag(
        &mut self,
        team: &Team,
        time: f64,
        moving: impl Fn(usize) -> (DVec3, DVec3) + Sync,
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
        let mut work = self.sheets.pull(team, pressed, &moving, force);
        for (body, (last_force, last_place)) in air.bodies.iter().zip(&mut self.bodies) {
            let (place, velocity) = moving(body.node);
            let orientation = match body.attitude {
                Attitude::Fixed(orientation) => orientation,
                Attitude::Body(index) => turned(index),
            };
            let relative = orientation.inverse() * (air.wind(place.z, gust) - velocity);
            let (density, viscosity) = (air.medium.density(place.z), air.medium.viscosity());
            let drag = orientation * body.shape.force(relative, density, viscosity);
            force[body.node] += drag;
            work -= 0.5 * (*last_force + drag).dot(place - *last_place);
            (*last_force, *last_place) = (drag, place);
        }
        work
    }

    /// Adds the force of the medium's inertia to `force`, N, (nodes,), and returns the work done on it since the forces
    /// before, J. `all` tells all other forces on a node, N; `place` where a node is, m.
    pub fn take_along(
        &mut self,
        system: &System,
        all: impl Fn(usize, DVec3) -> DVec3,
        place: impl Fn(usize) -> DVec3,
        force: &mut [DVec3],
    ) -> f64 {
        let mut work = 0.0;
        for (node, (arms, (last_force, last_place))) in self.arms.iter().zip(&mut self.inertia).enumerate() {
            if arms.is_empty() {
                continue;
            }
            let (mass, at) = (system.mass()[node], place(node));
            let others = all(node, force[node]) + mass * system.environment().gravity;
            let spans = arms.iter().map(|arm| (arm.taken_along, place(arm.to) - at));
            let inertia = added_mass::force(mass, others, spans);
            force[node] += inertia;
            work -= 0.5 * (*last_force + inertia).dot(at - *last_place);
            (*last_force, *last_place) = (inertia, at);
        }
        work
    }
}

/// How a node moves, as elements ask for it.
pub(super) fn as_seen(Moving { x, v: _, w }: Moving) -> (DVec3, DVec3) {
    (x, w)
}

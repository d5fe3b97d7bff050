//! That a system's parts fit each other, and have values that can be computed with.

use glam::DVec3;

use super::{Environment, SystemError, SystemParts};
use crate::air::{Air, Attitude};
use crate::forces::breaking::Breaking;
use crate::forces::element::Element;
use crate::forces::ground::{Ground, Spring};
use crate::forces::orbit::Orbit;

impl SystemParts {
    /// The first thing that is out of range, if there is one.
    pub(super) fn check(&self) -> Result<(), SystemError> {
        let nodes = self.mass.len();
        if nodes == 0 {
            return Err(SystemError::Empty);
        }
        for (what, found) in [("held", self.held.len()), ("tractor", self.tractor.len())] {
            if found != nodes {
                return Err(SystemError::Shape { what, found, expected: nodes });
            }
        }
        self.check_attached()?;
        let mut carried = vec![false; nodes];
        for tie in self.bodies.iter().flat_map(|body| &body.ties) {
            carried[tie.node] = true;
        }
        for (node, &mass) in self.mass.iter().enumerate() {
            let enough = if carried[node] {
                mass == 0.0
            } else if self.held[node] {
                mass >= 0.0
            } else {
                mass > 0.0
            };
            if !(enough && mass.is_finite()) {
                return Err(SystemError::Mass { node, mass });
            }
        }
        for (segment, s) in self.segments.iter().enumerate() {
            let [a, b] = s.ends;
            if a == b || a >= nodes || b >= nodes {
                return Err(SystemError::Ends { segment, ends: s.ends, nodes });
            }
            let checks = [
                ("rest length, m", s.rest_length, s.rest_length > 0.0),
                ("stiffness, N/m", s.stiffness, s.stiffness > 0.0),
                ("damping, N s/m", s.damping, s.damping >= 0.0),
                ("class", s.class as f64, s.class < self.laws.len()),
            ];
            for (what, value, holds) in checks {
                if !(holds && value.is_finite()) {
                    return Err(SystemError::Property { segment, what, value });
                }
            }
            let Breaking { load, strain } = s.breaking;
            let most = [("breaking load, N", load), ("breaking strain", strain)];
            // infinite: it never breaks
            if let Some((what, value)) = most.into_iter().find(|(_, value)| value.is_nan() || *value <= 0.0) {
                return Err(SystemError::Property { segment, what, value });
            }
        }
        for (class, law) in self.laws.iter().enumerate() {
            let wrong = law.parameters().into_iter().find(|(_, value, holds)| !(*holds && value.is_finite()));
            if let Some((what, value, _)) = wrong {
                return Err(SystemError::Law { class, what, value });
            }
        }
        let Environment { gravity, mass_damping, ref air, ref ground, orbit } = self.environment;
        air.iter().try_for_each(|air| self.check_air(air))?;
        ground.iter().try_for_each(|ground| self.check_ground(ground))?;
        if !gravity.is_finite() {
            return Err(SystemError::Environment { what: "gravity, m/s^2", value: gravity.length() });
        }
        if !(mass_damping >= 0.0 && mass_damping.is_finite()) {
            return Err(SystemError::Environment { what: "damping, 1/s", value: mass_damping });
        }
        let is_unit = |way: DVec3| (way.length_squared() - 1.0).abs() < 1e-9;
        if let Some(Orbit { mean_motion, radial, along }) = orbit
            && !(mean_motion >= 0.0
                && mean_motion.is_finite()
                && is_unit(radial)
                && is_unit(along)
                && radial.dot(along).abs() < 1e-9)
        {
            return Err(SystemError::Environment { what: "mean motion, 1/s, or one of its axes", value: mean_motion });
        }
        Ok(())
    }

    /// That what drags is there, and its values can be computed with.
    fn check_air(&self, air: &Air) -> Result<(), SystemError> {
        let (nodes, classes) = (self.mass.len(), self.laws.len());
        if air.ropes.len() != classes {
            let what = "drag of ropes, link classes of it";
            return Err(SystemError::Environment { what, value: air.ropes.len() as f64 });
        }
        let wrong = |what, index, node, why| Err(SystemError::Attached { what, index, node, why });
        for (index, sheet) in air.sheets.iter().enumerate() {
            if let Some(&node) = sheet.nodes.iter().find(|&&node| node >= nodes) {
                return wrong("drag of a sheet", index, node, "does not exist");
            }
        }
        for (index, body) in air.bodies.iter().enumerate() {
            let is_there = match body.attitude {
                Attitude::Fixed(_) => body.node < nodes,
                Attitude::Body(at) => self.bodies.get(at).is_some_and(|own| own.centre == body.node),
            };
            if !is_there {
                return wrong("drag of a body", index, body.node, "does not exist, or is not that body's centre");
            }
        }
        let of_ropes = air.ropes.iter().flatten().flat_map(|rope| {
            let normal = rope.normal.unwrap_or_default();
            [("diameter of a rope that drags, m", rope.diameter), ("normal coefficient", normal)]
                .into_iter()
                .chain([("tangential coefficient", rope.tangential), ("solidity", rope.solidity)])
        });
        let of_sheets = air
            .sheets
            .iter()
            .flat_map(|sheet| [("coefficient of a sheet", sheet.coefficient), ("area of a sheet, m^2", sheet.area)]);
        let own = [
            ("density, kg/m^3", air.medium.density(0.0)),
            ("viscosity, Pa s", air.medium.viscosity()),
            ("added mass", air.added_mass),
            ("fastest wind, m/s", air.fastest),
        ];
        let wrong = of_ropes.chain(of_sheets).chain(own).find(|(_, value)| !(*value >= 0.0 && value.is_finite()));
        wrong.map_or(Ok(()), |(what, value)| Err(SystemError::Environment { what, value }))
    }

    /// That what the ground touches is there, and its values can be computed with.
    fn check_ground(&self, ground: &Ground) -> Result<(), SystemError> {
        let wrong = |what, index, node, why| Err(SystemError::Attached { what, index, node, why });
        for (index, footing) in ground.nodes.iter().enumerate() {
            if self.mass.get(footing.node).is_none_or(|&mass| mass == 0.0) || !footing.radius.is_finite() {
                return wrong("contact of the ground", index, footing.node, "does not exist, or has no mass");
            }
        }
        for (index, hull) in ground.hulls.iter().enumerate() {
            if hull.body >= self.bodies.len() || !(hull.arm.is_finite() && hull.radius.is_finite()) {
                return wrong("contact of the ground", index, hull.body, "is no body");
            }
        }
        let springs = ground.nodes.iter().map(|at| at.spring).chain(ground.hulls.iter().map(|hull| hull.spring));
        let values = springs.flat_map(|Spring { stiffness, damping, mass }| [stiffness, damping, mass]);
        let wrong =
            values.chain([ground.friction, ground.height.abs()]).find(|value| !(*value >= 0.0 && value.is_finite()));
        wrong.map_or(Ok(()), |value| Err(SystemError::Environment { what: "ground, in one of its numbers,", value }))
    }

    /// That loads, bodies, drives and launchers have nodes of the right kind, and values that can be computed with.
    fn check_attached(&self) -> Result<(), SystemError> {
        let nodes = self.mass.len();
        let wrong = |what, index, node, why| Err(SystemError::Attached { what, index, node, why });
        for (index, load) in self.loads.iter().enumerate() {
            if load.node >= nodes || !load.force.is_finite() {
                return wrong("load", index, load.node, "does not exist, or whose force is not finite");
            }
        }
        let bends = self.bends.iter().map(|bend| bend.nodes().to_vec());
        let membranes = self.membranes.iter().map(|membrane| membrane.nodes().to_vec());
        let hinges = self.hinges.iter().map(|hinge| hinge.nodes().to_vec());
        for (index, element) in bends.chain(membranes).chain(hinges).enumerate() {
            if let Some(&node) = element.iter().find(|&&node| node >= nodes) {
                return wrong("element", index, node, "does not exist");
            }
        }
        let mut taken = vec![false; nodes];
        for (index, body) in self.bodies.iter().enumerate() {
            if body.centre >= nodes || !(body.inertia.is_finite() && body.inertia.min_element() > 0.0) {
                return wrong("body", index, body.centre, "does not exist, or about which there is no inertia");
            }
            for tie in &body.ties {
                if tie.node >= nodes || self.held[tie.node] || taken[tie.node] || !tie.arm.is_finite() {
                    return wrong("body", index, tie.node, "does not exist, is held, or is tied to a body already");
                }
                taken[tie.node] = true;
            }
        }
        if let Some((index, body)) = self.bodies.iter().enumerate().find(|(_, body)| taken[body.centre]) {
            return wrong("body", index, body.centre, "is its centre and tied to a body");
        }
        for (index, drive) in self.drives.iter().enumerate() {
            let ascending = drive.path.windows(2).all(|pair| pair[0].0 < pair[1].0);
            let finite = drive.path.iter().all(|(time, place)| time.is_finite() && place.is_finite());
            if drive.node >= nodes || !self.held[drive.node] || drive.path.is_empty() || !(ascending && finite) {
                return wrong("drive", index, drive.node, "is not held, or whose path does not go forward in time");
            }
        }
        let mut launched = vec![false; nodes];
        for (index, launcher) in self.launchers.iter().enumerate() {
            let node = launcher.node;
            if node >= nodes || self.held[node] || taken[node] || std::mem::replace(&mut launched[node], true) {
                return wrong("launcher", index, node, "does not exist, is held, carried or launched twice");
            }
            if let Some(why) = launcher.fault() {
                return wrong("launcher", index, node, why);
            }
        }
        Ok(())
    }
}

//! Drag of sheets and bodies. The laws are [`crate::forces::sheet_drag`] and [`crate::forces::body_drag`]; ropes drag in
//! the engine, next to their tension.

use glam::DVec3;

use super::bound::Bound;
use super::contract::{Effect, Forces, Net, Now, Resting, seen};
use super::elements::Elements;
use super::traced::TracedWork;
use crate::air::wind::LinearTable;
use crate::air::{Air, Attitude};
use crate::channel::Channel;
use crate::forces::element::ElementForces;
use crate::forces::sheet_drag;
use crate::parts::{PartKind, SystemError, SystemParts};

/// Sheets and bodies that drag.
#[derive(Debug, Clone)]
pub(super) struct Drag {
    sheets: Elements<3>,
    /// The drag of each body.
    bodies: Vec<TracedWork>,
}

impl Effect for Drag {
    const NAME: &'static str = "drag";
    const CHANNELS: &'static [Channel] = &[Channel::Air];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let air = parts.environment.air.as_ref().filter(|air| !(air.sheets.is_empty() && air.bodies.is_empty()))?;
        let sheets = Elements::new(air.sheets.iter().map(|sheet| sheet.nodes).collect());
        Some(Drag { sheets, bodies: vec![TracedWork::default(); air.bodies.len()] })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        let Some(air) = &parts.environment.air else { return Ok(()) };
        check_nodes(parts, air)?;
        check_values(air)
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        Drag::asks(parts, act_on);
        if let Some(air) = &parts.environment.air {
            for body in &air.bodies {
                act_on(body.node);
            }
        }
    }

    fn asks(parts: &SystemParts, ask: &mut dyn FnMut(usize)) {
        if let Some(air) = &parts.environment.air {
            for node in air.sheets.iter().flat_map(|sheet| sheet.nodes) {
                ask(node);
            }
        }
    }

    /// A bound on the slope of drag against speed at each node, of ropes too: that of the force on a node, all nodes
    /// moving alike at the fastest wind for which the step has to be stable.
    fn bound(parts: &SystemParts, bound: &mut Bound) {
        let Some(air) = &parts.environment.air else { return };
        let (density, viscosity, fastest) = (air.medium.density(0.0), air.medium.viscosity(), air.fastest);
        // a force that grows with the square of speed has twice the slope that it has on the average
        let slope = |force: DVec3| 2.0 * force.abs().max_element() / fastest.max(f64::MIN_POSITIVE);
        for s in &parts.segments {
            if let Some(rope) = air.ropes[s.group] {
                let [across, along] = [DVec3::X, DVec3::Z]
                    .map(|way| slope(rope.force(DVec3::Z, fastest * way, s.rest_length, density, viscosity)));
                for end in s.ends {
                    bound.add_drag(Self::NAME, end, 0.5 * across.max(along));
                }
            }
        }
        for sheet in &air.sheets {
            let whole = density * sheet.coefficient * sheet.area * fastest;
            for node in sheet.nodes {
                bound.add_drag(Self::NAME, node, whole / 3.0);
            }
        }
        for body in &air.bodies {
            let along = DVec3::AXES.map(|way| slope(body.shape.force(fastest * way, density, viscosity)));
            bound.add_drag(Self::NAME, body.node, along.iter().sum());
        }
    }

    /// The air as it is at the start, for a net of which only some bodies turn.
    fn at_rest(parts: &SystemParts, resting: &Resting, rest: &mut SystemParts) {
        let Some(mut air) = parts.environment.air.clone() else { return };
        air.added_mass = 0.0;
        air.wind.fluctuation = LinearTable::constant(air.wind.fluctuation.at(0.0));
        for body in &mut air.bodies {
            if let Attitude::Body(index) = body.attitude {
                let kept = resting.turning_body(index);
                body.attitude = kept.map_or(Attitude::Fixed(resting.turned[index]), Attitude::Body);
            }
        }
        rest.environment.air = Some(air);
    }

    fn act<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        let Some(air) = &now.parts.environment.air else { return };
        let gust = air.wind.fluctuation.at(now.time);
        let press = |index: usize, x: [DVec3; 3], w: [DVec3; 3]| {
            let height = (x[0].z + x[1].z + x[2].z) / 3.0;
            let (wind, density) = (air.wind(height, gust), air.medium.density(height));
            let third = sheet_drag::force(x, w, wind, density, air.sheets[index].coefficient) / 3.0;
            ElementForces { elastic: [DVec3::ZERO; 3], dissipative: [third; 3] }
        };
        let mut work = self.sheets.pull(now.team, press, |node| now.seen[node], &mut out.force);
        for (body, traced) in air.bodies.iter().zip(&mut self.bodies) {
            let (place, velocity) = seen(net.node(body.node));
            let orientation = match body.attitude {
                Attitude::Fixed(orientation) => orientation,
                Attitude::Body(index) => now.turning[index].half_step.orientation,
            };
            let relative = orientation.inverse() * (air.wind(place.z, gust) - velocity);
            let (density, viscosity) = (air.medium.density(place.z), air.medium.viscosity());
            let drag = orientation * body.shape.force(relative, density, viscosity);
            out.force[body.node] += drag;
            work -= traced.work(drag, place);
        }
        out.work[Channel::Air] += work;
    }
}

/// That what drags is there.
fn check_nodes(parts: &SystemParts, air: &Air) -> Result<(), SystemError> {
    let (nodes, groups) = (parts.mass.len(), parts.laws.len());
    if air.ropes.len() != groups {
        let what = "number of groups with a drag of ropes";
        return Err(SystemError::Environment { what, value: air.ropes.len() as f64 });
    }
    for (index, sheet) in air.sheets.iter().enumerate() {
        if let Some(&node) = sheet.nodes.iter().find(|&&node| node >= nodes) {
            return Err(SystemError::attached(PartKind::SheetDrag, index, node, "does not exist"));
        }
    }
    for (index, body) in air.bodies.iter().enumerate() {
        let is_there = match body.attitude {
            Attitude::Fixed(_) => body.node < nodes,
            Attitude::Body(at) => parts.bodies.get(at).is_some_and(|own| own.centre == body.node),
        };
        if !is_there {
            let why = "does not exist, or is not that body's centre";
            return Err(SystemError::attached(PartKind::BodyDrag, index, body.node, why));
        }
    }
    Ok(())
}

/// That its values can be computed with.
fn check_values(air: &Air) -> Result<(), SystemError> {
    let of_ropes = air.ropes.iter().flatten().flat_map(|rope| {
        let normal = rope.normal.unwrap_or_default();
        [
            ("diameter of a rope that drags, m", rope.diameter),
            ("normal coefficient", normal),
            ("tangential coefficient", rope.tangential),
            ("solidity", rope.solidity),
        ]
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

//! Density of a packed web, and the clearance between its ropes.

use std::f64::consts::PI;

use netcast_scenario::Rope;
use netcast_webs::{Class, Closeness, PACKED_FILL, Size, closeness};

use super::material::rest_lengths;
use crate::Model;

/// Figures of the packed web that its audit does not have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Packing {
    /// Mass of the web over the volume of the smallest cylinder about the launch axis that holds its nodes, kg/m^3;
    /// traction ropes and tractors are not counted. None where the web lies flat.
    pub density: Option<f64>,
    /// Share of that cylinder's volume that ropes, canopies and payloads fill. None where the web lies flat.
    pub solid_fraction: Option<f64>,
    /// Least distance of ropes that are not tied together; places in the world frame. None where too many ropes lie near
    /// each other to be compared.
    pub closeness: Option<Closeness>,
}

impl Model {
    /// Figures of the packed web. Takes up to a few seconds where many ropes lie near each other.
    pub fn packing(&self) -> Packing {
        let web = &self.cut.web;
        let is_web = self.cut.is_web();
        let to_launch_frame = self.frame.transpose();
        let nodes = self.state.position.iter().zip(is_web).filter(|(_, is_web)| *is_web);
        let room = Size::of(nodes.map(|(&node, _)| to_launch_frame * node)).volume();
        let diameters = self.rope_diameters();
        let lengths = rest_lengths(web.ropes.len(), &self.members);
        let ropes = web.ropes.iter().zip(&diameters).zip(&lengths);
        let ropes = ropes.filter(|((rope, _), _)| rope.class != Class::Traction);
        let rope_volume: f64 = ropes.map(|((_, d), length)| 0.25 * PI * d * d * length).sum();
        let carried = self.bill.packed_volume * PACKED_FILL - self.bill.rope_volume;
        let over_room = |amount: f64| Some(amount / room).filter(|_| room > 0.0);
        Packing {
            density: over_room(self.bill.web_mass()),
            solid_fraction: over_room(rope_volume + carried),
            closeness: closeness(&self.cut, &self.state.position, &diameters),
        }
    }

    /// Diameter of each rope of the web, m, (ropes,).
    fn rope_diameters(&self) -> Vec<f64> {
        let mut diameters = vec![0.0; self.cut.web.ropes.len()];
        for (segment, member) in self.cut.segments().zip(&self.members) {
            let name = self.groups[member.segment.group].rope.as_ref();
            let kind: &Rope = name.and_then(|name| self.scenario.ropes.get(name)).unwrap_or(&self.scenario.rope);
            diameters[segment.rope] = kind.diameter.si();
        }
        diameters
    }
}

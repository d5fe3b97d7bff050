//! Figures of a web in air, for a check before the run: Reynolds numbers, drag coefficients, speed of fall.

use glam::DVec3;
use netcast_dynamics::air::{Air, BodyDrag};
use netcast_dynamics::forces::body_drag::Shape;
use netcast_dynamics::forces::rope_drag::RopeDrag;
use netcast_scenario::Scenario;
use netcast_webs::Class;

use super::air_outline::AirOutline;
use crate::Model;

/// The ropes of one name in the air. Ropes that drag as a screen form an entry of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct RopesInAir {
    /// The name of their rope.
    pub rope: String,
    /// Whether they drag as a screen.
    pub screened: bool,
    /// Its diameter times their length, m^2.
    pub area: f64,
    /// Reynolds number by their diameter at the launch speed.
    pub reynolds: f64,
    /// Normal drag coefficient at that Reynolds number, with the effect of the screen.
    pub normal: f64,
}

/// How a web falls through the air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fall {
    /// At this terminal speed, m/s.
    At(f64),
    /// It does not fall: it is no heavier than the medium that it displaces.
    Floats,
    /// Without a terminal speed: it has no drag.
    Unhindered,
}

/// Time of a fall, in multiples of 1 / damping, beyond which it is long.
const LONG: f64 = 10.0;
/// Bisections of the terminal speed, more than the digits of a double.
const HALVINGS: usize = 80;

impl Model {
    /// The ropes in the air by name, in the order of the groups; empty without air.
    pub fn ropes_in_air(&self) -> Vec<RopesInAir> {
        let (Some(air), Some(outline)) = (&self.system.environment().air, &self.air) else { return Vec::new() };
        let mut found: Vec<RopesInAir> = Vec::new();
        for (group, area, drag) in self.rope_areas(air) {
            let Some(rope) = &self.groups[group].rope else { continue };
            let reynolds = reynolds(air, drag, outline.launch_speed);
            let (normal, screened) = (drag.coefficient(reynolds), drag.solidity > 0.0);
            match found.iter_mut().find(|known| known.rope == *rope && known.screened == screened) {
                Some(known) => known.area += area,
                None => found.push(RopesInAir { rope: rope.clone(), screened, area, reynolds, normal }),
            }
        }
        found
    }

    /// How the web falls, flat and level, without tractors and traction ropes; none without air. The terminal speed balances
    /// weight, buoyancy and drag.
    pub fn fall(&self) -> Option<Fall> {
        let (air, outline) = (self.system.environment().air.as_ref()?, self.air.as_ref()?);
        let weight = self.bill.web_mass() * self.system.environment().gravity.length() - outline.web_buoyancy;
        if weight <= 0.0 {
            return Some(Fall::Floats);
        }
        let ropes: Vec<_> =
            self.rope_areas(air).filter(|(group, ..)| self.groups[*group].class != Class::Traction).collect();
        let (density, viscosity) = (air.medium.density(0.0), air.medium.viscosity());
        // the z axis of each body is normal to the web
        let is_carried = |body: &&BodyDrag| !self.system.tractor()[body.node];
        let bodies: Vec<Shape> = air.bodies.iter().filter(is_carried).map(|body| body.shape).collect();
        let sheets: f64 = air.sheets.iter().map(|sheet| sheet.coefficient * sheet.area).sum();
        let drag = |speed: f64| {
            let ropes: f64 =
                ropes.iter().map(|(_, area, drag)| area * drag.coefficient(reynolds(air, drag, speed))).sum();
            let bodies: f64 = bodies.iter().map(|shape| shape.force(DVec3::Z * speed, density, viscosity).z).sum();
            0.5 * density * speed * speed * (ropes + sheets) + bodies
        };
        let (mut slow, mut fast) = (0.0, 1.0);
        while drag(fast) < weight {
            fast *= 2.0;
            if fast > 1e6 {
                return Some(Fall::Unhindered);
            }
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (slow + fast);
            if drag(middle) < weight { slow = middle } else { fast = middle }
        }
        Some(Fall::At(fast))
    }

    /// Each group of ropes with its projected area (diameter times length), m^2, and its drag.
    fn rope_areas<'a>(&'a self, air: &'a Air) -> impl Iterator<Item = (usize, f64, &'a RopeDrag)> {
        air.ropes.iter().enumerate().filter_map(|(group, drag)| {
            let drag = drag.as_ref()?;
            let segments = self.system.segments().iter().filter(|segment| segment.group == group);
            Some((group, drag.diameter * segments.map(|segment| segment.rest_length).sum::<f64>(), drag))
        })
    }
}

/// Reynolds number of a rope across its axis, `speed` in m/s, at the height of the muzzle.
fn reynolds(air: &Air, drag: &RopeDrag, speed: f64) -> f64 {
    air.medium.density(0.0) * speed * drag.diameter / air.medium.viscosity()
}

/// Notes on the air and on the mass damping that may stand for it. `gravity` is the system's, m/s^2; `falls` says that no
/// node is held.
pub fn notes(scenario: &Scenario, gravity: f64, air: Option<&AirOutline>, falls: bool) -> Vec<String> {
    let mut notes = Vec::new();
    let environment = &scenario.environment;
    let damping = environment.damping.si();
    let terminal = format!("{:.3} m/s (gravity / damping)", gravity / damping);
    if damping > 0.0 && environment.wind.is_some() {
        notes.push(
            "environment.damping acts against the world, not against the air: it holds back what the wind carries along, and \
             its drag comes on top of the air's; leave it out for all but comparisons"
                .to_owned(),
        );
    } else if damping > 0.0 && air.is_some() {
        notes.push(
            "environment.damping comes on top of the drag of the air, which it stands for: leave one of them out"
                .to_owned(),
        );
    }
    let time = scenario.solve.run_time().unwrap_or(0.0);
    if damping * time > LONG && gravity > 0.0 && falls {
        notes.push(format!(
            "environment.damping lets nothing fall faster than {terminal}, heavy or light, and nothing drift: over {time} s \
             that is no stand-in for air"
        ));
    }
    if let Some(air) = air.filter(|air| air.sizeless > 0) {
        let what = if air.sizeless == 1 { "1 particle has" } else { &format!("{} particles have", air.sizeless) };
        notes.push(format!("{what} no size: the air passes by; give it a `diameter`, or another shape"));
    }
    notes
}

//! Where the energy is and where it went.

use serde::{Deserialize, Serialize};

use crate::forces::law::{Axial, RopeState};
use crate::forces::{gravity, load, mass_damping};
use crate::state::State;
use crate::system::{Environment, System};
use crate::time::elements;
use crate::time::step::StepSums;

/// The energy balance at one time, J. What is stored is computed from the state; what was lost is the
/// integral of its own power or work, step by step (trapezoidal rule). None is found by difference.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Kinetic energy of everything.
    pub kinetic: f64,
    /// Of that, the energy of the web: everything but the tractors.
    pub kinetic_web: f64,
    /// Elastic energy of segments, bent ropes and sheets.
    pub elastic: f64,
    /// Potential energy of weight, relative to the origin.
    pub gravity: f64,
    /// Potential energy of loads that are there from the start, relative to the origin, less the work of the others.
    pub load: f64,
    /// Lost to damping inside ropes since the start.
    pub rope_damping: f64,
    /// Lost to damping inside sheets since the start.
    pub sheet_damping: f64,
    /// Lost to hysteresis of ropes since the start.
    pub rope_hysteresis: f64,
    /// Elastic energy of the segments that broke since the start, and of the bends over them, as they broke.
    pub rupture: f64,
    /// Lost to mass-proportional damping since the start.
    pub mass_damping: f64,
    /// Work done on what moves driven nodes since the start; negative where these have moved the net.
    pub drive: f64,
    /// Work done on launchers since the start; negative where these have thrown.
    pub launch: f64,
    /// Work done on the air since the start; negative where wind has driven the net.
    pub air: f64,
    /// Work done on the inertia of the medium around ropes since the start.
    pub added_mass: f64,
    /// Elastic energy of the ground.
    pub ground: f64,
    /// Lost to the ground since the start.
    pub ground_friction: f64,
    /// Potential energy beside an orbit, relative to the origin.
    pub orbit: f64,
}

impl Ledger {
    /// The energy that follows from a state; of what was lost that is hysteresis.
    pub fn of(system: &System, state: &State, ropes: &RopeState) -> Ledger {
        let State { position, velocity, rotation } = state;
        let Environment { ground, orbit, .. } = system.environment();
        let mut ledger = Ledger {
            gravity: gravity::energy(system.environment().gravity, system.mass(), position),
            load: load::energy(system.loads(), position),
            ground: ground.as_ref().map_or(0.0, |ground| ground.energy(system, state)),
            orbit: orbit.map_or(0.0, |orbit| orbit.energy(system, state)),
            ..Ledger::default()
        };
        for (node, v) in velocity.iter().enumerate() {
            let energy = 0.5 * system.mass()[node] * v.length_squared();
            ledger.kinetic += energy;
            if !system.tractor()[node] {
                ledger.kinetic_web += energy;
            }
        }
        for (body, rotation) in system.bodies().iter().zip(rotation) {
            let energy = body.rotational_energy(rotation);
            ledger.kinetic += energy;
            if !system.tractor()[body.centre] {
                ledger.kinetic_web += energy;
            }
        }
        for (segment, s) in system.segments().iter().enumerate() {
            let (law, axial, memory) = (system.law(s), Axial::from(s), ropes.memory_of(segment));
            if !ropes.broken[segment] {
                ledger.elastic += law.elastic_energy(s.stretch(position), &axial, &memory);
            }
            ledger.rope_hysteresis += law.hysteresis(&axial, &memory);
        }
        ledger.elastic += elements::elastic_energy(system.unbroken_bends(&ropes.broken), position)
            + elements::elastic_energy(system.membranes(), position)
            + elements::elastic_energy(system.hinges(), position);
        ledger
    }

    /// Every channel with its name. Their sum is constant in a perfect run. Taken apart field by field, so that a new
    /// channel cannot be forgotten here.
    pub fn channels(&self) -> [(&'static str, f64); 16] {
        let Ledger {
            kinetic,
            kinetic_web: _,
            elastic,
            gravity,
            load,
            rope_damping,
            sheet_damping,
            rope_hysteresis,
            rupture,
            mass_damping,
            drive,
            launch,
            air,
            added_mass,
            ground,
            ground_friction,
            orbit,
        } = *self;
        [
            ("kinetic", kinetic),
            ("elastic", elastic),
            ("gravity", gravity),
            ("load", load),
            ("rope_damping", rope_damping),
            ("sheet_damping", sheet_damping),
            ("rope_hysteresis", rope_hysteresis),
            ("rupture", rupture),
            ("mass_damping", mass_damping),
            ("drive", drive),
            ("launch", launch),
            ("air", air),
            ("added_mass", added_mass),
            ("ground", ground),
            ("ground_friction", ground_friction),
            ("orbit", orbit),
        ]
    }

    /// What is stored, kinetic and potential.
    pub fn stored(&self) -> f64 {
        self.kinetic + self.elastic + self.gravity + self.load + self.ground + self.orbit
    }

    /// The sum over all channels.
    pub fn sum(&self) -> f64 {
        self.channels().into_iter().map(|(_, energy)| energy).sum()
    }

    /// What is missing (or too much) since `start`.
    pub fn residual(&self, start: &Ledger) -> f64 {
        self.sum() - start.sum()
    }
}

/// How well the balance closes over a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    start: Ledger,
    largest_residual: f64,
    largest_mechanical: f64,
    lowest_weight: f64,
    largest_web: f64,
}

impl Balance {
    /// A balance that starts with `start`.
    pub fn new(start: Ledger) -> Balance {
        let mut balance = Balance {
            start,
            largest_residual: 0.0,
            largest_mechanical: f64::MIN,
            lowest_weight: f64::MAX,
            largest_web: 0.0,
        };
        balance.add(&start);
        balance
    }

    /// Takes a later ledger into account.
    pub fn add(&mut self, ledger: &Ledger) {
        self.largest_residual = self.largest_residual.max(ledger.residual(&self.start).abs());
        self.largest_mechanical = self.largest_mechanical.max(ledger.stored());
        self.lowest_weight = self.lowest_weight.min(ledger.gravity + ledger.load + ledger.orbit);
        self.largest_web = self.largest_web.max(ledger.kinetic_web + ledger.elastic);
    }

    /// Energy at the start, J: stored energy, the origin as the level of zero weight energy.
    pub fn initial(&self) -> f64 {
        self.start.sum()
    }

    /// What missing energy is counted from.
    pub(crate) fn start(&self) -> &Ledger {
        &self.start
    }

    /// Largest |residual| of the run, J.
    pub fn largest_residual(&self) -> f64 {
        self.largest_residual
    }

    /// |residual| over the largest total energy of the run; weight and loads count from the lowest that they reached.
    pub fn closure(&self) -> f64 {
        ratio(self.largest_residual, self.largest_mechanical - self.lowest_weight)
    }

    /// |residual| over the largest elastic and kinetic energy of everything but the tractors.
    pub fn closure_web(&self) -> f64 {
        ratio(self.largest_residual, self.largest_web)
    }
}

fn ratio(residual: f64, energy: f64) -> f64 {
    if residual == 0.0 { 0.0 } else { residual / energy.max(f64::MIN_POSITIVE) }
}

/// Running integrals of what is lost.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Losses {
    rope: f64,
    sheet: f64,
    rupture: f64,
    mass: Integral,
    load: f64,
    drive: f64,
    launch: f64,
    air: f64,
    added_mass: f64,
    ground: f64,
}

impl Losses {
    /// Adds the work of the forces of a step, since those of the step before.
    pub fn add_work(&mut self, sums: &StepSums) {
        let attached = &sums.attached;
        self.rope += sums.rope_work;
        self.air += sums.air_work;
        self.sheet += attached.sheet_work;
        self.load += attached.load_work;
        self.drive += attached.drive_work;
        self.launch += attached.launch_work;
        self.added_mass += attached.added_mass_work;
        self.ground += attached.ground_work;
        self.rupture += attached.rupture;
    }

    pub fn add_rupture(&mut self, energy: f64) {
        self.rupture += energy;
    }

    pub fn add_mass_power(&mut self, power: f64, dt: f64) {
        self.mass.add(power, dt);
    }

    /// The ledger of a state at which work has been added and the power of mass damping not yet.
    pub fn ledger(&self, system: &System, state: &State, ropes: &RopeState, dt: f64) -> Ledger {
        let mut mass = self.mass;
        mass.add(mass_damping::lost_power(system, state), dt);
        let now = Ledger::of(system, state, ropes);
        // taken apart, so that what is new cannot be forgotten here
        let Losses { rope, sheet, rupture, mass: _, load, drive, launch, air, added_mass, ground } = *self;
        Ledger {
            load: now.load - load,
            rope_damping: rope,
            sheet_damping: sheet,
            rupture,
            mass_damping: mass.value,
            drive,
            launch,
            air,
            added_mass,
            ground_friction: ground,
            ..now
        }
    }
}

/// Trapezoidal rule over equal steps.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
struct Integral {
    value: f64,
    last: Option<f64>,
}

impl Integral {
    fn add(&mut self, power: f64, dt: f64) {
        if let Some(last) = self.last {
            self.value += 0.5 * dt * (last + power);
        }
        self.last = Some(power);
    }
}

#[cfg(test)]
mod tests {
    use crate::system::{Environment, SystemParts};

    /// Does not compile when a part is added, until its channel is named here.
    #[test]
    fn every_part_of_a_system_has_its_channel() {
        let SystemParts {
            mass,
            held,
            tractor,
            segments,
            laws,
            bends,
            membranes,
            hinges,
            loads,
            bodies,
            drives,
            launchers,
            environment,
        } = SystemParts::default();
        let Environment { gravity, mass_damping, air, ground, orbit } = environment;
        let channels = [
            ("kinetic", mass.len() + held.len() + tractor.len() + bodies.len()),
            ("elastic", segments.len() + bends.len() + membranes.len() + hinges.len()),
            ("gravity", gravity.length() as usize),
            ("load", loads.len()),
            ("rope_damping", segments.len() + bends.len()),
            ("sheet_damping", membranes.len() + hinges.len()),
            ("rope_hysteresis", laws.len()),
            ("rupture", segments.len() + bends.len()),
            ("mass_damping", mass_damping as usize),
            ("drive", drives.len()),
            ("launch", launchers.len()),
            ("air", air.as_ref().map_or(0, |air| air.ropes.len())),
            ("added_mass", air.as_ref().map_or(0, |air| air.added_mass as usize)),
            ("ground", ground.as_ref().map_or(0, |ground| ground.nodes.len())),
            ("ground_friction", ground.as_ref().map_or(0, |ground| ground.hulls.len())),
            ("orbit", orbit.is_some() as usize),
        ];
        let names = super::Ledger::default().channels().map(|(name, _)| name);
        assert_eq!(channels.map(|(name, _)| name), names);
    }
}

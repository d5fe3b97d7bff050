//! The energy ledger: stored energy by channel, lost energy by channel, and how well they balance.

use std::ops::Index;

use serde::{Deserialize, Serialize};

use crate::channel::{ByChannel, Channel};
use crate::effects::Effects;
use crate::forces::gravity;
use crate::forces::law::Axial;
use crate::rope_state::RopeState;
use crate::state::State;
use crate::system::{Segment, System};

/// The energy balance at one time, J, one value for each channel. Stored energy is computed from the state. Lost energy is
/// integrated step by step from its own power or work (trapezoidal rule). No channel is found by difference.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    channels: ByChannel,
    /// Kinetic energy of the web alone, without the tractors, J.
    pub kinetic_web: f64,
}

impl Index<Channel> for Ledger {
    type Output = f64;

    fn index(&self, channel: Channel) -> &f64 {
        &self.channels[channel]
    }
}

impl Ledger {
    /// Energy stored in a system at the start, where nothing is lost yet.
    pub fn at_start(system: &System, state: &State) -> Ledger {
        let ropes = RopeState::at_rest(system, &state.position);
        Ledger::of(system, state, &ropes, Some(&Effects::at_rest(system.parts())))
    }

    /// Energy stored in a state, and hysteresis, the one loss that a state tells.
    pub(crate) fn of(system: &System, state: &State, ropes: &RopeState, effects: Option<&Effects>) -> Ledger {
        let mut ledger = Ledger::default();
        ledger.add_kinetic(system, state);
        let (gravity, masses) = (system.environment().gravity, state.position.iter().zip(system.mass()));
        ledger.channels[Channel::Gravity] = 0.0 - masses.map(|(x, m)| gravity::work(gravity, *m, *x)).sum::<f64>();
        for (segment, s) in system.segments().iter().enumerate() {
            let (law, axial, memory) = (system.law(s), Axial::from(s), ropes.memory_of(segment));
            if !ropes.broken[segment] {
                ledger.channels[Channel::Elastic] += law.elastic_energy(s.stretch(&state.position), &axial, &memory);
            }
            ledger.channels[Channel::RopeHysteresis] += law.hysteresis(&axial, &memory);
        }
        if let Some(effects) = effects {
            ledger.channels += effects.stored(state);
        }
        ledger
    }

    fn add_kinetic(&mut self, system: &System, state: &State) {
        let mut add = |node: usize, energy: f64| {
            self.channels[Channel::Kinetic] += energy;
            if !system.tractor()[node] {
                self.kinetic_web += energy;
            }
        };
        for (node, v) in state.velocity.iter().enumerate() {
            add(node, 0.5 * system.mass()[node] * v.length_squared());
        }
        for (body, rotation) in system.bodies().iter().zip(&state.rotation) {
            add(body.centre, body.rotational_energy(rotation));
        }
    }

    /// Stored energy, kinetic and potential, J.
    pub fn stored(&self) -> f64 {
        self.total(Channel::is_stored)
    }

    /// The sum over all channels. It is constant in a perfect run.
    pub fn sum(&self) -> f64 {
        self.channels.sum()
    }

    /// Energy missing (or gained) since `start`, J.
    pub fn residual(&self, start: &Ledger) -> f64 {
        self.sum() - start.sum()
    }

    fn total(&self, counts: fn(Channel) -> bool) -> f64 {
        Channel::ALL.iter().filter(|channel| counts(**channel)).map(|&channel| self[channel]).sum()
    }
}

/// A strain that nobody can measure: energy below that of ropes strained so much is not judged.
const LEAST_STRAIN: f64 = 1e-9;
/// How many times its last bit the largest term of the balance may be rounded by, on the way through a run.
const ROUNDING: f64 = 1e6;
/// The share of all energy from which that of the web is judged by itself.
const WEB_SHARE: f64 = 1e-3;

/// The energy, J, below which that of a system is noise: its ropes at the least strain.
pub(crate) fn least_energy(system: &System) -> f64 {
    let of_one = |s: &Segment| {
        let stretch = LEAST_STRAIN * s.rest_length;
        0.5 * system.law(s).largest_stiffness(&s.into()) * stretch * stretch
    };
    system.segments().iter().map(of_one).sum()
}

/// How well the balance closes over a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Balance {
    start: Ledger,
    /// Energy below which nothing is judged, J.
    least: f64,
    largest_residual: f64,
    largest_term: f64,
    largest_mechanical: f64,
    lowest_potential: f64,
    largest_web: f64,
}

impl Balance {
    /// A balance that starts with `start`; energy below `least`, J, is noise.
    pub fn new(start: Ledger, least: f64) -> Balance {
        let mut balance = Balance {
            start,
            least,
            largest_residual: 0.0,
            largest_term: 0.0,
            largest_mechanical: f64::MIN,
            lowest_potential: f64::MAX,
            largest_web: 0.0,
        };
        balance.add(&start);
        balance
    }

    /// Takes a later ledger into account.
    pub fn add(&mut self, ledger: &Ledger) {
        self.largest_residual = self.largest_residual.max(ledger.residual(&self.start).abs());
        self.largest_term = Channel::ALL.iter().map(|&channel| ledger[channel].abs()).fold(self.largest_term, f64::max);
        self.largest_mechanical = self.largest_mechanical.max(ledger.stored());
        self.lowest_potential = self.lowest_potential.min(ledger.total(Channel::is_potential));
        self.largest_web = self.largest_web.max(ledger.kinetic_web + ledger[Channel::Elastic]);
    }

    /// Energy at the start, J: stored energy, the origin as the level of zero weight energy.
    pub fn initial(&self) -> f64 {
        self.start.sum()
    }

    /// The ledger from which missing energy is counted.
    pub(crate) fn start(&self) -> &Ledger {
        &self.start
    }

    /// Largest |residual| of the run, J.
    pub fn largest_residual(&self) -> f64 {
        self.largest_residual
    }

    /// |residual| over the largest total energy of the run; weight and loads count from the lowest that they reached.
    pub fn closure(&self) -> f64 {
        ratio(self.largest_residual, self.total())
    }

    /// |residual| over the largest elastic and kinetic energy of everything but the tractors; a web that never has a
    /// thousandth of all energy is judged as if it had.
    pub fn closure_web(&self) -> f64 {
        ratio(self.largest_residual, self.largest_web.max(WEB_SHARE * self.total()))
    }

    /// The energy that the residual is judged by, J: no less than what rounding makes of the largest term.
    fn total(&self) -> f64 {
        let noise = ROUNDING * f64::EPSILON * self.largest_term;
        (self.largest_mechanical - self.lowest_potential).max(self.least).max(noise)
    }
}

fn ratio(residual: f64, energy: f64) -> f64 {
    if residual == 0.0 { 0.0 } else { residual / energy.max(f64::MIN_POSITIVE) }
}

/// Running integrals of lost energy.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Losses {
    work: ByChannel,
    mass: Integral,
}

impl Losses {
    /// Adds the work of a step's forces since the forces of the step before, J.
    pub fn add_work(&mut self, work: &ByChannel) {
        for &channel in Channel::ALL {
            self.work[channel] += work[channel];
        }
    }

    pub fn add_rupture(&mut self, energy: f64) {
        self.work[Channel::Rupture] += energy;
    }

    pub fn add_mass_power(&mut self, power: f64, dt: f64) {
        self.mass.add(power, dt);
    }

    /// `stored` plus the lost energy. `mass_power`, W, is that of mass damping at this state, not yet added.
    pub fn ledger(&self, stored: Ledger, mass_power: f64, dt: f64) -> Ledger {
        let (mut ledger, mut mass) = (stored, self.mass);
        mass.add(mass_power, dt);
        for &channel in Channel::ALL {
            ledger.channels[channel] += self.work[channel];
        }
        ledger.channels[Channel::MassDamping] = mass.value;
        ledger
    }
}

/// Power lost to mass-proportional damping by all nodes and turning bodies, W: alpha times the sum of m v^2 and of
/// L . omega.
pub(crate) fn mass_damping_power(system: &System, state: &State) -> f64 {
    let of_nodes: f64 = state.velocity.iter().zip(system.mass()).map(|(v, m)| m * v.length_squared()).sum();
    let turning = system.bodies().iter().zip(&state.rotation);
    let of_bodies: f64 = turning.map(|(body, rotation)| 2.0 * body.rotational_energy(rotation)).sum();
    system.environment().mass_damping * (of_nodes + of_bodies)
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

//! `[solve]`: what is solved, its duration, segment length and time step, and the tolerances of the energy balance.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{BelowOne, Positive};
use crate::quantity::{Length, Number, Time};

/// `[solve]`: what is solved, its duration, segment length and time step, and the tolerances of the energy balance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("anyOf" = [{"required": ["static"]}, {"required": ["duration"]}]))]
pub struct Solve {
    /// Time simulated, s. It may be left out where only the equilibrium is computed.
    pub duration: Option<Time<Positive>>,
    /// Computes the equilibrium under gravity, loads and pretension, in place of a run in time or before it. Default:
    /// none; only a run in time.
    #[serde(rename = "static")]
    pub statics: Option<Static>,
    /// Length of the segments that ropes are cut into, m. Default: chosen from the web, and printed.
    pub segment_length: Option<Length<Positive>>,
    /// Time step over the largest stable one, more than 0 and less than 1. Default: chosen for the energy balance,
    /// and printed.
    pub step_fraction: Option<Number<BelowOne>>,
    /// Largest permitted residual of the energy balance over the largest total energy of the run. Default: 0.003.
    #[serde(default = "default_energy_tolerance")]
    pub energy_tolerance: Number<Positive>,
    /// Largest permitted residual of the energy balance over the largest energy of the web, which is its elastic
    /// energy and the kinetic energy of all but the tractors. Default: 0.01.
    #[serde(default = "default_web_energy_tolerance")]
    pub web_energy_tolerance: Number<Positive>,
    /// What happens to a run whose energy balance exceeds a tolerance. Default: "stop".
    #[serde(default)]
    pub on_energy_error: OnEnergyError,
}

/// `[solve.static]`: the equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Static {
    /// Largest permitted net force on a node over the largest tension, bending force or load. Default: 1e-6.
    pub tolerance: Number<BelowOne>,
    /// Number of iterations after which the solver gives up. Default: 2000000.
    pub max_iterations: NonZeroU32,
    /// Whether a run of `solve.duration` starts from the equilibrium. Nodes with an initial speed are held until the
    /// run starts. Default: false.
    pub then_run: bool,
}

impl Default for Static {
    fn default() -> Self {
        Self {
            tolerance: Number::constant(1e-6),
            max_iterations: const { NonZeroU32::new(2_000_000).unwrap() },
            then_run: false,
        }
    }
}

impl Solve {
    /// Time simulated, s. `None` where only the equilibrium is computed.
    pub fn run_time(&self) -> Option<f64> {
        match self.statics {
            Some(Static { then_run: false, .. }) => None,
            _ => self.duration.map(|duration| duration.si()),
        }
    }
}

/// What happens to a run whose energy balance exceeds a tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OnEnergyError {
    /// The run fails.
    #[default]
    Stop,
    /// The run goes on, and its summary states the error.
    Flag,
}

fn default_energy_tolerance() -> Number<Positive> {
    Number::constant(0.003)
}

fn default_web_energy_tolerance() -> Number<Positive> {
    Number::constant(0.01)
}

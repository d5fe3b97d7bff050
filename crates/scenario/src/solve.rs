//! `[solve]`: what is solved, how long, how fine, and what the energy balance must hold.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{BelowOne, Positive};
use crate::quantity::{Length, Number, Time};

/// `[solve]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("anyOf" = [{"required": ["static"]}, {"required": ["duration"]}]))]
pub struct Solve {
    /// Time simulated, s. Not needed where the equilibrium is all that is asked for.
    pub duration: Option<Time<Positive>>,
    /// The equilibrium under weight, loads and pretension, instead of a run in time or before it. Left out: a run in
    /// time.
    #[serde(rename = "static")]
    pub statics: Option<Static>,
    /// Length of the segments that ropes are cut into, m. Left out: chosen from the web, and said.
    pub segment_length: Option<Length<Positive>>,
    /// Time step over the largest stable one. Left out: chosen for the energy balance, and said.
    pub step_fraction: Option<Number<BelowOne>>,
    /// Largest residual of the energy balance, over the largest total energy of the run.
    #[serde(default = "default_energy_tolerance")]
    pub energy_tolerance: Number<Positive>,
    /// Largest residual of the energy balance, over the largest energy of the web: elastic, and kinetic of all but the
    /// tractors.
    #[serde(default = "default_web_energy_tolerance")]
    pub web_energy_tolerance: Number<Positive>,
    /// What to do with a run whose energy balance misses a tolerance.
    #[serde(default)]
    pub on_energy_error: OnEnergyError,
}

/// `[solve.static]`
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Static {
    /// Largest force out of balance on any node, over the largest tension or load.
    pub tolerance: Number<BelowOne>,
    /// Iterations after which it is given up.
    pub max_iterations: NonZeroU32,
    /// Whether a run in time of `solve.duration` begins from it. What has a speed at the start is held until then.
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
    /// Time simulated, s: none where the equilibrium is all that is asked for.
    pub fn run_time(&self) -> Option<f64> {
        match self.statics {
            Some(Static { then_run: false, .. }) => None,
            _ => self.duration.map(|duration| duration.si()),
        }
    }
}

/// What to do with a run whose energy balance misses its tolerance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum OnEnergyError {
    /// The run has failed.
    #[default]
    Stop,
    /// The run goes on and its summary says so.
    Flag,
}

fn default_energy_tolerance() -> Number<Positive> {
    Number::constant(0.003)
}

fn default_web_energy_tolerance() -> Number<Positive> {
    Number::constant(0.01)
}

//! `[solve]`: how long, how fine, and what the energy balance must hold.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{BelowOne, Positive};
use crate::quantity::{Length, Number, Time};

/// `[solve]`
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Solve {
    /// Time simulated, s.
    pub duration: Time<Positive>,
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

//! Size of the model, time step and energy balance.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::quantity::section;

section! {
    /// Size and mass of the model.
    ModelSize, "model" {
        /// Number of nodes.
        nodes: usize => "Nodes", Count;
        /// Number of rope segments.
        segments: usize => "Segments", Count;
        /// Total rest length of all ropes.
        rope_length_m: f64 => "Rope length", Length, lower, headline;
        /// Mass of the web with its traction ropes, canopies and payloads, without tractors.
        web_mass_kg: f64 => "Mass of the web", Mass, lower, headline;
        /// Mass of all tractors.
        tractor_mass_kg: Option<f64> => "Mass of the tractors", Mass, lower, headline;
    }
}

section! {
    /// The time step and what limits it.
    StepSize, "step" {
        /// Step size.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        dt_s: f64 => "Time step", Duration;
        /// Steps taken.
        count: u64 => "Steps", Count;
        /// The part of the model that limits the time step: its stiffest or lightest.
        limited_by: Option<String> => "Time step limited by", Text;
        /// A change that would allow a larger time step.
        lifted_by: Option<String> => "Time step larger with", Text;
    }
}

section! {
    /// The energy balance at the end of the run. A number that a file lacks is read as NaN.
    EnergyBalance, "energy" {
        /// Total energy at the start.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        initial_j: f64 => "Total energy at the start", Energy;
        /// Total energy at the end.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        final_j: f64 => "Total energy at the end", Energy;
        /// Largest |residual| over the largest total energy of the run.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        closure: f64 => "Energy balance closes to", Share;
        /// Largest |residual| over the largest elastic and kinetic energy of everything but the tractors.
        closure_web: Option<f64> => "Energy balance of the web closes to", Share;
        /// Energy of each channel, integrated by itself and not found by difference.
        channels: BTreeMap<String, f64> => "Energy at the end, {}", Energy, by_name;
        /// Residual of the energy balance at the end: the energy that the channels do not account for.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        residual_j: f64 => "Energy residual", Energy;
        /// Largest residual at any check, from which the closure follows.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        largest_residual_j: f64 => "Largest energy residual", Energy, not_in_table;
        /// Largest closure that the scenario allows.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        tolerance: f64 => "Energy balance asked to close to", Share, not_in_table;
        /// Largest closure of the web that the scenario allows.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        tolerance_web: f64 => "Energy balance of the web asked to close to", Share, not_in_table;
    }
}

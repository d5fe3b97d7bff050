//! What was computed: the size of the model, the step, the energy balance.

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
        /// Length of all ropes at rest.
        rope_length_m: f64 => "Rope length", Length, lower, headline;
        /// Mass of the web with its traction ropes, canopies and payloads, without tractors.
        web_mass_kg: f64 => "Mass of the web", Mass, lower, headline;
        /// Mass of all tractors.
        tractor_mass_kg: Option<f64> => "Mass of the tractors", Mass, lower, headline;
    }
}

section! {
    /// The time step and what holds it down.
    StepSize, "step" {
        /// Step size.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        dt_s: f64 => "Time step", Duration;
        /// Steps taken.
        count: u64 => "Steps", Count;
        /// The stiffest or lightest place of the model.
        limited_by: Option<String> => "Time step limited by", Text;
        /// What would allow a larger one.
        lifted_by: Option<String> => "Time step larger with", Text;
    }
}

section! {
    /// The energy balance at the end of the run. What a file does not tell is read as not a number.
    EnergyBalance, "energy" {
        /// Total energy at the start.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        initial_j: f64 => "Total energy at the start", Energy;
        /// Total energy at the end.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        final_j: f64 => "Total energy at the end", Energy;
        /// |residual| over the largest total energy of the run.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        closure: f64 => "Energy balance closes to", Share;
        /// |residual| over the largest elastic and kinetic energy of everything but the tractors.
        closure_web: Option<f64> => "Energy balance of the web closes to", Share;
        /// Each channel of the energy, integrated in its own right.
        channels: BTreeMap<String, f64> => "Energy at the end, {}", Energy, by_name;
        /// What the channels leave unexplained at the end.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        residual_j: f64 => "Energy residual", Energy;
        /// The largest residual at any record time, by which the balance closes.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        largest_residual_j: f64 => "Largest energy residual", Energy, not_in_table;
        /// What the energy balance was asked to close to.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        tolerance: f64 => "Energy balance asked to close to", Share, not_in_table;
        /// What the energy balance of the web was asked to close to.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        tolerance_web: f64 => "Energy balance of the web asked to close to", Share, not_in_table;
    }
}

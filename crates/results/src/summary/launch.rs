//! How the run begins: what is launched, the packed web, the equilibrium.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::quantity::section;

section! {
    /// How the tractors were launched, as meant and as chance had it.
    Departures, "launch" {
        /// Angular speed of all that is launched at the start.
        spin_rad_s: f64 => "Spin at the start", AngularSpeed, not_in_table;
        parts:
        /// Each tractor's departure, by the number of its corner.
        tractors: BTreeMap<u32, Departure>;
        /// What the tubes push back with.
        recoil: Option<Recoil>;
    }
}

section! {
    /// How a tractor left: its muzzle where it has a tube, else where it was stowed.
    Departure, "launch.tractors.*" {
        /// When it left its muzzle, or where it was stowed; none where it never did.
        time_s: Option<f64> => "Departure of tractor {} at", Time, not_in_table;
        /// Its speed then.
        speed_m_s: Option<f64> => "Departure speed of tractor {}", Speed, not_in_table;
        /// Angle between its way and the launch axis.
        angle_rad: f64 => "Departure angle of tractor {}", Angle, not_in_table;
    }
}

section! {
    /// The push of all tubes together on what carries them.
    Recoil, "launch.recoil" {
        /// Largest force of all tubes together on what carries them.
        peak_n: f64 => "Peak recoil", Force, not_in_table;
        /// When it occurred.
        peak_time_s: f64 => "Time of peak recoil", Time, not_in_table;
        /// Size of the impulse of the recoil.
        impulse_n_s: f64 => "Impulse of the recoil", Impulse, not_in_table;
        /// The impulse of the recoil against the launch axis.
        axial_impulse_n_s: f64 => "Impulse of the recoil along the axis", Impulse, not_in_table;
    }
}

section! {
    /// The state at the start, looked over.
    StowedState, "stowed" {
        /// Length over rest length less 1 of the member that is stretched most: negative where all are slack.
        longest_stretch: Option<f64> => "Largest strain when packed", Strain;
        /// Which member that is.
        longest_stretch_where: Option<String> => "Largest strain when packed, in", Text;
        /// Number of members that are stretched.
        stretched: usize => "Stretched members when packed", Count;
        /// Elastic energy at the start.
        stored_energy_j: f64 => "Stored energy when packed", Energy;
        /// Largest distance of a node from the launch axis.
        packed_radius_m: f64 => "Packed radius", Length, lower;
        /// From the lowest node to the highest along the launch axis.
        packed_height_m: f64 => "Packed height", Length, lower;
        /// Mass of the web over the volume of the smallest cylinder about the launch axis that holds it; tractors and
        /// traction ropes are not counted.
        density_kg_m3: Option<f64> => "Packed density", Density, higher;
        /// Share of that cylinder that ropes, canopies and payloads fill.
        solid_fraction: Option<f64> => "Solid share when packed", Share, higher;
        /// Least distance between centre lines of ropes that share no knot.
        closest_approach_m: Option<f64> => "Closest approach of untied ropes when packed", Length, higher;
        /// Which two segments come so near.
        closest_approach_where: Option<String> => "Closest approach of untied ropes when packed, of", Text;
        /// Where they come so near.
        closest_approach_at_m: Option<[f64; 3]> => "Place of the closest approach when packed", Place, not_in_table;
        /// Pairs of segments of ropes that share no knot nearer than a diameter.
        nearer_than_a_diameter: Option<usize> => "Pairs nearer than a diameter when packed", Count, lower;
    }
}

section! {
    /// The equilibrium, alone or at the start of a run.
    Equilibrium, "static" {
        /// The largest force out of balance on a node that is free to move.
        residual_n: Option<f64> => "Largest force out of balance", Force;
        /// The same over the largest tension or load.
        residual_relative: Option<f64> => "Force out of balance over the largest tension or load", Error;
        /// The node on which it acts.
        residual_where: Option<String> => "Largest force out of balance, on", Text;
        /// The relative force out of balance that was asked for.
        tolerance: f64 => "Force out of balance that was asked for", Error;
        /// Iterations that it took.
        iterations: u64 => "Iterations", Count;
        /// Whether a run in time begins from it.
        then_run: bool => "Starts a run in time", Truth, not_in_table;
    }
}

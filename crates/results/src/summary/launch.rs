//! Start of the run: launch, packed web and equilibrium.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::quantity::section;

section! {
    /// Departures of the tractors and recoil of the tubes.
    Departures, "launch" {
        /// Angular speed of all that is launched at the start.
        spin_rad_s: f64 => "Spin at the start", AngularSpeed, not_in_table;
        parts:
        /// Each tractor's departure, by the number of its corner.
        tractors: BTreeMap<u32, Departure>;
        /// Recoil of the tubes.
        recoil: Option<Recoil>;
    }
}

section! {
    /// Departure of a tractor from its muzzle, or without a tube from its stowed position.
    Departure, "launch.tractors.*" {
        /// When it left its muzzle, or without a tube its stowed position; none if it never did.
        time_s: Option<f64> => "Departure of tractor {} at", Time, not_in_table;
        /// Speed of the tractor at its departure.
        speed_m_s: Option<f64> => "Departure speed of tractor {}", Speed, not_in_table;
        /// Angle between the velocity of the tractor at its departure and the launch axis.
        angle_rad: f64 => "Departure angle of tractor {}", Angle, not_in_table;
    }
}

section! {
    /// Recoil of all tubes together on their carrier.
    Recoil, "launch.recoil" {
        /// Largest force of all tubes together on their carrier.
        peak_n: f64 => "Peak recoil", Force, not_in_table;
        /// When it occurred.
        peak_time_s: f64 => "Time of peak recoil", Time, not_in_table;
        /// Magnitude of the impulse of the recoil.
        impulse_n_s: f64 => "Impulse of the recoil", Impulse, not_in_table;
        /// Impulse of the recoil against the launch axis.
        axial_impulse_n_s: f64 => "Impulse of the recoil along the axis", Impulse, not_in_table;
    }
}

section! {
    /// Audit of the packed web at the start.
    StowedState, "stowed" {
        /// Largest strain of any member: length over rest length less 1, negative if all members are slack.
        longest_stretch: Option<f64> => "Largest strain when packed", Strain;
        /// The member with the largest strain.
        longest_stretch_where: Option<String> => "Largest strain when packed, in", Text;
        /// Number of members that are stretched.
        stretched: usize => "Stretched members when packed", Count;
        /// Elastic energy at the start.
        stored_energy_j: f64 => "Stored energy when packed", Energy;
        /// Largest distance of a node from the launch axis.
        packed_radius_m: f64 => "Packed radius", Length, lower;
        /// Distance from the lowest node to the highest along the launch axis.
        packed_height_m: f64 => "Packed height", Length, lower;
        /// Mass of the web without traction ropes and tractors, over the volume of the smallest cylinder about the launch
        /// axis that holds it.
        density_kg_m3: Option<f64> => "Packed density", Density, higher;
        /// Volume of ropes, canopies and payloads over the volume of that cylinder.
        solid_fraction: Option<f64> => "Solid share when packed", Share, higher;
        /// Least distance between centre lines of ropes that share no knot.
        closest_approach_m: Option<f64> => "Closest approach of untied ropes when packed", Length, higher;
        /// The two segments with the least distance.
        closest_approach_where: Option<String> => "Closest approach of untied ropes when packed, of", Text;
        /// Place of the least distance.
        closest_approach_at_m: Option<[f64; 3]> => "Place of the closest approach when packed", Place, not_in_table;
        /// Number of pairs of segments nearer than a diameter, of ropes that share no knot.
        nearer_than_a_diameter: Option<usize> => "Pairs nearer than a diameter when packed", Count, lower;
    }
}

section! {
    /// The equilibrium, alone or at the start of a run.
    Equilibrium, "static" {
        /// Largest unbalanced force on a node that is free to move.
        residual_n: Option<f64> => "Largest force out of balance", Force;
        /// Largest unbalanced force over the largest tension, bending force or load.
        residual_relative: Option<f64> => "Force out of balance over the largest tension, bending force or load", Error;
        /// The node with the largest unbalanced force.
        residual_where: Option<String> => "Largest force out of balance, on", Text;
        /// Relative unbalanced force at which the search for the equilibrium stops.
        tolerance: f64 => "Force out of balance that was asked for", Error;
        /// Number of iterations of the search for the equilibrium.
        iterations: u64 => "Iterations", Count;
        /// Whether a run in time starts from the equilibrium.
        then_run: bool => "Starts a run in time", Truth, not_in_table;
    }
}

//! Flight of the web: its centre of mass, its feature points, the medium and the wind.

use serde::{Deserialize, Serialize};

use crate::quantity::{Dimension, Quantity, section};

section! {
    /// How long the web hung about its apex and where it ended, by its centre of mass at checks.
    Flight, "flight" {
        /// Greatest height of the centre of mass of the web without its tractors above the muzzle.
        apex_height_m: Option<f64> => "Greatest height of the web's centre of mass", Length, higher;
        /// When it occurred.
        apex_time_s: Option<f64> => "Time of greatest height of the web's centre of mass", Time;
        /// Start of the longest spell with at least 95 % of that height.
        hang_from_s: Option<f64> => "Hangs within 5 % of its apex from", Time, not_in_table;
        /// End of that spell.
        hang_to_s: Option<f64> => "Hangs within 5 % of its apex until", Time, not_in_table;
        /// Length of that spell.
        hang_time_s: Option<f64> => "Hangs within 5 % of its apex for", Time, higher, headline;
        /// Whether that spell lasts until the end of the run.
        still_up: Option<bool> => "Still hangs at the end of the run", Truth, not_in_table;
        /// Horizontal distance of the centre of mass from its start, at the end.
        drift_m: Option<f64> => "Drift over the ground by the end of the run", Length, not_in_table;
        /// Azimuth of the drift, anticlockwise from x; none without drift.
        drift_azimuth_rad: Option<f64> => "Direction of the drift", Angle, not_in_table;
        /// First check after the apex at which the net touches the ground again after leaving it.
        touches_down_s: Option<f64> => "Touches the ground at", Time, not_in_table;
        /// First check from which on the centre of mass stays within 5 cm of its last position, on the ground.
        lies_from_s: Option<f64> => "Lies still from", Time, not_in_table;
    }
}

section! {
    /// Where the web's centre of mass was at one moment.
    Place, "places.*" {
        /// When.
        time_s: Option<f64> => "Time of {}", Time, not_in_table;
        /// Its displacement along the launch axis since launch.
        travel_m: Option<f64> => "Distance along the axis at {}", Length;
        /// How far it is from where it started, over the ground.
        ground_distance_m: Option<f64> => "Distance over the ground at {}", Length;
        /// How far it is beside the vertical plane of the launch axis, positive to the left; none for a vertical axis.
        cross_range_m: Option<f64> => "Drift across the axis at {}", Length;
        /// Its height above the muzzle.
        height_m: Option<f64> => "Height at {}", Length;
        /// Its speed.
        speed_m_s: Option<f64> => "Speed at {}", Speed;
    }
}

/// Where the web's centre of mass was at the moments of the run; all none where there was no such moment.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Places {
    /// When the longest spell with 80 % of the flat web's area begins.
    pub opening: Place,
    /// When it ends; none where the run ends before.
    pub closing: Place,
    /// At the largest area inside the outline.
    pub largest_area: Place,
}

impl Places {
    /// Its keys.
    pub(crate) const MOMENTS: [&'static str; 3] = ["opening", "closing", "largest_area"];
}

section! {
    /// Force of a support on what it holds or drives.
    Reaction, "reactions.*" {
        /// Largest magnitude, over every step.
        peak_n: Option<f64> => "Largest reaction of {}", Force;
        /// When it occurred.
        peak_time_s: Option<f64> => "Time of the largest reaction of {}", Time, not_in_table;
        /// Its part along x of the world at the end.
        x_n: Option<f64> => "Reaction of {} at the end, x", Force;
        /// Its part along y of the world at the end.
        y_n: Option<f64> => "Reaction of {} at the end, y", Force;
        /// Its part along z of the world, upward, at the end.
        z_n: Option<f64> => "Reaction of {} at the end, z", Force;
    }
}

section! {
    /// Extremes of one point over every step.
    PointExtremes, "points.*" {
        /// Highest speed.
        peak_speed_m_s: Option<f64> => "Peak speed of {}", Speed;
        /// When it occurred.
        peak_speed_time_s: Option<f64> => "Peak speed of {} at", Time;
        /// Farthest displacement along the launch axis since launch.
        peak_travel_m: Option<f64> => "Peak travel of {}", Length;
        /// When it occurred.
        peak_travel_time_s: Option<f64> => "Peak travel of {} at", Time;
        /// Greatest height above the muzzle.
        peak_height_m: Option<f64> => "Peak height of {}", Length;
        /// When the point first reached 1 % of its peak travel.
        starts_s: Option<f64> => "Start of {}", Time;
    }
}

impl PointExtremes {
    /// Rows of single points with a name, a headline or a direction of better of their own.
    pub(crate) const SINGLE_POINTS: &'static [Quantity] = &[
        travel("points.tractor", "Peak travel of the tractors").higher().headline(),
        travel("points.B", "Peak travel of point B").higher().headline(),
        travel("points.centre", "Peak travel of the centre").higher(),
        Quantity::new("points.B", "peak_speed_m_s", "Peak speed of point B", Dimension::Speed, "Highest speed.")
            .headline(),
    ];
}

const fn travel(point: &'static str, name: &'static str) -> Quantity {
    let definition = "Farthest displacement along the launch axis since launch.";
    Quantity::new(point, "peak_travel_m", name, Dimension::Length, definition)
}

section! {
    /// The medium and the wind.
    AirMet, "air" {
        /// Density of the medium at the muzzle.
        density_kg_m3: f64 => "Density of the medium", Density;
        /// Dynamic viscosity of the medium.
        viscosity_pa_s: f64 => "Viscosity of the medium", Viscosity, not_in_table;
        /// Wind at the muzzle at the start.
        wind_m_s: [f64; 3] => "Wind at the muzzle at the start", Velocity;
        /// Largest velocity added to the mean wind at any time: gust, turbulence or measured wind.
        wind_change_max_m_s: f64 => "Largest change of the wind", Speed, not_in_table;
        /// Solidity of the screen that the ropes form; none where each rope drags as if alone.
        solidity: Option<f64> => "Solidity of the screen of ropes", Ratio, not_in_table;
    }
}

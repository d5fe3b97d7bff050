//! How the web flies: its centre of mass, its points, what it flies through.

use serde::{Deserialize, Serialize};

use crate::quantity::{Dimension, Quantity, section};

section! {
    /// How long the web hung about its apex and where it ended, by its centre of mass at record times.
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
        /// Whether that spell was cut off by the end of the run.
        still_up: Option<bool> => "Still hangs at the end of the run", Truth, not_in_table;
        /// How far the centre of mass is from where it started, over the ground, at the last record.
        drift_m: Option<f64> => "Drift over the ground by the end of the run", Length, not_in_table;
        /// In which direction, anticlockwise from x; none where it does not drift.
        drift_azimuth_rad: Option<f64> => "Direction of the drift", Angle, not_in_table;
        /// The first record after the apex at which anything touches the ground that had left it.
        touches_down_s: Option<f64> => "Touches the ground at", Time, not_in_table;
        /// From which record on the centre of mass stays within 5 cm of where it ends, on the ground.
        lies_from_s: Option<f64> => "Lies still from", Time, not_in_table;
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
    /// Rows of points of which more is wanted than of others.
    pub(crate) const WANTED: &'static [Quantity] = &[
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
        /// The largest wind that adds to the mean at any time: gusts, turbulence; the measured wind.
        wind_change_max_m_s: f64 => "Largest change of the wind", Speed, not_in_table;
        /// The solidity by which ropes drag as a screen; none where each drags as if alone.
        solidity: Option<f64> => "Solidity of the screen of ropes", Ratio, not_in_table;
    }
}

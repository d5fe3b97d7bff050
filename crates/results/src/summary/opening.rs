//! Opening, tilt of the mouth, coverage of a target, and posture of the web.

use serde::{Deserialize, Serialize};

use crate::quantity::section;

section! {
    /// How far and how long the web opened.
    Opening, "opening" {
        /// Largest area inside the outline, seen along the launch axis.
        area_max_m2: Option<f64> => "Largest outline area", Area, higher, headline;
        /// When it occurred.
        area_max_time_s: Option<f64> => "Time of largest outline area", Time, lower, headline;
        /// Area inside the outline of the web as designed, flat.
        reference_area_m2: Option<f64> => "Area of the flat web", Area;
        /// Largest magnitude of the outline's vector area.
        vector_area_max_m2: Option<f64> => "Largest vector area of the outline", Area, higher;
        /// Start of the longest spell in which the outline area is at least 80 % of that of the flat web.
        effective_from_s: Option<f64> => "At least 80 % open from", Time, lower;
        /// End of that spell.
        effective_to_s: Option<f64> => "At least 80 % open until", Time;
        /// Total time with at least 80 % of the area of the flat web.
        effective_duration_s: Option<f64> => "At least 80 % open in all", Time, higher, headline;
        /// Largest area of the tractors' polygon, seen along the launch axis.
        tractor_area_max_m2: Option<f64> => "Largest area of the tractors' polygon", Area, headline;
        /// When it occurred.
        tractor_area_max_time_s: Option<f64> => "Time of largest tractors' polygon", Time;
        /// Largest area of the silhouette along the launch axis at any check.
        shadow_area_max_m2: Option<f64> => "Largest silhouette", Area, higher;
        /// When it occurred.
        shadow_area_max_time_s: Option<f64> => "Time of largest silhouette", Time;
    }
}

section! {
    /// Tilt and asymmetry of the mouth, at checks.
    Mouth, "mouth" {
        /// Angle between the outline's vector area and the launch axis when the outline area is largest.
        tilt_at_area_max_rad: Option<f64> => "Tilt of the mouth at the largest area", Angle, lower;
        /// Largest tilt of the mouth while the web is at least 80 % open.
        tilt_max_open_rad: Option<f64> => "Largest tilt of the mouth while 80 % open", Angle, lower;
        /// Spread of the corners' distances from their mean, each over that in the flat web, when the outline area is
        /// largest.
        asymmetry_at_area_max: Option<f64> => "Asymmetry of the mouth at the largest area", Share, lower;
        /// Largest asymmetry of the mouth while the web is at least 80 % open.
        asymmetry_max_open: Option<f64> => "Largest asymmetry of the mouth while 80 % open", Share, lower;
    }
}

section! {
    /// Share of a target of stated size that the web covered, at checks.
    TargetCoverage, "target" {
        /// Diameter of the target.
        diameter_m: f64 => "Diameter of the target", Length;
        /// Largest share of the target that the silhouette covers.
        coverage_max: Option<f64> => "Largest share of the target covered", Share, higher, headline;
        /// When it occurred.
        coverage_max_time_s: Option<f64> => "Time of largest share of the target covered", Time, not_in_table;
        /// Start of the longest spell with at least 99 % of the target covered.
        covered_from_s: Option<f64> => "Target covered from", Time, lower;
        /// End of that spell.
        covered_to_s: Option<f64> => "Target covered until", Time;
        /// Total time with at least 99 % of the target covered.
        covered_duration_s: Option<f64> => "Target covered in all", Time, higher, headline;
    }
}

section! {
    /// When the middle trailed the outline and when it led.
    Posture, "posture" {
        /// Start of the longest spell in which the middle trails the outline.
        concave_from_s: Option<f64> => "The middle trails from", Time;
        /// End of that spell.
        concave_to_s: Option<f64> => "The middle trails until", Time, headline;
        /// When the middle first leads the outline.
        convex_from_s: Option<f64> => "The middle leads from", Time;
    }
}

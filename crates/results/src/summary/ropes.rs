//! Tensions of ropes, stresses of sheets, and broken segments.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::quantity::section;

section! {
    /// Rope tension, per rope, over every step.
    Tension, "tension" {
        /// Highest tension of any rope at any step.
        #[serde(default = "super::unknown", deserialize_with = "super::number_or_unknown")]
        max_n: f64 => "Highest tension", Force, lower, headline, not_in_table;
        /// When it occurred.
        max_time_s: Option<f64> => "Highest tension at", Time, not_in_table;
        /// Link class of the rope with the highest tension.
        max_where: Option<String> => "Highest tension in", Text, headline, not_in_table;
        /// Highest tension in the segments that meet point B.
        bottom_max_n: Option<f64> => "Highest tension in the bottom ropes", Force, lower, headline;
        /// Mean tension in the segments that meet point B, from the start of B to the time of largest area.
        bottom_mean_n: Option<f64> => "Mean tension in the bottom ropes", Force, lower;
        /// Number of rope segments that broke; break ties and stitches, which are made to break, do not count.
        broken_segments: usize => "Segments of rope that break", Count, lower, headline, not_in_table;
        /// When the first of them broke.
        first_break_time_s: Option<f64> => "First break of a rope at", Time, higher, not_in_table;
        parts:
        /// The extremes of each link class.
        by_class: BTreeMap<String, ClassTension>;
        /// Tensions of each kind of rope, by its name in the scenario.
        by_rope: BTreeMap<String, RopeUse>;
    }
}

section! {
    /// Highest tension in one link class.
    ClassTension, "tension.by_class.*" {
        /// Highest tension in a rope of the link class.
        max_n: f64 => "Highest tension, {}", Force, lower;
        /// When it occurred.
        max_time_s: Option<f64> => "Highest tension, {}, at", Time;
        /// Strength of the class's weakest rope over its highest tension, where a strength is given.
        margin: Option<f64> => "Margin, {}", Ratio, higher;
    }
}

section! {
    /// Tensions of one kind of rope: the largest over all steps, the smallest and the mean over all its segments at all
    /// checks.
    RopeUse, "tension.by_rope.*" {
        /// Smallest tension of its segments at any check: 0 if any was slack.
        min_n: Option<f64> => "Smallest tension, rope `{}`", Force;
        /// Mean tension over its segments and all checks.
        mean_n: Option<f64> => "Mean tension, rope `{}`", Force, lower;
        /// Highest tension at any step.
        max_n: f64 => "Highest tension, rope `{}`", Force, lower;
        /// When it occurred.
        max_time_s: Option<f64> => "Highest tension, rope `{}`, at", Time, not_in_table;
        /// Link class of the segment with the highest tension.
        max_where: Option<String> => "Highest tension, rope `{}`, in", Text, not_in_table;
        /// Largest strain of its segments, at the steps of its highest tensions.
        strain_max: Option<f64> => "Largest strain, rope `{}`", Strain;
        /// When it occurred.
        strain_max_time_s: Option<f64> => "Largest strain, rope `{}`, at", Time, not_in_table;
        /// Link class of the segment with the largest strain.
        strain_max_where: Option<String> => "Largest strain, rope `{}`, in", Text, not_in_table;
        /// Breaking load of the rope, where the scenario gives one.
        strength_n: Option<f64> => "Strength, rope `{}`", Force;
        /// Share of the breaking load that is lost at knots, where the scenario gives one.
        knot_reduction: Option<f64> => "Lost to knots, rope `{}`", Share;
        /// Highest tension over the breaking load less the loss at knots.
        utilisation: Option<f64> => "Utilisation, rope `{}`", Share, lower, headline;
        /// The breaking load less the loss at knots, over the highest tension.
        margin: Option<f64> => "Margin, rope `{}`", Ratio, higher;
    }
}

section! {
    /// Stress of the sheets of canopies, at every step.
    SheetStress, "canopies" {
        /// Largest principal stress (second Piola-Kirchhoff) of any triangle.
        max_principal_stress_pa: f64 => "Largest principal stress of the canopies", Stress, not_in_table;
        /// When it occurred.
        max_time_s: Option<f64> => "Largest principal stress of the canopies at", Time, not_in_table;
        /// The canopy with the largest principal stress.
        max_where: Option<String> => "Largest principal stress of the canopies in", Text, not_in_table;
        /// Strength of the cloth, where the scenario gives one.
        strength_pa: Option<f64> => "Strength of the cloth", Stress, not_in_table;
        /// Strength of the cloth over the largest principal stress.
        margin: Option<f64> => "Margin of the cloth", Ratio, higher, not_in_table;
    }
}

/// A segment that broke.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct BrokenSegment {
    /// Time of the break, s.
    pub time_s: f64,
    /// The segment in words.
    #[serde(rename = "where")]
    pub place: String,
    /// Index of the segment in the fields.
    pub segment: usize,
    /// Link class of the segment.
    pub class: String,
    /// Tension at the break, N.
    pub tension_n: f64,
    /// Whether it is made to break: a break tie, a tear stitch, a rope that is cut.
    pub released: bool,
    /// Whether it is cut, by `[[cuts]]`.
    pub cut: bool,
}

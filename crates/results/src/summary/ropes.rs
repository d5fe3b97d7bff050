//! What ropes and sheets bear, and what breaks.

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
        /// The link class of the rope that bore it.
        max_where: Option<String> => "Highest tension in", Text, headline, not_in_table;
        /// Highest tension in the segments that meet point B.
        bottom_max_n: Option<f64> => "Highest tension in the bottom ropes", Force, lower, headline;
        /// Their mean from B's start to the time of largest area.
        bottom_mean_n: Option<f64> => "Mean tension in the bottom ropes", Force, lower;
        /// Number of segments of rope that broke; ties and stitches, which are made to, do not count.
        broken_segments: usize => "Segments of rope that break", Count, lower, headline, not_in_table;
        /// When the first of them broke.
        first_break_time_s: Option<f64> => "First break of a rope at", Time, higher, not_in_table;
        parts:
        /// The extremes of each link class.
        by_class: BTreeMap<String, ClassTension>;
        /// What each kind of rope bears, by its name in the scenario.
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
    /// What one kind of rope bears. The largest tension is that of any step, smallest and mean are over all its segments
    /// at all record times.
    RopeUse, "tension.by_rope.*" {
        /// Smallest tension of its segments at any record time: 0 where any was slack.
        min_n: Option<f64> => "Smallest tension, rope `{}`", Force;
        /// Mean tension over its segments and all record times.
        mean_n: Option<f64> => "Mean tension, rope `{}`", Force, lower;
        /// Highest tension at any step.
        max_n: f64 => "Highest tension, rope `{}`", Force, lower;
        /// When it occurred.
        max_time_s: Option<f64> => "Highest tension, rope `{}`, at", Time, not_in_table;
        /// The link class where it occurred.
        max_where: Option<String> => "Highest tension, rope `{}`, in", Text, not_in_table;
        /// Its breaking load, where it is given.
        strength_n: Option<f64> => "Strength, rope `{}`", Force;
        /// The share of that which knots take, where it is given.
        knot_reduction: Option<f64> => "Lost to knots, rope `{}`", Share;
        /// Highest tension over the strength that knots leave.
        utilisation: Option<f64> => "Utilisation, rope `{}`", Share, lower, headline;
        /// The inverse of it.
        margin: Option<f64> => "Margin, rope `{}`", Ratio, higher;
    }
}

section! {
    /// What the sheets of canopies bear, at every step.
    SheetStress, "canopies" {
        /// Largest principal stress (second Piola-Kirchhoff) of any triangle.
        max_principal_stress_pa: f64 => "Largest principal stress of the canopies", Stress, not_in_table;
        /// When it occurred.
        max_time_s: Option<f64> => "Largest principal stress of the canopies at", Time, not_in_table;
        /// The canopy that bore it.
        max_where: Option<String> => "Largest principal stress of the canopies in", Text, not_in_table;
        /// What the cloth bears, where it is given.
        strength_pa: Option<f64> => "Strength of the cloth", Stress, not_in_table;
        /// Strength over largest stress.
        margin: Option<f64> => "Margin of the cloth", Ratio, higher, not_in_table;
    }
}

/// A segment that broke.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct BrokenSegment {
    /// When, s.
    pub time_s: f64,
    /// Which segment, in words.
    #[serde(rename = "where")]
    pub place: String,
    /// Its number in the fields.
    pub segment: usize,
    /// Its link class.
    pub class: String,
    /// Its tension then, N.
    pub tension_n: f64,
    /// Whether it was made to: a break tie, a tear stitch.
    pub released: bool,
}

//! Breaking of a segment, at a load, at a strain or at a time: a rope that is cut.
//!
//! ```text
//! T > load   or   d > strain L0   or   t >= time of the cut
//! ```
//!
//! The tension T of the step in which this first holds still acts, damping and all; from the next step on the segment is
//! gone, and its nodes fly on. So the load is exceeded by no more than what the tension gains in one step. The elastic energy
//! that it held then goes to the channel `rupture`; what its last tension does until the next step is dissipative, and goes
//! to `rope_damping`. docs/theory/breaking.md.
//!
//! A brittle break of the whole cross-section: no yarn goes before the others, and neither how long nor how often a load is borne
//! matters. Segments of one rope in one tension may break one after the other, before the wave of the first break has
//! passed: give one of them less strength where one break is meant.

use serde::{Deserialize, Serialize};

/// The load and the strain at which a segment breaks, and the time at which it is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Breaking {
    /// Breaking load, N.
    pub load: f64,
    /// Breaking strain.
    pub strain: f64,
    /// Time at which it is cut, s.
    pub cut_at: f64,
}

impl Breaking {
    /// It never breaks.
    pub const NEVER: Breaking = Breaking { load: f64::INFINITY, strain: f64::INFINITY, cut_at: f64::INFINITY };

    /// The length beyond which a segment breaks, m.
    pub fn length(&self, rest_length: f64) -> f64 {
        rest_length * (1.0 + self.strain)
    }

    /// Whether a segment of this rest length breaks, m, at this time, s, tension, N, and length, m.
    pub fn happens(&self, time: f64, rest_length: f64, tension: f64, length: f64) -> bool {
        tension > self.load || length > self.length(rest_length) || time >= self.cut_at
    }
}

impl Default for Breaking {
    fn default() -> Breaking {
        Breaking::NEVER
    }
}

/// A segment that broke.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Break {
    /// Which segment.
    pub segment: usize,
    /// In which step.
    pub step: u64,
    /// When, s.
    pub time: f64,
    /// Its tension then, N.
    pub tension: f64,
}

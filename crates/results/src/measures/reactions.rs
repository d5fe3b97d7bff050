//! Reactions: the force of each support on what it holds or drives.
//!
//! A held node does not accelerate, so its support balances all other forces on it. A driven node keeps its velocity
//! between two points of its path; the jerk at such a point is not in its reaction.

use glam::DVec3;
use netcast_dynamics::simulate::{Frame, Live};
use netcast_dynamics::time::step::Stepper;
use serde::{Deserialize, Serialize};

use super::peak::Peak;
use crate::landmarks::{Landmarks, Support};
use crate::summary::{Reaction, Summary};

/// The reactions of a run so far.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReactionMeasures {
    /// Magnitude over all steps, N, (supports,).
    peaks: Vec<Peak>,
    /// At the last check, N, (supports,).
    last: Vec<DVec3>,
}

impl ReactionMeasures {
    /// No step yet.
    pub fn new(landmarks: &Landmarks) -> ReactionMeasures {
        let supports = landmarks.supports.len();
        ReactionMeasures { peaks: vec![Peak::default(); supports], last: vec![DVec3::ZERO; supports] }
    }

    /// Whether these are measures of a web with such landmarks.
    pub fn fit(&self, landmarks: &Landmarks) -> bool {
        let supports = landmarks.supports.len();
        self.peaks.len() == supports && self.last.len() == supports
    }

    /// Takes a step into account.
    pub fn step(&mut self, landmarks: &Landmarks, live: &Live) {
        for (peak, support) in self.peaks.iter_mut().zip(&landmarks.supports) {
            peak.add(live.tension_time, reaction(support, live.net).length());
        }
    }

    /// Takes a check into account.
    pub fn check(&mut self, landmarks: &Landmarks, frame: &Frame) {
        for ((peak, last), support) in self.peaks.iter_mut().zip(&mut self.last).zip(&landmarks.supports) {
            *last = reaction(support, frame.net);
            peak.add(frame.time, last.length());
        }
    }

    /// Writes the section of the summary.
    pub fn finish(self, landmarks: &Landmarks, summary: &mut Summary) {
        for ((peak, last), support) in self.peaks.iter().zip(&self.last).zip(&landmarks.supports) {
            let finite = |value: f64| value.is_finite().then_some(value);
            let reaction = Reaction {
                peak_n: peak.value(),
                peak_time_s: peak.time(),
                x_n: finite(last.x),
                y_n: finite(last.y),
                z_n: finite(last.z),
            };
            summary.reactions.insert(support.name.clone(), reaction);
        }
    }
}

/// The force of a support on its nodes at the last forces, N.
pub fn reaction(support: &Support, net: &Stepper) -> DVec3 {
    support.nodes.iter().map(|&node| net.reaction(node)).sum()
}

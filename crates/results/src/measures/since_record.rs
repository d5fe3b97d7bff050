//! The largest values since the record before, so that a coarse record hides no peak.

use netcast_dynamics::simulate::Live;
use serde::{Deserialize, Serialize};

use crate::landmarks::Landmarks;

/// Largest tensions and speeds since the record before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SinceRecord {
    /// Of each link class, N, (classes,).
    pub class_tension: Vec<f64>,
    /// Of the segments that meet at each point, N, (points,).
    pub point_tension: Vec<f64>,
    /// Of each point, m/s, (points,).
    pub point_speed: Vec<f64>,
}

impl SinceRecord {
    /// No step since the record.
    pub fn new(landmarks: &Landmarks) -> SinceRecord {
        let (classes, points) = (landmarks.classes.len(), landmarks.points.len());
        SinceRecord {
            class_tension: vec![0.0; classes],
            point_tension: vec![0.0; points],
            point_speed: vec![0.0; points],
        }
    }

    /// Takes the tensions of a step in; `largest` is that of each group, N.
    pub fn add_tensions(&mut self, landmarks: &Landmarks, largest: &[f64], live: &Live) {
        for (group, &tension) in landmarks.groups.iter().zip(largest) {
            let peak = &mut self.class_tension[group.class];
            *peak = peak.max(tension);
        }
        for (peak, point) in self.point_tension.iter_mut().zip(&landmarks.points) {
            for &segment in point.segments.iter().filter(|&&segment| !live.net.is_gone(segment)) {
                *peak = peak.max(live.net.tension(segment));
            }
        }
    }
}

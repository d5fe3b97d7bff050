//! Largest principal stress in sheets, over all triangles and steps.

use glam::DVec3;
use netcast_dynamics::forces::element::Element;
use netcast_dynamics::forces::membrane::Membrane;
use serde::{Deserialize, Serialize};

use super::peak::Peak;
use crate::landmarks::Landmarks;
use crate::summary::SheetStress;

/// The largest stress so far, and its triangle.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct ClothMeasures {
    stress: Peak,
    triangle: usize,
}

impl ClothMeasures {
    /// Adds the stresses at `time`, s; `position` gives the place of a node, m.
    pub fn add(&mut self, membranes: &[Membrane], time: f64, position: impl Fn(usize) -> DVec3) {
        for (index, triangle) in membranes.iter().enumerate() {
            if self.stress.add(time, triangle.stress(triangle.nodes().map(&position)).largest()) {
                self.triangle = index;
            }
        }
    }

    /// The section of the summary; `None` for a net without sheets.
    pub fn finish(self, membranes: &[Membrane], landmarks: &Landmarks) -> Option<SheetStress> {
        let nodes = membranes.get(self.triangle)?.nodes();
        let canopy = landmarks.canopies.iter().position(|canopy| canopy.triangles.contains(&nodes));
        let largest = self.stress.value()?;
        Some(SheetStress {
            max_principal_stress_pa: largest,
            max_time_s: self.stress.time(),
            max_where: canopy.map(|index| format!("canopy {}", index + 1)),
            strength_pa: landmarks.cloth_strength,
            margin: landmarks.cloth_strength.filter(|_| largest > 0.0).map(|strength| strength / largest),
        })
    }
}

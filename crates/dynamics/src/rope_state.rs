//! State of ropes beside the positions of their nodes: the state of their laws, and which segments are broken.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::forces::law::{Axial, Memory};
use crate::system::System;

/// State of all segments beside the positions of their nodes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RopeState {
    /// State of each segment's law, (segments,); empty where no law of the system has state.
    pub memory: Vec<Memory>,
    /// Whether each is broken, (segments,).
    pub broken: Vec<bool>,
}

impl RopeState {
    /// The state of a system at rest at these positions, m, with no broken segment.
    pub fn at_rest(system: &System, position: &[DVec3]) -> RopeState {
        let segments = system.segments().iter();
        let memory = segments.clone().map(|s| system.law(s).at_rest(s.stretch(position)));
        RopeState {
            memory: if system.remembers() { memory.collect() } else { Vec::new() },
            broken: segments.map(|_| false).collect(),
        }
    }

    /// State of a segment's law.
    pub fn memory_of(&self, segment: usize) -> Memory {
        self.memory.get(segment).copied().unwrap_or_default()
    }

    /// A segment's rest length, stiffness and damping; [`Axial::GONE`] where it is broken.
    pub fn axial(&self, system: &System, segment: usize) -> Axial {
        if self.broken[segment] { Axial::GONE } else { Axial::from(&system.segments()[segment]) }
    }
}

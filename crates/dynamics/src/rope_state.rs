//! What evolves of ropes beside their nodes: what a law remembers, and what is broken.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::forces::law::{Axial, Memory};
use crate::system::System;

/// What evolves of the segments beside their nodes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RopeState {
    /// What each remembers, (segments,); empty where no law of the system remembers.
    pub memory: Vec<Memory>,
    /// Whether each is broken, (segments,).
    pub broken: Vec<bool>,
}

impl RopeState {
    /// Of a system that has been at these positions, m, for long, nothing broken.
    pub fn at_rest(system: &System, position: &[DVec3]) -> RopeState {
        let segments = system.segments().iter();
        let memory = segments.clone().map(|s| system.law(s).at_rest(s.stretch(position)));
        RopeState {
            memory: if system.remembers() { memory.collect() } else { Vec::new() },
            broken: segments.map(|_| false).collect(),
        }
    }

    /// What a segment remembers.
    pub fn memory_of(&self, segment: usize) -> Memory {
        self.memory.get(segment).copied().unwrap_or_default()
    }

    /// A segment along itself, as it is now.
    pub fn axial(&self, system: &System, segment: usize) -> Axial {
        if self.broken[segment] { Axial::GONE } else { Axial::from(&system.segments()[segment]) }
    }
}

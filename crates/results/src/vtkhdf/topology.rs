//! The topology of the fields: what is the same in every step.

use serde::{Deserialize, Serialize};

pub(super) const VECTOR_BYTES: usize = 3 * size_of::<f64>();
pub(super) const SCALAR_BYTES: usize = size_of::<f64>();
pub(super) const QUATERNION_BYTES: usize = 4 * size_of::<f64>();

/// Nodes, segments, triangles and names of the fields, the same in every step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FieldsTopology {
    /// Number of nodes.
    pub nodes: usize,
    /// The two nodes of each segment; shape (segments, 2).
    pub segments: Vec<[u32; 2]>,
    /// Link class of each segment, an index into `class_names`; shape (segments,).
    pub classes: Vec<u32>,
    /// The three nodes of each triangle of a sheet; shape (triangles, 3).
    pub triangles: Vec<[u32; 3]>,
    /// Names of the link classes.
    pub class_names: Vec<String>,
    /// Nodes with a name, such as feature point B.
    pub labels: Vec<(u32, String)>,
    /// Node at the centre of each rigid body; shape (bodies,).
    pub bodies: Vec<u32>,
}

impl FieldsTopology {
    /// Number of cells: segments and triangles.
    pub(super) fn cells(&self) -> usize {
        self.segments.len() + self.triangles.len()
    }

    /// A phrase on an index that is out of range; none if all are in range.
    pub(crate) fn fault(&self) -> Option<String> {
        let is_missing = |node: u32| node as usize >= self.nodes;
        let corners = self.segments.iter().flatten().chain(self.triangles.iter().flatten());
        let ends = corners.chain(&self.bodies).copied().find(|&node| is_missing(node));
        let label = || self.labels.iter().map(|(node, _)| *node).find(|&node| is_missing(node));
        if let Some(node) = ends.or_else(label) {
            return Some(format!("it names node {node} of {}", self.nodes));
        }
        let class = self.classes.iter().find(|&&class| class as usize >= self.class_names.len());
        class.map(|class| format!("it names link class {class} of {}", self.class_names.len()))
    }

    /// Bytes of one step: time, position and velocity of each node, tension of each segment, orientation of each body.
    /// None if the number overflows.
    pub(crate) fn frame_bytes(&self) -> Option<usize> {
        let nodes = self.nodes.checked_mul(2 * VECTOR_BYTES)?;
        let bodies = self.bodies.len().checked_mul(QUATERNION_BYTES)?;
        let segments = self.segments.len().checked_mul(SCALAR_BYTES)?;
        segments.checked_add(nodes)?.checked_add(bodies)?.checked_add(SCALAR_BYTES)
    }
}

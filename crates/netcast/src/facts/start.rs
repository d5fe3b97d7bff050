//! Facts on the state at the start: stretched segments, size and density of the packed web.

use netcast_model::Model;
use serde::Serialize;

use crate::case::Case;

/// The audit of the state at the start.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StartFacts {
    /// The largest strain of a segment; negative where all segments are slack. None where there are no segments.
    pub longest_stretch: Option<f64>,
    /// The label of that segment.
    pub longest_stretch_where: Option<String>,
    /// Elastic energy, J.
    pub stored_energy_j: f64,
    /// Largest distance of a node from the launch axis, m.
    pub packed_radius_m: f64,
    /// Extent of the nodes along the launch axis, m.
    pub packed_height_m: f64,
}

/// The density of the packed web, and the distances between its ropes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PackingFacts {
    /// Mass over the volume of the smallest cylinder about the launch axis, kg/m^3; none where the web is flat.
    pub density_kg_m3: Option<f64>,
    /// Solid share of that cylinder; none where the web is flat.
    pub solid_fraction: Option<f64>,
    /// Whether distances between ropes were computed; false where too many are near each other.
    pub is_compared: bool,
    /// The two nearest segments of ropes without a common knot; none where there are none.
    pub closest: Option<Closest>,
    /// Number of pairs of segments, of ropes without a common knot, nearer than a diameter; none where distances were
    /// not computed.
    pub nearer_than_a_diameter: Option<usize>,
}

/// Two segments near each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Closest {
    /// Their distance, m.
    pub distance_m: f64,
    /// Their labels.
    pub segments: [String; 2],
}

/// The audit of the state at the start of a model.
pub(super) fn start(model: &Model) -> StartFacts {
    let audit = &model.audit;
    StartFacts {
        longest_stretch: audit.longest.map(|longest| longest.stretch),
        longest_stretch_where: audit.longest.map(|longest| model.segment_label(longest.segment)),
        stored_energy_j: audit.stored_energy,
        packed_radius_m: audit.packed_radius,
        packed_height_m: audit.packed_height,
    }
}

impl Case {
    /// The packing of the web at the start. It takes up to a few seconds where many ropes are near each other.
    pub fn packing(&self) -> PackingFacts {
        let model = self.model();
        let packing = model.packing();
        let closest = packing.closeness.and_then(|closeness| closeness.closest);
        PackingFacts {
            density_kg_m3: packing.density,
            solid_fraction: packing.solid_fraction,
            is_compared: packing.closeness.is_some(),
            closest: closest.map(|closest| Closest {
                distance_m: closest.distance,
                segments: closest.segments.map(|segment| model.segment_label(segment)),
            }),
            nearer_than_a_diameter: packing.closeness.map(|closeness| closeness.touching),
        }
    }
}

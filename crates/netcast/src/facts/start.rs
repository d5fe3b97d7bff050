//! How a case starts: what is stretched, how large and how dense it is packed.

use netcast_model::Model;
use serde::Serialize;

use crate::case::Case;

/// The state at the start, looked over.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StartFacts {
    /// The largest stretch of a segment, as a share of its rest length; negative where none reaches it. None where there
    /// are no segments.
    pub longest_stretch: Option<f64>,
    /// Which segment that is.
    pub longest_stretch_where: Option<String>,
    /// Elastic energy, J.
    pub stored_energy_j: f64,
    /// Largest distance of a node from the launch axis, m.
    pub packed_radius_m: f64,
    /// From the lowest node to the highest along the launch axis, m.
    pub packed_height_m: f64,
}

/// How densely a web is packed, and how near its ropes come to each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PackingFacts {
    /// Mass over the volume of the smallest cylinder about the launch axis, kg/m^3; none where the web lies flat.
    pub density_kg_m3: Option<f64>,
    /// Share of that cylinder that is solid; none where the web lies flat.
    pub solid_fraction: Option<f64>,
    /// Whether the nearest ropes were looked for: not where too many lie near each other.
    pub is_compared: bool,
    /// The two segments that come nearest to each other; none where all ropes are tied together.
    pub closest: Option<Closest>,
    /// Pairs of segments, of ropes that share no knot, that are nearer than a diameter; none where they were not looked
    /// for.
    pub nearer_than_a_diameter: Option<usize>,
}

/// Two segments that come near each other.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Closest {
    /// Their distance, m.
    pub distance_m: f64,
    /// Which they are.
    pub segments: [String; 2],
}

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
    /// How the web is packed at the start. Takes up to a few seconds where many ropes lie near each other.
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

//! Names of the parts of a web: of segments, class numbers and bodies.

use std::f64::consts::PI;

use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::system::Segment;
use netcast_scenario::Rope;
use netcast_webs::{Class, CutSegment, CutWeb};

/// A segment of the system, and the rope, canopy or thread that it belongs to.
#[derive(Debug, Clone, Copy)]
pub struct Member {
    /// The segment of the system.
    pub segment: Segment,
    /// The rope, canopy or thread that it belongs to.
    pub part: Part,
}

/// The rope, canopy or thread that a segment belongs to; numbers count from 0.
#[derive(Debug, Clone, Copy)]
pub enum Part {
    Rope(CutSegment),
    Spoke { canopy: usize, number: usize },
    Side { canopy: usize, number: usize },
    Tie { number: usize },
    Stitch { row: usize, number: usize },
}

impl Member {
    /// Its name in messages.
    pub fn label(&self, cut: &CutWeb) -> String {
        let of = |what: &str, number: usize, canopy: usize| {
            format!("{what} {} of canopy {}", number + 1, cut.web.canopies[canopy].number)
        };
        match self.part {
            Part::Rope(segment) => cut.segment_label(&segment),
            Part::Spoke { canopy, number } => of("spoke", number, canopy),
            Part::Side { canopy, number } => of("side", number, canopy),
            Part::Tie { number } => {
                let [node, other] = self.segment.ends;
                let to = if other < cut.nodes.len() { format!(" to {}", cut.node_label(other)) } else { String::new() };
                format!("break tie {} at {}{to}", number + 1, cut.node_label(node))
            }
            Part::Stitch { row, number } => format!("stitch {} of row {}", number + 1, row + 1),
        }
    }

    /// Whether it is a segment of a rope.
    pub fn is_rope(&self) -> bool {
        matches!(self.part, Part::Rope(_))
    }
}

/// Segments of one link class that are made of one kind of rope.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// The link class.
    pub class: Class,
    /// The name of the rope, `rope` for the default one; none for members of canopies, ties and stitches.
    pub rope: Option<String>,
    /// Diameter of the rope, m; none for members of canopies, ties and stitches.
    pub diameter: Option<f64>,
    /// Breaking load of the rope, N; none if it is not given.
    pub strength: Option<f64>,
    /// Share of the strength that a knot costs; none if it is not given.
    pub knot_reduction: Option<f64>,
    /// The law of the segments.
    pub law: Law,
    /// Load and strain at which a segment breaks away from knots; those of the weakest tie or stitch.
    pub breaking: Breaking,
}

impl Group {
    /// A group of segments that are not rope: members of canopies, ties, stitches.
    pub(crate) fn of_threads(class: Class, breaking: Breaking) -> Group {
        Group { class, rope: None, diameter: None, strength: None, knot_reduction: None, law: Law::Linear, breaking }
    }
}

/// The purpose of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Pulls the web out.
    Tractor,
    /// A load that the web carries.
    Payload,
    /// An instrument in the middle.
    Sensor,
}

/// A body and the node that it sits on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedBody {
    /// Its purpose.
    pub role: Role,
    /// Its node.
    pub node: usize,
    /// Its size and mass.
    pub solid: netcast_scenario::Solid,
    /// Its index among the rigid bodies of the system; none for a mass on a node.
    pub rigid: Option<usize>,
}

/// A rope from knot to knot under the name that `[assign]` accepts.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Its link class.
    pub class: Class,
    /// Its ring, from 1 in the middle; none if it is not of class `ring`.
    pub ring: Option<usize>,
    /// The name of its rope, `rope` for the default one.
    pub rope: String,
    /// Its length without tension as drawn, m.
    pub length: f64,
}

/// Area of a rope's cross-section, m^2.
pub(super) fn section(rope: &Rope) -> f64 {
    0.25 * PI * rope.diameter.si() * rope.diameter.si()
}

//! The parts of a web with their names: what a segment, a class number and a body is.

use std::f64::consts::PI;

use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::system::Segment;
use netcast_scenario::Rope;
use netcast_webs::{Class, CutSegment, CutWeb};

/// A segment of the system and what it is a part of.
#[derive(Debug, Clone, Copy)]
pub struct Member {
    /// As the system has it.
    pub segment: Segment,
    /// What it is a part of.
    pub part: Part,
}

/// What a segment is a part of; numbers count from 0.
#[derive(Debug, Clone, Copy)]
pub enum Part {
    Rope(CutSegment),
    Spoke { canopy: usize, number: usize },
    Side { canopy: usize, number: usize },
    Tie { number: usize },
    Stitch { row: usize, number: usize },
}

impl Member {
    /// What a message calls it.
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

    /// Whether it is a piece of rope.
    pub fn is_rope(&self) -> bool {
        matches!(self.part, Part::Rope(_))
    }
}

/// Segments of one link class that are made of one kind of rope.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Their link class.
    pub class: Class,
    /// The name of their rope, `rope` for the default one; none for members of canopies, ties and stitches.
    pub rope: Option<String>,
    /// Diameter of the rope, m; none for the members of canopies.
    pub diameter: Option<f64>,
    /// Its breaking load, N, where it is given.
    pub strength: Option<f64>,
    /// The share of its strength that knots take from it, where it is given.
    pub knot_reduction: Option<f64>,
    /// By which its tension follows from its stretch.
    pub law: Law,
    /// What it bears at most away from knots; the weakest of ties and stitches.
    pub breaking: Breaking,
}

impl Group {
    /// Segments that are no rope: members of canopies, ties, stitches.
    pub(crate) fn of_threads(class: Class, breaking: Breaking) -> Group {
        Group { class, rope: None, diameter: None, strength: None, knot_reduction: None, law: Law::Linear, breaking }
    }
}

/// What a body is there for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Pulls the web out.
    Tractor,
    /// Is carried.
    Payload,
    /// Sits in the middle.
    Sensor,
}

/// A body and the node that it sits on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedBody {
    /// What it is there for.
    pub role: Role,
    /// Its node.
    pub node: usize,
    /// Its size and mass.
    pub solid: netcast_scenario::Solid,
    /// The system's rigid body that it is; none for a mass on a node.
    pub rigid: Option<usize>,
}

/// A rope from knot to knot, as `[assign]` can name it.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Its link class.
    pub class: Class,
    /// Its ring, from 1 in the middle, where it is of class `ring`.
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

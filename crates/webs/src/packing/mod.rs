//! Packing: where each node lies when the web is stowed, before it is launched.
//!
//! A pattern maps a cut web to positions in the launch frame: +z is the launch axis, z = 0 the muzzle. Rest lengths
//! are kept: a pattern may let ropes hang slack, and [`audit`] tells whether it stretches any.

mod audit;
mod bag;
mod bend;
mod closeness;
mod container;
mod folded;
mod folded_plates;
mod folds;
mod given;
mod imperfection;
mod mouth;
mod plate;
mod prescribed;
mod rings;
mod scale;
mod sector;
mod star;
mod ties;

pub use audit::{Audit, LongestStretch, Size, StowedSegment, audit};
pub use bag::Bag;
pub use closeness::{Approach, Closeness, closeness};
pub use container::Container;
pub use folded::{Folded, Folding};
pub use given::Given;
pub use imperfection::Imperfection;
pub use mouth::Mouth;
pub use plate::StiffPlate;
pub use prescribed::{Led, Prescribed, Settled};
pub use scale::Scale;
pub use sector::Sector;

use glam::DVec3;

use crate::CutWeb;
use crate::field::PackingField;

/// The ways to pack a web.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// The flat web shrunk about its middle.
    Scale(Scale),
    /// The web drawn in to a bag, its middle hanging below, its tractors on top.
    Bag(Bag),
    /// The web folded into a container.
    Folded(Folded),
    /// Where the user says.
    Given(Given),
}

impl Pattern {
    /// Positions of all nodes of the packed web in the launch frame, m.
    ///
    /// # Errors
    /// [`PackingError`]: a size that cannot be, or one that would stretch a rope.
    pub fn pack(&self, cut_web: &CutWeb) -> Result<Vec<DVec3>, PackingError> {
        self.pack_imperfectly(cut_web, None)
    }

    /// The same, disturbed: a web in a bag or a container, whose tractors stay in their places; one that was scaled or
    /// given with its traction ropes and tractors.
    ///
    /// # Errors
    /// As [`Pattern::pack`].
    pub fn pack_imperfectly(
        &self,
        cut_web: &CutWeb,
        imperfection: Option<&Imperfection>,
    ) -> Result<Vec<DVec3>, PackingError> {
        let mut packed = match self {
            Pattern::Bag(bag) => return bag.pack(cut_web, imperfection),
            Pattern::Folded(folded) => return folded.pack(cut_web, imperfection),
            Pattern::Scale(scale) => scale.pack(cut_web)?,
            Pattern::Given(given) => given.pack(cut_web)?,
        };
        if let Some(imperfection) = imperfection {
            imperfection.disturb(cut_web, &vec![true; packed.len()], &mut packed);
        }
        Ok(packed)
    }
}

/// Why a web cannot be packed as asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PackingError {
    /// The factor of a scaled web is out of its range.
    #[error("the factor must be more than 0 and at most 1, not {0}")]
    Factor(f64),
    /// A size is negative or not a number.
    #[error("the {what} must be a length of 0 m or more, not {value} m")]
    Size {
        /// Which size.
        what: PackingField,
        /// Its value, m.
        value: f64,
    },
    /// The bag is wider than the web.
    #[error("the radius of {radius} m must be more than 0 and at most the web's own, {limit:.4} m")]
    Radius {
        /// The radius given, m.
        radius: f64,
        /// The radius of the flat web, m.
        limit: f64,
    },
    /// The bag is so deep that ropes are stretched.
    #[error("a bag {depth} m deep would stretch the web's ropes; at its radius it can be at most {limit:.4} m deep")]
    Depth {
        /// The depth given, m.
        depth: f64,
        /// The largest depth that stretches no rope, m.
        limit: f64,
    },
    /// A traction rope does not reach from its corner out to its tractor, whatever the gap.
    #[error(
        "{tractor} would stand {distance:.4} m from its corner, farther than its traction rope of {length} m reaches; \
         bring the tractors' radius nearer to the packed web's, or make that less deep"
    )]
    TractorOutOfReach {
        /// The tractor's label.
        tractor: String,
        /// Distance from the tractor's place to its corner with no gap, m.
        distance: f64,
        /// Length of its traction rope, m.
        length: f64,
    },
    /// The tractors stand so far above the web that traction ropes are stretched.
    #[error("tractors {gap} m above the web would stretch {rope}; they can be at most {limit:.4} m above it")]
    Gap {
        /// The gap given, m.
        gap: f64,
        /// The largest gap that stretches no traction rope, m.
        limit: f64,
        /// Label of the traction rope.
        rope: String,
    },
    /// The web does not fit its container.
    #[error(
        "the web does not fit {container}; {}",
        match enough {
            Some(enough) => format!("packed so, it fits {enough}, the smallest of these proportions"),
            None => "none of these proportions takes it, however large".to_owned(),
        }
    )]
    Room {
        /// The container given.
        container: Container,
        /// The smallest of its proportions that does.
        enough: Option<Container>,
    },
    /// Nothing is led into the container.
    #[error("the web has no outline that could be drawn in")]
    NothingLed,
    /// There are more or fewer positions than nodes.
    #[error("{given} positions were given for {nodes} nodes")]
    Count {
        /// Positions given.
        given: usize,
        /// Nodes of the cut web.
        nodes: usize,
    },
    /// Knots have no position.
    #[error("{} no position: {}", if knots.len() == 1 { "a knot has" } else { "some knots have" }, knots.join(", "))]
    Missing {
        /// Their labels.
        knots: Vec<String>,
    },
    /// A position is not a finite number.
    #[error("the position of {0} is not a number")]
    NotFinite(String),
}

impl PackingError {
    /// What it is about.
    pub fn field(&self) -> PackingField {
        match self {
            PackingError::Factor(_) => PackingField::Factor,
            PackingError::Size { what, .. } => *what,
            PackingError::Radius { .. } => PackingField::Radius,
            PackingError::Depth { .. } => PackingField::Depth,
            PackingError::TractorOutOfReach { .. } => PackingField::TractorRadius,
            PackingError::Gap { .. } => PackingField::TractorGap,
            PackingError::Room { .. } => PackingField::Container,
            PackingError::NothingLed => PackingField::Paths,
            PackingError::Count { .. } | PackingError::Missing { .. } | PackingError::NotFinite(_) => {
                PackingField::Positions
            }
        }
    }
}

/// The longest stretch of any segment of a packed web, over its rest length.
#[cfg(test)]
fn longest_stretch(net: &crate::CutWeb, packed: &[glam::DVec3]) -> f64 {
    net.segments()
        .map(|segment| packed[segment.a].distance(packed[segment.b]) / segment.rest_length - 1.0)
        .fold(-1.0, f64::max)
}

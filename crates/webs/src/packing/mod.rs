//! Packing: positions of all nodes of the stowed web, before it is launched.
//!
//! A [`Pattern`] maps a cut web to positions in the launch frame: +z is the launch axis, z = 0 the muzzle.
//! [`Prescribed`] computes positions by simulating a motion; see its module `position_based`. Packing does not change
//! rest lengths, so a packed rope may be slack. [`audit`] finds stretched ropes, [`closeness`] ropes that overlap.

mod audit;
mod bag;
mod bend;
mod closeness;
mod container;
mod distance_limits;
mod folded;
mod folds;
mod given;
mod imperfection;
mod mouth;
mod plate;
mod position_based;
mod rings;
mod scale;
mod sector;
mod star;

pub use audit::{Audit, LongestStretch, Size, StowedSegment, audit};
pub use bag::Bag;
pub use closeness::{Approach, Closeness, closeness};
pub use container::Container;
pub use folded::{Folded, Folding};
pub use given::Given;
pub use imperfection::Imperfection;
pub use mouth::Mouth;
pub use plate::StiffPlate;
pub use position_based::{DrivenNode, Prescribed, Settled};
pub use scale::Scale;
pub use sector::Sector;

use glam::DVec3;

use crate::CutWeb;

/// The ways to pack a web.
#[derive(Debug, Clone, PartialEq)]
pub enum Pattern {
    /// The flat web shrunk about its middle.
    Scale(Scale),
    /// The web drawn in to a bag, with its middle below and its tractors on top.
    Bag(Bag),
    /// The web folded into a container.
    Folded(Folded),
    /// The web at given positions.
    Given(Given),
}

impl Pattern {
    /// Positions of all nodes of the packed web in the launch frame, m, (nodes,).
    ///
    /// # Errors
    /// [`PackingError`]: a size is out of its range or would stretch a rope, the web does not fit its container, or
    /// given positions are missing or not finite.
    pub fn pack(&self, cut_web: &CutWeb) -> Result<Vec<DVec3>, PackingError> {
        self.pack_imperfectly(cut_web, None)
    }

    /// As [`Pattern::pack`], with an imperfection. In a bag or a container the imperfection moves the web and not the
    /// tractors. A scaled or given web is moved together with its traction ropes and tractors.
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
    /// The factor of a scaled web is not more than 0 and at most 1.
    #[error("the factor must be more than 0 and at most 1, not {0}")]
    Factor(f64),
    /// A size is negative or not a number.
    #[error("the {what} must be a length of 0 m or more, not {value} m")]
    Size {
        /// The name of its field.
        argument: &'static str,
        /// The name of the size in the message.
        what: &'static str,
        /// Its value, m.
        value: f64,
    },
    /// The radius is not positive, or the container is wider than the web.
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
    /// A traction rope is too short to reach from its corner to its tractor, whatever the gap.
    #[error(
        "{tractor} would stand {distance:.4} m from its corner, farther than its traction rope of {length} m reaches; \
         bring the tractors' radius nearer to the packed web's, or make the packed web less deep"
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
            Some(enough) => format!(
                "folded like this, the smallest container of these proportions that holds it is {enough}"
            ),
            None => "folded like this, no container of these proportions holds it".to_owned(),
        }
    )]
    Room {
        /// The container given.
        container: Container,
        /// The smallest container of the same proportions that holds the web; none if even a very large one does not.
        enough: Option<Container>,
    },
    /// No paths are given and the web has no outline: no node is driven into the container.
    #[error("the web has no outline to draw in")]
    NothingDriven,
    /// There are more or fewer positions than nodes.
    #[error("{given} positions were given for {nodes} nodes")]
    Count {
        /// Number of positions.
        given: usize,
        /// Number of nodes of the cut web.
        nodes: usize,
    },
    /// Knots have no position.
    #[error("{} no position: {}", if knots.len() == 1 { "a knot has" } else { "some knots have" }, knots.join(", "))]
    Missing {
        /// Their labels.
        knots: Vec<String>,
    },
    /// A position is not finite; the label of its node.
    #[error("the position of {0} is not a number")]
    NotFinite(String),
}

impl PackingError {
    /// The name of the pattern's field at fault, such as "tractor_gap".
    pub fn argument(&self) -> &'static str {
        match self {
            PackingError::Factor(_) => "factor",
            PackingError::Size { argument, .. } => argument,
            PackingError::Radius { .. } => "radius",
            PackingError::Depth { .. } => "depth",
            PackingError::TractorOutOfReach { .. } => "tractor_radius",
            PackingError::Gap { .. } => "tractor_gap",
            PackingError::Room { .. } => "container",
            PackingError::NothingDriven => "paths",
            PackingError::Count { .. } | PackingError::Missing { .. } | PackingError::NotFinite(_) => "positions",
        }
    }
}

/// For tests: the largest relative stretch of a segment of a packed web; negative if all segments are slack.
#[cfg(test)]
fn longest_stretch(net: &crate::CutWeb, packed: &[glam::DVec3]) -> f64 {
    net.segments()
        .map(|segment| packed[segment.a].distance(packed[segment.b]) / segment.rest_length - 1.0)
        .fold(-1.0, f64::max)
}

//! Errors of drawing a web: arguments out of range, and faults in a list of knots and ropes.

use std::ops::RangeInclusive;

/// Why a web cannot be drawn. Rows and positions in lists count from 0 in the fields, from 1 in the messages.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WebError {
    /// An argument is out of its range.
    #[error("{fault}")]
    Argument {
        /// Name of the argument, or of its field, such as "hub_diameter".
        name: &'static str,
        /// What is wrong with its value.
        fault: String,
    },
    /// The web has no rope or no knot.
    #[error("the web is empty: it has {knots} knots and {ropes} ropes")]
    Empty {
        /// Number of knots.
        knots: usize,
        /// Number of ropes.
        ropes: usize,
    },
    /// Two nodes share an id.
    #[error("nodes {} and {} have the same id, \"{id}\"", .first + 1, .second + 1)]
    DuplicateId {
        /// The id.
        id: String,
        /// Position of the first node with this id in the list of nodes.
        first: usize,
        /// Position of the second node with this id.
        second: usize,
    },
    /// A coordinate is not a finite number.
    #[error("{knot} has a coordinate that is not a number")]
    NotFinite {
        /// The knot's label.
        knot: String,
    },
    /// A rope names a node that does not exist.
    #[error("rope {} is tied to node \"{id}\", which does not exist", .row + 1)]
    UnknownNode {
        /// Position of the rope in the list of ropes.
        row: usize,
        /// The id that names no node.
        id: String,
    },
    /// The outline, the corners or the points name a node that does not exist.
    #[error("{list}: there is no node \"{id}\"")]
    UnknownReference {
        /// The list with the id: "outline", "corners" or "points".
        list: &'static str,
        /// The id that names no node.
        id: String,
    },
    /// The outline or the corners name a node twice.
    #[error("{list}: node \"{id}\" is named twice")]
    Repeated {
        /// The list with the id: "outline" or "corners".
        list: &'static str,
        /// The id named twice.
        id: String,
    },
    /// The outline has fewer than three knots and encloses no area.
    #[error("an outline needs at least 3 knots, not {count}")]
    OutlineTooShort {
        /// The number of knots named.
        count: usize,
    },
    /// Both ends of a rope are tied to the same knot.
    #[error("{label} begins and ends at {knot}")]
    SelfLoop {
        /// Position of the rope in the web's ropes.
        rope: usize,
        /// The rope's label.
        label: String,
        /// The knot's label.
        knot: String,
    },
    /// A rope without a rest length of its own joins two knots at the same place.
    #[error("{label} has no length: {a} and {b} are at the same place")]
    ZeroLength {
        /// Position of the rope in the web's ropes.
        rope: usize,
        /// The rope's label.
        label: String,
        /// Label of the knot it begins at.
        a: String,
        /// Label of the knot it ends at.
        b: String,
    },
    /// A rope's own rest length is not positive.
    #[error("{label}: the rest length must be a positive length, not {value} m")]
    RestLength {
        /// Position of the rope in the web's ropes.
        rope: usize,
        /// The rope's label.
        label: String,
        /// The rest length given, m.
        value: f64,
    },
    /// The number of segments of a rope is 0.
    #[error("{label}: a rope has at least 1 segment, not 0")]
    NoSegments {
        /// Position of the rope in the web's ropes.
        rope: usize,
        /// The rope's label.
        label: String,
    },
    /// Some knots are not connected to the others.
    #[error("the web is in {pieces} pieces: nothing joins {a} and {b}")]
    Disconnected {
        /// Label of a knot in one piece.
        a: String,
        /// Label of a knot in another piece.
        b: String,
        /// The number of pieces.
        pieces: usize,
    },
    /// The web has no corners to tie tractors to.
    #[error("the web names no corners, so there is nothing to tie tractors to")]
    NoCorners,
    /// A corner lies at the middle of the web, where no direction points outwards for its traction rope.
    #[error("{corner} lies at the middle of the web, so its traction rope has no direction")]
    CornerInTheMiddle {
        /// Label of the corner's knot.
        corner: String,
    },
    /// The web already has tractors.
    #[error("the web already has tractors")]
    TractorsTwice,
}

impl WebError {
    /// The name of the argument at fault; none for a fault in a list of knots and ropes.
    pub fn argument_name(&self) -> Option<&'static str> {
        match self {
            WebError::Argument { name, .. } => Some(name),
            _ => None,
        }
    }

    /// An [`WebError::Argument`].
    pub(crate) fn argument(name: &'static str, fault: String) -> WebError {
        WebError::Argument { name, fault }
    }
}

/// Rounds to six significant figures, so that a suggestion reads as a person would type it.
pub(crate) fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Checks that an argument is a positive, finite length, m. `what` names it in the message.
pub(crate) fn positive(name: &'static str, what: &str, value: f64) -> Result<(), WebError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(WebError::argument(name, format!("{what} must be a positive length, not {value} m")))
    }
}

/// Checks that an argument lies in a range. `what` names it in the message.
pub(crate) fn in_range(
    name: &'static str,
    what: &str,
    value: usize,
    range: RangeInclusive<usize>,
) -> Result<(), WebError> {
    if range.contains(&value) {
        Ok(())
    } else {
        let (least, most) = range.into_inner();
        Err(WebError::argument(name, format!("{what} must be from {least} to {most}, not {value}")))
    }
}

/// For tests: the name of the argument at fault; none if the web was drawn.
#[cfg(test)]
pub(crate) fn refused<T>(drawn: Result<T, WebError>) -> Option<&'static str> {
    match drawn {
        Err(WebError::Argument { name, .. }) => Some(name),
        _ => None,
    }
}

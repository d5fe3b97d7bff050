//! What can be wrong with a web as it was asked for.

use crate::field::WebField;

/// A fault in a web's description. Rows and positions in lists count from 0 in the fields, from 1 in the messages.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum WebError {
    /// A length that must be positive and finite is not.
    #[error("{what} must be a positive length, not {value} m")]
    Length {
        /// What has this length.
        what: WebField,
        /// Its value, m.
        value: f64,
    },
    /// The traction ropes' length is negative or not a number.
    #[error(
        "the traction ropes' length must be zero (tractors tied straight to the corners) or positive, not {value} m"
    )]
    TractionLength {
        /// The length given, m.
        value: f64,
    },
    /// A number of cells or ropes is out of its range.
    #[error("{what} must be from {least} to {most}, not {value}")]
    Count {
        /// What is counted.
        what: WebField,
        /// The number given.
        value: usize,
        /// The smallest number allowed.
        least: usize,
        /// The largest number allowed.
        most: usize,
    },
    /// The mesh of a square web does not divide its side.
    #[error(
        "a mesh of {mesh} m does not divide a side of {side} m into whole cells; {} m or {} m would",
        rounded(*.coarser), rounded(*.finer)
    )]
    MeshDoesNotDivide {
        /// The side, m.
        side: f64,
        /// The mesh given, m.
        mesh: f64,
        /// The nearest larger mesh that divides the side, m.
        coarser: f64,
        /// The nearest smaller mesh that divides the side, m.
        finer: f64,
    },
    /// The mesh of a square web is larger than its side.
    #[error("a mesh of {mesh} m is larger than the web's side of {side} m")]
    MeshTooLarge {
        /// The side, m.
        side: f64,
        /// The mesh given, m.
        mesh: f64,
    },
    /// The mesh of a polygon web is larger than its apothem.
    #[error("a mesh of {mesh} m is larger than the distance from the middle to a side, {} m", rounded(*.apothem))]
    MeshBeyondApothem {
        /// The mesh given, m.
        mesh: f64,
        /// The apothem, m.
        apothem: f64,
    },
    /// The hanging ratio of a diamond net is out of its range.
    #[error("the hanging ratio must be greater than 0 and less than 1, not {value}")]
    HangingRatio {
        /// The ratio given.
        value: f64,
    },
    /// The hub of a radial-and-ring web is no smaller than the web.
    #[error("a hub of {hub} m leaves no room for radials in a web of {diameter} m")]
    HubTooLarge {
        /// The hub's diameter, m.
        hub: f64,
        /// The web's diameter, m.
        diameter: f64,
    },
    /// The corners of a radial-and-ring web cannot be spread evenly over its radials.
    #[error("{corners} corners do not lie evenly among {radials} radials; {} would", listed(.evenly))]
    UnevenCorners {
        /// The number of corners given.
        corners: usize,
        /// The number of radials.
        radials: usize,
        /// The numbers of corners that would lie evenly.
        evenly: Vec<usize>,
    },
    /// A gathering rope is not tied to every corner.
    #[error(
        "a gathering rope tied to every {every} knots would miss corners of the web: {every} does not divide the {meshes} \
         meshes of a side"
    )]
    TiesMissCorners {
        /// Knots from one tie to the next.
        every: usize,
        /// Knots of the outline from one corner to the next.
        meshes: usize,
    },
    /// A gathering rope would be shorter than the outline.
    #[error("the excess of a gathering rope must be 0 or more, not {value}")]
    Excess {
        /// The excess given, as a share of the outline.
        value: f64,
    },
    /// Canopies or rope hexagons leave no room for the links between them.
    #[error(
        "{what} with sides of {side} m leave no room for the ropes between them; their side must be less than {} m",
        rounded(*.limit)
    )]
    PlateTooLarge {
        /// Whose side it is.
        plate: WebField,
        /// "canopies" or "rope hexagons".
        what: &'static str,
        /// Their side, m.
        side: f64,
        /// The side at which neighbours touch, m.
        limit: f64,
    },
    /// There is no rope, or no knot.
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
        /// Position of the second.
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
        /// Where it is named.
        list: &'static str,
        /// The id that names no node.
        id: String,
    },
    /// The outline or the corners name a node twice.
    #[error("{list}: node \"{id}\" is named twice")]
    Repeated {
        /// Where it is named.
        list: &'static str,
        /// The id named twice.
        id: String,
    },
    /// An outline needs three knots to enclose an area.
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
    /// A rope joins two knots at the same place and has no length of its own.
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
    /// A rope is to be cut into no segments.
    #[error("{label}: a rope has at least 1 segment, not 0")]
    NoSegments {
        /// Position of the rope in the web's ropes.
        rope: usize,
        /// The rope's label.
        label: String,
    },
    /// The web falls apart.
    #[error("the web is in {pieces} pieces: nothing joins {a} and {b}")]
    Disconnected {
        /// Label of a knot in one piece.
        a: String,
        /// Label of a knot in another.
        b: String,
        /// The number of pieces.
        pieces: usize,
    },
    /// Tractors are wanted, but the web has no corners to tie them to.
    #[error("the web names no corners, so there is nothing to tie tractors to")]
    NoCorners,
    /// A corner lies at the middle of the web, so that its traction rope has no direction.
    #[error("{corner} lies at the middle of the web, so its traction rope has no direction to run in")]
    CornerInTheMiddle {
        /// Label of the corner's knot.
        corner: String,
    },
    /// The web has its tractors already.
    #[error("the web has its tractors already")]
    TractorsTwice,
}

impl WebError {
    /// The number that it is about; none for what is wrong with a list of nodes and ropes.
    pub fn field(&self) -> Option<WebField> {
        Some(match self {
            WebError::Length { what, .. } | WebError::Count { what, .. } => *what,
            WebError::TractionLength { .. } => WebField::TractionLength,
            WebError::MeshDoesNotDivide { .. } | WebError::MeshTooLarge { .. } | WebError::MeshBeyondApothem { .. } => {
                WebField::Mesh
            }
            WebError::HangingRatio { .. } => WebField::HangingRatio,
            WebError::HubTooLarge { .. } => WebField::HubDiameter,
            WebError::UnevenCorners { .. } => WebField::Corners,
            WebError::TiesMissCorners { .. } => WebField::GatheringEvery,
            WebError::Excess { .. } => WebField::GatheringExcess,
            WebError::PlateTooLarge { plate, .. } => *plate,
            WebError::Empty { .. }
            | WebError::DuplicateId { .. }
            | WebError::NotFinite { .. }
            | WebError::UnknownNode { .. }
            | WebError::UnknownReference { .. }
            | WebError::Repeated { .. }
            | WebError::OutlineTooShort { .. }
            | WebError::SelfLoop { .. }
            | WebError::ZeroLength { .. }
            | WebError::RestLength { .. }
            | WebError::NoSegments { .. }
            | WebError::Disconnected { .. }
            | WebError::NoCorners
            | WebError::CornerInTheMiddle { .. }
            | WebError::TractorsTwice => return None,
        })
    }
}

/// Rounded to six significant figures, so that a suggestion reads as a person would type it.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// The numbers with commas between them.
fn listed(numbers: &[usize]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// An error unless `value` is a positive, finite length.
pub(crate) fn positive(what: WebField, value: f64) -> Result<(), WebError> {
    if value > 0.0 && value.is_finite() { Ok(()) } else { Err(WebError::Length { what, value }) }
}

/// An error unless `value` lies in the range given.
pub(crate) fn in_range(what: WebField, value: usize, least: usize, most: usize) -> Result<(), WebError> {
    if (least..=most).contains(&value) { Ok(()) } else { Err(WebError::Count { what, value, least, most }) }
}

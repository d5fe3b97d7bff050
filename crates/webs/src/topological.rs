//! The topological rope web: the space web's ropes, with a closed hexagon of rope in the place of each canopy.

use crate::field::WebField;
use crate::plates::{PlateKind, plated_web};
use crate::{Class, Kind, Rope, Web, WebError};

const HEXAGONS: PlateKind = PlateKind {
    web: Kind::Topological,
    name: "hexagon",
    names: "rope hexagons",
    side: WebField::HexagonSide,
    has_hub: false,
};

/// The topological web: a hexagon of this side with rope hexagons of that side, both m.
///
/// Hexagons are numbered as the canopies of [`crate::space`]. Feature points: B a corner of the centre hexagon, C the
/// outer corner of the outline's hexagon next to the web's corner at 90 degrees, D the middle of a radial rope half
/// way.
///
/// # Errors
/// [`WebError::Length`] and [`WebError::PlateTooLarge`].
pub fn topological(side: f64, hexagon_side: f64) -> Result<Web, WebError> {
    let (mut web, plates) = plated_web(&HEXAGONS, side, hexagon_side)?;
    for (plate, number) in plates.iter().zip(1..) {
        web.ropes.extend((0..6).map(|edge| Rope {
            a: plate.rim[edge],
            b: plate.rim[(edge + 1) % 6],
            class: Class::Hexagon,
            label: format!("side {} of hexagon {number}", edge + 1),
            rest_length: None,
            segments: None,
        }));
    }
    Ok(web)
}

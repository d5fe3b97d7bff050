//! The topological rope web: the ropes of the space web, with a hexagon of rope in the place of each canopy.

use crate::plates::{PlateKind, plated_web};
use crate::{Class, Rope, Web, WebError};

const HEXAGONS: PlateKind =
    PlateKind { name: "hexagon", names: "rope hexagons", side_argument: "hexagon_side", has_hub: false };

/// Draws the topological web: a hexagon with this side and rope hexagons with side `hexagon_side`, both m.
///
/// Rope hexagons are numbered like the canopies of [`crate::space`]. Feature points: B is a corner of the centre
/// hexagon, C the outer corner of the outline's hexagon next to the web's corner at 90 degrees, D the middle of a
/// radial rope about half way between them.
///
/// # Errors
/// [`WebError::Argument`]: `side` or `hexagon_side` is not a positive length, or rope hexagons would touch.
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

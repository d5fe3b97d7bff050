//! The space web: hexagonal canopies on a triangular lattice, joined by double ropes; eighteen canopies carry a
//! payload.

use crate::plates::{PlateKind, plated_web};
use crate::{Canopy, Web, WebError};

const CANOPIES: PlateKind =
    PlateKind { name: "canopy", names: "canopies", side_argument: "canopy_side", has_hub: true };

/// Draws the space web: a hexagon with this side and canopies with side `canopy_side`, both m.
///
/// Canopies 1 to 12 stand on the outline and number 31 in the centre; 13 to 30, between them, carry a payload each. The
/// members of a canopy are not ropes: a model makes them from [`Web::canopies`]. Feature points: B is a corner of the
/// centre canopy, C the outer corner of the outline's canopy next to the web's corner at 90 degrees, D the middle of a
/// radial rope about half way between them.
///
/// # Errors
/// [`WebError::Argument`]: `side` or `canopy_side` is not a positive length, or canopies would touch.
pub fn space(side: f64, canopy_side: f64) -> Result<Web, WebError> {
    let (mut web, plates) = plated_web(&CANOPIES, side, canopy_side)?;
    let number_of_centre = plates.len();
    web.canopies = plates
        .iter()
        .zip(1..)
        .filter_map(|(plate, number)| {
            let hub = plate.hub?;
            let is_centre = number == number_of_centre;
            let is_on_outline = web.outline.iter().any(|vertex| vertex[0] == hub);
            Some(Canopy { hub, rim: plate.rim, carries_payload: !is_centre && !is_on_outline, number, is_centre })
        })
        .collect();
    Ok(web)
}

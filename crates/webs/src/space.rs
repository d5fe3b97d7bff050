//! The space web: double ropes between hexagonal canopies on a triangular lattice; eighteen of the canopies carry a
//! payload.

use crate::field::WebField;
use crate::plates::{PlateKind, plated_web};
use crate::{Canopy, Kind, Web, WebError};

const CANOPIES: PlateKind =
    PlateKind { web: Kind::Space, name: "canopy", names: "canopies", side: WebField::CanopySide, has_hub: true };

/// The space web: a hexagon of this side with canopies of that side, both m.
///
/// Canopies 1 to 12 stand on the outline, 13 to 30 inside it and carry a payload each, 31 in the centre. Their
/// members are not ropes: a model makes them from [`Web::canopies`]. Feature points: B a corner of the centre canopy,
/// C the outer corner of the outline's canopy next to the web's corner at 90 degrees, D the middle of a radial rope
/// half way.
///
/// # Errors
/// [`WebError::Length`] and [`WebError::PlateTooLarge`].
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

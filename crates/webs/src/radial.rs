//! The radial-and-ring web, as a spider builds it: straight radials from the middle to the outline, and polygonal rings
//! from radial to radial.
//!
//! Many radials cannot be tied in one knot. A hub, an open ring of rope, can then stand in the middle.

use crate::error::{in_range, positive};
use crate::sectors::Sectors;
use crate::{Web, WebError};

const MOST_RADIALS: usize = 360;
const MOST_RINGS: usize = 1000;

/// Sizes of a radial-and-ring web; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Radial {
    /// Diameter of the circle through the outline's corners.
    pub diameter: f64,
    /// Number of radials, 3 to 360: also the number of corners of each ring.
    pub radials: usize,
    /// Number of evenly spaced rings with the outline, 1 to 1000.
    pub rings: usize,
    /// Diameter of the circle through the hub's corners; none: the radials meet in a knot.
    pub hub_diameter: Option<f64>,
    /// Number of web corners, where tractors are tied: a divisor of `radials`, at least 3.
    pub corners: usize,
}

/// Draws the radial-and-ring web with a radial at 90 degrees.
///
/// Knots are numbered from the middle outwards, ring by ring; corners anticlockwise from the one at 90 degrees.
/// Classes: the outline, the other rings and the hub as rings, and radials. The centre is the knot in the middle or the
/// mean of the hub's knots. Feature points: B is the knot in the middle or the hub's knot at 90 degrees, C the corner
/// at 90 degrees, D half way between.
///
/// # Errors
/// [`WebError::Argument`]: a field of [`Radial`] is out of its range.
pub fn radial(sizes: &Radial) -> Result<Web, WebError> {
    let &Radial { diameter, radials, rings, hub_diameter, corners } = sizes;
    positive("diameter", "the web's diameter", diameter)?;
    in_range("radials", "the number of radials", radials, 3..=MOST_RADIALS)?;
    in_range("rings", "the number of rings", rings, 1..=MOST_RINGS)?;
    in_range("corners", "the number of corners", corners, 3..=radials)?;
    if !radials.is_multiple_of(corners) {
        let divisors = (3..=radials).filter(|count| radials.is_multiple_of(*count)).map(|count| count.to_string());
        let divisors = divisors.collect::<Vec<_>>().join(", ");
        let fault = format!("{corners} corners do not lie evenly among {radials} radials; {divisors} would");
        return Err(WebError::argument("corners", fault));
    }
    if let Some(hub) = hub_diameter {
        positive("hub_diameter", "the hub's diameter", hub)?;
        if hub >= diameter {
            let fault = format!("a hub of {hub} m leaves no room for radials in a web of {diameter} m");
            return Err(WebError::argument("hub_diameter", fault));
        }
    }

    let (hub, rim) = (0.5 * hub_diameter.unwrap_or(0.0), 0.5 * diameter);
    let radius = |ring: usize| hub + (rim - hub) * (ring as f64 / rings as f64);
    let sectors = Sectors {
        corners: radials,
        web_corners: corners,
        radii: (0..=rings).map(radius).collect(),
        divisions: vec![1; rings],
    };
    Ok(sectors.web())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use glam::DVec3;
    use proptest::prelude::*;

    use super::*;
    use crate::error::refused;
    use crate::symmetry::{is_mirrored, is_turned};
    use crate::{Class, Cutting, Site, cut, vector_area};

    const WEB: Radial = Radial { diameter: 5.0, radials: 12, rings: 8, hub_diameter: Some(0.2), corners: 4 };

    #[test]
    fn a_web_with_a_hub_has_its_counts_corners_and_points() {
        let web = radial(&WEB).unwrap();
        assert_eq!((web.knots.len(), web.ropes.len()), (12 * 9, 12 * 9 + 12 * 8));
        let at = |point: &str| web.position(web.points[point]);
        assert!(at("B").distance(0.1 * DVec3::Y) < 1e-12 && at("C").distance(2.5 * DVec3::Y) < 1e-12);
        assert!(at("D").distance(1.3 * DVec3::Y) < 1e-12);
        let corners = [DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y, DVec3::X].map(|towards| 2.5 * towards);
        for ((&corner, expected), number) in web.corners.iter().zip(corners).zip(1..) {
            assert!(web.knots[corner].position.distance(expected) < 1e-12);
            assert_eq!(web.knots[corner].label, format!("web corner {number}"));
        }
        assert_eq!(web.knots.iter().filter(|knot| knot.label.contains("corner")).count(), 4);
        assert_eq!((web.centre.len(), web.outline.len()), (12, 12));
    }

    #[test]
    fn without_a_hub_the_radials_meet_in_a_knot() {
        let web = radial(&Radial { hub_diameter: None, ..WEB }).unwrap();
        assert_eq!((web.knots.len(), web.ropes.len()), (1 + 12 * 8, 2 * 12 * 8));
        assert_eq!((web.centre.as_slice(), web.points["B"]), (&[0][..], Site::Knot(0)));
    }

    #[test]
    fn wrong_sizes_are_refused() {
        for (wrong, argument) in [
            (Radial { radials: 2, ..WEB }, "radials"),
            (Radial { rings: 0, ..WEB }, "rings"),
            (Radial { corners: 13, ..WEB }, "corners"),
            (Radial { corners: 0, ..WEB }, "corners"),
            (Radial { diameter: 0.0, ..WEB }, "diameter"),
            (Radial { hub_diameter: Some(-1.0), ..WEB }, "hub_diameter"),
            (Radial { hub_diameter: Some(5.0), ..WEB }, "hub_diameter"),
        ] {
            assert_eq!(refused(radial(&wrong)), Some(argument), "{wrong:?}");
        }
        let error = radial(&Radial { corners: 5, ..WEB }).unwrap_err().to_string();
        assert_eq!(error, "5 corners do not lie evenly among 12 radials; 3, 4, 6, 12 would");
    }

    proptest! {
        #[test]
        fn every_radial_web_has_its_counts_lengths_area_cells_and_symmetry(
            diameter in 0.5..20.0_f64,
            radials in 3..40_usize,
            rings in 1..20_usize,
            hub_share in prop::option::of(0.01..0.9_f64),
        ) {
            let hub_diameter = hub_share.map(|share| share * diameter);
            let web = radial(&Radial { diameter, radials, rings, hub_diameter, corners: radials }).unwrap();
            prop_assert_eq!(web.check(), []);
            prop_assert!(is_turned(&web, radials) && is_mirrored(&web));
            prop_assert!(web.mean_position(&web.centre).length() < 1e-12 * diameter);

            let (n, outer, hub) = (radials as f64, 0.5 * diameter, 0.5 * hub_diameter.unwrap_or(0.0));
            // chord 2 r sin(pi / n); the radii from the hub outwards are an arithmetic progression
            let perimeter = |radius: f64| 2.0 * n * radius * (PI / n).sin();
            let is = |got: f64, expected: f64| (got - expected).abs() < 1e-9 * diameter.max(expected);
            let length = web.rope_length_by_class();
            prop_assert!(is(length[&Class::Outline], perimeter(outer)));
            let count = rings as f64 + 1.0;
            let all_rings = perimeter(count * (hub + outer) / 2.0) - perimeter(outer);
            prop_assert!(is(length.get(&Class::Ring).copied().unwrap_or(0.0), all_rings));
            prop_assert!(is(length[&Class::Radial], n * (outer - hub)));
            let area = 0.5 * n * outer * outer * (2.0 * PI / n).sin();
            prop_assert!(is(web.reference_area().unwrap(), area));

            let net = cut(&web, &Cutting::SegmentLength(diameter)).unwrap();
            let cells = net.cells();
            prop_assert_eq!(cells.len(), radials * rings + usize::from(hub_share.is_some()));
            let of = |cell: &Vec<usize>| vector_area(&cell.iter().map(|&n| net.nodes[n]).collect::<Vec<_>>()).z;
            prop_assert!(is(cells.iter().map(of).sum(), area));
        }
    }
}

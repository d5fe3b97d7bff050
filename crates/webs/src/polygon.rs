//! The polygon web: a regular polygon filled with concentric polygons and radials.
//!
//! Ropes parallel to each side (parallels) lie one mesh apart from the middle to the side. A radial runs to every
//! corner. Further radials divide the sector between two corners into cells that are about as wide as high: where cells
//! would be wider than sqrt(2) meshes, a new radial begins in each and halves it. Unlike a square or hexagonal lattice,
//! this drawing fits a polygon with any number of sides.

use std::f64::consts::{PI, SQRT_2};

use crate::error::{in_range, positive, rounded};
use crate::sectors::Sectors;
use crate::{Web, WebError};

/// With more sides, radials to the corners crowd in the middle.
const MOST_SIDES: usize = 24;

const MOST_PARALLELS: usize = 1000;

/// Draws the polygon web: a regular polygon with 3 to 24 sides of length `side`, m, a corner at 90 degrees, and
/// parallels about `mesh` apart, m ([`parallel_spacing`] is the exact distance).
///
/// Knots are numbered from the middle outwards, ring by ring; corners anticlockwise from the one at 90 degrees.
/// Classes: the outline, the other parallels as rings, and radials. Feature points: B is the knot in the middle, C the
/// corner at 90 degrees, D half way between.
///
/// # Errors
/// [`WebError::Argument`]: `sides`, `side` or `mesh` is out of its range.
pub fn polygon(sides: usize, side: f64, mesh: f64) -> Result<Web, WebError> {
    let parallels = parallels(sides, side, mesh)?;
    let radius = 0.5 * side / libm::sin(PI / sides as f64);
    // width of a sector one mesh from the middle, in meshes
    let width = 2.0 * libm::tan(PI / sides as f64);
    let divisions = (0..parallels).map(|band| {
        let width = width * (band as f64 + 0.5);
        let mut cells = 1;
        while width > SQRT_2 * cells as f64 {
            cells *= 2;
        }
        cells
    });
    let sectors = Sectors {
        corners: sides,
        web_corners: sides,
        radii: (0..=parallels).map(|ring| radius * (ring as f64 / parallels as f64)).collect(),
        divisions: divisions.collect(),
    };
    Ok(sectors.web())
}

/// Distance between neighbouring parallels of a polygon web, m: the apothem over the rounded number of meshes in it.
///
/// # Errors
/// As [`polygon`].
pub fn parallel_spacing(sides: usize, side: f64, mesh: f64) -> Result<f64, WebError> {
    Ok(apothem(sides, side) / parallels(sides, side, mesh)? as f64)
}

/// Apothem: distance from the middle of the polygon to the middle of a side, m.
fn apothem(sides: usize, side: f64) -> f64 {
    0.5 * side / libm::tan(PI / sides as f64)
}

/// Number of parallels from the middle to a side, including the side itself.
fn parallels(sides: usize, side: f64, mesh: f64) -> Result<usize, WebError> {
    in_range("sides", "the number of sides", sides, 3..=MOST_SIDES)?;
    positive("side", "the web's side", side)?;
    positive("mesh", "the mesh", mesh)?;
    let apothem = apothem(sides, side);
    if mesh > apothem {
        let apothem = rounded(apothem);
        let fault = format!("a mesh of {mesh} m is larger than the distance from the middle to a side, {apothem} m");
        return Err(WebError::argument("mesh", fault));
    }
    let parallels = (apothem / mesh).round() as usize;
    in_range("mesh", "the number of meshes from the middle to a side", parallels, 1..=MOST_PARALLELS)?;
    Ok(parallels)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use proptest::prelude::*;

    use super::*;
    use crate::error::refused;
    use crate::symmetry::{is_mirrored, is_turned};
    use crate::{Class, Cutting, cut, vector_area};

    #[test]
    fn a_hexagon_of_four_parallels_has_its_counts_lengths_and_points() {
        // apothem 2.165 m: a mesh of 0.54 m goes into it four times
        let web = polygon(6, 2.5, 0.54).unwrap();
        // sectors 0.58, 1.73, 2.89 and 4.04 meshes wide: 1, 2, 4 and 4 cells (2.89 > 2 sqrt 2)
        assert_eq!(web.knots.len(), 1 + 6 * (2 + 4 + 4 + 4));
        let of = |class| web.ropes.iter().filter(|rope| rope.class == class).count();
        assert_eq!([Class::Outline, Class::Ring, Class::Radial].map(of), [6 * 4, 6 * (2 + 4 + 4), 6 * (1 + 2 + 4 + 4)]);
        let length = web.rope_length_by_class();
        assert!((length[&Class::Outline] - 15.0).abs() < 1e-12);
        assert!((length[&Class::Ring] - 15.0 * (1.0 + 2.0 + 3.0) / 4.0).abs() < 1e-12);
        // rays to the corners over four bands, to the middles of the sides over three, to their quarters over two
        let apothem = 2.5 * 0.75_f64.sqrt();
        let radial = 6.0 * (2.5 + 0.75 * apothem + 2.0 * 0.5 * apothem.hypot(0.625));
        assert!((length[&Class::Radial] - radial).abs() < 1e-12);
        assert!((web.reference_area().unwrap() - 1.5 * 3.0_f64.sqrt() * 6.25).abs() < 1e-12);
        let at = |point: &str| web.position(web.points[point]);
        assert!(at("B") == DVec3::ZERO && at("C").distance(DVec3::new(0.0, 2.5, 0.0)) < 1e-12);
        assert!(at("D").distance(DVec3::new(0.0, 1.25, 0.0)) < 1e-12);
    }

    #[test]
    fn a_web_of_one_parallel_is_a_polygon_with_radials_to_its_corners() {
        let web = polygon(5, 1.0, 0.6).unwrap();
        assert_eq!((web.knots.len(), web.ropes.len()), (1 + 5, 5 + 5));
        let at = |point: &str| web.position(web.points[point]);
        assert!((at("D") - 0.5 * at("C")).length() < 1e-12);
    }

    #[test]
    fn wrong_sizes_are_refused() {
        for sides in [0, 1, 2, 25] {
            assert_eq!(refused(polygon(sides, 2.5, 0.5)), Some("sides"), "{sides}");
        }
        assert_eq!(refused(polygon(6, -1.0, 0.5)), Some("side"));
        assert_eq!(refused(polygon(6, 2.5, f64::NAN)), Some("mesh"));
        assert_eq!(refused(polygon(6, 2.5, 1e-9)), Some("mesh"));
        let error = polygon(6, 2.5, 2.2).unwrap_err().to_string();
        assert_eq!(error, "a mesh of 2.2 m is larger than the distance from the middle to a side, 2.16506 m");
    }

    proptest! {
        #[test]
        fn every_polygon_web_has_its_counts_lengths_area_cells_and_symmetry(
            sides in 3..=24_usize, side in 0.3..9.0_f64, share in 0.03..1.0_f64,
        ) {
            let apothem = 0.5 * side / (PI / sides as f64).tan();
            let mesh = share * apothem;
            let web = polygon(sides, side, mesh).unwrap();
            prop_assert_eq!(web.check(), []);
            prop_assert!(is_turned(&web, sides) && is_mirrored(&web));

            let n = sides as f64;
            let spacing = parallel_spacing(sides, side, mesh).unwrap();
            let parallels = (apothem / spacing).round();
            prop_assert!((spacing / mesh).max(mesh / spacing) <= 1.5 + 1e-9);
            let length = web.rope_length_by_class();
            let is = |got: f64, expected: f64| (got - expected).abs() < 1e-9 * n * side * parallels;
            prop_assert!(is(length[&Class::Outline], n * side));
            // the perimeters of the rings are an arithmetic progression
            let rings = length.get(&Class::Ring).copied().unwrap_or(0.0);
            prop_assert!(is(rings, n * side * (parallels - 1.0) / 2.0));
            prop_assert!(is(web.reference_area().unwrap(), 0.5 * n * side * apothem));

            // Euler: cells = ropes + 1 - knots; their areas sum up to that of the web
            let net = cut(&web, &Cutting::SegmentLength(10.0 * side)).unwrap();
            let cells = net.cells();
            prop_assert_eq!(cells.len(), web.ropes.len() + 1 - web.knots.len());
            let area = |cell: &Vec<usize>| vector_area(&cell.iter().map(|&n| net.nodes[n]).collect::<Vec<_>>()).z;
            prop_assert!(is(cells.iter().map(area).sum(), 0.5 * n * side * apothem));
            // cells at the outline are at most sqrt 2 times as wide as high, and a little more for the slant of the
            // radials
            let width = |rope: &crate::Rope| web.drawn_length(rope);
            let widest = web.ropes.iter().filter(|rope| rope.class == Class::Outline).map(width).fold(0.0, f64::max);
            prop_assert!(widest <= spacing * SQRT_2 * (1.0 + 1.0 / (2.0 * parallels - 1.0)) + 1e-9);
        }
    }
}

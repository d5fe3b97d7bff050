//! The polygon web: a regular polygon filled with concentric polygons and the radials that join them.
//!
//! A square or hexagonal lattice fits no other polygon; this filling is the same for all. From the middle to each side
//! run parallels of it, a mesh apart. A radial runs to every corner, and in the sector between two of them so many more
//! that its cells come out as wide as high, as nearly as powers of two allow: where cells grow wider than sqrt(2) meshes,
//! every cell is halved by a radial that begins there.

use std::f64::consts::{PI, SQRT_2};

use crate::error::{in_range, positive, rounded};
use crate::sectors::Sectors;
use crate::{Web, WebError};

/// With more, the radials at the corners alone are closer in the middle than any mesh.
const MOST_SIDES: usize = 24;

const MOST_PARALLELS: usize = 1000;

/// The polygon web: a regular polygon with `sides` sides of `side` m, a corner at 90 degrees, and parallels about
/// a mesh, m, apart: [`parallel_spacing`].
///
/// Knots are numbered from the middle outwards, ring by ring; corners anticlockwise from the one at 90 degrees. Classes:
/// outline; ring, the other parallels; radial, the rest. Feature points: B the knot in the middle, C the corner at 90
/// degrees, D half way between.
///
/// # Errors
/// [`WebError::Argument`]: `sides`, `side` or `mesh`.
pub fn polygon(sides: usize, side: f64, mesh: f64) -> Result<Web, WebError> {
    let parallels = parallels(sides, side, mesh)?;
    let radius = 0.5 * side / libm::sin(PI / sides as f64);
    // of a sector at the height of one mesh, in meshes
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

/// Distance from one parallel of a polygon web to the next, m: the part of the apothem nearest to the mesh.
///
/// # Errors
/// As [`polygon`].
pub fn parallel_spacing(sides: usize, side: f64, mesh: f64) -> Result<f64, WebError> {
    Ok(apothem(sides, side) / parallels(sides, side, mesh)? as f64)
}

/// From the middle to the middle of a side, m.
fn apothem(sides: usize, side: f64) -> f64 {
    0.5 * side / libm::tan(PI / sides as f64)
}

/// Parallels from the middle to a side, the side itself included.
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
    fn a_hexagon_of_four_parallels() {
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
    fn one_parallel_is_a_polygon_with_its_radials() {
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
        fn counts_lengths_area_cells_and_symmetry(sides in 3..=24_usize, side in 0.3..9.0_f64, share in 0.03..1.0_f64) {
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
            // perimeters in arithmetic progression
            let rings = length.get(&Class::Ring).copied().unwrap_or(0.0);
            prop_assert!(is(rings, n * side * (parallels - 1.0) / 2.0));
            prop_assert!(is(web.reference_area().unwrap(), 0.5 * n * side * apothem));

            // Euler: the cells are as many as the loops of ropes, and tile the web
            let net = cut(&web, &Cutting::SegmentLength(10.0 * side)).unwrap();
            let cells = net.cells();
            prop_assert_eq!(cells.len(), web.ropes.len() + 1 - web.knots.len());
            let area = |cell: &Vec<usize>| vector_area(&cell.iter().map(|&n| net.nodes[n]).collect::<Vec<_>>()).z;
            prop_assert!(is(cells.iter().map(area).sum(), 0.5 * n * side * apothem));
            // beside the middle, where few sides meet, cells are as wide as high within sqrt 2 and the slant of a side
            let width = |rope: &crate::Rope| web.drawn_length(rope);
            let widest = web.ropes.iter().filter(|rope| rope.class == Class::Outline).map(width).fold(0.0, f64::max);
            prop_assert!(widest <= spacing * SQRT_2 * (1.0 + 1.0 / (2.0 * parallels - 1.0)) + 1e-9);
        }
    }
}

//! The square net: square meshes in a square outline, with tractors at the four corners.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::error::{in_range, positive, rounded};
use crate::rope_list::RopeList;
use crate::{Class, Knot, Site, Web, WebError};

const MOST_CELLS: usize = 2000;

/// Largest relative difference of side / mesh from a whole number: rounding of decimal input.
const ROUNDING: f64 = 1e-9;

/// Draws the square net with this side and this mesh, both m. The mesh must divide the side.
///
/// Knots are numbered row by row from below, corners anticlockwise from the upper right. Classes: outline, inner.
/// Feature points: B is the knot nearest to the centre (of four, the lower left), C the upper right corner, D a knot
/// half way between.
///
/// # Errors
/// [`WebError::Argument`]: `side` or `mesh` is not a positive length, or the mesh does not divide the side.
pub fn square(side: f64, mesh: f64) -> Result<Web, WebError> {
    let n = cells(side, mesh)?;
    let mut web = Web::default();
    let knot = |i: usize, j: usize| j * (n + 1) + i;

    // multiples of half a mesh from the centre, so that opposite knots are exact mirror images
    let coordinate = |i: usize| (2 * i as i64 - n as i64) as f64 * (side / (2 * n) as f64);
    for j in 0..=n {
        for i in 0..=n {
            let position = DVec3::new(coordinate(i), coordinate(j), 0.0);
            web.knots.push(Knot::new(format!("knot {}", knot(i, j) + 1), position));
        }
    }
    web.corners = vec![knot(n, n), knot(0, n), knot(0, 0), knot(n, 0)];
    for (&corner, number) in web.corners.iter().zip(1..) {
        web.knots[corner] = Knot::new(format!("web corner {number}"), web.knots[corner].position);
    }

    let class = |line: usize| if line == 0 || line == n { Class::Outline } else { Class::Inner };
    let mut ropes = RopeList::default();
    for j in 0..=n {
        let row: Vec<usize> = (0..=n).map(|i| knot(i, j)).collect();
        ropes.tie_along(&row, class(j));
    }
    for i in 0..=n {
        let column: Vec<usize> = (0..=n).map(|j| knot(i, j)).collect();
        ropes.tie_along(&column, class(i));
    }
    web.ropes = ropes.into_ropes();

    // anticlockwise: top, left, bottom, right
    let top = (1..=n).rev().map(|i| knot(i, n));
    let left = (1..=n).rev().map(|j| knot(0, j));
    let bottom = (0..n).map(|i| knot(i, 0));
    let right = (0..n).map(|j| knot(n, j));
    web.outline = top.chain(left).chain(bottom).chain(right).map(|knot| vec![knot]).collect();

    // with an odd number of cells four knots share the centre
    let (lower, upper) = (n / 2, n.div_ceil(2));
    web.centre = vec![knot(lower, lower), knot(upper, lower), knot(upper, upper), knot(lower, upper)];
    web.centre.sort_unstable();
    web.centre.dedup();
    let half_way = knot((lower + n) / 2, (lower + n).div_ceil(2));
    web.points = BTreeMap::from([
        ("B".into(), Site::Knot(knot(lower, lower))),
        ("C".into(), Site::Knot(knot(n, n))),
        ("D".into(), Site::Knot(half_way)),
    ]);
    Ok(web)
}

/// Number of meshes along a side.
fn cells(side: f64, mesh: f64) -> Result<usize, WebError> {
    positive("side", "the web's side", side)?;
    positive("mesh", "the mesh", mesh)?;
    let ratio = side / mesh;
    if ratio < 1.0 - ROUNDING {
        let fault = format!("a mesh of {mesh} m is larger than the web's side of {side} m");
        return Err(WebError::argument("mesh", fault));
    }
    // a ratio too large for usize saturates and is refused here
    in_range("mesh", "the number of meshes along a side", ratio.round() as usize, 1..=MOST_CELLS)?;
    if (ratio - ratio.round()).abs() > ROUNDING * ratio {
        let [coarser, finer] = [ratio.floor(), ratio.ceil()].map(|cells| rounded(side / cells));
        return Err(WebError::argument(
            "mesh",
            format!(
                "a mesh of {mesh} m does not divide a side of {side} m into whole cells; {coarser} m or {finer} m would"
            ),
        ));
    }
    Ok(ratio.round() as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::refused;

    #[test]
    fn a_five_metre_net_of_half_metre_meshes_has_its_counts_lengths_and_points() {
        let web = square(5.0, 0.5).unwrap();
        assert_eq!(web.knots.len(), 11 * 11);
        assert_eq!(web.ropes.len(), 2 * 10 * 11);
        let length = web.rope_length_by_class();
        assert!((length[&Class::Outline] - 20.0).abs() < 1e-12);
        assert!((length[&Class::Inner] - 2.0 * 9.0 * 5.0).abs() < 1e-12);
        assert!((web.reference_area().unwrap() - 25.0).abs() < 1e-12);
        assert_eq!(web.outline.len(), 40);
        assert_eq!(web.check(), []);
        let at = |point: &str| web.position(web.points[point]);
        assert_eq!(at("B"), DVec3::ZERO);
        assert_eq!(at("C"), DVec3::new(2.5, 2.5, 0.0));
        assert!(at("D").distance(at("C") / 2.0) < 0.5);
    }

    #[test]
    fn corners_run_anticlockwise_from_the_upper_right() {
        let web = square(2.0, 1.0).unwrap();
        let corners: Vec<DVec3> = web.corners.iter().map(|&corner| web.knots[corner].position).collect();
        assert_eq!(corners, [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| DVec3::new(x, y, 0.0)));
    }

    #[test]
    fn four_knots_share_the_centre_of_an_odd_net() {
        let web = square(1.5, 0.5).unwrap();
        assert_eq!(web.centre.len(), 4);
        assert!(web.mean_position(&web.centre).length() < 1e-15);
    }

    #[test]
    fn feature_points_are_three_different_knots() {
        for n in 1..12 {
            let web = square(n as f64, 1.0).unwrap();
            let [b, c, d] = ["B", "C", "D"].map(|point| web.points[point]);
            assert!(b != c && c != d && d != b, "{n} meshes");
        }
    }

    #[test]
    fn a_decimal_mesh_divides_its_side_despite_rounding() {
        assert_eq!(square(0.3, 0.1).unwrap().knots.len(), 16);
        assert_eq!(square(2.1, 0.7).unwrap().knots.len(), 16);
    }

    #[test]
    fn a_mesh_that_does_not_divide_the_side_is_refused_and_two_that_do_are_named() {
        let error = square(5.0, 0.3).unwrap_err();
        assert_eq!(
            error.to_string(),
            "a mesh of 0.3 m does not divide a side of 5 m into whole cells; 0.3125 m or 0.294118 m would"
        );
        for mesh in [2.0, 1e-9, f64::MIN_POSITIVE, 0.0, f64::NAN] {
            assert_eq!(refused(square(1.0, mesh)), Some("mesh"), "{mesh}");
        }
        assert_eq!(refused(square(-1.0, 0.5)), Some("side"));
    }
}

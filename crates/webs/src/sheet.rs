//! The mesh of a hexagonal canopy: equilateral triangles, the hinges between them, and the rim.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::WebError;
use crate::error::{in_range, positive};
use crate::plane::hexagon_corner;

/// Largest number of triangles along a side.
const MOST_FINENESS: usize = 100;

/// A flat regular hexagon about the origin, meshed with triangles; corner k lies at 60 k degrees from the x axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Nodes, m: the middle, then ring by ring outwards, each ring anticlockwise from the x axis.
    pub nodes: Vec<DVec2>,
    /// Triangles by their nodes, anticlockwise.
    pub triangles: Vec<[usize; 3]>,
    /// Pairs of triangles with a common edge: the two nodes of the edge, the third node of the triangle to its left,
    /// and the third node of the triangle to its right.
    pub hinges: Vec<[usize; 4]>,
    /// The node in the middle.
    pub middle: usize,
    /// The nodes on the corners, anticlockwise.
    pub corners: [usize; 6],
    /// The nodes along each side, from corner k to corner k + 1, both included.
    pub sides: [Vec<usize>; 6],
}

/// Meshes a hexagon with this side, m, with n = `fineness` triangles along each side: 6 n^2 triangles, 3 n (n + 1) + 1
/// nodes and 3 n (3 n - 1) hinges.
///
/// # Errors
/// [`WebError::Argument`]: `side` is not a positive length, or `fineness` is not from 1 to 100.
pub fn hexagonal_sheet(side: f64, fineness: usize) -> Result<Sheet, WebError> {
    positive("side", "a sheet's side", side)?;
    in_range("fineness", "a sheet's fineness", fineness, 1..=MOST_FINENESS)?;

    let spacing = side / fineness as f64;
    let mut nodes = vec![DVec2::ZERO];
    let mut triangles = Vec::new();
    for ring in 1..=fineness {
        for sector in 0..6 {
            let (corner, next) = (hexagon_corner(sector), hexagon_corner(sector + 1));
            for step in 0..ring {
                nodes.push(spacing * ((ring - step) as f64 * corner + step as f64 * next));
                let outer = [node(ring, sector, step), node(ring, sector, step + 1)];
                let inner = node(ring - 1, sector, step);
                triangles.push([inner, outer[0], outer[1]]);
                if step + 1 < ring {
                    triangles.push([inner, outer[1], node(ring - 1, sector, step + 1)]);
                }
            }
        }
    }
    let hinges = hinges(&triangles);
    Ok(Sheet {
        nodes,
        triangles,
        hinges,
        middle: 0,
        corners: std::array::from_fn(|k| node(fineness, k, 0)),
        sides: std::array::from_fn(|k| (0..=fineness).map(|step| node(fineness, k, step)).collect()),
    })
}

/// The node on a ring that lies `step` nodes after the first corner of a sector.
fn node(ring: usize, sector: usize, step: usize) -> usize {
    if ring == 0 { 0 } else { 1 + 3 * ring * (ring - 1) + (sector * ring + step) % (6 * ring) }
}

/// The hinges in the order of their second triangles; every inner edge has one.
fn hinges(triangles: &[[usize; 3]]) -> Vec<[usize; 4]> {
    let mut left_of = BTreeMap::new();
    let mut hinges = Vec::new();
    for triangle in triangles {
        for i in 0..3 {
            let [from, to, far] = [triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]];
            // the neighbouring triangle has the edge in the opposite direction
            match left_of.get(&(to, from)) {
                Some(&other) => hinges.push([to, from, other, far]),
                None => {
                    left_of.insert((from, to), far);
                }
            }
        }
    }
    hinges
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::error::refused;

    fn area(sheet: &Sheet, [a, b, c]: [usize; 3]) -> f64 {
        0.5 * (sheet.nodes[b] - sheet.nodes[a]).perp_dot(sheet.nodes[c] - sheet.nodes[a])
    }

    #[test]
    fn numbers_of_nodes_triangles_and_hinges_satisfy_euler_s_formula() {
        for n in [1, 2, 3, 8] {
            let sheet = hexagonal_sheet(0.14, n).unwrap();
            assert_eq!(sheet.nodes.len(), 3 * n * (n + 1) + 1);
            assert_eq!(sheet.triangles.len(), 6 * n * n);
            assert_eq!(sheet.hinges.len(), 3 * n * (3 * n - 1));
            let sorted = |a: usize, b: usize| (a.min(b), a.max(b));
            let edges: BTreeSet<(usize, usize)> =
                sheet.triangles.iter().flat_map(|&[a, b, c]| [sorted(a, b), sorted(b, c), sorted(c, a)]).collect();
            // Euler: nodes - edges + faces = 1
            assert_eq!(sheet.nodes.len() + sheet.triangles.len(), edges.len() + 1);
            assert_eq!(edges.len(), sheet.hinges.len() + 6 * n);
        }
    }

    #[test]
    fn triangles_have_equal_areas_and_fill_the_hexagon() {
        let sheet = hexagonal_sheet(0.14, 5).unwrap();
        let whole = 1.5 * 3.0_f64.sqrt() * 0.14 * 0.14;
        for &triangle in &sheet.triangles {
            assert!((area(&sheet, triangle) / whole * 150.0 - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn hinges_lie_between_a_triangle_on_the_left_and_one_on_the_right() {
        let sheet = hexagonal_sheet(1.0, 4).unwrap();
        let exists = |triangle: [usize; 3]| {
            (0..3).any(|turn| sheet.triangles.contains(&std::array::from_fn(|i| triangle[(i + turn) % 3])))
        };
        for &[from, to, left, right] in &sheet.hinges {
            assert!(exists([from, to, left]) && exists([to, from, right]));
        }
    }

    #[test]
    fn nodes_of_a_side_lie_evenly_from_corner_to_corner() {
        let sheet = hexagonal_sheet(0.14, 4).unwrap();
        assert_eq!(sheet.nodes[sheet.middle], DVec2::ZERO);
        for k in 0..6 {
            let (from, to) = (sheet.corners[k], sheet.corners[(k + 1) % 6]);
            let side = &sheet.sides[k];
            assert_eq!((side[0], side[4], side.len()), (from, to, 5));
            assert!(sheet.nodes[from].distance(0.14 * hexagon_corner(k)) < 1e-15);
            for pair in side.windows(2) {
                let step = (sheet.nodes[to] - sheet.nodes[from]) / 4.0;
                assert!((sheet.nodes[pair[1]] - sheet.nodes[pair[0]]).distance(step) < 1e-15);
            }
        }
    }

    #[test]
    fn wrong_sides_and_finenesses_are_refused() {
        assert_eq!(refused(hexagonal_sheet(0.0, 3)), Some("side"));
        assert_eq!(refused(hexagonal_sheet(0.14, 0)), Some("fineness"));
        assert_eq!(refused(hexagonal_sheet(0.14, MOST_FINENESS + 1)), Some("fineness"));
    }
}

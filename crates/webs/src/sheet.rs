//! A hexagonal canopy as a sheet: a mesh of equilateral triangles, the hinges between them, and its rim.

use std::collections::BTreeMap;

use glam::DVec2;

use crate::WebError;
use crate::error::{in_range, positive};
use crate::field::WebField;

/// Finest mesh of a sheet, triangles along a side.
pub const MOST_FINENESS: usize = 100;

/// A regular hexagon meshed with triangles, flat, about the origin; corner k lies at 60 k degrees from the x axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Nodes, m: the middle, then ring by ring outwards, each ring anticlockwise from the x axis.
    pub nodes: Vec<DVec2>,
    /// Triangles, anticlockwise.
    pub triangles: Vec<[usize; 3]>,
    /// Pairs of triangles that share an edge: its two nodes, then the far node to the left of it, and to the right.
    pub hinges: Vec<[usize; 4]>,
    /// The node in the middle.
    pub middle: usize,
    /// The nodes on the corners, anticlockwise.
    pub corners: [usize; 6],
    /// The nodes along each side, from corner k to corner k + 1, both included.
    pub sides: [Vec<usize>; 6],
}

/// A hexagon of this side, m, with `fineness` triangles along each side: 6 n^2 triangles, 3 n (n + 1) + 1 nodes, 3 n
/// (3 n - 1) hinges.
///
/// # Errors
/// A side that is not a positive length; a fineness of zero or above [`MOST_FINENESS`].
pub fn hexagonal_sheet(side: f64, fineness: usize) -> Result<Sheet, WebError> {
    positive(WebField::SheetSide, side)?;
    in_range(WebField::Fineness, fineness, 1, MOST_FINENESS)?;

    let spacing = side / fineness as f64;
    let mut nodes = vec![DVec2::ZERO];
    let mut triangles = Vec::new();
    for ring in 1..=fineness {
        for sector in 0..6 {
            let (corner, next) = (corner(sector), corner(sector + 1));
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

/// Unit vector at 60 k degrees; opposite ones are exact negatives.
fn corner(k: usize) -> DVec2 {
    let y = 0.75_f64.sqrt();
    match k % 6 {
        0 => DVec2::X,
        1 => DVec2::new(0.5, y),
        2 => DVec2::new(-0.5, y),
        3 => DVec2::NEG_X,
        4 => DVec2::new(-0.5, -y),
        _ => DVec2::new(0.5, -y),
    }
}

/// The node `step` steps on from the corner of a sector on a ring.
fn node(ring: usize, sector: usize, step: usize) -> usize {
    if ring == 0 { 0 } else { 1 + 3 * ring * (ring - 1) + (sector * ring + step) % (6 * ring) }
}

/// Each inner edge once, in the order in which triangles come to share it.
fn hinges(triangles: &[[usize; 3]]) -> Vec<[usize; 4]> {
    let mut left_of = BTreeMap::new();
    let mut hinges = Vec::new();
    for triangle in triangles {
        for i in 0..3 {
            let [from, to, far] = [triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]];
            // the triangle on the other side runs along the edge the other way
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
    use super::*;
    use std::collections::BTreeSet;

    fn area(sheet: &Sheet, [a, b, c]: [usize; 3]) -> f64 {
        0.5 * (sheet.nodes[b] - sheet.nodes[a]).perp_dot(sheet.nodes[c] - sheet.nodes[a])
    }

    #[test]
    fn it_has_the_nodes_triangles_and_hinges_of_a_disc() {
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
    fn its_triangles_are_equal_and_fill_the_hexagon() {
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
    fn its_rim_runs_from_corner_to_corner() {
        let sheet = hexagonal_sheet(0.14, 4).unwrap();
        assert_eq!(sheet.nodes[sheet.middle], DVec2::ZERO);
        for k in 0..6 {
            let (from, to) = (sheet.corners[k], sheet.corners[(k + 1) % 6]);
            let side = &sheet.sides[k];
            assert_eq!((side[0], side[4], side.len()), (from, to, 5));
            assert!(sheet.nodes[from].distance(0.14 * corner(k)) < 1e-15);
            for pair in side.windows(2) {
                let step = (sheet.nodes[to] - sheet.nodes[from]) / 4.0;
                assert!((sheet.nodes[pair[1]] - sheet.nodes[pair[0]]).distance(step) < 1e-15);
            }
        }
    }

    #[test]
    fn what_cannot_be_meshed_is_refused() {
        assert!(matches!(hexagonal_sheet(0.0, 3), Err(WebError::Length { .. })));
        assert!(matches!(hexagonal_sheet(0.14, 0), Err(WebError::Count { .. })));
        assert!(matches!(hexagonal_sheet(0.14, MOST_FINENESS + 1), Err(WebError::Count { .. })));
    }
}

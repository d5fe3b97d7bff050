//! The diamond net: rhombic meshes, as in a knotted fishing net, hung in a rectangular border.
//!
//! ```text
//!   w = 2 b E      h = 2 b sqrt(1 - E^2)      E = sin(angle / 2)
//! ```
//! Here b is the bar, the side of a mesh from knot to knot; w and h are the width and height of a mesh; angle is the
//! mesh's angle at its upper and lower knot. E is the hanging ratio: the length of the border over the length of the
//! netting stretched out along it. (Fridman, Calculations for Fishing Gear Designs, FAO 1986: primary and secondary
//! hanging ratio, E1^2 + E2^2 = 1.)

use std::collections::BTreeMap;

use glam::DVec3;

use crate::error::{in_range, positive};
use crate::rope_list::RopeList;
use crate::{Class, Knot, Site, Web, WebError};

const MOST_MESHES: usize = 1000;

/// A diamond net.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diamond {
    /// Side of a mesh, from knot to knot, m.
    pub mesh: f64,
    /// Hanging ratio: width of a mesh over twice its side, more than 0 and less than 1.
    pub hanging_ratio: f64,
    /// Number of meshes across the width, 1 to 1000.
    pub meshes_wide: usize,
    /// Number of meshes across the height, 1 to 1000.
    pub meshes_high: usize,
}

impl Diamond {
    /// Width and height of a mesh, m.
    pub fn opening(&self) -> [f64; 2] {
        let ratio = self.hanging_ratio;
        // (1 - E) (1 + E), not 1 - E^2, which cancels where E is nearly 1
        [ratio, ((1.0 - ratio) * (1.0 + ratio)).sqrt()].map(|share| 2.0 * self.mesh * share)
    }

    /// Width and height of the net, m.
    pub fn size(&self) -> [f64; 2] {
        let [width, height] = self.opening();
        [width * self.meshes_wide as f64, height * self.meshes_high as f64]
    }
}

/// Draws the diamond net, with a border rope that is tied to every knot along it.
///
/// Knots are numbered row by row from below, corners anticlockwise from the upper right. Classes: the border is
/// outline, the bars are inner. Feature points: B is the knot nearest to the centre (of four, the lowest), C the upper
/// right corner, D a knot half way between.
///
/// # Errors
/// [`WebError::Argument`]: a field of [`Diamond`] is out of its range.
pub fn diamond(net: &Diamond) -> Result<Web, WebError> {
    let &Diamond { mesh, hanging_ratio, meshes_wide: m, meshes_high: n } = net;
    positive("mesh", "the mesh", mesh)?;
    if !(hanging_ratio > 0.0 && hanging_ratio < 1.0) {
        let fault = format!("the hanging ratio must be greater than 0 and less than 1, not {hanging_ratio}");
        return Err(WebError::argument("hanging_ratio", fault));
    }
    in_range("meshes_wide", "the number of meshes across the width", m, 1..=MOST_MESHES)?;
    in_range("meshes_high", "the number of meshes across the height", n, 1..=MOST_MESHES)?;

    // i counts half meshes to the right, j half meshes upwards; at a knot both are even or both odd
    let knot = |i: usize, j: usize| j / 2 * (2 * m + 1) + j % 2 * (m + 1) + i / 2;
    let [width, height] = net.opening();
    let coordinate = |step: usize, half: usize, size: f64| (step as i64 - half as i64) as f64 * (0.5 * size);
    let mut web = Web::default();
    for j in 0..=2 * n {
        for i in (j % 2..=2 * m).step_by(2) {
            let position = DVec3::new(coordinate(i, m, width), coordinate(j, n, height), 0.0);
            web.knots.push(Knot::new(format!("knot {}", knot(i, j) + 1), position));
        }
    }
    web.corners = vec![knot(2 * m, 2 * n), knot(0, 2 * n), knot(0, 0), knot(2 * m, 0)];
    for (&corner, number) in web.corners.iter().zip(1..) {
        web.knots[corner] = Knot::new(format!("web corner {number}"), web.knots[corner].position);
    }

    // the border anticlockwise: top, left, bottom, right
    let top = (1..=m).rev().map(|i| knot(2 * i, 2 * n));
    let left = (1..=n).rev().map(|j| knot(0, 2 * j));
    let bottom = (0..m).map(|i| knot(2 * i, 0));
    let right = (0..n).map(|j| knot(2 * m, 2 * j));
    let border: Vec<usize> = top.chain(left).chain(bottom).chain(right).collect();
    let closed: Vec<usize> = border.iter().chain(&border[..1]).copied().collect();
    let mut ropes = RopeList::default();
    ropes.tie_along(&closed, Class::Outline);
    // bars row by row: each row is a zigzag from the left border to the right
    for j in 0..2 * n {
        let zigzag: Vec<usize> = (0..=2 * m).map(|i| knot(i, j + (i + j) % 2)).collect();
        ropes.tie_along(&zigzag, Class::Inner);
    }
    web.ropes = ropes.into_ropes();
    web.outline = border.into_iter().map(|knot| vec![knot]).collect();

    // the centre is a knot or the middle of a mesh
    let is_knot = (m + n).is_multiple_of(2);
    web.centre =
        if is_knot { vec![knot(m, n)] } else { vec![knot(m, n - 1), knot(m - 1, n), knot(m + 1, n), knot(m, n + 1)] };
    let (i, j) = ((3 * m).div_ceil(2), 3 * n / 2);
    web.points = BTreeMap::from([
        ("B".into(), Site::Knot(web.centre[0])),
        ("C".into(), Site::Knot(web.corners[0])),
        ("D".into(), Site::Knot(knot(i, j - (i + j) % 2))),
    ]);
    Ok(web)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;
    use crate::error::refused;
    use crate::symmetry::{is_mirrored, is_turned};
    use crate::{Cutting, cut, vector_area};

    const NET: Diamond = Diamond { mesh: 0.1, hanging_ratio: 0.6, meshes_wide: 30, meshes_high: 20 };

    #[test]
    fn a_net_of_thirty_by_twenty_meshes_has_its_counts_lengths_and_area() {
        let web = diamond(&NET).unwrap();
        // 3-4-5: meshes 0.12 m wide and 0.16 m high
        let [width, height] = NET.size();
        assert!((width - 3.6).abs() < 1e-12 && (height - 3.2).abs() < 1e-12);
        assert_eq!(web.knots.len(), 31 * 21 + 30 * 20);
        assert_eq!(web.ropes.len(), 4 * 30 * 20 + 2 * (30 + 20));
        let length = web.rope_length_by_class();
        assert!((length[&Class::Inner] - 240.0).abs() < 1e-9);
        assert!((length[&Class::Outline] - 13.6).abs() < 1e-9);
        assert!((web.reference_area().unwrap() - 3.6 * 3.2).abs() < 1e-9);
        let corner = web.knots[web.corners[0]].position;
        assert!(corner.distance(DVec3::new(1.8, 1.6, 0.0)) < 1e-12);
        assert_eq!(web.position(web.points["B"]), DVec3::ZERO);
        assert!(web.position(web.points["D"]).distance(0.5 * corner) < 0.1);
    }

    #[test]
    fn at_a_hanging_ratio_of_1_over_sqrt_2_meshes_are_squares() {
        let net = Diamond { hanging_ratio: 0.5_f64.sqrt(), ..NET };
        let [width, height] = net.opening();
        assert!((width - height).abs() < 1e-15 && (width - 0.1 * 2.0_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn wrong_sizes_are_refused() {
        for hanging_ratio in [0.0, -0.5, 1.0, 1.5, f64::NAN] {
            assert_eq!(refused(diamond(&Diamond { hanging_ratio, ..NET })), Some("hanging_ratio"));
        }
        assert_eq!(refused(diamond(&Diamond { mesh: 0.0, ..NET })), Some("mesh"));
        for meshes in [0, 1001] {
            assert_eq!(refused(diamond(&Diamond { meshes_wide: meshes, ..NET })), Some("meshes_wide"));
            assert_eq!(refused(diamond(&Diamond { meshes_high: meshes, ..NET })), Some("meshes_high"));
        }
    }

    proptest! {
        #[test]
        fn every_diamond_net_has_its_counts_lengths_area_cells_and_symmetry(
            mesh in 0.01..2.0_f64,
            hanging_ratio in 0.02..0.98_f64,
            meshes_wide in 1..20_usize,
            meshes_high in 1..20_usize,
        ) {
            let net = Diamond { mesh, hanging_ratio, meshes_wide, meshes_high };
            let web = diamond(&net).unwrap();
            prop_assert_eq!(web.check(), []);
            prop_assert!(is_turned(&web, 2) && is_mirrored(&web));
            let points: BTreeSet<String> = ["B", "C", "D"].map(|point| format!("{:?}", web.points[point])).into();
            prop_assert_eq!(points.len(), 3);
            prop_assert!(web.mean_position(&web.centre).length() < 1e-12);

            let (m, n) = (meshes_wide as f64, meshes_high as f64);
            let [width, height] = [2.0 * mesh * hanging_ratio, 2.0 * mesh * (1.0 - hanging_ratio.powi(2)).sqrt()];
            prop_assert_eq!(web.knots.len(), (meshes_wide + 1) * (meshes_high + 1) + meshes_wide * meshes_high);
            let is = |got: f64, expected: f64| (got - expected).abs() < 1e-9 * expected;
            let length = web.rope_length_by_class();
            prop_assert!(is(length[&Class::Inner], 4.0 * m * n * mesh));
            prop_assert!(is(length[&Class::Outline], 2.0 * (m * width + n * height)));
            prop_assert!(is(web.reference_area().unwrap(), m * width * n * height));
            // all bars have the same length
            let bars = web.ropes.iter().filter(|rope| rope.class == Class::Inner);
            prop_assert!(bars.map(|rope| web.drawn_length(rope)).all(|length| is(length, mesh)));

            // whole meshes, and half ones along the border
            let net = cut(&web, &Cutting::SegmentLength(10.0 * mesh)).unwrap();
            let area = |cell: Vec<usize>| vector_area(&cell.iter().map(|&n| net.nodes[n]).collect::<Vec<_>>()).z;
            let areas: Vec<f64> = net.cells().into_iter().map(area).collect();
            let whole = areas.iter().filter(|area| is(**area, 0.5 * width * height)).count();
            let half = areas.iter().filter(|area| is(**area, 0.25 * width * height)).count();
            let (m, n) = (meshes_wide, meshes_high);
            prop_assert_eq!((whole, half, areas.len()), (m * (n - 1) + (m - 1) * n, 2 * (m + n), whole + half));
        }
    }
}

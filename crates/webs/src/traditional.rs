//! The traditional rope web: square cells clipped by a regular hexagon, with a rope along the outline.
//!
//! Ropes run along the lines x = i h and y = j h with h = side / cells per side. They are tied where they cross and
//! where they meet the outline. The corners of the hexagon lie at 30, 90, 150, ... degrees from the x axis. Clipping
//! leaves short ropes near the outline; [`Web::merge_stubs`] removes them.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::error::{in_range, positive};
use crate::plane::compass;
use crate::rope_list::RopeList;
use crate::{Class, Knot, Site, Web, WebError};

const MOST_CELLS: usize = 1000;

/// Where a line of the grid meets the outline.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum End {
    /// At a corner of the hexagon, 0 to 5 anticlockwise from the one at 30 degrees.
    Corner(usize),
    /// The lower (-1) or upper (1) end of the column at x = i h.
    Column(i64, i64),
    /// The left (-1) or right (1) end of the row at y = j h.
    Row(i64, i64),
}

/// The grid of cells in the hexagon.
struct Grid {
    /// Number of cells along a side of the hexagon.
    cells: i64,
    /// Side of the hexagon, m.
    side: f64,
}

impl Grid {
    /// Side of a cell, m.
    fn cell(&self) -> f64 {
        self.side / self.cells as f64
    }

    /// The largest i of a column inside. No column lies on an upright side: its distance from the centre is an
    /// irrational number of cells.
    fn last_column(&self) -> i64 {
        (self.cells as f64 * 0.75_f64.sqrt()).floor() as i64
    }

    /// The largest j of a row inside.
    fn last_row(&self) -> i64 {
        self.cells - 1
    }

    /// Whether the crossing of column i and row j lies inside the outline. The slanted sides are |j| + |i| / sqrt(3) =
    /// cells; integers satisfy this only at a corner, i = 0.
    fn is_inside(&self, i: i64, j: i64) -> bool {
        i.abs() <= self.last_column() && i.abs() as f64 / 3.0_f64.sqrt() < (self.cells - j.abs()) as f64
    }

    /// The lower (`up` = -1) or upper (1) end of a column.
    fn column_end(&self, i: i64, up: i64) -> End {
        match (i, up) {
            (0, 1) => End::Corner(1),
            (0, _) => End::Corner(4),
            _ => End::Column(i, up),
        }
    }

    /// The left (`right` = -1) or right (1) end of a row.
    fn row_end(&self, j: i64, right: i64) -> End {
        if 2 * j.abs() != self.cells {
            return End::Row(j, right);
        }
        let [at_left, at_right] = if j > 0 { [2, 0] } else { [3, 5] };
        End::Corner(if right > 0 { at_right } else { at_left })
    }

    /// Position of an end, m, and its side of the hexagon; side 0 runs from the corner at 30 degrees to that at 90
    /// degrees.
    fn place(&self, end: End) -> (DVec3, usize) {
        let slanted = |is_right: bool, is_up: bool| {
            let [at_left, at_right] = if is_up { [1, 0] } else { [3, 4] };
            if is_right { at_right } else { at_left }
        };
        match end {
            End::Corner(corner) => (compass(corner) * self.side, corner),
            End::Column(i, up) => {
                let x = i as f64 * self.cell();
                let y = up as f64 * (self.side - x.abs() / 3.0_f64.sqrt());
                (DVec3::new(x, y, 0.0), slanted(i > 0, up > 0))
            }
            End::Row(j, right) => {
                let y = j as f64 * self.cell();
                let (reach, side) = if 2 * j.abs() < self.cells {
                    (self.side * 0.75_f64.sqrt(), if right > 0 { 5 } else { 2 })
                } else {
                    ((self.side - y.abs()) * 3.0_f64.sqrt(), slanted(right > 0, j > 0))
                };
                (DVec3::new(right as f64 * reach, y, 0.0), side)
            }
        }
    }
}

/// Draws the traditional web: a hexagon with this side, m, and 2 to 1000 square cells along a side.
///
/// Knots inside are numbered row by row from below; those of the outline follow, anticlockwise from the corner at 30
/// degrees. Classes: outline; radial for the two lines through the centre; inner for the others. Feature points: B is
/// the knot in the centre, C the corner at 90 degrees, D the knot half way between.
///
/// # Errors
/// [`WebError::Argument`]: `side` or `cells_per_side` is out of its range.
pub fn traditional(side: f64, cells_per_side: usize) -> Result<Web, WebError> {
    positive("side", "the web's side", side)?;
    in_range("cells_per_side", "the number of cells along a side", cells_per_side, 2..=MOST_CELLS)?;
    let grid = Grid { cells: cells_per_side as i64, side };
    let (last_row, last_column) = (grid.last_row(), grid.last_column());
    let mut web = Web::default();

    // knots inside, row by row
    let mut crossing = BTreeMap::new();
    for j in -last_row..=last_row {
        for i in (-last_column..=last_column).filter(|&i| grid.is_inside(i, j)) {
            crossing.insert((i, j), web.knots.len());
            let position = DVec3::new(i as f64 * grid.cell(), j as f64 * grid.cell(), 0.0);
            web.knots.push(Knot::new(format!("knot {}", web.knots.len() + 1), position));
        }
    }

    // knots on the outline, in order along it
    let columns = (-last_column..=last_column).flat_map(|i| [-1, 1].map(|up| grid.column_end(i, up)));
    let rows = (-last_row..=last_row).flat_map(|j| [-1, 1].map(|right| grid.row_end(j, right)));
    let mut ends: Vec<End> = (0..6).map(End::Corner).chain(columns).chain(rows).collect();
    let along = |end: End| {
        let (position, side) = grid.place(end);
        (side, position.distance_squared(compass(side) * grid.side))
    };
    ends.sort_by(|&a, &b| {
        let ((side_a, distance_a), (side_b, distance_b)) = (along(a), along(b));
        side_a.cmp(&side_b).then(distance_a.total_cmp(&distance_b))
    });
    ends.dedup();
    let mut knot_of_end = BTreeMap::new();
    for end in ends {
        let knot = web.knots.len();
        knot_of_end.insert(end, knot);
        let label = match end {
            End::Corner(corner) => format!("web corner {}", corner + 1),
            _ => format!("knot {}", knot + 1),
        };
        web.knots.push(Knot::new(label, grid.place(end).0));
        web.outline.push(vec![knot]);
    }
    web.corners = (0..6).map(|corner| knot_of_end[&End::Corner(corner)]).collect();

    // ropes line by line
    let class = |line: i64| if line == 0 { Class::Radial } else { Class::Inner };
    let mut ropes = RopeList::default();
    for i in -last_column..=last_column {
        let inside = (-last_row..=last_row).filter_map(|j| crossing.get(&(i, j)).copied());
        let (first, last) = (knot_of_end[&grid.column_end(i, -1)], knot_of_end[&grid.column_end(i, 1)]);
        let line: Vec<usize> = std::iter::once(first).chain(inside).chain([last]).collect();
        ropes.tie_along(&line, class(i));
    }
    for j in -last_row..=last_row {
        let inside = (-last_column..=last_column).filter_map(|i| crossing.get(&(i, j)).copied());
        let (first, last) = (knot_of_end[&grid.row_end(j, -1)], knot_of_end[&grid.row_end(j, 1)]);
        let line: Vec<usize> = std::iter::once(first).chain(inside).chain([last]).collect();
        ropes.tie_along(&line, class(j));
    }
    let outline: Vec<usize> = web.outline.iter().map(|vertex| vertex[0]).chain([web.outline[0][0]]).collect();
    ropes.tie_along(&outline, Class::Outline);
    web.ropes = ropes.into_ropes();

    let centre = crossing[&(0, 0)];
    web.centre = vec![centre];
    web.points = BTreeMap::from([
        ("B".into(), Site::Knot(centre)),
        ("C".into(), Site::Knot(web.corners[1])),
        ("D".into(), Site::Knot(crossing[&(0, grid.cells / 2)])),
    ]);
    Ok(web)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::refused;

    fn paper_web() -> Web {
        traditional(2.5, 6).unwrap()
    }

    #[test]
    fn the_paper_s_web_has_its_lengths_and_its_area() {
        let web = paper_web();
        let length = web.rope_length_by_class();
        assert!((length[&Class::Outline] - 15.0).abs() < 1e-12);
        assert!((length[&Class::Radial] + length[&Class::Inner] - 79.54).abs() < 5e-3);
        // the lines x = 0 from corner to corner and y = 0 between the upright sides
        assert!((length[&Class::Radial] - (5.0 + 2.5 * 3.0_f64.sqrt())).abs() < 1e-12);
        assert!((web.reference_area().unwrap() - 1.5 * 3.0_f64.sqrt() * 6.25).abs() < 1e-12);
        assert_eq!(web.check(), []);
    }

    #[test]
    fn the_length_of_rope_inside_is_the_sum_of_the_chords_of_the_hexagon() {
        for cells in 2..15 {
            let web = traditional(1.7, cells).unwrap();
            let h = 1.7 / cells as f64;
            let columns = (-40i64..=40).map(|i| i as f64 * h).filter(|x| x.abs() < 1.7 * 0.75_f64.sqrt());
            let rows = (-40i64..=40).map(|j| j as f64 * h).filter(|y| y.abs() < 1.7 - 1e-9);
            let expected: f64 = columns.map(|x| 2.0 * (1.7 - x.abs() / 3.0_f64.sqrt())).sum::<f64>()
                + rows.map(|y| 3.0_f64.sqrt() * 1.7_f64.min(2.0 * (1.7 - y.abs()))).sum::<f64>();
            let length = web.rope_length_by_class();
            let inside = length[&Class::Radial] + length.get(&Class::Inner).unwrap_or(&0.0);
            assert!((inside - expected).abs() < 1e-9, "{cells} cells: {inside} and {expected}");
            assert!((length[&Class::Outline] - 6.0 * 1.7).abs() < 1e-9);
            assert_eq!(web.check(), [], "{cells} cells");
        }
    }

    #[test]
    fn corners_stand_every_60_degrees_from_30() {
        let web = paper_web();
        for (corner, degrees) in web.corners.iter().zip([30.0, 90.0, 150.0, 210.0, 270.0, 330.0_f64]) {
            let angle = degrees.to_radians();
            let expected = 2.5 * DVec3::new(libm::cos(angle), libm::sin(angle), 0.0);
            assert!(web.knots[*corner].position.distance(expected) < 1e-12);
        }
    }

    #[test]
    fn feature_points_lie_on_the_line_to_the_corner_at_90_degrees() {
        let web = paper_web();
        for (point, y) in [("B", 0.0), ("C", 2.5), ("D", 1.25)] {
            assert!(web.position(web.points[point]).distance(DVec3::new(0.0, y, 0.0)) < 1e-12, "{point}");
        }
    }

    #[test]
    fn the_shortest_stub_is_0_047_m() {
        let web = paper_web();
        let shortest = web.ropes.iter().map(|rope| web.drawn_length(rope)).fold(f64::MAX, f64::min);
        // column 5 from the row through the corners at 30 and 150 degrees up to the outline
        assert!((shortest - (1.25 - 5.0 * 2.5 / 6.0 / 3.0_f64.sqrt())).abs() < 1e-12);
        assert!((shortest - 0.047).abs() < 5e-4);
    }

    #[test]
    fn wrong_sizes_are_refused() {
        assert_eq!(refused(traditional(0.0, 6)), Some("side"));
        assert_eq!(refused(traditional(f64::NAN, 6)), Some("side"));
        assert_eq!(refused(traditional(2.5, 1)), Some("cells_per_side"));
    }
}

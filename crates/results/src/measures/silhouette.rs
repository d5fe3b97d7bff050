//! The silhouette: what of the view along the launch axis the web covers.
//!
//! Every cell is the inside of its loop as seen along the axis: the points that the loop winds round (nonzero rule). The
//! silhouette is the union of all cells, so that folds do not cancel as they do in the outline's area. It is
//! measured on lines across the view: on each the union is exact, and between them the midpoint rule is of second order
//! in their distance.

use glam::{DVec2, DVec3};

/// Lines across the silhouette.
const LINES: usize = 200;
/// Lines across the target.
const TARGET_LINES: usize = 100;

/// The plane that the view along the launch axis is projected onto.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projection {
    across: DVec3,
    up: DVec3,
}

/// The loops of a web's cells as seen along the launch axis, m.
#[derive(Debug, Clone, PartialEq)]
pub struct Silhouette {
    cells: Vec<Vec<DVec2>>,
}

/// A place where a loop crosses a line: the line's number, how far along it, and whether the loop goes up there.
type Crossing = (usize, f64, i32);

impl Projection {
    /// The view along `axis`, a unit vector.
    pub fn along(axis: DVec3) -> Projection {
        let (across, up) = axis.any_orthonormal_pair();
        Projection { across, up }
    }

    /// Where a point appears, m.
    pub fn of(&self, point: DVec3) -> DVec2 {
        DVec2::new(point.dot(self.across), point.dot(self.up))
    }
}

impl Silhouette {
    /// The silhouette of `cells`, closed loops of nodes; none where there are no cells or a position is not finite.
    pub fn new(projection: &Projection, cells: &[Vec<usize>], position: impl Fn(usize) -> DVec3) -> Option<Silhouette> {
        let project = |cell: &Vec<usize>| cell.iter().map(|&node| projection.of(position(node))).collect();
        let cells: Vec<Vec<DVec2>> = cells.iter().map(project).collect();
        let whole = cells.iter().flatten().all(|point| point.is_finite());
        (whole && !cells.is_empty()).then_some(Silhouette { cells })
    }

    /// Its area, m^2.
    pub fn area(&self) -> f64 {
        let heights = || self.cells.iter().flatten().map(|point| point.y);
        let (lowest, highest) = (heights().fold(f64::MAX, f64::min), heights().fold(f64::MIN, f64::max));
        self.covered(lowest, highest, LINES, |_| (f64::MIN, f64::MAX))
    }

    /// The share of a disc that it covers, 0 to 1. The disc is seen face on; `middle` and `diameter` in m.
    pub fn coverage(&self, middle: DVec2, diameter: f64) -> f64 {
        let radius = 0.5 * diameter;
        let half_chord = |y: f64| (radius * radius - (y - middle.y) * (y - middle.y)).max(0.0).sqrt();
        let chord = |y: f64| (middle.x - half_chord(y), middle.x + half_chord(y));
        let (from, to) = (middle.y - radius, middle.y + radius);
        // by the same rule, so that of a disc that is covered no sliver is missing
        let height = diameter / TARGET_LINES as f64;
        let disc: f64 = (0..TARGET_LINES).map(|line| 2.0 * half_chord(line_at(from, height, line)) * height).sum();
        (self.covered(from, to, TARGET_LINES, chord) / disc).min(1.0)
    }

    /// The area that is covered between the heights `from` and `to`, and on each line between the limits that `within`
    /// gives for its height, m^2.
    fn covered(&self, from: f64, to: f64, lines: usize, within: impl Fn(f64) -> (f64, f64)) -> f64 {
        let height = (to - from) / lines as f64;
        if height.is_nan() || height <= 0.0 {
            return 0.0;
        }
        let mut intervals: Vec<Vec<(f64, f64)>> = vec![Vec::new(); lines];
        let mut crossings = Vec::new();
        for cell in &self.cells {
            crossings.clear();
            for (place, &start) in cell.iter().enumerate() {
                let end = cell[(place + 1) % cell.len()];
                cross(start, end, from, height, lines, &mut crossings);
            }
            crossings.sort_by(|one, other| one.0.cmp(&other.0).then(one.1.total_cmp(&other.1)));
            let (mut winding, mut entered) = (0, 0.0);
            for &(line, x, turn) in &crossings {
                if winding == 0 {
                    entered = x;
                }
                winding += turn;
                if winding == 0 && x > entered {
                    intervals[line].push((entered, x));
                }
            }
        }
        let measured = intervals.iter_mut().enumerate().map(|(line, intervals)| {
            let (left, right) = within(line_at(from, height, line));
            union_length(intervals, left, right)
        });
        measured.sum::<f64>() * height
    }
}

/// The height of a line.
fn line_at(from: f64, height: f64, line: usize) -> f64 {
    from + (line as f64 + 0.5) * height
}

/// Adds the crossings of one side of a loop. The half-open rule counts a corner that lies on a line once.
fn cross(start: DVec2, end: DVec2, from: f64, height: f64, lines: usize, crossings: &mut Vec<Crossing>) {
    let (low, high, turn) = if start.y < end.y { (start, end, 1) } else { (end, start, -1) };
    let number = |y: f64| ((y - from) / height - 0.5).ceil().clamp(0.0, lines as f64) as usize;
    for line in number(low.y)..number(high.y) {
        let share = (line_at(from, height, line) - low.y) / (high.y - low.y);
        crossings.push((line, low.x + (high.x - low.x) * share, turn));
    }
}

/// The length of the union of some intervals between `left` and `right`; they are sorted on the way.
fn union_length(intervals: &mut [(f64, f64)], left: f64, right: f64) -> f64 {
    intervals.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (mut length, mut reached) = (0.0, left);
    for &mut (from, to) in intervals {
        let (from, to) = (from.max(reached), to.min(right));
        if to > from {
            length += to - from;
            reached = to;
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square net of `count` x `count` cells of 1 m, its knots placed by `place`.
    fn net(count: usize, place: impl Fn(f64, f64) -> DVec3) -> Silhouette {
        let width = count + 1;
        let nodes: Vec<DVec3> =
            (0..width * width).map(|knot| place((knot % width) as f64, (knot / width) as f64)).collect();
        let corner = |x: usize, y: usize| x + width * y;
        let cells: Vec<Vec<usize>> = (0..count * count)
            .map(|cell| (cell % count, cell / count))
            .map(|(x, y)| vec![corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)])
            .collect();
        Silhouette::new(&Projection::along(DVec3::Z), &cells, |node| nodes[node]).unwrap()
    }

    fn turned(x: f64, y: f64) -> DVec3 {
        let (sine, cosine) = (libm::sin(0.3), libm::cos(0.3));
        DVec3::new(cosine * x - sine * y, sine * x + cosine * y, 0.0)
    }

    #[test]
    fn a_flat_net_turned_in_its_plane_covers_its_area() {
        let area = net(6, turned).area();
        assert!((area - 36.0).abs() < 36.0 * 2e-4, "{area}");
    }

    #[test]
    fn a_net_tilted_by_sixty_degrees_covers_half() {
        let area = net(6, |x, y| DVec3::new(x, 0.5 * y, 0.75_f64.sqrt() * y)).area();
        assert!((area - 18.0).abs() < 1e-9, "{area}");
    }

    #[test]
    fn a_net_folded_in_two_covers_half_its_area() {
        // the half y > 3 lies on the half y < 3
        let folded = net(6, |x, y| turned(x, if y > 3.0 { 6.0 - y } else { y }));
        assert!((folded.area() - 18.0).abs() < 18.0 * 2e-4, "{}", folded.area());
    }

    #[test]
    fn a_twisted_cell_covers_both_its_lobes() {
        let bow = [(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        let silhouette = Silhouette::new(&Projection::along(DVec3::Z), &[vec![0, 1, 2, 3]], |node| bow[node]).unwrap();
        assert!((silhouette.area() - 2.0).abs() < 1e-3, "{}", silhouette.area());
    }

    #[test]
    fn a_net_seen_edge_on_and_a_net_in_one_point_cover_nothing() {
        assert_eq!(net(2, |x, _| DVec3::new(x, 0.0, 0.0)).area(), 0.0);
        assert_eq!(net(2, |_, _| DVec3::ZERO).area(), 0.0);
    }

    #[test]
    fn a_disc_is_covered_by_the_share_that_lies_on_the_net() {
        let view = Projection::along(DVec3::Z);
        let silhouette = net(6, |x, y| DVec3::new(x, y, 0.0));
        let at = |x: f64, y: f64, diameter: f64| silhouette.coverage(view.of(DVec3::new(x, y, 5.0)), diameter);
        assert!((at(3.0, 3.0, 4.0) - 1.0).abs() < 1e-12);
        assert!((at(0.0, 3.0, 4.0) - 0.5).abs() < 1e-3);
        assert!((at(6.0, 0.0, 4.0) - 0.25).abs() < 1e-3);
        assert_eq!(at(-9.0, 3.0, 4.0), 0.0);
        // a disc larger than the net: the net's share of it
        assert!((at(3.0, 3.0, 12.0) - 36.0 / (36.0 * std::f64::consts::PI)).abs() < 2e-3);
    }

    #[test]
    fn without_cells_or_finite_places_there_is_no_silhouette() {
        let view = Projection::along(DVec3::Z);
        assert_eq!(Silhouette::new(&view, &[vec![0, 1, 2]], |_| DVec3::NAN), None);
        assert_eq!(Silhouette::new(&view, &[], |_| DVec3::ZERO), None);
    }
}

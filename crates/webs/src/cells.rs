//! The cells of a web: the loops of rope round its openings, found as the faces of the flat drawing.
//!
//! The web is a graph in the plane. A walk that turns at each knot into the next rope clockwise goes round one face.
//! Together the walks use every rope twice, once each way (de Berg et al., Computational Geometry, 3rd ed. 2008,
//! section 2.2). Traction ropes are left out, and so are gathering ropes, which lie on the outline.

use std::collections::BTreeMap;

use crate::{Class, CutWeb, Rope, vector_area};

/// A loop with a smaller share of the web's area is a rounding error.
const LEAST_SHARE: f64 = 1e-9;

impl CutWeb {
    /// The cells as closed loops of nodes, anticlockwise; each begins at a knot. Canopies are cells too. Empty where
    /// ropes cross in the flat web without a knot: cells are then not defined.
    pub fn cells(&self) -> Vec<Vec<usize>> {
        let sides = self.sides();
        let around = self.around(&sides);
        let faces = faces(&around);
        let knots = around.iter().filter(|neighbours| !neighbours.is_empty()).count();
        // Euler: a drawing without crossings has V - E + F = 1 + C
        if knots + faces.len() != sides.len() / 2 + 1 + components(&around) {
            return Vec::new();
        }
        let loops = faces.into_iter().map(|face| self.with_interiors(&face, &sides));
        let area = |cell: &Vec<usize>| vector_area(&cell.iter().map(|&n| self.nodes[n]).collect::<Vec<_>>()).z;
        let sized: Vec<(f64, Vec<usize>)> = loops.map(|cell| (area(&cell), cell)).collect();
        let whole = sized.iter().fold(0.0, |largest, (area, _)| f64::max(largest, area.abs()));
        sized.into_iter().filter(|(area, _)| *area > LEAST_SHARE * whole).map(|(_, cell)| cell).collect()
    }

    /// The nodes inside each rope by its two knots, both ways; the first of parallel ropes. A canopy's side has no
    /// nodes inside.
    fn sides(&self) -> BTreeMap<(usize, usize), Vec<usize>> {
        let mut sides = BTreeMap::new();
        let ropes = self.web.ropes.iter().enumerate();
        let is_side = |rope: &Rope| !matches!(rope.class, Class::Traction | Class::Gathering) && rope.a != rope.b;
        for (rope, ends) in ropes.filter(|(_, rope)| is_side(rope)) {
            let interior: Vec<usize> = self.ropes[rope].interior().collect();
            if !sides.contains_key(&(ends.a, ends.b)) {
                sides.insert((ends.b, ends.a), interior.iter().rev().copied().collect());
                sides.insert((ends.a, ends.b), interior);
            }
        }
        for canopy in &self.web.canopies {
            for (place, &corner) in canopy.rim.iter().enumerate() {
                let next = canopy.rim[(place + 1) % canopy.rim.len()];
                sides.entry((corner, next)).or_default();
                sides.entry((next, corner)).or_default();
            }
        }
        sides
    }

    /// The neighbours of each knot, anticlockwise, (knots,).
    fn around(&self, sides: &BTreeMap<(usize, usize), Vec<usize>>) -> Vec<Vec<usize>> {
        let mut around = vec![Vec::new(); self.web.knots.len()];
        for &(knot, neighbour) in sides.keys() {
            around[knot].push(neighbour);
        }
        for (knot, neighbours) in around.iter_mut().enumerate() {
            let angle = |&other: &usize| {
                let arm = self.nodes[other] - self.nodes[knot];
                libm::atan2(arm.y, arm.x)
            };
            neighbours.sort_by(|one, other| angle(one).total_cmp(&angle(other)));
        }
        around
    }

    /// A loop of knots, with the nodes inside the ropes between them.
    fn with_interiors(&self, face: &[usize], sides: &BTreeMap<(usize, usize), Vec<usize>>) -> Vec<usize> {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).flat_map(|(&a, &b)| std::iter::once(a).chain(sides[&(a, b)].iter().copied())).collect()
    }
}

/// The loop of knots round each face, which lies to the left of the walk.
fn faces(around: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let place =
        |knot: usize, neighbour: usize| around[knot].iter().position(|&n| n == neighbour).expect("sides go both ways");
    let mut walked: Vec<Vec<bool>> = around.iter().map(|neighbours| vec![false; neighbours.len()]).collect();
    let mut faces = Vec::new();
    for start in 0..around.len() {
        for first in 0..around[start].len() {
            let mut face = Vec::new();
            let (mut knot, mut out) = (start, first);
            while !walked[knot][out] {
                walked[knot][out] = true;
                face.push(knot);
                let next = around[knot][out];
                let count = around[next].len();
                // the next rope clockwise from the one on which the walk came
                out = (place(next, knot) + count - 1) % count;
                knot = next;
            }
            if !face.is_empty() {
                faces.push(face);
            }
        }
    }
    faces
}

/// Number of connected parts; knots without ropes do not count.
fn components(around: &[Vec<usize>]) -> usize {
    let mut seen = vec![false; around.len()];
    let mut count = 0;
    for start in 0..around.len() {
        if seen[start] || around[start].is_empty() {
            continue;
        }
        count += 1;
        let mut open = vec![start];
        while let Some(knot) = open.pop() {
            if !std::mem::replace(&mut seen[knot], true) {
                open.extend(around[knot].iter().filter(|&&neighbour| !seen[neighbour]));
            }
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::{
        CutWeb, Cutting, Graph, GraphNode, GraphRope, Web, cut, graph, space, square, topological, traditional,
        vector_area,
    };

    fn cut_at(web: &Web, length: f64) -> CutWeb {
        cut(&web.clone().with_traction(1.0, 2).unwrap(), &Cutting::SegmentLength(length)).unwrap()
    }

    fn areas(net: &CutWeb) -> Vec<f64> {
        let area = |cell: Vec<usize>| vector_area(&cell.iter().map(|&n| net.nodes[n]).collect::<Vec<_>>()).z;
        net.cells().into_iter().map(area).collect()
    }

    #[test]
    fn a_square_net_has_its_meshes_as_cells() {
        let net = cut_at(&square(5.0, 0.5).unwrap(), 0.25);
        let areas = areas(&net);
        assert_eq!(areas.len(), 100);
        assert!(areas.iter().all(|area| (area - 0.25).abs() < 1e-12));
        // 4 sides of 2 segments
        assert!(net.cells().iter().all(|cell| cell.len() == 8));
    }

    #[test]
    fn the_cells_of_a_hexagonal_web_tile_its_outline() {
        for (web, plate) in [(traditional(2.5, 6).unwrap(), 0.0), (topological(2.5, 0.14).unwrap(), 0.14)] {
            let net = cut_at(&web, 0.1);
            let total: f64 = areas(&net).iter().sum();
            let outline = web.reference_area().unwrap();
            // the outer of two ropes along the outline lies up to a rope hexagon's inner radius outside it
            let border = 6.0 * 2.5 * plate * 0.75_f64.sqrt();
            assert!(total >= outline - 1e-9 && total <= outline + border + 1e-9, "{total} of {outline}");
        }
    }

    #[test]
    fn the_cells_of_the_space_web_are_triangles_gaps_between_double_ropes_and_canopies() {
        let web = space(2.5, 0.14).unwrap();
        let net = cut_at(&web, 0.1);
        let areas = areas(&net);
        // 54 triangles, 90 gaps between the two ropes of a link, 31 canopies
        assert_eq!(areas.len(), 54 + 90 + 31);
        let canopy = 1.5 * 3.0_f64.sqrt() * 0.14 * 0.14;
        assert_eq!(areas.iter().filter(|area| (**area - canopy).abs() < 1e-9).count(), 31);
    }

    fn small_graph(ropes: &[(usize, usize)]) -> CutWeb {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (2.0, 2.0)];
        let node = |(index, &(x, y)): (usize, &(f64, f64))| GraphNode {
            id: format!("n{index}"),
            position: DVec3::new(x, y, 0.0),
        };
        let rope =
            |&(a, b): &(usize, usize)| GraphRope { a: format!("n{a}"), b: format!("n{b}"), ..GraphRope::default() };
        let web = graph(&Graph {
            nodes: corners.iter().enumerate().map(node).collect(),
            ropes: ropes.iter().map(rope).collect(),
            ..Graph::default()
        })
        .unwrap();
        cut(&web, &Cutting::SegmentLength(0.5)).unwrap()
    }

    #[test]
    fn a_rope_with_a_loose_end_leaves_the_cells_as_they_are() {
        let net = small_graph(&[(0, 1), (1, 2), (2, 3), (3, 0), (2, 4)]);
        assert_eq!(areas(&net), [1.0]);
    }

    #[test]
    fn a_web_with_ropes_that_cross_without_a_knot_has_no_cells() {
        let net = small_graph(&[(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 3), (2, 4)]);
        assert!(net.cells().is_empty());
    }
}

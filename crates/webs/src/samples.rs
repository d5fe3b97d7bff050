//! For tests: one web of every kind.

use std::f64::consts::PI;

use glam::DVec3;

use crate::{
    Diamond, Graph, GraphNode, GraphRope, Radial, Web, diamond, graph, polygon, radial, space, square, topological,
    traditional,
};

/// Draw one web of each kind, about 5 m wide, without tractors.
pub(crate) const SAMPLES: [fn() -> Web; 8] = [
    || traditional(2.5, 6).unwrap(),
    || topological(2.5, 0.14).unwrap(),
    || space(2.5, 0.14).unwrap(),
    || polygon(5, 2.5, 0.4).unwrap(),
    || radial(&Radial { diameter: 5.0, radials: 12, rings: 5, hub_diameter: Some(0.5), corners: 4 }).unwrap(),
    || diamond(&Diamond { mesh: 0.5, hanging_ratio: 0.6, meshes_wide: 8, meshes_high: 5 }).unwrap(),
    || square(3.5, 0.5).and_then(|net| net.with_gathering(7, 0.0)).unwrap(),
    dome,
];

/// A listed net of rings and radials on a dome: it is not flat, and its middle is not the origin.
fn dome() -> Web {
    let (around, rings) = (8, 4);
    let place = |ring: usize, number: usize| {
        let (r, angle) = (0.6 * (ring + 1) as f64, PI / 4.0 * number as f64);
        DVec3::new(3.0 + r * libm::cos(angle), 1.0 + r * libm::sin(angle), 1.0 - 0.2 * r * r)
    };
    let id = |ring: usize, number: usize| format!("{ring}-{}", number % around);
    let all = || (0..rings).flat_map(|ring| (0..around).map(move |number| (ring, number)));
    let nodes = all().map(|(ring, number)| GraphNode { id: id(ring, number), position: place(ring, number) });
    let rope = |a: String, b: String| GraphRope { a, b, ..GraphRope::default() };
    let round = all().map(|(ring, number)| rope(id(ring, number), id(ring, number + 1)));
    let out = all().filter(|&(ring, _)| ring > 0).map(|(ring, number)| rope(id(ring - 1, number), id(ring, number)));
    graph(&Graph {
        nodes: nodes.collect(),
        ropes: round.chain(out).collect(),
        outline: (0..around).map(|number| id(rings - 1, number)).collect(),
        corners: (0..around).step_by(2).map(|number| id(rings - 1, number)).collect(),
        ..Graph::default()
    })
    .unwrap()
}

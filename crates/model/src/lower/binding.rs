//! Nodes that are bound together into one rigid body of the system.
//!
//! Mass m, centre c and inertia I follow from the parts by the parallel-axis theorem. Part i has the mass m_i, its middle
//! at r_i and the inertia I_i about that middle:
//!
//! ```text
//! m = sum m_i,    c = sum m_i r_i / m,    I = sum I_i + m_i (|d|^2 1 - d d*),    d = r_i - c
//! ```
//!
//! The parts lie in the plane of the flat web, and so do two of the principal axes; the angle of the first against the
//! web's x axis has tan 2a = 2 I_xy / (I_xx - I_yy).

use glam::{DMat3, DVec3};
use netcast_dynamics::body::{Body, Tie};
use netcast_webs::CutWeb;

/// A mass with a size, in the plane of the flat web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lump {
    /// Its middle, m.
    pub place: DVec3,
    /// Its mass, kg.
    pub mass: f64,
    /// Its moments of inertia about its middle, along the axes of the web, kg m^2.
    pub inertia: DVec3,
}

/// Nodes of a canopy to be bound together.
#[derive(Debug, Clone, PartialEq)]
pub struct Binding {
    /// The canopy, as an index into the web's.
    pub canopy: usize,
    /// Its name in messages.
    pub label: String,
    /// The nodes; their mass becomes a part of the body.
    pub nodes: Vec<usize>,
    /// The other parts of the body.
    pub lumps: Vec<Lump>,
}

/// A rigid body made of nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Bound {
    /// Its canopy, as an index into the web's.
    pub canopy: usize,
    /// The body of the system; its centre is a node of its own.
    pub body: Body,
    /// Its principal axes in the flat web.
    pub axes: DMat3,
}

/// Relative difference of two moments of inertia below which they count as equal.
const ROUNDING: f64 = 1e-12;

impl Binding {
    /// Makes the body and adds a node at its centre. The `mass` of the bound nodes, kg, moves to that node.
    pub fn bind(self, cut: &mut CutWeb, mass: &mut Vec<f64>) -> Bound {
        let of_node = |&node: &usize| Lump { place: cut.nodes[node], mass: mass[node], inertia: DVec3::ZERO };
        let parts: Vec<Lump> = self.nodes.iter().map(of_node).chain(self.lumps).collect();
        let total: f64 = parts.iter().map(|part| part.mass).sum();
        let centre = parts.iter().map(|part| part.mass * part.place).sum::<DVec3>() / total;
        let (mut inertia, mut product) = (DVec3::ZERO, 0.0);
        for part in &parts {
            let d = part.place - centre;
            inertia += part.inertia + part.mass * (DVec3::splat(d.length_squared()) - d * d);
            product -= part.mass * d.x * d.y;
        }
        let DVec3 { x: xx, y: yy, z: zz } = inertia;
        let (mean, difference) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let radius = (difference * difference + product * product).sqrt();
        // equal moments leave the direction free; rounding would choose differently in equal canopies
        let angle = if radius > ROUNDING * mean { 0.5 * libm::atan2(product, difference) } else { 0.0 };
        let (sin, cos) = libm::sincos(angle);
        let x = DVec3::new(cos, sin, 0.0);
        let axes = DMat3::from_cols(x, DVec3::Z.cross(x), DVec3::Z);

        let tie = |&node: &usize| Tie { node, arm: axes.transpose() * (cut.nodes[node] - centre) };
        let ties = self.nodes.iter().map(tie).collect();
        for &node in &self.nodes {
            mass[node] = 0.0;
        }
        mass.push(total);
        let inertia = DVec3::new(mean + radius, mean - radius, zz);
        let centre = cut.add_node(self.canopy, centre, format!("the centre of {}", self.label));
        Bound { canopy: self.canopy, body: Body { centre, inertia, ties }, axes }
    }
}

#[cfg(test)]
mod tests {
    use netcast_webs::{Cutting, cut, square};

    use super::*;

    fn bound(places: &[(f64, f64, f64)], lumps: Vec<Lump>) -> (Bound, Vec<f64>, CutWeb) {
        let mut net = cut(&square(1.0, 1.0).unwrap(), &Cutting::SegmentLength(1.0)).unwrap();
        let mut mass = vec![1.0; net.nodes.len()];
        let nodes = places.iter().map(|&(x, y, m)| {
            mass.push(m);
            net.add_node(0, DVec3::new(x, y, 0.0), "a node".into())
        });
        let binding = Binding { canopy: 0, label: "it".into(), nodes: nodes.collect(), lumps };
        let bound = binding.bind(&mut net, &mut mass);
        (bound, mass, net)
    }

    #[test]
    fn four_masses_on_a_tilted_rectangle_have_its_inertia_and_axes() {
        // half lengths 0.3 and 0.1, turned so that the long one lies along (0.8, 0.6)
        let corner = |a: f64, b: f64| (1.0 + 0.8 * a - 0.6 * b, 2.0 + 0.6 * a + 0.8 * b, 0.5);
        let (bound, mass, net) =
            bound(&[corner(0.3, 0.1), corner(-0.3, 0.1), corner(-0.3, -0.1), corner(0.3, -0.1)], vec![]);
        let Body { centre, inertia, ties } = &bound.body;
        assert!(net.nodes[*centre].distance(DVec3::new(1.0, 2.0, 0.0)) < 1e-14);
        assert!((mass[*centre] - 2.0).abs() < 1e-14);
        // the larger one first: about the short axis of the rectangle
        assert!(inertia.distance(2.0 * DVec3::new(0.09, 0.01, 0.10)) < 1e-14, "{inertia}");
        assert!((bound.axes.x_axis.dot(DVec3::new(-0.6, 0.8, 0.0)).abs() - 1.0).abs() < 1e-14);
        for tie in ties {
            assert_eq!(mass[tie.node], 0.0);
            assert!((net.nodes[*centre] + bound.axes * tie.arm).distance(net.nodes[tie.node]) < 1e-14);
            assert!((tie.arm.abs() - DVec3::new(0.1, 0.3, 0.0)).length() < 1e-14);
        }
    }

    #[test]
    fn a_lump_off_the_centre_adds_its_own_inertia_and_its_parallel_axis_term() {
        let lump = Lump { place: DVec3::new(0.2, 0.0, 0.0), mass: 3.0, inertia: DVec3::new(0.1, 0.2, 0.3) };
        let (bound, _, net) = bound(&[(-0.2, 0.0, 1.0)], vec![lump]);
        assert!(net.nodes[bound.body.centre].distance(DVec3::new(0.1, 0.0, 0.0)) < 1e-15);
        // 1 kg at 0.3 m, 3 kg at 0.1 m: 0.12 kg m^2 about both axes across; the larger one first
        let expected = DVec3::new(0.2 + 0.12, 0.1, 0.3 + 0.12);
        assert!(bound.body.inertia.distance(expected) < 1e-15, "{}", bound.body.inertia);
    }
}

//! The web: knots, ropes, canopies, corners and feature points.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::{Class, vector_area};

/// A place where ropes are tied: to one another, to a canopy or to a tractor.
#[derive(Debug, Clone, PartialEq)]
pub struct Knot {
    /// Name, unique in the web; in a graph, the id that the user gave.
    pub name: String,
    /// Its name in messages, such as "knot 12" or "corner 3 of canopy 14".
    pub label: String,
    /// Position in the flat web, m.
    pub position: DVec3,
}

impl Knot {
    /// A knot whose label is its name.
    pub(crate) fn new(label: impl Into<String>, position: DVec3) -> Knot {
        let label = label.into();
        Knot { name: label.clone(), label, position }
    }
}

/// A rope from one knot to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Rope {
    /// The knot it begins at, as an index into [`Web::knots`].
    pub a: usize,
    /// The knot it ends at.
    pub b: usize,
    /// Link class that its tension is reported by.
    pub class: Class,
    /// Its name in messages, such as "radial rope 7".
    pub label: String,
    /// Rest length, m; none where it is the distance between the two knots.
    pub rest_length: Option<f64>,
    /// Prescribed number of segments; none where [`crate::Cutting`] decides.
    pub segments: Option<usize>,
}

/// A hexagonal plate: a hub in its centre and six rim knots, anticlockwise from the direction of the x axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Canopy {
    /// The knot in its centre.
    pub hub: usize,
    /// The knots at its corners, to which ropes are tied.
    pub rim: [usize; 6],
    /// Whether a payload is fixed to its hub.
    pub carries_payload: bool,
    /// Its number, from 1.
    pub number: usize,
    /// Whether it is the one in the middle of the web.
    pub is_centre: bool,
}

/// A place on a web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Site {
    /// At a knot.
    Knot(usize),
    /// Along a rope.
    OnRope {
        /// The rope, as an index into [`Web::ropes`].
        rope: usize,
        /// Share of its length from knot `a`: 0 at `a`, 1 at `b`.
        fraction: f64,
    },
}

/// A web as designed: flat, before it is cut, packed or loaded.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Web {
    /// Knots, (knots,).
    pub knots: Vec<Knot>,
    /// Ropes, (ropes,).
    pub ropes: Vec<Rope>,
    /// Hexagonal plates in the order of their numbers.
    pub canopies: Vec<Canopy>,
    /// The closed outline in order; each vertex is the mean of its knots: a canopy's hub, a rope hexagon's six
    /// corners, or one knot.
    pub outline: Vec<Vec<usize>>,
    /// The knots that tractors are tied to.
    pub corners: Vec<usize>,
    /// The knot of each corner's tractor; none before [`Web::with_traction`], the corners where traction
    /// ropes have no length.
    pub tractors: Vec<usize>,
    /// The traction ropes of each corner; none where tractors are tied straight to the corners.
    pub traction: Vec<Vec<usize>>,
    /// The centre of the web is the mean of these knots.
    pub centre: Vec<usize>,
    /// Where the launch axis pierces the flat web, m: the origin; in a graph, the mean of its outline (without one,
    /// of its knots).
    pub middle: DVec3,
    /// Feature points by name; "B" is the bottom of the stowed web.
    pub points: BTreeMap<String, Site>,
}

impl Web {
    /// The knot of this name.
    pub fn knot_named(&self, name: &str) -> Option<usize> {
        self.knots.iter().position(|knot| knot.name == name)
    }

    /// Distance between a rope's two knots in the flat web, m.
    pub fn drawn_length(&self, rope: &Rope) -> f64 {
        self.knots[rope.a].position.distance(self.knots[rope.b].position)
    }

    /// Length of a rope without tension, m: its own where it has one, else as drawn.
    pub fn rest_length(&self, rope: &Rope) -> f64 {
        rope.rest_length.unwrap_or_else(|| self.drawn_length(rope))
    }

    /// Length of the ropes of each class that the web has, m.
    pub fn rope_length_by_class(&self) -> BTreeMap<Class, f64> {
        let mut lengths = BTreeMap::new();
        for rope in &self.ropes {
            *lengths.entry(rope.class.clone()).or_insert(0.0) += self.rest_length(rope);
        }
        lengths
    }

    /// Where a place lies in the flat web, m.
    pub fn position(&self, site: Site) -> DVec3 {
        match site {
            Site::Knot(knot) => self.knots[knot].position,
            Site::OnRope { rope, fraction } => {
                let rope = &self.ropes[rope];
                self.knots[rope.a].position.lerp(self.knots[rope.b].position, fraction)
            }
        }
    }

    /// The mean position of some knots in the flat web, m.
    pub fn mean_position(&self, knots: &[usize]) -> DVec3 {
        knots.iter().map(|&knot| self.knots[knot].position).sum::<DVec3>() / knots.len() as f64
    }

    /// Area that the flat web's outline encloses, m^2: the magnitude of its vector area; none where the web has no
    /// outline.
    pub fn reference_area(&self) -> Option<f64> {
        let vertices: Vec<DVec3> = self.outline.iter().map(|knots| self.mean_position(knots)).collect();
        (vertices.len() >= 3).then(|| vector_area(&vertices).length())
    }

    /// Area of the polygon of the tractors of the flat web, m^2; none with fewer than three.
    pub fn tractor_area(&self) -> Option<f64> {
        let ring: Vec<DVec3> = self.tractor_ring().iter().map(|&knot| self.knots[knot].position).collect();
        (ring.len() >= 3).then(|| vector_area(&ring).length())
    }

    /// The tractors' knots in the order in which they stand round the middle,
    /// anticlockwise from the first: their polygon is then simple even where a user named the corners in another
    /// order.
    pub fn tractor_ring(&self) -> Vec<usize> {
        let angle = |knot: usize| {
            let arm = self.knots[knot].position - self.middle;
            libm::atan2(arm.y, arm.x)
        };
        let mut ring = self.tractors.clone();
        ring.sort_by(|&one, &other| angle(one).total_cmp(&angle(other)));
        if let Some(first) = ring.iter().position(|knot| self.tractors.first() == Some(knot)) {
            ring.rotate_left(first);
        }
        ring
    }

    /// Distance from the middle, in the web's plane, of the farthest knot, m; tractors on traction ropes are not
    /// counted.
    pub fn radius(&self) -> f64 {
        let on_traction_ropes = |knot: &usize| !self.traction.is_empty() && self.tractors.contains(knot);
        (0..self.knots.len())
            .filter(|knot| !on_traction_ropes(knot))
            .map(|knot| (self.knots[knot].position - self.middle).truncate().length())
            .fold(0.0, f64::max)
    }
}

//! The web: knots, ropes, canopies, corners and feature points.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::{Class, vector_area};

/// A place where ropes are tied: to one another, to a canopy or to a tractor.
#[derive(Debug, Clone, PartialEq)]
pub struct Knot {
    /// Name, unique in the web; in a graph, the id that the user gave.
    pub name: String,
    /// Name in messages, such as "knot 12" or "corner 3 of canopy 14".
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
    /// Knot at its beginning, as an index into [`Web::knots`].
    pub a: usize,
    /// Knot at its end, as an index into [`Web::knots`].
    pub b: usize,
    /// Link class under which its tension is reported.
    pub class: Class,
    /// Name in messages, such as "radial rope 7".
    pub label: String,
    /// Rest length, m; none: the distance between its two knots.
    pub rest_length: Option<f64>,
    /// Number of segments; none: [`crate::Cutting`] decides.
    pub segments: Option<usize>,
}

/// A hexagonal plate: a hub in its centre and six rim knots, anticlockwise from the direction of the x axis.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Canopy {
    /// The knot in the centre.
    pub hub: usize,
    /// The knots at its corners, to which ropes are tied.
    pub rim: [usize; 6],
    /// Whether a payload is fixed to its hub.
    pub carries_payload: bool,
    /// Its number, from 1.
    pub number: usize,
    /// Whether it stands in the centre of the web.
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
    /// All knots, (knots,).
    pub knots: Vec<Knot>,
    /// All ropes, (ropes,).
    pub ropes: Vec<Rope>,
    /// Hexagonal plates in the order of their numbers.
    pub canopies: Vec<Canopy>,
    /// Vertices of the closed outline in order, (vertices,). A vertex lies at the mean of its knots: a canopy's hub, a
    /// rope hexagon's six corners, or one knot.
    pub outline: Vec<Vec<usize>>,
    /// Knots for tractors, (corners,).
    pub corners: Vec<usize>,
    /// The knot of each corner's tractor, (corners,); empty before [`Web::with_traction`]. Without traction ropes these
    /// are the corners themselves.
    pub tractors: Vec<usize>,
    /// Traction ropes of each corner, (corners,); empty where tractors are tied straight to the corners.
    pub traction: Vec<Vec<usize>>,
    /// Knots whose mean is the centre of the web.
    pub centre: Vec<usize>,
    /// Where the launch axis pierces the flat web, m: the origin; in a graph, the mean of its outline or, without an
    /// outline, of its knots.
    pub middle: DVec3,
    /// Feature points by name; "B" is the bottom of the stowed web.
    pub points: BTreeMap<String, Site>,
}

impl Web {
    /// The knot with this name.
    pub fn knot_named(&self, name: &str) -> Option<usize> {
        self.knots.iter().position(|knot| knot.name == name)
    }

    /// Distance between a rope's two knots in the flat web, m.
    pub fn drawn_length(&self, rope: &Rope) -> f64 {
        self.knots[rope.a].position.distance(self.knots[rope.b].position)
    }

    /// Rest length of a rope, m: its own if it has one, else its length as drawn.
    pub fn rest_length(&self, rope: &Rope) -> f64 {
        rope.rest_length.unwrap_or_else(|| self.drawn_length(rope))
    }

    /// Total rest length of the ropes in each class, m; classes without ropes are left out.
    pub fn rope_length_by_class(&self) -> BTreeMap<Class, f64> {
        let mut lengths = BTreeMap::new();
        for rope in &self.ropes {
            *lengths.entry(rope.class.clone()).or_insert(0.0) += self.rest_length(rope);
        }
        lengths
    }

    /// Position of a site in the flat web, m.
    pub fn position(&self, site: Site) -> DVec3 {
        match site {
            Site::Knot(knot) => self.knots[knot].position,
            Site::OnRope { rope, fraction } => {
                let rope = &self.ropes[rope];
                self.knots[rope.a].position.lerp(self.knots[rope.b].position, fraction)
            }
        }
    }

    /// Mean position of these knots in the flat web, m.
    pub fn mean_position(&self, knots: &[usize]) -> DVec3 {
        knots.iter().map(|&knot| self.knots[knot].position).sum::<DVec3>() / knots.len() as f64
    }

    /// Area inside the flat web's outline, m^2: the magnitude of its vector area; none without an outline.
    pub fn reference_area(&self) -> Option<f64> {
        let vertices: Vec<DVec3> = self.outline.iter().map(|knots| self.mean_position(knots)).collect();
        (vertices.len() >= 3).then(|| vector_area(&vertices).length())
    }

    /// Area of the polygon of tractors about the flat web, m^2; none with fewer than three tractors.
    pub fn tractor_area(&self) -> Option<f64> {
        let ring: Vec<DVec3> = self.tractor_ring().iter().map(|&knot| self.knots[knot].position).collect();
        (ring.len() >= 3).then(|| vector_area(&ring).length())
    }

    /// The tractors' knots anticlockwise round the middle, beginning with the first tractor. In this order their
    /// polygon does not cross itself, in whatever order a user named the corners.
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

    /// Distance from the middle to the farthest knot in the web's plane, m; tractors on traction ropes do not count.
    pub fn radius(&self) -> f64 {
        let on_traction_ropes = |knot: &usize| !self.traction.is_empty() && self.tractors.contains(knot);
        (0..self.knots.len())
            .filter(|knot| !on_traction_ropes(knot))
            .map(|knot| (self.knots[knot].position - self.middle).truncate().length())
            .fold(0.0, f64::max)
    }

    /// How far the web reaches in any direction, m: the largest distance of a knot from the middle, or half of its longest
    /// rope where that is more. Traction ropes and their tractors are left out.
    pub fn reach(&self) -> f64 {
        let is_traction = |rope: &&Rope| rope.class == Class::Traction;
        let halves = self.ropes.iter().filter(|rope| !is_traction(rope)).map(|rope| 0.5 * self.rest_length(rope));
        let on_traction_ropes = |knot: &usize| !self.traction.is_empty() && self.tractors.contains(knot);
        let knots = (0..self.knots.len()).filter(|knot| !on_traction_ropes(knot));
        knots.map(|knot| self.knots[knot].position.distance(self.middle)).chain(halves).fold(0.0, f64::max)
    }
}

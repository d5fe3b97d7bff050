//! What of a system has a meaning: the launch axis, the outline, corners, tractors, feature points, link classes.
//!
//! The system itself knows nodes and segments by number only. Who makes the system says here what they are.

use glam::DVec3;

use crate::measures::{mean, vector_area};

/// What is followed under one name: a point, or a group of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Landmark {
    /// Its name in the results, such as "B" or "tractor".
    pub name: String,
    /// The nodes whose mean it is; not empty.
    pub nodes: Vec<usize>,
    /// Whether its nodes are points of their own, as tractors are. The speed of a group is the mean of its speeds;
    /// that of a point is the speed of its mean.
    pub is_group: bool,
    /// The segments of rope that meet there.
    pub segments: Vec<usize>,
}

impl Landmark {
    /// Its speed, m/s.
    pub fn speed(&self, velocity: impl Fn(usize) -> DVec3) -> f64 {
        if self.is_group {
            self.nodes.iter().map(|&n| velocity(n).length()).sum::<f64>() / self.nodes.len() as f64
        } else {
            mean(&self.nodes, velocity).length()
        }
    }
}

/// A link class.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkClass {
    /// Its name in the results.
    pub name: String,
    /// Whether it is made of ropes; canopy members are not, and do not count for the largest tension.
    pub is_rope: bool,
    /// Strength of its weakest rope, N, where one is given.
    pub strength: Option<f64>,
}

/// The meanings of a system's nodes and segments.
#[derive(Debug, Clone, PartialEq)]
pub struct Landmarks {
    /// The launch axis, a unit vector in the world frame.
    pub axis: DVec3,
    /// The closed outline; each vertex the mean of its nodes. Empty where there is none.
    pub outline: Vec<Vec<usize>>,
    /// Area of the outline of the flat web along the axis, m^2.
    pub reference_area: Option<f64>,
    /// How far the middle of the flat web lies above its outline along the axis, m; zero for a plane web.
    pub flat_posture: f64,
    /// The tractors, in order around the web.
    pub tractors: Vec<usize>,
    /// The web's centre is the mean of these nodes.
    pub centre: Vec<usize>,
    /// Feature points, then tractor, corner and centre, each where it exists.
    pub points: Vec<Landmark>,
    /// The segments of rope that meet the bottom, point B.
    pub bottom: Vec<usize>,
    /// Link classes, in the order of the system's class numbers.
    pub classes: Vec<LinkClass>,
}

impl Landmarks {
    /// Vector area of the outline, m^2; none where there is no outline.
    pub fn outline_area(&self, position: impl Fn(usize) -> DVec3) -> Option<DVec3> {
        let vertices = self.outline.iter().map(|nodes| mean(nodes, &position));
        (!self.outline.is_empty()).then(|| vector_area(vertices))
    }

    /// Area of the tractors' polygon along the axis, m^2; none where they make none.
    pub fn tractor_area(&self, position: impl Fn(usize) -> DVec3) -> Option<f64> {
        let vertices = self.tractors.iter().map(|&node| position(node));
        (self.tractors.len() >= 3).then(|| vector_area(vertices).dot(self.axis).abs())
    }
}

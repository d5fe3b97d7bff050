//! Names of the parts of a system: launch axis, outline, corners, tractors, feature points, link classes.
//!
//! The system has only numbers of nodes and segments. The builder of the system names them here, and
//! `landmarks.json` keeps the names beside the fields.

use std::fs;
use std::path::Path;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::geometry::{mean, vector_area};
use crate::{ResultError, json};

/// A named point of the results, or a named group of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Landmark {
    /// Name in the results, such as "B" or "tractor".
    pub name: String,
    /// The nodes; the position is their mean. Not empty.
    pub nodes: Vec<usize>,
    /// Whether the nodes are points of their own, such as tractors. The speed of a group is the mean of the speeds of
    /// its nodes; the speed of a point is the speed of the mean of its nodes.
    pub is_group: bool,
    /// The rope segments that meet at its nodes.
    pub segments: Vec<usize>,
}

impl Landmark {
    /// Speed, m/s; `velocity` gives the velocity of a node, m/s.
    pub fn speed(&self, velocity: impl Fn(usize) -> DVec3) -> f64 {
        if self.is_group {
            self.nodes.iter().map(|&n| velocity(n).length()).sum::<f64>() / self.nodes.len() as f64
        } else {
            mean(&self.nodes, velocity).length()
        }
    }
}

/// A node that is held or driven, or all of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Support {
    /// Name in the results.
    pub name: String,
    /// The nodes, of which the reaction is the sum.
    pub nodes: Vec<usize>,
}

/// A link class: what tensions are reported by.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LinkClass {
    /// Name in the results.
    pub name: String,
    /// Whether it is made of ropes. Canopy members are not ropes and do not count for the largest tension.
    pub is_rope: bool,
    /// Strength of its weakest rope, N, where the scenario gives one.
    #[serde(rename = "strength_n")]
    pub strength: Option<f64>,
}

/// A kind of rope by the name that the scenario gives it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NamedRope {
    /// `rope` for the default rope, else the name of its table.
    pub name: String,
    /// Breaking load, N, where it is given.
    #[serde(rename = "strength_n")]
    pub strength: Option<f64>,
    /// Share of the strength that is lost at knots, where the scenario gives one.
    pub knot_reduction: Option<f64>,
}

/// Segments of one link class that are made of one kind of rope.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Index into [`Landmarks::classes`].
    pub class: usize,
    /// Index into [`Landmarks::ropes`]; none for members that are not ropes.
    pub rope: Option<usize>,
}

/// A canopy, to be drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CanopyMark {
    /// The node at its middle.
    pub hub: usize,
    /// The nodes at its corners, in order.
    pub rim: Vec<usize>,
    /// Its triangles if it is a sheet, else empty. Shape (triangles, 3).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub triangles: Vec<[usize; 3]>,
}

impl CanopyMark {
    /// Closed loops of nodes to draw: the triangles of a sheet, else the rim.
    pub fn loops(&self) -> Vec<&[usize]> {
        if self.triangles.is_empty() {
            vec![&self.rim]
        } else {
            self.triangles.iter().map(|triangle| &triangle[..]).collect()
        }
    }

    /// Triangles to fill: those of a sheet, else those between hub and rim. Shape (triangles, 3).
    pub fn faces(&self) -> Vec<[usize; 3]> {
        let Self { hub, rim, triangles } = self;
        if triangles.is_empty() {
            (0..rim.len()).map(|k| [*hub, rim[k], rim[(k + 1) % rim.len()]]).collect()
        } else {
            triangles.clone()
        }
    }
}

/// The purpose of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyKind {
    /// Tractor: pulls the web out.
    Tractor,
    /// Payload: is carried by the web.
    Payload,
    /// Sensor: sits in the middle of the web.
    Sensor,
}

/// A body that the web carries, to be drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BodyMark {
    /// Purpose.
    pub kind: BodyKind,
    /// The node on which it sits.
    pub node: usize,
    /// Shape and size.
    pub shape: BodyShape,
    /// Index of the system's rigid body, whose orientation the fields hold; none for a mass on a node, which is drawn
    /// along the launch axis.
    pub rigid: Option<usize>,
}

/// Shape and size of a body; its height is along its own z axis.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyShape {
    /// A cylinder.
    Cylinder {
        /// Diameter, m.
        diameter_m: f64,
        /// Height, m.
        height_m: f64,
    },
    /// A sphere.
    Sphere {
        /// Diameter, m.
        diameter_m: f64,
    },
    /// A box.
    Box {
        /// Size along its axes x, y, z, m.
        size_m: [f64; 3],
    },
    /// A point without size.
    Particle,
}

impl BodyShape {
    /// Size along its own axes x, y, z, m; 0 for a particle.
    pub fn size_m(&self) -> [f64; 3] {
        match *self {
            Self::Cylinder { diameter_m, height_m } => [diameter_m, diameter_m, height_m],
            Self::Sphere { diameter_m } => [diameter_m; 3],
            Self::Box { size_m } => size_m,
            Self::Particle => [0.0; 3],
        }
    }
}

/// Names of a system's nodes and segments.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Landmarks {
    /// The launch axis, a unit vector in the world frame.
    pub axis: DVec3,
    /// Height of the ground, m; none without a ground.
    #[serde(default, rename = "ground_m")]
    pub ground: Option<f64>,
    /// The closed outline: the nodes of each vertex, which lies at their mean. Empty without an outline.
    pub outline: Vec<Vec<usize>>,
    /// Area inside the outline of the flat web, seen along the axis, m^2.
    #[serde(rename = "reference_area_m2")]
    pub reference_area: Option<f64>,
    /// Distance by which the middle of the flat web leads its outline along the axis, m; zero for a plane web.
    #[serde(rename = "flat_posture_m")]
    pub flat_posture: f64,
    /// The nodes of the corners, where tractors are tied.
    pub corners: Vec<usize>,
    /// The points that measure the symmetry of the mouth: the corners, or without corners the vertices of the outline.
    /// Each lies at the mean of its nodes.
    pub mouth: Vec<Vec<usize>>,
    /// Distance of each point of `mouth` from the mean of these points in the flat web, m. Shape (points of the mouth,).
    #[serde(rename = "mouth_reach_m")]
    pub mouth_reach: Vec<f64>,
    /// The cells of the web: closed loops of nodes. Empty for a web whose ropes cross when it is drawn in a plane.
    pub cells: Vec<Vec<usize>>,
    /// Diameter of the target, m, where the scenario gives one.
    #[serde(rename = "target_diameter_m")]
    pub target_diameter: Option<f64>,
    /// The nodes of the tractors, in order around the web.
    pub tractors: Vec<usize>,
    /// The nodes whose mean is the web's centre.
    pub centre: Vec<usize>,
    /// Feature points, then tractor, corner and centre, each where it exists.
    pub points: Vec<Landmark>,
    /// What is held or driven: all of it, `supports`, then node by node where these are few. Empty where nothing is.
    #[serde(default)]
    pub supports: Vec<Support>,
    /// The rope segments that meet at the bottom, point B.
    pub bottom: Vec<usize>,
    /// Link classes.
    pub classes: Vec<LinkClass>,
    /// Kinds of rope.
    pub ropes: Vec<NamedRope>,
    /// Link class and rope of each group of the system, in the order of the groups. Shape (groups,).
    pub groups: Vec<Group>,
    /// Canopies, to be drawn.
    pub canopies: Vec<CanopyMark>,
    /// Strength of the cloth of the canopies, Pa, where the scenario gives one.
    #[serde(default, rename = "cloth_strength_pa")]
    pub cloth_strength: Option<f64>,
    /// Tractors, payloads and sensors, to be drawn.
    pub bodies: Vec<BodyMark>,
}

impl Landmarks {
    /// Names of points that every summary has, also for a web without such a point.
    pub const ALWAYS_NAMED: [&str; 7] = ["A", "B", "C", "D", "tractor", "corner", "centre"];

    /// Writes them to `path`.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn write(&self, path: &Path) -> Result<(), ResultError> {
        let text = serde_json::to_string(self).expect("plain data") + "\n";
        fs::write(path, text).map_err(ResultError::write(path))
    }

    /// Reads them from `path`.
    ///
    /// # Errors
    /// [`ResultError::Read`], or [`ResultError::Json`] with line, column and key.
    pub fn read(path: &Path) -> Result<Self, ResultError> {
        json::read(path)
    }

    /// Every node that has a name; a node may occur several times.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let groups = self.outline.iter().chain(&self.mouth).chain(&self.cells).chain([&self.corners, &self.centre]);
        let points = self.points.iter().flat_map(|point| &point.nodes);
        let canopies = self.canopies.iter().flat_map(|canopy| canopy.rim.iter().chain([&canopy.hub]));
        let sheets = self.canopies.iter().flat_map(|canopy| &canopy.triangles).flatten();
        let bodies = self.bodies.iter().map(|body| &body.node);
        let supports = self.supports.iter().flat_map(|support| &support.nodes);
        groups
            .flatten()
            .chain(&self.tractors)
            .chain(points)
            .chain(canopies)
            .chain(sheets)
            .chain(bodies)
            .chain(supports)
            .copied()
    }

    /// Vector area of the outline, m^2; none without an outline. `position` gives the position of a node, m.
    pub fn outline_area(&self, position: impl Fn(usize) -> DVec3) -> Option<DVec3> {
        let vertices = self.outline.iter().map(|nodes| mean(nodes, &position));
        (!self.outline.is_empty()).then(|| vector_area(vertices))
    }

    /// Vector area of the outline, m^2, and mean of its vertices, m. The outline must not be empty.
    pub fn outline_area_and_middle(&self, position: impl Fn(usize) -> DVec3) -> (DVec3, DVec3) {
        let mut sum = DVec3::ZERO;
        let vertices = self.outline.iter().map(|nodes| mean(nodes, &position)).inspect(|vertex| sum += *vertex);
        let area = vector_area(vertices);
        (area, sum / self.outline.len() as f64)
    }

    /// Distance by which the middle leads the outline along the axis, less that of the flat web, over the square root of
    /// the reference area; none without an outline.
    pub fn posture(&self, position: impl Fn(usize) -> DVec3) -> Option<f64> {
        let (_, rim) = (!self.outline.is_empty()).then(|| self.outline_area_and_middle(&position))?;
        self.posture_of(rim, mean(&self.centre, position))
    }

    /// The same by the mean of the outline's vertices, `rim`, and the place of the middle, m.
    pub fn posture_of(&self, rim: DVec3, middle: DVec3) -> Option<f64> {
        let size = self.reference_area?.sqrt();
        let lead = (middle - rim).dot(self.axis) - self.flat_posture;
        (size > 0.0).then(|| lead / size)
    }

    /// Area of the tractors' polygon along the axis, m^2; none where they make none.
    pub fn tractor_area(&self, position: impl Fn(usize) -> DVec3) -> Option<f64> {
        let vertices = self.tractors.iter().map(|&node| position(node));
        (self.tractors.len() >= 3).then(|| vector_area(vertices).dot(self.axis).abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn landmarks_read_back_equal() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("landmarks.json");
        let landmarks = Landmarks {
            axis: DVec3::new(0.6, 0.0, 0.8),
            outline: vec![vec![0], vec![1, 2]],
            reference_area: Some(1.0 / 3.0),
            mouth: vec![vec![0], vec![1]],
            mouth_reach: vec![0.1 + 0.2, 2.0],
            groups: vec![Group { class: 0, rope: None }, Group { class: 1, rope: Some(0) }],
            ropes: vec![NamedRope { name: "rope".into(), strength: Some(1e4), knot_reduction: None }],
            bodies: vec![BodyMark {
                kind: BodyKind::Tractor,
                node: 3,
                shape: BodyShape::Cylinder { diameter_m: 0.1, height_m: 0.2 },
                rigid: None,
            }],
            ..Landmarks::default()
        };
        landmarks.write(&path).unwrap();
        assert_eq!(Landmarks::read(&path).unwrap(), landmarks);
    }
}

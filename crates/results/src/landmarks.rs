//! What of a system has a meaning: the launch axis, the outline, corners, tractors, feature points, link classes.
//!
//! The system itself knows nodes and segments by number only. Who makes the system says here what they are.
//! `landmarks.json` keeps it beside the fields, whose numbers it explains.

use std::fs;
use std::path::Path;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::geometry::{mean, vector_area};
use crate::{ResultError, json};

/// What is followed under one name: a point, or a group of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LinkClass {
    /// Its name in the results.
    pub name: String,
    /// Whether it is made of ropes; canopy members are not, and do not count for the largest tension.
    pub is_rope: bool,
    /// Strength of its weakest rope, N, where one is given.
    #[serde(rename = "strength_n")]
    pub strength: Option<f64>,
}

/// A kind of rope by the name that the scenario gives it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NamedRope {
    /// `rope` for the default one, else the name of its table.
    pub name: String,
    /// Breaking load, N, where it is given.
    #[serde(rename = "strength_n")]
    pub strength: Option<f64>,
    /// The share of its strength that knots take from it, where it is given.
    pub knot_reduction: Option<f64>,
}

/// Segments of one link class that are made of one kind of rope: what the system has as a class.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Index into [`Landmarks::classes`].
    pub class: usize,
    /// Index into [`Landmarks::ropes`]; none for members that are no ropes.
    pub rope: Option<usize>,
}

/// A canopy, to be drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CanopyMark {
    /// The node in its middle.
    pub hub: usize,
    /// The nodes at its corners, in order.
    pub rim: Vec<usize>,
    /// Its triangles, where it is a sheet.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub triangles: Vec<[usize; 3]>,
}

impl CanopyMark {
    /// What to draw of it, as closed loops of nodes: its triangles, or else its rim.
    pub fn loops(&self) -> Vec<&[usize]> {
        if self.triangles.is_empty() {
            vec![&self.rim]
        } else {
            self.triangles.iter().map(|triangle| &triangle[..]).collect()
        }
    }

    /// What to fill of it: its triangles, or else those between its hub and its rim.
    pub fn faces(&self) -> Vec<[usize; 3]> {
        let Self { hub, rim, triangles } = self;
        if triangles.is_empty() {
            (0..rim.len()).map(|k| [*hub, rim[k], rim[(k + 1) % rim.len()]]).collect()
        } else {
            triangles.clone()
        }
    }
}

/// What a body is there for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyKind {
    /// Pulls the web out.
    Tractor,
    /// Is carried.
    Payload,
    /// Sits in the middle.
    Sensor,
}

/// A body that the web carries, to be drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BodyMark {
    /// What it is there for.
    pub kind: BodyKind,
    /// The node that it sits on.
    pub node: usize,
    /// What it fills.
    pub shape: BodyShape,
    /// Which of the system's rigid bodies it is, whose orientations the fields have; none for a mass on a node, which is
    /// drawn along the launch axis.
    pub rigid: Option<usize>,
}

/// What a body fills; its height is along its z axis.
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
    /// Nothing.
    Particle,
}

impl BodyShape {
    /// Its size along its axes x, y, z, m; 0 for a particle.
    pub fn size_m(&self) -> [f64; 3] {
        match *self {
            Self::Cylinder { diameter_m, height_m } => [diameter_m, diameter_m, height_m],
            Self::Sphere { diameter_m } => [diameter_m; 3],
            Self::Box { size_m } => size_m,
            Self::Particle => [0.0; 3],
        }
    }
}

/// The meanings of a system's nodes and segments.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Landmarks {
    /// The launch axis, a unit vector in the world frame.
    pub axis: DVec3,
    /// Height of the ground, m; none where there is none.
    #[serde(default, rename = "ground_m")]
    pub ground: Option<f64>,
    /// The closed outline; each vertex the mean of its nodes. Empty where there is none.
    pub outline: Vec<Vec<usize>>,
    /// Area of the outline of the flat web along the axis, m^2.
    #[serde(rename = "reference_area_m2")]
    pub reference_area: Option<f64>,
    /// How far the middle of the flat web lies above its outline along the axis, m; zero for a plane web.
    #[serde(rename = "flat_posture_m")]
    pub flat_posture: f64,
    /// The corners of the web, where tractors are tied.
    pub corners: Vec<usize>,
    /// The points by which the symmetry of the mouth is judged: its corners, or without corners the vertices of its
    /// outline; each the mean of its nodes.
    pub mouth: Vec<Vec<usize>>,
    /// The distance of each of these from their mean in the flat web, m.
    #[serde(rename = "mouth_reach_m")]
    pub mouth_reach: Vec<f64>,
    /// The cells of the web: closed loops of nodes. Empty where the web cannot be drawn in a plane without crossings.
    pub cells: Vec<Vec<usize>>,
    /// Diameter of the target that the web is measured against, m, where one is stated.
    #[serde(rename = "target_diameter_m")]
    pub target_diameter: Option<f64>,
    /// The tractors, in order around the web.
    pub tractors: Vec<usize>,
    /// The web's centre is the mean of these nodes.
    pub centre: Vec<usize>,
    /// Feature points, then tractor, corner and centre, each where it exists.
    pub points: Vec<Landmark>,
    /// The segments of rope that meet the bottom, point B.
    pub bottom: Vec<usize>,
    /// Link classes.
    pub classes: Vec<LinkClass>,
    /// Kinds of rope.
    pub ropes: Vec<NamedRope>,
    /// Class and rope of the system's class numbers, in their order.
    pub groups: Vec<Group>,
    /// Canopies, to be drawn.
    pub canopies: Vec<CanopyMark>,
    /// What the cloth of canopies that are sheets bears, Pa, where it is given.
    #[serde(default, rename = "cloth_strength_pa")]
    pub cloth_strength: Option<f64>,
    /// Tractors, payloads and sensors, to be drawn.
    pub bodies: Vec<BodyMark>,
}

impl Landmarks {
    /// Names under which a summary has a point, whether the web has it or not.
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

    /// Every node that is named, one or more times.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let groups = self.outline.iter().chain(&self.mouth).chain(&self.cells).chain([&self.corners, &self.centre]);
        let points = self.points.iter().flat_map(|point| &point.nodes);
        let canopies = self.canopies.iter().flat_map(|canopy| canopy.rim.iter().chain([&canopy.hub]));
        let sheets = self.canopies.iter().flat_map(|canopy| &canopy.triangles).flatten();
        let bodies = self.bodies.iter().map(|body| &body.node);
        groups.flatten().chain(&self.tractors).chain(points).chain(canopies).chain(sheets).chain(bodies).copied()
    }

    /// Vector area of the outline, m^2; none where there is no outline.
    pub fn outline_area(&self, position: impl Fn(usize) -> DVec3) -> Option<DVec3> {
        let vertices = self.outline.iter().map(|nodes| mean(nodes, &position));
        (!self.outline.is_empty()).then(|| vector_area(vertices))
    }

    /// Vector area of the outline, m^2, and the mean of its vertices, m; there must be an outline.
    pub fn outline_area_and_middle(&self, position: impl Fn(usize) -> DVec3) -> (DVec3, DVec3) {
        let mut sum = DVec3::ZERO;
        let vertices = self.outline.iter().map(|nodes| mean(nodes, &position)).inspect(|vertex| sum += *vertex);
        let area = vector_area(vertices);
        (area, sum / self.outline.len() as f64)
    }

    /// How far the middle leads the outline along the axis, over the square root of the reference area, both from the
    /// flat web; none where there is no outline.
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
    fn what_is_written_reads_back_equal() {
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

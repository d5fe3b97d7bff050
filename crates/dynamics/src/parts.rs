//! The parts of a system as plain data: nodes, segments, effects and surroundings.

use glam::DVec3;

use crate::air::Air;
use crate::body::Body;
use crate::custom::CustomEffect;
use crate::drive::Drive;
use crate::forces::bending::{Bending, Clamp};
use crate::forces::ground::Ground;
use crate::forces::hinge::Hinge;
use crate::forces::law::Law;
use crate::forces::load::Load;
use crate::forces::membrane::Membrane;
use crate::forces::orbit::Orbit;
use crate::forces::segment::Segment;
use crate::launcher::Launcher;

/// Surroundings of the net: gravity, damping, air, ground, orbit.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Environment {
    /// Acceleration of gravity, m/s^2, as a vector in the world frame.
    pub gravity: DVec3,
    /// Mass-proportional damping, 1/s: a force -damping * m * v on every node.
    pub mass_damping: f64,
    /// Air, or another medium, that drags at the net.
    pub air: Option<Air>,
    /// Ground that the net can land on.
    pub ground: Option<Ground>,
    /// Circular orbit beside which the net flies.
    pub orbit: Option<Orbit>,
}

/// Plain data from which a [`System`](crate::system::System) is built; [`SystemParts::build`] checks it.
#[derive(Debug, Clone, Default)]
pub struct SystemParts {
    /// Mass of each node, kg; shape (nodes,). A tie of a rigid body has none.
    pub mass: Vec<f64>,
    /// Whether a node stays where it is; shape (nodes,).
    pub held: Vec<bool>,
    /// Whether a node is a tractor, whose kinetic energy is kept apart from the web's; shape (nodes,).
    pub tractor: Vec<bool>,
    /// Segments; those of one rope in order, one after the other, so that they can be laid out as one run.
    pub segments: Vec<Segment>,
    /// The law of each group, (groups,).
    pub laws: Vec<Law>,
    /// Where ropes resist bending.
    pub bends: Vec<Bending>,
    /// Ends at which ropes that resist bending keep their direction.
    pub clamps: Vec<Clamp>,
    /// Triangles of sheets.
    pub membranes: Vec<Membrane>,
    /// Where sheets resist bending.
    pub hinges: Vec<Hinge>,
    /// Constant forces.
    pub loads: Vec<Load>,
    /// Rigid bodies.
    pub bodies: Vec<Body>,
    /// Nodes that are moved along paths; they are held as well. The centre of a body must be that of its mass.
    pub drives: Vec<Drive>,
    /// Launchers, which hold nodes and throw them.
    pub launchers: Vec<Launcher>,
    /// Effects of the caller's own.
    pub custom: Vec<Box<dyn CustomEffect>>,
    /// Surroundings.
    pub environment: Environment,
}

/// Why a system cannot be simulated.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// There is nothing to simulate.
    #[error("the system has no nodes")]
    Empty,
    /// Arrays that describe the nodes differ in length.
    #[error("{what} is given for {found} nodes, masses for {expected}")]
    Shape {
        /// Which array.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The number of nodes.
        expected: usize,
    },
    /// A node that can move has no mass, or a mass that is not a number.
    #[error("node {node} has a mass of {mass} kg; a node that is free to move needs a positive one")]
    Mass {
        /// Which node.
        node: usize,
        /// Its mass, kg.
        mass: f64,
    },
    /// A segment joins a node to itself or to one that does not exist.
    #[error("segment {segment} joins nodes {} and {}; there are {nodes} nodes", ends[0], ends[1])]
    Ends {
        /// Which segment.
        segment: usize,
        /// Its ends.
        ends: [usize; 2],
        /// The number of nodes.
        nodes: usize,
    },
    /// A property of a segment is out of range.
    #[error("segment {segment} has a {what} of {value}")]
    Property {
        /// Which segment.
        segment: usize,
        /// Which property.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A parameter of a group's law is out of range.
    #[error("the law of group {group} has a {what} of {value}")]
    Law {
        /// Which group.
        group: usize,
        /// Which parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A part of the system names a node that it cannot have.
    #[error("{part} {index} has node {node}, which {why}")]
    Attached {
        /// The kind of part, and so the list in which `index` counts.
        part: PartKind,
        /// Index of the part in its list.
        index: usize,
        /// The node; of a [`PartKind::Hull`], the body.
        node: usize,
        /// What is wrong with it.
        why: &'static str,
    },
    /// Something that surrounds the net is out of range.
    #[error("the environment's {what} is {value}")]
    Environment {
        /// Which property.
        what: &'static str,
        /// Its value.
        value: f64,
    },
}

/// A kind of part that names nodes, by the list in which such parts stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartKind {
    /// [`SystemParts::bends`].
    Bend,
    /// [`SystemParts::clamps`].
    Clamp,
    /// [`SystemParts::membranes`].
    Membrane,
    /// [`SystemParts::hinges`].
    Hinge,
    /// [`SystemParts::loads`].
    Load,
    /// [`SystemParts::bodies`].
    Body,
    /// [`SystemParts::drives`].
    Drive,
    /// [`SystemParts::launchers`].
    Launcher,
    /// [`SystemParts::custom`].
    Custom,
    /// [`Ground::nodes`].
    Footing,
    /// [`Ground::hulls`].
    Hull,
    /// [`Air::sheets`].
    SheetDrag,
    /// [`Air::bodies`].
    BodyDrag,
}

impl std::fmt::Display for PartKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            PartKind::Bend => "bend",
            PartKind::Clamp => "clamp",
            PartKind::Membrane => "triangle of a sheet",
            PartKind::Hinge => "hinge",
            PartKind::Load => "load",
            PartKind::Body => "body",
            PartKind::Drive => "drive",
            PartKind::Launcher => "launcher",
            PartKind::Custom => "custom effect",
            PartKind::Footing | PartKind::Hull => "contact of the ground",
            PartKind::SheetDrag => "drag of a sheet",
            PartKind::BodyDrag => "drag of a body",
        })
    }
}

impl SystemError {
    /// A part names a node that it cannot have.
    pub(crate) fn attached(part: PartKind, index: usize, node: usize, why: &'static str) -> SystemError {
        SystemError::Attached { part, index, node, why }
    }
}

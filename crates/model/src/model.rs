//! The model: a system with the names of its parts.

use glam::{DMat3, DVec3};
use netcast_dynamics::body::Body;
use netcast_dynamics::state::State;
use netcast_dynamics::step_size::StepLimit;
use netcast_dynamics::system::{Segment, System};
use netcast_scenario::{Diagnostics, Document, Scenario, Solid};
use netcast_webs::{Audit, Bill, CutWeb};

use crate::lower::material;
use crate::lower::members::Member;
use crate::lower::{AirOutline, CutSheet, Draft, Group, Link, PlacedBody, Role, Throw};

/// A scenario ready to be simulated, with the names of its parts.
#[derive(Debug, Clone)]
pub struct Model {
    /// The scenario; values that it left out are filled in.
    pub scenario: Scenario,
    /// The simulated system.
    pub system: System,
    /// Total mass, kg. The system itself counts driven nodes as massless.
    pub mass: f64,
    /// The state at the start, world frame.
    pub state: State,
    /// The web as drawn and cut; node k of the system is node k of the web.
    pub cut: CutWeb,
    /// The cells of the web as closed loops of nodes; see [`CutWeb::cells`].
    pub cells: Vec<Vec<usize>>,
    /// Rotation from the launch frame (z along the launch axis) to the world frame.
    pub frame: DMat3,
    /// Link class and rope of each class number of the system, (classes,).
    pub groups: Vec<Group>,
    /// Nodes of the tractors in order around the web, (tractors,).
    pub tractors: Vec<usize>,
    /// Payloads, sensor and tractors with their nodes.
    pub bodies: Vec<PlacedBody>,
    /// How each tractor is thrown, in the order of the corners, (tractors,); none for a tractor that is not thrown.
    pub throws: Vec<Option<Throw>>,
    /// The canopies that are sheets, in the order of the web.
    pub sheets: Vec<CutSheet>,
    /// The bill of materials.
    pub bill: Bill,
    /// The audit of the packed web.
    pub audit: Audit,
    /// The stability limit of the step, and its cause.
    pub limit: StepLimit,
    /// Key figures of the air; none without air.
    pub air: Option<AirOutline>,
    /// Messages to the user about values that were chosen or changed.
    pub notes: Vec<String>,
    pub(crate) members: Vec<Member>,
}

impl Model {
    /// Makes the model of a scenario, stage by stage.
    ///
    /// # Errors
    /// All mistakes that can be found in one pass, each with its place in the file.
    pub fn new(document: &Document) -> Result<Model, Diagnostics> {
        Ok(Draft::new(document)?.run()?.finish())
    }

    /// The launch axis, a unit vector in the world frame.
    pub fn axis(&self) -> DVec3 {
        self.frame * DVec3::Z
    }

    /// The name of a segment in messages, such as "segment 12 of traction rope 3".
    pub fn segment_label(&self, segment: usize) -> String {
        self.members[segment].label(&self.cut)
    }

    /// The name of a node in messages, such as "knot 12".
    pub fn node_label(&self, node: usize) -> String {
        match self.tied_to(node) {
            Some(knot) => format!("the centre of {}", self.cut.node_label(knot)),
            None if node < self.cut.nodes.len() => self.cut.node_label(node),
            None => "the place of a break tie".to_owned(),
        }
    }

    /// The knot that the rigid body with its centre at `node` is tied to.
    fn tied_to(&self, node: usize) -> Option<usize> {
        let body = self.system.bodies().iter().find(|body| body.centre == node)?;
        body.ties.first().map(|tie| tie.node)
    }

    /// The links of the web under the names that `[assign]` accepts.
    pub fn links(&self) -> Vec<Link> {
        material::links(&self.cut.web, &self.members, &self.groups)
    }

    /// Whether a segment is a piece of rope, not a member of a canopy, a tie or a stitch.
    pub fn is_rope(&self, segment: usize) -> bool {
        self.members[segment].is_rope()
    }

    /// The rigid body of each tractor, in the order of the corners, (tractors,); none for a point mass.
    pub fn tractors_by_corner(&self) -> Vec<Option<(Solid, &Body)>> {
        let rigid_tractor = |knot: &usize| {
            let is_at_knot = |placed: &&PlacedBody| {
                placed.role == Role::Tractor && placed.rigid.is_some() && self.tied_to(placed.node) == Some(*knot)
            };
            let placed = self.bodies.iter().find(is_at_knot)?;
            Some((placed.solid, &self.system.bodies()[placed.rigid?]))
        };
        self.cut.web.tractors.iter().map(rigid_tractor).collect()
    }

    /// The segments of rope that end at one of `nodes`; a body's centre stands for the knot that is tied to the body.
    pub fn ropes_at(&self, nodes: &[usize]) -> Vec<usize> {
        let nodes: Vec<usize> = nodes.iter().map(|&node| self.tied_to(node).unwrap_or(node)).collect();
        let meets = |s: &Segment| s.ends.iter().any(|end| nodes.contains(end));
        let segments = self.system.segments().iter().enumerate();
        segments.filter(|(i, s)| self.is_rope(*i) && meets(s)).map(|(i, _)| i).collect()
    }

    /// The feature points with their nodes, in the order of their names.
    pub fn points(&self) -> Vec<(String, usize)> {
        self.cut.web.points.iter().map(|(name, &site)| (name.clone(), self.cut.node_of(site))).collect()
    }
}

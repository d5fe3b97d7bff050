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
    /// The scenario with everything written out that was chosen on the way.
    pub scenario: Scenario,
    /// What is simulated.
    pub system: System,
    /// The mass of it all, kg; in the system what is driven has none.
    pub mass: f64,
    /// Where it starts, world frame.
    pub state: State,
    /// The web as drawn and cut; node k of the system is node k of the web.
    pub cut: CutWeb,
    /// Its cells as closed loops of nodes; see [`CutWeb::cells`].
    pub cells: Vec<Vec<usize>>,
    /// Turns the launch frame (z along the launch axis) to the world.
    pub frame: DMat3,
    /// Link class and rope by the system's class number.
    pub groups: Vec<Group>,
    /// The tractors in order around the web; their nodes.
    pub tractors: Vec<usize>,
    /// Payloads, sensor and tractors where they sit.
    pub bodies: Vec<PlacedBody>,
    /// How each tractor is thrown, in the order of the corners, (tractors,); none where it is not.
    pub throws: Vec<Option<Throw>>,
    /// The canopies that are sheets, in order.
    pub sheets: Vec<CutSheet>,
    /// The bill of materials.
    pub bill: Bill,
    /// The state at the start, looked over.
    pub audit: Audit,
    /// What bounds the step.
    pub limit: StepLimit,
    /// What the air comes to; none where there is none.
    pub air: Option<AirOutline>,
    /// What was chosen or changed for the user, to be said.
    pub notes: Vec<String>,
    pub(crate) members: Vec<Member>,
}

impl Model {
    /// Makes the model of a scenario, stage by stage.
    ///
    /// # Errors
    /// Everything that does not fit, as far as it can be told at once, each with its place.
    pub fn new(document: &Document) -> Result<Model, Diagnostics> {
        Ok(Draft::new(document)?.run()?.finish())
    }

    /// The launch axis, a unit vector in the world frame.
    pub fn axis(&self) -> DVec3 {
        self.frame * DVec3::Z
    }

    /// What a message calls a segment, such as "segment 12 of traction rope 3".
    pub fn segment_label(&self, segment: usize) -> String {
        self.members[segment].label(&self.cut)
    }

    /// What a message calls a node, such as "knot 12".
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

    /// The links of the web, as `[assign]` can name them.
    pub fn links(&self) -> Vec<Link> {
        material::links(&self.cut.web, &self.members, &self.groups)
    }

    /// Whether a segment is a piece of rope; members of canopies are not.
    pub fn is_rope(&self, segment: usize) -> bool {
        self.members[segment].is_rope()
    }

    /// The tractors that are rigid bodies, in the order of the corners; none for the others.
    pub fn tractors_by_corner(&self) -> Vec<Option<(Solid, &Body)>> {
        let at = |knot: &usize| {
            let is_it = |placed: &&PlacedBody| {
                placed.role == Role::Tractor && placed.rigid.is_some() && self.tied_to(placed.node) == Some(*knot)
            };
            let placed = self.bodies.iter().find(is_it)?;
            Some((placed.solid, &self.system.bodies()[placed.rigid?]))
        };
        self.cut.web.tractors.iter().map(at).collect()
    }

    /// The segments of rope that meet at some node of `nodes`, or at what is tied to a body there.
    pub fn ropes_at(&self, nodes: &[usize]) -> Vec<usize> {
        let nodes: Vec<usize> = nodes.iter().map(|&node| self.tied_to(node).unwrap_or(node)).collect();
        let meets = |s: &Segment| s.ends.iter().any(|end| nodes.contains(end));
        let segments = self.system.segments().iter().enumerate();
        segments.filter(|(i, s)| self.is_rope(*i) && meets(s)).map(|(i, _)| i).collect()
    }

    /// Feature points by name with their nodes.
    pub fn points(&self) -> Vec<(String, usize)> {
        self.cut.web.points.iter().map(|(name, &site)| (name.clone(), self.cut.node_of(site))).collect()
    }
}

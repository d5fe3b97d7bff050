//! The model that is simulated: lumped masses joined by tension-only segments. Immutable, SI, without names.

mod check;

use std::collections::BTreeMap;

use glam::DVec3;

use crate::air::Air;
use crate::body::Body;
use crate::drive::Drive;
use crate::forces::bending::Bending;
use crate::forces::breaking::Breaking;
use crate::forces::element::Element;
use crate::forces::ground::Ground;
use crate::forces::hinge::Hinge;
use crate::forces::law::Law;
use crate::forces::load::Load;
use crate::forces::membrane::Membrane;
use crate::forces::orbit::Orbit;
use crate::launcher::Launcher;
use crate::layout::Layout;

/// A piece of rope between two nodes: spring and damper along one line, pulling only (the paper's Figure 6) unless the law
/// of its class says otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The two nodes that it joins.
    pub ends: [usize; 2],
    /// Length without tension, m.
    pub rest_length: f64,
    /// Stiffness k = EA / rest length, N/m.
    pub stiffness: f64,
    /// Damping c against the rate of stretch, N s/m.
    pub damping: f64,
    /// Link class, an index below [`System::class_count`].
    pub class: usize,
    /// What it bears at most.
    pub breaking: Breaking,
}

impl Segment {
    /// The other end of this segment, seen from `node`.
    pub fn other_end(&self, node: usize) -> usize {
        if self.ends[0] == node { self.ends[1] } else { self.ends[0] }
    }

    /// Its stretch with all nodes at `position`, m.
    pub fn stretch(&self, position: &[DVec3]) -> f64 {
        let [a, b] = self.ends;
        (position[b] - position[a]).length() - self.rest_length
    }
}

/// What surrounds the net.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Environment {
    /// Acceleration of gravity, m/s^2, as a vector in the world frame.
    pub gravity: DVec3,
    /// Mass-proportional damping, 1/s: a force -damping * m * v on every node.
    pub mass_damping: f64,
    /// What drags at it, if anything.
    pub air: Option<Air>,
    /// What it can land on, if anything.
    pub ground: Option<Ground>,
    /// The orbit that it flies beside, if any.
    pub orbit: Option<Orbit>,
}

/// The net as a system of ordinary differential equations.
#[derive(Debug, Clone)]
pub struct System {
    mass: Vec<f64>,
    held: Vec<bool>,
    tractor: Vec<bool>,
    segments: Vec<Segment>,
    laws: Vec<Law>,
    bends: Vec<Bending>,
    membranes: Vec<Membrane>,
    hinges: Vec<Hinge>,
    loads: Vec<Load>,
    bodies: Vec<Body>,
    drives: Vec<Drive>,
    launchers: Vec<Launcher>,
    environment: Environment,
    layout: Layout,
    /// The bends over each segment that has some.
    bends_over: BTreeMap<usize, Vec<usize>>,
}

/// What a [`System`] is made from; [`SystemParts::build`] checks it.
#[derive(Debug, Clone, Default)]
pub struct SystemParts {
    /// Mass of each node, kg; shape (nodes,). What a rigid body carries has none.
    pub mass: Vec<f64>,
    /// Whether a node stays where it is; shape (nodes,).
    pub held: Vec<bool>,
    /// Whether a node is a tractor, whose kinetic energy is kept apart from the web's; shape (nodes,).
    pub tractor: Vec<bool>,
    /// Segments; those of one rope in order, one after the other, so that they can be laid out as one run.
    pub segments: Vec<Segment>,
    /// The law of each link class, (classes,).
    pub laws: Vec<Law>,
    /// Where ropes resist bending.
    pub bends: Vec<Bending>,
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
    /// What holds nodes and throws them.
    pub launchers: Vec<Launcher>,
    /// What surrounds it.
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
    /// A parameter of a class's law is out of range.
    #[error("the law of class {class} has a {what} of {value}")]
    Law {
        /// Which class.
        class: usize,
        /// Which parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A load, a body, a drive or a launcher names a node that it cannot have.
    #[error("{what} {index} has node {node}, which {why}")]
    Attached {
        /// What names it.
        what: &'static str,
        /// Which of them.
        index: usize,
        /// The node.
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

impl SystemParts {
    /// Checks the parts and lays the system out for the step.
    ///
    /// # Errors
    /// The first part that is out of range, as a [`SystemError`].
    pub fn build(mut self) -> Result<System, SystemError> {
        self.check()?;
        let mut resting = self.held.clone();
        for drive in &self.drives {
            resting[drive.node] = false;
            // what drives it has to do with its mass, the net has not
            self.mass[drive.node] = 0.0;
        }
        let bends_over = bends_over(&self.bends, &self.segments);
        let layout = Layout::new(self.mass.len(), &self.segments, &resting, self.laws.len());
        Ok(System {
            mass: self.mass,
            held: self.held,
            tractor: self.tractor,
            segments: self.segments,
            laws: self.laws,
            bends: self.bends,
            membranes: self.membranes,
            hinges: self.hinges,
            loads: self.loads,
            bodies: self.bodies,
            drives: self.drives,
            launchers: self.launchers,
            environment: self.environment,
            layout,
            bends_over,
        })
    }
}

impl System {
    /// Mass of each node, kg; shape (nodes,).
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    /// Whether each node stays where it is; shape (nodes,).
    pub fn held(&self) -> &[bool] {
        &self.held
    }

    /// Whether each node is a tractor; shape (nodes,).
    pub fn tractor(&self) -> &[bool] {
        &self.tractor
    }

    /// The segments, in the order in which they were given.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Number of link classes.
    pub fn class_count(&self) -> usize {
        self.laws.len()
    }

    /// The law of each link class, (classes,).
    pub fn laws(&self) -> &[Law] {
        &self.laws
    }

    /// The law of a segment.
    pub fn law(&self, segment: &Segment) -> &Law {
        &self.laws[segment.class]
    }

    /// Whether any segment remembers more than where its nodes are.
    pub fn remembers(&self) -> bool {
        self.laws.iter().any(Law::remembers)
    }

    /// Where ropes resist bending.
    pub fn bends(&self) -> &[Bending] {
        &self.bends
    }

    /// The bends between a segment and the next one, which are no more when it breaks.
    pub fn bends_over(&self, segment: usize) -> &[usize] {
        self.bends_over.get(&segment).map_or(&[], |bends| &bends[..])
    }

    /// The bends between segments of which none is `broken`, (segments,).
    pub fn unbroken_bends(&self, broken: &[bool]) -> impl Iterator<Item = &Bending> {
        let mut whole = vec![true; self.bends.len()];
        let gone = self.bends_over.iter().filter(|(segment, _)| broken[**segment]);
        gone.flat_map(|(_, bends)| bends).for_each(|&bend| whole[bend] = false);
        self.bends.iter().zip(whole).filter(|(_, whole)| *whole).map(|(bend, _)| bend)
    }

    /// Triangles of sheets.
    pub fn membranes(&self) -> &[Membrane] {
        &self.membranes
    }

    /// Where sheets resist bending.
    pub fn hinges(&self) -> &[Hinge] {
        &self.hinges
    }

    /// Constant forces.
    pub fn loads(&self) -> &[Load] {
        &self.loads
    }

    /// Rigid bodies.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// Nodes that are moved along paths.
    pub fn drives(&self) -> &[Drive] {
        &self.drives
    }

    /// What holds nodes and throws them.
    pub fn launchers(&self) -> &[Launcher] {
        &self.launchers
    }

    /// What surrounds it.
    pub fn environment(&self) -> &Environment {
        &self.environment
    }

    /// How nodes and segments lie in memory while time runs.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }
}

/// The bends over each segment. Where several segments join two nodes of a bend the first is the piece of its rope.
fn bends_over(bends: &[Bending], segments: &[Segment]) -> BTreeMap<usize, Vec<usize>> {
    let (mut between, mut over) = (BTreeMap::new(), BTreeMap::<usize, Vec<usize>>::new());
    if bends.is_empty() {
        return over;
    }
    let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    for (index, segment) in segments.iter().enumerate() {
        between.entry(sorted(segment.ends)).or_insert(index);
    }
    for (index, bend) in bends.iter().enumerate() {
        let [before, at, after] = bend.nodes();
        let joined = [[before, at], [at, after]].into_iter().filter_map(|ends| between.get(&sorted(ends)));
        joined.for_each(|&segment| over.entry(segment).or_default().push(index));
    }
    over
}

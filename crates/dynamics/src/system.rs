//! The model that is simulated: lumped masses joined by tension-only segments. Immutable, SI, without names.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::air::{Air, Attitude};
use crate::body::Body;
use crate::drive::Drive;
use crate::forces::bending::Bending;
use crate::forces::breaking::Breaking;
use crate::forces::element::Element;
use crate::forces::ground::{Ground, Spring};
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
        let nodes = self.mass.len();
        if nodes == 0 {
            return Err(SystemError::Empty);
        }
        for (what, found) in [("held", self.held.len()), ("tractor", self.tractor.len())] {
            if found != nodes {
                return Err(SystemError::Shape { what, found, expected: nodes });
            }
        }
        self.check_attached()?;
        let mut carried = vec![false; nodes];
        for tie in self.bodies.iter().flat_map(|body| &body.ties) {
            carried[tie.node] = true;
        }
        for (node, &mass) in self.mass.iter().enumerate() {
            let enough = if carried[node] {
                mass == 0.0
            } else if self.held[node] {
                mass >= 0.0
            } else {
                mass > 0.0
            };
            if !(enough && mass.is_finite()) {
                return Err(SystemError::Mass { node, mass });
            }
        }
        for (segment, s) in self.segments.iter().enumerate() {
            let [a, b] = s.ends;
            if a == b || a >= nodes || b >= nodes {
                return Err(SystemError::Ends { segment, ends: s.ends, nodes });
            }
            let checks = [
                ("rest length, m", s.rest_length, s.rest_length > 0.0),
                ("stiffness, N/m", s.stiffness, s.stiffness > 0.0),
                ("damping, N s/m", s.damping, s.damping >= 0.0),
                ("class", s.class as f64, s.class < self.laws.len()),
            ];
            for (what, value, holds) in checks {
                if !(holds && value.is_finite()) {
                    return Err(SystemError::Property { segment, what, value });
                }
            }
            let Breaking { load, strain } = s.breaking;
            let most = [("breaking load, N", load), ("breaking strain", strain)];
            // infinite: it never breaks
            if let Some((what, value)) = most.into_iter().find(|(_, value)| value.is_nan() || *value <= 0.0) {
                return Err(SystemError::Property { segment, what, value });
            }
        }
        for (class, law) in self.laws.iter().enumerate() {
            let wrong = law.parameters().into_iter().find(|(_, value, holds)| !(*holds && value.is_finite()));
            if let Some((what, value, _)) = wrong {
                return Err(SystemError::Law { class, what, value });
            }
        }
        let Environment { gravity, mass_damping, ref air, ref ground, orbit } = self.environment;
        air.iter().try_for_each(|air| self.check_air(air))?;
        ground.iter().try_for_each(|ground| self.check_ground(ground))?;
        if !gravity.is_finite() {
            return Err(SystemError::Environment { what: "gravity, m/s^2", value: gravity.length() });
        }
        if !(mass_damping >= 0.0 && mass_damping.is_finite()) {
            return Err(SystemError::Environment { what: "damping, 1/s", value: mass_damping });
        }
        let is_unit = |way: DVec3| (way.length_squared() - 1.0).abs() < 1e-9;
        if let Some(Orbit { mean_motion, radial, along }) = orbit
            && !(mean_motion >= 0.0
                && mean_motion.is_finite()
                && is_unit(radial)
                && is_unit(along)
                && radial.dot(along).abs() < 1e-9)
        {
            return Err(SystemError::Environment { what: "mean motion, 1/s, or one of its axes", value: mean_motion });
        }
        let mut resting = self.held.clone();
        for drive in &self.drives {
            resting[drive.node] = false;
            // what drives it has to do with its mass, the net has not
            self.mass[drive.node] = 0.0;
        }
        let bends_over = bends_over(&self.bends, &self.segments);
        let layout = Layout::new(nodes, &self.segments, &resting, self.laws.len());
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

    /// That what drags is there, and its values can be computed with.
    fn check_air(&self, air: &Air) -> Result<(), SystemError> {
        let (nodes, classes) = (self.mass.len(), self.laws.len());
        if air.ropes.len() != classes {
            let what = "drag of ropes, link classes of it";
            return Err(SystemError::Environment { what, value: air.ropes.len() as f64 });
        }
        let wrong = |what, index, node, why| Err(SystemError::Attached { what, index, node, why });
        for (index, sheet) in air.sheets.iter().enumerate() {
            if let Some(&node) = sheet.nodes.iter().find(|&&node| node >= nodes) {
                return wrong("drag of a sheet", index, node, "does not exist");
            }
        }
        for (index, body) in air.bodies.iter().enumerate() {
            let is_there = match body.attitude {
                Attitude::Fixed(_) => body.node < nodes,
                Attitude::Body(at) => self.bodies.get(at).is_some_and(|own| own.centre == body.node),
            };
            if !is_there {
                return wrong("drag of a body", index, body.node, "does not exist, or is not that body's centre");
            }
        }
        let of_ropes = air.ropes.iter().flatten().flat_map(|rope| {
            let normal = rope.normal.unwrap_or_default();
            [("diameter of a rope that drags, m", rope.diameter), ("normal coefficient", normal)]
                .into_iter()
                .chain([("tangential coefficient", rope.tangential), ("solidity", rope.solidity)])
        });
        let of_sheets = air
            .sheets
            .iter()
            .flat_map(|sheet| [("coefficient of a sheet", sheet.coefficient), ("area of a sheet, m^2", sheet.area)]);
        let own = [
            ("density, kg/m^3", air.medium.density(0.0)),
            ("viscosity, Pa s", air.medium.viscosity()),
            ("added mass", air.added_mass),
            ("fastest wind, m/s", air.fastest),
        ];
        let wrong = of_ropes.chain(of_sheets).chain(own).find(|(_, value)| !(*value >= 0.0 && value.is_finite()));
        wrong.map_or(Ok(()), |(what, value)| Err(SystemError::Environment { what, value }))
    }

    /// That what the ground touches is there, and its values can be computed with.
    fn check_ground(&self, ground: &Ground) -> Result<(), SystemError> {
        let wrong = |what, index, node, why| Err(SystemError::Attached { what, index, node, why });
        for (index, footing) in ground.nodes.iter().enumerate() {
            if self.mass.get(footing.node).is_none_or(|&mass| mass == 0.0) || !footing.radius.is_finite() {
                return wrong("contact of the ground", index, footing.node, "does not exist, or has no mass");
            }
        }
        for (index, hull) in ground.hulls.iter().enumerate() {
            if hull.body >= self.bodies.len() || !(hull.arm.is_finite() && hull.radius.is_finite()) {
                return wrong("contact of the ground", index, hull.body, "is no body");
            }
        }
        let springs = ground.nodes.iter().map(|at| at.spring).chain(ground.hulls.iter().map(|hull| hull.spring));
        let values = springs.flat_map(|Spring { stiffness, damping, mass }| [stiffness, damping, mass]);
        let wrong =
            values.chain([ground.friction, ground.height.abs()]).find(|value| !(*value >= 0.0 && value.is_finite()));
        wrong.map_or(Ok(()), |value| Err(SystemError::Environment { what: "ground, in one of its numbers,", value }))
    }

    /// That loads, bodies, drives and launchers have nodes of the right kind, and values that can be computed with.
    fn check_attached(&self) -> Result<(), SystemError> {
        let nodes = self.mass.len();
        let wrong = |what, index, node, why| Err(SystemError::Attached { what, index, node, why });
        for (index, load) in self.loads.iter().enumerate() {
            if load.node >= nodes || !load.force.is_finite() {
                return wrong("load", index, load.node, "does not exist, or whose force is not finite");
            }
        }
        let bends = self.bends.iter().map(|bend| bend.nodes().to_vec());
        let membranes = self.membranes.iter().map(|membrane| membrane.nodes().to_vec());
        let hinges = self.hinges.iter().map(|hinge| hinge.nodes().to_vec());
        for (index, element) in bends.chain(membranes).chain(hinges).enumerate() {
            if let Some(&node) = element.iter().find(|&&node| node >= nodes) {
                return wrong("element", index, node, "does not exist");
            }
        }
        let mut taken = vec![false; nodes];
        for (index, body) in self.bodies.iter().enumerate() {
            if body.centre >= nodes || !(body.inertia.is_finite() && body.inertia.min_element() > 0.0) {
                return wrong("body", index, body.centre, "does not exist, or about which there is no inertia");
            }
            for tie in &body.ties {
                if tie.node >= nodes || self.held[tie.node] || taken[tie.node] || !tie.arm.is_finite() {
                    return wrong("body", index, tie.node, "does not exist, is held, or is tied to a body already");
                }
                taken[tie.node] = true;
            }
        }
        if let Some((index, body)) = self.bodies.iter().enumerate().find(|(_, body)| taken[body.centre]) {
            return wrong("body", index, body.centre, "is its centre and tied to a body");
        }
        for (index, drive) in self.drives.iter().enumerate() {
            let ascending = drive.path.windows(2).all(|pair| pair[0].0 < pair[1].0);
            let finite = drive.path.iter().all(|(time, place)| time.is_finite() && place.is_finite());
            if drive.node >= nodes || !self.held[drive.node] || drive.path.is_empty() || !(ascending && finite) {
                return wrong("drive", index, drive.node, "is not held, or whose path does not go forward in time");
            }
        }
        let mut launched = vec![false; nodes];
        for (index, launcher) in self.launchers.iter().enumerate() {
            let node = launcher.node;
            if node >= nodes || self.held[node] || taken[node] || std::mem::replace(&mut launched[node], true) {
                return wrong("launcher", index, node, "does not exist, is held, carried or launched twice");
            }
            if let Some(why) = launcher.fault() {
                return wrong("launcher", index, node, why);
            }
        }
        Ok(())
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

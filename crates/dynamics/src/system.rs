//! The model that is simulated: lumped masses joined by tension-only segments. Immutable, SI, without names.

mod check;

use crate::body::Body;
use crate::channel::Channel;
use crate::drive::Drive;
use crate::forces::law::Law;
use crate::forces::load::Load;
use crate::forces::membrane::Membrane;
pub use crate::forces::segment::Segment;
use crate::launcher::Launcher;
use crate::layout::Layout;
pub use crate::parts::{Environment, PartKind, SystemError, SystemParts};

/// The net as a system of ordinary differential equations: parts that fit each other, and how they lie in memory while
/// time runs.
#[derive(Debug, Clone)]
pub struct System {
    parts: SystemParts,
    layout: Layout,
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
        let layout = Layout::new(self.mass.len(), &self.segments, &resting, self.laws.len());
        Ok(System { parts: self, layout })
    }
}

impl System {
    /// The parts that it is made from. Driven nodes have no mass of their own.
    pub fn parts(&self) -> &SystemParts {
        &self.parts
    }

    /// Mass of each node, kg; shape (nodes,).
    pub fn mass(&self) -> &[f64] {
        &self.parts.mass
    }

    /// Whether each node stays where it is; shape (nodes,).
    pub fn held(&self) -> &[bool] {
        &self.parts.held
    }

    /// Whether each node is a tractor; shape (nodes,).
    pub fn tractor(&self) -> &[bool] {
        &self.parts.tractor
    }

    /// The segments, in the order in which they were given.
    pub fn segments(&self) -> &[Segment] {
        &self.parts.segments
    }

    /// Number of groups.
    pub fn group_count(&self) -> usize {
        self.parts.laws.len()
    }

    /// The law of each group, (groups,).
    pub fn laws(&self) -> &[Law] {
        &self.parts.laws
    }

    /// The law of a segment.
    pub fn law(&self, segment: &Segment) -> &Law {
        &self.parts.laws[segment.group]
    }

    /// Whether the law of any segment has state.
    pub fn remembers(&self) -> bool {
        self.parts.laws.iter().any(Law::remembers)
    }

    /// Triangles of sheets.
    pub fn membranes(&self) -> &[Membrane] {
        &self.parts.membranes
    }

    /// Rigid bodies.
    pub fn bodies(&self) -> &[Body] {
        &self.parts.bodies
    }

    /// Launchers, which hold nodes and throw them.
    pub fn launchers(&self) -> &[Launcher] {
        &self.parts.launchers
    }

    /// Gravity, damping, air, ground and orbit around the net.
    pub fn environment(&self) -> &Environment {
        &self.parts.environment
    }

    /// How nodes and segments lie in memory while time runs.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Constant forces.
    pub fn loads(&self) -> &[Load] {
        &self.parts.loads
    }

    /// Nodes that are moved along paths.
    pub fn drives(&self) -> &[Drive] {
        &self.parts.drives
    }

    /// The channels of the energy balance that results list: all that netcast knows, and that of the caller's effects
    /// where there are some.
    pub fn channels(&self) -> impl Iterator<Item = Channel> + use<> {
        let has_custom = !self.parts.custom.is_empty();
        Channel::ALL.iter().copied().filter(move |channel| *channel != Channel::Custom || has_custom)
    }
}

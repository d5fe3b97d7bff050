//! The contract between an effect, which is one file of this folder, and the step.

use std::fmt::Debug;

use glam::DVec3;
use serde::Serialize;
use serde::de::DeserializeOwned;

use super::bound::Bound;
use crate::channel::{ByChannel, Channel};
pub(crate) use crate::moving::Net;
use crate::moving::{Moving, StepFactors, Turning};
use crate::parts::{SystemError, SystemParts};
use crate::state::State;
use crate::team::Team;

/// A force on nodes or bodies beside rope tension. A value holds the state that changes during a run; what never changes
/// is in the [`SystemParts`] that every call gets.
///
/// All but [`Effect::of`] and [`Effect::nodes`] do nothing unless an effect says otherwise.
pub(crate) trait Effect: Sized + Clone + Send {
    /// Its name in messages, in memory, and where an observer asks for its forces.
    const NAME: &'static str;
    /// The channels that it stores energy in, or loses it by.
    const CHANNELS: &'static [Channel];
    /// State that it keeps from step to step beside the positions of nodes; `()` for none.
    type Memory: Debug + Clone + PartialEq + Default + Serialize + DeserializeOwned;

    /// The effect at the start of a run; none where the parts have nothing of the kind.
    fn of(parts: &SystemParts) -> Option<Self>;

    /// Checks that its parts fit the system.
    ///
    /// # Errors
    /// The first part that does not fit.
    fn check(_: &SystemParts) -> Result<(), SystemError> {
        Ok(())
    }

    /// Tells `act_on` every node that it may exert a force on.
    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize));

    /// Tells `ask` the nodes that it asks for several times a step: they are in [`Now::seen`].
    fn asks(_: &SystemParts, _ask: &mut dyn FnMut(usize)) {}

    /// Adds its stiffness and damping at each node: of springs between nodes, and of drag.
    fn bound(_: &SystemParts, _: &mut Bound) {}

    /// Adds what depends on those sums: springs between a node and the world, and stiffness that bodies get from their ties.
    fn bound_carried(_: &SystemParts, _: &mut Bound) {}

    /// Puts into `rest` those of its parts that act in a relaxation to an equilibrium.
    fn at_rest(_: &SystemParts, _: &Resting, _rest: &mut SystemParts) {}

    /// Tells `join` the pairs of nodes that it holds together.
    fn joins(_: &SystemParts, _join: &mut dyn FnMut(usize, usize)) {}

    /// Tells `bear` the nodes that it can support from below.
    fn bears(_: &SystemParts, _bear: &mut dyn FnMut(usize)) {}

    /// Adds the forces that follow from where nodes and bodies are and how they move, and the work since those before.
    fn act<N: Net>(&mut self, _: &Now, _: &N, _: &mut Forces) {}

    /// Adds the forces that follow from all other forces on a node.
    fn couple<N: Net>(&mut self, _: &Now, _: &N, _: &mut Forces) {}

    /// A segment breaks at these forces; elements that belong to it act for the last time.
    fn part(&mut self, _: &SystemParts, _segment: usize, _work: &mut ByChannel) {}

    /// A segment is broken and no longer acts.
    fn gone(&mut self, _: &SystemParts, _segment: usize) {}

    /// Nodes were put where `node` says.
    fn placed(&mut self, _: &SystemParts, _node: &dyn Fn(usize) -> Moving) {}

    /// Nodes have moved to where `node` says, and [`Now::time`] is that of the next step. What it carries goes to
    /// [`Forces::carried`].
    fn moved(&mut self, _: &Now, _node: &dyn Fn(usize) -> Moving, _: &mut Forces) {}

    /// Adds the energy that it has stored in this state, J.
    fn stored(&self, _: &SystemParts, _: &State, _: &mut ByChannel) {}

    /// Its state now.
    fn memory(&self) -> Self::Memory {
        Self::Memory::default()
    }

    /// Restores its state.
    fn remember(&mut self, _: &Self::Memory) {}

    /// Number of entries in a memory.
    fn remembered(_: &Self::Memory) -> usize {
        0
    }

    /// Number of entries that a memory of these parts must have.
    fn to_remember(_: &SystemParts) -> usize {
        0
    }
}

/// Time, parts and motion that every call of an effect gets.
pub(crate) struct Now<'n> {
    /// The system's parts.
    pub parts: &'n SystemParts,
    /// The threads to work on.
    pub team: &'n Team,
    /// The step's constants.
    pub factors: StepFactors,
    /// Time, s.
    pub time: f64,
    /// Whether the run takes its first step.
    pub is_first: bool,
    /// Position, m, and velocity, m/s, of the nodes that effects ask for several times a step; (nodes,).
    pub seen: &'n [(DVec3, DVec3)],
    /// How each rigid body turns, (bodies,).
    pub turning: &'n [Turning],
}

/// Sums of all effects at one evaluation of forces.
#[derive(Debug, Clone)]
pub(crate) struct Forces {
    /// Force on each node beside those of ropes, N, (nodes,).
    pub force: Vec<DVec3>,
    /// Torque on each rigid body about its centre, N m, (bodies,).
    pub torque: Vec<DVec3>,
    /// Work since the forces before, J, by the channel that it goes to.
    pub work: ByChannel,
    /// The sum of L . omega over all bodies at the step, J: their share in what mass-proportional damping takes.
    pub turning: f64,
    /// Nodes that are released at these forces, and their half-step velocities before, m/s.
    pub released: Vec<(usize, DVec3)>,
    /// Nodes that are carried, driven or released, and how they move now.
    pub carried: Vec<(usize, Moving)>,
    /// How bodies turn after a step, (bodies,).
    pub turned: Vec<Turning>,
}

impl Forces {
    /// Zero on all nodes and bodies of `parts`.
    pub fn none(parts: &SystemParts) -> Forces {
        Forces {
            force: vec![DVec3::ZERO; parts.mass.len()],
            torque: vec![DVec3::ZERO; parts.bodies.len()],
            work: ByChannel::default(),
            turning: 0.0,
            released: Vec::new(),
            carried: Vec::new(),
            turned: Vec::new(),
        }
    }

    /// Forgets the forces before.
    pub fn clear(&mut self) {
        self.force.fill(DVec3::ZERO);
        self.torque.fill(DVec3::ZERO);
        self.work = ByChannel::default();
        self.released.clear();
    }
}

/// What does not move in a relaxation: held nodes, and nodes and bodies that are launched later.
pub(crate) struct Resting {
    /// Whether each node is fixed, (nodes,).
    pub held: Vec<bool>,
    /// Indices of the bodies that may turn: a body that is launched later keeps its attitude.
    pub turning: Vec<usize>,
    /// How every body is turned at the start, (bodies,).
    pub turned: Vec<glam::DQuat>,
    /// Damping of springs, as a time: c over k, s.
    pub damping_time: f64,
}

impl Resting {
    /// The number of a body among those that turn; none for one that does not.
    pub fn turning_body(&self, body: usize) -> Option<usize> {
        self.turning.iter().position(|&turning| turning == body)
    }
}

/// A node as elements ask for it: position, m, and velocity at the step, m/s.
pub(crate) fn seen(Moving { x, v: _, w }: Moving) -> (DVec3, DVec3) {
    (x, w)
}

//! Effects: forces on nodes and bodies beside rope tension. Each effect is one file, and one line in one list.
//!
//! The trait `Effect` in `contract.rs` is the contract: whether the parts fit, on which nodes an effect acts, how stiff it
//! is, how it takes part in a relaxation, its forces, its stored energy and its memory. Both steps call the
//! list in the same order, so that forces are summed in the same order whatever the number of threads:
//!
//! ```text
//! act      forces that follow from where nodes and bodies are and how they move, in the order of the list
//! part     segments break at these forces: what belongs to them acts for the last time
//! couple   forces that follow from all forces on a node, in the order of the list: bodies take up those on their ties
//! moved    nodes have moved: launchers let go, drives go on, bodies turn and take their ties along; last effect first
//! ```
//!
//! Ropes are not in the list: they are the engine, in [`crate::time`].

mod added_mass;
mod bends;
mod bodies;
mod bound;
mod contract;
pub mod custom;
mod drag;
mod drives;
mod elements;
mod ground;
mod launchers;
mod loads;
mod orbit;
mod sheets;
mod traced;

use std::collections::BTreeSet;

use glam::DVec3;
use serde::{Deserialize, Serialize};

pub(crate) use bodies::{carried_velocities, for_each_tie};
pub use bound::Stiff;
pub(crate) use bound::{Bound, turning_mass};
pub(crate) use contract::{Effect, Forces, Net, Now, Resting, seen};
pub use launchers::{Launched, Launching, Phase, Recoil};

use crate::body::Rotation;
use crate::channel::{ByChannel, Channel};
use crate::moving::{Moving, StepFactors, Turning};
use crate::parts::{SystemError, SystemParts};
use crate::state::State;
use crate::team::Team;

/// Makes the list: a field an effect, none where a system has nothing of the kind, and what goes through all of them.
macro_rules! effects {
    ($($(#[$doc:meta])* $field:ident: $Effect:ty,)*) => {
        /// The effects of a system in the order of the step.
        #[derive(Clone)]
        struct List {
            $($(#[$doc])* $field: Option<$Effect>,)*
        }

        /// State that effects keep from one step to the next beside the positions of nodes.
        #[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
        pub struct Memory {
            $($field: <$Effect as Effect>::Memory,)*
        }

        /// Name and channels of every effect, in the order of the step.
        pub const EFFECTS: &[(&str, &[Channel])] = &[$((<$Effect>::NAME, <$Effect>::CHANNELS),)*];

        /// Whether all parts that effects act by fit the system.
        pub(crate) fn check(parts: &SystemParts) -> Result<(), SystemError> {
            $(<$Effect>::check(parts)?;)*
            Ok(())
        }

        /// Adds up how stiff effects make each node; see [`Effect::bound`] and [`Effect::bound_carried`].
        pub(crate) fn bound(parts: &SystemParts, bound: &mut Bound) {
            $(<$Effect>::bound(parts, bound);)*
            $(<$Effect>::bound_carried(parts, bound);)*
        }

        /// Puts into `rest` the parts of effects that act in a relaxation.
        pub(crate) fn at_rest(parts: &SystemParts, resting: &Resting, rest: &mut SystemParts) {
            $(<$Effect>::at_rest(parts, resting, rest);)*
        }

        /// Tells `join` the pairs of nodes that effects hold together.
        pub(crate) fn joins(parts: &SystemParts, join: &mut dyn FnMut(usize, usize)) {
            $(<$Effect>::joins(parts, join);)*
        }

        /// Tells `bear` the nodes that something below can bear.
        pub(crate) fn bears(parts: &SystemParts, bear: &mut dyn FnMut(usize)) {
            $(<$Effect>::bears(parts, bear);)*
        }

        /// Tells `act_on` every node that effects act on; of the one named `only`, if that is given.
        pub(crate) fn nodes(parts: &SystemParts, only: Option<&str>, act_on: &mut dyn FnMut(usize)) {
            $(if only.is_none_or(|name| name == <$Effect>::NAME) {
                <$Effect>::nodes(parts, act_on);
            })*
        }

        /// Tells `ask` the nodes that effects ask for several times a step.
        fn asks(parts: &SystemParts, ask: &mut dyn FnMut(usize)) {
            $(<$Effect>::asks(parts, ask);)*
        }

        impl List {
            fn of(parts: &SystemParts) -> List {
                List { $($field: <$Effect>::of(parts),)* }
            }

            fn is_empty(&self) -> bool {
                $(self.$field.is_none())&&*
            }

            /// Does `act` or `couple`, and keeps what the effect that is watched does to nodes and bodies.
            fn act<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces, watch: &mut Watch) {
                $(if let Some(effect) = &mut self.$field {
                    watch.add(<$Effect>::NAME, out, |out| effect.act(now, net, out));
                })*
            }

            fn couple<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces, watch: &mut Watch) {
                $(if let Some(effect) = &mut self.$field {
                    watch.add(<$Effect>::NAME, out, |out| effect.couple(now, net, out));
                })*
            }

            /// Every effect that there is, in the order of the list.
            fn all(&mut self) -> impl DoubleEndedIterator<Item = &mut dyn Moved> {
                [$(self.$field.as_mut().map(|effect| effect as &mut dyn Moved),)*].into_iter().flatten()
            }

            fn stored(&self, parts: &SystemParts, state: &State) -> ByChannel {
                let mut stored = ByChannel::default();
                $(if let Some(effect) = &self.$field {
                    effect.stored(parts, state, &mut stored);
                })*
                stored
            }

            fn memory(&self) -> Memory {
                Memory { $($field: self.$field.as_ref().map(Effect::memory).unwrap_or_default(),)* }
            }

            fn remember(&mut self, memory: &Memory) {
                $(if let Some(effect) = &mut self.$field {
                    effect.remember(&memory.$field);
                })*
            }
        }

        impl Memory {
            /// The first effect whose memory does not fit `parts`: its name, entries found, entries expected.
            pub(crate) fn misfit(&self, parts: &SystemParts) -> Option<(&'static str, usize, usize)> {
                let counts = [$((<$Effect>::NAME, <$Effect>::remembered(&self.$field), <$Effect>::to_remember(parts)),)*];
                counts.into_iter().find(|(_, found, expected)| found != expected)
            }
        }
    };
}

effects! {
    /// Forces given on nodes.
    loads: loads::Loads,
    /// Bending of ropes.
    bends: bends::Bends,
    /// Sheets in their plane.
    membranes: sheets::Membranes,
    /// Bending of sheets.
    hinges: sheets::Hinges,
    /// The ground under nodes.
    footings: ground::Footings,
    /// Tidal and Coriolis forces beside an orbit.
    orbit: orbit::BesideOrbit,
    /// Drag of sheets and bodies.
    drag: drag::Drag,
    /// Rigid bodies and their ties.
    bodies: bodies::Bodies,
    /// The ground under rigid bodies.
    hulls: ground::Hulls,
    /// Inertia of the medium around ropes.
    added_mass: added_mass::AddedMass,
    /// Effects of the caller's own.
    custom: custom::Customs,
    /// Nodes that are led along paths.
    drives: drives::Drives,
    /// Launchers, which hold nodes and throw them. Last, as it answers all other forces.
    launchers: launchers::Launchers,
}

/// The part of an [`Effect`] that is called once a step, after nodes have moved.
trait Moved {
    fn placed(&mut self, parts: &SystemParts, node: &dyn Fn(usize) -> Moving);
    fn part(&mut self, parts: &SystemParts, segment: usize, work: &mut ByChannel);
    fn gone(&mut self, parts: &SystemParts, segment: usize);
    fn moved(&mut self, now: &Now, node: &dyn Fn(usize) -> Moving, out: &mut Forces);
}

impl<E: Effect> Moved for E {
    fn placed(&mut self, parts: &SystemParts, node: &dyn Fn(usize) -> Moving) {
        Effect::placed(self, parts, node);
    }

    fn part(&mut self, parts: &SystemParts, segment: usize, work: &mut ByChannel) {
        Effect::part(self, parts, segment, work);
    }

    fn gone(&mut self, parts: &SystemParts, segment: usize) {
        Effect::gone(self, parts, segment);
    }

    fn moved(&mut self, now: &Now, node: &dyn Fn(usize) -> Moving, out: &mut Forces) {
        Effect::moved(self, now, node, out);
    }
}

/// Forces of one effect at the last forces.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EffectForces {
    /// Force on each node, N, (nodes,).
    pub force: Vec<DVec3>,
    /// Torque on each rigid body about its centre, N m, (bodies,).
    pub torque: Vec<DVec3>,
}

/// The effects whose forces somebody wants to see, by name.
#[derive(Clone, Default)]
struct Watch(Vec<(&'static str, EffectForces)>);

impl Watch {
    /// Lets an effect add its forces; where it is watched, keeps what it added.
    #[inline]
    fn add(&mut self, name: &'static str, out: &mut Forces, add: impl FnOnce(&mut Forces)) {
        let Some((_, kept)) = self.0.iter_mut().find(|(watched, _)| *watched == name) else { return add(out) };
        let before = (out.force.clone(), out.torque.clone());
        add(out);
        for (kept, now, before) in [(&mut kept.force, &out.force, before.0), (&mut kept.torque, &out.torque, before.1)]
        {
            for (kept, (now, before)) in kept.iter_mut().zip(now.iter().zip(before)) {
                *kept += *now - before;
            }
        }
    }

    fn clear(&mut self) {
        for (_, kept) in &mut self.0 {
            kept.force.fill(DVec3::ZERO);
            kept.torque.fill(DVec3::ZERO);
        }
    }
}

/// The effects of a system in motion, and the forces that they add up to.
#[derive(Clone)]
pub(crate) struct Effects<'a> {
    parts: &'a SystemParts,
    factors: StepFactors,
    list: List,
    forces: Forces,
    watch: Watch,
    /// The nodes that effects ask for several times a step, each once; position and velocity of those, (nodes,).
    asked: Vec<usize>,
    seen: Vec<(DVec3, DVec3)>,
    turning: Vec<Turning>,
    /// Whether no step was taken yet.
    is_first: bool,
}

impl<'a> Effects<'a> {
    /// Effects of `parts` at the start of a run.
    pub fn new(parts: &'a SystemParts, factors: StepFactors) -> Self {
        let mut asked = BTreeSet::new();
        asks(parts, &mut |node| {
            asked.insert(node);
        });
        Effects {
            parts,
            factors,
            list: List::of(parts),
            forces: Forces::none(parts),
            watch: Watch::default(),
            asked: asked.into_iter().collect(),
            seen: vec![(DVec3::ZERO, DVec3::ZERO); parts.mass.len()],
            turning: Vec::new(),
            is_first: true,
        }
    }

    /// To ask what is stored, without a run.
    pub fn at_rest(parts: &'a SystemParts) -> Self {
        Effects::new(parts, StepFactors::new(1.0, 0.0))
    }

    /// Whether there are none. A step then does without all calls.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Keeps, from the next forces on, what the effects of these names do. Unknown names are ignored.
    pub fn watch(&mut self, names: &[&str]) {
        let known = EFFECTS.iter().map(|(name, _)| *name).filter(|name| names.contains(name));
        let none = EffectForces { force: self.forces.force.clone(), torque: self.forces.torque.clone() };
        self.watch = Watch(known.map(|name| (name, none.clone())).collect());
        self.watch.clear();
    }

    /// Forces of a watched effect at the last forces.
    pub fn watched(&self, name: &str) -> Option<&EffectForces> {
        self.watch.0.iter().find(|(watched, _)| *watched == name).map(|(_, forces)| forces)
    }

    /// All forces but those of couplings at `time`, s: the first part of a step. Call [`Effects::part`] and
    /// [`Effects::couple`] next.
    pub fn act<N: Net>(&mut self, team: &Team, time: f64, net: &N) {
        for &node in &self.asked {
            self.seen[node] = seen(net.node(node));
        }
        self.forces.clear();
        self.watch.clear();
        self.with_now(team, time, |list, now, forces, watch| list.act(now, net, forces, watch));
    }

    /// Tells what belongs to a segment that it breaks at these forces.
    pub fn part(&mut self, failing: impl IntoIterator<Item = usize>) {
        for segment in failing {
            for effect in self.list.all() {
                effect.part(self.parts, segment, &mut self.forces.work);
            }
        }
    }

    /// Couplings at `time`, s: the second part of a step's forces.
    pub fn couple<N: Net>(&mut self, team: &Team, time: f64, net: &N) {
        self.with_now(team, time, |list, now, forces, watch| list.couple(now, net, forces, watch));
        let momenta = self.parts.bodies.iter().zip(self.rotations());
        self.forces.turning = momenta.map(|(body, now)| now.angular_momentum.dot(body.angular_velocity(&now))).sum();
    }

    /// Nodes have moved to where `node` says; `time`, s, is that of the next step. Returns what is carried, driven or
    /// released, and how it moves now.
    pub fn moved(&mut self, time: f64, node: impl Fn(usize) -> Moving) -> &[(usize, Moving)] {
        self.forces.carried.clear();
        self.forces.turned.clear();
        self.with_now(&Team::default(), time, |list, now, forces, _| {
            for effect in list.all().rev() {
                effect.moved(now, &node, forces);
            }
        });
        std::mem::swap(&mut self.turning, &mut self.forces.turned);
        self.is_first = false;
        &self.forces.carried
    }

    /// Tells effects the positions and velocities of nodes at the start.
    pub fn placed(&mut self, node: impl Fn(usize) -> Moving) {
        for effect in self.list.all() {
            effect.placed(self.parts, &node);
        }
    }

    /// Takes out what belongs to segments that are broken, (segments,).
    pub fn put_broken(&mut self, broken: &[bool]) {
        for segment in (0..broken.len()).filter(|&segment| broken[segment]) {
            for effect in self.list.all() {
                effect.gone(self.parts, segment);
            }
        }
    }

    fn with_now(&mut self, team: &Team, time: f64, work: impl FnOnce(&mut List, &Now, &mut Forces, &mut Watch)) {
        let Effects { parts, factors, list, forces, watch, seen, turning, is_first, .. } = self;
        let now = Now { parts, team, factors: *factors, time, is_first: *is_first, seen, turning };
        work(list, &now, forces, watch);
    }

    /// Sum of the forces of all effects.
    pub fn forces(&self) -> &Forces {
        &self.forces
    }

    /// Energy stored in this state, J, by channel.
    pub fn stored(&self, state: &State) -> ByChannel {
        self.list.stored(self.parts, state)
    }

    /// Memory of all effects.
    pub fn memory(&self) -> Memory {
        self.list.memory()
    }

    /// Restores a memory before the next forces. `is_first`: whether no step was taken before it.
    pub fn remember(&mut self, memory: &Memory, is_first: bool) {
        self.list.remember(memory);
        self.is_first = is_first;
    }

    /// How each body turns: half a step ago and extrapolated to the step, (bodies,).
    pub fn turning(&self) -> &[Turning] {
        &self.turning
    }

    /// Bodies turn like this, (bodies,), whatever they did before.
    pub fn turn(&mut self, turning: Vec<Turning>) {
        self.turning = turning;
    }

    /// How each body turns at the step of the last forces, (bodies,).
    pub fn rotations(&self) -> Vec<Rotation> {
        let turning = self.turning.iter().zip(&self.forces.torque);
        turning.map(|(turning, torque)| turning.at_step(*torque, self.factors)).collect()
    }

    /// The start: half-step angular momenta such that bodies turn as in `rotations` at the step of the last forces.
    pub fn before_start(&mut self, rotations: &[Rotation]) {
        for ((turning, torque), start) in self.turning.iter_mut().zip(&self.forces.torque).zip(rotations) {
            turning.start(start, *torque, self.factors);
        }
    }

    /// How the launch stands.
    pub fn launching(&self) -> Launching {
        self.list.launchers.as_ref().map_or(Launching::default(), |launchers| launchers.launching().clone())
    }
}

//! Forces given on nodes. The law is [`crate::forces::load`].

use super::contract::{Effect, Forces, Net, Now, Resting};
use super::traced::TracedWork;
use crate::channel::{ByChannel, Channel};
use crate::parts::{PartKind, SystemError, SystemParts};
use crate::state::State;

/// Loads in motion: each load that is brought up in time is followed for its work.
#[derive(Debug, Clone)]
pub(super) struct Loads {
    traced: Vec<TracedWork>,
}

impl Effect for Loads {
    const NAME: &'static str = "load";
    const CHANNELS: &'static [Channel] = &[Channel::Load];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        (!parts.loads.is_empty()).then(|| Loads { traced: vec![TracedWork::default(); parts.loads.len()] })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        for (index, load) in parts.loads.iter().enumerate() {
            let is_right = load.force.is_finite() && load.ramp >= 0.0 && load.ramp.is_finite();
            if load.node >= parts.mass.len() || !is_right {
                return Err(SystemError::attached(
                    PartKind::Load,
                    index,
                    load.node,
                    "does not exist, or whose force is not finite",
                ));
            }
        }
        Ok(())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for load in &parts.loads {
            act_on(load.node);
        }
    }

    /// Loads that act from the start, on what is free to move.
    fn at_rest(parts: &SystemParts, resting: &Resting, rest: &mut SystemParts) {
        let steady = parts.loads.iter().filter(|load| load.is_steady());
        rest.loads.extend(steady.filter(|load| !resting.held[load.node]));
    }

    fn act<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        for (load, traced) in now.parts.loads.iter().zip(&mut self.traced) {
            out.force[load.node] += load.at(now.time);
            if !load.is_steady() {
                out.work[Channel::Load] -= traced.work(load.at(now.time), net.node(load.node).x);
            }
        }
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        let steady = parts.loads.iter().filter(|load| load.is_steady());
        let energy = steady.map(|load| load.force.dot(state.position[load.node])).sum::<f64>();
        stored[Channel::Load] += 0.0 - energy;
    }
}

//! Effects of the caller's own, followed for their work. The contract with the caller is [`crate::custom`].

use glam::DVec3;

use super::bound::{Bound, Stiff};
use super::contract::{Effect, Forces, Net, Now};
use super::traced::TracedWork;
use crate::channel::Channel;
use crate::custom::CustomEffect;
use crate::parts::{PartKind, SystemError, SystemParts};

/// Effects of the caller's own in motion. A relaxation leaves them out.
#[derive(Debug, Clone)]
pub(super) struct Customs(Vec<Custom>);

#[derive(Debug, Clone)]
struct Custom {
    effect: Box<dyn CustomEffect>,
    /// The force on each of its nodes.
    traced: Vec<(usize, TracedWork)>,
    /// Its force alone, N, (nodes,).
    force: Vec<DVec3>,
}

impl Effect for Customs {
    const NAME: &'static str = "custom";
    const CHANNELS: &'static [Channel] = &[Channel::Custom];
    type Memory = Vec<Vec<f64>>;

    fn of(parts: &SystemParts) -> Option<Self> {
        let start = |effect: &dyn CustomEffect| Custom {
            traced: effect.nodes().into_iter().map(|node| (node, TracedWork::default())).collect(),
            force: vec![DVec3::ZERO; parts.mass.len()],
            effect: effect.boxed_clone(),
        };
        (!parts.custom.is_empty()).then(|| Customs(parts.custom.iter().map(|effect| start(effect.as_ref())).collect()))
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        for (index, effect) in parts.custom.iter().enumerate() {
            if let Some(node) = effect.nodes().into_iter().find(|&node| node >= parts.mass.len()) {
                return Err(SystemError::attached(PartKind::Custom, index, node, "does not exist"));
            }
        }
        Ok(())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for node in parts.custom.iter().flat_map(|effect| effect.nodes()) {
            act_on(node);
        }
    }

    fn bound(parts: &SystemParts, bound: &mut Bound) {
        for (index, effect) in parts.custom.iter().enumerate() {
            for (node, stiffness, damping) in effect.bound() {
                // it acts between a node and the world: it counts half of what joins two nodes
                let what = Stiff::Effect { name: Self::NAME, index: Some(index) };
                bound.add(node, 0.5 * stiffness, 0.5 * damping, what);
            }
        }
    }

    fn act<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        for Custom { effect, traced, force } in &mut self.0 {
            for (node, _) in &*traced {
                force[*node] = DVec3::ZERO;
            }
            effect.act(now.time, net, force);
            for (node, traced) in traced {
                out.force[*node] += force[*node];
                out.work[Channel::Custom] -= traced.work(force[*node], net.node(*node).x);
            }
        }
    }

    fn memory(&self) -> Vec<Vec<f64>> {
        self.0.iter().map(|custom| custom.effect.memory()).collect()
    }

    fn remember(&mut self, memory: &Vec<Vec<f64>>) {
        for (custom, memory) in self.0.iter_mut().zip(memory) {
            custom.effect.remember(memory);
        }
    }

    fn remembered(memory: &Vec<Vec<f64>>) -> usize {
        memory.len()
    }

    fn to_remember(parts: &SystemParts) -> usize {
        parts.custom.len()
    }
}

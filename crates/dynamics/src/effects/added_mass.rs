//! Inertia of the medium around ropes. The law is [`crate::forces::added_mass`].

use glam::DVec3;

use super::contract::{Effect, Forces, Net, Now};
use super::traced::TracedWork;
use crate::channel::{ByChannel, Channel};
use crate::forces::{added_mass, gravity};
use crate::moving::Moving;
use crate::parts::SystemParts;

/// Ropes that take the medium along.
#[derive(Debug, Clone)]
pub(super) struct AddedMass {
    /// Segments at each node, (nodes,).
    arms: Vec<Vec<Arm>>,
    /// The segments that break at the last forces.
    leaving: Vec<usize>,
    /// The force of the medium's inertia on each node, (nodes,).
    inertia: Vec<TracedWork>,
}

/// A segment that meets others at a node: its other end, its number, and the mass that half of it takes along, kg.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Arm {
    to: usize,
    segment: usize,
    taken_along: f64,
}

impl Effect for AddedMass {
    const NAME: &'static str = "added mass";
    const CHANNELS: &'static [Channel] = &[Channel::AddedMass];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let arms = arms(parts)?;
        Some(AddedMass { inertia: vec![TracedWork::default(); arms.len()], arms, leaving: Vec::new() })
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        if parts.environment.air.as_ref().is_some_and(|air| air.added_mass > 0.0) {
            for node in 0..parts.mass.len() {
                act_on(node);
            }
        }
    }

    fn couple<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        let place = |node: usize| net.node(node).x;
        let mut work = 0.0;
        for (node, (arms, traced)) in self.arms.iter().zip(&mut self.inertia).enumerate() {
            // a node that has lost its last segment still has the force of the step before
            if arms.is_empty() && !traced.is_acting() {
                continue;
            }
            let (mass, at) = (now.parts.mass[node], place(node));
            let weight = gravity::force(now.parts.environment.gravity, mass);
            let others = net.with_ropes(node, out.force[node]) + weight;
            let spans = arms.iter().map(|arm| (arm.taken_along, place(arm.to) - at));
            let inertia = if arms.is_empty() { DVec3::ZERO } else { added_mass::force(mass, others, spans) };
            out.force[node] += inertia;
            work -= traced.work(inertia, at);
        }
        out.work[Channel::AddedMass] += work;
    }

    fn act<N: Net>(&mut self, _: &Now, _: &N, _: &mut Forces) {
        // segments that broke at the last forces break again where these are the same
        self.leaving.clear();
    }

    fn part(&mut self, _: &SystemParts, segment: usize, _: &mut ByChannel) {
        self.leaving.push(segment);
    }

    fn gone(&mut self, parts: &SystemParts, segment: usize) {
        for end in parts.segments[segment].ends {
            self.arms[end].retain(|arm| arm.segment != segment);
        }
    }

    fn moved(&mut self, now: &Now, _: &dyn Fn(usize) -> Moving, _: &mut Forces) {
        for segment in std::mem::take(&mut self.leaving) {
            self.gone(now.parts, segment);
        }
    }
}

/// The segments that take mass along at each node that has mass of its own, (nodes,); none where no rope does.
fn arms(parts: &SystemParts) -> Option<Vec<Vec<Arm>>> {
    let air = parts.environment.air.as_ref().filter(|air| air.added_mass > 0.0)?;
    let mut arms = vec![Vec::new(); parts.mass.len()];
    let displaced = air.added_mass * air.medium.density(0.0) * std::f64::consts::FRAC_PI_4;
    for (segment, s) in parts.segments.iter().enumerate() {
        let Some(rope) = air.ropes[s.group] else { continue };
        let taken_along = 0.5 * displaced * rope.diameter * rope.diameter * s.rest_length;
        for end in s.ends {
            if parts.mass[end] > 0.0 && !parts.held[end] {
                arms[end].push(Arm { to: s.other_end(end), segment, taken_along });
            }
        }
    }
    Some(arms)
}

//! Where ropes resist bending. The law is [`crate::forces::bending`]; a bend goes with a segment under it that breaks.

use std::collections::BTreeMap;

use super::bound::{Bound, Stiff};
use super::contract::{Effect, Forces, Net, Now, Resting};
use super::elements::{self, Elements};
use crate::channel::{ByChannel, Channel};
use crate::forces::element::Element;
use crate::parts::{PartKind, SystemError, SystemParts};
use crate::state::State;

/// Bends in motion.
#[derive(Debug, Clone)]
pub(super) struct Bends {
    elements: Elements<3>,
    /// The bends over each segment that has some.
    over: BTreeMap<usize, Vec<usize>>,
}

impl Effect for Bends {
    const NAME: &'static str = "bending";
    const CHANNELS: &'static [Channel] = &[Channel::Elastic, Channel::RopeDamping, Channel::Rupture];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let elements = || Elements::new(parts.bends.iter().map(Element::nodes).collect());
        (!parts.bends.is_empty()).then(|| Bends { elements: elements(), over: bends_over(parts) })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        elements::check(PartKind::Bend, &parts.bends, parts.mass.len())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for node in parts.bends.iter().flat_map(Element::nodes) {
            act_on(node);
        }
    }

    fn asks(parts: &SystemParts, ask: &mut dyn FnMut(usize)) {
        Bends::nodes(parts, ask);
    }

    fn bound(parts: &SystemParts, bound: &mut Bound) {
        for (index, bend) in parts.bends.iter().enumerate() {
            bound.add_element(bend, Stiff::Effect { name: Self::NAME, index: Some(index) });
        }
    }

    fn at_rest(parts: &SystemParts, _: &Resting, rest: &mut SystemParts) {
        rest.bends = parts.bends.clone();
    }

    fn joins(parts: &SystemParts, join: &mut dyn FnMut(usize, usize)) {
        for [a, b, c] in parts.bends.iter().map(Element::nodes) {
            join(a, b);
            join(a, c);
        }
    }

    fn act<N: Net>(&mut self, now: &Now, _: &N, out: &mut Forces) {
        let (bends, seen) = (&now.parts.bends, now.seen);
        let work = self.elements.pull(now.team, |i, x, w| bends[i].pull(x, w), |node| seen[node], &mut out.force);
        out.work[Channel::RopeDamping] += work;
    }

    fn part(&mut self, parts: &SystemParts, segment: usize, work: &mut ByChannel) {
        for &bend in self.over.get(&segment).into_iter().flatten() {
            if let Some(place) = self.elements.leave(bend) {
                work[Channel::Rupture] += parts.bends[bend].elastic_energy(place);
            }
        }
    }

    fn gone(&mut self, _: &SystemParts, segment: usize) {
        for &bend in self.over.get(&segment).into_iter().flatten() {
            self.elements.remove(bend);
        }
    }

    fn moved(&mut self, _: &Now, _: &dyn Fn(usize) -> crate::moving::Moving, _: &mut Forces) {
        self.elements.remove_leaving();
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        stored[Channel::Elastic] += self.elements.stored(&parts.bends, &state.position);
    }
}

/// The bends over each segment. Where several segments join two nodes of a bend the first is the piece of its rope.
fn bends_over(parts: &SystemParts) -> BTreeMap<usize, Vec<usize>> {
    let (mut between, mut over) = (BTreeMap::new(), BTreeMap::<usize, Vec<usize>>::new());
    let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    for (index, segment) in parts.segments.iter().enumerate() {
        between.entry(sorted(segment.ends)).or_insert(index);
    }
    for (index, bend) in parts.bends.iter().enumerate() {
        let [before, at, after] = bend.nodes();
        for segment in [[before, at], [at, after]].into_iter().filter_map(|ends| between.get(&sorted(ends))) {
            over.entry(*segment).or_default().push(index);
        }
    }
    over
}

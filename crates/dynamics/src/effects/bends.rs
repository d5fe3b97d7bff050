//! Where ropes resist bending. The law is [`crate::forces::bending`]; a bend goes with a segment under it that breaks.

use std::collections::BTreeMap;

use super::bound::{Bound, Stiff};
use super::contract::{Effect, Forces, Net, Now, Resting};
use super::elements::{self, Elements};
use crate::channel::{ByChannel, Channel};
use crate::forces::element::Element;
use crate::forces::segment::Segment;
use crate::parts::{PartKind, SystemError, SystemParts};
use crate::state::State;

/// Bends in motion: inside ropes, and at clamped ends.
#[derive(Debug, Clone)]
pub(super) struct Bends {
    inside: OverSegments<3>,
    clamped: OverSegments<2>,
}

/// Elements, each of which leaves with the first of the segments under it that breaks.
#[derive(Debug, Clone)]
struct OverSegments<const N: usize> {
    elements: Elements<N>,
    /// The elements over each segment that has some.
    over: BTreeMap<usize, Vec<usize>>,
}

impl<const N: usize> OverSegments<N> {
    fn new<E: Element<N>>(elements: &[E], segments: &[Segment]) -> Self {
        let nodes: Vec<[usize; N]> = elements.iter().map(Element::nodes).collect();
        OverSegments { over: over(segments, &nodes), elements: Elements::new(nodes) }
    }

    /// Takes out the elements over a segment that breaks. Returns the energy that they held, J.
    fn part<E: Element<N>>(&mut self, elements: &[E], segment: usize) -> f64 {
        let leaving = self.over.get(&segment).into_iter().flatten();
        leaving.filter_map(|&index| Some(elements[index].elastic_energy(self.elements.leave(index)?))).sum()
    }

    fn gone(&mut self, segment: usize) {
        for &index in self.over.get(&segment).into_iter().flatten() {
            self.elements.remove(index);
        }
    }
}

impl Effect for Bends {
    const NAME: &'static str = "bending";
    const CHANNELS: &'static [Channel] = &[Channel::Elastic, Channel::RopeDamping, Channel::Rupture];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let SystemParts { bends, clamps, segments, .. } = parts;
        let some = !(bends.is_empty() && clamps.is_empty());
        some.then(|| Bends { inside: OverSegments::new(bends, segments), clamped: OverSegments::new(clamps, segments) })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        elements::check(PartKind::Bend, &parts.bends, parts.mass.len())?;
        elements::check(PartKind::Clamp, &parts.clamps, parts.mass.len())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for node in parts.bends.iter().flat_map(Element::nodes).chain(parts.clamps.iter().flat_map(Element::nodes)) {
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
        for clamp in &parts.clamps {
            bound.add_element(clamp, Stiff::Effect { name: Self::NAME, index: None });
        }
    }

    fn at_rest(parts: &SystemParts, _: &Resting, rest: &mut SystemParts) {
        rest.bends = parts.bends.clone();
        rest.clamps = parts.clamps.clone();
    }

    fn joins(parts: &SystemParts, join: &mut dyn FnMut(usize, usize)) {
        for [a, b, c] in parts.bends.iter().map(Element::nodes) {
            join(a, b);
            join(a, c);
        }
    }

    fn act<N: Net>(&mut self, now: &Now, _: &N, out: &mut Forces) {
        let (SystemParts { bends, clamps, .. }, seen) = (now.parts, |node: usize| now.seen[node]);
        let of_bend = |i: usize, x, w| bends[i].pull(x, w);
        out.work[Channel::RopeDamping] += self.inside.elements.pull(now.team, of_bend, seen, &mut out.force);
        let of_clamp = |i: usize, x, w| clamps[i].pull(x, w);
        out.work[Channel::RopeDamping] += self.clamped.elements.pull(now.team, of_clamp, seen, &mut out.force);
    }

    fn part(&mut self, parts: &SystemParts, segment: usize, work: &mut ByChannel) {
        work[Channel::Rupture] += self.inside.part(&parts.bends, segment);
        work[Channel::Rupture] += self.clamped.part(&parts.clamps, segment);
    }

    fn gone(&mut self, _: &SystemParts, segment: usize) {
        self.inside.gone(segment);
        self.clamped.gone(segment);
    }

    fn moved(&mut self, _: &Now, _: &dyn Fn(usize) -> crate::moving::Moving, _: &mut Forces) {
        self.inside.elements.remove_leaving();
        self.clamped.elements.remove_leaving();
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        stored[Channel::Elastic] += self.inside.elements.stored(&parts.bends, &state.position);
        stored[Channel::Elastic] += self.clamped.elements.stored(&parts.clamps, &state.position);
    }
}

/// The elements over each segment: those whose nodes, in their order, it joins. Where several segments join two nodes the
/// first is the piece of the rope.
fn over<const N: usize>(segments: &[Segment], elements: &[[usize; N]]) -> BTreeMap<usize, Vec<usize>> {
    let (mut between, mut over) = (BTreeMap::new(), BTreeMap::<usize, Vec<usize>>::new());
    let sorted = |a: usize, b: usize| [a.min(b), a.max(b)];
    for (index, Segment { ends: [a, b], .. }) in segments.iter().enumerate() {
        between.entry(sorted(*a, *b)).or_insert(index);
    }
    for (index, nodes) in elements.iter().enumerate() {
        for segment in nodes.windows(2).filter_map(|ends| between.get(&sorted(ends[0], ends[1]))) {
            over.entry(*segment).or_default().push(index);
        }
    }
    over
}

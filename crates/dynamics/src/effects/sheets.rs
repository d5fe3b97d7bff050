//! Sheets: their triangles in their plane, and what resists bending along the edges between these. The laws are
//! [`crate::forces::membrane`] and [`crate::forces::hinge`].

use super::bound::{Bound, Stiff};
use super::contract::{Effect, Forces, Net, Now, Resting};
use super::elements::{self, Elements};
use crate::channel::{ByChannel, Channel};
use crate::forces::element::Element;
use crate::parts::{PartKind, SystemError, SystemParts};
use crate::state::State;

/// Triangles in motion.
#[derive(Debug, Clone)]
pub(super) struct Membranes(Elements<3>);

/// Edges in motion.
#[derive(Debug, Clone)]
pub(super) struct Hinges(Elements<4>);

impl Effect for Membranes {
    const NAME: &'static str = "sheet";
    const CHANNELS: &'static [Channel] = &[Channel::Elastic, Channel::SheetDamping];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let elements = || Elements::new(parts.membranes.iter().map(Element::nodes).collect());
        (!parts.membranes.is_empty()).then(|| Membranes(elements()))
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        elements::check(PartKind::Membrane, &parts.membranes, parts.mass.len())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for node in parts.membranes.iter().flat_map(Element::nodes) {
            act_on(node);
        }
    }

    fn asks(parts: &SystemParts, ask: &mut dyn FnMut(usize)) {
        Membranes::nodes(parts, ask);
    }

    fn bound(parts: &SystemParts, bound: &mut Bound) {
        for (index, membrane) in parts.membranes.iter().enumerate() {
            bound.add_element(membrane, Stiff::Effect { name: Self::NAME, index: Some(index) });
        }
    }

    fn at_rest(parts: &SystemParts, _: &Resting, rest: &mut SystemParts) {
        rest.membranes = parts.membranes.clone();
    }

    fn joins(parts: &SystemParts, join: &mut dyn FnMut(usize, usize)) {
        for [a, b, c] in parts.membranes.iter().map(Element::nodes) {
            join(a, b);
            join(a, c);
        }
    }

    fn act<N: Net>(&mut self, now: &Now, _: &N, out: &mut Forces) {
        let (membranes, seen) = (&now.parts.membranes, now.seen);
        let work = self.0.pull(now.team, |i, x, w| membranes[i].pull(x, w), |node| seen[node], &mut out.force);
        out.work[Channel::SheetDamping] += work;
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        stored[Channel::Elastic] += self.0.stored(&parts.membranes, &state.position);
    }
}

impl Effect for Hinges {
    const NAME: &'static str = "bending of a sheet";
    const CHANNELS: &'static [Channel] = &[Channel::Elastic, Channel::SheetDamping];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let elements = || Elements::new(parts.hinges.iter().map(Element::nodes).collect());
        (!parts.hinges.is_empty()).then(|| Hinges(elements()))
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        elements::check(PartKind::Hinge, &parts.hinges, parts.mass.len())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for node in parts.hinges.iter().flat_map(Element::nodes) {
            act_on(node);
        }
    }

    fn asks(parts: &SystemParts, ask: &mut dyn FnMut(usize)) {
        Hinges::nodes(parts, ask);
    }

    fn bound(parts: &SystemParts, bound: &mut Bound) {
        for (index, hinge) in parts.hinges.iter().enumerate() {
            bound.add_element(hinge, Stiff::Effect { name: Self::NAME, index: Some(index) });
        }
    }

    fn at_rest(parts: &SystemParts, _: &Resting, rest: &mut SystemParts) {
        rest.hinges = parts.hinges.clone();
    }

    fn act<N: Net>(&mut self, now: &Now, _: &N, out: &mut Forces) {
        let (hinges, seen) = (&now.parts.hinges, now.seen);
        let work = self.0.pull(now.team, |i, x, w| hinges[i].pull(x, w), |node| seen[node], &mut out.force);
        out.work[Channel::SheetDamping] += work;
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        stored[Channel::Elastic] += self.0.stored(&parts.hinges, &state.position);
    }
}

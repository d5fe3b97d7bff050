//! Forces on a net that flies beside an orbit. The law is [`crate::forces::orbit`].

use glam::DVec3;

use super::contract::{Effect, Forces, Net, Now};
use crate::channel::{ByChannel, Channel};
use crate::forces::orbit::Orbit;
use crate::parts::{SystemError, SystemParts};
use crate::state::State;

/// An orbit that a net flies beside. A relaxation leaves it out.
#[derive(Debug, Clone)]
pub(super) struct BesideOrbit(Orbit);

impl Effect for BesideOrbit {
    const NAME: &'static str = "orbit";
    const CHANNELS: &'static [Channel] = &[Channel::Orbit];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        parts.environment.orbit.map(BesideOrbit)
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        let Some(Orbit { mean_motion, radial, along }) = parts.environment.orbit else { return Ok(()) };
        let is_unit = |way: DVec3| (way.length_squared() - 1.0).abs() < 1e-9;
        let has_axes = is_unit(radial) && is_unit(along) && radial.dot(along).abs() < 1e-9;
        if !(mean_motion >= 0.0 && mean_motion.is_finite() && has_axes) {
            return Err(SystemError::Environment { what: "mean motion, 1/s, or one of its axes", value: mean_motion });
        }
        Ok(())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        if parts.environment.orbit.is_some() {
            for node in 0..parts.mass.len() {
                act_on(node);
            }
        }
    }

    fn act<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        for (node, (force, &mass)) in out.force.iter_mut().zip(&now.parts.mass).enumerate() {
            let moving = net.node(node);
            *force += mass * self.0.acceleration(moving.x, moving.w);
        }
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        let masses = state.position.iter().zip(&parts.mass);
        stored[Channel::Orbit] += masses.map(|(x, mass)| self.0.energy(*mass, *x)).sum::<f64>();
    }
}

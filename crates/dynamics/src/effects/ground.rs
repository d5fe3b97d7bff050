//! The ground under nodes and under the hulls of rigid bodies. The law is [`crate::forces::ground`].

use glam::{DQuat, DVec3};

use super::bound::{Bound, lever};
use super::contract::{Effect, Forces, Net, Now, Resting, seen};
use super::elements::Elements;
use crate::body::Rotation;
use crate::channel::{ByChannel, Channel};
use crate::forces::ground::{Footing, Ground, Hull, Spring};
use crate::moving::Turning;
use crate::parts::{PartKind, SystemError, SystemParts};
use crate::state::State;

/// Name in the step bound of nodes and of bodies alike.
const NAME: &str = "ground";

/// Nodes that the ground can touch.
#[derive(Debug, Clone)]
pub(super) struct Footings(Elements<1>);

impl Effect for Footings {
    const NAME: &'static str = NAME;
    const CHANNELS: &'static [Channel] = &[Channel::Ground, Channel::GroundFriction];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let ground = parts.environment.ground.as_ref().filter(|ground| !ground.nodes.is_empty())?;
        Some(Footings(Elements::new(ground.nodes.iter().map(|at| [at.node]).collect())))
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        let Some(ground) = &parts.environment.ground else { return Ok(()) };
        for (index, footing) in ground.nodes.iter().enumerate() {
            if parts.mass.get(footing.node).is_none_or(|&mass| mass == 0.0) || !footing.radius.is_finite() {
                return Err(SystemError::attached(
                    PartKind::Footing,
                    index,
                    footing.node,
                    "does not exist, or has no mass",
                ));
            }
        }
        let springs = ground.nodes.iter().map(|at| at.spring).chain(ground.hulls.iter().map(|hull| hull.spring));
        let values = springs.flat_map(|Spring { stiffness, damping, mass }| [stiffness, damping, mass]);
        let wrong =
            values.chain([ground.friction, ground.height.abs()]).find(|value| !(*value >= 0.0 && value.is_finite()));
        wrong.map_or(Ok(()), |value| Err(SystemError::Environment { what: "ground, in one of its numbers,", value }))
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for (_, at) in footings(parts) {
            act_on(at.node);
        }
    }

    fn bound_carried(parts: &SystemParts, bound: &mut Bound) {
        for (_, at) in footings(parts) {
            bound.add_contact(NAME, at.node, 0.5, &at.spring);
        }
    }

    /// It bears and does not rub, for friction would keep what only friction keeps.
    fn at_rest(parts: &SystemParts, resting: &Resting, rest: &mut SystemParts) {
        let Some(ground) = &parts.environment.ground else { return };
        let free = ground.nodes.iter().filter(|at| !resting.held[at.node]);
        let nodes = free.map(|at| Footing { spring: damped(at.spring, resting), ..*at }).collect();
        let hulls = ground.hulls.iter().filter_map(|hull| {
            let body = resting.turning_body(hull.body)?;
            Some(Hull { body, spring: damped(hull.spring, resting), ..*hull })
        });
        rest.environment.ground = Some(Ground { friction: 0.0, nodes, hulls: hulls.collect(), height: ground.height });
    }

    fn bears(parts: &SystemParts, bear: &mut dyn FnMut(usize)) {
        for (_, at) in footings(parts) {
            bear(at.node);
        }
    }

    fn act<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        let Some(ground) = &now.parts.environment.ground else { return };
        let push = |i: usize, [x]: [DVec3; 1], [v]: [DVec3; 1]| {
            let footing = &ground.nodes[i];
            ground.push(&footing.spring, footing.lowest(x), v, now.factors.dt)
        };
        let work = self.0.pull(now.team, push, |node| seen(net.node(node)), &mut out.force);
        out.work[Channel::GroundFriction] += work;
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        let of_one = |(ground, at): (&Ground, &Footing)| ground.energy(&at.spring, at.lowest(state.position[at.node]));
        stored[Channel::Ground] += footings(parts).map(of_one).sum::<f64>();
    }
}

/// Each node that the ground can touch, with the ground.
fn footings(parts: &SystemParts) -> impl Iterator<Item = (&Ground, &Footing)> {
    parts.environment.ground.iter().flat_map(|ground| ground.nodes.iter().map(move |at| (ground, at)))
}

/// Each point of a rigid body that the ground can touch, with the ground.
fn hulls(parts: &SystemParts) -> impl Iterator<Item = (&Ground, &Hull)> {
    parts.environment.ground.iter().flat_map(|ground| ground.hulls.iter().map(move |hull| (ground, hull)))
}

/// A spring for a relaxation, damped as all springs are there.
fn damped(spring: Spring, resting: &Resting) -> Spring {
    Spring { damping: resting.damping_time * spring.stiffness, ..spring }
}

/// Rigid bodies that the ground can touch: the dissipative force on each point of a hull, N, and how its body lay, at
/// the last forces.
#[derive(Debug, Clone)]
pub(super) struct Hulls(Vec<(DVec3, Placed)>);

/// A body where its hull touches: its centre and how it is turned.
#[derive(Debug, Clone, Copy)]
struct Placed {
    centre: DVec3,
    orientation: DQuat,
}

impl Placed {
    const NOWHERE: Placed = Placed { centre: DVec3::ZERO, orientation: DQuat::IDENTITY };

    /// The way of what touches at `hull`, m, since `before`: a sphere rolls on, and is turned under its lowest point.
    fn way(&self, before: &Placed, hull: &Hull) -> DVec3 {
        let turn = self.orientation * before.orientation.inverse();
        let angle = 2.0 * turn.w.signum() * DVec3::new(turn.x, turn.y, turn.z);
        let arm = self.orientation * hull.arm - before.orientation * hull.arm;
        (self.centre - before.centre) + arm - angle.cross(hull.radius * DVec3::Z)
    }
}

impl Effect for Hulls {
    const NAME: &'static str = "ground under bodies";
    const CHANNELS: &'static [Channel] = &[Channel::Ground, Channel::GroundFriction];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        let count = hulls(parts).count();
        (count > 0).then(|| Hulls(vec![(DVec3::ZERO, Placed::NOWHERE); count]))
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        for (index, (_, hull)) in hulls(parts).enumerate() {
            if hull.body >= parts.bodies.len() || !(hull.arm.is_finite() && hull.radius.is_finite()) {
                return Err(SystemError::attached(PartKind::Hull, index, hull.body, "is no body"));
            }
        }
        Ok(())
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for (_, hull) in hulls(parts) {
            act_on(parts.bodies[hull.body].centre);
        }
    }

    fn bound_carried(parts: &SystemParts, bound: &mut Bound) {
        for (_, hull) in hulls(parts) {
            let body = &parts.bodies[hull.body];
            bound.add_contact(NAME, body.centre, 0.5 * lever(parts, body, hull.reach()), &hull.spring);
        }
    }

    fn bears(parts: &SystemParts, bear: &mut dyn FnMut(usize)) {
        Hulls::nodes(parts, bear);
    }

    fn couple<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        let mut work = 0.0;
        for ((ground, hull), last) in hulls(now.parts).zip(&mut self.0) {
            let body = &now.parts.bodies[hull.body];
            let Turning { half_step, extrapolated } = now.turning[hull.body];
            let rotation = Rotation { angular_momentum: extrapolated, ..half_step };
            let (x, w) = seen(net.node(body.centre));
            let (place, velocity) = hull.moving(body, &rotation, x, w);
            let push = ground.push(&hull.spring, place, velocity, now.factors.dt);
            let ([elastic], [dissipative]) = (push.elastic, push.dissipative);
            let force = elastic + dissipative;
            if force != DVec3::ZERO {
                out.force[body.centre] += force;
                out.torque[hull.body] += (place - x).cross(force);
            }
            let placed = Placed { centre: x, orientation: rotation.orientation };
            let before = std::mem::replace(last, (dissipative, placed));
            work -= 0.5 * (before.0 + dissipative).dot(placed.way(&before.1, hull));
        }
        out.work[Channel::GroundFriction] += work;
    }

    fn stored(&self, parts: &SystemParts, state: &State, stored: &mut ByChannel) {
        let of_one = |(ground, hull): (&Ground, &Hull)| {
            let centre = state.position[parts.bodies[hull.body].centre];
            ground.energy(&hull.spring, centre + hull.offset(&state.rotation[hull.body]))
        };
        stored[Channel::Ground] += hulls(parts).map(of_one).sum::<f64>();
    }
}

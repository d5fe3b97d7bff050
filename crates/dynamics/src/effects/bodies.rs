//! Rigid bodies: they take up what pulls at their ties, turn, and take their ties along. The law is [`crate::body`].

use glam::DVec3;

use super::bound::{Bound, lever};
use super::contract::{Effect, Forces, Net, Now};
use crate::body::{Body, Rotation};
use crate::channel::Channel;
use crate::moving::{Moving, Turning};
use crate::parts::{PartKind, SystemError, SystemParts};

/// Rigid bodies in motion; how they turn is in [`Now::turning`].
#[derive(Debug, Clone)]
pub(super) struct Bodies {
    /// How every tie of every body moves, in order.
    ties: Vec<Moving>,
}

impl Effect for Bodies {
    const NAME: &'static str = "body";
    const CHANNELS: &'static [Channel] = &[Channel::Kinetic];
    type Memory = ();

    fn of(parts: &SystemParts) -> Option<Self> {
        (!parts.bodies.is_empty()).then(|| Bodies { ties: Vec::new() })
    }

    fn check(parts: &SystemParts) -> Result<(), SystemError> {
        let nodes = parts.mass.len();
        let mut taken = vec![false; nodes];
        for (index, body) in parts.bodies.iter().enumerate() {
            if body.centre >= nodes || !(body.inertia.is_finite() && body.inertia.min_element() > 0.0) {
                let why = "does not exist, or about which there is no inertia";
                return Err(SystemError::attached(PartKind::Body, index, body.centre, why));
            }
            for tie in &body.ties {
                if tie.node >= nodes || parts.held[tie.node] || taken[tie.node] || !tie.arm.is_finite() {
                    let why = "does not exist, is held, or is tied to a body already";
                    return Err(SystemError::attached(PartKind::Body, index, tie.node, why));
                }
                taken[tie.node] = true;
            }
        }
        match parts.bodies.iter().enumerate().find(|(_, body)| taken[body.centre]) {
            Some((index, body)) => {
                Err(SystemError::attached(PartKind::Body, index, body.centre, "is its centre and tied to a body"))
            }
            None => Ok(()),
        }
    }

    fn nodes(parts: &SystemParts, act_on: &mut dyn FnMut(usize)) {
        for body in &parts.bodies {
            act_on(body.centre);
        }
    }

    /// Stiffness and damping at a tie act on the body.
    fn bound_carried(parts: &SystemParts, bound: &mut Bound) {
        for body in &parts.bodies {
            for tie in &body.ties {
                bound.pass(tie.node, body.centre, lever(parts, body, tie.arm.length()));
            }
        }
    }

    fn joins(parts: &SystemParts, join: &mut dyn FnMut(usize, usize)) {
        for body in &parts.bodies {
            for tie in &body.ties {
                join(tie.node, body.centre);
            }
        }
    }

    fn couple<N: Net>(&mut self, now: &Now, net: &N, out: &mut Forces) {
        for (index, body) in now.parts.bodies.iter().enumerate() {
            for tie in &body.ties {
                let force = net.with_ropes(tie.node, out.force[tie.node]);
                out.force[body.centre] += force;
                out.torque[index] += (net.node(tie.node).x - net.node(body.centre).x).cross(force);
            }
        }
    }

    fn placed(&mut self, parts: &SystemParts, node: &dyn Fn(usize) -> Moving) {
        self.ties = parts.bodies.iter().flat_map(|body| &body.ties).map(|tie| node(tie.node)).collect();
    }

    fn moved(&mut self, now: &Now, node: &dyn Fn(usize) -> Moving, out: &mut Forces) {
        let mut ties = self.ties.iter_mut();
        for ((body, turning), torque) in now.parts.bodies.iter().zip(now.turning).zip(&out.torque) {
            let mut turning = *turning;
            turning.advance(body, *torque, now.factors);
            out.turned.push(turning);
            let carried = out.carried.iter().find(|(carried, _)| *carried == body.centre);
            let centre = carried.map_or_else(|| node(body.centre), |(_, moving)| *moving);
            for_each_tie(body, &turning, centre, |node, moving| {
                let tie = ties.next().expect("every tie was placed");
                *tie = Moving { v: (moving.x - tie.x) / now.factors.dt, ..moving };
                out.carried.push((node, *tie));
            });
        }
    }
}

/// The velocities of ties at a step, m/s, (nodes,): those of their bodies.
pub(crate) fn carried_velocities(bodies: &[Body], rotation: &[Rotation], position: &[DVec3], velocity: &mut [DVec3]) {
    for (body, rotation) in bodies.iter().zip(rotation) {
        let spin = body.angular_velocity(rotation);
        for tie in &body.ties {
            velocity[tie.node] = velocity[body.centre] + spin.cross(position[tie.node] - position[body.centre]);
        }
    }
}

/// Calls `put` with each of a body's ties and how it moves at a step, where the body's centre moves like `centre`; both
/// velocities are those of the step.
pub(crate) fn for_each_tie(body: &Body, turning: &Turning, centre: Moving, mut put: impl FnMut(usize, Moving)) {
    let orientation = turning.half_step.orientation;
    let spin = body.angular_velocity(&Rotation { orientation, angular_momentum: turning.extrapolated });
    for tie in &body.ties {
        let arm = orientation * tie.arm;
        let w = centre.w + spin.cross(arm);
        put(tie.node, Moving { x: centre.x + arm, v: w, w });
    }
}

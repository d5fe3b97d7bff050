//! The state at the start in the form that the first step needs.

use crate::effects::for_each_tie;
use crate::moving::{Moving, Turning};
use crate::state::State;
use crate::system::System;
use glam::DVec3;

/// Held nodes rest, ties follow their bodies, and driven nodes move along their paths. `dt` is the step, s.
pub(super) fn started(system: &System, state: &State, dt: f64) -> State {
    let mut state = state.clone();
    for (velocity, _) in state.velocity.iter_mut().zip(system.held()).filter(|(_, held)| **held) {
        *velocity = DVec3::ZERO;
    }
    for drive in system.drives() {
        let first = drive.at(0.0);
        (state.position[drive.node], state.velocity[drive.node]) = (first, (drive.at(dt) - first) / dt);
    }
    for (body, rotation) in system.bodies().iter().zip(&state.rotation) {
        let (x, v) = (state.position[body.centre], state.velocity[body.centre]);
        let centre = Moving { x, v, w: v };
        for_each_tie(body, &Turning::starting(*rotation), centre, |tie, moving| {
            (state.position[tie], state.velocity[tie]) = (moving.x, moving.w);
        });
    }
    state
}

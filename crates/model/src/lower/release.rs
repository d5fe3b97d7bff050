//! Release of the net: tractors leave their launchers, covers open, a late sector comes free. Also the spin at the start.

use glam::DVec3;
use netcast_dynamics::launcher::{Launcher, Means, Tube};
use netcast_dynamics::state::State;
use netcast_dynamics::system::SystemParts;
use netcast_scenario::{Diagnostics, Scenario};
use netcast_webs::Sector;

use super::draft::Draft;
use super::selection::unknown_knot;
use super::throw::{Throw, Thrown};

/// Gives tractors their velocities or launchers, and adds the spin of the whole net.
pub fn launch(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { scenario, throws, parts, state, frame, falls, .. } = draft;
    throw(throws, parts, state);
    let turning = scenario.launch.as_ref().map_or(0.0, |launch| launch.spin.si());
    spin(turning * (*frame * DVec3::Z), parts, state);
    *falls = !parts.held.contains(&true);
    Ok(())
}

/// Gives each tractor its velocity, or a launcher that drives it later. A held tractor stays at rest.
fn throw(throws: &mut [Option<Throw>], parts: &mut SystemParts, state: &mut State) {
    for throw in throws.iter_mut().flatten().filter(|throw| !parts.held[throw.node]) {
        let (node, delay, direction) = (throw.node, throw.delay, throw.direction);
        let by = match &throw.by {
            Thrown::At(velocity) if delay > 0.0 => Means::Velocity(*velocity),
            Thrown::At(velocity) => {
                state.velocity[node] = *velocity;
                continue;
            }
            Thrown::From { stroke, push } => {
                let breech = state.position[node];
                Means::Tube(Tube { breech, direction, stroke: *stroke, push: push.clone() })
            }
        };
        state.velocity[node] = DVec3::ZERO;
        throw.launcher = Some(parts.launchers.len());
        parts.launchers.push(Launcher { node, at: delay, by });
    }
}

/// Adds the velocities of a rigid rotation about the origin; `angular_velocity` in rad/s, world frame.
fn spin(angular_velocity: DVec3, parts: &SystemParts, state: &mut State) {
    if angular_velocity == DVec3::ZERO {
        return;
    }
    for (velocity, position) in state.velocity.iter_mut().zip(&state.position) {
        *velocity += angular_velocity.cross(*position);
    }
    for (body, rotation) in parts.bodies.iter().zip(&mut state.rotation) {
        *rotation = body.turning(rotation.orientation, angular_velocity);
    }
}

/// Holds nodes under covers and in a late sector. Each starts when the last of its covers opens.
///
/// # Errors
/// An unknown node, or a tractor under a cover.
pub fn hold_back(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, tractors, notes, parts, state, .. } = draft;
    let mut opens = vec![0.0f64; parts.mass.len()];
    let mut is_web = cut.is_web();
    is_web.resize(parts.mass.len(), true);
    for &node in &*tractors {
        is_web[node] = false;
    }
    let mut found = Vec::new();
    for (index, cover) in scenario.covers.iter().enumerate() {
        let mut put = |node: usize| opens[node] = opens[node].max(cover.opens.si());
        let Some(named) = &cover.nodes else {
            for node in (0..is_web.len()).filter(|&node| is_web[node]) {
                put(node);
            }
            continue;
        };
        for (place, id) in named.iter().enumerate() {
            match cut.web.knot_named(id) {
                Some(knot) if tractors.contains(&knot) || parts.mass[knot] == 0.0 => {
                    let message = format!("{id:?} is a tractor, which is not covered");
                    found.push(document.diagnostic(&format!("covers.{index}.nodes.{place}"), message));
                }
                Some(knot) => put(knot),
                None => found.push(unknown_knot(document, &format!("covers.{index}.nodes.{place}"), id, cut)),
            }
        }
    }
    Diagnostics::fail_if_any(found)?;
    if let Some((sector, until)) = late_sector(scenario) {
        let mut late = 0;
        for (node, _) in sector.of(cut).iter().enumerate().filter(|&(node, &is_in)| is_in && is_web[node]) {
            opens[node] = opens[node].max(until);
            late += 1;
        }
        let Sector { direction, width } = sector;
        notes.push(format!(
            "a sector {:.0} deg wide about {:.0} deg from x of the flat web, {late} nodes, is held where it is stowed until \
             {until} s",
            width.to_degrees(),
            direction.to_degrees()
        ));
    }
    for (node, &at) in opens.iter().enumerate() {
        // a node without mass moves with its rigid body
        if at > 0.0 && !parts.held[node] && parts.mass[node] > 0.0 {
            state.velocity[node] = DVec3::ZERO;
            parts.launchers.push(Launcher { node, at, by: Means::Velocity(DVec3::ZERO) });
        }
    }
    Ok(())
}

/// The late sector of the web and the time of its release, s; none if the scenario has none.
fn late_sector(scenario: &Scenario) -> Option<(Sector, f64)> {
    let imperfection = scenario.stow.as_ref()?.imperfection.as_ref()?;
    let late = imperfection.late_sector.as_ref()?;
    let width = late.width.si();
    let sector = match late.direction {
        Some(direction) => Sector { direction: direction.si(), width },
        None => Sector::by_chance(width, imperfection.seed.into()),
    };
    Some((sector, late.until.si()))
}

//! Tractors as rigid bodies. Each has a node at its centre of mass and carries the knot that its ropes are tied to.
//!
//! A tractor whose ropes are tied at its centre of mass feels no torque and stays a mass on its knot. The mass of the last
//! rope segments on the knot adds to the mass of the body, not to its inertia.

use glam::{DMat3, DQuat, DVec3};
use netcast_dynamics::body::{Body, Tie};
use netcast_scenario::{Attitude, Diagnostics, Scenario, TiedAt};
use netcast_webs::CutWeb;

use super::draft::Draft;
use super::members::{PlacedBody, Role};
use super::throw::Throw;

/// Makes a rigid body of each tractor that is tied away from its centre, and moves the tractor to a new node there.
///
/// # Errors
/// A tractor that is held or has no size.
pub fn make_rigid(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, throws, bodies: placed, parts, state, .. } = draft;
    let mut found = Vec::new();
    let tractors = placed.iter_mut().filter(|body| body.role == Role::Tractor);
    for body in tractors {
        let knot = body.node;
        let Some(index) = cut.web.tractors.iter().position(|tractor| *tractor == knot) else { continue };
        let Some((arm, path)) = arm(scenario, index as u32 + 1, body) else { continue };
        let Some(inertia) = body.solid.inertia_kg_m2().filter(|_| !parts.held[knot]) else {
            let (message, help) = if parts.held[knot] {
                ("the corner that it is tied to is held by [hold]", "tie it at its centre")
            } else {
                ("a particle has a centre only", "give it a size, such as [tractor.cylinder]")
            };
            found.push(document.diagnostic(&path, format!("tractor {}: {message}", index + 1)).with_help(help));
            continue;
        };
        let orientation = at_launch(cut, scenario, throws[index].as_ref(), index);
        let centre = parts.mass.len();
        let mass = std::mem::take(&mut parts.mass[knot]);
        parts.mass.push(mass);
        parts.held.push(false);
        parts.tractor[knot] = false;
        parts.tractor.push(true);
        parts.bodies.push(Body { centre, inertia, ties: vec![Tie { node: knot, arm }] });
        state.position.push(state.position[knot] - orientation * arm);
        state.velocity.push(state.velocity[knot]);
        let rotation = parts.bodies[parts.bodies.len() - 1].turning(orientation, DVec3::ZERO);
        state.rotation.push(rotation);
        (body.node, body.rigid) = (centre, Some(parts.bodies.len() - 1));
    }
    Diagnostics::fail_if_any(found)
}

/// Moves loads and throws of a tractor from its knot to its centre, and lists the centres of the tractors.
pub fn act_on_centres(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { cut, throws, tractors, parts, .. } = draft;
    let bodies = &parts.bodies;
    let centre_of = |knot: usize| {
        let body = bodies.iter().find(|body| body.ties.iter().any(|tie| tie.node == knot));
        body.map_or(knot, |body| body.centre)
    };
    for load in parts.loads.iter_mut().filter(|load| cut.web.tractors.contains(&load.node)) {
        load.node = centre_of(load.node);
    }
    *tractors = cut.web.tractor_ring().into_iter().map(centre_of).collect();
    for throw in throws.iter_mut().flatten() {
        throw.node = centre_of(throw.node);
    }
    Ok(())
}

/// The tie point of the tractor at `corner`, from 1: its place from the centre in body axes, m, and the path of its key in
/// the scenario. None where the ropes are tied at the centre.
fn arm(scenario: &Scenario, corner: u32, body: &PlacedBody) -> Option<(DVec3, String)> {
    let entry = scenario.tractors.iter().position(|tractor| tractor.corner.get() == corner);
    let own = entry.map(|index| {
        let tractor = &scenario.tractors[index];
        (format!("tractors.{index}"), tractor.tied_at, tractor.tie_point)
    });
    let common = scenario.traction_rope.as_ref();
    let common = common.map(|rope| ("traction_rope".to_owned(), rope.tied_at, rope.tie_point));
    let (path, tied_at, tie_point) =
        own.into_iter().chain(common).find(|(_, at, point)| at.is_some() || point.is_some())?;
    let arm = match (tied_at, tie_point) {
        (Some(TiedAt::Rear), _) => DVec3::NEG_Z * body.solid.shape.half_height_m(),
        (Some(TiedAt::Front), _) => DVec3::Z * body.solid.shape.half_height_m(),
        (_, Some(point)) => DVec3::from_array(point.map(|along| along.si())),
        _ => DVec3::ZERO,
    };
    let key = if tied_at.is_some() { "tied_at" } else { "tie_point" };
    // a particle has no end to be tied at
    let is_elsewhere = arm != DVec3::ZERO || matches!(tied_at, Some(TiedAt::Rear | TiedAt::Front));
    is_elsewhere.then(|| (arm, format!("{path}.{key}")))
}

/// Orientation of the tractor at `corner`, from 0, at the start: from body axes to the world frame.
pub fn at_launch(cut: &CutWeb, scenario: &Scenario, throw: Option<&Throw>, corner: usize) -> DQuat {
    let frame = super::throw::frame(scenario);
    let axis = frame * DVec3::Z;
    let pointing = match scenario.launch.as_ref().map_or(Attitude::default(), |launch| launch.attitude) {
        Attitude::Flight => throw.map_or(axis, |throw| throw.direction),
        Attitude::Axis => axis,
    };
    let outwards = frame * (cut.web.knots[cut.web.corners[corner]].position - cut.web.middle);
    attitude(pointing, axis.cross(outwards))
}

/// The rotation that turns z to `pointing`, a unit vector, and y as near to `around` as possible.
fn attitude(pointing: DVec3, around: DVec3) -> DQuat {
    let y = around.reject_from_normalized(pointing).try_normalize();
    let y = y.unwrap_or_else(|| pointing.any_orthonormal_vector());
    DQuat::from_mat3(&DMat3::from_cols(y.cross(pointing), y, pointing)).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_attitude_turns_z_to_the_direction_and_y_to_the_axis_across() {
        let (pointing, around) = (DVec3::new(0.6, 0.0, 0.8), DVec3::Y);
        let turned = attitude(pointing, around);
        assert!((turned * DVec3::Z - pointing).length() < 1e-15);
        assert!((turned * DVec3::Y - around).length() < 1e-15);
        assert!((turned * DVec3::X - DVec3::new(0.8, 0.0, -0.6)).length() < 1e-15);
        // no direction across is defined: any y will do
        assert!((attitude(DVec3::Y, DVec3::Y) * DVec3::Z - DVec3::Y).length() < 1e-15);
    }
}

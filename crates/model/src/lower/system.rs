//! Assembles the parts of the system from the results of the stages, and builds the system.

use glam::{DQuat, DVec3};
use netcast_dynamics::channel::Channel;
use netcast_dynamics::energy::Ledger;
use netcast_dynamics::forces::orbit::{self, Orbit};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::{Environment, SystemError};
use netcast_scenario::{Diagnostics, Orbit as WrittenOrbit};
use netcast_webs::Audit;

use super::assignment::table_of;
use super::binding::Bound;
use super::draft::Draft;
use super::launch;

/// Collects segments, canopies, environment and initial velocities as parts of the system.
pub fn assemble(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, frame, groups, members, canopies, turns, parts, state, .. } = draft;
    parts.tractor = vec![false; cut.nodes.len()];
    for &node in &cut.web.tractors {
        parts.tractor[node] = true;
    }
    parts.segments = members.iter().map(|member| member.segment).collect();
    parts.laws = groups.iter().map(|group| group.law.clone()).collect();
    parts.membranes = std::mem::take(&mut canopies.membranes);
    parts.hinges = std::mem::take(&mut canopies.hinges);
    parts.bodies = canopies.bound.iter().map(|bound| bound.body.clone()).collect();
    parts.environment = Environment {
        // 0 - g: without gravity this is +0, not -0
        gravity: DVec3::new(0.0, 0.0, 0.0 - scenario.environment.gravity.si()),
        mass_damping: scenario.environment.damping.si(),
        orbit: scenario.environment.orbit.as_ref().map(orbit_of),
        ..Environment::default()
    };
    let turned = |bound: &Bound| {
        let orientation = DQuat::from_mat3(&(*frame * turns[bound.canopy] * bound.axes)).normalize();
        bound.body.turning(orientation, DVec3::ZERO)
    };
    state.rotation = canopies.bound.iter().map(turned).collect();
    state.velocity = launch::own_velocities(document, cut, *frame);
    Ok(())
}

/// The orbit of the muzzle. World z points away from the planet, x along the orbit.
fn orbit_of(asked: &WrittenOrbit) -> Orbit {
    let by_altitude = || asked.altitude.map_or(0.0, |altitude| orbit::mean_motion(altitude.si()));
    let mean_motion = asked.mean_motion.map_or_else(by_altitude, |rate| rate.si());
    Orbit { mean_motion, radial: DVec3::Z, along: DVec3::X }
}

/// Builds the system from its parts.
///
/// # Errors
/// Parts that contradict each other or have impossible values.
pub fn build(draft: &mut Draft) -> Result<(), Diagnostics> {
    let parts = std::mem::take(&mut draft.parts);
    draft.mass = parts.mass.iter().sum();
    let system = parts
        .build()
        .map_err(|error| Diagnostics::from(draft.document.diagnostic(&place_of(&error, draft), error.to_string())))?;
    // the audit of the packing knows neither laws nor elements
    let stored_energy = Ledger::at_start(&system, &draft.state)[Channel::Elastic];
    draft.audit = draft.audit.take().map(|audit| Audit { stored_energy, ..audit });
    let limit = step_limit(&system);
    draft.system = Some((system, limit));
    Ok(())
}

/// The table that an error of the system is about.
fn place_of(error: &SystemError, draft: &Draft) -> String {
    let rope_of = |group: usize| {
        let name = draft.groups.get(group).and_then(|group| group.rope.as_ref());
        name.map_or("rope".to_owned(), |name| table_of(name).to_string())
    };
    match error {
        SystemError::Property { segment, .. } => {
            rope_of(draft.members.get(*segment).map_or(usize::MAX, |member| member.segment.group))
        }
        SystemError::Law { group, .. } => rope_of(*group),
        SystemError::Environment { .. } => "environment".to_owned(),
        SystemError::Mass { .. } => "rope".to_owned(),
        SystemError::Empty | SystemError::Shape { .. } | SystemError::Ends { .. } | SystemError::Attached { .. } => {
            "web".to_owned()
        }
    }
}

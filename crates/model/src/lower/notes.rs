//! Notes on properties of a model that a user may not expect.

use glam::DVec3;
use netcast_dynamics::air::wind::Wind;
use netcast_dynamics::state::State;
use netcast_dynamics::system::{Segment, System};
use netcast_scenario::{Diagnostics, Scenario};

use super::assignment;
use super::draft::Draft;
use super::drawing::two_digits;
use super::exposure;
use super::listed;
use super::members::Group;
use super::proportions;
use super::silences;
use super::stepping::largest_dt;
use super::throw::{Throw, Thrown};

/// Adds the notes on the model as a whole.
pub fn add(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, groups, throws, state, air, system, falls, bill, notes, .. } = draft;
    let Some((system, limit)) = system else { return Ok(()) };
    if scenario.measure.target_diameter.is_some() && cut.cells().is_empty() {
        notes.push("the target's coverage is not measured: drawn flat, this web's ropes enclose no cells".to_owned());
    }
    notes.extend(launched_and_held(system, throws));
    notes.extend(document.files.graph.iter().flat_map(|files| listed::notes(scenario, files)));
    let gravity = system.environment().gravity.length();
    notes.extend(exposure::notes(scenario, gravity, air.as_ref(), *falls));
    notes.extend(never_moves(system, state));
    if scenario.solve.run_time().is_some() {
        notes.extend(damping_above_stiffness(scenario, system, groups));
    }
    let dt = largest_dt(scenario, limit);
    let end = scenario.solve.run_time().unwrap_or(0.0);
    let is_thrown = throws.iter().flatten().any(|throw| throw.by != Thrown::At(DVec3::ZERO));
    notes.extend(proportions::notes(scenario, bill.as_ref(), is_thrown));
    silences::require_some_wind(document, end)?;
    notes.extend(silences::notes(document, scenario, throws, air.as_ref(), dt, end));
    Ok(())
}

/// A note on tractors that are both thrown and held.
fn launched_and_held(system: &System, throws: &[Option<Throw>]) -> Option<String> {
    let is_both = |throw: &&Throw| system.held()[throw.node] && throw.by != Thrown::At(DVec3::ZERO);
    let (count, all) = (throws.iter().flatten().filter(is_both).count(), throws.len());
    (count > 0).then(|| format!("{count} of {all} tractors are held by [hold] or [drive]: they are not launched"))
}

/// Notes of ropes that answer a jerk by damping more than by stiffness. A velocity v that jumps at the end of a rope makes the
/// tension EA v / c behind its front. In a segment of length h it makes EA t v / h by damping, t being the damping time: more
/// where h < c t, and then the largest tensions are those of the segments, not of the rope.
fn damping_above_stiffness(scenario: &Scenario, system: &System, groups: &[Group]) -> Vec<String> {
    let mut found = Vec::new();
    for (name, rope) in assignment::ropes(scenario) {
        let wave_speed = libm::sqrt(rope.elastic_modulus.si() / rope.density.si());
        let is_of_rope = |segment: &&Segment| groups[segment.group].rope.as_deref() == Some(name);
        let share = |segment: &Segment| wave_speed * (segment.damping / segment.stiffness) / segment.rest_length;
        let worst = system.segments().iter().filter(is_of_rope).max_by(|a, b| share(a).total_cmp(&share(b)));
        let Some((segment, share)) = worst.map(|s| (s, share(s))).filter(|(_, share)| *share > 1.0) else { continue };
        found.push(format!(
            "{}: in segments of {} m a jerk makes {share:.1} times more tension by damping than by stiffness: the highest \
             tensions depend on the length of segments; take segments of at least {} m, or less damping",
            assignment::table_of(name),
            two_digits(segment.rest_length),
            two_digits(share * segment.rest_length)
        ));
    }
    found
}

/// A note that the net is at rest and nothing will move it.
fn never_moves(system: &System, state: &State) -> Option<String> {
    let still = state.velocity.iter().all(|v| *v == DVec3::ZERO) && system.launchers().is_empty();
    let unloaded = system.environment().gravity == DVec3::ZERO && system.loads().is_empty();
    let calm = system.environment().air.as_ref().is_none_or(|air| air.wind == Wind::none());
    let slack = system.segments().iter().all(|s| {
        let [a, b] = s.ends;
        (state.position[b] - state.position[a]).length() <= s.rest_length
    });
    let weightless = system.environment().orbit.is_none();
    (still && unloaded && weightless && calm && slack && system.drives().is_empty())
        .then(|| "nothing moves: there is no launch, no gravity and no tension at the start".to_owned())
}

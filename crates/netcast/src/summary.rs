//! Makes the summary of a run from the measured sections, the model and the outcome.

use netcast_dynamics::forces::breaking::Break;
use netcast_dynamics::simulate::Outcome;
use netcast_model::Model;
use netcast_results::Summary;
use netcast_results::summary::{AirMet, BrokenSegment, ModelSize, StepSize, StowedState, Tension};

use crate::launched::launched;
use crate::rest::Rest;

/// The summary of a run of `model` with steps of `dt`, s: its `outcome` and the sections that were `measured`. Wall
/// time and warnings are left to the caller.
pub(crate) fn summary(model: &Model, dt: f64, rest: Option<&Rest>, outcome: &Outcome, measured: Summary) -> Summary {
    let (system, bill) = (&model.system, &model.bill);
    let breaks: Vec<BrokenSegment> = outcome.breaks.iter().map(|broken| broken_segment(model, broken)).collect();
    let broken = || breaks.iter().filter(|broken| !broken.released);
    Summary {
        title: model.scenario.title.clone(),
        netcast: env!("CARGO_PKG_VERSION").to_owned(),
        finished: outcome.stopped.is_none() && rest.is_none_or(Rest::is_found),
        model: ModelSize {
            nodes: system.mass().len(),
            segments: system.segments().len(),
            rope_length_m: bill.length_by_class.values().sum(),
            web_mass_kg: model.mass - bill.tractor_mass,
            tractor_mass_kg: (bill.tractors > 0).then_some(bill.tractor_mass),
        },
        step: StepSize { dt_s: dt, count: outcome.steps, limited_by: model.limited_by(), lifted_by: model.step_lift() },
        launch: launched(model, outcome),
        air: air(model),
        statics: rest.map(|rest| rest.summary(model)),
        tension: Tension {
            broken_segments: broken().count(),
            first_break_time_s: broken().next().map(|first| first.time_s),
            ..measured.tension
        },
        breaks,
        stowed: stowed(model),
        ..measured
    }
}

/// A break, with the labels of segment and link class.
fn broken_segment(model: &Model, broken: &Break) -> BrokenSegment {
    let &Break { segment, step: _, time, tension } = broken;
    let broken = &model.system.segments()[segment];
    let (class, cut) = (&model.groups[broken.group].class, time >= broken.breaking.cut_at);
    BrokenSegment {
        time_s: time,
        place: model.segment_label(segment),
        segment,
        class: class.name().to_owned(),
        tension_n: tension,
        released: cut || class.is_made_to_break(),
        cut,
    }
}

/// The medium and the wind of a run; none without air.
fn air(model: &Model) -> Option<AirMet> {
    let air = model.system.environment().air.as_ref()?;
    Some(AirMet {
        density_kg_m3: air.medium.density(0.0),
        viscosity_pa_s: air.medium.viscosity(),
        wind_m_s: air.wind.at(0.0, 0.0).into(),
        wind_change_max_m_s: air.wind.fluctuation.values.iter().map(|wind| wind.length()).fold(0.0, f64::max),
        solidity: model.air.as_ref().and_then(|air| air.solidity),
    })
}

/// The audit of the state at the start.
fn stowed(model: &Model) -> StowedState {
    let audit = &model.audit;
    let packing = model.packing();
    let closest = packing.closeness.and_then(|closeness| closeness.closest);
    StowedState {
        longest_stretch: audit.longest.map(|longest| longest.stretch),
        longest_stretch_where: audit.longest.map(|longest| model.segment_label(longest.segment)),
        stretched: audit.stretched,
        stored_energy_j: audit.stored_energy,
        packed_radius_m: audit.packed_radius,
        packed_height_m: audit.packed_height,
        density_kg_m3: packing.density,
        solid_fraction: packing.solid_fraction,
        closest_approach_m: closest.map(|closest| closest.distance),
        closest_approach_where: closest.map(|closest| closest.segments.map(|s| model.segment_label(s)).join(" and ")),
        closest_approach_at_m: closest.map(|closest| closest.place.to_array()),
        nearer_than_a_diameter: packing.closeness.map(|closeness| closeness.touching),
    }
}

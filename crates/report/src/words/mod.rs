//! The result of a run as sentences for a designer.
//!
//! A number is worded by what is printed of it: it is rounded first, and the printed values are compared. So no sentence
//! says that a web opens to 80 % and never reaches them, and none tells a flight of a millimetre.

mod flight;
mod opening;
mod phrases;
mod ropes;

use netcast_results::Summary;

use crate::format::{against, with_prefix};
use flight::{air, fastest_point, hang, landing, launch, middle_at_rest, tractors};
use opening::{area_at_rest, effective_opening, mouth, opening, place_of_opening, posture, target};
use ropes::{bottom_pull, broken, cut, hardest_pull, let_go, worst_rope};

pub(crate) use ropes::worst;

/// The result of a run as sentences, most important first.
///
/// A missing or null value gives no sentence. The first sentence says whether the run stopped before its end. A run
/// whose energy balance failed gets only the sentence on energy: its other numbers mean nothing.
///
/// ```
/// let mut summary = netcast_results::Summary { finished: true, ..Default::default() };
/// summary.opening.area_max_m2 = Some(15.8);
/// summary.opening.area_max_time_s = Some(0.131);
/// summary.opening.reference_area_m2 = Some(16.238);
/// assert_eq!(netcast_report::words(&summary)[0], "Opens to 15.8 m² (97 % of the flat web) at 0.131 s.");
/// ```
pub fn words(summary: &Summary) -> Vec<String> {
    if is_equilibrium(summary) {
        let mut timeless = summary.clone();
        timeless.tension.max_time_s = None;
        let told: [Sentence; 5] = [balance, area_at_rest, middle_at_rest, hardest_pull, worst_rope];
        return told.iter().filter_map(|sentence| sentence(&timeless)).collect();
    }
    let told: &[Sentence] = if summary.energy.closure > CAME_APART {
        &[unfinished, energy]
    } else {
        &[
            unfinished,
            balance,
            launch,
            opening,
            effective_opening,
            place_of_opening,
            target,
            let_go,
            cut,
            broken,
            hardest_pull,
            worst_rope,
            bottom_pull,
            tractors,
            fastest_point,
            posture,
            mouth,
            hang,
            landing,
            air,
            energy,
        ]
    };
    told.iter().filter_map(|sentence| sentence(summary)).collect()
}

/// Whether the result is an equilibrium alone, without a step in time.
pub(crate) fn is_equilibrium(summary: &Summary) -> bool {
    summary.statics.is_some() && summary.step.count == 0
}

type Sentence = fn(&Summary) -> Option<String>;

/// Closure of the energy balance above which the step did not resolve the motion.
const CAME_APART: f64 = 0.5;

fn unfinished(summary: &Summary) -> Option<String> {
    let said = "The run stopped before its end: what follows covers the time up to there.";
    (!summary.finished).then(|| said.to_owned())
}

fn balance(summary: &Summary) -> Option<String> {
    let found = summary.statics.as_ref()?;
    let iterations = format!("after {} iterations", found.iterations);
    let force = found.residual_n.map(|force| with_prefix(force, "N")).unwrap_or("no finite force".into());
    let place = found.residual_where.as_ref().map(|place| format!(" at {place}")).unwrap_or_default();
    Some(match found.residual_relative.filter(|relative| *relative <= found.tolerance) {
        Some(relative) => {
            let what = if is_equilibrium(summary) { "Hangs" } else { "Starts" };
            format!(
                "{what} in equilibrium: {force}{place} is out of balance, {relative:.1e} of the largest tension or \
                load, {iterations}."
            )
        }
        None => {
            format!("Is not in equilibrium {iterations}: {force} is out of balance{place}. Do not trust these numbers.")
        }
    })
}

fn energy(summary: &Summary) -> Option<String> {
    let energy = &summary.energy;
    let closure = Some(energy.closure).filter(|closure| closure.is_finite())?;
    // what a file does not tell is not a number, and nothing is above it
    let missed = closure > energy.tolerance || energy.closure_web.is_some_and(|web| web > energy.tolerance_web);
    let web = energy.closure_web.map(|web| against(web, energy.tolerance_web));
    let web = web.map(|web| format!(" ({web} of what the web itself holds)")).unwrap_or_default();
    let closes = against(closure, energy.tolerance) + &web;
    Some(if missed {
        format!("The energy balance is off by {closes}, more than is allowed: do not trust these numbers.")
    } else {
        format!("The energy balance closes to {closes}.")
    })
}

#[cfg(test)]
mod properties;
#[cfg(test)]
mod tests;

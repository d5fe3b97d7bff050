//! The section `launch` of the summary: how the tractors left the launcher.

use netcast_dynamics::simulate::Outcome;
use netcast_model::{Model, Throw};
use netcast_results::summary::{Departure, Departures, Recoil};

/// The departures of the tractors and the recoil of a run; none where nothing is launched.
pub(crate) fn launched(model: &Model, outcome: &Outcome) -> Option<Departures> {
    let launch = model.scenario.launch.as_ref();
    let spin_rad_s = launch.map_or(0.0, |launch| launch.spin.si());
    let axis = model.axis();
    let depart = |throw: &Throw| {
        // a tractor without a launcher leaves at the start, unless it is held
        let left = match throw.launcher {
            Some(launcher) => outcome.launching.nodes[launcher].left,
            None if model.system.held()[throw.node] => None,
            None => Some((0.0, model.state.velocity[throw.node].length())),
        };
        Departure {
            time_s: left.map(|(time, _)| time),
            speed_m_s: left.map(|(_, speed)| speed),
            angle_rad: throw.angle_to(axis),
        }
    };
    let tractors = model.throws.iter().flatten().map(|throw| (throw.corner, depart(throw))).collect();
    let recoil = launch.and_then(|launch| launch.tube.as_ref()).map(|_| {
        let recoil = outcome.launching.recoil;
        Recoil {
            peak_n: recoil.peak.0,
            peak_time_s: recoil.peak.1,
            impulse_n_s: recoil.impulse.length(),
            axial_impulse_n_s: 0.0 - recoil.impulse.dot(axis),
        }
    });
    let is_launched = launch.is_some() || model.throws.iter().any(Option::is_some);
    is_launched.then_some(Departures { spin_rad_s, tractors, recoil })
}

//! The part of `netcast check` about the cost of a run.

use netcast::facts::{Cost, Equilibrium};

use crate::screen::{number, rows, say, wait};

/// Prints the limits of the search for an equilibrium.
pub fn equilibrium(wanted: &Equilibrium) {
    let Equilibrium { max_iterations, tolerance, nodes, segments } = wanted;
    say!("Equilibrium");
    rows(&[
        ("iterations".into(), format!("at most {max_iterations} of {nodes} nodes and {segments} segments")),
        ("forces balance to".into(), format!("{tolerance:e}")),
    ]);
}

/// Prints segments, steps, computing time and disk space.
pub fn cost(cost: &Cost) {
    let elements: String = cost.elements.iter().map(|some| format!(", {} {}", some.count, some.kind)).collect();
    let limit = cost.limited_by.as_deref().unwrap_or("nothing");
    let seconds = cost.one_core_s.map(|seconds| format!(", about {} on one core of this machine", wait(seconds)));
    say!("Cost");
    rows(&[
        ("model".into(), format!("{} nodes, {} segments{elements}", cost.nodes, cost.segments)),
        (
            "step".into(),
            format!(
                "{} us, at most {} % of the stable {} us, limited by {limit}",
                number(1e6 * cost.dt_s, 4),
                number(100.0 * cost.step_fraction, 3),
                number(1e6 * cost.stable_dt_s, 4)
            ),
        ),
        ("larger step with".into(), cost.lifted_by.clone().unwrap_or_else(|| "nothing".into())),
        ("steps".into(), format!("{} for {} s", cost.steps, number(cost.duration_s, 4))),
        ("segment updates".into(), format!("{}{}", number(cost.segment_updates, 3), seconds.unwrap_or_default())),
        ("records".into(), format!("{}, about {} MB", cost.records, number(1e-6 * cost.frames_bytes, 2))),
    ]);
}

//! Turns of phrase that several sentences share.

use crate::format::time;

/// ` at 0.131 s`; empty without a time.
pub(super) fn at(time_s: Option<f64>) -> String {
    time_s.map(|seconds| format!(" at {}", time(seconds))).unwrap_or_default()
}

/// Whether a time, s, reads as the start of the run.
pub(super) fn is_start(seconds: f64) -> bool {
    time(seconds) == time(0.0)
}

/// A length of time; one that reads as zero is `less than 0.001 s`.
pub(super) fn lasting(seconds: f64) -> String {
    if is_start(seconds) { "less than 0.001 s".into() } else { time(seconds) }
}

/// A spell, the longest of several or the only one, and the total of all: `from 0.112 s to 0.193 s, for 0.081 s`.
pub(super) fn spell(from: f64, to: f64, total: Option<f64>) -> String {
    let when = if time(from) == time(to) {
        format!("at {}", time(from))
    } else {
        format!("from {} to {}", time(from), time(to))
    };
    match sum_of_several(to - from, total) {
        Some(total) => format!("{when}, its longest spell; {} in all", time(total)),
        None => format!("{when}, for {}", lasting(to - from)),
    }
}

/// The total of several spells, s; none where the longest, `spell`, is the only one or reads like all of them.
pub(super) fn sum_of_several(spell: f64, total: Option<f64>) -> Option<f64> {
    total.filter(|total| *total > spell && time(*total) != time(spell))
}

/// `one`, `one and other`, `one, other and last`.
pub(super) fn listed(names: &[&str]) -> String {
    match names {
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        names => names.concat(),
    }
}

pub(super) fn article(noun: &str) -> &'static str {
    if noun.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" }
}

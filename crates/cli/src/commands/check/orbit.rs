//! What `netcast check` says of the orbit.

use std::f64::consts::TAU;

use netcast::Model;

use crate::screen::{number, rows, say};

/// How fast it is gone round.
pub fn orbit(model: &Model) {
    let Some(orbit) = &model.system.environment().orbit else { return };
    let period = TAU / orbit.mean_motion;
    say!("Orbit");
    rows(&[
        ("mean motion".into(), format!("{} rad/s", number(orbit.mean_motion, 5))),
        ("period".into(), format!("{} s, {} min", number(period, 5), number(period / 60.0, 4))),
    ]);
}

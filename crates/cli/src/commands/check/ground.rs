//! What `netcast check` says of the ground.

use std::f64::consts::PI;

use netcast::Model;

use crate::screen::{number, rows, say};

/// A speed that things come down at, m/s.
const IMPACT: f64 = 20.0;

/// Where it is, how it answers, what touches it.
pub fn ground(model: &Model) {
    let (Some(ground), Some(asked)) = (&model.system.environment().ground, &model.scenario.environment.ground) else {
        return;
    };
    let height = match number(ground.height.abs(), 4) {
        level if ground.height == 0.0 => format!("{level} m: level with the muzzle"),
        below if ground.height < 0.0 => format!("{below} m below the muzzle"),
        above => format!("{above} m above the muzzle"),
    };
    let depth = number(1e3 * IMPACT * asked.contact_time.si() / PI, 3);
    let hulls = match ground.hulls.len() {
        0 => String::new(),
        count => format!(", {count} points of rigid bodies"),
    };
    say!("Ground");
    rows(&[
        ("height".into(), height),
        ("friction".into(), number(ground.friction, 3)),
        ("restitution".into(), number(asked.restitution.si(), 3)),
        (format!("{IMPACT} m/s sinks in by"), format!("{depth} mm at most")),
        ("touched by".into(), format!("{} nodes{hulls}", ground.nodes.len())),
    ]);
}

//! The part of `netcast check` about the orbit, the ground, loads and drives.

use netcast::facts::{ActingFacts, GroundFacts, OrbitFacts};

use crate::screen::{number, rows, say};

/// Prints mean motion and period of the orbit.
pub fn orbit(orbit: &OrbitFacts) {
    let period = orbit.period_s;
    say!("Orbit");
    rows(&[
        ("mean motion".into(), format!("{} rad/s", number(orbit.mean_motion_rad_s, 5))),
        ("period".into(), format!("{} s, {} min", number(period, 5), number(period / 60.0, 4))),
    ]);
}

/// Prints height and contact of the ground, and the number of nodes that can touch it.
pub fn ground(ground: &GroundFacts) {
    let level = number(ground.height_m.abs(), 4);
    let height = if ground.height_m == 0.0 {
        format!("{level} m: level with the muzzle")
    } else if ground.height_m < 0.0 {
        format!("{level} m below the muzzle")
    } else {
        format!("{level} m above the muzzle")
    };
    let depth = number(1e3 * ground.impact_depth_m, 3);
    let hulls = match ground.body_points {
        0 => String::new(),
        count => format!(", {count} points of rigid bodies"),
    };
    say!("Ground");
    rows(&[
        ("height".into(), height),
        ("friction".into(), number(ground.friction, 3)),
        ("restitution".into(), number(ground.restitution, 3)),
        (format!("{} m/s sinks in by", ground.impact_speed_m_s), format!("{depth} mm at most")),
        ("touched by".into(), format!("{} nodes{hulls}", ground.nodes)),
    ]);
}

/// Prints loads and drives.
pub fn acting(acting: &ActingFacts) {
    let mut lines = Vec::new();
    if let Some(loads) = &acting.loads {
        let [x, y, z] = loads.force_n.map(|sum| number(sum, 4));
        let ramped = if loads.ramped > 0 { format!(", {} of them with a ramp", loads.ramped) } else { String::new() };
        lines.push(("loads".into(), format!("{} on nodes, {x}, {y}, {z} N in all{ramped}", loads.nodes)));
    }
    if let Some(drives) = &acting.drives {
        let told = format!("{} nodes, the last until {} s", drives.nodes, number(drives.until_s, 4));
        lines.push(("drives".into(), told));
    }
    if !lines.is_empty() {
        say!("Loads and drives");
        rows(&lines);
    }
}

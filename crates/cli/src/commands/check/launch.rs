//! The part of `netcast check` about tractors, their launch, break ties and stitches.

use netcast::Facts;
use netcast::facts::{BodyFacts, Pushed, Tied};

use crate::screen::{number, rows, say};

/// Prints the rigid bodies. Equal bodies share a line.
pub fn bodies(bodies: &[BodyFacts]) {
    let mut lines: Vec<(String, Vec<u32>)> = Vec::new();
    for body in bodies {
        let [x, y, z] = body.inertia_kg_m2.map(|moment| number(moment, 3));
        let arm = body.tied_at_m.map(|along| number(1e3 * along, 3)).join(", ");
        let mass = number(body.mass_kg, 4);
        let told = format!("{mass} kg, inertia {x}, {y}, {z} kg m^2, tied at {arm} mm from its centre");
        match lines.iter_mut().find(|(known, _)| *known == told) {
            Some((_, corners)) => corners.push(body.corner),
            None => lines.push((told, vec![body.corner])),
        }
    }
    if lines.is_empty() {
        return;
    }
    say!("Rigid bodies");
    rows(&lines.into_iter().map(|(told, corners)| (named(&corners), told)).collect::<Vec<_>>());
}

/// The name of the tractors at `corners`.
fn named(corners: &[u32]) -> String {
    let numbers: Vec<String> = corners.iter().map(u32::to_string).collect();
    format!("tractor {}", numbers.join(", "))
}

/// Prints spin and throws, unless all tractors have one plain speed.
pub fn launch(facts: &Facts) {
    let mut lines = Vec::new();
    if let Some(spin) = facts.spin_rad_s {
        lines.push(("spin".into(), format!("{} rad/s about the launch axis", number(spin, 4))));
    }
    for throw in facts.throws.iter().filter(|_| !facts.is_plain_launch) {
        let by = match throw.by {
            Pushed::Speed { speed_m_s } => format!("{} m/s", number(speed_m_s, 4)),
            Pushed::Tube { stroke_m, work_j } => {
                let work = work_j.map(|work| format!(", {} J", number(work, 4)));
                format!("a tube of {} m{}", number(stroke_m, 4), work.unwrap_or_default())
            }
        };
        let delay =
            if throw.delay_s > 0.0 { format!(", after {} ms", number(1e3 * throw.delay_s, 4)) } else { "".into() };
        let angle = number(throw.angle_rad.to_degrees(), 4);
        lines.push((named(&[throw.corner]), format!("{by} at {angle} deg from the axis{delay}")));
    }
    if !lines.is_empty() {
        say!("Launch");
        rows(&lines);
    }
}

/// Prints break ties and stitches.
pub fn ties(ties: &[Tied]) {
    if ties.is_empty() {
        return;
    }
    let line = |tied: &Tied| {
        let least = number(tied.least_load_n, 4);
        let load = if tied.least_load_n == tied.largest_load_n {
            format!("{least} N")
        } else {
            format!("{least} to {} N", number(tied.largest_load_n, 4))
        };
        (tied.kind.clone(), format!("{}, break at {load}; they have no mass", tied.count))
    };
    say!("Ties and stitches");
    rows(&ties.iter().map(line).collect::<Vec<_>>());
}

//! The part of `netcast check` about air and wind.

use netcast::facts::{AirFacts, BodiesInAir, Fall, WindFacts};

use crate::screen::{number, rows, say};

/// Prints the medium, the wind, the drag of each part, solidity, buoyancy and fall.
pub fn air(air: &AirFacts) {
    say!("Air");
    let mut lines = vec![("medium".into(), medium(air))];
    lines.extend(air.wind.as_ref().map(|facts| ("wind".into(), wind(facts))));
    for rope in &air.ropes {
        let at = if air.launch_speed_m_s > 0.0 {
            format!(
                ", Reynolds number {} and coefficient {} across it at {} m/s",
                number(rope.reynolds, 3),
                number(rope.normal_coefficient, 4),
                number(air.launch_speed_m_s, 4)
            )
        } else {
            String::new()
        };
        let part = if rope.is_screen { ", as a screen" } else { "" };
        lines.push((format!("drags: {}{part}", rope.rope), format!("{} m^2{at}", number(rope.area_m2, 4))));
    }
    lines.extend(air.canopies.map(|canopies| {
        let (area, coefficient) = (number(canopies.area_m2, 4), number(canopies.coefficient, 4));
        ("drags: canopies".into(), format!("{area} m^2, coefficient {coefficient} square to the wind"))
    }));
    lines.extend(bodies(&air.bodies).map(|bodies| ("drags: bodies".into(), bodies)));
    lines.push(("solidity".into(), solidity(air)));
    if air.buoyancy_n > 0.0 {
        lines.push(("buoyancy".into(), format!("{} N, among the loads", number(air.buoyancy_n, 4))));
    }
    if let Some(fall) = air.fall {
        lines.push(("the web falls".into(), in_words(fall)));
    }
    rows(&lines);
}

/// A fall in words.
fn in_words(fall: Fall) -> String {
    match fall {
        Fall::TerminalSpeedMS(speed) => format!("at {} m/s in the end, flat and without tractors", number(speed, 4)),
        Fall::Floats => "not at all: it floats".into(),
        Fall::Unhindered => "ever faster: it has no drag".into(),
    }
}

/// Kind, density and viscosity of the medium.
fn medium(air: &AirFacts) -> String {
    let what = air.altitude_m.map_or("as given".into(), |altitude| format!("standard atmosphere at {altitude} m"));
    let (density, viscosity) = (number(air.density_kg_m3, 4), number(1e3 * air.viscosity_pa_s, 4));
    format!("{what}: {density} kg/m^3, {viscosity} mPa s")
}

/// The mean wind, and the largest gust.
fn wind(wind: &WindFacts) -> String {
    let most = number(wind.change_max_m_s, 3);
    let Some(mean) = wind.mean else { return format!("as measured, at most {most} m/s") };
    let [here, above] = [mean.at_muzzle_m_s, mean.at_10_m_m_s].map(|speed| number(speed, 3));
    let towards = number(mean.towards_rad.to_degrees(), 3);
    let changes = if wind.is_gusty { format!("; gusts and turbulence of at most {most} m/s") } else { String::new() };
    format!("{here} m/s at the muzzle, {above} m/s at 10 m, towards {towards} deg from x{changes}")
}

/// Number and size of the bodies in the air; none without bodies.
fn bodies(bodies: &BodiesInAir) -> Option<String> {
    let BodiesInAir { count, area_max_m2, hidden, sizeless } = *bodies;
    let dragging = (count > 0).then(|| format!("{count}, {} m^2 at most", number(area_max_m2, 3)));
    let hidden = (hidden > 0).then(|| format!("{hidden} hidden by their canopies"));
    let sizeless = (sizeless > 0).then(|| format!("{sizeless} without size"));
    let told: Vec<String> = [dragging, hidden, sizeless].into_iter().flatten().collect();
    (!told.is_empty()).then(|| told.join("; "))
}

/// The solidity of the drawn web, and the one that sets the drag.
fn solidity(air: &AirFacts) -> String {
    let drawn = air.drawn_solidity.map(|drawn| format!("{} as drawn", number(drawn, 3)));
    let taken = match air.screen_solidity {
        Some(taken) => format!("the ropes drag as a screen of solidity {}", number(taken, 3)),
        None => "each rope drags as if alone".into(),
    };
    drawn.into_iter().chain([taken]).collect::<Vec<_>>().join("; ")
}

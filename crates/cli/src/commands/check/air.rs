//! What `netcast check` says of the air and the wind.

use netcast::Model;
use netcast::dynamics::air::Air;
use netcast::dynamics::forces::body_drag::Shape;
use netcast::model::{AirOutline, Fall, RopesInAir};

use crate::screen::{number, rows, say};

/// Height above the ground at which weather services tell the wind, m.
const WEATHER_HEIGHT: f64 = 10.0;

/// The medium, the wind, what drags.
pub fn air(model: &Model) {
    let (Some(air), Some(outline)) = (&model.system.environment().air, &model.air) else { return };
    say!("Air");
    let mut lines = vec![("medium".into(), medium(model, air))];
    lines.extend(wind(model, air).map(|wind| ("wind".into(), wind)));
    for RopesInAir { rope, screened, area, reynolds, normal } in model.ropes_in_air() {
        let at = match outline.launch_speed > 0.0 {
            true => format!(
                ", Reynolds number {} and coefficient {} across it at {} m/s",
                number(reynolds, 3),
                number(normal, 4),
                number(outline.launch_speed, 4)
            ),
            false => String::new(),
        };
        let part = if screened { ", as a screen" } else { "" };
        lines.push((format!("drags: {rope}{part}"), format!("{} m^2{at}", number(area, 4))));
    }
    lines.extend(canopies(air).map(|canopies| ("drags: canopies".into(), canopies)));
    lines.extend(bodies(air, outline).map(|bodies| ("drags: bodies".into(), bodies)));
    lines.push(("solidity".into(), solidity(outline)));
    if outline.buoyancy > 0.0 {
        lines.push(("buoyancy".into(), format!("{} N, among the loads", number(outline.buoyancy, 4))));
    }
    if let Some(fall) = model.fall().filter(|_| model.scenario.environment.gravity.si() > 0.0) {
        lines.push(("the web falls".into(), in_words(fall)));
    }
    rows(&lines);
}

fn in_words(fall: Fall) -> String {
    match fall {
        Fall::At(speed) => format!("{} m/s at last, flat and without tractors", number(speed, 4)),
        Fall::Floats => "not: it floats".into(),
        Fall::Unhindered => "ever faster: nothing of it drags".into(),
    }
}

fn medium(model: &Model, air: &Air) -> String {
    let asked = model.scenario.environment.air.as_ref().and_then(|air| air.altitude);
    let what = asked.map_or("as given".into(), |altitude| format!("standard atmosphere at {altitude}"));
    let (density, viscosity) = (air.medium.density(0.0), 1e3 * air.medium.viscosity());
    format!("{what}: {} kg/m^3, {} mPa s", number(density, 4), number(viscosity, 4))
}

/// The mean of the wind, and how much it changes.
fn wind(model: &Model, air: &Air) -> Option<String> {
    let asked = model.scenario.environment.wind.as_ref()?;
    let most = number(air.wind.fluctuation.values.iter().map(|velocity| velocity.length()).fold(0.0, f64::max), 3);
    if asked.series.is_some() {
        return Some(format!("as measured, at most {most} m/s"));
    }
    let up = WEATHER_HEIGHT - asked.muzzle_height.map_or(0.0, |height| height.si());
    let [here, above] = [0.0, up].map(|height| number(air.wind.mean.at(height), 3));
    let towards = number(asked.azimuth.map_or(0.0, |azimuth| azimuth.si().to_degrees()), 3);
    let changes = match asked.gust.is_some() || asked.turbulence.is_some() {
        true => format!("; gusts and turbulence of at most {most} m/s"),
        false => String::new(),
    };
    Some(format!("{here} m/s at the muzzle, {above} m/s at 10 m, towards {towards} deg from x{changes}"))
}

fn canopies(air: &Air) -> Option<String> {
    let coefficient = air.sheets.first()?.coefficient;
    let area = air.sheets.iter().map(|sheet| sheet.area).sum();
    Some(format!("{} m^2, coefficient {} square to the wind", number(area, 4), number(coefficient, 4)))
}

fn bodies(air: &Air, outline: &AirOutline) -> Option<String> {
    // the largest face of each, which it may turn to the wind or not
    let face = |shape: &Shape| match *shape {
        Shape::Sphere(diameter) => std::f64::consts::FRAC_PI_4 * diameter * diameter,
        Shape::Cylinder { diameter, height } => diameter * height.max(std::f64::consts::FRAC_PI_4 * diameter),
        Shape::Box(sides) => sides.element_product() / sides.min_element(),
    };
    let area = air.bodies.iter().map(|body| face(&body.shape)).sum();
    let count = air.bodies.len();
    let dragging = (count > 0).then(|| format!("{count}, {} m^2 at most", number(area, 3)));
    let hidden = (outline.hidden > 0).then(|| format!("{} hidden by their canopies", outline.hidden));
    let sizeless = (outline.sizeless > 0).then(|| format!("{} without size", outline.sizeless));
    let told: Vec<String> = [dragging, hidden, sizeless].into_iter().flatten().collect();
    (!told.is_empty()).then(|| told.join("; "))
}

fn solidity(outline: &AirOutline) -> String {
    let drawn = outline.drawn_solidity.map(|drawn| format!("{} as drawn", number(drawn, 3)));
    let taken = match outline.solidity {
        Some(taken) => format!("the ropes drag as those of a screen of {}", number(taken, 3)),
        None => "each rope drags as if alone".into(),
    };
    drawn.into_iter().chain([taken]).collect::<Vec<_>>().join("; ")
}

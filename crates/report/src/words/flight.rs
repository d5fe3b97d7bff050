//! Launch, points, flight and the medium.

use netcast_results::Summary;
use netcast_results::summary::{Departure, PointExtremes};

use super::phrases::{at, is_start, lasting, listed};
use crate::format::{is_seen, metres, percent, significant, time, with_prefix};

/// Computed values of the launch: muzzle speeds and recoil, delays, spin.
pub(super) fn launch(summary: &Summary) -> Option<String> {
    let launch = summary.launch.as_ref()?;
    let departures: Vec<&Departure> = launch.tractors.values().collect();
    let of_each = |of: fn(&Departure) -> Option<f64>| departures.iter().filter_map(|one| of(one)).collect::<Vec<f64>>();
    let (speeds, times) = (of_each(|one| one.speed_m_s), of_each(|one| one.time_s));
    let left = match (speeds.len(), departures.len()) {
        (left, all) if left < all => format!("{left} of {all} tractors have left"),
        _ => "The tractors left".to_owned(),
    };
    let [speed, time_of] = [&speeds, &times].map(|values| {
        let least = values.iter().copied().reduce(f64::min)?;
        Some((least, values.iter().copied().fold(least, f64::max)))
    });
    let range = |(least, most): (f64, f64), write: fn(f64) -> String| {
        let [least, most] = [least, most].map(write);
        if least == most { least } else { format!("{least} to {most}") }
    };
    let spin = Some(launch.spin_rad_s).filter(|spin| *spin != 0.0);
    // a time that reads as zero is none
    let is_late = |latest: f64| time(latest) != time(0.0);
    let is_plain = spin.is_none() && launch.recoil.is_none() && time_of.is_none_or(|(_, latest)| !is_late(latest));
    if is_plain {
        return None;
    }
    let mut told = left;
    if let (Some(speed), Some(times)) = (speed, time_of) {
        told += &format!(" at {} m/s", range(speed, significant));
        if is_late(times.1) {
            told += &format!(", {} after the start", range(times, time));
        }
    }
    if let Some(spin) = spin {
        told += &format!(", all turning at {} rad/s", significant(spin));
    }
    if let Some(recoil) = &launch.recoil {
        let (peak, impulse) = (with_prefix(recoil.peak_n, "N"), significant(recoil.impulse_n_s));
        told += &format!("; the recoil is up to {peak}, {impulse} N s in all");
    }
    Some(told + ".")
}

pub(super) fn middle_at_rest(summary: &Summary) -> Option<String> {
    let travel = peak_travel(summary, "centre").filter(|travel| is_seen(*travel))?;
    let side = if travel < 0.0 { "behind" } else { "ahead of" };
    Some(format!("The middle lies {} {side} its place as drawn, along the launch axis.", metres(travel.abs())))
}

pub(super) fn tractors(summary: &Summary) -> Option<String> {
    let tractor = summary.points.get("tractor").and_then(Option::as_ref);
    let travel = peak_travel(summary, "tractor").filter(|travel| *travel > 0.0 && is_seen(*travel));
    let area = summary.opening.tractor_area_max_m2.filter(|area| *area >= 1e-4);
    let travel = travel.map(|travel| {
        let when = tractor.and_then(|tractor| tractor.peak_travel_time_s);
        let when = when.map(|seconds| format!(" by {}", time(seconds))).unwrap_or_default();
        format!("travel {} along the launch axis{when}", metres(travel))
    });
    let area = area.map(|area| {
        let when = at(summary.opening.tractor_area_max_time_s);
        format!("span up to {} m²{when}", significant(area))
    });
    let done: Vec<String> = travel.into_iter().chain(area).collect();
    (!done.is_empty()).then(|| format!("The tractors {}.", done.join(" and ")))
}

/// The fastest of the points that a designer named; those whose speeds read alike share it.
pub(super) fn fastest_point(summary: &Summary) -> Option<String> {
    // tractors, corners and the centre are told of elsewhere
    let named = summary.points.iter().filter(|(name, _)| !is_part_of_the_web(name));
    let speed = |point: &PointExtremes| point.peak_speed_m_s.filter(|speed| *speed >= 5e-4);
    let moving = named.filter_map(|(name, point)| Some((&name[..], point.as_ref()?, speed(point.as_ref()?)?)));
    let moving: Vec<(&str, &PointExtremes, f64)> = moving.collect();
    let fastest = moving.iter().map(|(.., speed)| *speed).reduce(f64::max)?;
    let told = format!("{} m/s", significant(fastest));
    let alike: Vec<_> = moving.iter().filter(|(.., speed)| significant(*speed) == significant(fastest)).collect();
    let names: Vec<&str> = alike.iter().map(|(name, ..)| *name).collect();
    Some(match alike[..] {
        [(name, point, _)] if moving.len() == 1 => {
            format!("Point {name} reaches {told}{}.", at(point.peak_speed_time_s))
        }
        [(name, point, _)] => {
            format!("Of the feature points, {name} is the fastest: {told}{}.", at(point.peak_speed_time_s))
        }
        _ => format!("Of the feature points, {} are the fastest: {told}.", listed(&names)),
    })
}

/// Farthest travel of a point, m; none where the web has no such point.
fn peak_travel(summary: &Summary, point: &str) -> Option<f64> {
    summary.points.get(point)?.as_ref()?.peak_travel_m
}

fn is_part_of_the_web(name: &str) -> bool {
    matches!(name, "tractor" | "corner" | "centre")
}

/// Whether the web flies high enough to be said to rise: a hundredth of its width, and a centimetre.
fn rises(summary: &Summary, apex: f64) -> bool {
    let width = summary.opening.reference_area_m2.filter(|area| *area > 0.0).map(f64::sqrt);
    apex >= width.map_or(0.01, |width| f64::max(0.01, 0.01 * width)) && is_seen(apex)
}

pub(super) fn hang(summary: &Summary) -> Option<String> {
    // beside an orbit nothing hangs about an apex
    if summary.energy.channels.get("orbit").is_some_and(|energy| *energy != 0.0) {
        return None;
    }
    let flight = &summary.flight;
    let (apex, hang) = (flight.apex_height_m.filter(|apex| rises(summary, *apex))?, flight.hang_time_s?);
    // what is highest at the start does not rise
    if flight.apex_time_s.is_some_and(is_start) {
        return None;
    }
    let (least, cut) = match flight.still_up {
        Some(true) if !is_start(hang) => ("at least ", ", up to the end of the run"),
        Some(true) => ("", " up to the end of the run"),
        _ => ("", ""),
    };
    Some(format!(
        "The web's centre of mass rises to {}{} and hangs within 5 % of that for {least}{}{cut}.",
        metres(apex),
        at(flight.apex_time_s),
        lasting(hang)
    ))
}

pub(super) fn landing(summary: &Summary) -> Option<String> {
    let flight = &summary.flight;
    let touch = flight.touches_down_s?;
    let drift = flight.drift_m?;
    let lies = flight.lies_from_s.map(|from| format!(", lies still from {}", time(from))).unwrap_or_default();
    let ends =
        if is_seen(drift) { format!("{} from where it started", metres(drift)) } else { "where it started".into() };
    Some(format!("It touches the ground at {}{lies} and ends {ends}.", time(touch)))
}

/// What the air has taken, or the wind given.
pub(super) fn air(summary: &Summary) -> Option<String> {
    let air = summary.air.as_ref()?;
    let density = format!("{} kg/m³", significant(air.density_kg_m3));
    let taken = *summary.energy.channels.get("air")?;
    let speed = air.wind_m_s.iter().map(|along| along * along).sum::<f64>().sqrt();
    let change = Some(air.wind_change_max_m_s).filter(|change| *change > 0.0);
    let moving = match (speed > 0.0, change) {
        (true, _) => format!(" that moves at {} m/s at the start", significant(speed)),
        (false, Some(change)) => format!(" that moves at up to {} m/s", significant(change)),
        (false, None) => String::new(),
    };
    if taken.abs() < LEAST_ENERGY {
        return Some(format!("Drag takes next to nothing, in a medium of {density}{moving}."));
    }
    let initial = Some(summary.energy.initial_j).filter(|initial| *initial > taken.abs());
    let share = initial.map(|initial| format!(", {} of what there was at the start", percent(taken.abs() / initial)));
    let verb = if taken < 0.0 { "gives" } else { "takes" };
    let (taken, share) = (with_prefix(taken.abs(), "J"), share.unwrap_or_default());
    Some(format!("Drag {verb} {taken}{share}, in a medium of {density}{moving}."))
}

/// An energy below this, J, is none.
const LEAST_ENERGY: f64 = 1e-6;

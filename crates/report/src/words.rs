//! What happened, in a designer's words.

use serde_json::Value;

use crate::format::{percent, significant, time, with_prefix};

/// The result of a run as sentences, most important first, from the value of its `summary.json`.
///
/// What a scenario does not have (null or missing) is not spoken of; the first sentence says it where a run did not
/// reach its end. Of a run that came apart nothing else is told: its numbers mean nothing.
///
/// ```
/// let summary = serde_json::json!({
///     "finished": true,
///     "opening": {"area_max_m2": 15.8, "area_max_time_s": 0.131, "reference_area_m2": 16.238},
/// });
/// assert_eq!(netcast_report::words(&summary)[0], "Opens to 15.8 m² (97 % of the flat web) at 0.131 s.");
/// ```
pub fn words(summary: &Value) -> Vec<String> {
    if is_equilibrium(summary) {
        let mut timeless = summary.clone();
        timeless["tension"]["max_time_s"] = Value::Null;
        let told: [Sentence; 5] = [balance, area_at_rest, middle_at_rest, hardest_pull, worst_rope];
        return told.iter().filter_map(|sentence| sentence(&timeless)).collect();
    }
    let told: &[Sentence] = match summary["energy"]["closure"].as_f64() {
        Some(closure) if closure > CAME_APART => &[unfinished, energy],
        _ => &[
            unfinished,
            balance,
            launch,
            opening,
            effective_opening,
            target,
            let_go,
            broken,
            hardest_pull,
            worst_rope,
            bottom_pull,
            tractors,
            fastest_point,
            posture,
            mouth,
            hang,
            landing,
            air,
            energy,
        ],
    };
    told.iter().filter_map(|sentence| sentence(summary)).collect()
}

/// Whether the equilibrium is all there is: nothing has happened.
pub(crate) fn is_equilibrium(summary: &Value) -> bool {
    summary["static"].is_object() && summary["step"]["count"].as_u64() == Some(0)
}

type Sentence = fn(&Value) -> Option<String>;

/// Share of all energy that a balance misses only where the step no longer resolved the motion.
const CAME_APART: f64 = 0.5;

fn unfinished(summary: &Value) -> Option<String> {
    let said = "The run stopped before its end: what follows covers the time up to there.";
    (summary["finished"].as_bool() == Some(false)).then(|| said.to_owned())
}

/// What a launch comes to that was not given: muzzle speeds and recoil, delays, spin.
fn launch(summary: &Value) -> Option<String> {
    let launch = &summary["launch"];
    let departures: Vec<&Value> = launch["tractors"].as_object()?.values().collect();
    let of_each = |key: &str| departures.iter().filter_map(|one| one[key].as_f64()).collect::<Vec<f64>>();
    let (speeds, times) = (of_each("speed_m_s"), of_each("time_s"));
    let left = match (speeds.len(), departures.len()) {
        (left, all) if left < all => format!("{left} of {all} tractors have left"),
        _ => "The tractors left".to_owned(),
    };
    let [speed, time_of] = [&speeds, &times].map(|values| {
        let least = values.iter().copied().reduce(f64::min)?;
        Some((least, values.iter().copied().fold(least, f64::max)))
    });
    let range = |(least, most): (f64, f64), write: fn(f64) -> String| match write(least) == write(most) {
        true => write(least),
        false => format!("{} to {}", write(least), write(most)),
    };
    let spin = launch["spin_rad_s"].as_f64().filter(|spin| *spin != 0.0);
    let is_plain = spin.is_none() && launch["recoil"].is_null() && time_of.is_none_or(|(_, latest)| latest == 0.0);
    if is_plain {
        return None;
    }
    let mut told = left;
    if let (Some(speed), Some(times)) = (speed, time_of) {
        told += &format!(" at {} m/s", range(speed, significant));
        if times.1 > 0.0 {
            told += &format!(", {} after the start", range(times, time));
        }
    }
    if let Some(spin) = spin {
        told += &format!(", all turning at {} rad/s", significant(spin));
    }
    let recoil = &launch["recoil"];
    if let (Some(peak), Some(impulse)) = (recoil["peak_n"].as_f64(), recoil["impulse_n_s"].as_f64()) {
        told += &format!("; the recoil is up to {}, {} N s in all", with_prefix(peak, "N"), significant(impulse));
    }
    Some(told + ".")
}

fn balance(summary: &Value) -> Option<String> {
    let found = &summary["static"];
    let (relative, tolerance) = (found["residual_relative"].as_f64(), found["tolerance"].as_f64()?);
    let iterations = format!("after {} iterations", found["iterations"].as_u64()?);
    let force = found["residual_n"].as_f64().map(|force| with_prefix(force, "N")).unwrap_or("no finite force".into());
    let place = found["residual_where"].as_str().map(|place| format!(" at {place}")).unwrap_or_default();
    Some(match relative.filter(|relative| *relative <= tolerance) {
        Some(relative) => {
            let what = if is_equilibrium(summary) { "Hangs" } else { "Starts" };
            format!(
                "{what} in equilibrium: {force}{place} is out of balance, {relative:.1e} of the largest tension or \
                load, {iterations}."
            )
        }
        None => {
            format!("Is not in equilibrium {iterations}: {force} is out of balance{place}. Do not trust these numbers.")
        }
    })
}

fn area_at_rest(summary: &Value) -> Option<String> {
    let opening = &summary["opening"];
    let area = opening["area_max_m2"].as_f64()?;
    let share = opening["reference_area_m2"].as_f64().filter(|reference| *reference > 0.0);
    let share = share.map(|reference| format!(" ({} of the flat web)", percent(area / reference)));
    Some(format!("Encloses {} m², seen along the launch axis{}.", significant(area), share.unwrap_or_default()))
}

fn middle_at_rest(summary: &Value) -> Option<String> {
    let travel = summary["points"]["centre"]["peak_travel_m"].as_f64().filter(|travel| *travel != 0.0)?;
    let side = if travel < 0.0 { "behind" } else { "ahead of" };
    Some(format!("The middle lies {} m {side} its place as drawn, along the launch axis.", significant(travel.abs())))
}

/// Whether the web is open as it begins, as one is that is held or thrown as it is drawn: it does not open then.
fn starts_open(summary: &Value) -> bool {
    summary["opening"]["effective_from_s"] == 0.0
}

/// Whether it is so from its beginning to its end.
fn stays_open(summary: &Value) -> bool {
    let (count, dt) = (summary["step"]["count"].as_f64(), summary["step"]["dt_s"].as_f64());
    let end = count.zip(dt).map(|(count, dt)| count * dt);
    let to = summary["opening"]["effective_to_s"].as_f64();
    // half a record or so
    starts_open(summary) && to.zip(end).is_none_or(|(to, end)| to >= 0.99 * end)
}

fn opening(summary: &Value) -> Option<String> {
    let opening = &summary["opening"];
    if stays_open(summary) {
        return None;
    }
    let area = opening["area_max_m2"].as_f64()?;
    let share = opening["reference_area_m2"].as_f64().filter(|reference| *reference > 0.0);
    let share = share.map(|reference| format!(" ({} of the flat web)", percent(area / reference)));
    let opens = if starts_open(summary) { "Its largest area is" } else { "Opens to" };
    Some(format!("{opens} {} m²{}{}.", significant(area), share.unwrap_or_default(), at(&opening["area_max_time_s"])))
}

fn effective_opening(summary: &Value) -> Option<String> {
    let opening = &summary["opening"];
    opening["area_max_m2"].as_f64()?;
    opening["reference_area_m2"].as_f64()?;
    if stays_open(summary) {
        return None;
    }
    let (Some(from), Some(to)) = (opening["effective_from_s"].as_f64(), opening["effective_to_s"].as_f64()) else {
        return Some("Never reaches 80 % of the flat web.".into());
    };
    let spell = to - from;
    let total = opening["effective_duration_s"].as_f64().unwrap_or(spell);
    // more than one spell: the longest is told, and what all of them come to
    let is_one_of_several = total > spell * 1.001 + 1e-9;
    Some(match (starts_open(summary), is_one_of_several) {
        (true, true) => {
            format!("Is open as it begins, and at least 80 % so until {}; for {} in all.", time(to), time(total))
        }
        (true, false) => format!("Is open as it begins, and at least 80 % so until {}.", time(to)),
        (false, true) => {
            format!(
                "At least 80 % open from {} to {}, its longest spell; {} in all.",
                time(from),
                time(to),
                time(total)
            )
        }
        (false, false) => format!("At least 80 % open from {} to {}, for {}.", time(from), time(to), time(spell)),
    })
}

fn hardest_pull(summary: &Value) -> Option<String> {
    let tension = &summary["tension"];
    let max = tension["max_n"].as_f64().filter(|max| *max > 0.0)?;
    let class = tension["max_where"].as_str();
    let rope = class.map(|class| format!(" is {} {class} rope", article(class))).unwrap_or(" bears".into());
    let colon = if class.is_some() { ":" } else { "" };
    Some(format!("The hardest pulled rope{rope}{colon} {}{}.", with_prefix(max, "N"), at(&tension["max_time_s"])))
}

/// What broke, in the order of time: what was made to, or what was not.
fn breaks(summary: &Value, released: bool) -> Vec<&Value> {
    let all = summary["breaks"].as_array().into_iter().flatten();
    all.filter(|one| one["released"].as_bool().unwrap_or(false) == released).collect()
}

/// Where, when and under what something broke.
fn break_in_words(one: &Value) -> Option<String> {
    let (place, tension) = (one["where"].as_str()?, with_prefix(one["tension_n"].as_f64()?, "N"));
    Some(format!("{place}{}, under {tension}", at(&one["time_s"])))
}

fn broken(summary: &Value) -> Option<String> {
    let breaks = breaks(summary, false);
    let first = break_in_words(breaks.first()?)?;
    Some(match breaks.len() {
        1 => format!("Something breaks: {first}."),
        more => format!("{more} segments break, the first of them {first}."),
    })
}

/// Break ties and stitches.
fn let_go(summary: &Value) -> Option<String> {
    let ties = breaks(summary, true);
    let (first, last) = (break_in_words(ties.first()?)?, break_in_words(ties.last()?)?);
    let (one, several) = match ["tie", "stitch"].map(|class| ties.iter().all(|tie| tie["class"] == class)) {
        [true, _] => ("tie", "ties"),
        [_, true] => ("stitch", "stitches"),
        _ => ("thread", "ties and stitches"),
    };
    Some(match ties.len() {
        1 => format!("One {one} lets go: {first}."),
        more => format!("{more} {several} let go, the first of them {first}, the last {last}."),
    })
}

/// The rope that comes nearest to breaking, of those whose strength is given.
fn worst_rope(summary: &Value) -> Option<String> {
    let ropes = summary["tension"]["by_rope"].as_object()?.iter();
    let used = ropes.filter_map(|(name, rope)| Some((name, rope, rope["utilisation"].as_f64()?)));
    let (name, rope, utilisation) = used.max_by(|(_, _, a), (_, _, b)| a.total_cmp(b)).filter(|(_, _, u)| *u > 0.0)?;
    let whose = match name.as_str() {
        "rope" => "The default rope".to_owned(),
        name => format!("Rope {name}"),
    };
    let class = rope["max_where"].as_str().map(|class| format!(", in {} {class} rope", article(class)));
    let knots = rope["knot_reduction"].as_f64().filter(|share| *share > 0.0);
    let left = match knots {
        Some(share) => format!("of the strength that knots leave it ({} less)", percent(share)),
        None => "of its strength".into(),
    };
    let broke = !breaks(summary, false).is_empty();
    let so = match utilisation <= 1.0 {
        true => format!("a margin of {}", significant(1.0 / utilisation)),
        false if broke => format!("a margin of {}", significant(1.0 / utilisation)),
        false => format!("it would break (margin {})", significant(1.0 / utilisation)),
    };
    Some(format!("{whose} is worst off: {} {left}{}; {so}.", percent(utilisation), class.unwrap_or_default()))
}

fn bottom_pull(summary: &Value) -> Option<String> {
    let tension = &summary["tension"];
    let max = tension["bottom_max_n"].as_f64()?;
    let mean = tension["bottom_mean_n"].as_f64();
    let mean = mean.map(|mean| format!(", {} on average while the web opens", with_prefix(mean, "N")));
    Some(format!(
        "The bottom ropes, which meet point B, bear up to {}{}.",
        with_prefix(max, "N"),
        mean.unwrap_or_default()
    ))
}

fn tractors(summary: &Value) -> Option<String> {
    let travel = summary["points"]["tractor"]["peak_travel_m"].as_f64().filter(|travel| *travel > 0.0);
    let area = summary["opening"]["tractor_area_max_m2"].as_f64();
    let travel = travel.map(|travel| {
        let when = summary["points"]["tractor"]["peak_travel_time_s"].as_f64();
        let when = when.map(|seconds| format!(" by {}", time(seconds))).unwrap_or_default();
        format!("travel {} m along the launch axis{when}", significant(travel))
    });
    let area = area.map(|area| {
        let when = at(&summary["opening"]["tractor_area_max_time_s"]);
        format!("span up to {} m²{when}", significant(area))
    });
    let done: Vec<String> = travel.into_iter().chain(area).collect();
    (!done.is_empty()).then(|| format!("The tractors {}.", done.join(" and ")))
}

fn fastest_point(summary: &Value) -> Option<String> {
    // tractors, corners and the centre are told of elsewhere: this is about the points that a designer named
    let named = summary["points"].as_object()?.iter().filter(|(name, _)| !is_part_of_the_web(name));
    let speeds = named.filter_map(|(name, point)| Some((name, point, point["peak_speed_m_s"].as_f64()?)));
    let (name, point, speed) = speeds.max_by(|(_, _, a), (_, _, b)| a.total_cmp(b)).filter(|(_, _, v)| *v > 0.0)?;
    Some(format!("Point {name} is the fastest: {} m/s{}.", significant(speed), at(&point["peak_speed_time_s"])))
}

fn is_part_of_the_web(name: &str) -> bool {
    matches!(name, "tractor" | "corner" | "centre")
}

fn posture(summary: &Value) -> Option<String> {
    let posture = &summary["posture"];
    let trails = posture["concave_from_s"].as_f64().map(|from| {
        let until = posture["concave_to_s"].as_f64().map(|to| format!(" until {}", time(to)));
        (from, "trails", format!("from {}{}", time(from), until.unwrap_or_default()))
    });
    let leads = posture["convex_from_s"].as_f64().map(|from| (from, "leads", format!("from {}", time(from))));
    let (first, then) = match (trails, leads) {
        (Some(trails), Some(leads)) if leads.0 < trails.0 => (leads, Some(trails)),
        (Some(trails), leads) => (trails, leads),
        (None, leads) => (leads?, None),
    };
    let then = then.map(|(_, verb, when)| format!(" and {verb} it {when}"));
    Some(format!("The middle {} the outline {}{}.", first.1, first.2, then.unwrap_or_default()))
}

fn target(summary: &Value) -> Option<String> {
    let target = &summary["target"];
    let size = format!("A target of {} m", significant(target["diameter_m"].as_f64()?));
    let most = target["coverage_max"].as_f64()?;
    let (Some(from), Some(to)) = (target["covered_from_s"].as_f64(), target["covered_to_s"].as_f64()) else {
        let when = at(&target["coverage_max_time_s"]);
        return Some(format!("{size} is never wholly covered: {} of it at most{when}.", percent(most)));
    };
    let spell = to - from;
    let total = target["covered_duration_s"].as_f64().unwrap_or(spell);
    let rest = match total > spell * 1.001 + 1e-9 {
        true => format!(", its longest spell; {} in all", time(total)),
        false => format!(", for {}", time(spell)),
    };
    Some(format!("{size} is wholly covered from {} to {}{rest}.", time(from), time(to)))
}

fn mouth(summary: &Value) -> Option<String> {
    let mouth = &summary["mouth"];
    let tilt = mouth["tilt_max_open_rad"].as_f64()?.to_degrees();
    let uneven = mouth["asymmetry_max_open"].as_f64();
    let uneven = uneven.map(|share| format!(", and the reach of its corners differs by {} at most", percent(share)));
    let tilt = if tilt < 0.05 { "less than 0.1".into() } else { format!("at most {tilt:.1}") };
    Some(format!("While it is open the mouth leans by {tilt}°{}.", uneven.unwrap_or_default()))
}

fn hang(summary: &Value) -> Option<String> {
    // beside an orbit nothing hangs about an apex
    if summary["energy"]["channels"]["orbit"].as_f64().is_some_and(|energy| energy != 0.0) {
        return None;
    }
    let flight = &summary["flight"];
    let (apex, hang) = (flight["apex_height_m"].as_f64()?, flight["hang_time_s"].as_f64()?);
    let least = if flight["still_up"].as_bool() == Some(true) { "at least " } else { "" };
    let cut = if least.is_empty() { "" } else { ", up to the end of the run" };
    Some(format!(
        "The web's centre of mass rises to {} m{} and hangs within 5 % of that for {least}{}{cut}.",
        significant(apex),
        at(&flight["apex_time_s"]),
        time(hang)
    ))
}

fn landing(summary: &Value) -> Option<String> {
    let flight = &summary["flight"];
    let touch = flight["touches_down_s"].as_f64()?;
    let drift = significant(flight["drift_m"].as_f64()?);
    let lies = flight["lies_from_s"].as_f64().map(|from| format!(", lies still from {}", time(from)));
    Some(format!(
        "It touches the ground at {}{} and ends {drift} m from where it started.",
        time(touch),
        lies.unwrap_or_default()
    ))
}

/// What the air has taken, or the wind given.
fn air(summary: &Value) -> Option<String> {
    let (air, energy) = (&summary["air"], &summary["energy"]);
    let density = format!("{} kg/m³", significant(air["density_kg_m3"].as_f64()?));
    let taken = energy["channels"]["air"].as_f64()?;
    let wind = air["wind_m_s"].as_array().into_iter().flatten().filter_map(Value::as_f64);
    let speed = wind.map(|along| along * along).sum::<f64>().sqrt();
    let change = air["wind_change_max_m_s"].as_f64().filter(|change| *change > 0.0);
    let moving = match (speed > 0.0, change) {
        (true, _) => format!(" that moves at {} m/s at the start", significant(speed)),
        (false, Some(change)) => format!(" that moves at up to {} m/s", significant(change)),
        (false, None) => String::new(),
    };
    let initial = energy["initial_j"].as_f64().filter(|initial| *initial > taken.abs());
    let share = initial.map(|initial| format!(", {} of what there was at the start", percent(taken.abs() / initial)));
    let verb = if taken < 0.0 { "gives" } else { "takes" };
    let (taken, share) = (with_prefix(taken.abs(), "J"), share.unwrap_or_default());
    Some(format!("Drag {verb} {taken}{share}, in a medium of {density}{moving}."))
}

fn energy(summary: &Value) -> Option<String> {
    let energy = &summary["energy"];
    let closure = energy["closure"].as_f64()?;
    let web = energy["closure_web"].as_f64();
    let misses = |closure: Option<f64>, tolerance: &Value| closure.zip(tolerance.as_f64()).is_some_and(|(c, t)| c > t);
    let missed = misses(Some(closure), &energy["tolerance"]) || misses(web, &energy["tolerance_web"]);
    let web = web.map(|web| format!(" ({} of what the web itself holds)", percent(web))).unwrap_or_default();
    Some(match missed {
        true => format!(
            "The energy balance is off by {}{web}, more than is allowed: do not trust these numbers.",
            percent(closure)
        ),
        false => format!("The energy balance closes to {}{web}.", percent(closure)),
    })
}

fn at(time_s: &Value) -> String {
    time_s.as_f64().map(|seconds| format!(" at {}", time(seconds))).unwrap_or_default()
}

fn article(noun: &str) -> &'static str {
    if noun.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn full() -> Value {
        json!({
            "finished": true,
            "opening": {
                "area_max_m2": 15.8, "area_max_time_s": 0.131, "reference_area_m2": 16.238,
                "effective_from_s": 0.112, "effective_to_s": 0.193, "effective_duration_s": 0.081,
                "tractor_area_max_m2": 32.4, "tractor_area_max_time_s": 0.16
            },
            "points": {
                "A": {"peak_speed_m_s": 71.0, "peak_speed_time_s": 0.01},
                "B": {"peak_speed_m_s": 112.4, "peak_speed_time_s": 0.07},
                "tractor": {"peak_speed_m_s": 900.0, "peak_travel_m": 5.93, "peak_travel_time_s": 0.5}
            },
            "tension": {
                "max_n": 51000.0, "max_time_s": 0.15, "max_where": "outline",
                "bottom_max_n": 14200.0, "bottom_mean_n": 3900.0,
                "by_class": {"outline": {"max_n": 51000.0, "margin": 2.3}},
                "by_rope": {
                    "rope": {"max_n": 9000.0, "utilisation": null},
                    "border": {"max_n": 51000.0, "max_where": "outline", "utilisation": 0.5435, "knot_reduction": 0.2}
                }
            },
            "mouth": {"tilt_max_open_rad": 0.05, "asymmetry_max_open": 0.02},
            "target": {"diameter_m": 1.5, "coverage_max": 1.0, "coverage_max_time_s": 0.06,
                       "covered_from_s": 0.05, "covered_to_s": 0.26, "covered_duration_s": 0.21},
            "flight": {"apex_height_m": 5.76, "apex_time_s": 0.539, "hang_time_s": 0.246, "still_up": true,
                       "touches_down_s": 2.11, "lies_from_s": 2.9, "drift_m": 8.41},
            "posture": {"concave_from_s": 0.004, "concave_to_s": 0.187, "convex_from_s": 0.212},
            "energy": {"closure": 0.0005, "closure_web": 0.0031, "tolerance": 0.003}
        })
    }

    #[test]
    fn beside_an_orbit_nothing_hangs_about_an_apex() {
        let mut summary = full();
        assert!(words(&summary).iter().any(|told| told.contains("hangs within")));
        summary["energy"]["channels"] = json!({"orbit": 1e-4});
        assert!(words(&summary).iter().all(|told| !told.contains("hangs within")));
    }

    #[test]
    fn of_a_run_that_came_apart_only_that_is_told() {
        let mut summary = full();
        summary["finished"] = json!(false);
        summary["energy"]["closure"] = json!(0.993);
        let told = words(&summary);
        assert_eq!(told.len(), 2, "{told:?}");
        assert!(told[0].starts_with("The run stopped") && told[1].contains("do not trust"));
    }

    #[test]
    fn of_an_equilibrium_no_story_is_told() {
        let mut summary = full();
        summary["step"] = json!({"count": 0});
        summary["points"]["centre"] = json!({"peak_travel_m": -0.695});
        summary["static"] = json!({"residual_n": 6.2e-6, "residual_relative": 4.3e-7, "residual_where": "knot 6",
                                   "tolerance": 1e-6, "iterations": 945});
        let told = words(&summary);
        assert_eq!(
            told[..4],
            [
                "Hangs in equilibrium: 6.20e-6 N at knot 6 is out of balance, 4.3e-7 of the largest tension or load, after \
                 945 iterations.",
                "Encloses 15.8 m², seen along the launch axis (97 % of the flat web).",
                "The middle lies 0.695 m behind its place as drawn, along the launch axis.",
                "The hardest pulled rope is an outline rope: 51.0 kN.",
            ]
        );
        assert_eq!(told.len(), 5);
        summary["static"]["residual_relative"] = json!(1e-3);
        assert!(words(&summary)[0].contains("not in equilibrium") && words(&summary)[0].contains("Do not trust"));
        summary["step"]["count"] = json!(100);
        summary["static"]["residual_relative"] = json!(1e-7);
        assert!(words(&summary)[0].starts_with("Starts in equilibrium") && words(&summary).len() == 14);
    }

    #[test]
    fn a_launch_is_told_in_full() {
        assert_eq!(
            words(&full()),
            [
                "Opens to 15.8 m² (97 % of the flat web) at 0.131 s.",
                "At least 80 % open from 0.112 s to 0.193 s, for 0.081 s.",
                "A target of 1.50 m is wholly covered from 0.050 s to 0.260 s, for 0.210 s.",
                "The hardest pulled rope is an outline rope: 51.0 kN at 0.150 s.",
                "Rope border is worst off: 54 % of the strength that knots leave it (20 % less), in an outline rope; a margin of 1.84.",
                "The bottom ropes, which meet point B, bear up to 14.2 kN, 3.90 kN on average while the web opens.",
                "The tractors travel 5.93 m along the launch axis by 0.500 s and span up to 32.4 m² at 0.160 s.",
                "Point B is the fastest: 112 m/s at 0.070 s.",
                "The middle trails the outline from 0.004 s until 0.187 s and leads it from 0.212 s.",
                "While it is open the mouth leans by at most 2.9°, and the reach of its corners differs by 2 % at most.",
                "The web's centre of mass rises to 5.76 m at 0.539 s and hangs within 5 % of that for at least 0.246 s, up to \
                 the end of the run.",
                "It touches the ground at 2.110 s, lies still from 2.900 s and ends 8.41 m from where it started.",
                "The energy balance closes to 0.05 % (0.31 % of what the web itself holds).",
            ]
        );
    }

    #[test]
    fn what_is_null_or_missing_is_not_spoken_of() {
        assert!(words(&json!({})).is_empty());
        let summary = json!({
            "finished": true,
            "opening": {"area_max_m2": null, "reference_area_m2": null},
            "points": {"tractor": null, "centre": {"peak_travel_m": 0.2}},
            "tension": {"max_n": 120.0, "max_time_s": null, "max_where": null},
            "posture": {"concave_from_s": null, "concave_to_s": null, "convex_from_s": null},
            "energy": {"closure": 0.0, "closure_web": null}
        });
        assert_eq!(words(&summary), ["The hardest pulled rope bears 120 N.", "The energy balance closes to 0 %."]);
    }

    #[test]
    fn a_web_that_is_open_as_it_begins_does_not_open() {
        let about_opening = |to: f64, total: f64| {
            let opening = json!({"area_max_m2": 15.7, "area_max_time_s": 0.8, "reference_area_m2": 16.0,
                                 "effective_from_s": 0.0, "effective_to_s": to, "effective_duration_s": total});
            words(&json!({"finished": true, "opening": opening, "step": {"count": 100, "dt_s": 0.01}}))
        };
        assert_eq!(about_opening(1.0, 1.0), [""; 0]);
        let largest = "Its largest area is 15.7 m² (98 % of the flat web) at 0.800 s.";
        assert_eq!(about_opening(0.4, 0.4), [largest, "Is open as it begins, and at least 80 % so until 0.400 s."]);
        // and opens again
        let again = "Is open as it begins, and at least 80 % so until 0.400 s; for 0.600 s in all.";
        assert_eq!(about_opening(0.4, 0.6), [largest, again]);
    }

    /// Of a summary with what was made to break, and with what was not.
    #[test]
    fn ties_let_go_and_ropes_break() {
        let at = |class: &str, released: bool, time_s: f64| json!({"where": format!("{class} 1"), "class": class, "time_s": time_s, "tension_n": 50.0, "released": released});
        let said = |breaks: Value| words(&json!({"finished": true, "breaks": breaks}));
        assert_eq!(said(json!([at("tie", true, 0.2)])), ["One tie lets go: tie 1 at 0.200 s, under 50.0 N."]);
        let all = said(json!([at("tie", true, 0.1), at("ring", false, 0.2), at("stitch", true, 0.3)]));
        assert_eq!(
            all,
            [
                "2 ties and stitches let go, the first of them tie 1 at 0.100 s, under 50.0 N, the last stitch 1 at 0.300 s, \
                 under 50.0 N.",
                "Something breaks: ring 1 at 0.200 s, under 50.0 N."
            ]
        );
    }

    #[test]
    fn what_went_wrong_is_said() {
        let mut summary = full();
        summary["finished"] = json!(false);
        summary["opening"]["effective_from_s"] = json!(null);
        summary["tension"]["by_rope"]["border"] = json!({"utilisation": 1.25});
        summary["target"]["covered_from_s"] = json!(null);
        summary["target"]["coverage_max"] = json!(0.62);
        summary["energy"]["closure"] = json!(0.02);
        let told = words(&summary);
        assert!(told[0].contains("stopped before its end"));
        assert_eq!(told[2], "Never reaches 80 % of the flat web.");
        assert_eq!(told[3], "A target of 1.50 m is never wholly covered: 62 % of it at most at 0.060 s.");
        assert_eq!(told[5], "Rope border is worst off: 125 % of its strength; it would break (margin 0.800).");
        assert!(told.last().unwrap().contains("off by 2 %") && told.last().unwrap().contains("do not trust"));
    }

    #[test]
    fn a_web_whose_own_energy_does_not_close_is_not_trusted_either() {
        let mut summary = full();
        summary["energy"]["tolerance_web"] = json!(0.001);
        assert!(words(&summary).last().unwrap().contains("do not trust"));
    }

    #[test]
    fn the_middle_is_told_of_in_the_order_of_time() {
        let told = |posture: Value| words(&json!({ "posture": posture }));
        assert_eq!(
            told(json!({"concave_from_s": 0.2, "concave_to_s": 0.4, "convex_from_s": 0.15})),
            ["The middle leads the outline from 0.150 s and trails it from 0.200 s until 0.400 s."]
        );
        assert_eq!(
            told(json!({"concave_from_s": 0.2, "concave_to_s": 0.4, "convex_from_s": null})),
            ["The middle trails the outline from 0.200 s until 0.400 s."]
        );
        assert_eq!(told(json!({"convex_from_s": 0.15})), ["The middle leads the outline from 0.150 s."]);
    }

    #[test]
    fn several_spells_of_opening_are_told_apart_from_one() {
        let mut summary = full();
        summary["opening"]["effective_duration_s"] = json!(0.12);
        assert_eq!(
            words(&summary)[1],
            "At least 80 % open from 0.112 s to 0.193 s, its longest spell; 0.120 s in all."
        );
    }

    #[test]
    fn what_the_air_takes_or_the_wind_gives_is_told() {
        let mut summary = json!({"energy": {"initial_j": 4000.0, "channels": {"air": 100.0}},
                                 "air": {"density_kg_m3": 1.2, "wind_m_s": [0.0, 0.0, 0.0], "wind_change_max_m_s": 0.0}});
        let still = "Drag takes 100 J, 2.5 % of what there was at the start, in a medium of 1.20 kg/m³.";
        assert_eq!(air(&summary).unwrap(), still);
        summary["energy"] = json!({"initial_j": 0.0, "channels": {"air": -12.0}});
        summary["air"]["wind_m_s"] = json!([3.0, 4.0, 0.0]);
        let windy = "Drag gives 12.0 J, in a medium of 1.20 kg/m³ that moves at 5.00 m/s at the start.";
        assert_eq!(air(&summary).unwrap(), windy);
        assert_eq!(air(&json!({"air": null, "energy": {"channels": {"air": 0.0}}})), None);
    }

    #[test]
    fn a_launch_is_told_where_it_is_more_than_its_speed() {
        let one = |speed: f64, time: f64| json!({"speed_m_s": speed, "time_s": time, "angle_rad": 0.3});
        let mut launch =
            json!({"spin_rad_s": 0.0, "tractors": {"1": one(50.0, 0.0), "2": one(50.0, 0.0)}, "recoil": null});
        let told = |launch: &Value| super::launch(&json!({ "launch": launch }));
        assert_eq!(told(&launch), None);
        assert_eq!(told(&Value::Null), None);
        launch["spin_rad_s"] = json!(20.0);
        assert_eq!(told(&launch).unwrap(), "The tractors left at 50.0 m/s, all turning at 20.0 rad/s.");
        launch = json!({
            "spin_rad_s": 0.0,
            "tractors": {"1": one(31.0, 0.02), "2": one(33.0, 0.03), "3": {"speed_m_s": null, "time_s": null}},
            "recoil": {"peak_n": 4500.0, "impulse_n_s": 95.0},
        });
        let expected = "2 of 3 tractors have left at 31.0 to 33.0 m/s, 0.020 s to 0.030 s after the start; the recoil is up to \
                        4.50 kN, 95.0 N s in all.";
        assert_eq!(told(&launch).unwrap(), expected);
    }
}

//! The result of a run as sentences for a designer.

use netcast_results::summary::{BrokenSegment, Departure};
use netcast_results::{OPEN_SHARE, Summary};

use crate::format::{percent, significant, time, with_prefix};

/// The result of a run as sentences, most important first.
///
/// A missing or null value gives no sentence. The first sentence says whether the run stopped before its end. A run
/// whose energy balance failed gets only the sentence on energy: its other numbers mean nothing.
///
/// ```
/// let mut summary = netcast_results::Summary { finished: true, ..Default::default() };
/// summary.opening.area_max_m2 = Some(15.8);
/// summary.opening.area_max_time_s = Some(0.131);
/// summary.opening.reference_area_m2 = Some(16.238);
/// assert_eq!(netcast_report::words(&summary)[0], "Opens to 15.8 m² (97 % of the flat web) at 0.131 s.");
/// ```
pub fn words(summary: &Summary) -> Vec<String> {
    if is_equilibrium(summary) {
        let mut timeless = summary.clone();
        timeless.tension.max_time_s = None;
        let told: [Sentence; 5] = [balance, area_at_rest, middle_at_rest, hardest_pull, worst_rope];
        return told.iter().filter_map(|sentence| sentence(&timeless)).collect();
    }
    let told: &[Sentence] = if summary.energy.closure > CAME_APART {
        &[unfinished, energy]
    } else {
        &[
            unfinished,
            balance,
            launch,
            opening,
            effective_opening,
            target,
            let_go,
            cut,
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
        ]
    };
    told.iter().filter_map(|sentence| sentence(summary)).collect()
}

/// Whether the result is an equilibrium alone, without a step in time.
pub(crate) fn is_equilibrium(summary: &Summary) -> bool {
    summary.statics.is_some() && summary.step.count == 0
}

type Sentence = fn(&Summary) -> Option<String>;

/// Closure of the energy balance above which the step did not resolve the motion.
const CAME_APART: f64 = 0.5;

fn unfinished(summary: &Summary) -> Option<String> {
    let said = "The run stopped before its end: what follows covers the time up to there.";
    (!summary.finished).then(|| said.to_owned())
}

/// Computed values of the launch: muzzle speeds and recoil, delays, spin.
fn launch(summary: &Summary) -> Option<String> {
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
    let is_plain = spin.is_none() && launch.recoil.is_none() && time_of.is_none_or(|(_, latest)| latest == 0.0);
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
    if let Some(recoil) = &launch.recoil {
        let (peak, impulse) = (with_prefix(recoil.peak_n, "N"), significant(recoil.impulse_n_s));
        told += &format!("; the recoil is up to {peak}, {impulse} N s in all");
    }
    Some(told + ".")
}

fn balance(summary: &Summary) -> Option<String> {
    let found = summary.statics.as_ref()?;
    let iterations = format!("after {} iterations", found.iterations);
    let force = found.residual_n.map(|force| with_prefix(force, "N")).unwrap_or("no finite force".into());
    let place = found.residual_where.as_ref().map(|place| format!(" at {place}")).unwrap_or_default();
    Some(match found.residual_relative.filter(|relative| *relative <= found.tolerance) {
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

fn area_at_rest(summary: &Summary) -> Option<String> {
    let opening = &summary.opening;
    let area = opening.area_max_m2?;
    let share = opening.reference_area_m2.filter(|reference| *reference > 0.0);
    let share = share.map(|reference| format!(" ({} of the flat web)", percent(area / reference)));
    Some(format!("Encloses {} m², seen along the launch axis{}.", significant(area), share.unwrap_or_default()))
}

fn middle_at_rest(summary: &Summary) -> Option<String> {
    let travel = peak_travel(summary, "centre").filter(|travel| *travel != 0.0)?;
    let side = if travel < 0.0 { "behind" } else { "ahead of" };
    Some(format!("The middle lies {} m {side} its place as drawn, along the launch axis.", significant(travel.abs())))
}

/// Whether the web is open at the start, such as a web that is held or thrown flat.
fn starts_open(summary: &Summary) -> bool {
    summary.opening.effective_from_s == Some(0.0)
}

/// Whether the web is open from start to end.
fn stays_open(summary: &Summary) -> bool {
    let end = summary.step.count as f64 * summary.step.dt_s;
    // half a record or so; where a file does not tell the end, it is not a number, and nothing is short of it
    let closes = summary.opening.effective_to_s.is_some_and(|to| to < 0.99 * end);
    starts_open(summary) && !closes
}

fn opening(summary: &Summary) -> Option<String> {
    let opening = &summary.opening;
    if stays_open(summary) {
        return None;
    }
    let area = opening.area_max_m2?;
    let share = opening.reference_area_m2.filter(|reference| *reference > 0.0);
    let share = share.map(|reference| format!(" ({} of the flat web)", percent(area / reference)));
    let opens = if starts_open(summary) { "Its largest area is" } else { "Opens to" };
    Some(format!("{opens} {} m²{}{}.", significant(area), share.unwrap_or_default(), at(opening.area_max_time_s)))
}

fn effective_opening(summary: &Summary) -> Option<String> {
    let opening = &summary.opening;
    opening.area_max_m2?;
    opening.reference_area_m2?;
    if stays_open(summary) {
        return None;
    }
    let (Some(from), Some(to)) = (opening.effective_from_s, opening.effective_to_s) else {
        return Some(format!("Never reaches {} of the flat web.", percent(OPEN_SHARE)));
    };
    let spell = to - from;
    let total = opening.effective_duration_s.unwrap_or(spell);
    // several spells: the sentence gives the longest and the sum of all
    let is_one_of_several = total > spell * 1.001 + 1e-9;
    let [from, to, spell, total] = [from, to, spell, total].map(time);
    let open = percent(OPEN_SHARE);
    Some(match (starts_open(summary), is_one_of_several) {
        (true, true) => format!("Is open at the start, and at least {open} so until {to}; for {total} in all."),
        (true, false) => format!("Is open at the start, and at least {open} so until {to}."),
        (false, true) => format!("At least {open} open from {from} to {to}, its longest spell; {total} in all."),
        (false, false) => format!("At least {open} open from {from} to {to}, for {spell}."),
    })
}

fn hardest_pull(summary: &Summary) -> Option<String> {
    let tension = &summary.tension;
    let max = Some(tension.max_n).filter(|max| *max > 0.0)?;
    let class = tension.max_where.as_ref();
    let rope = class.map(|class| format!(" is {} {class} rope", article(class))).unwrap_or(" bears".into());
    let colon = if class.is_some() { ":" } else { "" };
    Some(format!("The hardest pulled rope{rope}{colon} {}{}.", with_prefix(max, "N"), at(tension.max_time_s)))
}

/// What broke, in the order of time: what was made to, or what was not.
fn breaks(summary: &Summary, released: bool) -> Vec<&BrokenSegment> {
    summary.breaks.iter().filter(|one| one.released == released).collect()
}

/// Where, when and under what something broke.
fn break_in_words(one: &BrokenSegment) -> String {
    format!("{}{}, under {}", one.place, at(Some(one.time_s)), with_prefix(one.tension_n, "N"))
}

fn broken(summary: &Summary) -> Option<String> {
    let breaks = breaks(summary, false);
    let first = break_in_words(breaks.first()?);
    Some(match breaks.len() {
        1 => format!("Something breaks: {first}."),
        more => format!("{more} segments break, the first of them {first}."),
    })
}

/// Ropes that were cut.
fn cut(summary: &Summary) -> Option<String> {
    let cuts: Vec<String> = summary.breaks.iter().filter(|one| one.cut).map(break_in_words).collect();
    Some(match cuts.len() {
        0 => return None,
        1 => format!("One rope is cut: {}.", cuts[0]),
        more => format!("{more} ropes are cut, the first of them {}.", cuts[0]),
    })
}

/// Break ties and stitches.
fn let_go(summary: &Summary) -> Option<String> {
    let ties: Vec<&BrokenSegment> = breaks(summary, true).into_iter().filter(|one| !one.cut).collect();
    let (first, last) = (break_in_words(ties.first()?), break_in_words(ties.last()?));
    let (one, several) = match ["tie", "stitch"].map(|class| ties.iter().all(|tie| tie.class == class)) {
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
fn worst_rope(summary: &Summary) -> Option<String> {
    let used = summary.tension.by_rope.iter().filter_map(|(name, rope)| Some((name, rope, rope.utilisation?)));
    let (name, rope, utilisation) = used.max_by(|(_, _, a), (_, _, b)| a.total_cmp(b)).filter(|(_, _, u)| *u > 0.0)?;
    let whose = match name.as_str() {
        "rope" => "The default rope".to_owned(),
        name => format!("Rope {name}"),
    };
    let class = rope.max_where.as_ref().map(|class| format!(", in {} {class} rope", article(class)));
    let knots = rope.knot_reduction.filter(|share| *share > 0.0);
    let left = match knots {
        Some(share) => format!("of the strength that knots leave it ({} less)", percent(share)),
        None => "of its strength".into(),
    };
    let broke = !breaks(summary, false).is_empty();
    let margin = significant(1.0 / utilisation);
    let holds = utilisation <= 1.0 || broke;
    let so = if holds { format!("a margin of {margin}") } else { format!("it would break (margin {margin})") };
    Some(format!("{whose} is worst off: {} {left}{}; {so}.", percent(utilisation), class.unwrap_or_default()))
}

fn bottom_pull(summary: &Summary) -> Option<String> {
    let tension = &summary.tension;
    let max = tension.bottom_max_n?;
    let mean = tension.bottom_mean_n.map(|mean| format!(", {} on average while the web opens", with_prefix(mean, "N")));
    Some(format!(
        "The bottom ropes, which meet point B, bear up to {}{}.",
        with_prefix(max, "N"),
        mean.unwrap_or_default()
    ))
}

fn tractors(summary: &Summary) -> Option<String> {
    let tractor = summary.points.get("tractor").and_then(Option::as_ref);
    let travel = peak_travel(summary, "tractor").filter(|travel| *travel > 0.0);
    let area = summary.opening.tractor_area_max_m2;
    let travel = travel.map(|travel| {
        let when = tractor.and_then(|tractor| tractor.peak_travel_time_s);
        let when = when.map(|seconds| format!(" by {}", time(seconds))).unwrap_or_default();
        format!("travel {} m along the launch axis{when}", significant(travel))
    });
    let area = area.map(|area| {
        let when = at(summary.opening.tractor_area_max_time_s);
        format!("span up to {} m²{when}", significant(area))
    });
    let done: Vec<String> = travel.into_iter().chain(area).collect();
    (!done.is_empty()).then(|| format!("The tractors {}.", done.join(" and ")))
}

fn fastest_point(summary: &Summary) -> Option<String> {
    // tractors, corners and the centre are told of elsewhere: this is about the points that a designer named
    let named = summary.points.iter().filter(|(name, _)| !is_part_of_the_web(name));
    let speeds = named.filter_map(|(name, point)| Some((name, point.as_ref()?, point.as_ref()?.peak_speed_m_s?)));
    let (name, point, speed) = speeds.max_by(|(_, _, a), (_, _, b)| a.total_cmp(b)).filter(|(_, _, v)| *v > 0.0)?;
    Some(format!("Point {name} is the fastest: {} m/s{}.", significant(speed), at(point.peak_speed_time_s)))
}

/// Farthest travel of a point, m; none where the web has no such point.
fn peak_travel(summary: &Summary, point: &str) -> Option<f64> {
    summary.points.get(point)?.as_ref()?.peak_travel_m
}

fn is_part_of_the_web(name: &str) -> bool {
    matches!(name, "tractor" | "corner" | "centre")
}

fn posture(summary: &Summary) -> Option<String> {
    let posture = &summary.posture;
    let trails = posture.concave_from_s.map(|from| {
        let until = posture.concave_to_s.map(|to| format!(" until {}", time(to)));
        (from, "trails", format!("from {}{}", time(from), until.unwrap_or_default()))
    });
    let leads = posture.convex_from_s.map(|from| (from, "leads", format!("from {}", time(from))));
    let (first, then) = match (trails, leads) {
        (Some(trails), Some(leads)) if leads.0 < trails.0 => (leads, Some(trails)),
        (Some(trails), leads) => (trails, leads),
        (None, leads) => (leads?, None),
    };
    let then = then.map(|(_, verb, when)| format!(" and {verb} it {when}"));
    Some(format!("The middle {} the outline {}{}.", first.1, first.2, then.unwrap_or_default()))
}

fn target(summary: &Summary) -> Option<String> {
    let target = summary.target.as_ref()?;
    let size = format!("A target of {} m", significant(target.diameter_m));
    let most = target.coverage_max?;
    let (Some(from), Some(to)) = (target.covered_from_s, target.covered_to_s) else {
        let when = at(target.coverage_max_time_s);
        return Some(format!("{size} is never wholly covered: {} of it at most{when}.", percent(most)));
    };
    let spell = to - from;
    let total = target.covered_duration_s.unwrap_or(spell);
    let rest = if total > spell * 1.001 + 1e-9 {
        format!(", its longest spell; {} in all", time(total))
    } else {
        format!(", for {}", time(spell))
    };
    Some(format!("{size} is wholly covered from {} to {}{rest}.", time(from), time(to)))
}

fn mouth(summary: &Summary) -> Option<String> {
    let tilt = summary.mouth.tilt_max_open_rad?.to_degrees();
    let uneven = summary
        .mouth
        .asymmetry_max_open
        .map(|share| format!(", and the reach of its corners differs by {} at most", percent(share)));
    let tilt = if tilt < 0.05 { "less than 0.1".into() } else { format!("at most {tilt:.1}") };
    Some(format!("While it is open the mouth leans by {tilt}°{}.", uneven.unwrap_or_default()))
}

fn hang(summary: &Summary) -> Option<String> {
    // beside an orbit nothing hangs about an apex
    if summary.energy.channels.get("orbit").is_some_and(|energy| *energy != 0.0) {
        return None;
    }
    let flight = &summary.flight;
    let (apex, hang) = (flight.apex_height_m?, flight.hang_time_s?);
    let least = if flight.still_up == Some(true) { "at least " } else { "" };
    let cut = if least.is_empty() { "" } else { ", up to the end of the run" };
    Some(format!(
        "The web's centre of mass rises to {} m{} and hangs within 5 % of that for {least}{}{cut}.",
        significant(apex),
        at(flight.apex_time_s),
        time(hang)
    ))
}

fn landing(summary: &Summary) -> Option<String> {
    let flight = &summary.flight;
    let touch = flight.touches_down_s?;
    let drift = significant(flight.drift_m?);
    let lies = flight.lies_from_s.map(|from| format!(", lies still from {}", time(from)));
    Some(format!(
        "It touches the ground at {}{} and ends {drift} m from where it started.",
        time(touch),
        lies.unwrap_or_default()
    ))
}

/// What the air has taken, or the wind given.
fn air(summary: &Summary) -> Option<String> {
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
    let initial = Some(summary.energy.initial_j).filter(|initial| *initial > taken.abs());
    let share = initial.map(|initial| format!(", {} of what there was at the start", percent(taken.abs() / initial)));
    let verb = if taken < 0.0 { "gives" } else { "takes" };
    let (taken, share) = (with_prefix(taken.abs(), "J"), share.unwrap_or_default());
    Some(format!("Drag {verb} {taken}{share}, in a medium of {density}{moving}."))
}

fn energy(summary: &Summary) -> Option<String> {
    let energy = &summary.energy;
    let closure = Some(energy.closure).filter(|closure| closure.is_finite())?;
    // what a file does not tell is not a number, and nothing is above it
    let missed = closure > energy.tolerance || energy.closure_web.is_some_and(|web| web > energy.tolerance_web);
    let web = energy.closure_web.map(|web| format!(" ({} of what the web itself holds)", percent(web)));
    let closes = format!("{}{}", percent(closure), web.unwrap_or_default());
    Some(if missed {
        format!("The energy balance is off by {closes}, more than is allowed: do not trust these numbers.")
    } else {
        format!("The energy balance closes to {closes}.")
    })
}

fn at(time_s: Option<f64>) -> String {
    time_s.map(|seconds| format!(" at {}", time(seconds))).unwrap_or_default()
}

fn article(noun: &str) -> &'static str {
    if noun.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" }
}

#[cfg(test)]
mod tests;

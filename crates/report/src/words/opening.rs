//! How far the web opens, where and for how long; its mouth, its posture and the target that it covers.

use netcast_results::{OPEN_SHARE, Summary};

use super::phrases::{at, is_start, lasting, spell, sum_of_several};
use crate::format::{beside, is_seen, metres, percent, percent_to, share_of_flat, significant, time};

/// An area below this, m², is none.
const LEAST_AREA: f64 = 1e-4;

/// A share that reads as zero in the company of whole per cent.
const LEAST_SHARE: f64 = 5e-4;

/// The largest area as a share of the flat web's, where that is known.
fn largest_share(summary: &Summary) -> Option<f64> {
    let reference = summary.opening.reference_area_m2.filter(|reference| *reference > 0.0)?;
    Some(summary.opening.area_max_m2? / reference)
}

/// The largest area and its share of the flat web's; none where there is next to no area.
fn largest_area(summary: &Summary) -> Option<String> {
    let area = summary.opening.area_max_m2.filter(|area| *area >= LEAST_AREA)?;
    let share = largest_share(summary);
    if share.is_some_and(|share| share < LEAST_SHARE) {
        return None;
    }
    let share = share.map(|share| format!(" ({} of the flat web)", share_of_flat(share)));
    Some(format!("{} m²{}", significant(area), share.unwrap_or_default()))
}

pub(super) fn area_at_rest(summary: &Summary) -> Option<String> {
    summary.opening.area_max_m2?;
    let Some(area) = largest_area(summary) else {
        return Some("Encloses no area, seen along the launch axis.".into());
    };
    let (area, share) = area.split_once(" (").map_or((&area[..], String::new()), |(a, b)| (a, format!(" ({b}")));
    Some(format!("Encloses {area}, seen along the launch axis{share}."))
}

/// Whether the web is open at the start, such as a web that is held or thrown flat.
fn starts_open(summary: &Summary) -> bool {
    summary.opening.effective_from_s.is_some_and(is_start)
}

/// Whether the web is open from start to end.
fn stays_open(summary: &Summary) -> bool {
    let end = summary.step.count as f64 * summary.step.dt_s;
    // half a record or so; where a file does not tell the end, it is not a number, and nothing is short of it
    let closes = summary.opening.effective_to_s.is_some_and(|to| to < 0.99 * end);
    starts_open(summary) && !closes
}

pub(super) fn opening(summary: &Summary) -> Option<String> {
    let opening = &summary.opening;
    if stays_open(summary) {
        return None;
    }
    opening.area_max_m2?;
    let Some(area) = largest_area(summary) else { return Some("The web does not open.".into()) };
    let opens = if starts_open(summary) { "Its largest area is" } else { "Opens to" };
    Some(format!("{opens} {area}{}.", at(opening.area_max_time_s)))
}

pub(super) fn effective_opening(summary: &Summary) -> Option<String> {
    let opening = &summary.opening;
    let share = largest_share(summary)?;
    if stays_open(summary) || largest_area(summary).is_none() {
        return None;
    }
    let open = percent(OPEN_SHARE);
    let (Some(from), Some(to)) = (opening.effective_from_s, opening.effective_to_s) else {
        return (share < OPEN_SHARE).then(|| format!("Never reaches {open} of the flat web."));
    };
    if !starts_open(summary) {
        return Some(format!("At least {open} open {}.", spell(from, to, opening.effective_duration_s)));
    }
    if is_start(to) {
        return Some(format!("Is at least {open} open at the start, for {}.", lasting(to - from)));
    }
    let total = sum_of_several(to - from, opening.effective_duration_s);
    let total = total.map(|total| format!("; for {} in all", time(total))).unwrap_or_default();
    Some(format!("Is open at the start, and at least {open} so until {}{total}.", time(to)))
}

/// Where the web is when it has opened.
pub(super) fn place_of_opening(summary: &Summary) -> Option<String> {
    let place = &summary.places.opening;
    let travel = place.travel_m.filter(|_| summary.opening.effective_from_s.is_some() && !starts_open(summary))?;
    let ground = place.ground_distance_m.filter(|distance| is_seen(*distance));
    let ground = ground.map(|distance| format!("{} over the ground", metres(distance)));
    let height = place.height_m.map(|height| match height {
        level if !is_seen(level) => "level with the muzzle".to_owned(),
        above if above > 0.0 => format!("{} above the muzzle", metres(above)),
        below => format!("{} below the muzzle", metres(-below)),
    });
    let more: Vec<String> = ground.into_iter().chain(height).collect();
    let more = if more.is_empty() { String::new() } else { format!(": {}", more.join(", ")) };
    let open = percent(OPEN_SHARE);
    Some(format!("It reaches {open} after {} along the launch axis{more}.", metres(travel)))
}

pub(super) fn posture(summary: &Summary) -> Option<String> {
    let posture = &summary.posture;
    // a spell without a length is none
    let is_moment = |from: f64| posture.concave_to_s.is_some_and(|to| time(to) == time(from));
    let trails = posture.concave_from_s.filter(|from| !is_moment(*from)).map(|from| {
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

pub(super) fn target(summary: &Summary) -> Option<String> {
    let target = summary.target.as_ref()?;
    let size = format!("A target of {} m", significant(target.diameter_m));
    let most = target.coverage_max?;
    let (Some(from), Some(to)) = (target.covered_from_s, target.covered_to_s) else {
        if most < LEAST_SHARE {
            return Some(format!("{size} is never covered."));
        }
        let (most, when) = (beside(most, 1.0, percent_to), at(target.coverage_max_time_s));
        return Some(format!("{size} is never wholly covered: {most} of it at most{when}."));
    };
    Some(format!("{size} is wholly covered {}.", spell(from, to, target.covered_duration_s)))
}

pub(super) fn mouth(summary: &Summary) -> Option<String> {
    summary.opening.effective_from_s?;
    let tilt = summary.mouth.tilt_max_open_rad?.to_degrees();
    let uneven = summary
        .mouth
        .asymmetry_max_open
        .map(|share| format!(", and the reach of its corners differs by {}", at_most(share)));
    let tilt = if tilt < 0.05 { "less than 0.1".into() } else { format!("at most {tilt:.1}") };
    Some(format!("While it is open the mouth leans by {tilt}°{}.", uneven.unwrap_or_default()))
}

/// `2 % at most`, or that it is less than a tenth of a per cent.
fn at_most(share: f64) -> String {
    if share < LEAST_SHARE { "less than 0.1 %".into() } else { format!("{} at most", percent(share)) }
}

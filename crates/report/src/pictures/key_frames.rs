//! Chooses the frames that pictures show: the moments of a run that a designer asks about.

use netcast_results::Summary;
use netcast_results::summary::PointExtremes;

use super::colour::{SLACK_BELOW, TensionScale};
use crate::format::share_of_flat;
use crate::results::{Results, Scene};

/// A frame with the name of its moment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct KeyFrame {
    pub frame: usize,
    pub name: &'static str,
}

/// Least time between two moments as a share of the run: nearer ones look alike.
const LEAST_GAP: f64 = 0.004;

/// Up to `count` moments of the opening, in order of time.
pub(crate) fn postures(results: &Results, scene: &Scene, count: usize) -> Vec<KeyFrame> {
    let summary = results.summary();
    let (opening, posture) = (&summary.opening, &summary.posture);
    let end = scene.frames() - 1;
    let turning = point(summary, "tractor").and_then(|tractor| tractor.peak_travel_time_s);
    let turning = turning.filter(|time| *time < 0.98 * scene.fields.times[end]);
    let wanted = [
        (Some(0), start_name(summary)),
        (Some(end), "at the end"),
        (at(scene, opening.area_max_time_s), "largest area"),
        // take a frame within the open interval, not merely the nearest
        (opening.effective_from_s.map(|time| first_from(scene, time)), "80 % open"),
        (opening.effective_to_s.map(|time| last_until(scene, time)), "80 % open until here"),
        (at(scene, posture.convex_from_s), "the middle takes the lead"),
        (at(scene, starts(summary, "centre")), "the middle sets off"),
        (turning.map(|time| scene.frame_at(time)), "tractors at their farthest"),
        (at(scene, starts(summary, "corner")), "the corners set off"),
    ];
    chosen(results, scene, &wanted, count)
}

/// Up to `count` moments that matter for rope tensions, in order of time.
pub(crate) fn tensions(results: &Results, scene: &Scene, count: usize) -> Vec<KeyFrame> {
    let (summary, end) = (results.summary(), scene.frames() - 1);
    let opening = &summary.opening;
    let hardest = (0..scene.frames()).max_by(|&one, &other| {
        highest_tension(scene, one).total_cmp(&highest_tension(scene, other)).then(other.cmp(&one))
    });
    let closed = opening.effective_to_s.map(|time| first_from(scene, time));
    let late = closed.map(|closed| (closed + end) / 2);
    let halfway = at(scene, opening.area_max_time_s).and_then(|largest| half_open(results, scene, largest));
    let wanted = [
        (hardest, "highest tension"),
        (at(scene, opening.area_max_time_s), "largest area"),
        (halfway, "halfway to the largest area"),
        (at(scene, starts(summary, "centre")), "the middle sets off"),
        (closed, "no longer 80 % open"),
        (late, "late"),
        (at(scene, starts(summary, "corner")), "the corners set off"),
        (Some(end), "at the end"),
    ];
    chosen(results, scene, &wanted, count)
}

/// The highest tension of any rope in a frame, N; 0 where all are slack.
pub(crate) fn highest_tension(scene: &Scene, frame: usize) -> f64 {
    let tensions = scene.fields.tensions(frame).iter().enumerate();
    let of_ropes = tensions.filter(|(segment, _)| scene.is_rope(*segment)).map(|(_, &tension)| tension);
    of_ropes.filter(|&tension| tension >= SLACK_BELOW).fold(0.0, f64::max)
}

/// The scale of tension of all pictures of a run and of its replay.
pub(crate) fn tension_scale(scene: &Scene) -> TensionScale {
    TensionScale::up_to((0..scene.frames()).map(|frame| highest_tension(scene, frame)).fold(0.0, f64::max))
}

/// Up to `count` moments in order of time: the first of `wanted` that lie apart, and frames that halve the widest gaps.
fn chosen(results: &Results, scene: &Scene, wanted: &[(Option<usize>, &'static str)], count: usize) -> Vec<KeyFrame> {
    let times = &scene.fields.times;
    let length = times[scene.frames() - 1] - times[0];
    let mut moments: Vec<KeyFrame> = Vec::new();
    for &(frame, name) in wanted {
        let Some(frame) = frame else { continue };
        let is_apart = |moment: &KeyFrame| (times[moment.frame] - times[frame]).abs() > LEAST_GAP * length;
        if moments.len() < count && moments.iter().all(is_apart) {
            moments.push(KeyFrame { frame, name });
        }
    }
    moments.sort_by_key(|moment| moment.frame);
    let largest = at(scene, results.summary().opening.area_max_time_s);
    while moments.len() < count {
        // only a gap with a frame inside can be halved
        let gaps = (1..moments.len()).filter(|&place| moments[place].frame - moments[place - 1].frame > 1);
        let width = |place: usize| times[moments[place].frame] - times[moments[place - 1].frame];
        let Some(place) = gaps.max_by(|&one, &other| width(one).total_cmp(&width(other)).then(other.cmp(&one))) else {
            break;
        };
        let frame = (moments[place - 1].frame + moments[place].frame) / 2;
        moments.insert(place, KeyFrame { frame, name: ON_THE_WAY });
    }
    for place in 1..moments.len() {
        if moments[place].name == ON_THE_WAY {
            moments[place].name = way(scene, moments[place - 1].frame, moments[place].frame, largest);
        }
    }
    moments
}

/// The name of a frame without a moment of its own.
const ON_THE_WAY: &str = "on the way";

/// The name of `frame` by the picture before it: whether the area that a reader sees beneath both has grown. `largest` is
/// the frame of the largest area.
fn way(scene: &Scene, before: usize, frame: usize, largest: Option<usize>) -> &'static str {
    let (Some(was), Some(is)) = (area(scene, before), area(scene, frame)) else { return ON_THE_WAY };
    let flat = scene.landmarks.reference_area.filter(|flat| *flat > 0.0).unwrap_or(1.0);
    let told = |area: f64| share_of_flat(area / flat);
    match largest {
        _ if told(is) == told(was) => ON_THE_WAY,
        _ if is < was => "closing",
        Some(largest) if frame > largest => "opening again",
        _ => "opening",
    }
}

/// Area of the outline along the launch axis, m^2; none without an outline.
fn area(scene: &Scene, frame: usize) -> Option<f64> {
    let positions = scene.fields.positions(frame);
    Some(scene.landmarks.outline_area(|node| positions[node])?.dot(scene.landmarks.axis).abs())
}

/// The name of the first frame.
fn start_name(summary: &Summary) -> &'static str {
    let speed = point(summary, "tractor").and_then(|tractor| tractor.peak_speed_m_s);
    let is_launched = speed.is_some_and(|speed| speed > 0.0);
    if is_launched { "stowed" } else { "at the start" }
}

fn point<'s>(summary: &'s Summary, name: &str) -> Option<&'s PointExtremes> {
    summary.points.get(name)?.as_ref()
}

/// Time at which a point sets off, s.
fn starts(summary: &Summary, name: &str) -> Option<f64> {
    point(summary, name)?.starts_s
}

/// The frame nearest to `time`, s.
fn at(scene: &Scene, time: Option<f64>) -> Option<usize> {
    time.map(|time| scene.frame_at(time))
}

/// The first frame at or after `time`, s.
fn first_from(scene: &Scene, time: f64) -> usize {
    scene.fields.times.iter().position(|&frame| frame >= time).unwrap_or(scene.frames() - 1)
}

/// The last frame at or before `time`, s.
fn last_until(scene: &Scene, time: f64) -> usize {
    scene.fields.times.iter().rposition(|&frame| frame <= time).unwrap_or(0)
}

/// The first frame with at least half of the largest area, before frame `largest`; none where that is the first of all.
fn half_open(results: &Results, scene: &Scene, largest: usize) -> Option<usize> {
    let half = 0.5 * results.summary().opening.area_max_m2?;
    (0..largest).find(|&frame| area(scene, frame).unwrap_or(0.0) >= half).filter(|&frame| frame > 0)
}

//! The three sheets of a result: postures at eight moments, tensions at six, and the stowed state from two directions.

use glam::DVec3;

use super::camera::{Camera, View};
use super::key_frames::{self, KeyFrame, highest_tension, tension_scale};
use super::net_picture::{extent, open_share};
use super::sheet::{Cell, Sheet};
use crate::format::{fixed, share_of_flat, significant, time, with_prefix};
use crate::results::{Results, Scene};

const POSTURES: usize = 8;
const CLOUDS: usize = 6;

const THREE_QUARTER: &str = "Seen from the side and 23° above, launch axis up; one scale for all.";

/// The web's posture at eight moments.
pub(crate) fn postures<'a>(results: &Results, scene: &'a Scene) -> Sheet<'a> {
    let moments = key_frames::postures(results, scene, POSTURES);
    let shaded = "Per cent: area of the outline over that of the flat web; shaded from 80 %. Middle at: travel of the middle since launch.";
    let has_outline = !scene.landmarks.outline.is_empty();
    let cells = moments
        .iter()
        .map(|moment| cell(moment, [moment_time(scene, moment), share(scene, moment), travel(scene, moment)]));
    Sheet {
        scene,
        cells: cells.collect(),
        columns: 4,
        width: 300.0,
        class: "postures",
        scale: tension_scale(scene),
        has_key: true,
        mark: None,
        notes: [THREE_QUARTER].into_iter().chain(has_outline.then_some(shaded)).map(str::to_owned).collect(),
    }
}

/// The tensions of the ropes at six moments.
pub(crate) fn clouds<'a>(results: &Results, scene: &'a Scene) -> Sheet<'a> {
    let moments = key_frames::tensions(results, scene, CLOUDS);
    let up_to = |moment: &KeyFrame| Some(format!("up to {}", with_prefix(highest_tension(scene, moment.frame), "N")));
    let cells = moments.iter().map(|moment| cell(moment, [moment_time(scene, moment), up_to(moment)]));
    Sheet {
        scene,
        cells: cells.collect(),
        columns: 3,
        width: 400.0,
        class: "wide clouds",
        scale: tension_scale(scene),
        has_key: true,
        mark: None,
        notes: [THREE_QUARTER.to_owned()].into_iter().chain(missed_peak(results, scene)).collect(),
    }
}

/// The state at the start, from the side and from ahead.
pub(crate) fn stowed<'a>(results: &Results, scene: &'a Scene) -> Sheet<'a> {
    let closest = closest_approach(results);
    let cell = |view: View, name: &str, across: &str, along: &str| {
        let (least, most) = extent(scene, 0, &Camera::new(view, scene.landmarks.axis));
        let size = most - least;
        let caption = format!("{} m {across}, {} m {along}", significant(size.x), significant(size.y));
        Cell { frame: 0, view, name: name.into(), caption }
    };
    Sheet {
        scene,
        cells: vec![
            cell(View::Side, "from the side, launch axis up", "wide", "along the axis"),
            cell(View::Ahead, "from ahead, back along the launch axis", "wide", "high"),
        ],
        columns: 2,
        width: 440.0,
        class: "wide pair stowed",
        scale: tension_scale(scene),
        has_key: highest_tension(scene, 0) > 0.0,
        mark: closest.as_ref().map(|(place, _)| *place),
        notes: ["Both pictures have one scale. The sizes include tractors and payloads.".to_owned()]
            .into_iter()
            .chain(closest.map(|(_, note)| note))
            .collect(),
    }
}

/// The postures as figures of the page; empty where the result has no fields.
pub(crate) fn postures_html(results: &Results) -> String {
    results.scene.as_ref().map(|scene| postures(results, scene).html()).unwrap_or_default()
}

/// The tensions as figures of the page; empty where the result has no fields.
pub(crate) fn clouds_html(results: &Results) -> String {
    results.scene.as_ref().map(|scene| clouds(results, scene).html()).unwrap_or_default()
}

/// The stowed state as figures of the page; empty where the result has no fields.
pub(crate) fn stowed_html(results: &Results) -> String {
    results.scene.as_ref().map(|scene| stowed(results, scene).html()).unwrap_or_default()
}

/// The world position, m, at which ropes that are not tied together are nearest, and a note on it.
fn closest_approach(results: &Results) -> Option<(DVec3, String)> {
    let stowed = &results.summary().stowed;
    let (place, distance) = (stowed.closest_approach_at_m?, stowed.closest_approach_m?);
    let note = format!(
        "The ring marks where ropes that are not tied together are nearest: {} between their centre lines.",
        with_prefix(distance, "m")
    );
    Some((DVec3::from(place), note))
}

fn cell<const N: usize>(moment: &KeyFrame, facts: [Option<String>; N]) -> Cell {
    // no-break spaces keep each fact on one line
    let facts = facts.into_iter().flatten().map(|fact| fact.replace(' ', "\u{a0}"));
    let caption = facts.collect::<Vec<String>>().join(" · ");
    Cell { frame: moment.frame, view: View::ThreeQuarter, name: moment.name.into(), caption }
}

fn moment_time(scene: &Scene, moment: &KeyFrame) -> Option<String> {
    Some(time(scene.fields.times[moment.frame]))
}

fn share(scene: &Scene, moment: &KeyFrame) -> Option<String> {
    open_share(scene, moment.frame).map(|share| format!("{} of flat", share_of_flat(share)))
}

fn travel(scene: &Scene, moment: &KeyFrame) -> Option<String> {
    let centre = &scene.landmarks.centre;
    let along = |frame: usize| scene.mean(frame, centre).dot(scene.landmarks.axis);
    (!centre.is_empty()).then(|| format!("middle at {} m", fixed(along(moment.frame) - along(0), 2)))
}

/// A note on the highest tension of the run where it fell between two frames and is in no picture.
fn missed_peak(results: &Results, scene: &Scene) -> Option<String> {
    let tension = &results.summary().tension;
    let (highest, at) = (tension.max_n, tension.max_time_s?);
    let shown = (0..scene.frames()).map(|frame| highest_tension(scene, frame)).fold(0.0, f64::max);
    let class = tension.max_where.as_ref()?;
    (highest > 1.01 * shown).then(|| {
        let highest = with_prefix(highest, "N");
        format!(
            "The highest tension of the run, {highest} in a rope of class {class}, fell between two frames, at {at:.4} s."
        )
    })
}

//! Notes on input that has no effect, or whose range the run leaves.

use netcast_scenario::{Diagnostics, Document, Scenario, WindRow};

use super::air_outline::AirOutline;
use super::throw::Throw;

/// A solidity from which ropes cannot lie side by side.
const SOLID: f64 = 1.0;

/// The notes for a run of `end`, s, with steps of `dt`, s.
pub fn notes(
    document: &Document,
    scenario: &Scenario,
    throws: &[Option<Throw>],
    air: Option<&AirOutline>,
    dt: f64,
    end: f64,
) -> Vec<String> {
    let every = scenario.record.every.si();
    let too_often = (every < dt).then(|| {
        format!("record.every, {every} s, is shorter than the step, {dt:.3e} s: there is one record a step, no more")
    });
    [
        too_often,
        thrown_too_late(throws, end),
        document.files.wind.as_ref().and_then(|rows| wind_not_covered(rows, end)),
        document.files.wind.as_ref().and_then(|rows| wind_too_fast(rows, dt)),
        air.and_then(|air| too_solid(air.drawn_solidity?)),
        (throws.iter().any(Option::is_some) && scenario.stow.is_none())
            .then(|| "there is a launch and no [stow]: the web starts flat, as drawn".to_owned()),
    ]
    .into_iter()
    .flatten()
    .chain(drives_not_covered(document, scenario, end))
    .collect()
}

/// A measured wind of which the run takes nothing.
///
/// # Errors
/// With both ranges.
pub fn require_some_wind(document: &Document, end: f64) -> Result<(), Diagnostics> {
    let Some([first, .., last]) = document.files.wind.as_deref() else { return Ok(()) };
    let (from, to) = (first.time_s, last.time_s);
    if end <= 0.0 || (from <= end && to >= 0.0) {
        return Ok(());
    }
    let message = format!("the wind series covers {from} s to {to} s, and the run takes 0 s to {end} s: nothing of it");
    let help = format!("`time_offset = \"{} s\"` beside the file starts the run at its first row", -from);
    Err(document.diagnostic("environment.wind.series.file", message).with_help(help).into())
}

/// Drives whose path goes on after the end of the run.
fn drives_not_covered(document: &Document, scenario: &Scenario, end: f64) -> Vec<String> {
    let range = |name: &String| {
        let path = scenario.drive[name].path.iter().flatten().map(|point| point.time.si());
        let file = document.files.paths.get(name).into_iter().flatten().map(|row| row.time_s);
        let mut times = path.chain(file);
        let first = times.next()?;
        Some((first, times.last().unwrap_or(first)))
    };
    let told = |name: &String| {
        let (from, to) = range(name)?;
        let what = if from >= end {
            "the run ends on the way to its first point"
        } else if to > end {
            "the run ends before its last point"
        } else {
            return None;
        };
        Some(format!("the path of drive {name:?} covers {from} s to {to} s, and the run takes 0 s to {end} s: {what}"))
    };
    if end > 0.0 { scenario.drive.keys().filter_map(told).collect() } else { Vec::new() }
}

/// Tractors whose delay lasts to the end of the run.
fn thrown_too_late(throws: &[Option<Throw>], end: f64) -> Option<String> {
    let late: Vec<String> =
        throws.iter().flatten().filter(|throw| throw.delay >= end).map(|throw| throw.corner.to_string()).collect();
    (!late.is_empty() && end > 0.0).then(|| {
        let who = if late.len() == 1 { "the tractor of corner" } else { "the tractors of corners" };
        format!("{who} {} never start: their delay lasts to the end of the run, {end} s", late.join(", "))
    })
}

/// A measured wind that begins after the start of the run or ends before its end. One row is a steady wind.
fn wind_not_covered(rows: &[WindRow], end: f64) -> Option<String> {
    let [first, .., last] = rows else { return None };
    let (from, to) = (first.time_s, last.time_s);
    let held = match (from > 0.0, to < end) {
        (false, false) => return None,
        (true, false) => "before it, its first row holds",
        (false, true) => "after it, its last row holds",
        (true, true) => "before and after it, its first and its last row hold",
    };
    Some(format!("the wind series covers {from} s to {to} s, and the run takes 0 s to {end} s: {held}"))
}

/// A measured wind that changes faster than steps see.
fn wind_too_fast(rows: &[WindRow], dt: f64) -> Option<String> {
    let closest = rows.windows(2).map(|pair| pair[1].time_s - pair[0].time_s).fold(f64::INFINITY, f64::min);
    (closest < dt).then(|| {
        format!("the wind series has rows {closest:.3e} s apart, and the step is {dt:.3e} s: what lies between steps is missed")
    })
}

/// Ropes that cover more than the web's area.
fn too_solid(solidity: f64) -> Option<String> {
    (solidity > SOLID)
        .then(|| format!("the web's ropes have {solidity:.1} times its area: is a rope thicker than its mesh is wide?"))
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::throw::Thrown;
    use super::*;

    fn row(time_s: f64) -> WindRow {
        WindRow { time_s, velocity_m_s: [1.0, 0.0, 0.0] }
    }

    #[test]
    fn tractors_that_never_start_are_told() {
        let thrown = |corner: u32, delay: f64| {
            let by = Thrown::At(DVec3::Z);
            Some(Throw { corner, node: 0, delay, direction: DVec3::Z, by, launcher: None })
        };
        assert_eq!(thrown_too_late(&[thrown(1, 0.0), thrown(2, 0.1)], 0.2), None);
        let note = thrown_too_late(&[thrown(1, 10.0), thrown(2, 0.1), thrown(3, 10.0)], 0.2).unwrap();
        assert!(note.starts_with("the tractors of corners 1, 3 never start"), "{note}");
        // an equilibrium takes no time
        assert_eq!(thrown_too_late(&[thrown(1, 0.0)], 0.0), None);
    }

    #[test]
    fn ropes_thicker_than_their_mesh_are_told() {
        assert_eq!(too_solid(0.3), None);
        assert!(too_solid(26.0).unwrap().contains("26.0 times"));
    }

    #[test]
    fn a_wind_series_on_another_clock_is_told() {
        assert_eq!(wind_not_covered(&[row(0.0), row(2.0)], 1.0), None);
        assert_eq!(wind_not_covered(&[row(5.0)], 1.0), None);
        let note = wind_not_covered(&[row(1000.0), row(1001.0)], 1.0).unwrap();
        assert!(note.contains("covers 1000 s to 1001 s") && note.contains("first row holds"), "{note}");
        assert!(wind_not_covered(&[row(0.0), row(0.5)], 1.0).unwrap().contains("after it, its last row holds"));
    }
}

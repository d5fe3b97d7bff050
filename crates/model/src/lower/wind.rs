//! The wind of a scenario: a mean by height and a fluctuation by time, both as tables.

use glam::DVec3;
use netcast_dynamics::air::turbulence::{self, Spectrum};
use netcast_dynamics::air::wind::{LinearTable, Wind, gust, logarithmic, power_law};
use netcast_scenario::{
    Diagnostic, Diagnostics, Document, Gust, LogarithmicProfile, PowerProfile, Scenario, Turbulence,
    Wind as WrittenWind, WindRow,
};
use netcast_webs::chance::uniform_above_zero;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// The longest run for which turbulence is made, s. Its table takes time and memory.
const LONGEST: f64 = 600.0;
/// Least time in which an eddy of the length scale passes, s. The tables have no waves beyond 50 1/s, where 4 % of the
/// variance of such eddies lie.
const SHORTEST: f64 = 0.2;
/// The most entries of a table by time.
const MOST_ENTRIES: f64 = 1e6;
/// Entries of the table of a gust.
const GUST_ENTRIES: f64 = 200.0;

/// The wind during `duration`, s, with a profile up to `top`, m above the muzzle; no wind if the scenario has none.
///
/// # Errors
/// Values that contradict each other, or a table that would be too large.
pub fn wind(document: &Document, scenario: &Scenario, duration: f64, top: f64) -> Result<Wind, Diagnostics> {
    let Some(asked) = &scenario.environment.wind else { return Ok(Wind::none()) };
    if let Some(rows) = &document.files.wind {
        return match resampled(during(rows, duration)) {
            Some(fluctuation) => Ok(Wind { fluctuation, ..Wind::none() }),
            None => {
                let message = format!("the times of its rows are too uneven for a table of {MOST_ENTRIES:e} entries");
                let help = "leave out rows that lie close together, or space them evenly";
                Err(document.diagnostic("environment.wind.series.file", message).with_help(help).into())
            }
        };
    }
    let direction = towards(asked.azimuth.map_or(0.0, |azimuth| azimuth.si()));
    let speed = asked.speed.map_or(0.0, |speed| speed.si());
    let muzzle = asked.muzzle_height.map_or(0.0, |height| height.si());
    let mean = match (&asked.power, &asked.logarithmic) {
        (Some(PowerProfile { exponent, reference_height }), _) => {
            power_law(speed, reference_height.si(), exponent.si(), muzzle, top)
        }
        (None, Some(LogarithmicProfile { roughness, reference_height })) => {
            let (roughness, reference) = (roughness.si(), reference_height.si());
            if roughness >= reference {
                let path = "environment.wind.logarithmic.roughness";
                let message =
                    format!("expected less than the reference height, {reference} m, where the wind has its speed");
                return Err(document.diagnostic(path, message).into());
            }
            logarithmic(speed, reference, roughness, muzzle, top)
        }
        (None, None) => LinearTable::constant(speed),
    };
    let eddies = asked.turbulence.as_ref().map(|eddies| turbulent(document, eddies, direction, speed, duration));
    let fluctuation = match (eddies.transpose()?, &asked.gust) {
        (None, None) => LinearTable::constant(DVec3::ZERO),
        (Some(eddies), None) => eddies,
        (None, Some(gust)) => gust_of(asked, gust),
        (Some(eddies), Some(gust)) => sum(&eddies, &gust_of(asked, gust), duration),
    };
    Ok(Wind { direction, mean, fluctuation })
}

/// The horizontal unit vector along an azimuth, rad.
fn towards(azimuth: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(azimuth);
    DVec3::new(cos, sin, 0.0)
}

/// The velocity of a gust by time, world frame, m/s.
fn gust_of(wind: &WrittenWind, asked: &Gust) -> LinearTable<DVec3> {
    let direction = towards(asked.azimuth.or(wind.azimuth).map_or(0.0, |azimuth| azimuth.si()));
    let duration = asked.duration.si();
    let spacing = (duration / GUST_ENTRIES).max(f64::MIN_POSITIVE);
    let LinearTable { first, spacing, values } = gust(asked.speed.si(), asked.at.si(), duration, spacing);
    LinearTable { first, spacing, values: values.into_iter().map(|speed| direction * speed).collect() }
}

/// Velocity of isotropic turbulence by time, world frame, m/s. The mean wind, `speed` m/s along `direction`, carries it.
fn turbulent(
    document: &Document,
    asked: &Turbulence,
    direction: DVec3,
    speed: f64,
    duration: f64,
) -> Result<LinearTable<DVec3>, Diagnostic> {
    let table = asked.table();
    if speed == 0.0 {
        let message = "turbulence is carried along by the wind, whose speed is 0";
        return Err(document.diagnostic(table, message).with_help("give `environment.wind.speed`"));
    }
    if duration > LONGEST {
        let message = format!("turbulence is made for runs of at most {LONGEST} s, not for {duration} s");
        return Err(document
            .diagnostic(table, message)
            .with_help("give a wind of your own in [environment.wind.series]"));
    }
    let eddies = asked.eddies();
    let relative = eddies.intensity.map(|intensity| speed * intensity.si());
    let deviation = relative.or(eddies.deviation.map(|deviation| deviation.si())).unwrap_or(0.0);
    let along = eddies.length_scale.si();
    let shortest = speed * SHORTEST;
    if along < shortest {
        let message =
            format!("eddies of {along} m pass faster than the tables resolve: expected at least {shortest} m");
        return Err(document.diagnostic(&format!("{table}.length_scale"), message));
    }
    let (spectrum, across) = match asked {
        // length scales of isotropic turbulence in the terms of either spectrum
        Turbulence::VonKarman(_) => (Spectrum::VonKarman, 0.5 * along),
        Turbulence::Dryden(_) => (Spectrum::Dryden, along),
    };
    let turbulence =
        turbulence::Turbulence { spectrum, deviation: [deviation; 3], scale: [along, across, across], speed };
    let mut source = ChaCha8Rng::seed_from_u64(eddies.seed.into());
    let axes = [direction, DVec3::Z.cross(direction), DVec3::Z];
    Ok(turbulence.series(axes, duration, || uniform_above_zero(&mut source)))
}

/// The sum of two tables from time 0 to `duration`, s, at the finer spacing of the two.
fn sum(one: &LinearTable<DVec3>, other: &LinearTable<DVec3>, duration: f64) -> LinearTable<DVec3> {
    let spacing = one.spacing.min(other.spacing).max(duration / MOST_ENTRIES);
    let count = (duration / spacing).ceil() as usize + 1;
    let at = |i: usize| i as f64 * spacing;
    LinearTable { first: 0.0, spacing, values: (0..=count).map(|i| one.at(at(i)) + other.at(at(i))).collect() }
}

/// The rows that a run from 0 to `duration` seconds needs.
fn during(rows: &[WindRow], duration: f64) -> &[WindRow] {
    let first = rows.partition_point(|row| row.time_s <= 0.0).saturating_sub(1);
    let past = rows.partition_point(|row| row.time_s < duration).saturating_add(1).min(rows.len());
    &rows[first..past.max(first)]
}

/// A measured wind at equally spaced times. The spacing is that of the rows if they are equally spaced, else a quarter of
/// their shortest gap: a peak then keeps at least seven eighths of its height. None if the table would be too large.
fn resampled(rows: &[WindRow]) -> Option<LinearTable<DVec3>> {
    let velocity = |row: &WindRow| DVec3::from_array(row.velocity_m_s);
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
        return Some(LinearTable::constant(DVec3::ZERO));
    };
    let gaps = rows.windows(2).map(|pair| pair[1].time_s - pair[0].time_s);
    let (least, most) = gaps.fold((f64::INFINITY, 0.0f64), |(least, most), gap| (least.min(gap), most.max(gap)));
    let length = last.time_s - first.time_s;
    if most <= least * (1.0 + 1e-6) && rows.len() > 1 {
        let spacing = length / (rows.len() - 1) as f64;
        return Some(LinearTable { first: first.time_s, spacing, values: rows.iter().map(velocity).collect() });
    }
    if length == 0.0 {
        return Some(LinearTable::constant(velocity(first)));
    }
    let count = (4.0 * length / least).ceil();
    if count > MOST_ENTRIES {
        return None;
    }
    let count = count as usize;
    let spacing = length / count as f64;
    let at = |i: usize| {
        let time = first.time_s + i as f64 * spacing;
        let after = rows.partition_point(|row| row.time_s <= time).clamp(1, rows.len() - 1);
        let (before, after) = (&rows[after - 1], &rows[after]);
        let share = ((time - before.time_s) / (after.time_s - before.time_s)).min(1.0);
        velocity(before) * (1.0 - share) + velocity(after) * share
    };
    Some(LinearTable { first: first.time_s, spacing, values: (0..=count).map(at).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(times: &[(f64, f64)]) -> Vec<WindRow> {
        times.iter().map(|&(time_s, vx)| WindRow { time_s, velocity_m_s: [vx, -vx, 0.5] }).collect()
    }

    #[test]
    fn rows_at_equal_times_are_kept_as_they_are() {
        let series = resampled(&rows(&[(0.1, 3.0), (0.2, 5.0), (0.3, 4.0), (0.4, 4.5)])).unwrap();
        assert_eq!(series.values.len(), 4);
        for (time, speed) in [(0.0, 3.0), (0.15, 4.0), (0.3, 4.0), (0.35, 4.25), (9.0, 4.5)] {
            assert!(series.at(time).distance(DVec3::new(speed, -speed, 0.5)) < 1e-12, "{time}");
        }
        assert_eq!(resampled(&rows(&[(0.1, 3.0)])).unwrap().at(7.0), DVec3::new(3.0, -3.0, 0.5));
    }

    #[test]
    fn only_the_rows_of_the_run_are_tabulated_and_too_many_entries_are_refused() {
        let day = rows(&[(-3600.0, 1.0), (-1.0, 2.0), (0.5, 4.0), (0.6, 8.0), (3.0, 2.0), (4.0, 3.0), (86_400.0, 1.0)]);
        let times = |duration: f64| during(&day, duration).iter().map(|row| row.time_s).collect::<Vec<_>>();
        assert_eq!(times(2.0), [-1.0, 0.5, 0.6, 3.0]);
        assert_eq!(times(3.0), [-1.0, 0.5, 0.6, 3.0]);
        assert_eq!(times(1e6)[1..], times(1e5)[1..]);
        // all of it would be 3.6 million entries
        assert!(resampled(&day).is_none());
        let run = resampled(during(&day, 2.0)).unwrap();
        for (time, speed) in [(0.0, 2.0 + 2.0 / 1.5), (0.55, 6.0), (2.0, 8.0 - 6.0 * 1.4 / 2.4)] {
            assert!((run.at(time).x - speed).abs() < 1e-9, "{time}: {}", run.at(time).x);
        }
        // before its first row and after its last it is constant
        for (row, duration) in [((5.0, 3.0), 1.0), ((-5.0, 3.0), 1.0), ((0.0, 3.0), 0.0)] {
            assert_eq!(resampled(during(&rows(&[row]), duration)).unwrap().at(0.5).x, 3.0);
        }
    }

    #[test]
    fn rows_at_uneven_times_are_joined_by_straight_lines_and_keep_their_peaks() {
        let rows = rows(&[(0.0, 0.0), (1.0, 0.0), (1.13, 8.0), (1.3, 0.0), (4.0, 2.7)]);
        let series = resampled(&rows).unwrap();
        for (time, speed) in [(0.5, 0.0), (2.0, 0.7), (3.7, 2.4), (4.0, 2.7)] {
            assert!((series.at(time).x - speed).abs() < 1e-12, "{time}");
        }
        let most = series.values.iter().map(|v| v.x).fold(0.0, f64::max);
        assert!((7.0..=8.0).contains(&most), "{most}");
    }
}

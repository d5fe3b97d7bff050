//! A coarse record hid peaks, and changed the motion and the verdict.

use netcast::{Case, Run};

use crate::support::examples;

/// A net that whips, with a record each `every`.
fn run(every: &str) -> Run {
    let overrides = [format!("record.every={every:?}"), "solve.duration=\"0.25 s\"".to_owned()];
    let case = Case::read(examples().join("04_square_net/square_net.toml"), &overrides).unwrap();
    let run = case.simulation().threads(1).run().unwrap();
    assert_eq!(run.failure, None);
    run
}

#[test]
fn what_is_recorded_changes_no_number_of_the_summary() {
    let summary = |every: &str| {
        let mut summary = run(every).summary;
        summary.wall_time_s = 0.0;
        summary.to_json().unwrap()
    };
    let once = summary("1 ms");
    for every in ["0.13 ms", "2 ms", "17 ms", "1 s"] {
        assert_eq!(summary(every), once, "{every}");
    }
}

#[test]
fn a_coarse_record_hides_no_peak() {
    let run = run("20 ms");
    let history = run.history();
    let largest = |column: &str| history.values(column).unwrap().flatten().fold(0.0, f64::max);
    let tension = &run.summary.tension;
    // records at whole times miss the peak by far: else this shows nothing
    assert!(largest("tension_max_n") < 0.9 * tension.max_n, "{} of {}", largest("tension_max_n"), tension.max_n);
    assert_eq!(largest("tension_peak_n"), tension.max_n);
    for (name, class) in &tension.by_class {
        if class.max_n > 0.0 {
            assert_eq!(largest(&format!("{name}_peak_n")), class.max_n, "{name}");
        }
    }
    let tractor = run.summary.points["tractor"].as_ref().unwrap();
    assert_eq!(Some(largest("tractor_speed_peak_m_s")), tractor.peak_speed_m_s);
}

#[test]
fn the_moments_of_a_run_are_among_its_frames_whatever_is_recorded() {
    let run = run("50 ms");
    let (tension, opening) = (&run.summary.tension, &run.summary.opening);
    let highest =
        |frame: netcast::RunFrame| frame.tension_n.iter().copied().filter(|t| !t.is_nan()).fold(0.0, f64::max);
    let shown = run.frames().map(highest).fold(0.0, f64::max);
    assert!(shown > 0.99 * tension.max_n, "{shown} N of {} N", tension.max_n);
    let times: Vec<f64> = run.frames().map(|frame| frame.time_s).collect();
    assert!(times.is_sorted(), "{times:?}");
    let dt = run.summary.step.dt_s;
    let expected = [opening.area_max_time_s, opening.effective_from_s, opening.effective_to_s];
    assert!(expected.iter().any(Option::is_some));
    let places = &run.summary.places;
    for (time, place) in expected.into_iter().zip([&places.largest_area, &places.opening, &places.closing]) {
        let Some(time) = time.filter(|&time| time < run.case().schedule().end) else { continue };
        let nearest = times.iter().map(|frame| (frame - time).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= 2.0 * dt, "no frame at {time} s: {nearest} s away");
        assert!((place.time_s.unwrap() - time).abs() <= 2.0 * dt, "{place:?} {time}");
    }
}

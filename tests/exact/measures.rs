//! Measures of the whole web, on runs with known answers.

use crate::support::Run;

/// A square net of 2 m, held at its corners without gravity: nothing moves.
const HELD: [&str; 2] = ["environment.gravity=0", "solve.duration=\"2 ms\""];

#[test]
fn a_flat_net_has_its_own_area_as_shadow_and_covers_a_target_in_its_middle() {
    let inside = [&HELD[..], &["measure.target_diameter=\"1.2 m\""]].concat();
    let run = Run::example("05_hanging_net/hanging_net.toml", &inside);
    assert!((run.summary.opening.shadow_area_max_m2.unwrap() - 4.0).abs() < 1e-9);
    assert_eq!(run.summary.mouth.tilt_at_area_max_rad, Some(0.0));
    assert_eq!(run.summary.mouth.asymmetry_at_area_max, Some(0.0));
    let target = run.summary.target.unwrap();
    assert!((target.coverage_max.unwrap() - 1.0).abs() < 1e-9);
    assert_eq!((target.covered_from_s, target.covered_to_s), (Some(0.0), Some(0.002)));

    // on a larger disc it covers its own area
    let outside = [&HELD[..], &["measure.target_diameter=\"4 m\""]].concat();
    let run = Run::example("05_hanging_net/hanging_net.toml", &outside);
    let target = run.summary.target.unwrap();
    let share = 4.0 / (4.0 * std::f64::consts::PI);
    assert!((target.coverage_max.unwrap() - share).abs() < 3e-3, "{:?}", target.coverage_max);
    assert_eq!(target.covered_duration_s, Some(0.0));
}

#[test]
fn the_shadow_of_a_stowed_net_does_not_depend_on_the_launch_axis() {
    let shadow = |launch: &[&str]| {
        let run = Run::example("04_square_net/square_net.toml", &[&["solve.duration=\"0.1 s\""][..], launch].concat());
        (run.column("shadow_area_m2"), run.column("mouth_asymmetry"))
    };
    let (up, _) = shadow(&["launch.elevation=\"90 deg\""]);
    let (slanted, asymmetry) = shadow(&["launch.elevation=\"30 deg\"", "launch.azimuth=\"70 deg\""]);
    // only at the start: later, whipping slack ropes amplify rounding
    assert!((up[0] - slanted[0]).abs() < 1e-4 * up[0], "{} and {}", up[0], slanted[0]);
    assert!(asymmetry.iter().all(|share| *share < 1e-3));
    // scaled to a quarter, it starts with a sixteenth of its area of 25 m^2
    assert!((up[0] - 25.0 / 16.0).abs() < 1e-9, "{}", up[0]);
}

#[test]
fn the_utilisation_of_a_rope_counts_its_strength_at_knots() {
    let run = Run::example(
        "06_graph_net/graph_net.toml",
        &["ropes.border.knot_reduction=\"40 %\"", "solve.duration=\"0.2 s\""],
    );
    let tension = &run.summary.tension;
    let border = &tension.by_rope["border"];
    // the border is the rope of the outline only
    assert_eq!(border.max_n, tension.by_class["outline"].max_n);
    assert_eq!(border.max_where.as_deref(), Some("outline"));
    assert!((border.utilisation.unwrap() - border.max_n / (0.6 * 12_000.0)).abs() < 1e-12);
    assert!((border.margin.unwrap() * border.utilisation.unwrap() - 1.0).abs() < 1e-12);
    // the margin of the class counts the full strength of the rope
    assert!((tension.by_class["outline"].margin.unwrap() - 12_000.0 / border.max_n).abs() < 1e-12);

    let others = tension.by_class.iter().filter(|(class, _)| *class != "outline");
    let most = others.map(|(_, class)| class.max_n).fold(0.0, f64::max);
    assert_eq!(tension.by_rope["rope"].max_n, most);
    assert_eq!(tension.by_rope["rope"].utilisation, None);
    assert!(border.min_n.unwrap() <= border.mean_n.unwrap() && border.mean_n.unwrap() <= border.max_n);
}

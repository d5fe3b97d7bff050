//! Each sentence is held to what a reader of the numbers would say.

use serde_json::{Value, json};

use super::*;

/// The sentences of a summary that a file holds.
fn words(summary: &Value) -> Vec<String> {
    super::words(&read(summary))
}

fn read(summary: &Value) -> Summary {
    serde_json::from_value(summary.clone()).unwrap()
}

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
fn in_an_orbit_no_hang_time_is_reported() {
    let mut summary = full();
    assert!(words(&summary).iter().any(|told| told.contains("hangs within")));
    summary["energy"]["channels"] = json!({"orbit": 1e-4});
    assert!(words(&summary).iter().all(|told| !told.contains("hangs within")));
}

#[test]
fn a_run_that_diverged_has_no_sentences_but_that_and_a_warning() {
    let mut summary = full();
    summary["finished"] = json!(false);
    summary["energy"]["closure"] = json!(0.993);
    let told = words(&summary);
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[0].starts_with("The run stopped") && told[1].contains("do not trust"));
}

#[test]
fn an_equilibrium_is_described_without_times() {
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
fn a_complete_summary_gives_all_sentences_in_order() {
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
            "Of the feature points, B is the fastest: 112 m/s at 0.070 s.",
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
fn values_that_are_null_or_missing_give_no_sentence() {
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
fn a_web_that_starts_open_is_not_said_to_open() {
    let about_opening = |to: f64, total: f64| {
        let opening = json!({"area_max_m2": 15.7, "area_max_time_s": 0.8, "reference_area_m2": 16.0,
                             "effective_from_s": 0.0, "effective_to_s": to, "effective_duration_s": total});
        words(&json!({"finished": true, "opening": opening, "step": {"count": 100, "dt_s": 0.01}}))
    };
    assert_eq!(about_opening(1.0, 1.0), [""; 0]);
    let largest = "Its largest area is 15.7 m² (98 % of the flat web) at 0.800 s.";
    assert_eq!(about_opening(0.4, 0.4), [largest, "Is open at the start, and at least 80 % so until 0.400 s."]);
    // and opens again
    let again = "Is open at the start, and at least 80 % so until 0.400 s; for 0.600 s in all.";
    assert_eq!(about_opening(0.4, 0.6), [largest, again]);
}

/// Of a summary with what was made to break, and with what was not.
#[test]
fn released_ties_and_broken_ropes_have_separate_sentences() {
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
fn faults_of_a_failed_run_are_reported() {
    let mut summary = full();
    summary["finished"] = json!(false);
    summary["opening"]["effective_from_s"] = json!(null);
    summary["opening"]["area_max_m2"] = json!(12.0);
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
fn a_web_whose_own_energy_does_not_close_gives_a_warning() {
    let mut summary = full();
    summary["energy"]["tolerance_web"] = json!(0.001);
    assert!(words(&summary).last().unwrap().contains("do not trust"));
}

#[test]
fn phases_of_posture_are_in_the_order_of_time() {
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
fn of_several_open_spells_the_longest_and_the_total_are_given() {
    let mut summary = full();
    summary["opening"]["effective_duration_s"] = json!(0.12);
    assert_eq!(words(&summary)[1], "At least 80 % open from 0.112 s to 0.193 s, its longest spell; 0.120 s in all.");
}

#[test]
fn the_work_of_drag_is_given_as_taken_or_given() {
    let mut summary = json!({"energy": {"initial_j": 4000.0, "channels": {"air": 100.0}},
                             "air": {"density_kg_m3": 1.2, "wind_m_s": [0.0, 0.0, 0.0], "wind_change_max_m_s": 0.0}});
    let still = "Drag takes 100 J, 2.5 % of what there was at the start, in a medium of 1.20 kg/m³.";
    assert_eq!(air(&read(&summary)).unwrap(), still);
    summary["energy"] = json!({"initial_j": 0.0, "channels": {"air": -12.0}});
    summary["air"]["wind_m_s"] = json!([3.0, 4.0, 0.0]);
    let windy = "Drag gives 12.0 J, in a medium of 1.20 kg/m³ that moves at 5.00 m/s at the start.";
    assert_eq!(air(&read(&summary)).unwrap(), windy);
    assert_eq!(air(&read(&json!({"air": null, "energy": {"channels": {"air": 0.0}}}))), None);
}

#[test]
fn a_launch_has_a_sentence_if_it_has_spin_or_recoil() {
    let one = |speed: f64, time: f64| json!({"speed_m_s": speed, "time_s": time, "angle_rad": 0.3});
    let mut launch = json!({"spin_rad_s": 0.0, "tractors": {"1": one(50.0, 0.0), "2": one(50.0, 0.0)}, "recoil": null});
    let told = |launch: &Value| super::launch(&read(&json!({ "launch": launch })));
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

#[test]
fn a_web_that_just_misses_eighty_per_cent_is_not_said_to_open_to_them() {
    let mut summary = full();
    summary["opening"]["area_max_m2"] = json!(0.799 * 16.238);
    summary["opening"]["effective_from_s"] = json!(null);
    assert_eq!(
        words(&summary)[..2],
        ["Opens to 13.0 m² (79.9 % of the flat web) at 0.131 s.", "Never reaches 80 % of the flat web."]
    );
    // nor is one that opens to next to nothing
    summary["opening"]["area_max_m2"] = json!(1e-19);
    assert_eq!(words(&summary)[0], "The web does not open.");
    assert!(words(&summary).iter().all(|told| !told.contains("80 %")));
}

#[test]
fn the_rounding_error_of_a_slack_rope_is_no_pull() {
    let mut summary = full();
    summary["tension"] = json!({"max_n": 1.1e-10, "max_where": "ring", "bottom_max_n": 1.1e-10,
                                "by_rope": {"rope": {"utilisation": 1e-14}}});
    let told = words(&summary);
    assert!(told.contains(&"No rope is ever taut.".into()), "{told:?}");
    assert!(told.contains(&"The bottom ropes, which meet point B, stay slack.".into()), "{told:?}");
    assert!(told.iter().all(|told| !told.contains("e-10") && !told.contains("worst off")), "{told:?}");
}

#[test]
fn a_web_that_lifts_by_a_millimetre_does_not_rise_and_hang() {
    let mut summary = full();
    summary["flight"]["apex_height_m"] = json!(0.0014);
    assert!(words(&summary).iter().all(|told| !told.contains("hangs")));
    summary["flight"]["apex_height_m"] = json!(0.4);
    summary["flight"]["apex_time_s"] = json!(1e-4);
    assert!(words(&summary).iter().all(|told| !told.contains("hangs")));
}

#[test]
fn the_place_where_the_web_opens_is_told() {
    let mut summary = full();
    summary["places"]["opening"] = json!({"travel_m": 4.21, "ground_distance_m": 4.0, "height_m": -1.2});
    let place = "It reaches 80 % after 4.21 m along the launch axis: 4.00 m over the ground, 1.20 m below the muzzle.";
    assert_eq!(words(&summary)[2], place);
    summary["places"]["opening"]["height_m"] = json!(-1e-6);
    assert!(words(&summary)[2].ends_with("4.00 m over the ground, level with the muzzle."));
}

#[test]
fn points_whose_speeds_read_alike_share_the_first_place() {
    let mut summary = full();
    summary["points"]["A"]["peak_speed_m_s"] = json!(112.1);
    assert!(words(&summary).contains(&"Of the feature points, A and B are the fastest: 112 m/s.".into()));
}

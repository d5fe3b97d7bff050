//! The scenario of the contract with our users, word for word, runs.

use crate::workbench::Workbench;

/// The text of the contract; the tests of the scenario crate read the same file.
const SCENARIO: &str = include_str!("../../../scenario/tests/contract.toml");

/// Keys that a user's script relies on.
const SUMMARY: &str = r#"{
  "title": "", "netcast": "0.1.0", "wall_time_s": 0.0, "finished": true,
  "model":   {"nodes": 0, "segments": 0, "rope_length_m": 0.0, "web_mass_kg": 0.0, "tractor_mass_kg": 0.0},
  "step":    {"dt_s": 0.0, "count": 0, "limited_by": "segment 12 of traction rope 3"},
  "opening": {"area_max_m2": 0.0, "area_max_time_s": 0.0, "reference_area_m2": 0.0, "vector_area_max_m2": 0.0,
              "effective_from_s": null, "effective_to_s": null, "effective_duration_s": 0.0,
              "tractor_area_max_m2": 0.0, "tractor_area_max_time_s": 0.0},
  "points":  {"A": {"peak_speed_m_s": 0.0, "peak_speed_time_s": 0.0, "peak_travel_m": 0.0, "peak_travel_time_s": 0.0,
                    "peak_height_m": 0.0, "starts_s": 0.0},
              "B": {}, "C": {}, "D": {}, "tractor": {}, "corner": {}, "centre": {}},
  "tension": {"max_n": 0.0, "max_time_s": 0.0, "max_where": "traction", "bottom_max_n": 0.0, "bottom_mean_n": null,
              "by_class": {"traction": {"max_n": 0.0, "max_time_s": 0.0, "margin": null},
                           "outline": {}, "ring": {}, "radial": {}}},
  "posture": {"concave_from_s": null, "concave_to_s": null, "convex_from_s": null},
  "energy":  {"initial_j": 0.0, "final_j": 0.0, "closure": 0.0, "closure_web": 0.0, "channels": {}}
}"#;

/// Asserts that `found` has every key of `expected`: with a value of the same type, or any value for null.
fn assert_has(expected: &serde_json::Value, found: &serde_json::Value, path: &str) {
    use serde_json::Value;
    match (expected, found) {
        (Value::Object(expected), Value::Object(found)) => {
            for (key, value) in expected {
                let inner = found.get(key).unwrap_or_else(|| panic!("{path} has no {key}"));
                assert_has(value, inner, &format!("{path}.{key}"));
            }
        }
        (Value::Null, _) => {}
        _ => assert_eq!(std::mem::discriminant(expected), std::mem::discriminant(found), "{path}: {found}"),
    }
}

#[test]
fn the_scenario_of_the_contract_runs_and_its_summary_has_every_key() {
    let workbench = Workbench::new(&[("space_web.toml", SCENARIO)]);
    workbench.succeed(&["run", "space_web.toml", "--quiet", "--set", "solve.duration=20 ms"]);
    let summary = workbench.summary("results/space_web");
    assert_has(&serde_json::from_str(SUMMARY).unwrap(), &summary, "summary");
    assert_eq!(summary["title"], "The space web, launched as in the paper");
    assert_eq!(summary["finished"], true);
    // six cylinders of 0.1 m x 0.2 m at 17,700 kg/m^3
    assert!((summary["model"]["tractor_mass_kg"].as_f64().unwrap() - 166.82).abs() < 0.01);
    // a hexagon of 2.5 m: 3 sqrt(3)/2 a^2
    assert!((summary["opening"]["reference_area_m2"].as_f64().unwrap() - 16.238).abs() < 0.001);
    // all tractors start at sqrt(50^2 + 50^2) m/s
    assert!((summary["points"]["tractor"]["peak_speed_m_s"].as_f64().unwrap() - 70.71).abs() < 0.01);
    assert!(summary["energy"]["closure"].as_f64().unwrap() <= 0.003);
    // the energy at the start is that of the tractors, 166.82 kg at 70.71 m/s, and the weight energy of the bag below
    let kinetic = 0.5 * summary["model"]["tractor_mass_kg"].as_f64().unwrap() * 5000.0;
    assert!((summary["energy"]["initial_j"].as_f64().unwrap() / kinetic - 1.0).abs() < 0.01);
}

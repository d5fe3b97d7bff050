//! The page of a result folder: complete, offline, safe against markup in texts, and written for partial folders too.

use std::fs;

use netcast_report::{ReportError, write_report};
use netcast_results::ResultError;
use serde_json::{Value, json};
use tempfile::TempDir;

/// The summary of a launched web with points, classes and energies.
fn summary() -> Value {
    json!({
        "title": "A web", "netcast": "0.1.0", "wall_time_s": 1.5, "finished": true,
        "model": {"nodes": 1893, "segments": 2108, "rope_length_m": 117.0, "web_mass_kg": 57.7, "tractor_mass_kg": 166.8},
        "step": {"dt_s": 1.3e-6, "count": 472441, "limited_by": "segment 12 of traction rope 3"},
        "opening": {
            "area_max_m2": 15.8, "area_max_time_s": 0.131, "reference_area_m2": 16.238, "vector_area_max_m2": 15.9,
            "effective_from_s": 0.112, "effective_to_s": 0.193, "effective_duration_s": 0.081,
            "tractor_area_max_m2": 32.4, "tractor_area_max_time_s": 0.16
        },
        "points": {
            "B": {"peak_speed_m_s": 112.4, "peak_speed_time_s": 0.07, "peak_travel_m": 8.8, "peak_travel_time_s": 0.6,
                  "peak_height_m": 8.8, "starts_s": 0.06},
            "tractor": {"peak_speed_m_s": 70.7, "peak_speed_time_s": 0.0, "peak_travel_m": 5.9,
                        "peak_travel_time_s": 0.6, "peak_height_m": 5.9, "starts_s": 0.001}
        },
        "tension": {
            "max_n": 51000.0, "max_time_s": 0.15, "max_where": "traction", "bottom_max_n": 14200.0, "bottom_mean_n": 3900.0,
            "by_class": {"traction": {"max_n": 51000.0, "max_time_s": 0.15, "margin": 1.84},
                         "ring": {"max_n": 18000.0, "max_time_s": 0.14, "margin": null}}
        },
        "posture": {"concave_from_s": 0.004, "concave_to_s": 0.187, "convex_from_s": 0.212},
        "energy": {"initial_j": 417000.0, "final_j": 52000.0, "closure": 0.0005, "closure_web": 0.0031,
                   "channels": {"kinetic": 12000.0, "elastic": 3.0}, "residual_j": 210.0, "tolerance": 0.003},
        "warnings": ["The air is left out."]
    })
}

const COLUMNS: &str = "time_s,area_m2,vector_area_m2,tractor_area_m2,centre_travel_m,corner_travel_m,tractor_travel_m,\
    tension_max_n,B_x_m,B_y_m,B_z_m,B_travel_m,B_speed_m_s,B_tension_n,tractor_speed_m_s,traction_mean_n,traction_max_n,\
    ring_mean_n,ring_max_n,energy_kinetic_j,energy_elastic_j,energy_residual_j";

fn history() -> String {
    let mut text = format!("{COLUMNS}\n");
    let width = COLUMNS.split(',').count();
    for step in 0..=600 {
        let cells: Vec<String> =
            (0..width).map(|column| (step as f64 * 1e-3 * (1 + column) as f64).to_string()).collect();
        text += &format!("{}\n", cells.join(","));
    }
    text
}

fn manifest() -> Value {
    json!({
        "program": "netcast", "version": "0.1.0", "revision": null, "input_hash": "e3b0c44298fc1c14", "threads": 1,
        "machine": {"os": "linux", "arch": "x86_64", "cpu": null, "cores": 2}, "seed": null, "wall_time_s": 1.5,
        "started": "2026-11-22T01:42:17Z"
    })
}

fn folder(summary: &Value, history: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("summary.json"), summary.to_string()).unwrap();
    fs::write(folder.path().join("history.csv"), history).unwrap();
    fs::write(folder.path().join("manifest.json"), manifest().to_string()).unwrap();
    folder
}

fn page(summary: &Value, history: &str) -> String {
    let folder = folder(summary, history);
    let path = write_report(folder.path()).unwrap();
    assert_eq!(path, folder.path().join("report.html"));
    fs::read_to_string(path).unwrap()
}

/// The page without the charting library, whose source mentions addresses that it never fetches.
fn without_library(page: &str) -> String {
    let start = page.find("<script type=\"text/plain\" id=\"library\">").expect("the library is embedded");
    let end = start + page[start..].find("</script>").expect("a script ends");
    format!("{}{}", &page[..start], &page[end..])
}

/// The figures as the page's script reads them.
fn figures(page: &str) -> Vec<Value> {
    let (_, data) = page.split_once("id=\"figure-data\">").unwrap();
    let (data, _) = data.split_once("</script>").unwrap();
    serde_json::from_str(data).unwrap()
}

/// Id and names of the curves of each figure on the page.
fn curves(page: &str) -> Vec<(String, Vec<String>)> {
    let name = |value: &Value| value.as_str().unwrap().to_owned();
    figures(page)
        .iter()
        .map(|figure| {
            let curves = figure["curves"].as_array().unwrap();
            (name(&figure["id"]), curves.iter().map(|curve| name(&curve["name"])).collect())
        })
        .collect()
}

#[test]
fn the_page_is_one_file_that_fetches_nothing() {
    let page = page(&summary(), &history());
    assert!(page.len() < 6_000_000, "{} bytes", page.len());
    // the policy makes the browser refuse whatever a later change might fetch
    assert!(page.contains("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"));
    let own = without_library(&page);
    for fetch in ["http:", "https:", "<link", "<iframe", "<img", "src=", "@import", "url(", "fetch("] {
        assert!(!own.contains(fetch), "the page has `{fetch}`");
    }
}

#[test]
fn the_page_has_every_curve_under_its_name() {
    let expected = [
        ("areas", vec!["outline area", "vector area", "tractors' polygon", "80 % of the flat web"]),
        ("speeds", vec!["B", "tractors"]),
        ("travels", vec!["centre", "corners", "tractors", "B"]),
        ("class-tensions", vec!["traction", "traction, mean", "ring", "ring, mean"]),
        ("point-tensions", vec!["B (bottom ropes)"]),
        ("energies", vec!["kinetic", "elastic"]),
        ("residual", vec!["residual"]),
    ];
    let page = page(&summary(), &history());
    let found = curves(&page);
    assert_eq!(found.len(), expected.len());
    for ((id, names), (expected_id, expected_names)) in found.iter().zip(&expected) {
        assert_eq!(id, expected_id);
        assert_eq!(names, expected_names, "curves of {id}");
        assert!(page.contains(&format!("<div class=\"plot\" id=\"{id}\">")));
    }
}

/// The unit and the first value of the chart of tension by class.
fn first_tension(history: &str) -> (String, Value) {
    let page = page(&summary(), history);
    let figures = figures(&page);
    let tensions = figures.iter().find(|figure| figure["id"] == "class-tensions").unwrap();
    (tensions["unit"].as_str().unwrap().to_owned(), tensions["curves"][0]["y"][0].clone())
}

#[test]
fn curves_carry_the_numbers_of_the_history_in_a_fitting_unit() {
    let page = page(&summary(), &history());
    let area = &figures(&page)[0];
    assert_eq!(area["yTitle"], "area, m²");
    assert_eq!(area["shaded"], json!([0.112, 0.193]));
    // the second column is twice the time
    assert_eq!(area["curves"][0]["x"][300], json!(0.3));
    assert_eq!(area["curves"][0]["y"][300], json!(0.6));
    // 80 % of 16.238 m2
    assert_eq!(area["curves"][3]["y"], json!([12.9904, 12.9904]));

    let loud = format!("{COLUMNS}\n{}\n", vec!["48200"; COLUMNS.split(',').count()].join(","));
    assert_eq!(first_tension(&loud), ("kN".to_owned(), json!(48.2)));
}

#[test]
fn the_page_has_the_sentences_and_the_table_of_numbers() {
    let page = page(&summary(), &history());
    assert!(page.contains("<li>Opens to 15.8 m² (97 % of the flat web) at 0.131 s.</li>"));
    assert!(page.contains("<li>The air is left out.</li>"));
    for number in ["51.0 kN", "1.84", "segment 12 of traction rope 3", "1.30 µs", "2026-11-22T01:42:17Z"] {
        assert!(page.contains(number), "{number}");
    }
}

#[test]
fn without_fields_the_page_says_what_a_replay_needs() {
    let page = page(&summary(), &history());
    assert!(page.contains("There is nothing to replay: a replay needs fields.vtkhdf"));
    assert!(!page.contains("id=\"replay-data\"") && !page.contains("id=\"replay-view\""));
}

#[test]
fn the_page_shows_the_resolved_scenario() {
    let folder = folder(&summary(), &history());
    fs::create_dir(folder.path().join("inputs")).unwrap();
    fs::write(folder.path().join("inputs/scenario.toml"), "title = \"a <b> & c\"\n").unwrap();
    let page = fs::read_to_string(write_report(folder.path()).unwrap()).unwrap();
    assert!(page.contains("<pre>title = &quot;a &lt;b&gt; &amp; c&quot;\n</pre>"));
    let folder = self::folder(&summary(), &history());
    let page = fs::read_to_string(write_report(folder.path()).unwrap()).unwrap();
    assert!(!page.contains("<h2>Inputs</h2>"));
}

#[test]
fn a_title_cannot_become_markup() {
    let mut summary = summary();
    summary["title"] = json!("</title><script>alert(\"1 & 2\")</script> {{words}}");
    summary["step"]["limited_by"] = json!("<b>rope</b>");
    let history = history().replace("ring_", "</script><b>_");
    let own = without_library(&page(&summary, &history));
    assert!(own.contains("&lt;/title&gt;&lt;script&gt;alert(&quot;1 &amp; 2&quot;)&lt;/script&gt; {{words}}"));
    assert!(own.contains("&lt;b&gt;rope&lt;/b&gt;") && !own.contains("<b>"));
    assert!(!own.contains("<script>alert"));
}

#[test]
fn missing_and_null_values_are_left_out() {
    let summary = json!({
        "title": "", "finished": false,
        "opening": {"area_max_m2": null, "reference_area_m2": null, "effective_from_s": null, "effective_to_s": null},
        "points": {"A": null, "tractor": null}, "tension": {"max_n": 0.0, "max_time_s": null, "by_class": {}},
        "posture": {"concave_from_s": null}, "energy": {"closure": null}
    });
    let page = page(&summary, "time_s,area_m2,tractor_travel_m,energy_kinetic_j\n0,,,1\n0.001,,,2\n");
    assert_eq!(curves(&page), [("energies".to_owned(), vec!["kinetic".to_owned()])]);
    assert!(page.contains("<title>Untitled scenario</title>"));
    assert!(page.contains("stopped early"));
    assert!(!without_library(&page).contains("NaN"));
}

#[test]
fn a_run_that_failed_at_its_start_has_a_page() {
    let page = page(&json!({"title": "Failed", "finished": false}), "time_s\n");
    assert!(curves(&page).is_empty());
    assert!(page.contains("The run stopped before its end"));
}

#[test]
fn the_error_names_the_file_that_is_missing_or_malformed() {
    let empty = tempfile::tempdir().unwrap();
    assert!(write_report(empty.path()).unwrap_err().to_string().contains("summary.json"));

    let bad_cell = folder(&summary(), "time_s,area_m2\n0,1\n0.001,wide\n");
    let error = write_report(bad_cell.path()).unwrap_err();
    assert!(matches!(&error, ReportError::Result(_)), "{error}");

    let bad_json = folder(&summary(), &history());
    fs::write(bad_json.path().join("manifest.json"), "{").unwrap();
    assert!(matches!(write_report(bad_json.path()), Err(ReportError::Result(ResultError::Json { .. }))));
}

#[test]
fn channels_that_are_zero_all_along_have_no_curve_and_the_others_look_different() {
    let channels = |count: usize| (0..count).map(|place| format!("energy_c{place}_j")).collect::<Vec<_>>().join(",");
    let row = |time: f64| {
        // the fourth holds nothing, the fifth the rounding error of the others
        let values = (0..17).map(|place| match place {
            3 => 0.0,
            4 => 1e-12,
            other => 1e3 * time + other as f64,
        });
        format!("{time},{}\n", values.map(|value| value.to_string()).collect::<Vec<_>>().join(","))
    };
    let history = format!("time_s,{}\n{}{}", channels(17), row(0.0), row(0.1));
    let page = page(&summary(), &history);
    let figures = figures(&page);
    let curves = figures.iter().find(|figure| figure["id"] == "energies").unwrap()["curves"].as_array().unwrap();
    let names: Vec<&str> = curves.iter().map(|curve| curve["name"].as_str().unwrap()).collect();
    assert!(names.len() == 15 && !names.contains(&"c3") && !names.contains(&"c4"), "{names:?}");
    // colour and dash follow from the place
    let places: Vec<u64> = curves.iter().map(|curve| curve["colour"].as_u64().unwrap()).collect();
    assert_eq!(places, (0..15).collect::<Vec<u64>>());
}

#[test]
fn points_of_a_user_never_take_the_place_of_a_point_of_the_paper() {
    let history = "time_s,gate_speed_m_s,post_speed_m_s,tractor_speed_m_s,B_speed_m_s\n0,1,2,3,4\n0.1,1,2,3,5\n";
    let figures = figures(&page(&summary(), history));
    let curves = figures.iter().find(|figure| figure["id"] == "speeds").unwrap()["curves"].as_array().unwrap().clone();
    let mut places: Vec<u64> = curves.iter().map(|curve| curve["colour"].as_u64().unwrap()).collect();
    places.sort_unstable();
    places.dedup();
    assert_eq!(places.len(), 4, "two points have one colour");
}

#[test]
fn backquotes_of_a_warning_are_code() {
    let mut summary = summary();
    summary["warnings"] = json!(["raise `solve.step_fraction` <now>"]);
    let page = page(&summary, &history());
    assert!(page.contains("<li>raise <code>solve.step_fraction</code> &lt;now&gt;</li>"));
}

#[test]
fn the_letters_of_the_points_are_explained_where_the_web_has_them() {
    let mut summary = summary();
    assert!(!page(&summary, &history()).contains("are the feature points of the paper"), "there is B alone");
    summary["points"]["C"] = summary["points"]["B"].clone();
    let told = "B and C are the feature points of the paper that these webs come from: B in the middle of the web, C at a corner.";
    assert!(page(&summary, &history()).contains(told));
    // the points of a net that its user drew have no such places
    let folder = folder(&summary, &history());
    fs::create_dir(folder.path().join("inputs")).unwrap();
    fs::write(folder.path().join("inputs/scenario.toml"), "[web.graph]\nnodes = \"n.csv\"\n").unwrap();
    let page = fs::read_to_string(write_report(folder.path()).unwrap()).unwrap();
    assert!(!page.contains("are the feature points of the paper"));
}

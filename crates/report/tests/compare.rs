//! The page of a comparison: complete, offline, safe against markup in texts, and written for partial folders too.

use std::fs;
use std::path::Path;

use netcast_report::{ReportError, write_comparison, write_pictures, write_report};
use netcast_results::ResultError;
use serde_json::{Value, json};
use tempfile::TempDir;

fn manifest() -> Value {
    json!({
        "program": "netcast", "version": "0.1.0", "revision": null, "input_hash": "e3b0c44298fc1c14", "threads": 1,
        "machine": {"os": "linux", "arch": "x86_64", "cpu": null, "cores": 2}, "seed": null, "wall_time_s": 1.5,
        "started": "2026-11-22T01:42:17Z"
    })
}

fn comparison() -> Value {
    let row = |quantity: &str, label: &str, unit: &str, better: Value, values: Value, best: Value| {
        json!({"quantity": quantity, "label": label, "unit": unit, "group": "Opening", "headline": true,
               "better": better,
               "reproducible": true, "values": values, "best": best, "reported": {}, "deviation_percent": {}})
    };
    let mut time = row(
        "opening.area_max_time_s",
        "Time of largest outline area",
        "s",
        json!("lower"),
        json!({"ring": 0.12, "star": 0.14}),
        json!(["ring"]),
    );
    time["reported"] = json!({"star": 0.16});
    time["deviation_percent"] = json!({"star": -12.5});
    json!({
        "title": "ring and star", "netcast": "0.1.0", "finished": false,
        "designs": [
            {"name": "ring", "title": "A ring", "folder": "ring", "finished": true, "failure": null,
             "warnings": ["no air"]},
            {"name": "star", "title": "</title><script>alert(1)</script>{{style}}", "folder": "star", "finished": false,
             "failure": "step 3 <b>", "warnings": ["step 3 <b>"]}
        ],
        "reported": "a <i>test</i>",
        "differences": [{"path": "rope.elastic_modulus", "values": {"ring": "78000000000 Pa", "star": null}},
                        {"path": "launch.elevation", "values": {"ring": "1.5707963267948966 rad", "star": "0.5 rad"}}],
        "table": [
            time,
            row("tension.max_n", "Highest tension", "N", json!("lower"), json!({"ring": 51e3, "star": null}), json!([])),
            row("model.segments", "Segments", "", Value::Null, json!({"ring": 1998, "star": 12}), json!([])),
            row("flight.still_up", "Still up", "", Value::Null, json!({"ring": true, "star": false}), json!([])),
        ]
    })
}

/// A folder with the histories of two designs and no fields.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |path: &Path, name: &str, text: String| fs::write(path.join(name), text).unwrap();
    write(folder.path(), "summary.json", comparison().to_string());
    write(folder.path(), "manifest.json", manifest().to_string());
    for (name, column) in [("ring", "ring_mean_n"), ("star", "B_speed_m_s")] {
        let own = folder.path().join(name);
        fs::create_dir(&own).unwrap();
        write(&own, "summary.json", json!({"title": name, "finished": true}).to_string());
        write(&own, "manifest.json", manifest().to_string());
        let header =
            format!("time_s,area_m2,{column},energy_kinetic_j,energy_elastic_j,energy_gravity_j,mouth_tilt_rad\n");
        write(&own, "history.csv", header + "0,1.5,2,100,20,3,0.5\n0.1,2.5,3,200,40,,\n");
    }
    folder
}

fn page() -> String {
    let folder = folder();
    fs::read_to_string(write_comparison(folder.path()).unwrap()).unwrap()
}

/// The page without the charting library, whose source mentions addresses that it never fetches.
fn own(page: &str) -> String {
    let start = page.find("<script type=\"text/plain\" id=\"library\">").expect("the library is embedded");
    let end = start + page[start..].find("</script>").expect("a script ends");
    format!("{}{}", &page[..start], &page[end..])
}

fn data(page: &str) -> Value {
    let (_, data) = page.split_once("id=\"comparison-data\">").unwrap();
    serde_json::from_str(data.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn the_page_is_one_file_that_fetches_nothing_and_escapes_markup() {
    let page = page();
    assert!(page.contains("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none';"));
    let own = own(&page);
    for fetch in ["http:", "https:", "<link", "<iframe", "<img", "src=", "@import", "url(", "fetch("] {
        assert!(!own.contains(fetch), "the page has `{fetch}`");
    }
    assert!(own.contains("&lt;/title&gt;&lt;script&gt;alert(1)&lt;/script&gt;{{style}}"));
    assert!(own.contains("a &lt;i&gt;test&lt;/i&gt;") && own.contains("step 3 &lt;b&gt;"));
    assert!(!own.contains("<script>alert"));
}

#[test]
fn the_table_marks_the_best_and_shows_reported_values_with_their_deviation() {
    let page = page();
    assert!(page.contains("★ </span>0.120<span class=\"said\"> (best)</span>"));
    assert!(page.contains("<td class=\"reported\">0.160<small>-12 %</small></td>"));
    for told in [
        "Time of largest outline area<span class=\"unit\">, s</span>",
        "Highest tension<span class=\"unit\">, kN</span>",
        "<td>51.0</td>",
        "<td>1\u{202f}998</td>",
        "<td>yes</td>",
        "<td>90 deg</td>",
        "<td>78 GPa</td><td class=\"nothing\">absent</td>",
        "title=\"lower is better\">↓",
    ] {
        assert!(page.contains(told), "{told}");
    }
}

#[test]
fn a_design_that_failed_is_listed_with_the_reason() {
    let page = page();
    assert!(page.contains("<b>star</b>: step 3 &lt;b&gt;."));
    assert!(page.contains("stopped early"));
    // once, not again as a warning
    assert_eq!(page.matches("step 3 &lt;b&gt;").count(), 1);
    assert!(page.contains("<li>no air</li>"));
}

#[test]
fn a_figure_has_one_curve_for_each_design() {
    let data = data(&page());
    let figures = data["figures"].as_array().unwrap();
    let figure =
        |id: &str| figures.iter().find(|figure| figure["id"] == id).unwrap_or_else(|| panic!("no figure {id}"));
    let names: Vec<&str> = figures.iter().map(|figure| figure["id"].as_str().unwrap()).collect();
    assert_eq!(names, ["area", "ring-tension", "b-speed", "tilt", "energy"]);
    let area = figure("area")["curves"].as_array().unwrap();
    assert_eq!((&area[1]["name"], &area[1]["colour"]), (&json!("star"), &json!(1)));
    // a design keeps its colour where the others have no curve
    assert_eq!(figure("b-speed")["curves"].as_array().unwrap().len(), 1);
    assert_eq!(figure("b-speed")["curves"][0]["colour"], 1);
    // the sum has a gap where a summand has one
    assert_eq!(figure("energy")["curves"][0]["y"], json!([123.0, null]));
    assert_eq!(figure("tilt")["unit"], "°");
    assert_eq!(figure("tilt")["curves"][0]["y"][0], json!(28.6479));
}

#[test]
fn missing_files_are_named_on_the_page_or_in_the_error() {
    let folder = folder();
    let page = fs::read_to_string(write_comparison(folder.path()).unwrap()).unwrap();
    assert!(page.contains("star: its folder holds no fields or landmarks"));
    assert!(!page.contains("id=\"replay-0\""));
    fs::remove_file(folder.path().join("star/history.csv")).unwrap();
    let error = write_comparison(folder.path()).unwrap_err().to_string();
    assert!(error.contains("history.csv"), "{error}");
    fs::write(folder.path().join("summary.json"), "{").unwrap();
    assert!(matches!(write_comparison(folder.path()), Err(ReportError::Result(ResultError::Json { .. }))));
}

#[test]
fn the_report_of_a_comparison_is_the_comparison_page() {
    let folder = folder();
    assert_eq!(write_report(folder.path()).unwrap(), folder.path().join("report.html"));
    assert!(fs::read_to_string(folder.path().join("report.html")).unwrap().contains("What differs in the inputs"));
}

#[test]
fn pictures_of_a_comparison_are_refused_with_the_folders_to_name_instead() {
    let folder = folder();
    let error = write_pictures(folder.path()).unwrap_err().to_string();
    assert!(error.contains("holds a comparison") && error.ends_with("ring, star"), "{error}");
}

#[test]
fn replays_come_before_tables_and_the_contents_list_all_sections() {
    let page = own(&page());
    let place = |text: &str| page.find(text).unwrap_or_else(|| panic!("the page has no {text}"));
    assert!(place("class=\"stages\"") < place("<table"));
    let ids: Vec<&str> = page.split("<section class=\"").skip(1).map(|rest| rest.split('"').next().unwrap()).collect();
    assert_eq!(ids, ["replay", "came-out", "differences", "figures", "quantities"]);
    assert!(ids.iter().all(|id| page.contains(&format!("<a href=\"#part-{id}\">"))));
}

//! The files of a run, their folder, and the printed output.

use std::fs;

use crate::workbench::{Ended, Workbench, listing};

const FILES: [&str; 9] = [
    "fields.vtkhdf",
    "history.csv",
    "inputs/",
    "inputs/scenario.toml",
    "landmarks.json",
    "manifest.json",
    "report.html",
    "summary.json",
    "",
];

#[test]
fn a_run_writes_the_files_of_the_contract_and_no_others() {
    let workbench = Workbench::with_net();
    let ended = workbench.succeed(&["run", "net.toml"]);
    let found = listing(&workbench.path("results"));
    let mut expected: Vec<String> = FILES.iter().map(|file| format!("net/{file}")).collect();
    expected.sort();
    assert_eq!(found.keys().cloned().collect::<Vec<_>>(), expected);
    assert_eq!(workbench.listing().len(), 2 + expected.len(), "net.toml, results/ and the result");

    assert!(ended.stdout.starts_with("A small net\n  Opens to "), "{}", ended.stdout);
    assert!(ended.stdout.contains("report.html"), "{}", ended.stdout);
    // no bar where standard error is no terminal
    assert_eq!(ended.stderr, "");

    let manifest: serde_json::Value = serde_json::from_str(&workbench.read("results/net/manifest.json")).unwrap();
    for key in ["version", "revision", "input_hash", "machine", "threads", "seed", "wall_time_s"] {
        assert!(manifest.get(key).is_some(), "{key}: {manifest}");
    }
    let page = workbench.read("results/net/report.html");
    for outside in ["<script src", "<link", "<img", "<iframe", "@import"] {
        assert!(!page.contains(outside), "the report needs the network: {outside}");
    }
}

#[test]
fn history_has_one_row_a_record_and_the_columns_of_the_contract() {
    let workbench = Workbench::with_net();
    workbench.succeed(&["run", "net.toml", "--quiet"]);
    let history = workbench.read("results/net/history.csv");
    let mut lines = history.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert_eq!(
        columns[..8],
        [
            "time_s",
            "area_m2",
            "vector_area_m2",
            "tractor_area_m2",
            "centre_travel_m",
            "corner_travel_m",
            "tractor_travel_m",
            "tension_max_n"
        ]
    );
    for column in
        ["B_x_m", "B_y_m", "B_z_m", "B_travel_m", "B_speed_m_s", "B_tension_n", "outline_mean_n", "inner_max_n"]
    {
        assert!(columns.contains(&column), "{column}: {columns:?}");
    }
    let times: Vec<f64> = lines.map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(times.len(), 11);
    for (row, time) in times.iter().enumerate() {
        assert!((time - 0.005 * row as f64).abs() < 1e-12, "{times:?}");
    }
    // stowed at a quarter: a sixteenth of 4 m^2, and corner masses of 0.3 kg
    let first: Vec<&str> = history.lines().nth(1).unwrap().split(',').collect();
    assert!((first[1].parse::<f64>().unwrap() - 0.25).abs() < 1e-12, "{first:?}");
    let summary = workbench.summary("results/net");
    assert!((summary["opening"]["reference_area_m2"].as_f64().unwrap() - 4.0).abs() < 1e-12);
    assert!((summary["model"]["tractor_mass_kg"].as_f64().unwrap() - 1.2).abs() < 1e-12);
    // 4 meshes a side: 2 x 5 lines of 2 m
    assert!((summary["model"]["rope_length_m"].as_f64().unwrap() - 20.0).abs() < 1e-12);
    assert_eq!(summary["model"]["segments"], 80);
}

#[test]
fn json_is_the_summary_and_nothing_else() {
    let workbench = Workbench::with_net();
    let Ended { stdout, stderr, .. } = workbench.succeed(&["run", "net.toml", "--json"]);
    assert_eq!(stdout, workbench.read("results/net/summary.json"));
    assert_eq!(stderr, "");
    let quiet = workbench.succeed(&["run", "net.toml", "--json", "--quiet", "--out", "other"]);
    assert_eq!(quiet.stdout, workbench.read("other/summary.json"));
}

#[test]
fn quiet_prints_nothing() {
    let workbench = Workbench::with_net();
    let ended = workbench.succeed(&["run", "net.toml", "--quiet"]);
    assert_eq!((ended.stdout, ended.stderr), (String::new(), String::new()));
    assert!(workbench.path("results/net/summary.json").is_file());
}

#[test]
fn a_run_replaces_its_own_result_and_keeps_files_of_the_user() {
    let workbench = Workbench::with_net();
    workbench.succeed(&["run", "net.toml", "--quiet"]);
    fs::write(workbench.path("results/net/notes.txt"), "of the user").unwrap();
    fs::write(workbench.path("results/net/inputs/of_the_first_run"), "").unwrap();
    workbench.succeed(&["run", "net.toml", "--quiet", "--set", "title=second"]);
    assert_eq!(workbench.summary("results/net")["title"], "second");
    assert!(!workbench.path("results/net/inputs/of_the_first_run").exists());
    assert_eq!(fs::read_to_string(workbench.path("results/net/notes.txt")).unwrap(), "of the user");
    assert_eq!(fs::read_dir(workbench.path("results")).unwrap().count(), 1, "nothing is left beside the result");
}

#[test]
fn a_folder_that_netcast_did_not_write_is_refused_and_stays() {
    let workbench = Workbench::with_net();
    fs::create_dir_all(workbench.path("thesis")).unwrap();
    fs::write(workbench.path("thesis/chapter.tex"), "years of work").unwrap();
    fs::create_dir_all(workbench.path("empty")).unwrap();
    let before = workbench.listing();
    for (out, said) in [
        ("thesis", "not written by netcast"),
        ("thesis/chapter.tex", "is a file"),
        ("thesis/chapter.tex/deeper", "chapter.tex"),
        (".", "is the current folder"),
        ("..", "is the current folder or holds it"),
    ] {
        let ended = workbench.netcast(&["run", "net.toml", "--out", out]);
        assert_eq!(ended.status, 2, "{out}: {}", ended.stderr);
        assert!(ended.stderr.contains(said), "{out}: {}", ended.stderr);
    }
    assert!(workbench.listing() == before, "something was written");
    workbench.succeed(&["run", "net.toml", "--quiet", "--out", "empty"]);
    assert!(workbench.path("empty/summary.json").is_file());
}

#[test]
#[cfg(target_os = "linux")]
fn a_folder_that_cannot_be_made_is_wrong_input_and_is_named_as_given() {
    let ended = Workbench::with_net().netcast(&["run", "net.toml", "--out", "/proc/results"]);
    assert_eq!(ended.status, 2, "{}", ended.stderr);
    assert!(ended.stderr.contains("cannot make the folder /proc/results:"), "{}", ended.stderr);
}

/// A run whose record interval did not divide its duration ended up to a step early or late.
#[test]
fn a_run_ends_at_its_duration_for_any_record_interval() {
    let workbench = Workbench::with_net();
    for every in ["7 ms", "5 ms", "11 ms", "1 s"] {
        workbench.succeed(&["run", "net.toml", "--quiet", "--set", &format!("record.every={every}")]);
        let history = workbench.read("results/net/history.csv");
        let times: Vec<&str> = history.lines().skip(1).map(|row| row.split(',').next().unwrap()).collect();
        assert_eq!(times.last(), Some(&"0.05"), "every {every}");
        if every == "7 ms" {
            assert_eq!(times[..4], ["0", "0.007", "0.014", "0.021"]);
        }
    }
}

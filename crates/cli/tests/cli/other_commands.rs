//! `check`, `stow`, `init`, `report` and `schema`.

use std::fs;

use crate::workbench::{SMALL_NET, Workbench};

const KINDS: [&str; 9] =
    ["space", "traditional", "topological", "square", "polygon", "radial", "diamond", "graph", "held"];

/// The row `name` of `check`, with `more` in the scenario.
fn row(workbench: &Workbench, name: &str, more: &[&str]) -> String {
    let sets = more.iter().flat_map(|more| ["--set", more]);
    let said = workbench.succeed(&["check", "net.toml"].into_iter().chain(sets).collect::<Vec<&str>>()).stdout;
    let row = said.lines().find_map(|line| line.trim_start().strip_prefix(name));
    row.unwrap_or_else(|| panic!("{name}: {said}")).trim().to_owned()
}

#[test]
fn check_prints_ground_orbit_and_fall() {
    let workbench = Workbench::with_net();
    let ground = ["environment.ground={height=\"-1.5 m\", friction=0.3, contact_time=\"2 ms\"}"];
    let row_of = |name: &str| row(&workbench, name, &ground);
    assert_eq!(row_of("height"), "1.500 m below the muzzle");
    assert_eq!([row_of("friction"), row_of("restitution")], ["0.300", "0.200"]);
    // 20 m/s times 2 ms over pi
    assert_eq!(row_of("20 m/s sinks in by"), "12.7 mm at most");
    assert!(row_of("touched by").ends_with(" nodes"), "{}", row_of("touched by"));
    // 2 pi sqrt((6378.137 km + 400 km)^3 / GM)
    let orbit = ["environment.orbit.altitude=400 km"];
    assert_eq!(row(&workbench, "mean motion", &orbit), "0.0011314 rad/s");
    assert!(row(&workbench, "period", &orbit).ends_with(", 92.56 min"), "{}", row(&workbench, "period", &orbit));

    let fall = |air: &str| row(&workbench, "the web falls", &[air]);
    assert!(fall("environment.air={}").ends_with("m/s in the end, flat and without tractors"));
    assert_eq!(fall("environment.air.normal_coefficient=0"), "ever faster: it has no drag");
    assert_eq!(fall("environment.air={density=2000, viscosity=\"1 mPa s\"}"), "not at all: it floats");
}

#[test]
fn check_prints_materials_and_cost_and_writes_nothing() {
    let workbench = Workbench::with_net();
    let before = workbench.listing();
    let said = workbench.succeed(&["check", "net.toml"]).stdout;
    assert!(workbench.listing() == before, "something was written");
    let value = |name: &str| {
        let row =
            said.lines().find(|line| line.trim_start().starts_with(name)).unwrap_or_else(|| panic!("{name}: {said}"));
        row.trim_start()[name.len()..].trim().to_owned()
    };
    // ten lines of 2 m; 1140 kg/m^3 and 3 mm: 8.058 g a metre
    assert_eq!(value("rope 3.00 mm"), "20.000 m, 0.1612 kg");
    assert_eq!(value("of which outline"), "8.0000 m");
    assert_eq!(value("of which inner"), "12.000 m");
    assert_eq!(value("knots, ropes"), "25, 40");
    assert_eq!(value("tractors"), "4, 1.200 kg");
    assert_eq!(value("total thrown mass"), "1.361 kg");
    assert_eq!(value("model"), "65 nodes, 80 segments");
    assert_eq!(value("area inside the outline"), "4.0000 m^2 flat");
    assert!(value("longest stretch").starts_with("none"), "{said}");
    assert!(value("step").contains(" us, at most 28.0 % of the stable "), "{said}");
    assert!(value("records").starts_with("11, "), "{said}");
    let step: Vec<&str> = said.lines().filter(|line| line.contains("limited by segment")).collect();
    assert_eq!(step.len(), 1, "{said}");
    // a run takes the number of steps that it prints
    workbench.succeed(&["run", "net.toml", "--quiet"]);
    let count = workbench.summary("results/net")["step"]["count"].to_string();
    assert_eq!(value("steps"), format!("{count} for 0.05000 s"));
}

#[test]
fn check_and_stow_print_json() {
    let workbench = Workbench::with_net();
    let before = workbench.listing();
    let json = |arguments: &[&str]| -> serde_json::Value {
        let said = workbench.succeed(arguments).stdout;
        serde_json::from_str(&said).unwrap_or_else(|error| panic!("{error}: {said}"))
    };
    let facts = json(&["check", "net.toml", "--json"]);
    // ten lines of 2 m; 1140 kg/m^3 and 3 mm
    let (rope, cost) = (&facts["bill"]["ropes"][0], &facts["cost"]);
    let mass = 20.0 * 1140.0 * std::f64::consts::PI * 2.25e-6;
    assert!((rope["length_m"].as_f64().unwrap() - 20.0).abs() < 1e-9, "{rope}");
    assert!((rope["mass_kg"].as_f64().unwrap() - mass).abs() < 1e-9, "{rope}");
    assert_eq!((&cost["nodes"], &cost["segments"], &cost["records"]), (&65.into(), &80.into(), &11.into()));
    assert!(cost["one_core_s"].as_f64().unwrap() > 0.0, "{cost}");
    assert!(facts["air"].is_null() && facts["links"].is_null());
    let links = json(&["check", "net.toml", "--json", "--links"])["links"].as_array().unwrap().len();
    assert_eq!(links, 40);
    let falling = json(&["check", "net.toml", "--json", "--set", "environment.air={}"]);
    assert!(falling["air"]["fall"]["terminal_speed_m_s"].as_f64().unwrap() > 0.0, "{falling}");
    let stowed = json(&["stow", "net.toml", "--json"]);
    assert!(stowed["start"]["longest_stretch"].as_f64().unwrap() <= 0.0, "{stowed}");
    assert!(stowed["packing"]["is_compared"].as_bool().unwrap(), "{stowed}");
    assert!(workbench.listing() == before, "something was written");
    // a wrong scenario is still reported on standard error
    let ended = workbench.netcast(&["check", "net.toml", "--json", "--set", "rope.diameter=2 kg"]);
    assert_eq!((ended.status, &ended.stdout[..]), (2, ""));
}

#[test]
fn a_note_tells_of_a_value_that_was_chosen() {
    let net = SMALL_NET.replace("segments_per_mesh = 2\n", "");
    let workbench = Workbench::new(&[("net.toml", &net)]);
    let said = workbench.succeed(&["check", "net.toml"]).stdout;
    assert!(said.contains("note: ropes are cut into segments of about"), "{said}");
    workbench.succeed(&["run", "net.toml", "--quiet"]);
    assert!(workbench.summary("results/net")["warnings"].to_string().contains("segments of about"));
}

#[test]
fn a_stowed_web_can_be_written_changed_and_run() {
    let workbench = Workbench::with_net();
    let bag = ["--set", "stow={bag={radius=\"0.2 m\"}}"];
    let said = workbench.succeed(&[&["stow", "net.toml", "--write", "stowed.csv"][..], &bag].concat()).stdout;
    for audit in [
        "longest stretch",
        "stored energy    0 J",
        "packed size      radius 0.2000 m",
        "kg/m^3",
        "closest approach",
        "nearer than a diameter",
    ] {
        assert!(said.contains(audit), "{audit}: {said}");
    }
    let rows = workbench.read("stowed.csv");
    assert_eq!(rows.lines().next(), Some("id,x,y,z"));
    assert_eq!(rows.lines().count(), 1 + 65);

    workbench.succeed(&[&["run", "net.toml", "--quiet", "--out", "bag"][..], &bag].concat());
    workbench.succeed(&["run", "net.toml", "--quiet", "--out", "file", "--set", "stow={file={path=\"stowed.csv\"}}"]);
    for file in ["history.csv", "fields.vtkhdf"] {
        let [bag, from_file] = ["bag", "file"].map(|folder| fs::read(workbench.path(folder).join(file)).unwrap());
        assert!(bag == from_file, "{file}");
    }
    assert!(workbench.path("file/inputs/stowed.csv").is_file());
}

/// Its positions are in the launch frame.
#[test]
fn a_stow_file_does_not_depend_on_the_launch() {
    let workbench = Workbench::with_net();
    let tilted = ["--set", "launch.elevation=30 deg", "--set", "launch.azimuth=70 deg"];
    workbench.succeed(&["stow", "net.toml", "--write", "up.csv"]);
    workbench.succeed(&[&["stow", "net.toml", "--write", "tilted.csv"][..], &tilted].concat());
    let numbers = |file: &str| -> Vec<f64> {
        let text = workbench.read(file);
        text.lines().skip(1).flat_map(|line| line.split(',').skip(1)).map(|cell| cell.parse().unwrap()).collect()
    };
    for (up, tilted) in numbers("up.csv").into_iter().zip(numbers("tilted.csv")) {
        assert!((up - tilted).abs() < 1e-15 * 8.0, "{up} {tilted}");
    }
}

/// `--write` with the scenario's own name once destroyed it.
#[test]
fn a_stow_file_is_not_written_over_another_file() {
    let workbench = Workbench::with_net();
    let before = workbench.read("net.toml");
    let ended = workbench.netcast(&["stow", "net.toml", "--write", "net.toml"]);
    assert_eq!(ended.status, 2);
    assert!(ended.stderr.contains("cannot write net.toml"), "{}", ended.stderr);
    assert_eq!(workbench.read("net.toml"), before);
}

#[test]
fn a_stow_file_that_cannot_be_written_is_named() {
    let ended = Workbench::with_net().netcast(&["stow", "net.toml", "--write", "no/such/folder.csv"]);
    assert_eq!(ended.status, 2);
    assert!(ended.stderr.contains("cannot write no/such/folder.csv"), "{}", ended.stderr);
}

#[test]
fn every_kind_of_template_can_be_checked_and_run() {
    let workbench = Workbench::new(&[]);
    for kind in KINDS {
        let file = format!("{kind}/{kind}.toml");
        let said = workbench.succeed(&["init", kind, "--out", &file]).stdout;
        assert!(said.contains(&format!("next: netcast run {file}")), "{said}");
        workbench.succeed(&["check", &file]);
        workbench.succeed(&["run", &file, "--quiet", "--set", "solve.duration=2 ms"]);
        assert_eq!(workbench.summary(&format!("results/{kind}"))["finished"], true);
        // at least one line in four has a comment
        let text = workbench.read(&file);
        let (comments, lines) = (text.matches('#').count(), text.lines().filter(|line| !line.is_empty()).count());
        assert!(4 * comments >= lines, "{file}: {comments} comments in {lines} lines");
    }
    let help = workbench.succeed(&["init", "--help"]).stdout;
    for kind in KINDS {
        assert!(help.contains(&format!("- {kind}:")), "{help}");
    }
}

#[test]
fn init_overwrites_nothing() {
    let workbench = Workbench::new(&[("nodes.csv", "mine")]);
    let before = workbench.listing();
    let ended = workbench.netcast(&["init", "graph"]);
    assert_eq!(ended.status, 2);
    assert!(ended.stderr.contains("nodes.csv exists already"), "{}", ended.stderr);
    assert!(workbench.listing() == before, "something was written");
    workbench.succeed(&["init", "held"]);
    let before = workbench.listing();
    assert_eq!(workbench.netcast(&["init", "space"]).status, 2);
    assert!(workbench.listing() == before, "something was written");
}

#[test]
fn a_report_can_be_written_again_from_the_results_alone() {
    let workbench = Workbench::with_net();
    workbench.succeed(&["run", "net.toml", "--quiet"]);
    let page = workbench.read("results/net/report.html");
    fs::remove_file(workbench.path("results/net/report.html")).unwrap();
    fs::rename(workbench.path("results/net"), workbench.path("moved")).unwrap();
    let said = workbench.succeed(&["report", "moved"]).stdout;
    assert!(said.contains("report.html"), "{said}");
    assert!(workbench.read("moved/report.html") == page, "the report differs from that of the run");
}

#[test]
fn a_folder_without_results_has_no_report() {
    let workbench = Workbench::with_net();
    let before = workbench.listing();
    for folder in [".", "nowhere", "net.toml"] {
        let ended = workbench.netcast(&["report", folder]);
        assert_eq!(ended.status, 2, "{folder}");
        assert!(ended.stderr.contains("summary.json"), "{}", ended.stderr);
        assert!(ended.stderr.contains("`netcast run`"), "{}", ended.stderr);
    }
    assert!(workbench.listing() == before, "something was written");
}

#[test]
fn the_schema_describes_every_section_of_a_scenario() {
    let text = Workbench::new(&[]).succeed(&["schema"]).stdout;
    let schema: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    for key in ["title", "web", "rope", "ropes", "assign", "canopy", "payload", "traction_rope", "tractor", "tractors"]
    {
        assert!(schema["properties"][key]["description"].is_string(), "{key}");
    }
    for key in ["stow", "launch", "environment", "solve", "record", "hold", "points"] {
        assert!(schema["properties"][key]["description"].is_string(), "{key}");
    }
}

#[test]
fn a_note_tells_of_tractors_that_are_launched_and_held() {
    let workbench = Workbench::with_net();
    let ended = workbench.succeed(&["check", "net.toml", "--set", "hold.corners=true"]);
    assert!(
        ended.stdout.contains("4 of 4 tractors are held by [hold] or [drive]: they are not launched"),
        "{}",
        ended.stdout
    );
}

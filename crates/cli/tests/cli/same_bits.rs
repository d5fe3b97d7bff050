//! Runs that must agree bit by bit: on any number of threads, and from the inputs that a run kept.

use std::fs;
use std::path::Path;

use crate::workbench::{SMALL_NET, Workbench};

/// The files that must not differ between two equal runs; the summary without its wall time.
fn bits(workbench: &Workbench, folder: &str) -> [(&'static str, Vec<u8>); 3] {
    let bytes = |name: &str| fs::read(workbench.path(folder).join(name)).unwrap();
    let summary = workbench.read(&format!("{folder}/summary.json"));
    let told: Vec<&str> = summary.lines().filter(|line| !line.contains("\"wall_time_s\"")).collect();
    assert_eq!(told.len() + 1, summary.lines().count());
    [
        ("history.csv", bytes("history.csv")),
        ("fields.vtkhdf", bytes("fields.vtkhdf")),
        ("summary.json", told.join("\n").into_bytes()),
    ]
}

fn assert_same(workbench: &Workbench, first: &str, second: &str) {
    for ((name, a), (_, b)) in bits(workbench, first).into_iter().zip(bits(workbench, second)) {
        assert!(a == b, "{name} of {second} differs from that of {first}");
    }
}

fn threads_agree(net: &str) -> Workbench {
    let workbench = Workbench::new(&[("net.toml", net)]);
    for threads in ["1", "2", "3", "8"] {
        workbench.succeed(&["run", "net.toml", "--quiet", "--threads", threads, "--out", threads]);
        let manifest: serde_json::Value =
            serde_json::from_str(&workbench.read(&format!("{threads}/manifest.json"))).unwrap();
        assert_eq!(manifest["threads"].to_string(), threads);
        assert_same(&workbench, "1", threads);
    }
    workbench
}

#[test]
fn any_number_of_threads_gives_the_same_bits_of_a_small_net() {
    threads_agree(SMALL_NET);
}

/// Fine enough that threads share the work, and under pretension, so that every segment counts.
#[test]
fn any_number_of_threads_gives_the_same_bits_of_a_large_net() {
    let net = SMALL_NET
        .replace("mesh = \"0.5 m\"\nsegments_per_mesh = 2", "mesh = \"0.02 m\"\nsegments_per_mesh = 1")
        .replace("elastic_modulus = \"5 GPa\"", "elastic_modulus = \"5 GPa\"\npretension = \"5 N\"")
        .replace("[stow.scale]\nfactor = 0.25\n", "")
        .replace("50 ms", "200 us")
        .replace("5 ms", "100 us");
    let workbench = threads_agree(&net);
    let summary = workbench.summary("1");
    // a net of 100 x 100 meshes; the engine shares work from 20,000 segments on
    assert_eq!(summary["model"]["segments"], 2 * 101 * 100);
    assert!(summary["step"]["count"].as_u64().unwrap() > 50);
    assert!(summary["tension"]["by_class"]["inner"]["max_n"].as_f64().unwrap() > 5.0);
}

fn inputs_run_again(workbench: &Workbench, scenario: &str, overrides: &[&str]) {
    let mut arguments = vec!["run", scenario, "--quiet", "--out", "first"];
    arguments.extend(overrides.iter().flat_map(|set| ["--set", set]));
    workbench.succeed(&arguments);
    workbench.succeed(&["run", "first/inputs/scenario.toml", "--quiet", "--out", "second"]);
    assert_same(workbench, "first", "second");
    // a resolved scenario resolves to itself
    assert_eq!(workbench.read("first/inputs/scenario.toml"), workbench.read("second/inputs/scenario.toml"));
    let hash = |folder: &str| {
        let manifest: serde_json::Value =
            serde_json::from_str(&workbench.read(&format!("{folder}/manifest.json"))).unwrap();
        manifest["input_hash"].as_str().unwrap().to_owned()
    };
    assert_eq!(hash("first"), hash("second"));
}

#[test]
fn the_inputs_of_a_run_give_the_same_bits_again() {
    inputs_run_again(&Workbench::with_net(), "net.toml", &[]);
}

#[test]
fn the_inputs_of_a_run_include_its_overrides() {
    let workbench = Workbench::with_net();
    inputs_run_again(&workbench, "net.toml", &["launch.axial_speed=25 m/s", "solve.step_fraction=0.1"]);
    assert!(workbench.read("first/inputs/scenario.toml").contains("25"));
}

#[test]
fn the_inputs_of_a_graph_include_its_files() {
    let workbench = Workbench::with_graph();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/06_graph_net/graph_net.toml");
    inputs_run_again(&workbench, example.to_str().unwrap(), &["solve.duration=20 ms"]);
    for file in ["nodes.csv", "ropes.csv"] {
        let original = fs::read(example.with_file_name(file)).unwrap();
        assert!(fs::read(workbench.path("first/inputs").join(file)).unwrap() == original, "{file}");
    }
}

#[test]
fn two_input_files_of_one_name_stay_two_files() {
    let workbench = Workbench::with_graph();
    for (folder, file) in [("a", "nodes.csv"), ("b", "ropes.csv")] {
        fs::create_dir(workbench.path(folder)).unwrap();
        fs::rename(workbench.path(file), workbench.path(folder).join("table.csv")).unwrap();
    }
    inputs_run_again(&workbench, "net.toml", &["web.graph.nodes=a/table.csv", "web.graph.ropes=b/table.csv"]);
}

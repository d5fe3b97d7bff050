//! Input that was dropped without a word: windows of records, velocities of nodes that do not move, rows that say a thing twice.

use std::path::Path;

use netcast::scenario::Source;
use netcast::{Case, Diagnostics, Document};
use tempfile::TempDir;

const ROPE: &str = "rope = { diameter = \"3 mm\", density = 1440, elastic_modulus = \"70 GPa\" }\n";

fn case(folder: &Path, scenario: &str, files: &[(&str, &str)]) -> Result<Case, Diagnostics> {
    for (name, text) in files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    let text = format!("web.graph = {{ nodes = \"nodes.csv\", ropes = \"ropes.csv\" }}\n{ROPE}{scenario}");
    Case::of(Document::parse(Source { name: "net.toml".into(), text }, folder, &[])?)
}

const NODES: (&str, &str) = ("nodes.csv", "id,x,y,z,mass,fixed,vx\na,0,0,0,1,0,0\nb,1,0,0,1,0,0\n");
const ROPES: (&str, &str) = ("ropes.csv", "a,b,segments\na,b,2\n");

/// A wind whose clock shows 1000 s at the start was steady for the whole run: its first row.
#[test]
fn a_wind_series_by_another_clock_is_refused_and_an_offset_sets_it_right() {
    let folder = TempDir::new().unwrap();
    let wind = |start: f64| {
        let row = |(t, v): (f64, f64)| format!("{},{v},0,0\n", start + t);
        format!("t,vx,vy,vz\n{}", [(0.0, 1.0), (0.5, 40.0), (1.0, 5.0)].map(row).concat())
    };
    let run = |series: &str, start: f64| {
        let scenario = format!(
            "environment = {{ gravity = 0, air = {{}}, wind.series = {{ file = \"wind.csv\"{series} }} }}\n\
             solve = {{ duration = 1, segment_length = 1 }}\nrecord.every = 0.1\n"
        );
        let files = [NODES, ROPES, ("wind.csv", &wind(start))];
        case(folder.path(), &scenario, &files).map(|case| case.simulate().unwrap().history().rows().to_vec())
    };
    let refused = run("", 1000.0).unwrap_err().to_string();
    for told in ["1000 s to 1001 s", "0 s to 1 s: nothing of it", "`time_offset = \"-1000 s\"`", "net.toml:3"] {
        assert!(refused.contains(told), "{told}: {refused}");
    }
    let right = run("", 0.0).unwrap();
    assert_eq!(run(", time_offset = \"-1000 s\"", 1000.0).unwrap(), right);
    assert_eq!(run(", time_offset = 0, scale = 1", 0.0).unwrap(), right);
    assert_ne!(run(", scale = 1.5", 0.0).unwrap(), right);
}

#[test]
fn what_a_graph_says_without_effect_is_told() {
    let folder = TempDir::new().unwrap();
    let notes = |scenario: &str, nodes: &str, ropes: &str| {
        let scenario = format!("solve.duration = 1\n{scenario}");
        let files = [("nodes.csv", nodes), ("ropes.csv", ropes), ("path.csv", "t,x,y,z\n1000,0,0,0\n1001,0,0,1\n")];
        case(folder.path(), &scenario, &files).unwrap().model().notes.join("\n")
    };
    let nodes = "id,x,y,z,mass,fixed,vx\na,0,0,0,0,1,3\nb,1,0,0,1,0,4\nc,2,0,0,1,0,0\n";
    let drive = "drive.x = { nodes = [\"b\"], file = \"path.csv\" }\n";
    let told = notes(drive, nodes, "a,b,segments\na,b,1\nb,a,1\nb,c,2\n");
    for expected in [
        "the velocity of fixed nodes does not act: a",
        "drives move nodes that web.graph.nodes fixes or gives a velocity, which does not act: b",
        "between the same two nodes, which pull side by side: lines 2 and 3",
        "the path of drive \"x\" covers 1000 s to 1001 s, and the run takes 0 s to 1 s: the run ends on the way to its first point",
    ] {
        assert!(told.contains(expected), "{expected}:\n{told}");
    }
    assert!(!told.contains("cut into segments of about"), "{told}");
    let plain = notes("", "id,x,y,z,mass,fixed\na,0,0,0,0,1\nb,1,0,0,1,0\nc,2,0,0,1,0\n", "a,b\na,b\nb,c\n");
    assert!(plain.contains("cut into segments of about") && !plain.contains("side by side"), "{plain}");
    // the same path from time 0
    let shifted = drive.replace("path.csv\"", "path.csv\", time_offset = \"-1000 s\"");
    assert!(!notes(&shifted, nodes, "a,b\na,b\nb,c\n").contains("covers"));
}

/// The advice was longer segments; two knots of a mesh lay 0.1 um apart.
#[test]
fn two_knots_that_nearly_coincide_are_named_as_what_bounds_the_step() {
    let folder = TempDir::new().unwrap();
    let nodes = "id,x,y,z,mass,fixed\na,0,0,0,0,1\nb,1,0,0,0,0\nc,1.0000001,0,0,0,0\nd,2,0,0,0.1,0\n";
    let solve = "solve = { duration = \"1 us\", segment_length = \"0.25 m\" }\nrecord.every = \"1 us\"\n";
    let case = case(folder.path(), solve, &[("nodes.csv", nodes), ("ropes.csv", "a,b\na,b\nb,c\nc,d\n")]).unwrap();
    assert_eq!(case.model().step_lift().as_deref(), Some("knots b and c made one: they nearly coincide"));
}

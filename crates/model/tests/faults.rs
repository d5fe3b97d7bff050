//! Whatever stage finds it: what is wrong with a web is told at once.

mod common;

use common::parse;
use netcast_model::Model;
use netcast_scenario::Diagnostics;

const NET: &str = r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 970, elastic_modulus = "5 GPa" }
tractor.particle.mass = 1
solve = { duration = "0.1 s", segment_length = "0.25 m" }
"#;

/// The paths of all that is wrong.
fn places(more: &str) -> Vec<String> {
    let document = parse(&format!("{NET}{more}"), &[]).unwrap_or_else(|wrong| panic!("{wrong}"));
    let Err(Diagnostics(found)) = Model::new(&document) else { panic!("nothing is wrong") };
    found.into_iter().map(|one| one.path).collect()
}

#[test]
fn faults_of_all_stages_are_told_together() {
    let found = places(
        r#"hold.nodes = ["knot 99"]
load.wind = { force = [1, 0, 0], nodes = ["knot 98"] }
drive.pull = { nodes = ["knot 97"], path = [{ time = 1, by = [0, 0, 1] }] }
covers = [{ opens = "1 ms", nodes = ["knot 96"] }]
break_ties = [{ nodes = ["knot 95"], breaking_load = 1 }]
stow.scale.factor = 0.5
"#,
    );
    let expected =
        ["hold.nodes[0]", "load.wind.nodes[0]", "drive.pull.nodes[0]", "covers[0].nodes[0]", "break_ties[0].nodes[0]"];
    assert_eq!(found, expected);
}

#[test]
fn a_wrong_wind_and_a_wrong_solidity_are_told_with_what_lies_below_the_ground() {
    let found = places(
        r#"environment.air.solidity = "web"
environment.wind = { speed = 5, logarithmic = { roughness = "20 m" } }
environment.ground.height = "1 m"
"#,
    );
    assert!(found.contains(&"environment.wind.logarithmic.roughness".to_owned()), "{found:?}");
    assert!(found.contains(&"environment.ground.height".to_owned()), "{found:?}");
}

/// What a stage cannot do without is not told again by that stage.
#[test]
fn a_fault_brings_no_others_with_it() {
    let more = "points.here = \"knot 99\"\nload.wind = { force = [1, 0, 0], points = [\"here\"] }\n";
    assert_eq!(places(more), ["points.here"]);
}

//! All mistakes in a scenario are reported at once, whichever stages find them.

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

/// The paths of all mistakes.
fn places(more: &str) -> Vec<String> {
    let document = parse(&format!("{NET}{more}"), &[]).unwrap_or_else(|wrong| panic!("{wrong}"));
    let Err(Diagnostics(found)) = Model::new(&document) else { panic!("nothing is wrong") };
    found.into_iter().map(|one| one.path).collect()
}

#[test]
fn mistakes_of_all_stages_are_reported_together() {
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
fn a_wrong_wind_and_a_net_below_the_ground_are_reported_together() {
    let found = places(
        r#"environment.air.solidity = "web"
environment.wind = { speed = 5, logarithmic = { roughness = "20 m" } }
environment.ground.height = "1 m"
"#,
    );
    assert!(found.contains(&"environment.wind.logarithmic.roughness".to_owned()), "{found:?}");
    assert!(found.contains(&"environment.ground.height".to_owned()), "{found:?}");
}

/// A stage does not report again the mistake of a stage that it needs.
#[test]
fn one_mistake_is_reported_once() {
    let more = "points.here = \"knot 99\"\nload.wind = { force = [1, 0, 0], points = [\"here\"] }\n";
    assert_eq!(places(more), ["points.here"]);
}

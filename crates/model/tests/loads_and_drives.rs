//! Loads, drives and the equilibrium: the parts that the model makes of them, and the mistakes that it reports.

use glam::DVec3;
use netcast_model::Model;
use netcast_scenario::{Diagnostics, Document, Source};

const NET: &str = r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "1 GPa" }
hold.corners = true
"#;

/// The model of the net with `more`, and with `csv` as the file `path.csv` beside it.
fn model(more: &str, csv: &str) -> Result<Model, Diagnostics> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("path.csv"), csv).unwrap();
    let source = Source { name: "net.toml".into(), text: format!("{NET}{more}") };
    Model::new(&Document::parse(source, folder.path(), &[])?)
}

/// The mistakes, as lines without the name of the file.
fn wrong(more: &str, csv: &str) -> Vec<String> {
    let Err(Diagnostics(found)) = model(more, csv) else { panic!("nothing is wrong") };
    let help = |help: &Option<String>| help.as_ref().map_or(String::new(), |help| format!(" ({help})"));
    found.iter().map(|one| format!("{}: {}{}", one.path, one.message, help(&one.help))).collect()
}

#[test]
fn a_force_per_length_sums_to_force_times_length_of_rope() {
    let model =
        model("solve.duration = 1\nload.snow = { force_per_length = [0, 0, \"-3 N/m\"], class = \"inner\" }", "");
    let model = model.unwrap();
    let sum: DVec3 = model.system.loads().iter().map(|load| load.force).sum();
    // three ropes of 2 m in either direction
    assert!((sum - DVec3::new(0.0, 0.0, -36.0)).length() < 1e-12, "{sum}");
}

#[test]
fn a_node_that_is_named_twice_is_loaded_once() {
    let load = "load.pull = { force = [\"5 N\", 0, 0], corners = true, nodes = [\"knot 8\"], points = [\"B\"], ramp = \"1 s\" }";
    let model = model(&format!("solve.duration = 1\n{load}\n[points]\nX = \"knot 8\""), "").unwrap();
    let loads = model.system.loads();
    assert!(loads.iter().all(|load| load.force == 5.0 * DVec3::X && load.ramp == 1.0));
    assert_eq!(loads.len(), 6);
}

#[test]
fn a_path_starts_at_the_place_of_the_node_in_the_world_frame() {
    let drive =
        "drive.a = { file = \"path.csv\", points = [\"B\"] }\nstow.scale.factor = 0.5\nlaunch.elevation = \"0 deg\"";
    let model = model(&format!("solve.duration = 1\n{drive}"), "t,x,y,z\n0,0,0,0\n0.5,0,0,1\n").unwrap();
    let [drive] = model.system.drives() else { panic!("one node is driven") };
    let start = model.state.position[drive.node];
    assert_eq!(drive.path, [(0.0, start), (0.5, start + DVec3::Z)]);
    assert!(model.system.held()[drive.node]);
}

#[test]
fn the_drive_of_a_rigid_tractor_moves_its_centre() {
    let tractors = "solve.duration = 1\ntractor.cylinder = { diameter = \"40 mm\", height = \"60 mm\", mass = \"1 kg\" }\n\
                    traction_rope = { length = \"0.5 m\", tied_at = \"rear\" }\n\
                    drive.a = { path = [{ time = 1, by = [0, 0, 1] }], tractors = true }\n";
    let model = model(tractors, "").unwrap();
    let bodies = model.system.bodies();
    assert_eq!((bodies.len(), model.system.drives().len()), (4, 4));
    for (body, drive) in bodies.iter().zip(model.system.drives()) {
        let start = model.state.position[body.centre];
        assert_eq!((drive.node, drive.at(1.0)), (body.centre, start + DVec3::Z));
        assert!(model.system.held()[body.centre] && !model.system.held()[body.ties[0].node]);
    }
    // the model counts the mass of driven bodies, the system does not
    assert!(model.mass > 4.0 && model.system.mass().iter().sum::<f64>() < 1.0);
}

#[test]
fn mistakes_are_reported_at_their_place() {
    let told = |more: &str, csv: &str, expected: &[&str]| assert_eq!(wrong(more, csv), expected, "{more}");
    let run = "solve.duration = 1\n";
    told(
        &format!("{run}load.a = {{ force = [0, 1], nodes = [\"knot 8\"] }}"),
        "",
        &["load.a.force: expected 3 values, found 2"],
    );
    told(
        &format!("{run}load.a = {{ force = [0, 0, \"1 m\"], nodes = [\"knot 8\"] }}"),
        "",
        &["load.a.force[2]: expected a force such as \"12 kN\", found \"1 m\", which is a length"],
    );
    told(
        &format!("{run}load.a.force = [0, 0, 1]"),
        "",
        &[
            "load.a: no nodes are named for it to act on (give one of `load.a.corners`, `load.a.tractors`, `load.a.nodes`, \
           `load.a.points`)",
        ],
    );
    told(
        &format!("{run}load.a = {{ force = [0, 0, 1], nodes = [\"knot 88\"], points = [\"Z\"], tractors = true }}"),
        "",
        &[
            "load.a.nodes[0]: unknown node \"knot 88\" (did you mean \"knot 8\"?)",
            "load.a.points[0]: unknown feature point \"Z\" (did you mean \"B\"?)",
            "load.a.tractors: the web has no tractors",
        ],
    );
    told(
        &format!("{run}load.a = {{ force_per_length = [0, 0, 1], class = \"iner\" }}"),
        "",
        &["load.a.class: no rope is of the link class \"iner\" (did you mean \"inner\"?)"],
    );
    told(
        &format!("{run}load.a = {{ force_per_length = [0, 0, 1], class = \"inner\", corners = true }}"),
        "",
        &["load.a.corners: `force_per_length` acts on the ropes of a class, not on `corners` (give `force` instead)"],
    );
    told(
        &format!("{run}drive.a = {{ file = \"path.csv\", points = [\"B\"] }}"),
        "t,x,y,z\n0,0,0,1\n2,0,0,0\n1,0,0,0\n",
        &[
            "drive.a.file: t: expected no displacement at time 0: a path begins where the node is",
            "drive.a.file: t: expected a time after that of the point before",
        ],
    );
    told(
        &format!(
            "{run}drive.a = {{ path = [{{ time = 1, by = [0, 0, 0] }}], points = [\"B\"] }}\ndrive.b = {{ path = [{{ time = 1, by = [0, 0, 0] }}, {{ time = 1, by = [0, 0, 0] }}], points = [\"B\"] }}"
        ),
        "",
        &[
            "drive.b: knot 13 is moved by another drive already",
            "drive.b.path[1]: expected a time after that of the point before",
        ],
    );
}

#[test]
fn an_equilibrium_needs_support_and_no_time() {
    let held = model("solve.static = {}", "").unwrap();
    assert_eq!(held.scenario.solve.run_time(), None);
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{}solve.static = {{}}", NET.replace("hold.corners = true", ""));
    let document = Document::parse(Source { name: "net.toml".into(), text }, folder.path(), &[]).unwrap();
    let told = Model::new(&document).unwrap_err().to_string();
    assert!(told.contains("there is no equilibrium: nothing holds the part of the web with"), "{told}");

    let told = wrong("solve.static = { then_run = true }", "");
    assert!(told[0].starts_with("solve: missing key `duration`"), "{told:?}");
    assert_eq!(
        wrong("[solve]", "")[0],
        "solve.duration: missing key `duration` (`duration` is a time greater than 0 such as \"0.6 s\")"
    );
    let told = wrong(
        "solve.static = {}\nload.a = { force = [0, 0, 1], points = [\"B\"], ramp = 1 }\ndrive.a = { path = [], points = [\"B\"] }",
        "",
    );
    assert!(
        told[0].starts_with("load.a.ramp: the ramp has no effect")
            && told[1].starts_with("drive.a: the drive has no effect")
    );
}

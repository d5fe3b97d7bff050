//! The three kinds of canopy in a scenario: masses and inertia against closed forms, packing, and the mistakes that are
//! reported.

use std::fs;
use std::path::Path;

use glam::DVec3;
use netcast_model::{Model, node_id};
use netcast_scenario::{Diagnostics, Document, Source};

const SIDE: f64 = 0.14;
/// Mass of a canopy, kg: 3 sqrt(3)/2 side^2, 10 mm thick, 2000 kg/m^3.
const CLOTH: f64 = 2.598_076_211_353_316 * SIDE * SIDE * 0.01 * 2000.0;
/// Mass of half a segment of rope, kg: 10 mm thick, 1850 kg/m^3, six segments to a link.
const HALF_SEGMENT: f64 = 0.5 * 1850.0 * 0.25 * std::f64::consts::PI * 1e-4 * LINK / 6.0;
/// Length of a link between two canopies, m: 2.5 m / 3 - sqrt(3) side.
const LINK: f64 = 2.5 / 3.0 - 1.732_050_807_568_877_2 * SIDE;

const REST: &str = r#"
[web.space]
side = "2.5 m"
[rope]
diameter = "10 mm"
density = "1850 kg/m^3"
elastic_modulus = "78 GPa"
[solve]
duration = "1 ms"
segment_length = "0.1 m"
"#;

fn parse_in(folder: &Path, with: &str) -> Result<Document, Diagnostics> {
    Document::parse(Source { name: "net.toml".into(), text: format!("{with}{REST}") }, folder, &[])
}

fn model(with: &str) -> Model {
    let document = parse_in(Path::new(""), with).unwrap_or_else(|errors| panic!("{errors}"));
    Model::new(&document).unwrap_or_else(|errors| panic!("{errors}"))
}

#[track_caller]
fn wrong(with: &str) -> Vec<String> {
    let made = parse_in(Path::new(""), with).and_then(|document| Model::new(&document));
    let Err(Diagnostics(found)) = made else { panic!("{with} is right") };
    found.iter().map(ToString::to_string).collect()
}

#[track_caller]
fn assert_near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12 * expected.abs(), "{found} instead of {expected}");
}

const KINDS: [&str; 5] = [
    "canopy.links = {}\n",
    "canopy.rigid = {}\n",
    "canopy.membrane = {}\n",
    "canopy.membrane = { wrinkles = true, bending = \"none\", fineness = 3 }\n",
    "canopy.membrane = { fineness = 5, tie_radius = \"30 mm\" }\n",
];
const PAYLOAD: &str = "payload.cylinder = {}\nsensor.cylinder.mass = \"0.2 kg\"\n";

#[test]
fn the_mass_of_the_system_is_that_of_the_bill_for_every_kind_of_canopy() {
    let total = |model: &Model| model.system.mass().iter().sum::<f64>();
    let expected = total(&model(&format!("{}{PAYLOAD}", KINDS[0])));
    for kind in KINDS {
        let model = model(&format!("{kind}{PAYLOAD}"));
        assert_near(total(&model), expected);
        assert_near(model.bill.canopy_mass, 31.0 * CLOTH);
        // the sensor is on no bill
        assert_near(total(&model), model.bill.total_mass() + 0.2);
    }
}

#[test]
fn a_rigid_canopy_has_the_inertia_of_its_plate_payload_and_rope_ends() {
    let model = model("canopy.rigid = {}\npayload.cylinder = { diameter = 0.06, height = 0.066, mass = 0.5 }\n");
    assert_eq!(model.system.bodies().len(), 31);
    // canopy 20 is one of the inner ones: twelve ropes, two at each corner
    let bound = &model.system.bodies()[19];
    let mass = CLOTH + 0.5 + 12.0 * HALF_SEGMENT;
    assert_near(model.system.mass()[bound.centre], mass);
    let corners = 12.0 * HALF_SEGMENT * SIDE * SIDE;
    let across = CLOTH * (5.0 / 24.0 * SIDE * SIDE + 1e-4 / 12.0) + 0.5 * (0.03 * 0.03 / 4.0 + 0.066 * 0.066 / 12.0);
    let polar = CLOTH * 5.0 / 12.0 * SIDE * SIDE + 0.5 * 0.5 * 0.03 * 0.03;
    assert_near(bound.inertia.x, across + 0.5 * corners);
    assert_near(bound.inertia.y, across + 0.5 * corners);
    assert_near(bound.inertia.z, polar + corners);
    // its centre lies on its hub, where results expect it; the nodes that it carries are massless
    let hub = model.cut.web.canopies[19].hub;
    assert!(model.state.position[bound.centre].distance(model.state.position[hub]) < 1e-15);
    assert!(bound.ties.len() == 7 && bound.ties.iter().all(|tie| model.system.mass()[tie.node] == 0.0));
    // canopy 1, on the outline, has ropes on one side only
    let edge = &model.system.bodies()[0];
    let off = model.state.position[edge.centre].distance(model.state.position[model.cut.web.canopies[0].hub]);
    assert!(off > 1e-3 && off < 0.01, "{off}");
}

#[test]
fn a_sheet_of_two_triangles_a_side_shares_its_mass_by_triangles() {
    let model = model("canopy.membrane = {}\n");
    assert_eq!(model.system.membranes().len(), 31 * 24);
    assert_eq!(model.system.parts().hinges.len(), 31 * 30);
    assert!(model.system.bodies().is_empty());
    let sheet = &model.sheets[30];
    let share = CLOTH / 24.0 / 3.0;
    let mass = |node: usize| model.system.mass()[sheet.nodes[node]];
    // the middle and the six nodes about it meet six triangles, a node of a side three, a corner two and two ropes
    for node in 0..7 {
        assert_near(mass(node), 6.0 * share);
    }
    for corner in 0..6 {
        assert_near(mass(7 + 2 * corner), 2.0 * share + 2.0 * HALF_SEGMENT);
        assert_near(mass(8 + 2 * corner), 3.0 * share);
    }
    assert_eq!(model.node_label(sheet.nodes[8]), "node 8 of canopy 31");
}

#[test]
fn patches_are_rigid_bodies_without_elements_inside() {
    let model = model("canopy.membrane = { fineness = 5, tie_radius = \"28 mm\" }\npayload.cylinder = {}\n");
    // six ties on each of 31 canopies, and 18 payloads on the seven nodes under them
    assert_eq!(model.system.bodies().len(), 31 * 6 + 18);
    let count = |nodes: usize| model.system.bodies().iter().filter(|body| body.ties.len() == nodes).count();
    assert_eq!((count(4), count(7)), (31 * 6, 18));
    // two triangles in a tie, six under a payload
    assert_eq!(model.system.membranes().len(), 31 * 6 * 25 - 31 * 6 * 2 - 18 * 6);
    // the hinges between those: one in a tie, six under a payload
    assert_eq!(model.system.parts().hinges.len(), 31 * 15 * 14 - 31 * 6 - 18 * 6);
}

/// Asserts that nothing is stretched and that each body is oriented so that its ties lie at their packed nodes.
#[track_caller]
fn assert_well_packed(model: &Model, of: &str) {
    assert!(model.audit.is_slack(), "{of}");
    assert!(model.audit.stored_energy < 1e-9, "{of}{}", model.audit.stored_energy);
    for (body, rotation) in model.system.bodies().iter().zip(&model.state.rotation) {
        for tie in &body.ties {
            let placed = model.state.position[body.centre] + rotation.orientation * tie.arm;
            assert!(placed.distance(model.state.position[tie.node]) < 1e-12, "{of}");
        }
    }
}

#[test]
fn every_kind_of_canopy_can_be_folded_and_stiff_ones_keep_their_shape() {
    let folds = ["zigzag]", "zigzag]\nalong = \"lines\"", "star]", "roll]", "layers]"];
    let rooms = ["cylinder = { radius = 0.6, height = 1 }", "box = { width = 1, breadth = 1.1, height = 0.9 }"];
    let disturbed = "[stow.imperfection]\nscatter = \"5 mm\"\ntwist = \"10 deg\"\nseed = 3\n";
    for kind in KINDS {
        for (index, fold) in folds.into_iter().enumerate() {
            for (room, imperfection) in rooms.into_iter().zip(["", disturbed]) {
                let stow = format!("{kind}{PAYLOAD}[stow.{fold}\ncontainer.{room}\n{imperfection}");
                let model = model(&stow);
                assert_well_packed(&model, &stow);
                let keeps_its_shape = !kind.contains("links") && !kind.contains("wrinkles");
                for canopy in model.cut.web.canopies.iter().filter(|_| keeps_its_shape) {
                    let corners = canopy.rim.map(|knot| model.state.position[knot]);
                    for k in 0..6 {
                        assert!((corners[k].distance(corners[(k + 1) % 6]) - SIDE).abs() < 1e-12, "{stow}");
                    }
                }
                let lies_flat = |canopy: &netcast_webs::Canopy| {
                    let z = canopy.rim.map(|knot| model.state.position[knot].z);
                    z.into_iter().fold(f64::MIN, f64::max) - z.into_iter().fold(f64::MAX, f64::min) < 1e-3
                };
                // in upright layers canopies stand upright, except in the middle of rings and star
                let upright = model.cut.web.canopies.iter().filter(|canopy| !lies_flat(canopy)).count();
                assert!(index == 4 || upright >= 25, "{upright} in {stow}");
            }
        }
    }
}

#[test]
fn every_kind_of_canopy_can_be_led_into_a_container_and_stiff_ones_keep_their_shape() {
    for kind in KINDS {
        for imperfection in ["", "[stow.imperfection]\nscatter = \"5 mm\"\ntwist = \"10 deg\"\nseed = 3\n"] {
            let stow = format!("{kind}{PAYLOAD}[stow.prescribed]\nradius = 0.5\ndepth = 0.5\n{imperfection}");
            let model = model(&stow);
            assert_well_packed(&model, &stow);
            // a stiff canopy at the ring protrudes from it
            assert!(model.audit.packed_radius < 0.5 + SIDE + 0.02, "{stow}: {}", model.audit.packed_radius);
            let keeps_its_shape = !kind.contains("links");
            for canopy in model.cut.web.canopies.iter().filter(|_| keeps_its_shape) {
                let reach = model.state.position[canopy.rim[2]].distance(model.state.position[canopy.hub]);
                assert!((reach - SIDE).abs() < 1e-12, "{stow}");
            }
        }
    }
}

#[test]
fn a_bag_keeps_stiff_canopies_flat_shrinks_cloth_and_stretches_nothing() {
    for kind in KINDS {
        let bag = "stow.bag = { radius = \"0.24 m\", depth = \"0.38 m\" }\n";
        let disturbed = format!("{bag}stow.imperfection = {{ scatter = \"5 mm\", twist = \"10 deg\" }}\n");
        for stow in ["stow.scale.factor = 0.2\n", bag, &disturbed] {
            let model = model(&format!("{kind}{stow}"));
            assert_well_packed(&model, &format!("{kind}{stow}"));
            let keeps_its_shape = !kind.contains("links") && !kind.contains("wrinkles");
            for canopy in &model.cut.web.canopies {
                let reach = model.state.position[canopy.rim[2]].distance(model.state.position[canopy.hub]);
                assert_eq!((reach - SIDE).abs() < 1e-12, keeps_its_shape, "{kind}{stow}");
            }
        }
    }
}

#[test]
fn a_bag_too_deep_for_plates_is_refused() {
    let deep = "stow.bag = { radius = \"0.2 m\", depth = \"2.4 m\" }\n";
    assert!(model(&format!("canopy.links = {{}}\n{deep}")).audit.is_slack());
    let found = wrong(&format!("canopy.rigid = {{}}\n{deep}"));
    assert!(found[0].contains("stow.bag: the stowed web is stretched"), "{found:?}");
}

/// The bag is a cone that keeps lengths along its sides: the middle triangles become slender and longer.
#[test]
fn a_bag_that_stretches_cloth_is_refused() {
    let found = wrong(
        "canopy.membrane = { wrinkles = true, bending = \"none\" }\nstow.bag = { radius = \"1.5 m\", depth = \"1.99 m\" }\n",
    );
    assert!(found[0].contains("stow.bag: the stowed web is stretched: the cloth at"), "{found:?}");
}

#[test]
fn a_stow_file_gives_a_plate_its_orientation() {
    let folder = tempfile::tempdir().unwrap();
    let flat = model(KINDS[1]);
    // the whole web stands on its edge
    let up = |x: DVec3| DVec3::new(x.x, -x.z, x.y);
    let write = |bend: f64| {
        let mut text = "id,x,y,z\n".to_owned();
        for knot in 0..flat.cut.web.knots.len() {
            let x = up(flat.cut.nodes[knot]);
            let id = node_id(&flat.cut, knot);
            let z = x.z + if id == "corner 2 of canopy 9" { bend } else { 0.0 };
            text += &format!("{id},{},{},{z}\n", x.x, x.y);
        }
        fs::write(folder.path().join("stowed.csv"), text).unwrap();
    };
    let read = |kind: &str| parse_in(folder.path(), &format!("{kind}stow.file.path = \"stowed.csv\"\n"));
    write(0.0);
    for kind in KINDS {
        let model = Model::new(&read(kind).unwrap()).unwrap_or_else(|errors| panic!("{kind}{errors}"));
        assert_eq!(model.state.position.len(), model.cut.nodes.len());
        for (node, x) in model.cut.nodes.iter().enumerate() {
            assert!(model.state.position[node].distance(up(*x)) < 1e-9, "{kind}{}", model.node_label(node));
        }
    }
    write(-1e-3);
    let Err(Diagnostics(found)) = Model::new(&read(KINDS[1]).unwrap()) else { panic!("a plate was bent") };
    assert!(found[0].to_string().contains("stow.file.path: canopy 9 keeps its shape"), "{}", found[0]);
}

#[test]
fn mistakes_are_reported_at_their_place() {
    for (with, expected) in [
        ("canopy.membrane.fineness = 101\n", "net.toml:1:28: canopy.membrane.fineness: "),
        ("canopy.membrane.poisson_ratio = 1\n", "net.toml:1:33: canopy.membrane.poisson_ratio: "),
        (
            "canopy.membrane = { poisson_ratio = 0.9, elastic_modulus_across = \"900 GPa\" }\n",
            "net.toml:1:37: canopy.membrane.poisson_ratio: an element has a Poisson ratio of 0.9",
        ),
        (
            "canopy.membrane = { damping_time = 0, damping_ratio = 0 }\n",
            "canopy.membrane.damping_ratio: expected only one of",
        ),
        (
            "canopy.membrane.tie_radius = \"7 cm\"\n",
            "net.toml:1:30: canopy.membrane.tie_radius: the nodes bound within",
        ),
        ("canopy.membrane.bending = \"beam\"\n", "canopy.membrane.bending"),
        ("canopy.rigid.elastic_modulus = 1\n", "canopy.rigid.elastic_modulus: unknown key"),
        (
            "canopy.rigid = {}\nhold.nodes = [\"corner 1 of canopy 3\"]\n",
            "hold.nodes[0]: \"corner 1 of canopy 3\" is a part of a rigid body",
        ),
    ] {
        let found = wrong(with);
        assert!(found.len() == 1 && found[0].contains(expected), "{with}{found:#?}");
    }
}

#[test]
fn a_membrane_can_be_a_cloth_of_the_library() {
    let model = model("canopy.membrane = { material = \"aramid cloth\", thickness = \"0.1 mm\", wrinkles = true }\n");
    assert!(model.bill.canopy_mass < 31.0 * CLOTH / 100.0);
}

#[test]
fn a_rope_bends_between_its_knots_only() {
    let stiff = |bending: &str| {
        let rope = "diameter = 0.01, density = 1850, elastic_modulus = 78e9";
        format!("ropes.stiff = {{ {rope}, bending_stiffness = {bending} }}\nassign.radial = \"stiff\"\n")
    };
    let bent = model(&stiff("\"0.02 N m^2\""));
    let radial = bent.cut.web.ropes.iter().zip(&bent.cut.ropes).filter(|(rope, _)| rope.class.name() == "radial");
    let inside: usize = radial.map(|(_, cut)| cut.segments - 1).sum();
    assert!(inside > 0);
    assert_eq!(bent.system.parts().bends.len(), inside);
    let found = wrong(&stiff("\"1 N m\""));
    assert!(
        found[0].contains("ropes.stiff.bending_stiffness: expected a bending stiffness greater than 0"),
        "{found:?}"
    );
}

//! Webs that a scenario describes by their sizes: the drawn webs, and the mistakes that are reported.

use std::path::Path;

use netcast_model::Model;
use netcast_scenario::{Diagnostics, Document, Source, resolved_toml};
use netcast_webs::{Class, Web};

const REST: &str = "
[rope]
diameter = \"3 mm\"
density = 1140
elastic_modulus = \"5 GPa\"
[solve]
duration = 0.1
segment_length = 0.2
";

fn parse(web: &str, overrides: &[String]) -> Result<Document, Diagnostics> {
    let source = Source { name: "net.toml".into(), text: format!("{web}{REST}") };
    Document::parse(source, Path::new(""), overrides)
}

fn document(web: &str) -> Document {
    parse(web, &[]).unwrap_or_else(|errors| panic!("{errors}"))
}

fn model(web: &str) -> Model {
    Model::new(&document(web)).unwrap_or_else(|errors| panic!("{errors}"))
}

fn drawn(web: &str) -> Web {
    model(web).cut.web
}

/// All mistakes in a web that reading or drawing it reports.
fn wrong(web: &str) -> Vec<String> {
    let Err(Diagnostics(found)) = parse(web, &[]).and_then(|document| Model::new(&document)) else {
        panic!("{web} is right")
    };
    found.iter().map(ToString::to_string).collect()
}

/// Asserts that there is one mistake, at `place`, whose text has `message`.
#[track_caller]
fn assert_wrong(web: &str, place: &str, message: &str) {
    let found = wrong(web);
    assert_eq!(found.len(), 1, "{found:#?}");
    assert!(found[0].starts_with(place) && found[0].contains(message), "{}", found[0]);
}

#[test]
fn a_polygon_has_the_given_side_or_diameter() {
    let by_side = drawn("web.polygon = { sides = 6, side = \"2.5 m\", mesh = \"0.5 m\" }");
    let by_diameter = drawn("web.polygon = { sides = 6, diameter = \"5 m\", mesh = \"0.5 m\" }");
    for web in [by_side, by_diameter] {
        assert_eq!(web.corners.len(), 6);
        assert!((web.radius() - 2.5).abs() < 1e-12);
        assert!((web.rope_length_by_class()[&Class::Outline] - 15.0).abs() < 1e-12);
    }
}

#[test]
fn a_note_tells_the_sizes_that_follow_from_a_mesh() {
    let told = model("web.polygon = { sides = 6, side = 2.5, mesh = 0.5 }").notes;
    assert!(told.iter().any(|note| note.contains("parallels are 0.5413 m apart")), "{told:?}");
    // its apothem is 2 m
    let exact = model("web.polygon = { sides = 4, side = 4, mesh = 0.5 }").notes;
    assert!(!exact.iter().any(|note| note.contains("apart")), "{exact:?}");
    let told = model("web.diamond = { mesh = 0.25, meshes_wide = 10, meshes_high = 5, hanging_ratio = 0.6 }").notes;
    assert!(told.iter().any(|note| note.contains("3.0000 m wide and 2.0000 m high")), "{told:?}");
}

#[test]
fn a_radial_web_has_a_corner_at_every_radial_by_default() {
    let web = |more: &str| format!("web.radial = {{ diameter = 5, radials = 12, rings = 4{more} }}");
    assert_eq!(drawn(&web("")).corners.len(), 12);
    assert_eq!(drawn(&web(", corners = 4")).corners.len(), 4);
    assert_eq!(drawn(&web(", hub_diameter = \"40 cm\"")).centre.len(), 12);
    assert!(resolved_toml(&document(&web("")).scenario).contains("corners = 12"));
}

#[test]
fn an_angle_and_its_hanging_ratio_draw_the_same_meshes() {
    let web = |shape: &str| drawn(&format!("web.diamond = {{ mesh = 0.5, meshes_wide = 8, meshes_high = 6{shape} }}"));
    let close = |one: &Web, other: &Web| {
        one.knots.iter().zip(&other.knots).all(|(one, other)| one.position.distance(other.position) < 1e-12)
    };
    assert!(close(&web(", angle = \"60 deg\""), &web(", hanging_ratio = 0.5")));
    assert!(close(&web(""), &web(", angle = \"90 deg\"")));
    let resolved = resolved_toml(&document("web.diamond = { mesh = 1, meshes_wide = 2, meshes_high = 2 }").scenario);
    assert!(resolved.contains("angle = \"1.5707963267948966 rad\""), "{resolved}");
}

#[test]
fn a_gathering_rope_is_a_link_class_that_a_rope_can_be_assigned_to() {
    let net = "web.square = { side = 5, mesh = 0.5, gathering = { every = 2, excess = \"10 %\" } }
ropes.cord = { diameter = \"6 mm\", density = 1140, elastic_modulus = 5e9 }
assign.gathering = \"cord\"";
    let model = model(net);
    assert!((model.bill.length_by_class[&Class::Gathering] - 22.0).abs() < 1e-12);
    let cord = model.bill.ropes.iter().find(|line| line.name == "cord").unwrap();
    assert!((cord.length - 22.0).abs() < 1e-12);
    assert_eq!(model.cells.len(), 100);
}

/// A whole mesh is not a stub, however coarse the segments are.
#[test]
fn coarse_segments_remove_no_knot() {
    for web in [
        "web.radial = { diameter = 5, radials = 3, rings = 40 }",
        "web.polygon = { sides = 3, side = 2, mesh = 0.05 }",
        "web.diamond = { mesh = 0.05, meshes_wide = 9, meshes_high = 9, angle = \"5 deg\" }",
    ] {
        let coarse = parse(web, &["solve.segment_length=2".to_owned()]).unwrap();
        assert_eq!(Model::new(&coarse).unwrap().cut.web, drawn(web));
    }
}

#[test]
fn wrong_sizes_are_reported_at_their_place_with_the_expected_range() {
    let polygon = |sizes: &str| format!("[web.polygon]\n{sizes}");
    assert_wrong(
        &polygon("sides = 2\nside = 1\nmesh = 0.1"),
        "net.toml:2:9: web.polygon.sides",
        "at least 3 and at most 24, found the number 2",
    );
    assert_wrong(&polygon("sides = 6\nside = 1\nmesh = 0.9"), "net.toml:4:8: web.polygon.mesh", "0.866025 m");
    assert_wrong(&polygon("sides = 6\nmesh = 0.9"), "net.toml:1:6: web.polygon", "missing key `side` or `diameter`");
    let twice = polygon("sides = 6\nside = 1\ndiameter = 2\nmesh = 0.1");
    assert_wrong(&twice, "net.toml:4:1: web.polygon.diameter", "expected only one of `side` and `diameter`");

    let radial = |more: &str| format!("[web.radial]\ndiameter = 5\nradials = 12\nrings = 4\n{more}");
    assert_wrong(&radial("corners = 5"), "net.toml:5:11: web.radial.corners", "3, 4, 6, 12 would");
    assert_wrong(&radial("corners = 13"), "net.toml:5:11: web.radial.corners", "from 3 to 12, not 13");
    assert_wrong(&radial("hub_diameter = 5"), "net.toml:5:16: web.radial.hub_diameter", "no room for radials");
    let few = radial("").replace("radials = 12", "radials = 2");
    assert_wrong(&few, "net.toml:3:11: web.radial.radials", "from 3 to 360, not 2");
    let many = radial("").replace("rings = 4", "rings = 4000");
    assert_wrong(&many, "net.toml:4:9: web.radial.rings", "from 1 to 1000, not 4000");

    let diamond = |more: &str| format!("[web.diamond]\nmesh = 0.1\nmeshes_wide = 8\nmeshes_high = 8\n{more}");
    for angle in ["0 deg", "-10 deg", "180 deg", "300 deg"] {
        let expected = "expected an angle greater than 0 deg and less than 180 deg";
        assert_wrong(&diamond(&format!("angle = \"{angle}\"")), "net.toml:5:9: web.diamond.angle", expected);
    }
    assert_wrong(&diamond("hanging_ratio = 1"), "net.toml:5:17: web.diamond.hanging_ratio", "less than 1");
    assert_wrong(
        &diamond("angle = 1\nhanging_ratio = 0.5"),
        "net.toml:6:1:",
        "only one of `angle` and `hanging_ratio`",
    );
    let wide = diamond("").replace("wide = 8", "wide = 2000");
    assert_wrong(&wide, "net.toml:3:15: web.diamond.meshes_wide", "from 1 to 1000, not 2000");

    let square = |every: &str| format!("[web.square]\nside = 5\nmesh = 0.5\n[web.square.gathering]\nevery = {every}");
    assert_wrong(&square("3"), "net.toml:5:9: web.square.gathering.every", "3 does not divide the 10 meshes of a side");
    assert_wrong(&square("0"), "net.toml:5:9: web.square.gathering.every", "of at least 1");
    assert_wrong(&square("2\nexcess = -0.1"), "net.toml:6:10: web.square.gathering.excess", "of at least 0");
}

#[test]
fn only_a_space_web_has_canopies() {
    for web in ["polygon = { sides = 3, side = 2, mesh = 0.5 }", "radial = { diameter = 2, radials = 6, rings = 2 }"] {
        let found = wrong(&format!("web.{web}\ncanopy.links = {{}}"));
        assert!(found[0].contains("only a space web has a canopy"), "{found:?}");
    }
}

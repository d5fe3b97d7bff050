//! Webs folded or led into containers: every pattern, imperfections, and the mistakes that are reported.

mod common;

use common::parse;
use glam::DVec3;
use netcast_model::Model;

const NET: &str = "
[web.square]
side = \"2 m\"
mesh = \"0.5 m\"
[rope]
diameter = \"3 mm\"
density = 970
elastic_modulus = \"5 GPa\"
[ropes.thick]
diameter = \"8 mm\"
density = 970
elastic_modulus = \"5 GPa\"
[traction_rope]
length = \"0.6 m\"
[tractor.particle]
mass = \"0.5 kg\"
[solve]
duration = \"0.1 s\"
segment_length = \"0.25 m\"
";

fn model(stow: &str) -> Result<Model, String> {
    let document = parse(&format!("{NET}{stow}"), &[]).map_err(|wrong| wrong.to_string())?;
    Model::new(&document).map_err(|wrong| wrong.to_string())
}

fn told(stow: &str) -> String {
    model(stow).map(|_| ()).expect_err(stow)
}

#[test]
fn every_pattern_packs_a_net_without_stretch_into_its_container() {
    let tube = "container.cylinder = { radius = \"0.25 m\", height = \"0.5 m\" }";
    let box_ = "container.box = { width = \"0.5 m\", breadth = \"0.4 m\", height = \"0.5 m\" }";
    for pattern in ["zigzag", "star", "roll", "layers"] {
        for container in [tube, box_] {
            for rest in ["", "\nspacing = \"5 mm\"\n[stow.imperfection]\nscatter = \"3 mm\"\ntwist = \"15 deg\""] {
                let stow = format!("[stow.{pattern}]\n{container}{rest}");
                let model = model(&stow).unwrap_or_else(|wrong| panic!("{stow}: {wrong}"));
                assert!(model.audit.is_slack(), "{stow}");
                let packing = model.packing();
                assert!(packing.density.unwrap() > 0.0 && packing.solid_fraction.unwrap() < 1.0, "{stow}");
                assert!(packing.closeness.unwrap().closest.is_some(), "{stow}");
            }
        }
    }
}

#[test]
fn layers_lie_a_rope_apart_and_traction_ropes_do_not_count() {
    let spacing = |rest: &str| {
        let text = format!("{NET}[stow.layers.container.cylinder]\nradius = 1\nheight = 1\n{rest}");
        let document = parse(&text, &[]).unwrap();
        let netcast_scenario::Stow::Layers(layers) = document.scenario.stow.unwrap().pattern else { panic!() };
        layers.spacing.unwrap().si()
    };
    assert_eq!(spacing(""), 0.003);
    assert_eq!(spacing("[assign]\ntraction = \"thick\""), 0.003);
    assert_eq!(spacing("[assign]\noutline = \"thick\""), 0.008);
}

#[test]
fn an_impossible_packing_is_reported_at_its_place() {
    let tube = |radius: &str, rest: &str| {
        format!("[stow.roll]\ncontainer.cylinder = {{ radius = \"{radius}\", height = \"0.2 m\" }}\n{rest}")
    };
    let found = told(&tube("20 mm", ""));
    assert!(found.contains("stow.roll.container: the web does not fit a cylinder of radius 0.02 m"), "{found}");
    assert!(found.contains("these proportions that holds it is a cylinder of radius 0."), "{found}");
    let found = told(&tube("0.2 m", "tractor_gap = \"2 m\""));
    assert!(found.contains("stow.roll.tractor_gap: tractors 2 m above the web would stretch"), "{found}");
    let found = told(&tube("0.2 m", "tractor_radius = \"2 m\""));
    assert!(found.contains("stow.roll.tractor_radius: tractor 1 would stand"), "{found}");
    let found = told("[stow.roll]\nspacing = \"5 mm\"");
    assert!(found.contains("stow.roll.container: missing key `container`"), "{found}");
    assert!(found.contains("[stow.roll.container.cylinder], [stow.roll.container.box]"), "{found}");
    let found = told(&format!("{}[stow.imperfection]\nscater = \"5 mm\"", tube("0.2 m", "")));
    assert!(found.contains("stow.imperfection.scater: unknown key `scater`"), "{found}");
    assert!(found.contains("did you mean `scatter`?"), "{found}");
    let found = told("[stow.imperfection]\nscatter = \"5 mm\"");
    assert!(found.contains("stow: expected one of [stow.scale], ") && found.contains("found none"), "{found}");
    let found = told("[stow.zigzg]\nfactor = 1");
    assert!(found.contains("did you mean `zigzag`?"), "{found}");
}

#[test]
fn a_seed_repeats_its_packing_and_another_seed_changes_it() {
    let at = |seed: u32| {
        let stow = format!("[stow.bag]\nradius = \"0.2 m\"\n[stow.imperfection]\nscatter = \"5 mm\"\nseed = {seed}");
        model(&stow).unwrap().state.position
    };
    assert_eq!(at(3), at(3));
    assert_ne!(at(3), at(4));
}

#[test]
fn a_late_sector_is_held_as_stowed_but_its_tractors_are_not() {
    let late = |rest: &str| {
        model(&format!(
            "[stow.bag]\nradius = \"0.2 m\"\n[launch]\naxial_speed = \"20 m/s\"\n[stow.imperfection]\n\
             late_sector = {{ width = \"90 deg\", until = \"4 ms\"{rest} }}\n"
        ))
        .unwrap()
    };
    let about_x = late(", direction = 0");
    let launchers = about_x.system.launchers();
    let on_a_traction_rope = |node: usize| !about_x.cut.is_web()[node];
    let is_in = |node: usize| {
        let place = about_x.cut.nodes[node] - about_x.cut.web.middle;
        place.x >= place.y.abs() - 1e-6 && !on_a_traction_rope(node)
    };
    let expected: Vec<usize> = (0..about_x.cut.nodes.len()).filter(|&node| is_in(node)).collect();
    assert_eq!(launchers.iter().map(|launcher| launcher.node).collect::<Vec<_>>(), expected);
    assert!(launchers.iter().all(|launcher| launcher.at == 4e-3));
    assert!(about_x.notes.iter().any(|note| note.contains("a sector 90 deg wide about 0 deg")), "{:?}", about_x.notes);
    assert!(about_x.tractors.iter().all(|&tractor| about_x.state.velocity[tractor].length() > 19.0));
    // without a direction the seed chooses the sector
    let held = |seed: u32| {
        let text = format!(
            "[stow.bag]\nradius = \"0.2 m\"\n[stow.imperfection]\nseed = {seed}\nlate_sector = {{ width = 1, until = 1 }}"
        );
        model(&text).unwrap().system.launchers().to_vec()
    };
    assert_eq!(held(3), held(3));
    assert_ne!(held(3), held(4));
}

#[test]
fn an_impossible_late_sector_is_reported() {
    let late = |rest: &str| told(&format!("[stow.bag]\nradius = 0.2\n[stow.imperfection]\nlate_sector = {rest}\n"));
    let found = late("{ width = \"400 deg\", until = 1 }");
    assert!(found.contains("late_sector.width: expected an angle greater than 0 deg and at most 360 deg"), "{found}");
    let found = late("{ width = 1 }");
    assert!(found.contains("late_sector.until: missing key `until`"), "{found}");
    let found = late("{ width = 1, until = 1 }\n[launch]\nspin = \"3 rad/s\"");
    assert!(found.contains("stow.imperfection.late_sector: a spinning web is launched at once"), "{found}");
}

#[test]
fn a_web_is_led_into_its_container_and_rests_there() {
    let led = model("[stow.prescribed]\nradius = \"0.3 m\"\ndepth = \"0.4 m\"\n").unwrap();
    assert!(led.audit.is_slack() && led.audit.stored_energy < 1e-12);
    assert!(led.audit.packed_radius < 0.301, "{}", led.audit.packed_radius);
    assert!(led.state.velocity.iter().all(|v| v.length() == 0.0));
    assert!(led.notes.iter().any(|note| note.starts_with("the web came to rest in its container")), "{:?}", led.notes);
}

/// The net without traction ropes, led by the drives in `keys`.
fn led_by_hand(keys: &str) -> Result<Model, String> {
    let text = format!("{NET}[stow.prescribed]\n{keys}");
    let document = parse(&text, &["traction_rope.length=0"]).map_err(|wrong| wrong.to_string())?;
    Model::new(&document).map_err(|wrong| wrong.to_string())
}

#[test]
fn led_nodes_end_at_the_ends_of_their_paths() {
    let led = led_by_hand(
        "radius = \"0.9 m\"\n\
         drive.left = { nodes = [\"web corner 3\"], path = [{ time = \"1 s\", by = [\"0.7 m\", \"0.7 m\", 0] }] }\n\
         drive.right = { nodes = [\"web corner 1\"], path = [{ time = \"1 s\", by = [\"-0.7 m\", \"-0.7 m\", 0] }] }\n",
    )
    .unwrap();
    let knot = |number: usize| led.state.position[number - 1];
    // the led corners come 0.3 m near to the middle along x and y; the other corners fall
    assert!((knot(1) - knot(25)).distance(DVec3::new(-0.6, -0.6, 0.0)) < 1e-9, "{} {}", knot(1), knot(25));
    assert!(knot(5).z < knot(1).z - 0.5 && knot(21).z < knot(1).z - 0.5);
}

/// D lies in the middle of a rope. The packing cuts that rope into longer pieces than the web's segments.
#[test]
fn a_point_inside_a_rope_can_be_led() {
    let text = "web.space.side = \"2.5 m\"\nrope = { diameter = \"3 mm\", density = 970, elastic_modulus = \"5 GPa\" }\n\
                solve = { duration = 1, segment_length = \"10 mm\" }\n[stow.prescribed]\nradius = \"2.4 m\"\ngravity = 0\n\
                drive.up = { points = [\"D\"], path = [{ time = \"0.5 s\", by = [\"0.1 m\", 0, \"0.3 m\"] }] }\n";
    let led = Model::new(&parse(text, &[]).unwrap()).unwrap_or_else(|wrong| panic!("{wrong}"));
    let (_, point) = led.points().into_iter().find(|(name, _)| name == "D").unwrap();
    let flat = led.cut.nodes[point] - led.cut.web.middle;
    // the top of the packed web lies at the muzzle
    assert!(led.state.position[point].distance(DVec3::new(flat.x + 0.1, flat.y, 0.0)) < 1e-12);
}

#[test]
fn impossible_paths_are_reported() {
    let found = |keys: &str| told(&format!("[stow.prescribed]\n{keys}\n"));
    let drive = |keys: &str| found(&format!("radius = \"0.9 m\"\ndrive.it = {{ {keys} }}"));
    let by = "path = [{ time = 1, by = [\"-0.1 m\", \"-0.1 m\", 0] }]";
    let apart = format!(
        "radius = \"1.3 m\"\ndrive.it = {{ nodes = [\"web corner 3\"], {by} }}\n\
         drive.other = {{ nodes = [\"web corner 2\", \"web corner 4\"], path = [{{ time = 1, by = [0, 0, 0] }}] }}"
    );
    let wrong = led_by_hand(&apart).map(|_| ()).unwrap_err();
    assert!(wrong.contains("stow.prescribed: the stowed web is stretched: segment"), "{wrong}");
    let wrong = drive(&format!("nodes = [\"knot 99\"], {by}"));
    assert!(wrong.contains("stow.prescribed.drive.it.nodes[0]: unknown node \"knot 99\""), "{wrong}");
    let wrong = drive(by);
    assert!(wrong.contains("stow.prescribed.drive.it: no nodes are named for it to act on"), "{wrong}");
    let wrong = drive(&format!("tractors = true, {by}"));
    assert!(wrong.contains("tractor 1 is no part of the web itself"), "{wrong}");
    let wrong = drive("corners = true, file = \"none.csv\"");
    assert!(wrong.contains("stow.prescribed.drive.it.file: cannot read none.csv"), "{wrong}");
    for key in ["time", "longest"] {
        let wrong = found(&format!("radius = \"0.3 m\"\n{key} = \"1e9 s\""));
        assert!(
            wrong.contains(&format!("stow.prescribed.{key}: expected a time greater than 0 and at most 1000")),
            "{wrong}"
        );
    }
    let wrong = drive("corners = true, path = [{ time = 1, by = [0, 0, 0] }, { time = 1e9, by = [0, 0, 0] }]");
    assert!(
        wrong.contains("stow.prescribed.drive.it.path[1].time: expected a time") && wrong.contains("1000 s"),
        "{wrong}"
    );
    let wrong = found("radius = \"3 m\"");
    assert!(wrong.contains("stow.prescribed.radius: ") && wrong.contains("at most the web's own"), "{wrong}");
    let wrong = found("radius = \"0.3 m\"\ntractor_gap = \"2 m\"");
    assert!(wrong.contains("stow.prescribed.tractor_gap: tractors 2 m above"), "{wrong}");
}

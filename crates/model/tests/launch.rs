//! `[launch]`, `[traction_rope]`, `[[tractors]]` and `[[covers]]`: the bodies, launchers and velocities of the model.

mod common;

use common::parse;
use glam::DVec3;
use netcast_dynamics::launcher::{Means, Push, Tube};
use netcast_model::Model;
use netcast_scenario::{Diagnostics, resolved_toml};

/// A small net in a bag. Its four tractors have 1 kg, are 40 mm long and wide, and hang on ropes of 0.5 m.
const NET: &str = r#"
[web.square]
side = "2 m"
mesh = "0.5 m"
[rope]
diameter = "3 mm"
density = 1140
elastic_modulus = "5 GPa"
[tractor.cylinder]
diameter = "40 mm"
height = "40 mm"
mass = "1 kg"
[traction_rope]
length = "0.5 m"
[stow.bag]
radius = "0.3 m"
[solve]
duration = "30 ms"
"#;

fn model(added: &str, overrides: &[&str]) -> Result<Model, Diagnostics> {
    Model::new(&parse(&format!("{NET}{added}"), overrides)?)
}

fn modelled(added: &str, overrides: &[&str]) -> Model {
    model(added, overrides).unwrap_or_else(|errors| panic!("{errors}"))
}

fn wrong(added: &str, overrides: &[&str]) -> Vec<String> {
    let Err(Diagnostics(found)) = model(added, overrides) else {
        panic!("nothing is wrong with {added} {overrides:?}")
    };
    found.iter().map(ToString::to_string).collect()
}

const THROWN: &str = "[launch]\naxial_speed = \"30 m/s\"\nradial_speed = \"10 m/s\"\n";

#[test]
fn a_tractor_tied_at_its_centre_stays_a_point_mass() {
    let plain = modelled(THROWN, &[]);
    let said = modelled(THROWN, &["traction_rope.tied_at=\"centre\""]);
    let zero = modelled(THROWN, &["traction_rope.tie_point=[0, 0, 0]"]);
    assert!(plain.system.bodies().is_empty() && said.system.bodies().is_empty() && zero.system.bodies().is_empty());
    assert_eq!((&plain.state, &plain.state), (&said.state, &zero.state));
    assert_eq!((plain.system.mass(), plain.system.mass()), (said.system.mass(), zero.system.mass()));
}

#[test]
fn a_tractor_tied_at_its_rear_is_a_rigid_body_ahead_of_its_knot() {
    let plain = modelled(THROWN, &[]);
    let tied = modelled(THROWN, &["traction_rope.tied_at=\"rear\""]);
    assert_eq!(tied.system.bodies().len(), 4);
    let sum = |model: &Model| model.system.mass().iter().sum::<f64>();
    assert!((sum(&plain) / sum(&tied) - 1.0).abs() < 1e-12);
    // m (3 r^2 + h^2)/12 and m r^2/2, for h = 2 r
    let inertia = DVec3::new(7.0, 7.0, 6.0) / 12.0 * 0.02 * 0.02;
    for (index, body) in tied.system.bodies().iter().enumerate() {
        assert!((body.inertia - inertia).length() < 1e-15, "{}", body.inertia);
        let [tie] = body.ties[..] else { panic!("{:?}", body.ties) };
        let (centre, knot) = (tied.state.position[body.centre], tied.state.position[tie.node]);
        assert_eq!((knot, tie.node), (plain.state.position[tie.node], tied.cut.web.tractors[index]));
        let velocity = tied.state.velocity[body.centre];
        assert_eq!(velocity, plain.state.velocity[tie.node]);
        assert!((centre - knot - 0.02 * velocity.normalize()).length() < 1e-15, "it does not point where it flies");
        assert!((tied.state.rotation[index].orientation * DVec3::Z - velocity.normalize()).length() < 1e-15);
        assert!(tied.system.tractor()[body.centre] && !tied.system.tractor()[tie.node]);
        assert_eq!(tied.ropes_at(&[body.centre]), plain.ropes_at(&[tie.node]));
    }
    assert_eq!(tied.tractors, tied.system.bodies().iter().map(|body| body.centre).collect::<Vec<_>>());
    assert_eq!(tied.node_label(tied.tractors[2]), "the centre of tractor 3");
}

#[test]
fn the_axes_of_a_tie_point_are_the_flight_and_the_outward_direction() {
    let off = ["traction_rope.tie_point=[\"20 mm\", 0, \"-20 mm\"]", "launch.attitude=\"axis\""];
    let model = modelled(THROWN, &off);
    for (body, rotation) in model.system.bodies().iter().zip(&model.state.rotation) {
        assert!((rotation.orientation * DVec3::Z - DVec3::Z).length() < 1e-15);
        let outwards = model.state.position[body.ties[0].node].with_z(0.0).normalize();
        assert!((rotation.orientation * DVec3::X - outwards).length() < 1e-15);
    }
}

#[test]
fn one_tractor_may_differ_in_shape_tie_point_and_delay() {
    let own = r#"
        [[tractors]]
        corner = 2
        sphere = { diameter = "50 mm", density = 7800 }
        tied_at = "front"
        delay = "4 ms"
        [[tractors]]
        corner = 3
        box = { width = "20 mm", depth = "30 mm", height = "60 mm", mass = "2 kg" }
    "#;
    let model = modelled(&format!("{THROWN}{own}"), &[]);
    let masses: Vec<f64> = model.bodies.iter().map(|body| body.solid.mass_kg).collect();
    assert!((masses[1] - 7800.0 * std::f64::consts::PI / 6.0 * 1.25e-4).abs() < 1e-12);
    assert_eq!((masses[0], masses[2], masses[3]), (1.0, 2.0, 1.0));
    let [body] = model.system.bodies() else { panic!() };
    assert_eq!(body.ties[0].arm, DVec3::Z * 0.025);
    let [launcher] = model.system.launchers() else { panic!() };
    assert_eq!((launcher.node, launcher.at), (body.centre, 4e-3));
    assert_eq!(model.state.velocity[body.centre], DVec3::ZERO);
    let Means::Velocity(velocity) = launcher.by else { panic!() };
    assert!((velocity.length() - 1000f64.sqrt()).abs() < 1e-12);
}

#[test]
fn spin_is_a_rigid_rotation_about_the_launch_axis() {
    let overrides = ["launch.spin=600 rpm", "traction_rope.tied_at=\"rear\"", "launch.elevation=40 deg"];
    let (still, model) = (modelled(THROWN, &overrides[1..]), modelled(THROWN, &overrides));
    let turning = 20.0 * std::f64::consts::PI * model.axis();
    for (node, velocity) in model.state.velocity.iter().enumerate() {
        let expected = still.state.velocity[node] + turning.cross(model.state.position[node]);
        assert!((velocity - expected).length() < 1e-12);
    }
    for (body, rotation) in model.system.bodies().iter().zip(&model.state.rotation) {
        assert!((body.angular_velocity(rotation) - turning).length() < 1e-12);
    }
}

const TUBE: &str = "[launch.tube]\nstroke = \"0.2 m\"\ncant = \"30 deg\"\n\
                    force_over_stroke = { at = [0, \"0.2 m\"], force = [\"2 kN\", 0] }\n";

#[test]
fn a_tube_begins_at_its_stowed_tractor_and_is_canted_outwards() {
    let model = modelled(TUBE, &[]);
    for (launcher, throw) in model.system.launchers().iter().zip(model.throws.iter().flatten()) {
        let Means::Tube(Tube { breech, direction, stroke, push }) = &launcher.by else { panic!() };
        assert_eq!((*breech, *stroke), (model.state.position[launcher.node], 0.2));
        let outwards = breech.with_z(0.0).normalize();
        assert!((*direction - 0.5 * outwards - 0.75f64.sqrt() * DVec3::Z).length() < 1e-15);
        assert!((push.work(0.2).unwrap() - 200.0).abs() < 1e-12);
        assert!((throw.angle_to(model.axis()).to_degrees() - 30.0).abs() < 1e-12);
    }
    assert_eq!(model.system.launchers().len(), 4);
}

const SCATTER: &str = "[launch.scatter]\nspeed = \"5 %\"\nangle = \"2 deg\"\ndelay = \"1 ms\"\nseed = 11\n";

#[test]
fn the_resolved_scenario_repeats_the_scatter_and_another_seed_changes_it() {
    let added = format!("{THROWN}{SCATTER}");
    let first = modelled(&added, &[]);
    let again = Model::new(&parse(&resolved_toml(&first.scenario), &[]).unwrap()).unwrap();
    assert_eq!((&first.throws, &first.state), (&again.throws, &again.state));
    assert_eq!(first.system.launchers(), again.system.launchers());
    assert_ne!(first.throws, modelled(&added, &["launch.scatter.seed=12"]).throws);
    let delays: Vec<f64> = first.throws.iter().flatten().map(|throw| throw.delay).collect();
    assert_eq!(delays.iter().copied().fold(f64::INFINITY, f64::min), 0.0);
    assert!(delays.iter().all(|delay| *delay < 8e-3), "{delays:?}");
    // tubes, delays and scatter combine; four times the force gives twice the speed
    let tubes = modelled(&format!("{TUBE}{SCATTER}"), &[]);
    let resolved = parse(&resolved_toml(&tubes.scenario), &[]).unwrap();
    assert_eq!(tubes.throws, Model::new(&resolved).unwrap().throws);
    let work = |launcher: &netcast_dynamics::launcher::Launcher| match &launcher.by {
        Means::Tube(Tube { push: push @ Push::OverStroke(_), .. }) => push.work(0.2).unwrap(),
        other => panic!("{other:?}"),
    };
    let works: Vec<f64> = tubes.system.launchers().iter().map(work).collect();
    let speeds: Vec<f64> =
        first.throws.iter().flatten().map(|throw| first.state.velocity[throw.node].length()).collect();
    // the first tractor to start has its velocity; in its tube it has the same relative deviation
    let at_once = delays.iter().position(|delay| *delay == 0.0).unwrap();
    assert!(((works[at_once] / 200.0).sqrt() / (speeds[at_once] / 1000f64.sqrt()) - 1.0).abs() < 1e-12);
}

#[test]
fn a_cover_holds_the_web_but_not_its_tractors() {
    let model = modelled(&format!("{THROWN}[[covers]]\nopens = \"3 ms\"\n"), &[]);
    let held: Vec<usize> = model.system.launchers().iter().map(|launcher| launcher.node).collect();
    assert!(held.len() > 100 && model.tractors.iter().all(|tractor| !held.contains(tractor)));
    let on_rope = model.cut.ropes[model.cut.web.traction[0][0]].interior();
    assert!(on_rope.clone().count() > 2 && on_rope.into_iter().all(|node| !held.contains(&node)));
    let two = "[[covers]]\nopens = \"3 ms\"\nnodes = [\"knot 3\"]\n[[covers]]\nopens = \"5 ms\"\nnodes = [\"knot 3\", \"knot 4\"]\n";
    let model = modelled(&format!("{THROWN}{two}"), &[]);
    assert_eq!(model.system.launchers().iter().map(|launcher| launcher.at).collect::<Vec<_>>(), [5e-3, 5e-3]);
}

#[test]
fn contradictions_are_reported_at_their_place() {
    for (added, overrides, expected) in [
        (
            THROWN,
            &["launch.tube={stroke=1, force_over_time={at=[0], force=[1]}}"][..],
            "launch.axial_speed: the speed of a",
        ),
        (TUBE, &["launch.spin=3 rad/s"], "launch.tube: a spinning web is launched at once"),
        (THROWN, &["launch.spin=3 rad/s", "covers=[{opens=1}]"], "covers: a spinning web"),
        (THROWN, &["launch.spin=3 rad/s", "tractors=[{corner=1, delay=1}]"], "tractors[0].delay: a spinning web"),
        (THROWN, &["launch.spin=3 1/s"], "launch.spin: expected an angular speed"),
        (
            THROWN,
            &["traction_rope.tied_at=\"rim\""],
            "traction_rope.tied_at: expected \"centre\" or \"rear\" or \"front\"",
        ),
        (THROWN, &["traction_rope.tie_point=[1, 2]"], "traction_rope.tie_point: expected 3 values, found 2"),
        (THROWN, &["traction_rope.tie_point=[1, 2, 3]", "traction_rope.tied_at=\"rear\""], "expected only one of"),
        (
            THROWN,
            &["tractor={particle={mass=1}}", "traction_rope.tied_at=\"rear\""],
            "tractor 1: a particle has a centre",
        ),
        (
            THROWN,
            &["traction_rope={length=0, tied_at=\"rear\"}", "hold.corners=true"],
            "traction_rope.tied_at: tractor 1: the corner that it is tied to is held",
        ),
        (
            THROWN,
            &["tractors=[{corner=1, sphere={diameter=1}, particle={mass=1}}]"],
            "expected only one of `sphere` and",
        ),
        ("[launch.tube]\nstroke = 1\n", &[], "launch.tube.force_over_stroke: missing key `force_over_stroke`"),
        (
            TUBE,
            &["launch.tube.force_over_stroke={at=[0, 1], force=[1]}"],
            "expected one force a point, found 2 points and 1 forces",
        ),
        (
            TUBE,
            &["launch.tube.force_over_stroke={at=[1, 0], force=[1, 1]}"],
            "force_over_stroke.at: expected increasing values",
        ),
        (TUBE, &["launch.tube.force_over_stroke={at=[0], force=[-1]}"], "expected a force of at least 0"),
        (TUBE, &["launch.tube.force_over_stroke={file=\"none.csv\"}"], "cannot read none.csv"),
        (THROWN, &["covers=[{opens=1, nodes=[\"knot 999\"]}]"], "covers[0].nodes[0]: unknown node"),
        (THROWN, &["covers=[{opens=1, nodes=[\"tractor 1\"]}]"], "is a tractor, which is not covered"),
        (THROWN, &["covers=[{opens=0}]"], "covers[0].opens: expected a time greater than 0"),
    ] {
        let found = wrong(added, overrides);
        assert!(found.iter().any(|line| line.contains(expected)), "{overrides:?}: {found:#?} has no {expected:?}");
    }
}

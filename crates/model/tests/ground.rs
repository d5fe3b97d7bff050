//! Ground and orbit of a scenario: the parts that the model makes of them, and the mistakes that it reports.

use glam::DVec3;
use netcast_model::Model;
use netcast_scenario::{Diagnostics, Document, Source, resolved_toml};

const NET: &str = r#"
web.square = { side = "2 m", mesh = "0.5 m" }
rope = { diameter = "4 mm", density = 1140, elastic_modulus = "1 GPa" }
solve.duration = "2 s"
"#;

fn model(more: &str) -> Result<Model, Diagnostics> {
    let source = Source { name: "net.toml".into(), text: format!("{NET}{more}") };
    Model::new(&Document::parse(source, "".as_ref(), &[])?)
}

fn wrong(more: &str) -> String {
    let Err(Diagnostics(found)) = model(more) else { panic!("nothing is wrong: {more}") };
    found.iter().map(|one| format!("{}: {}", one.path, one.message)).collect::<Vec<_>>().join("; ")
}

#[test]
fn the_default_height_of_the_ground_is_the_lowest_point_and_is_written_out() {
    // balls of 0.1 m on the corners of a net drawn level at the muzzle
    let ball = "tractor.sphere = { diameter = \"0.1 m\", mass = \"1 kg\" }";
    let net = model(&format!("{ball}\nenvironment.ground = {{}}")).unwrap();
    let ground = net.system.environment().ground.as_ref().unwrap();
    assert_eq!((ground.height, ground.friction, ground.nodes.len()), (-0.05, 0.5, net.cut.nodes.len()));
    assert!(resolved_toml(&net.scenario).contains("height = \"-0.05 m\""));
    // a mass rebounds within the contact time: t = pi sqrt(m / k)
    let spring = ground.nodes[0].spring;
    assert!((std::f64::consts::PI * (spring.mass / spring.stiffness).sqrt() / 1e-3 - 1.0).abs() < 1e-12);
}

#[test]
fn a_rigid_tractor_touches_the_ground_with_its_rims_and_its_ropes_with_their_knots() {
    let cylinder = "tractor.cylinder = { diameter = \"0.1 m\", height = \"0.2 m\", mass = \"1 kg\" }";
    let tied = "traction_rope = { length = \"0.5 m\", tied_at = \"rear\" }";
    let net = model(&format!("{cylinder}\n{tied}\nenvironment.ground.height = -1")).unwrap();
    let ground = net.system.environment().ground.as_ref().unwrap();
    assert_eq!((ground.hulls.len(), net.system.bodies().len()), (4 * 16, 4));
    assert!(ground.nodes.iter().all(|at| net.system.bodies().iter().all(|body| body.centre != at.node)));
}

#[test]
fn a_rigid_ball_touches_the_ground_with_its_surface() {
    let ball = "tractor.sphere = { diameter = \"0.1 m\", mass = \"1 kg\" }";
    let tied = "traction_rope = { length = \"0.5 m\", tied_at = \"front\" }";
    let net = model(&format!("{ball}\n{tied}\nenvironment.ground = {{}}")).unwrap();
    let ground = net.system.environment().ground.as_ref().unwrap();
    let hulls: Vec<_> = ground.hulls.iter().map(|hull| (hull.body, hull.arm, hull.radius)).collect();
    assert_eq!(hulls, [0, 1, 2, 3].map(|body| (body, DVec3::ZERO, 0.05)));
    // its front lies with the ropes at the muzzle, its back a diameter below
    assert!((ground.height + 0.1).abs() < 1e-15, "{}", ground.height);
}

#[test]
fn a_rigid_canopy_touches_the_ground_with_its_corners_and_its_middle() {
    let text = "web.space.side = \"1 m\"\ncanopy.rigid.side = \"0.14 m\"\nsolve.duration = \"0.1 s\"\n\
                rope = { diameter = \"3 mm\", density = 1440, elastic_modulus = \"7 GPa\" }\n\
                launch.elevation = \"30 deg\"\nenvironment.ground = {}";
    let source = Source { name: "net.toml".into(), text: text.into() };
    let net = Model::new(&Document::parse(source, "".as_ref(), &[]).unwrap()).unwrap();
    let ground = net.system.environment().ground.as_ref().unwrap();
    let carried: Vec<_> = net
        .system
        .bodies()
        .iter()
        .enumerate()
        .flat_map(|(i, body)| body.ties.iter().map(move |tie| (i, tie)))
        .collect();
    assert_eq!(ground.hulls.len(), carried.len());
    for (hull, (body, tie)) in ground.hulls.iter().zip(carried) {
        let touches = net.state.position[net.system.bodies()[body].centre] + hull.offset(&net.state.rotation[body]);
        assert!(hull.body == body && touches.distance(net.state.position[tie.node]) < 1e-12);
        assert!(ground.nodes.iter().all(|at| at.node != tie.node), "it touches once");
    }
    let lowest = net.state.position.iter().map(|place| place.z).fold(f64::INFINITY, f64::min);
    assert!((ground.height - lowest).abs() < 1e-12, "{} and {lowest}", ground.height);
}

#[test]
fn held_nodes_count_for_the_height_of_the_ground_and_are_not_pushed() {
    let ball = "tractor.sphere = { diameter = \"0.1 m\", mass = \"1 kg\" }";
    for held in ["hold.corners = true", "drive.them = { corners = true, path = [{ time = 1, by = [0, 0, 1] }] }"] {
        let net = model(&format!("{ball}\n{held}\nenvironment.ground = {{}}")).unwrap();
        let ground = net.system.environment().ground.as_ref().unwrap();
        assert_eq!((ground.height, ground.nodes.len()), (-0.05, net.cut.nodes.len() - 4), "{held}");
    }
}

#[test]
fn a_start_below_the_ground_is_reported() {
    let found = wrong("environment.ground.height = \"0.3 m\"");
    assert!(found.contains("environment.ground.height: ") && found.contains("starts 0.300 m below"), "{found}");
}

#[test]
fn on_the_ground_a_net_has_an_equilibrium_with_nothing_held() {
    let lying = model("environment.ground = {}\nsolve.static = {}").unwrap();
    assert!(lying.system.held().iter().all(|held| !held));
    assert!(wrong("solve.static = {}").contains("there is no equilibrium"));
}

#[test]
fn a_step_limited_by_the_ground_or_by_drag_names_it() {
    let short = model("environment.ground = { height = -1, contact_time = \"1 us\" }").unwrap();
    assert!(short.limited_by().unwrap().starts_with("the ground at"), "{:?}", short.limited_by());
    assert!(short.step_lift().unwrap().contains("contact_time"));
    let soft = NET.replace("1 GPa", "100 Pa");
    let thick = format!("{soft}environment.air = {{ density = 1e5, viscosity = 1 }}");
    let source = Source { name: "net.toml".into(), text: thick };
    let model = Model::new(&Document::parse(source, "".as_ref(), &[]).unwrap()).unwrap();
    assert!(model.limited_by().unwrap().starts_with("the drag of the medium at"), "{:?}", model.limited_by());
}

#[test]
fn a_profile_of_the_wind_begins_at_the_ground() {
    let wind = "[environment]\nair = {}\nground.height = -3\nwind = { speed = 5, power.exponent = 0.2 }";
    let net = model(wind).unwrap();
    let air = net.system.environment().air.as_ref().unwrap();
    // 10 m above the ground are 7 m above the muzzle
    assert!((air.wind.at(7.0, 0.0).x - 5.0).abs() < 1e-9 && air.wind.at(-3.0, 0.0) == DVec3::ZERO);
}

#[test]
fn an_orbit_has_its_mean_motion_and_excludes_gravity_air_and_ground() {
    let net = model("environment.orbit.altitude = \"600 km\"").unwrap();
    let environment = net.system.environment();
    // 96.5 minutes
    let period = std::f64::consts::TAU / environment.orbit.unwrap().mean_motion / 60.0;
    assert!((period - 96.7).abs() < 0.2 && environment.gravity == DVec3::ZERO, "{period} min");
    let given = model("environment.orbit.mean_motion = \"1e-3 rad/s\"").unwrap();
    assert_eq!(given.system.environment().orbit.unwrap().mean_motion, 1e-3);
    let found = wrong("[environment]\ngravity = 9.81\nair = {}\nground = {}\norbit.altitude = \"600 km\"");
    for what in ["environment.air", "environment.ground", "environment.gravity"] {
        assert!(found.contains(what), "{what} in {found}");
    }
    assert!(wrong("environment.orbit.altitude = 6e5\nsolve.static = {}").contains("solve.static: in an orbit"));
    let found = wrong("environment.orbit = {}");
    assert!(found.contains("altitude"), "{found}");
}

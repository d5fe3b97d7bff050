//! Launches by spin, tubes and delays against closed forms of work, momentum and angular momentum.

use crate::support::{Run, assert_close};
use glam::DVec3;
use netcast::dynamics::simulate::{Frame, Live, Observer, simulate};
use netcast::scenario::Source;
use netcast::{Case, Document, Model};

/// A net in a bag without gravity. Its tractors move 0.1 m before any rope is taut.
fn net(launch: &str) -> String {
    format!(
        r#"
[web.square]
side = "2 m"
mesh = "0.5 m"
[rope]
diameter = "2 mm"
density = 1140
elastic_modulus = "5 GPa"
[tractor.cylinder]
diameter = "50 mm"
height = "80 mm"
mass = "0.8 kg"
[traction_rope]
length = "0.6 m"
tied_at = "rear"
[stow.bag]
radius = "0.2 m"
[environment]
gravity = 0
[solve]
duration = "60 ms"
segment_length = "0.25 m"
{launch}"#
    )
}

fn read(text: String) -> Document {
    let source = Source { name: "net.toml".into(), text };
    Document::parse(source, "".as_ref(), &[]).unwrap_or_else(|errors| panic!("{errors}"))
}

/// The mass of a tractor with half a segment of rope, kg.
fn moving_mass(model: &Model) -> f64 {
    model.system.mass()[model.tractors[0]]
}

/// Splayed tubes: the velocity of each tractor is at the spread to the axis, with the axial speed along it.
#[test]
fn a_spread_turns_the_flight_of_each_tractor_from_the_axis() {
    let launch = "[launch]\naxial_speed = \"30 m/s\"\nspread = \"20 deg\"\nelevation = \"40 deg\"\n\
                  [[tractors]]\ncorner = 2\nspread = \"35 deg\"\n[[tractors]]\ncorner = 3\naxial_speed = \"50 m/s\"\n\
                  [[tractors]]\ncorner = 4\nradial_speed = \"5 m/s\"\n";
    let model = Model::new(&read(net(launch))).unwrap();
    let axis = model.axis();
    let found = model.tractors.iter().map(|&node| {
        let velocity = model.state.velocity[node];
        (velocity.dot(axis), velocity.angle_between(axis).to_degrees())
    });
    let exact = [(30.0, 20.0), (30.0, 35.0), (50.0, 20.0), (30.0, f64::atan2(5.0, 30.0).to_degrees())];
    for ((along, angle), (exact_along, exact_angle)) in found.zip(exact) {
        assert_close("speed along the axis, m/s", along, exact_along, 1e-12);
        assert_close("angle to the axis, deg", angle, exact_angle, 1e-9);
    }
    let wrong = |launch: &str| {
        let source = Source { name: "net.toml".into(), text: net(launch) };
        Document::parse(source, "".as_ref(), &[]).unwrap_err().to_string()
    };
    let both = wrong("[launch]\naxial_speed = 30\nradial_speed = 3\nspread = \"20 deg\"\n");
    assert!(both.contains("expected only one of `radial_speed` and `spread`"), "{both}");
    let idle = wrong("[launch]\nspread = \"20 deg\"\n");
    assert!(idle.contains("which is not given"), "{idle}");
}

#[test]
fn a_spring_in_a_tube_gives_its_work_and_takes_the_recoil() {
    let tube = "[launch.tube]\nstroke = \"0.1 m\"\ncant = \"30 deg\"\n\
                force_over_stroke = { at = [0, \"0.1 m\"], force = [\"1.2 kN\", 0] }\n";
    let run = Run::of(&read(net(tube)));
    let launch = run.summary.launch.clone().expect("it is launched");
    let speed = (2.0 * 60.0 / moving_mass(&run.model)).sqrt();
    for departure in launch.tractors.values() {
        assert_close("muzzle speed, m/s", departure.speed_m_s.expect("it left"), speed, 1e-5);
        // a quarter of the period of mass and spring
        let quarter = 0.5 * std::f64::consts::PI * (moving_mass(&run.model) / 12_000.0).sqrt();
        assert_close("time in the tube, s", departure.time_s.expect("it left"), quarter, 1e-3);
        assert_close("angle, deg", departure.angle_rad.to_degrees(), 30.0, 1e-12);
    }
    let recoil = launch.recoil.expect("tubes have one");
    // the parts across the axis cancel
    let momentum = 4.0 * moving_mass(&run.model) * speed * 0.75f64.sqrt();
    assert_close("recoil, N s", recoil.axial_impulse_n_s, momentum, 1e-5);
    assert_close("recoil, N s", recoil.impulse_n_s, momentum, 1e-5);
    assert_close("largest recoil, N", recoil.peak_n, 4.0 * 1200.0 * 0.75f64.sqrt(), 1e-9);
    assert_close("work of the springs, J", -run.last("energy_launch_j"), 240.0, 1e-6);
}

#[test]
fn a_constant_force_in_a_tube_does_work_against_the_weight() {
    let tube = "[launch]\nelevation = \"40 deg\"\n[launch.tube]\nstroke = \"0.1 m\"\n\
                force_over_stroke = { at = [0], force = [\"300 N\"] }\n";
    let run = Run::of(&read(net(tube).replace("gravity = 0", "gravity = 9.80665")));
    let launch = run.summary.launch.clone().expect("it is launched");
    let weight = 9.80665 * libm::sin(40f64.to_radians());
    let speed = (2.0 * 0.1 * (300.0 / moving_mass(&run.model) - weight)).sqrt();
    for departure in launch.tractors.values() {
        assert_close("muzzle speed, m/s", departure.speed_m_s.expect("it left"), speed, 2e-5);
    }
}

#[test]
fn a_delayed_tractor_leaves_at_its_time_and_the_ledger_has_its_energy() {
    let delayed = "[launch]\naxial_speed = \"20 m/s\"\n[[tractors]]\ncorner = 3\ndelay = \"5 ms\"\n";
    let run = Run::of(&read(net(delayed)));
    let launch = run.summary.launch.clone().expect("it is launched");
    let late = &launch.tractors[&3];
    let dt = run.summary.step.dt_s;
    assert!((late.time_s.expect("it left") - 5e-3).abs() <= dt && late.speed_m_s == Some(20.0), "{late:?}");
    assert_eq!(launch.tractors[&1].time_s, Some(0.0));
    assert_close("work of the launcher, J", -run.last("energy_launch_j"), 0.5 * moving_mass(&run.model) * 400.0, 1e-9);
    let node = run.model.tractors[2];
    let start = run.fields.positions(0)[node];
    let way = |time: f64| {
        let frame = run.fields.times.iter().position(|&frame| (frame - time).abs() <= 0.5 * dt).expect("a record");
        (run.fields.positions(frame)[node] - start).length()
    };
    assert!(way(4e-3) < 1e-12);
    assert!(way(6e-3) > 0.015);
}

/// The angular momentum of the whole net about the origin at each record, kg m^2/s.
struct AngularMomentum<'m> {
    model: &'m Model,
    records: Vec<DVec3>,
}

impl Observer for AngularMomentum<'_> {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        let nodes = frame.position.iter().zip(frame.velocity).zip(self.model.system.mass());
        let of_nodes: DVec3 = nodes.map(|((x, v), m)| x.cross(*m * *v)).sum();
        let of_bodies: DVec3 = frame.rotation.iter().map(|rotation| rotation.angular_momentum).sum();
        self.records.push(of_nodes + of_bodies);
    }
}

#[test]
fn a_spinning_web_keeps_its_angular_momentum() {
    let spun = "[launch]\naxial_speed = \"10 m/s\"\nspin = \"40 rad/s\"\n";
    let document = read(net(spun));
    let case = Case::of(document.clone()).unwrap_or_else(|errors| panic!("{errors}"));
    let model = case.model();
    let mut angular_momentum = AngularMomentum { model, records: Vec::new() };
    let outcome = simulate(&model.system, &model.state, case.schedule(), 1, &mut angular_momentum);
    let start = angular_momentum.records[0];
    // the net starts as a rotating rigid body
    let about_axis: f64 =
        model.state.position.iter().zip(model.system.mass()).map(|(x, m)| m * x.truncate().length_squared()).sum();
    let own: f64 = model.system.bodies().iter().map(|body| body.inertia.z).sum();
    assert_close("angular momentum, kg m^2/s", start.z, 40.0 * (about_axis + own), 1e-9);
    for now in angular_momentum.records {
        assert!((now - start).length() < 2e-3 * start.length(), "{now} instead of {start}");
    }
    assert!(outcome.balance.closure() < 3e-3, "{}", outcome.balance.closure());
}

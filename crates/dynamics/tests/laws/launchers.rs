//! Launchers against closed forms: muzzle speeds, recoil, delays; and energy that closes through all of it.

use crate::nets::{Film, Material, Net};
use glam::{DQuat, DVec3};
use netcast_dynamics::channel::Channel;
use netcast_dynamics::launcher::{ForceCurve, Launcher, Means, Push, Tube};
use netcast_dynamics::simulate::{Outcome, Schedule, simulate};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::Environment;

const GRAVITY: f64 = 9.81;
const MASS: f64 = 0.5;
const STROKE: f64 = 0.4;

fn tube(node: usize, direction: DVec3, push: Push) -> Launcher {
    Launcher { node, at: 0.0, by: Means::Tube(Tube { breech: DVec3::ZERO, direction, stroke: STROKE, push }) }
}

fn constant(force: f64) -> Push {
    Push::OverStroke(ForceCurve(vec![(0.0, force)]))
}

/// A mass alone in a tube.
fn shot(launcher: Launcher, gravity: DVec3, dt: f64) -> (Outcome, Film) {
    let mut net = Net::default();
    let node = net.node(DVec3::ZERO, DVec3::ZERO);
    net.parts.mass[node] = MASS;
    net.parts.launchers = vec![launcher];
    net.parts.environment = Environment { gravity, mass_damping: 0.0, ..Environment::default() };
    let mut film = Film::default();
    let outcome = simulate(&net.build(), &net.state, &Schedule::new(0.1, 1e-3, dt), 1, &mut film);
    (outcome, film)
}

fn left(outcome: &Outcome) -> (f64, f64) {
    outcome.launching.nodes[0].left.expect("it has left")
}

#[test]
fn a_constant_force_gives_the_muzzle_speed_of_its_work_and_a_recoil_of_its_momentum() {
    let force = 800.0;
    let (outcome, _) = shot(tube(0, DVec3::X, constant(force)), DVec3::ZERO, 1e-5);
    let exact = (2.0 * force * STROKE / MASS).sqrt();
    let (time, speed) = left(&outcome);
    assert!((speed / exact - 1.0).abs() < 1e-6, "{speed} instead of {exact} m/s");
    assert!((time / (exact * MASS / force) - 1.0).abs() < 1e-4, "{time} s");
    let recoil = outcome.launching.recoil;
    assert!((recoil.impulse + MASS * speed * DVec3::X).length() < 1e-5 * MASS * speed, "{}", recoil.impulse);
    assert!((recoil.peak.0 - force).abs() < 1e-9);
    assert!((outcome.ledger[Channel::Launch] + 0.5 * MASS * exact * exact).abs() < 1e-5 * MASS * exact * exact);
    assert!(outcome.balance.closure() < 1e-5, "{}", outcome.balance.closure());
}

#[test]
fn the_muzzle_speed_is_of_second_order_wherever_the_step_falls() {
    let exact = (2.0 * 800.0 * STROKE / MASS).sqrt();
    for dt in [1e-3, 0.7e-3, 0.31e-3, 1e-4, 3.3e-5] {
        let (outcome, _) = shot(tube(0, DVec3::X, constant(800.0)), DVec3::ZERO, dt);
        let error = (left(&outcome).1 / exact - 1.0).abs();
        // the work is exact; the last force of the scheme is dt^2 a^2/8 of energy
        assert!(error < 800.0 * dt * dt, "{error} with a step of {dt} s");
    }
}

#[test]
fn upwards_the_weight_takes_its_share_and_the_tube_bears_what_lies_across() {
    let direction = DVec3::new(0.6, 0.0, 0.8);
    let (outcome, film) = shot(tube(0, direction, constant(50.0)), DVec3::NEG_Z * GRAVITY, 1e-5);
    let exact = (2.0 * STROKE * (50.0 / MASS - GRAVITY * 0.8)).sqrt();
    let (time, speed) = left(&outcome);
    assert!((speed / exact - 1.0).abs() < 2e-5, "{speed} instead of {exact} m/s");
    for (at, x, _) in film.frames.iter().filter(|(at, ..)| *at <= time) {
        assert!(x[0].cross(direction).length() < 1e-13, "beside the tube at {at} s: {}", x[0]);
    }
    assert!(outcome.balance.closure() < 1e-5, "{}", outcome.balance.closure());
}

#[test]
fn a_spring_gives_what_it_has_stored() {
    let stiffness = 5e3;
    let spring = Push::OverStroke(ForceCurve(vec![(0.0, stiffness * STROKE), (STROKE, 0.0)]));
    let (outcome, _) = shot(tube(0, DVec3::Y, spring), DVec3::ZERO, 1e-5);
    let energy = 0.5 * stiffness * STROKE * STROKE;
    let (time, speed) = left(&outcome);
    assert!((0.5 * MASS * speed * speed / energy - 1.0).abs() < 1e-6, "{speed} m/s");
    // a quarter of its period
    let quarter = 0.5 * std::f64::consts::PI * (MASS / stiffness).sqrt();
    assert!((time / quarter - 1.0).abs() < 1e-3, "{time} s instead of {quarter} s");
    assert!((outcome.launching.recoil.peak.0 - stiffness * STROKE).abs() < 1e-9);
}

#[test]
fn a_force_over_time_gives_its_impulse() {
    // a triangle of 4 ms and 1500 N, over before the tube is
    let pulse = Push::OverTime(ForceCurve(vec![(0.0, 0.0), (2e-3, 1500.0), (4e-3, 0.0)]));
    let (outcome, _) = shot(Launcher { at: 5e-3, ..tube(0, DVec3::X, pulse) }, DVec3::ZERO, 1e-5);
    let (time, speed) = left(&outcome);
    assert!((MASS * speed / 3.0 - 1.0).abs() < 1e-5, "{} N s", MASS * speed);
    // it has gone 2 ms times the final speed at the end of the pulse, and coasts
    assert!((time - (5e-3 + 4e-3 + (STROKE - 2e-3 * speed) / speed)).abs() < 2e-5, "{time} s");
}

#[test]
fn what_waits_for_its_time_stays_and_then_has_its_velocity() {
    let (delay, velocity) = (20e-3, DVec3::new(3.0, 0.0, 4.0));
    let launcher = Launcher { node: 0, at: delay, by: Means::Velocity(velocity) };
    let gravity = DVec3::NEG_Z * GRAVITY;
    let (outcome, film) = shot(launcher, gravity, 1e-4);
    for (time, x, v) in &film.frames {
        let t = (time - delay).max(0.0);
        assert!((x[0] - (velocity * t + 0.5 * t * t * gravity)).length() < 1e-12, "{} at {time} s", x[0]);
        let exact = if *time > delay - 1e-9 { velocity + t * gravity } else { DVec3::ZERO };
        assert!((v[0] - exact).length() < 1e-12, "{} at {time} s", v[0]);
    }
    assert_eq!(left(&outcome).1, 5.0);
    assert!((outcome.ledger[Channel::Launch] + 0.5 * MASS * 25.0).abs() < 1e-12);
    assert!(outcome.balance.closure() < 1e-12);
}

/// Two masses on a rope: one thrown from a tube as a rigid body tied at its rear, the other let go later.
#[test]
fn a_rope_pulled_out_of_two_launchers_closes_its_energy() {
    let rope = Material { axial_stiffness: 2e4, mass_per_length: 0.05, damping_ratio: 0.05 };
    let mut net = Net::rope(1.0, 10, rope);
    for x in &mut net.state.position {
        *x = DVec3::new(0.3 * x.x, 0.0, -0.1);
    }
    let rear = 10;
    let axis = DQuat::from_rotation_y(0.3);
    let direction = axis * DVec3::Z;
    let breech = net.state.position[rear] + 0.1 * direction;
    let inertia = DVec3::new(0.003, 0.003, 0.001);
    let body = net.body(breech, DVec3::ZERO, 1.0, inertia, (axis, 50.0 * direction), &[rear]);
    net.parts.mass[0] += 0.4;
    let push = Push::OverStroke(ForceCurve(vec![(0.0, 900.0), (STROKE, 400.0)]));
    net.parts.launchers = vec![
        Launcher { node: body, at: 2e-3, by: Means::Tube(Tube { breech, direction, stroke: STROKE, push }) },
        Launcher { node: 0, at: 30e-3, by: Means::Velocity(DVec3::new(-5.0, 2.0, 10.0)) },
        // a cover over the middle of the rope
        Launcher { node: 5, at: 10e-3, by: Means::Velocity(DVec3::ZERO) },
    ];
    net.parts.environment =
        Environment { gravity: DVec3::NEG_Z * GRAVITY, mass_damping: 1.0, ..Environment::default() };
    let system = net.build();
    let mut film = Film::default();
    let schedule = Schedule::new(0.1, 1e-3, 0.2 * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut film);
    let at = |time: f64| &film.frames[(time / 1e-3).round() as usize].1;
    assert!((at(10e-3)[5] - net.state.position[5]).length() < 1e-12, "the cover has moved");
    assert!((at(30e-3)[0] - net.state.position[0]).length() < 1e-12, "what is held has moved");
    assert!(at(0.1)[body].distance(breech) > 2.0 * STROKE);
    assert!(outcome.ledger[Channel::Launch] < -200.0, "{}", outcome.ledger[Channel::Launch]);
    assert!(outcome.balance.closure() < 1e-3, "{}", outcome.balance.closure());
}

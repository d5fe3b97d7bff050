//! Ground and orbit: what falls bounces as it should, slides as far as friction lets it, and lies still; what flies
//! beside an orbit goes the way of Clohessy and Wiltshire.

use crate::nets::{self, Film, Material, Net};
use glam::{DQuat, DVec3};
use netcast_dynamics::channel::Channel;
use netcast_dynamics::forces::ground::{Footing, Ground, Hull, Spring};
use netcast_dynamics::forces::orbit::Orbit;
use netcast_dynamics::simulate::{Outcome, Schedule, simulate};
use netcast_dynamics::statics::{Accuracy, relax, unsupported};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::Environment;
use proptest::prelude::*;

const GRAVITY: f64 = 9.80665;

fn lying(ground: Ground) -> Environment {
    Environment { gravity: DVec3::NEG_Z * GRAVITY, ground: Some(ground), ..Environment::default() }
}

/// Ground at zero under all nodes of `net`.
fn under(net: &Net, friction: f64, restitution: f64) -> Ground {
    let footing =
        |(node, &mass): (usize, &f64)| Footing { node, radius: 0.0, spring: Spring::bouncing(mass, 1e-3, restitution) };
    let nodes = net.parts.mass.iter().enumerate().filter(|(_, mass)| **mass > 0.0).map(footing).collect();
    Ground { height: 0.0, friction, nodes, hulls: Vec::new() }
}

fn run(net: &Net, duration: f64, share: f64) -> (Outcome, Film) {
    let system = net.build();
    let mut film = Film::default();
    let schedule = Schedule::new(duration, 1e-3, share * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut film);
    assert_eq!(outcome.stopped, None);
    (outcome, film)
}

#[test]
fn a_ball_that_is_dropped_rises_to_the_square_of_its_restitution() {
    for restitution in [0.2, 0.6, 1.0] {
        let mut net = Net::default();
        let ball = net.node(2.0 * DVec3::Z, DVec3::ZERO);
        net.parts.mass[ball] = 0.3;
        net.parts.environment = lying(under(&net, 0.5, restitution));
        let (outcome, film) = run(&net, 1.4, 0.02);
        let landed = film.frames.iter().position(|frame| frame.1[ball].z < 0.0).unwrap();
        let rebound = film.frames[landed..].iter().map(|frame| frame.1[ball].z).fold(0.0, f64::max);
        let expected = 2.0 * restitution * restitution;
        assert!((rebound / expected - 1.0).abs() < 0.01, "{restitution}: {rebound} for {expected} m");
        assert!(outcome.balance.closure() < 4e-4, "{restitution}: {}", outcome.balance.closure());
    }
}

#[test]
fn what_slides_stops_after_v_squared_over_twice_mu_g_and_stays() {
    let mut net = Net::default();
    let stone = net.node(DVec3::ZERO, 3.0 * DVec3::X);
    net.parts.mass[stone] = 2.0;
    net.parts.environment = lying(under(&net, 0.4, 0.2));
    let (outcome, film) = run(&net, 2.0, 0.05);
    let way = 9.0 / (2.0 * 0.4 * GRAVITY);
    let at = |i: usize| film.frames[i].1[stone].x;
    assert!((at(2000) / way - 1.0).abs() < 2e-3, "{} for {way} m", at(2000));
    assert!((at(2000) - at(1200)).abs() < 1e-6 * way);
    assert!(
        (outcome.ledger[Channel::GroundFriction] / 9.0 - 1.0).abs() < 1e-2,
        "{}",
        outcome.ledger[Channel::GroundFriction]
    );
    assert!(outcome.balance.closure() < 1e-4, "{}", outcome.balance.closure());
}

#[test]
fn a_box_dropped_on_an_edge_comes_to_lie_on_its_side() {
    let mut net = Net::default();
    let (sin, cos) = libm::sincos(0.5 * 0.3);
    let tilted = DQuat::from_xyzw(0.0, sin, 0.0, cos);
    let inertia = DVec3::new(0.2 * 0.2 + 0.1 * 0.1, 0.3 * 0.3 + 0.1 * 0.1, 0.3 * 0.3 + 0.2 * 0.2) / 12.0;
    let body = net.body(0.3 * DVec3::Z, DVec3::ZERO, 1.0, inertia, (tilted, DVec3::ZERO), &[]);
    let mut ground = under(&net, 0.6, 0.2);
    ground.nodes.clear();
    let corners =
        [-1.0, 1.0].map(|x| [-1.0, 1.0].map(|y| [-1.0, 1.0].map(|z| DVec3::new(0.15 * x, 0.1 * y, 0.05 * z))));
    let hull = |arm| Hull::new(0, &net.parts.bodies[0], 1.0, arm, 0.0, |mass| Spring::bouncing(mass, 1e-3, 0.2));
    ground.hulls = corners.into_iter().flatten().flatten().map(hull).collect();
    net.parts.environment = lying(ground);
    let (outcome, film) = run(&net, 2.0, 0.1);
    let (_, place, velocity) = film.frames.last().unwrap();
    assert!((place[body].z - 0.05).abs() < 1e-4 && velocity[body].length() < 1e-3, "{place:?}, {velocity:?}");
    assert!(outcome.balance.closure() < 1e-3, "{}", outcome.balance.closure());
}

#[test]
fn an_impact_in_few_steps_leaves_no_hole_in_the_balance() {
    // 0.1 of a radian a step; after several bounces from heights that the step knows nothing of
    for height in [0.5, 0.511, 0.523, 0.537] {
        let mut net = Net::default();
        let ball = net.node(height * DVec3::Z, DVec3::ZERO);
        net.parts.mass[ball] = 0.3;
        let mut ground = under(&net, 0.5, 1.0);
        // no whole number of steps in contact, or what a crossing takes the next gives back
        ground.nodes[0].spring = Spring::bouncing(0.3, 1.0157e-3, 1.0);
        net.parts.environment = lying(ground);
        let outcome = run(&net, 1.2, 0.05).0;
        let missing = (outcome.ledger.sum() - outcome.balance.initial()) / outcome.balance.initial();
        assert!(missing.abs() < 1e-4, "{height} m: {missing}");
    }
}

#[test]
fn a_sliding_ball_comes_to_roll_at_five_sevenths_of_its_speed() {
    let mut net = Net::default();
    let (mass, radius, speed) = (0.5, 0.05, 2.0);
    let inertia = DVec3::splat(0.4 * mass * radius * radius);
    let ball = net.body(radius * DVec3::Z, speed * DVec3::X, mass, inertia, (DQuat::IDENTITY, DVec3::ZERO), &[]);
    let mut ground = under(&net, 0.3, 0.2);
    ground.nodes.clear();
    let spring = |mass: f64| Spring::bouncing(mass, 1e-3, 0.2);
    ground.hulls = vec![Hull::new(0, &net.parts.bodies[0], mass, DVec3::ZERO, radius, spring)];
    net.parts.environment = lying(ground);
    let (outcome, film) = run(&net, 0.6, 0.05);
    // it slides for 2 v / (7 mu g) = 0.19 s
    let rolls = film.frames.last().unwrap().2[ball].x;
    assert!((rolls / (5.0 / 7.0 * speed) - 1.0).abs() < 2e-3, "{rolls}");
    let lost = outcome.ledger[Channel::GroundFriction] / (0.5 * mass * speed * speed);
    assert!((lost / (2.0 / 7.0) - 1.0).abs() < 1e-2, "{lost}");
    assert!(outcome.balance.closure() < 1e-4, "{}", outcome.balance.closure());
}

#[test]
fn a_heavy_box_and_its_rope_come_to_rest_on_the_ground_with_nothing_held() {
    let soft = Material { axial_stiffness: 1e3, mass_per_length: 0.1, damping_ratio: 0.05 };
    let mut net = Net::rope(1.0, 4, soft);
    let corner = net.state.position[4];
    let inertia = DVec3::splat(50.0 * 0.04 / 6.0);
    net.state.position[4] = corner + 0.3 * DVec3::Z;
    let at = corner + DVec3::new(0.1, 0.0, 0.3);
    let body = net.body(at, DVec3::ZERO, 50.0, inertia, (DQuat::IDENTITY, DVec3::ZERO), &[4]);
    for x in &mut net.state.position {
        x.z += 0.02;
    }
    let mut ground = under(&net, 0.5, 0.2);
    ground.nodes.retain(|at| at.node != body);
    let corners = [-0.1, 0.1].map(|x| [-0.1, 0.1].map(|y| [-0.1, 0.1].map(|z| DVec3::new(x, y, z))));
    let spring = |mass: f64| Spring::bouncing(mass, 1e-3, 0.2);
    let hull = |arm| Hull::new(0, &net.parts.bodies[0], 50.0, arm, 0.0, spring);
    ground.hulls = corners.into_iter().flatten().flatten().map(hull).collect();
    net.parts.environment = lying(ground);
    let system = net.build();
    assert_eq!(unsupported(&system, &net.state), None);
    let accuracy = Accuracy { tolerance: 1e-5, max_iterations: 1_000_000 };
    let found = relax(&system, &net.state, &accuracy, 1, &mut |_| true);
    assert_eq!(found.stopped, None);
    assert!((found.state.position[body].z - 0.1).abs() < 1e-3, "{}", found.state.position[body]);
}

#[test]
fn a_rope_laid_down_on_ground_rests_on_it() {
    let soft = Material { axial_stiffness: 1e3, mass_per_length: 0.1, damping_ratio: 0.05 };
    let mut net = Net::rope(1.0, 10, soft);
    for x in &mut net.state.position {
        x.z += 0.01 + 0.02 * x.x;
    }
    net.parts.environment = lying(under(&net, 0.5, 0.2));
    let accuracy = Accuracy { tolerance: 1e-6, max_iterations: 1_000_000 };
    let found = relax(&net.build(), &net.state, &accuracy, 1, &mut |_| true);
    assert_eq!(found.stopped, None);
    // each sinks by g / omega^2
    let sinks = GRAVITY * (1e-3 / std::f64::consts::PI) * (1e-3 / std::f64::consts::PI);
    assert!(found.state.position.iter().all(|x| (x.z / -sinks - 1.0).abs() < 1e-3), "{:?}", found.state.position);
}

#[test]
fn beside_an_orbit_a_mass_goes_the_way_of_clohessy_and_wiltshire() {
    let n = 1.1e-3;
    let (start, velocity) = (DVec3::new(30.0, -50.0, 20.0), DVec3::new(0.05, -0.02, 0.03));
    // the world's axes: z away from the planet, x along the orbit, y across
    let mut net = Net::default();
    let (radial, along) = (DVec3::Z, DVec3::X);
    let across = radial.cross(along);
    let world = |of: DVec3| of.x * radial + of.y * along + of.z * across;
    let mass = net.node(world(start), world(velocity));
    net.parts.mass[mass] = 5.0;
    net.parts.environment =
        Environment { orbit: Some(Orbit { mean_motion: n, radial, along }), ..Environment::default() };
    let mut film = Film::default();
    let period = 2.0 * std::f64::consts::PI / n;
    let outcome = simulate(&net.build(), &net.state, &Schedule::new(period, 100.0, 0.5), 1, &mut film);
    for (t, position, _) in &film.frames {
        let (s, c) = libm::sincos(n * t);
        let x = (4.0 - 3.0 * c) * start.x + s / n * velocity.x + 2.0 / n * (1.0 - c) * velocity.y;
        let y = 6.0 * (s - n * t) * start.x + start.y - 2.0 / n * (1.0 - c) * velocity.x
            + (4.0 * s - 3.0 * n * t) / n * velocity.y;
        let z = c * start.z + s / n * velocity.z;
        let error = (position[mass] - world(DVec3::new(x, y, z))).length();
        assert!(error < 1e-3, "{t} s: {error} m");
    }
    assert!(outcome.balance.closure() < 1e-6, "{}", outcome.balance.closure());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_net_that_lands_closes_its_energy_better_with_a_smaller_step(mut net in nets::any_net(0.2)) {
        nets::on_the_ground_of_a_moon(&mut net);
        let system = net.build();
        let closure = |share: f64| {
            let schedule = Schedule::new(0.03, 0.01, share * step_limit(&system).dt);
            simulate(&system, &net.state, &schedule, 1, &mut Film::default()).balance.closure()
        };
        let (coarse, fine) = (closure(0.2), closure(0.02));
        prop_assert!(fine < 3e-4 && fine < (0.3 * coarse).max(2e-5), "{} and {}", coarse, fine);
    }
}

//! Air: what falls reaches its speed, what is towed takes its shape, wind carries, and the energy closes.

use crate::nets::{self, Film, Material, Net};
use glam::{DQuat, DVec3};
use netcast_dynamics::air::atmosphere::Medium;
use netcast_dynamics::air::wind::{LinearTable, Wind};
use netcast_dynamics::air::{Air, Attitude, BodyDrag};
use netcast_dynamics::channel::Channel;
use netcast_dynamics::forces::body_drag::Shape;
use netcast_dynamics::forces::rope_drag::RopeDrag;
use netcast_dynamics::forces::sheet_drag::SheetDrag;
use netcast_dynamics::simulate::{Outcome, Schedule, simulate};
use netcast_dynamics::statics::{Accuracy, relax};
use netcast_dynamics::step_size::{Stiff, step_limit};
use netcast_dynamics::system::Environment;
use proptest::prelude::*;

const GRAVITY: f64 = 9.80665;
const ROPE: RopeDrag = RopeDrag { diameter: 0.01, normal: Some(1.1), tangential: 0.0, solidity: 0.0 };

fn still(ropes: Vec<Option<RopeDrag>>) -> Air {
    Air { ropes, fastest: 100.0, ..Air::new(Medium::uniform(1.225, 1.7894e-5), Wind::none()) }
}

fn falling(air: Air) -> Environment {
    Environment { gravity: DVec3::NEG_Z * GRAVITY, air: Some(air), ..Environment::default() }
}

fn run(net: &Net, duration: f64, largest_dt: f64) -> (Outcome, Film) {
    let system = net.build();
    let schedule = Schedule::new(duration, 0.01, (0.25 * step_limit(&system).dt).min(largest_dt));
    let mut film = Film::default();
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut film);
    assert_eq!(outcome.stopped, None);
    (outcome, film)
}

/// Largest distance from v = v_t tanh(g t / v_t), over v_t, of a node's falling speed.
fn error_of_fall(film: &Film, node: usize, terminal: f64) -> f64 {
    let error = |(time, _, velocity): &(f64, Vec<DVec3>, Vec<DVec3>)| {
        (-velocity[node].z - terminal * libm::tanh(GRAVITY * time / terminal)).abs() / terminal
    };
    film.frames.iter().map(error).fold(0.0, f64::max)
}

#[test]
fn a_level_rope_falls_as_a_body_in_quadratic_drag() {
    // the paper's rope: 14.5 m/s
    let soft = Material { axial_stiffness: 1e3, mass_per_length: 1850.0 * 7.853_981_6e-5, damping_ratio: 0.05 };
    let mut net = Net::rope(2.0, 10, soft);
    net.parts.environment = falling(still(vec![Some(ROPE)]));
    let terminal = (2.0 * soft.mass_per_length * GRAVITY / (1.225 * 1.1 * 0.01)).sqrt();
    assert!((terminal - 14.5).abs() < 0.05, "{terminal}");
    let (outcome, film) = run(&net, 8.0, 1e-3);
    for node in [0, 5, 10] {
        let error = error_of_fall(&film, node, terminal);
        assert!(error < 1e-5, "node {node}: {error}");
    }
    assert!(outcome.balance.closure() < 1e-6, "{}", outcome.balance.closure());
    assert!(outcome.ledger[Channel::Air] > 0.5 * -outcome.ledger[Channel::Gravity]);
}

#[test]
fn a_sheet_and_a_body_fall_at_their_terminal_speeds() {
    let mut net = Net::default();
    for corner in [DVec3::ZERO, DVec3::X, DVec3::Y] {
        let node = net.node(corner, DVec3::ZERO);
        net.parts.mass[node] = 0.2;
    }
    let sphere = net.node(10.0 * DVec3::X, DVec3::ZERO);
    net.parts.mass[sphere] = 0.8;
    // a cylinder on its side
    let cylinder = net.node(20.0 * DVec3::X, DVec3::ZERO);
    net.parts.mass[cylinder] = 3.0;
    let shape = Shape::Cylinder { diameter: 0.1, height: 0.2 };
    let lying = Attitude::Fixed(DQuat::from_xyzw(0.5f64.sqrt(), 0.0, 0.0, 0.5f64.sqrt()));
    let mut air = still(Vec::new());
    air.sheets = vec![SheetDrag { nodes: [0, 1, 2], coefficient: 1.17, area: 0.5 }];
    air.bodies = vec![
        BodyDrag { node: sphere, attitude: Attitude::Fixed(DQuat::IDENTITY), shape: Shape::Sphere(0.2) },
        BodyDrag { node: cylinder, attitude: lying, shape },
    ];
    net.parts.environment = falling(air);
    let (outcome, film) = run(&net, 12.0, 1e-3);
    let terminal = |mass: f64, area: f64| (2.0 * mass * GRAVITY / (1.225 * area)).sqrt();
    let error = error_of_fall(&film, 0, terminal(0.6, 1.17 * 0.5));
    assert!(error < 1e-5, "sheet: {error}");
    let error = error_of_fall(&film, cylinder, terminal(3.0, 0.68 * 0.02));
    assert!(error < 1e-5, "cylinder: {error}");
    // the sphere's coefficient by White's fit at its own speed: 1/2 rho C A v^2 = m g
    let v = -film.frames.last().unwrap().2[sphere].z;
    let reynolds = 1.225 * v * 0.2 / 1.7894e-5;
    let coefficient = 24.0 / reynolds + 6.0 / (1.0 + reynolds.sqrt()) + 0.4;
    let drag = 0.5 * 1.225 * coefficient * std::f64::consts::PI * 0.01 * v * v;
    assert!((drag / (0.8 * GRAVITY) - 1.0).abs() < 5e-3, "{drag}");
    assert!(outcome.balance.closure() < 1e-6, "{}", outcome.balance.closure());
}

#[test]
fn wind_carries_a_loose_rope_along_at_last() {
    let soft = Material { axial_stiffness: 1e3, mass_per_length: 0.01, damping_ratio: 0.05 };
    let mut net = Net::rope(1.0, 5, soft);
    let mut air = still(vec![Some(ROPE)]);
    air.wind = Wind::uniform(DVec3::Y, 8.0);
    net.parts.environment = Environment { air: Some(air), ..Environment::default() };
    let (outcome, film) = run(&net, 60.0, 1e-2);
    // m v' = c (u - v)^2: u - v = u / (1 + c u t / m)
    let (_, _, velocity) = film.frames.last().unwrap();
    let c = 0.5 * 1.225 * 1.1 * 0.01 / 0.01;
    let left = 8.0 / (1.0 + c * 8.0 * 60.0);
    assert!((velocity[2].y - (8.0 - left)).abs() < 1e-3, "{}", velocity[2].y);
    // the wind has done it all
    assert!(
        (outcome.ledger[Channel::Air] + outcome.ledger[Channel::Kinetic]).abs()
            < 1e-6 * outcome.ledger[Channel::Kinetic]
    );
}

#[test]
fn a_rope_in_water_has_the_mass_of_the_water_it_takes_along_across_and_not_along() {
    let pull = |way: DVec3| {
        let light = Material { axial_stiffness: 1e3, mass_per_length: 0.1, damping_ratio: 0.05 };
        let mut net = Net::rope(1.0, 5, light);
        let mut air = still(vec![Some(RopeDrag { normal: Some(0.0), ..ROPE })]);
        (air.medium, air.added_mass) = (Medium::uniform(1000.0, 1e-3), 1.0);
        net.parts.environment = Environment { gravity: way, air: Some(air), ..Environment::default() };
        let (outcome, film) = run(&net, 0.1, 1e-3);
        assert!(outcome.balance.closure() < 1e-6, "{}", outcome.balance.closure());
        film.frames.last().unwrap().2[2].dot(way) / 0.1
    };
    assert!((pull(DVec3::X) - 1.0).abs() < 1e-9);
    let taken_along = 1000.0 * std::f64::consts::FRAC_PI_4 * 1e-4;
    assert!((pull(DVec3::Z) - 0.1 / (0.1 + taken_along)).abs() < 1e-9, "{}", pull(DVec3::Z));
}

#[test]
fn a_gust_does_the_work_that_it_gives() {
    let soft = Material { axial_stiffness: 1e3, mass_per_length: 0.05, damping_ratio: 0.05 };
    let mut net = Net::rope(1.0, 5, soft);
    let mut air = still(vec![Some(RopeDrag { normal: None, tangential: 0.02, ..ROPE })]);
    let values = [0.0, 5.0, 20.0, -10.0, 0.0].map(|speed| DVec3::new(0.0, speed, 0.3 * speed));
    air.wind.fluctuation = LinearTable { first: 0.1, spacing: 0.1, values: values.into() };
    net.parts.environment = Environment { air: Some(air), ..Environment::default() };
    let (outcome, _) = run(&net, 1.0, 1e-3);
    assert!(
        outcome.ledger[Channel::Kinetic] > 0.01 && outcome.balance.closure() < 1e-4,
        "{}",
        outcome.balance.closure()
    );
}

#[test]
fn a_ball_on_a_line_rests_in_a_wind_where_drag_and_weight_balance() {
    let line = Material { axial_stiffness: 1e4, mass_per_length: 1e-6, damping_ratio: 0.05 };
    let mut net = Net::rope(1.0, 4, line);
    net.parts.held[0] = true;
    net.parts.mass[4] += 0.05;
    let mut air = still(vec![None]);
    let ball = Shape::Sphere(0.1);
    air.bodies = vec![BodyDrag { node: 4, attitude: Attitude::Fixed(DQuat::IDENTITY), shape: ball }];
    air.wind = Wind::uniform(DVec3::Y, 12.0);
    // a gust that comes later is of no account
    air.wind.fluctuation = LinearTable { first: 1.0, spacing: 1.0, values: vec![DVec3::ZERO, 50.0 * DVec3::X] };
    net.parts.environment = falling(air);
    let accuracy = Accuracy { tolerance: 1e-9, max_iterations: 1_000_000 };
    let found = relax(&net.build(), &net.state, &accuracy, 1, &mut |_| true);
    assert_eq!(found.stopped, None);
    let drag = ball.force(12.0 * DVec3::Y, 1.225, 1.7894e-5).y;
    let (at, expected) = (found.state.position[4], drag / (0.05 * GRAVITY));
    assert!((at.y / -at.z / expected - 1.0).abs() < 1e-4 && at.x.abs() < 1e-9, "{at}, {expected}");
}

#[test]
fn a_loose_sheet_in_water_is_bounded_by_drag_alone_and_so_is_a_plate() {
    let mut air = still(Vec::new());
    air.medium = Medium::uniform(1000.0, 1e-3);
    air.sheets = vec![SheetDrag { nodes: [0, 1, 2], coefficient: 1.17, area: 0.5 }];
    let bound = |as_plate: bool| {
        let mut net = Net::default();
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y].map(|corner| net.node(corner, DVec3::ZERO));
        for corner in corners {
            net.parts.mass[corner] = 0.1;
        }
        if as_plate {
            let at = DVec3::new(1.0, 1.0, 0.0) / 3.0;
            net.body(at, DVec3::ZERO, 0.3, DVec3::splat(0.01), (DQuat::IDENTITY, DVec3::ZERO), &corners);
        }
        net.parts.environment = Environment { air: Some(air.clone()), ..Environment::default() };
        let limit = step_limit(&net.build());
        assert_eq!(limit.stiffest, Some(Stiff::Effect { name: "drag", index: None }));
        limit.dt
    };
    // a third of rho C A u on each corner, and C dt / m at most 1 for what is between a node and the world
    let slope = 1000.0 * 1.17 * 0.5 * 100.0;
    assert!((bound(false) / (0.1 / (slope / 3.0)) - 1.0).abs() < 1e-9, "{}", bound(false));
    assert!(bound(true) < 0.3 / slope, "{}", bound(true));
}

/// The bound holds: at it nothing grows that drags in a medium as thick as it may be.
#[test]
fn the_step_is_bounded_by_drag_where_it_is_the_stiffest_there_is() {
    let mut net = Net::rope(1.0, 4, Material { axial_stiffness: 1.0, mass_per_length: 1e-3, damping_ratio: 0.0 });
    let free = step_limit(&net.build()).dt;
    let mut air = still(vec![Some(ROPE)]);
    (air.medium, air.wind) = (Medium::uniform(1000.0, 1e-3), Wind::uniform(DVec3::Z, 10.0));
    air.fastest = 10.0;
    net.parts.environment = Environment { air: Some(air), ..Environment::default() };
    let system = net.build();
    let bound = step_limit(&system).dt;
    assert!(bound < 0.1 * free, "{bound} s, {free} s without");
    let schedule = Schedule::new(0.2, 0.01, 0.99 * bound);
    let mut film = Film::default();
    simulate(&system, &net.state, &schedule, 1, &mut film);
    let fastest = film.frames.iter().flat_map(|frame| &frame.2).map(|v| v.z).fold(0.0, f64::max);
    assert!(fastest <= 10.0 * 1.0001, "{fastest}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_net_that_tears_in_a_storm_closes_too(mut net in nets::any_net_of_any_law(0.2)) {
        if net.parts.mass.len() > 3 {
            nets::in_a_storm(&mut net);
            let system = net.build();
            let schedule = Schedule::new(0.03, 0.01, 0.02 * step_limit(&system).dt);
            let outcome = simulate(&system, &net.state, &schedule, 1, &mut Film::default());
            prop_assert!(outcome.balance.closure() < 5e-4, "{}, {} breaks", outcome.balance.closure(), outcome.breaks.len());
        }
    }

    #[test]
    fn any_net_in_a_storm_closes_its_energy_better_with_a_smaller_step(mut net in nets::any_net(0.2)) {
        if net.parts.mass.len() > 3 {
            nets::in_a_storm(&mut net);
            let system = net.build();
            let closure = |share: f64| {
                let schedule = Schedule::new(0.03, 0.01, share * step_limit(&system).dt);
                simulate(&system, &net.state, &schedule, 1, &mut Film::default()).balance.closure()
            };
            let (coarse, fine) = (closure(0.2), closure(0.02));
            prop_assert!(fine < 2e-4 && fine < (0.3 * coarse).max(2e-5), "{} and {}", coarse, fine);
        }
    }
}

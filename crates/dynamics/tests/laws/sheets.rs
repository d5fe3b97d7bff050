//! Sheets and bending ropes in motion: the laws that hold for any.

use crate::nets::{self, Film, Material, Net};
use glam::{DQuat, DVec2, DVec3};
use netcast_dynamics::channel::Channel;
use netcast_dynamics::forces::bending::Bending;
use netcast_dynamics::forces::hinge::Hinge;
use netcast_dynamics::forces::membrane::{Fabric, Membrane};
use netcast_dynamics::forces::tension_field::Elasticity;
use netcast_dynamics::simulate::{Outcome, Schedule, simulate};
use netcast_dynamics::step_size::{Stiff, step_limit};

/// A square sheet of `n` by `n` cells of two triangles each and side 1 m, crumpled a little, thrown and spun; its
/// corners carry masses on ropes. It is a plate where it `compresses`.
fn sheet(n: usize, compresses: bool, damping_time: f64) -> Net {
    let (thickness, density, modulus) = (1e-3, 1000.0, 1e7);
    let fabric = Fabric { elasticity: Elasticity::isotropic(modulus, 0.3), thickness, compresses, damping_time };
    let mut net = Net::default();
    let id = |i: usize, j: usize| i * (n + 1) + j;
    let flat = |i: usize, j: usize| DVec2::new(i as f64, j as f64) / n as f64;
    for i in 0..=n {
        for j in 0..=n {
            let at = flat(i, j);
            let ripple = 0.02 * libm::sin(9.0 * at.x) * libm::cos(7.0 * at.y);
            let place = DVec3::new(0.9 * at.x, at.y, ripple);
            net.node(place, DVec3::new(1.0 - 6.0 * at.y, 6.0 * at.x, 2.0));
        }
    }
    let mut triangle = |corners: [(usize, usize); 3]| {
        let nodes = corners.map(|(i, j)| id(i, j));
        let rest = corners.map(|(i, j)| flat(i, j));
        net.parts.membranes.push(Membrane::new(nodes, rest, &fabric).unwrap());
        let area = 0.5 * (rest[1] - rest[0]).perp_dot(rest[2] - rest[0]);
        for node in nodes {
            net.parts.mass[node] += density * thickness * area / 3.0;
        }
    };
    for i in 0..n {
        for j in 0..n {
            triangle([(i, j), (i + 1, j), (i + 1, j + 1)]);
            triangle([(i, j), (i + 1, j + 1), (i, j + 1)]);
        }
    }
    let rigidity = modulus * thickness * thickness * thickness / (12.0 * 0.91);
    for i in 0..n {
        for j in 0..n {
            let hinge = [(i, j), (i + 1, j + 1), (i, j + 1), (i + 1, j)];
            let rest = hinge.map(|(i, j)| flat(i, j));
            net.parts.hinges.push(Hinge::new(hinge.map(|(i, j)| id(i, j)), rest, rigidity, damping_time).unwrap());
        }
    }
    let rope = Material { axial_stiffness: 5e3, mass_per_length: 0.02, damping_ratio: 0.05 };
    for (i, j) in [(0, 0), (n, 0), (n, n), (0, n)] {
        let corner = id(i, j);
        let away = (2.0 * flat(i, j) - DVec2::ONE).extend(0.0);
        let mass = net.node(net.state.position[corner] + 0.2 * away, net.state.velocity[corner] + 3.0 * away);
        net.segment(corner, mass, 0.3, rope);
        net.parts.mass[mass] += 0.2;
    }
    net
}

fn fly(net: &Net, share: f64, threads: usize) -> (Film, Outcome) {
    let system = net.build();
    let mut film = Film::default();
    let schedule = Schedule::new(0.2, 0.02, share * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, threads, &mut film);
    (film, outcome)
}

#[test]
fn a_thrown_sheet_keeps_momentum_and_its_energy_balance_closes() {
    for (compresses, damping_time) in [(false, 0.0), (false, 2e-5), (true, 0.0), (true, 2e-5)] {
        let net = sheet(6, compresses, damping_time);
        let mass = net.build().mass().to_vec();
        let (film, outcome) = fly(&net, 0.2, 1);
        let momenta = |(_, x, v): &(f64, Vec<DVec3>, Vec<DVec3>)| {
            let nodes = x.iter().zip(v).zip(&mass);
            nodes.fold((DVec3::ZERO, DVec3::ZERO), |(p, l), ((x, v), &m)| (p + m * *v, l + x.cross(m * *v)))
        };
        let (p0, l0) = momenta(&film.frames[0]);
        let (p, l) = momenta(film.frames.last().unwrap());
        assert!(
            (p - p0).length() < 1e-10 * p0.length() && (l - l0).length() < 1e-6 * l0.length(),
            "{p0} {p}, {l0} {l}"
        );
        let closure = outcome.balance.closure();
        println!("compresses {compresses}, damping {damping_time} s: closure {closure:.2e}, {:?}", outcome.ledger);
        assert!(outcome.stopped.is_none() && closure < 2e-3, "{closure}");
        assert_eq!(outcome.ledger[Channel::SheetDamping] > 0.0, damping_time > 0.0);
    }
}

#[test]
fn at_the_limit_of_the_step_a_sheet_does_not_come_apart_and_well_beyond_it_does() {
    let mut net = sheet(6, true, 0.0);
    for v in &mut net.state.velocity {
        *v *= 0.01;
    }
    let (_, outcome) = fly(&net, 0.95, 1);
    assert!(outcome.stopped.is_none(), "{:?}", outcome.stopped);
    let (_, outcome) = fly(&net, 3.0, 1);
    assert!(outcome.stopped.is_some());
}

#[test]
fn threads_do_not_change_a_bit_of_a_sheet() {
    // enough elements that threads share them
    let mut net = sheet(40, false, 1e-5);
    net.parts.environment = nets::surroundings();
    let system = net.build();
    assert!(system.membranes().len() > 2000);
    let run = |threads: usize| {
        let engine = netcast_dynamics::time::step::Engine { threads, least_slots_for_threads: 0, ..Default::default() };
        let dt = 0.3 * step_limit(&system).dt;
        let mut stepper = netcast_dynamics::time::step::Stepper::on(engine, &system, &net.state, dt);
        let sums: Vec<_> = (0..60).map(|_| stepper.step()).collect();
        (sums, stepper.motion())
    };
    let one = run(1);
    for threads in [2, 3, 8] {
        assert!(run(threads) == one, "{threads} threads");
    }
}

#[test]
fn a_bending_rope_closes_its_balance_and_sets_its_step() {
    let rope = Material { axial_stiffness: 2e3, mass_per_length: 0.1, damping_ratio: 0.02 };
    let mut net = Net::rope(1.0, 20, rope);
    for node in 1..20 {
        net.parts.bends.push(Bending::new([node - 1, node, node + 1], [0.05; 2], 4.0, 1e-5).unwrap());
    }
    for node in 0..=20 {
        net.state.velocity[node] = 10.0 * libm::sin(4.0 * net.state.position[node].x) * DVec3::Z;
    }
    let limit = step_limit(&net.build());
    assert!(
        matches!(limit.stiffest, Some(Stiff::Effect { name: "bending", .. })) && limit.elsewhere > limit.dt,
        "{limit:?}"
    );
    let (_, outcome) = fly(&net, 0.3, 1);
    let closure = outcome.balance.closure();
    assert!(closure < 1e-3 && outcome.ledger[Channel::RopeDamping] > 0.0, "{closure}");
}

#[test]
fn a_body_carries_a_patch_of_a_sheet() {
    let mut net = sheet(6, true, 1e-5);
    let id = |i: usize, j: usize| i * 7 + j;
    let patch: Vec<usize> = (2..5).flat_map(|i| (2..5).map(move |j| id(i, j))).collect();
    let middle = net.state.position[id(3, 3)];
    let mass = 0.3 + patch.iter().map(|&node| net.parts.mass[node]).sum::<f64>();
    let inertia = DVec3::splat(mass * 0.03);
    net.body(middle, net.state.velocity[id(3, 3)], mass, inertia, (DQuat::IDENTITY, DVec3::Z * 6.0), &patch);
    let (film, outcome) = fly(&net, 0.2, 1);
    assert!(outcome.stopped.is_none() && outcome.balance.closure() < 2e-3, "{}", outcome.balance.closure());
    // nodes of the patch keep their distances
    let span = |frame: usize| (film.frames[frame].1[id(2, 2)] - film.frames[frame].1[id(4, 4)]).length();
    assert!((span(0) - span(film.frames.len() - 1)).abs() < 1e-12);
}

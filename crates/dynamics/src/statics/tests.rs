use super::*;
use crate::body::Rotation;
use crate::body::Tie;
use crate::drive::Drive;
use crate::launcher::{Launcher, Means};
use glam::DQuat;

const TIGHT: Accuracy = Accuracy { tolerance: 1e-10, max_iterations: 1_000_000 };

fn rope(ends: [usize; 2], rest_length: f64, stiffness: f64) -> Segment {
    Segment { ends, rest_length, stiffness, damping: 0.3, group: 0, breaking: Breaking::NEVER }
}

fn load(node: usize, force: DVec3) -> Load {
    Load { node, force, ramp: 0.0 }
}

/// Nodes at `position` of which those with mass 0 are held, and ropes between them, under a gravity of 10 m/s^2.
fn net(mass: &[f64], position: &[DVec3], segments: Vec<Segment>) -> (SystemParts, State) {
    let parts = SystemParts {
        mass: mass.to_vec(),
        held: mass.iter().map(|&mass| mass == 0.0).collect(),
        tractor: vec![false; mass.len()],
        segments,
        laws: vec![Law::Linear],
        environment: Environment { gravity: DVec3::new(0.0, 0.0, -10.0), mass_damping: 0.5, ..Environment::default() },
        ..SystemParts::default()
    };
    let velocity = vec![DVec3::ZERO; mass.len()];
    (parts, State { position: position.to_vec(), velocity, ..State::default() })
}

fn rest(parts: SystemParts, state: &State) -> Relaxed {
    relax(&parts.build().unwrap(), state, &TIGHT, 1, &mut |_| true)
}

#[test]
fn a_weight_on_a_rope_stretches_it_by_what_it_weighs() {
    // slack and beside its place at first: it comes to hang below, 3 kg * 10 m/s^2 / (600 N/m) lower than unloaded
    let (parts, state) = net(&[0.0, 3.0], &[DVec3::ZERO, 0.7 * DVec3::X], vec![rope([0, 1], 1.0, 600.0)]);
    let found = rest(parts, &state);
    assert_eq!(found.stopped, None);
    assert!((found.state.position[1] - DVec3::new(0.0, 0.0, -1.05)).length() < 1e-6, "{:?}", found.state.position);
    assert!((found.residual.largest - 30.0).abs() < 1e-8 && found.state.velocity == [DVec3::ZERO; 2]);
}

#[test]
fn loads_in_balance_need_no_support() {
    let (mut parts, state) = net(&[1.0, 1.0], &[DVec3::ZERO, DVec3::X], vec![rope([0, 1], 1.0, 200.0)]);
    parts.environment.gravity = DVec3::ZERO;
    parts.loads = vec![load(0, -8.0 * DVec3::X), load(1, 8.0 * DVec3::X)];
    assert_eq!(unsupported(&parts.clone().build().unwrap(), &state), None);
    let found = rest(parts, &state);
    assert!((found.state.position[1] - found.state.position[0] - 1.04 * DVec3::X).length() < 1e-9);
}

#[test]
fn what_nothing_holds_is_found_with_what_it_bears() {
    let ropes = vec![rope([0, 1], 1.0, 600.0), rope([2, 3], 1.0, 600.0)];
    let (mut parts, state) = net(&[0.0, 1.0, 2.0, 2.0], &[DVec3::ZERO; 4], ropes);
    parts.loads = vec![load(3, 10.0 * DVec3::Z)];
    let system = parts.build().unwrap();
    assert_eq!(unsupported(&system, &state), Some(Unsupported { node: 2, load: 30.0 }));
    let few = Accuracy { max_iterations: 3000, ..TIGHT };
    let found = relax(&system, &state, &few, 1, &mut |_| true);
    assert_eq!(found.stopped, Some(StaticsError::NotConverged { iterations: 3000 }));
    assert!(found.residual.force > 9.9 && found.residual.relative() > 0.3);
    let stopped = relax(&system, &state, &few, 1, &mut |so_far| so_far.iterations < 2000).stopped;
    assert_eq!(stopped, Some(StaticsError::Interrupted { iterations: 2000 }));
}

#[test]
fn a_body_hangs_with_its_centre_below_the_point_that_it_hangs_by() {
    // tied off its centre by one rope, and started upside down but for a little
    let (mut parts, mut state) =
        net(&[0.0, 2.0, 0.0], &[DVec3::ZERO, DVec3::Z, DVec3::Z], vec![rope([0, 2], 1.0, 4000.0)]);
    parts.held[2] = false;
    let arm = DVec3::new(0.3, 0.0, 0.4);
    parts.bodies = vec![Body { centre: 1, inertia: DVec3::new(1.0, 2.0, 3.0), ties: vec![Tie { node: 2, arm }] }];
    state.rotation = vec![Rotation { orientation: DQuat::from_xyzw(0.6, 0.0, 0.0, 0.8), angular_momentum: DVec3::X }];
    let found = rest(parts, &state);
    assert_eq!(found.stopped, None);
    let [_, centre, tie] = found.state.position[..] else { unreachable!() };
    assert!((tie - DVec3::new(0.0, 0.0, -1.005)).length() < 1e-6, "{tie}");
    assert!((centre - DVec3::new(0.0, 0.0, -1.505)).length() < 1e-6, "{centre}");
}

#[test]
fn what_is_thrown_later_is_held_until_then() {
    let ropes = vec![rope([0, 1], 1.0, 600.0), rope([1, 2], 1.0, 600.0)];
    let (parts, mut state) = net(&[1.0, 3.0, 1.0], &[DVec3::ZERO, DVec3::X, DVec3::X], ropes);
    state.velocity[0] = 5.0 * DVec3::Z;
    let found = rest(parts, &state);
    assert_eq!((found.stopped, found.state.position[0]), (None, DVec3::ZERO));
    assert!((found.state.position[1].z + 1.0 + 40.0 / 600.0).abs() < 1e-6);
}

#[test]
fn a_body_in_its_launcher_keeps_its_attitude() {
    // from a tie beside its middle hangs a weight: it would turn if it could
    let ropes = vec![rope([1, 2], 1.0, 600.0)];
    let (mut parts, mut state) = net(&[2.0, 0.0, 3.0], &[DVec3::Z, DVec3::ZERO, DVec3::ZERO], ropes);
    parts.held[1] = false;
    let tie = Tie { node: 1, arm: 0.5 * DVec3::X };
    parts.bodies = vec![Body { centre: 0, inertia: DVec3::ONE, ties: vec![tie] }];
    parts.launchers = vec![Launcher { node: 0, at: 1.0, by: Means::Velocity(DVec3::X) }];
    let attitude = Rotation { orientation: DQuat::IDENTITY, angular_momentum: DVec3::ZERO };
    state.rotation = vec![attitude];
    let found = rest(parts, &state);
    assert_eq!((found.stopped, &found.state.rotation[..]), (None, &[attitude][..]));
    assert!((found.state.position[2] - DVec3::new(0.5, 0.0, -0.05)).length() < 1e-6);
}

#[test]
fn driven_nodes_wait_where_their_paths_begin() {
    let (mut parts, state) = net(&[0.0, 3.0], &[DVec3::X, 0.7 * DVec3::X], vec![rope([0, 1], 1.0, 600.0)]);
    parts.drives = vec![Drive { node: 0, path: vec![(0.0, DVec3::Y), (1.0, DVec3::X)] }];
    let found = rest(parts, &state);
    assert!((found.state.position[1] - DVec3::new(0.0, 1.0, -1.05)).length() < 1e-6);
}

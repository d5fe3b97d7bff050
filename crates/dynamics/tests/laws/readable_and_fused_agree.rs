//! The fused step gives the bits of the readable one, on any net, by any law of its ropes, in vectors of any width and on any number of threads.

use crate::nets;
use glam::{DQuat, DVec2, DVec3};
use netcast_dynamics::drive::Drive;
use netcast_dynamics::forces::bending::Bending;
use netcast_dynamics::forces::hinge::Hinge;
use netcast_dynamics::forces::load::Load;
use netcast_dynamics::forces::membrane::{Fabric, Membrane};
use netcast_dynamics::forces::tension_field::Elasticity;
use netcast_dynamics::launcher::{ForceCurve, Launcher, Means, Push, Tube};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::time::readable::Readable;
use netcast_dynamics::time::step::{Engine, Stepper, Vectors};
use proptest::prelude::*;

/// Every width of vectors on one thread, and several threads however small the net.
fn engines() -> Vec<Engine> {
    let widths = Vectors::ALL.map(|vectors| Engine { vectors, ..Engine::default() });
    let threads = [2, 3, 8].map(|threads| Engine { threads, least_slots_for_threads: 0, ..Engine::default() });
    [&widths[..], &threads[..]].concat()
}

/// Returns how many segments broke on the way.
fn agree(net: nets::Net, steps: usize) -> Result<usize, TestCaseError> {
    let system = net.build();
    let dt = 0.4 * step_limit(&system).dt.min(1e-3);
    let mut readable = Readable::new(&system, &net.state, dt);
    let mut all: Vec<Stepper> =
        engines().into_iter().map(|engine| Stepper::on(engine, &system, &net.state, dt)).collect();
    for step in 0..steps {
        readable.step();
        for fused in &mut all {
            let sums = fused.step();
            if step > 0 {
                prop_assert_eq!(sums.work, readable.work);
            }
            for node in 0..readable.position.len() {
                prop_assert_eq!(fused.position(node), readable.position[node], "step {}, node {}", step, node);
                prop_assert_eq!(fused.half_step_velocity(node), readable.velocity[node]);
            }
            let failing: Vec<usize> = fused.failing().map(|failure| failure.segment).collect();
            prop_assert!(failing.len() == readable.failing.len());
            prop_assert!(failing.iter().all(|segment| readable.failing.contains(segment)));
            prop_assert_eq!(&fused.motion().ropes, &readable.ropes, "step {}", step);
            for (segment, pull) in readable.pulls.iter().enumerate() {
                prop_assert_eq!(fused.tension(segment), pull.tension);
            }
        }
    }
    Ok(readable.ropes.broken.iter().filter(|broken| **broken).count())
}

/// A body between the last two nodes, a load on it and on a knot, a node that is driven, and elements between knots.
fn attach(net: &mut nets::Net, driven: usize) {
    let nodes = net.parts.mass.len();
    let ties = [nodes - 1, nodes - 2];
    if ties.contains(&driven) {
        return;
    }
    let middle = 0.5 * (net.state.position[ties[0]] + net.state.position[ties[1]]);
    let inertia = DVec3::new(0.02, 0.03, 0.04);
    let centre = net.body(middle, 3.0 * DVec3::X, 0.5, inertia, (DQuat::IDENTITY, DVec3::new(5.0, -3.0, 20.0)), &ties);
    net.parts.loads = [centre, driven, 1]
        .map(|node| Load { node, force: DVec3::new(1.0, -2.0, 0.5), ramp: 1e-4 * node as f64 })
        .into();
    let flat = [DVec2::ZERO, DVec2::X, DVec2::new(0.4, 0.8), DVec2::new(0.5, -0.7)];
    let elasticity = Elasticity::isotropic(1e6, 0.3);
    let fabric = Fabric { elasticity, thickness: 1e-3, compresses: false, damping_time: 1e-4 };
    net.parts.bends = vec![Bending::new([0, 1, 2], [0.3, 0.4], 1.0, 1e-4).unwrap()];
    net.parts.membranes = vec![Membrane::new([2, 0, 1], [flat[0], flat[1], flat[2]], &fabric).unwrap()];
    net.parts.hinges = vec![Hinge::new([0, 1, 2, centre], flat, 0.5, 1e-4).unwrap()];
    let from = net.state.position[driven];
    net.parts.drives = vec![Drive { node: driven, path: vec![(0.0, from), (0.01, from + DVec3::new(0.1, 0.2, 0.0))] }];
    launch(net, centre, (0..nodes).find(|node| *node != driven && !ties.contains(node)));
}

/// The body from a tube, and another node that is let go.
fn launch(net: &mut nets::Net, body: usize, other: Option<usize>) {
    let push = Push::OverStroke(ForceCurve(vec![(0.0, 3e3), (0.01, 2e3)]));
    let tube = Tube { breech: net.state.position[body], direction: DVec3::Y, stroke: 0.01, push };
    net.state.velocity[body] = DVec3::ZERO;
    net.parts.launchers = vec![Launcher { node: body, at: 1e-3, by: Means::Tube(tube) }];
    if let Some(node) = other {
        net.state.velocity[node] = DVec3::ZERO;
        net.parts.launchers.push(Launcher { node, at: 2e-3, by: Means::Velocity(DVec3::new(3.0, -4.0, 10.0)) });
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn they_agree(mut net in nets::any_net(0.05), held in 0usize..3, surrounded: bool, attached: bool, stormy: bool, landed: bool) {
        net.parts.held[held] = true;
        if attached {
            attach(&mut net, held);
        }
        if surrounded {
            net.parts.environment = nets::surroundings();
        }
        if stormy && net.parts.mass.len() > 3 {
            nets::in_a_storm(&mut net);
        }
        if landed {
            nets::on_the_ground_of_a_moon(&mut net);
        }
        prop_assert_eq!(agree(net, 150)?, 0);
    }

    #[test]
    fn they_agree_by_any_law(
        mut net in nets::any_net_of_any_law(0.05),
        held in 0usize..3,
        surrounded: bool,
        attached: bool,
        stiff: bool,
        stormy: bool,
        landed: bool,
    ) {
        net.parts.held[held] = true;
        if attached {
            attach(&mut net, held);
        }
        if stiff {
            net.stiffen(0.5);
        }
        if surrounded {
            net.parts.environment = nets::surroundings();
        }
        if stormy && net.parts.mass.len() > 3 {
            nets::in_a_storm(&mut net);
        }
        if landed {
            nets::on_the_ground_of_a_moon(&mut net);
        }
        agree(net, 150)?;
    }
}

//! The fused step gives the bits of the readable one, on any net, in vectors of any width and on any number of threads.

mod nets;

use netcast_dynamics::time::readable::Readable;
use netcast_dynamics::time::step::{Engine, Stepper, Vectors};
use netcast_dynamics::time::step_size::step_limit;
use proptest::prelude::*;

/// Every width of vectors on one thread, and several threads however small the net.
fn engines() -> Vec<Engine> {
    let widths = Vectors::ALL.map(|vectors| Engine { vectors, ..Engine::default() });
    let threads = [2, 3, 8].map(|threads| Engine { threads, least_slots_for_threads: 0, ..Engine::default() });
    [&widths[..], &threads[..]].concat()
}

fn agree(net: nets::Net, steps: usize) -> Result<(), TestCaseError> {
    let system = net.build();
    let dt = 0.4 * step_limit(&system).dt.min(1e-3);
    let mut readable = Readable::new(&system, &net.state, dt);
    let mut all: Vec<Stepper> =
        engines().into_iter().map(|engine| Stepper::on(engine, &system, &net.state, dt)).collect();
    for step in 0..steps {
        readable.step();
        for fused in &mut all {
            let work = fused.step().rope_work;
            if step > 0 {
                prop_assert_eq!(work, readable.rope_work);
            }
            for node in 0..readable.position.len() {
                prop_assert_eq!(fused.position(node), readable.position[node], "step {}, node {}", step, node);
                prop_assert_eq!(fused.half_step_velocity(node), readable.velocity[node]);
            }
            for (segment, pull) in readable.pulls.iter().enumerate() {
                prop_assert_eq!(fused.tension(segment), pull.tension);
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn they_agree(mut net in nets::any_net(0.05), held in 0usize..3, surrounded: bool) {
        net.parts.held[held] = true;
        if surrounded {
            net.parts.environment = nets::surroundings();
        }
        agree(net, 150)?;
    }
}

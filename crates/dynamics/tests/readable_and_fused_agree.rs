//! The fused step gives the bits of the readable one, on any net.

mod nets;

use netcast_dynamics::time::readable::Readable;
use netcast_dynamics::time::step::Stepper;
use netcast_dynamics::time::step_size::step_limit;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn they_agree(mut net in nets::any_net(0.05), held in 0usize..3, surrounded: bool) {
        net.parts.held[held] = true;
        if surrounded {
            net.parts.environment = nets::surroundings();
        }
        let system = net.build();
        let dt = 0.4 * step_limit(&system).dt.min(1e-3);
        let mut readable = Readable::new(&system, &net.state, dt);
        let mut fused = Stepper::new(&system, &net.state, dt, 1);
        for step in 0..300 {
            readable.step();
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
}

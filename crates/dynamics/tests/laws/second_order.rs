//! The scheme is second order where the solution is smooth: halving the step quarters the error.

use crate::nets::{Film, Material, Net};
use glam::DVec3;
use netcast_dynamics::simulate::{Schedule, simulate};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::Environment;

/// A rope that hangs between two held ends, taut under pretension, plucked, with damping in the rope and by mass: all
/// terms, never slack.
fn end_of_run(dt_share: f64, count: u64) -> Vec<DVec3> {
    let mut net = Net::rope(1.0, 8, Material { axial_stiffness: 1000.0, mass_per_length: 0.1, damping_ratio: 0.1 });
    for x in &mut net.state.position {
        let u = x.x;
        *x = DVec3::new(1.1 * u, 0.05 * libm::sin(3.0 * u), 0.08 * u * (1.0 - u));
    }
    (net.parts.held[0], net.parts.held[8]) = (true, true);
    net.parts.environment =
        Environment { gravity: DVec3::new(0.0, 0.0, -9.81), mass_damping: 2.0, ..Environment::default() };
    let system = net.build();
    let duration = 40.0 * 0.5 * step_limit(&system).dt;
    let schedule = Schedule::new(duration, duration, dt_share * step_limit(&system).dt);
    assert_eq!(schedule.count, count);
    let mut film = Film::default();
    simulate(&system, &net.state, &schedule, 1, &mut film);
    film.frames.pop().expect("the end is recorded").1
}

#[test]
fn halving_the_step_quarters_the_error() {
    let best = end_of_run(0.5 / 64.0, 40 * 64);
    let error = |halvings: u64| {
        let end = end_of_run(0.5 / (1 << halvings) as f64, 40 << halvings);
        end.iter().zip(&best).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max)
    };
    let errors = [error(0), error(1), error(2), error(3)];
    println!("errors, m: {errors:?}");
    for pair in errors.windows(2).skip(1) {
        let ratio = pair[0] / pair[1];
        assert!((3.6..4.5).contains(&ratio), "ratio {ratio}, errors {errors:?}");
    }
}

//! The bound on the step holds, and where it is exact it is reached.

use crate::nets::{self, Film, Material, Net};
use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::simulate::{Schedule, StepError, simulate};
use netcast_dynamics::step_size::{Stiff, step_limit};
use proptest::prelude::*;

/// A taut rope between held ends, disturbed in its highest mode; the largest speed after `steps` steps of `share` of
/// the limit.
fn speed_after(share: f64, steps: f64, damping_ratio: f64) -> f64 {
    let mut net = Net::rope(1.0, 20, Material { axial_stiffness: 1e4, mass_per_length: 0.01, damping_ratio });
    for x in &mut net.state.position {
        x.x *= 1.05;
    }
    for i in 1..20 {
        net.state.velocity[i].x = if i % 2 == 0 { 1e-6 } else { -1e-6 };
    }
    (net.parts.held[0], net.parts.held[20]) = (true, true);
    let system = net.build();
    let dt = share * step_limit(&system).dt;
    let mut film = Film::default();
    simulate(&system, &net.state, &Schedule::steps(dt, steps as u64), 1, &mut film);
    film.frames.last().expect("recorded").2.iter().map(|v| v.length()).fold(0.0, f64::max)
}

#[test]
fn inside_a_rope_the_limit_is_the_time_a_wave_takes_through_a_segment() {
    let net = Net::rope(2.0, 20, nets::paper_rope(0.0));
    let limit = step_limit(&net.build());
    // wave speed sqrt(E/rho) = 6493 m/s
    assert!((limit.dt - 0.1 / (78e9f64 / 1850.0).sqrt()).abs() < 1e-12);
}

#[test]
fn just_below_the_limit_nothing_grows_and_just_above_it_explodes() {
    for damping_ratio in [0.0, 0.02, 0.1, 0.5] {
        let (below, above) = (speed_after(0.98, 400.0, damping_ratio), speed_after(1.05, 400.0, damping_ratio));
        assert!(below < 1e-5, "ratio {damping_ratio}: {below} m/s below the limit");
        assert!(above > 1e-3, "ratio {damping_ratio}: {above} m/s above the limit");
    }
}

#[test]
fn a_stiff_segment_between_light_nodes_is_named() {
    let mut net = Net::rope(2.0, 20, nets::paper_rope(0.05));
    net.parts.segments[7].stiffness *= 4.0;
    assert_eq!(step_limit(&net.build()).stiffest, Some(Stiff::Segment(7)));
}

#[test]
fn a_step_far_beyond_the_limit_stops_the_run_and_says_where() {
    let mut net = Net::rope(1.0, 10, nets::paper_rope(0.0));
    net.state.velocity[10] = DVec3::new(70.0, 0.0, 0.0);
    let system = net.build();
    let dt = 3.0 * step_limit(&system).dt;
    let outcome = simulate(&system, &net.state, &Schedule::steps(dt, (0.2 / dt) as u64), 1, &mut Film::default());
    let stopped = outcome.stopped.expect("it must not run to the end");
    assert!(matches!(stopped, StepError::Diverged { .. } | StepError::NotFinite { .. }), "{stopped}");
    assert!(outcome.end_time < 0.2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// At the full limit any damped net stays bounded: the bound is on the safe side whatever the shape, and the law.
    #[test]
    fn the_limit_is_safe_for_any_net(net in prop_oneof![nets::any_net(0.3), nets::any_net_of_any_law(0.3)]) {
        let system = net.build();
        let limit = step_limit(&system).dt;
        prop_assume!(limit.is_finite());
        let outcome = simulate(&system, &net.state, &Schedule::steps(0.999 * limit, 500), 1, &mut Film::default());
        prop_assert!(outcome.stopped.is_none());
        let (end, start) = (outcome.ledger, outcome.balance.initial());
        prop_assert!(end[Channel::Kinetic] + end[Channel::Elastic] <= 3.0 * start, "from {start} J to {end:?}");
    }
}

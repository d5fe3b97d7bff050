//! Laws of ropes in motion: their energy balance, a mass on a relaxing rope, a frame of struts and ropes.

use crate::nets::{self, Film, Net};
use glam::DVec3;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::viscoelastic::Viscoelastic;
use netcast_dynamics::simulate::{Frame, Live, Observer, Schedule, simulate};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::{Environment, Segment};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

/// The largest closure of some nets whose segments all follow `law`, at this share of the stable step.
fn worst_closure(law: usize, share: f64) -> f64 {
    let mut runner = TestRunner::deterministic();
    let mut closure = || {
        let mut net = nets::any_net_of_any_law(0.02).new_tree(&mut runner).expect("a net").current();
        for segment in &mut net.parts.segments {
            (segment.group, segment.breaking) = (law, Breaking::NEVER);
        }
        let system = net.build();
        let schedule = Schedule::new(0.1, 1e-3, share * step_limit(&system).dt.min(1e-3));
        simulate(&system, &net.state, &schedule, 1, &mut Film::default()).balance.closure()
    };
    (0..12).map(|_| closure()).fold(0.0, f64::max)
}

#[test]
fn the_balance_closes_by_every_law_and_better_with_smaller_steps() {
    for law in 0..nets::laws().len() {
        let [coarse, fine] = [0.2, 0.05].map(|share| worst_closure(law, share));
        println!("{coarse:.1e} at a fifth of the stable step, {fine:.1e} at a twentieth, law {law}");
        // second order gives a sixteenth; the coarse run is checked less often, and its worst is missed more often
        assert!(coarse < 3e-3 && fine < 0.2 * coarse);
    }
}

/// A mass on a rope that relaxes is a linear system of third order. The second method: x' = v, m v' = m g - k x - q,
/// q' = k1 v - q/tau by Runge and Kutta's fourth-order scheme.
#[test]
fn a_mass_on_a_relaxing_rope_moves_as_its_differential_equations() {
    let (mass, k, ratio, tau, gravity, speed) = (2.0, 1e4, 1.5, 0.02, 10.0, 0.1);
    let mut net = Net::default();
    let (top, bottom) = (net.node(DVec3::ZERO, DVec3::ZERO), net.node(-DVec3::Z, -speed * DVec3::Z));
    net.parts.mass[bottom] = mass;
    net.parts.held[top] = true;
    // drawn with its weight on it, at rest for long
    let rest_length = 1.0 - mass * gravity / k;
    let (damping, breaking) = (0.0, Breaking::NEVER);
    net.parts.segments = vec![Segment { ends: [top, bottom], rest_length, stiffness: k, damping, group: 0, breaking }];
    net.parts.laws = vec![Law::Viscoelastic(Viscoelastic { ratio, relaxation_time: tau })];
    net.parts.environment = Environment { gravity: -gravity * DVec3::Z, mass_damping: 0.0, ..Environment::default() };
    let system = net.build();
    let mut film = Film::default();
    let outcome =
        simulate(&system, &net.state, &Schedule::new(0.2, 0.005, 0.02 * step_limit(&system).dt), 1, &mut film);

    let rate = |[x, v, q]: [f64; 3]| [v, gravity - (k * x + q) / mass, ratio * k * v - q / tau];
    let (mut state, steps, mut worst) = ([mass * gravity / k, speed, 0.0], 500, 0.0f64);
    let h = 0.005 / f64::from(steps);
    for (time, position, _) in &film.frames {
        let stretch = -position[bottom].z - rest_length;
        worst = worst.max((stretch - state[0]).abs());
        assert!(stretch > 0.0 && *time <= 0.2);
        for _ in 0..steps {
            let moved = |by: f64, rate: [f64; 3]| [0, 1, 2].map(|i| state[i] + by * rate[i]);
            let a = rate(state);
            let b = rate(moved(0.5 * h, a));
            let c = rate(moved(0.5 * h, b));
            let d = rate(moved(h, c));
            state = [0, 1, 2].map(|i| state[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
    }
    println!("largest difference {worst:.1e} m; closure {:.1e}", outcome.balance.closure());
    // of an amplitude of 1 mm
    assert!(worst < 1e-6 && outcome.balance.closure() < 1e-4);
}

/// Tensions at the last record.
#[derive(Default)]
struct Last(Vec<f64>);

impl Observer for Last {
    fn step(&mut self, _: &Live) {}
    fn record(&mut self, frame: &Frame) {
        self.0 = frame.tension.to_vec();
    }
}

/// Code_Aster's SSNL105 (V6.02.105): a unit square of bars with two diagonals that only pull, 1 kN along x at a corner. The
/// loaded diagonal pulls with 1414.2 N, one bar pushes with 1000 N, the other diagonal is slack.
#[test]
fn a_square_frame_of_struts_is_held_by_one_of_its_two_ropes() {
    let mut net = Net::default();
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
        net.node(DVec3::new(x, y, 0.0), DVec3::ZERO);
    }
    (net.parts.held[0], net.parts.held[1]) = (true, true);
    // the load is the weight of the two free corners, all but a thousandth of it at the third
    let (mass, light) = (1.0, 0.001);
    (net.parts.mass[2], net.parts.mass[3]) = (mass - light, light);
    net.parts.environment = Environment { gravity: 1000.0 * DVec3::X, mass_damping: 300.0, ..Environment::default() };
    net.parts.laws = vec![Law::Strut, Law::Linear];
    let side = 1.0;
    for (ends, rest_length, group) in [
        ([0, 1], side, 0),
        ([1, 2], side, 0),
        ([2, 3], side, 0),
        ([3, 0], side, 0),
        ([0, 2], 2f64.sqrt(), 1),
        ([1, 3], 2f64.sqrt(), 1),
    ] {
        let (stiffness, damping, breaking) = (1e9 / rest_length, 0.0, Breaking::NEVER);
        net.parts.segments.push(Segment { ends, rest_length, stiffness, damping, group, breaking });
    }
    let system = net.build();
    let mut last = Last::default();
    simulate(&system, &net.state, &Schedule::new(0.1, 0.1, 0.5 * step_limit(&system).dt), 1, &mut last);
    println!("{:?} N", last.0);
    let expected = [0.0, -1000.0, -1000.0 * light, 0.0, 1000.0 * 2f64.sqrt(), 0.0];
    for (found, expected) in last.0.iter().zip(expected) {
        assert!((found - expected).abs() < 0.01, "{found} N instead of {expected} N");
    }
}

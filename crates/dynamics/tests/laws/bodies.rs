//! Rigid bodies in nets: known motions, and laws that hold for any.

use crate::nets::{Film, Material, Net};
use glam::{DQuat, DVec3};
use netcast_dynamics::channel::Channel;
use netcast_dynamics::drive::Drive;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::load::Load;
use netcast_dynamics::simulate::{Frame, Live, Observer, Outcome, Schedule, simulate};
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::{Environment, System};
use proptest::prelude::*;

const GRAVITY: f64 = 9.81;

/// Keeps how the first body is turned at every record.
#[derive(Default)]
struct Turns(Vec<(f64, DQuat)>);

impl Observer for Turns {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        self.0.push((frame.time, frame.rotation[0].orientation));
    }
}

/// A body that turns about a fixed point, with its weight m g at an arm: inertia about the point, kg m^2.
fn pivoted(inertia: DVec3, weight: f64, arm: DVec3, turned: DQuat, spin: DVec3) -> (System, Net) {
    let mut net = Net::default();
    let at = net.node(turned * arm, DVec3::ZERO);
    let pivot = net.body(DVec3::ZERO, DVec3::ZERO, 1.0, inertia, (turned, spin), &[at]);
    net.parts.held[pivot] = true;
    net.parts.loads = vec![Load { node: at, force: DVec3::NEG_Z * weight, ramp: 0.0 }];
    (net.build(), net)
}

#[test]
fn a_rod_swings_from_the_horizontal_as_the_elliptic_integral_says() {
    // 1 kg, 1 m, pivoted at its end: period 1.93333 s
    let (system, net) =
        pivoted(DVec3::new(1e-4, 1.0 / 3.0, 1.0 / 3.0), GRAVITY, 0.5 * DVec3::X, DQuat::IDENTITY, DVec3::ZERO);
    let mut turns = Turns::default();
    let outcome = simulate(&system, &net.state, &Schedule::new(2.0, 1e-3, 1e-3), 1, &mut turns);
    // the rod is level again on its own side after one period, when it comes up highest
    let late = turns.0.iter().filter(|(time, _)| *time > 1.5);
    let top = late.max_by(|a, b| (a.1 * DVec3::X).z.total_cmp(&(b.1 * DVec3::X).z)).unwrap();
    assert!((top.0 - 1.93333).abs() < 2e-3, "period {} s", top.0);
    assert!(outcome.balance.closure() < 1e-5, "{}", outcome.balance.closure());
}

#[test]
fn a_fast_top_precesses_steadily() {
    // a symmetric top at 90 degrees, its axis level: precession m g l / (I3 w3), exactly so in steady motion
    let (inertia, spin, lever) = (DVec3::new(0.01, 0.01, 0.002), 300.0, 0.1);
    let rate = GRAVITY * lever / (inertia.z * spin);
    let level = DQuat::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let axis = level * DVec3::Z;
    let (system, net) = pivoted(inertia, GRAVITY, lever * DVec3::Z, level, spin * axis + rate * DVec3::Z);
    let mut turns = Turns::default();
    simulate(&system, &net.state, &Schedule::new(1.0, 1e-2, 1e-4), 1, &mut turns);
    for (time, orientation) in turns.0 {
        let now = orientation * DVec3::Z;
        let expected = DQuat::from_rotation_z(rate * time) * axis;
        assert!((now - expected).length() < 2e-3, "{now} instead of {expected} at {time} s");
    }
}

#[test]
fn a_body_without_a_torque_turns_freely_while_it_falls() {
    let mut net = Net::default();
    let spin = DVec3::new(0.1, 6.0, 0.3);
    let inertia = DVec3::new(1.0, 2.0, 3.0);
    let centre = net.body(DVec3::ZERO, DVec3::Z, 2.0, inertia, (DQuat::IDENTITY, spin), &[]);
    net.parts.environment =
        Environment { gravity: DVec3::NEG_Z * GRAVITY, mass_damping: 0.0, ..Environment::default() };
    let system = net.build();
    let mut film = Film::default();
    let outcome = simulate(&system, &net.state, &Schedule::new(1.0, 1.0, 1e-3), 1, &mut film);
    let height = film.frames.last().unwrap().1[centre].z;
    assert!((height - (1.0 - 0.5 * GRAVITY)).abs() < 1e-9, "{height}");
    // what the splitting makes of the rotational energy swings with the step and does not drift
    assert!(outcome.balance.closure() < 1e-5, "{}", outcome.balance.closure());
}

/// A body on a rope that is tied above its centre is a double pendulum. In its slow mode, of small swings:
///
/// ```text
/// | m a^2   m a l     |         | m g a   0     |       angles of rope and body; a the rope's length, l the arm
/// | m a l   m l^2 + I |  w^2  = | 0       m g l |
/// ```
#[test]
fn a_body_tied_above_its_centre_swings_below_its_rope_as_a_double_pendulum() {
    let (mass, inertia, rope, arm) = (1.5, 0.02, 0.6, 0.2);
    // (g - a w2)(g l - (l^2 + I/m) w2) = (a l) l w2^2, from the two lines over m a and m
    let r2 = arm * arm + inertia / mass;
    let (a, b, c) = (rope * r2 - rope * arm * arm, -GRAVITY * (r2 + rope * arm), GRAVITY * GRAVITY * arm);
    let w2 = (-b - (b * b - 4.0 * a * c).sqrt()) / (2.0 * a);
    let rope_angle = 0.01;
    let body_angle = rope_angle * (GRAVITY - rope * w2) / (arm * w2);

    let mut net = Net::default();
    let above = net.node(DVec3::ZERO, DVec3::ZERO);
    let along = |angle: f64| DVec3::new(libm::sin(angle), 0.0, -libm::cos(angle));
    let stiff = Material { axial_stiffness: 1e5, mass_per_length: 0.0, damping_ratio: 0.0 };
    let at_rest = rope / (1.0 + mass * GRAVITY / stiff.axial_stiffness);
    let tie = net.node(rope * along(rope_angle), DVec3::ZERO);
    net.segment(above, tie, at_rest, stiff);
    let centre = net.state.position[tie] + arm * along(body_angle);
    let turned = DQuat::from_rotation_y(-body_angle);
    let moments = DVec3::new(inertia, inertia, 0.5 * inertia);
    let body = net.body(centre, DVec3::ZERO, mass, moments, (turned, DVec3::ZERO), &[tie]);
    net.parts.held[above] = true;
    net.parts.environment =
        Environment { gravity: DVec3::NEG_Z * GRAVITY, mass_damping: 0.0, ..Environment::default() };
    let system = net.build();
    let period = std::f64::consts::TAU / w2.sqrt();
    let mut film = Film::default();
    let schedule = Schedule::new(period, period / 400.0, 0.1 * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut film);
    let swing = centre.x;
    for (time, x, _) in film.frames {
        let expected = swing * libm::cos(time * w2.sqrt());
        assert!((x[body].x - expected).abs() < 2e-3 * swing, "{} instead of {expected} at {time} s", x[body].x);
    }
    assert!(outcome.balance.closure() < 1e-4, "{}", outcome.balance.closure());
}

/// A rod of 2 kg and 1 m between two ropes, one on each end.
fn rod_between_ropes(velocity: DVec3, spin: DVec3) -> Net {
    let rope = Material { axial_stiffness: 2e4, mass_per_length: 0.05, damping_ratio: 0.05 };
    let mut net = Net::default();
    let ends = [DVec3::NEG_X, DVec3::X].map(|end| net.node(0.5 * end, DVec3::ZERO));
    for (end, away) in ends.into_iter().zip([DVec3::NEG_X, DVec3::X]) {
        let mut last = end;
        for piece in 1..=4 {
            let place = 0.5 * away + 0.1 * piece as f64 * (away + 0.3 * DVec3::Z);
            let next = net.node(place, velocity + 4.0 * away.cross(DVec3::Z));
            net.segment(last, next, 0.1, rope);
            last = next;
        }
        net.parts.mass[last] += 0.3;
    }
    let inertia = DVec3::new(1e-3, 2.0 / 12.0, 2.0 / 12.0);
    net.body(DVec3::ZERO, velocity, 2.0, inertia, (DQuat::IDENTITY, spin), &ends);
    net
}

/// Linear and angular momentum about the origin of everything.
fn momenta(system: &System, frame: &Frame) -> (DVec3, DVec3) {
    let nodes = frame.position.iter().zip(frame.velocity).zip(system.mass());
    let (p, l) = nodes.fold((DVec3::ZERO, DVec3::ZERO), |(p, l), ((x, v), m)| (p + *m * *v, l + x.cross(*m * *v)));
    (p, l + frame.rotation.iter().map(|rotation| rotation.angular_momentum).sum::<DVec3>())
}

/// Keeps the momenta of every record.
struct Momenta<'a>(&'a System, Vec<(DVec3, DVec3)>);

impl Observer for Momenta<'_> {
    fn step(&mut self, _: &Live) {}

    fn record(&mut self, frame: &Frame) {
        self.1.push(momenta(self.0, frame));
    }
}

fn fly(net: &Net, share: f64) -> (Vec<(DVec3, DVec3)>, Outcome) {
    let system = net.build();
    let mut kept = Momenta(&system, Vec::new());
    let schedule = Schedule::new(0.3, 0.01, share * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut kept);
    (kept.1, outcome)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_body_among_ropes_keeps_momentum_and_energy(
        (vx, vy, vz) in (-5.0..5.0, -5.0..5.0, -5.0..5.0),
        (wx, wy, wz) in (-9.0..9.0, -9.0..9.0, -9.0..9.0),
    ) {
        let net = rod_between_ropes(DVec3::new(vx, vy, vz), DVec3::new(wx, wy, wz));
        let (momenta, outcome) = fly(&net, 0.1);
        let (p0, l0) = momenta[0];
        for (p, l) in momenta {
            prop_assert!((p - p0).length() < 1e-9 * (1.0 + p0.length()), "momentum {p} instead of {p0}");
            // exact for positions, half-step velocities and forces; at the record it swings with the step squared
            prop_assert!((l - l0).length() < 2e-3 * (1.0 + l0.length()), "angular momentum {l} instead of {l0}");
        }
        prop_assert!(outcome.stopped.is_none());
        prop_assert!(outcome.balance.closure() < 3e-3, "{}", outcome.balance.closure());
    }

    #[test]
    fn at_the_limit_of_the_step_a_body_does_not_come_apart(wy in -9.0..9.0) {
        let mut net = rod_between_ropes(DVec3::ZERO, DVec3::new(0.0, wy, 1.0));
        // without damping, whose cost the limit counts too; and bars, for near the limit every slack-taut event gains
        // energy, with bodies or without
        for s in &mut net.parts.segments {
            s.damping = 0.0;
        }
        net.parts.laws = vec![Law::Strut];
        let (_, outcome) = fly(&net, 0.9);
        prop_assert!(outcome.stopped.is_none(), "{:?}", outcome.stopped);
    }
}

#[test]
fn what_drives_a_node_does_the_work_that_the_net_gains() {
    // the end of a level rope is lifted and swung about: weight, motion and stretch come from the drive alone
    let rope = Material { axial_stiffness: 2e4, mass_per_length: 0.05, damping_ratio: 0.1 };
    let mut net = Net::rope(1.0, 10, rope);
    net.parts.held[0] = true;
    let path = (0..=200).map(|i| {
        let angle = 0.02 * f64::from(i) * std::f64::consts::PI;
        (5e-3 * f64::from(i), DVec3::new(0.0, 0.2 * angle.sin(), 0.3 * (1.0 - angle.cos())))
    });
    net.parts.drives = vec![Drive { node: 0, path: path.collect() }];
    net.parts.environment =
        Environment { gravity: DVec3::NEG_Z * GRAVITY, mass_damping: 0.5, ..Environment::default() };
    let system = net.build();
    let schedule = Schedule::new(1.2, 0.01, 0.2 * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut Film::default());
    assert!(outcome.ledger[Channel::Drive] < -0.1, "the drive has done {} J", -outcome.ledger[Channel::Drive]);
    assert!(outcome.balance.closure() < 2e-3, "{}", outcome.balance.closure());
}

/// The pendulum of above, its centre of mass on a circle: the load that turns it does not know of that.
#[test]
fn a_body_whose_centre_is_driven_round_a_circle_swings_as_if_it_stayed() {
    let (_, mut net) =
        pivoted(DVec3::new(1e-4, 1.0 / 3.0, 1.0 / 3.0), GRAVITY, 0.5 * DVec3::X, DQuat::IDENTITY, DVec3::ZERO);
    let centre = net.parts.bodies[0].centre;
    let circle = |time: f64| {
        let (sin, cos) = libm::sincos(7.0 * time);
        DVec3::new(0.3 * (cos - 1.0), 0.2 * sin, 0.3 * sin)
    };
    let path = (0..=2000).map(|i| 1e-3 * f64::from(i)).map(|time| (time, circle(time))).collect();
    net.parts.drives = vec![Drive { node: centre, path }];
    let system = net.build();
    let (mut turns, mut film) = (Turns::default(), Film::default());
    let schedule = Schedule::new(2.0, 1e-3, 1e-3);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut turns);
    simulate(&system, &net.state, &schedule, 1, &mut film);
    let late = turns.0.iter().filter(|(time, _)| *time > 1.5);
    let top = late.max_by(|a, b| (a.1 * DVec3::X).z.total_cmp(&(b.1 * DVec3::X).z)).unwrap();
    assert!((top.0 - 1.93333).abs() < 2e-3, "period {} s", top.0);
    let tie = net.parts.bodies[0].ties[0];
    for ((time, position, _), (_, orientation)) in film.frames.iter().zip(&turns.0) {
        assert!((position[centre] - circle(*time)).length() < 1e-12);
        assert!((position[tie.node] - position[centre] - *orientation * tie.arm).length() < 1e-12);
    }
    // the load's work is the rotation's energy and the drive's share, F . dx of the centre
    println!("closure {:.1e}, drive {:.4} J", outcome.balance.closure(), outcome.ledger[Channel::Drive]);
    let by_hand = -GRAVITY * circle(2.0).z;
    assert!(
        (outcome.ledger[Channel::Drive] - by_hand).abs() < 1e-9,
        "{} and not {by_hand}",
        outcome.ledger[Channel::Drive]
    );
    assert!(outcome.balance.closure() < 1e-5, "{}", outcome.balance.closure());
}

/// Held or driven, a body that springs turn has a stable step: that of its inertia at their arms.
#[test]
fn a_body_that_cannot_give_way_bounds_the_step_by_its_turning() {
    let (inertia, arm, spring) = (0.02, 0.3, 1e4);
    let mut net = Net::default();
    let ends = [0.3, -0.3].map(|x| net.node(DVec3::new(x, 0.0, 0.0), DVec3::ZERO));
    let centre = net.body(DVec3::ZERO, DVec3::ZERO, 1.0, DVec3::splat(inertia), (DQuat::IDENTITY, DVec3::ZERO), &ends);
    net.parts.held[centre] = true;
    for end in ends {
        let far = net.node(net.state.position[end] + DVec3::Y, DVec3::ZERO);
        net.parts.held[far] = true;
        net.segment(
            end,
            far,
            0.9,
            Material { axial_stiffness: 0.9 * spring, mass_per_length: 0.0, damping_ratio: 0.0 },
        );
    }
    // 2/omega of two springs on the arms; the bound counts each twice, for what else may hang there
    let exact = 2.0 / (2.0 * spring * arm * arm / inertia).sqrt();
    for driven in [false, true] {
        net.parts.drives =
            if driven { vec![Drive { node: centre, path: vec![(0.0, DVec3::ZERO)] }] } else { Vec::new() };
        let limit = step_limit(&net.build()).dt;
        assert!((limit / exact - 0.5f64.sqrt()).abs() < 1e-9, "{limit} s, {exact} s");
    }
}

#[test]
fn a_load_that_is_brought_up_does_the_work_that_the_net_gains() {
    // a level rope between held ends, pulled down at its middle within 0.2 s
    let rope = Material { axial_stiffness: 2e4, mass_per_length: 0.05, damping_ratio: 0.1 };
    let mut net = Net::rope(1.0, 10, rope);
    (net.parts.held[0], net.parts.held[10]) = (true, true);
    net.parts.loads = vec![Load { node: 5, force: DVec3::new(3.0, 2.0, -100.0), ramp: 0.2 }];
    net.parts.environment.gravity = DVec3::NEG_Z * GRAVITY;
    let system = net.build();
    let schedule = Schedule::new(0.5, 0.01, 0.2 * step_limit(&system).dt);
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut Film::default());
    assert!(outcome.ledger[Channel::Load] < -1.0, "the load has done {} J", -outcome.ledger[Channel::Load]);
    assert!(outcome.balance.closure() < 2e-3, "{}", outcome.balance.closure());
}

//! Ropes that break: where, at which load, when, and what becomes of the energy.

use crate::nets::{self, Film, Net};
use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::simulate::{Frame, Live, Observer, Schedule, resume, simulate};
use netcast_dynamics::snapshot::Snapshot;
use netcast_dynamics::step_size::step_limit;
use proptest::prelude::*;

const LENGTH: f64 = 5.0;
const COUNT: usize = 250;
const SPEED: f64 = 71.0;
/// The rope's wave speed, m/s, and its tension behind the front, N: rho A c V.
const WAVE_SPEED: f64 = 6493.2;
const PLATEAU: f64 = 66_990.0;

/// The paper's rope, its first end held while all of it runs away from there: the front of its tension travels from that
/// end to the other. The segment `weak` bears `load`, N.
fn jerked(weak: usize, breaking: Breaking) -> Net {
    let mut net = Net::rope(LENGTH, COUNT, nets::paper_rope(0.05));
    net.state.velocity = vec![DVec3::X * SPEED; COUNT + 1];
    net.parts.held[0] = true;
    net.parts.segments[weak].breaking = breaking;
    net
}

/// Sees when a segment's tension first exceeds a load, and what it is then.
struct Watch {
    segment: usize,
    load: f64,
    first: Option<(f64, f64)>,
}

impl Observer for Watch {
    fn step(&mut self, live: &Live) {
        let tension = live.net.tension(self.segment);
        if tension > self.load {
            self.first.get_or_insert((live.tension_time, tension));
        }
    }
    fn record(&mut self, _: &Frame) {}
}

#[test]
fn a_jerked_rope_breaks_at_its_weak_segment_at_that_load() {
    let (segment_length, back) = (LENGTH / COUNT as f64, 2.0 * LENGTH / WAVE_SPEED);
    for (weak, share) in [(0, 0.4), (60, 0.5), (125, 0.5), (220, 0.6)] {
        let load = share * PLATEAU;
        let net = jerked(weak, Breaking { load, ..Breaking::NEVER });
        let system = net.build();
        let dt = 0.3 * step_limit(&system).dt;
        let schedule = Schedule::new(back, back / 50.0, dt);
        let outcome = simulate(&system, &net.state, &schedule, 1, &mut Film::default());

        let [only] = outcome.breaks[..] else { panic!("{:?}", outcome.breaks) };
        let (tension, closure) = (only.tension, outcome.balance.closure());
        let front = (weak as f64 + 0.5) * segment_length / WAVE_SPEED;
        println!(
            "{tension:.0} N at a load of {load:.0} N, {:.2e} s, front {front:.2e} s, closure {closure:.1e}",
            only.time
        );
        assert_eq!(only.segment, weak);
        // the same rope, strong enough: its tension passes the load in that step, and not before
        let strong = jerked(weak, Breaking::NEVER).build();
        let mut watch = Watch { segment: weak, load, first: None };
        simulate(&strong, &net.state, &schedule, 1, &mut watch);
        assert_eq!(watch.first, Some((only.time, only.tension)));
        assert!(tension > load && tension < 1.15 * PLATEAU, "{tension} N at a load of {load} N");
        // the front is as wide as a few segments
        assert!((only.time - front).abs() < 4.0 * segment_length / WAVE_SPEED, "{} s, front {front} s", only.time);
        assert!(outcome.ledger[Channel::Rupture] > 0.0 && closure < 5e-4, "{:?}", outcome.ledger);
    }
}

#[test]
fn a_rope_breaks_at_its_strain_too() {
    // behind the front the strain is V over the wave speed
    let strain = SPEED / WAVE_SPEED;
    for (share, breaks) in [(0.5, 1), (1.5, 0)] {
        let net = jerked(125, Breaking { strain: share * strain, ..Breaking::NEVER });
        let system = net.build();
        let schedule = Schedule::new(LENGTH / WAVE_SPEED, 1e-5, 0.3 * step_limit(&system).dt);
        let outcome = simulate(&system, &net.state, &schedule, 1, &mut Film::default());
        assert_eq!(outcome.breaks.len(), breaks);
        assert!(outcome.balance.closure() < 5e-4);
    }
}

/// A right angle of two segments, its far end flying off so fast that the segment there breaks at once: from then on the
/// three nodes know nothing of each other, and what the bend held is in the ledger.
#[test]
fn nothing_bends_over_a_segment_that_is_gone() {
    let mut net = Net::default();
    let corners = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
    let nodes = corners.map(|corner| net.node(corner, DVec3::ZERO));
    let soft = nets::Material { axial_stiffness: 1e4, mass_per_length: 1.0, damping_ratio: 0.0 };
    for ends in nodes.windows(2) {
        net.segment(ends[0], ends[1], 1.0, soft);
    }
    net.state.velocity[2] = 30.0 * DVec3::Y;
    net.parts.segments[1].breaking = Breaking { load: 500.0, ..Breaking::NEVER };
    net.stiffen(50.0);
    let system = net.build();
    let schedule = Schedule::new(0.02, 1e-4, 1e-6);
    let mut film = Film::default();
    let outcome = simulate(&system, &net.state, &schedule, 1, &mut film);
    let [only] = outcome.breaks[..] else { panic!("{:?}", outcome.breaks) };
    let after: Vec<_> = film.frames.iter().filter(|(time, ..)| *time > only.time + 2e-6).collect();
    assert!(after.len() > 100);
    for (_, _, velocity) in &after {
        // the first segment is slack: nothing pulls it back, and nothing turns it
        assert!((velocity[2] - after[0].2[2]).length() < 1e-9, "{}", velocity[2]);
        let momentum = 0.5 * velocity[0] + velocity[1];
        assert!((momentum - 0.5 * after[0].2[0] - after[0].2[1]).length() < 1e-9);
        assert!((velocity[1].y - after[0].2[1].y).abs() < 0.02 * velocity[1].y.abs() + 1e-3, "{}", velocity[1]);
    }
    // k d^2/2 of the segment, and of the bend EI/l (1 - cos) of a right angle, hardly turned by then
    let axial = 0.5 * 500.0 * 500.0 / 1e4;
    println!(
        "{} J in rupture, {axial} of them the segment's; closure {:.1e}",
        outcome.ledger[Channel::Rupture],
        outcome.balance.closure()
    );
    assert!((outcome.ledger[Channel::Rupture] - axial - 50.0).abs() < 1.0, "{:?}", outcome.ledger);
    assert!(outcome.ledger[Channel::Elastic] < 1.0 && outcome.balance.closure() < 1e-4, "{:?}", outcome);
}

/// Interrupts a run at every record and keeps the snapshots.
#[derive(Default)]
struct Keeper(Vec<Snapshot>);

impl Observer for Keeper {
    fn step(&mut self, _: &Live) {}
    fn record(&mut self, _: &Frame) {}
    fn wants_snapshot(&mut self) -> bool {
        true
    }
    fn snapshot(&mut self, snapshot: &Snapshot) {
        self.0.push(snapshot.clone());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Whatever breaks, the balance closes, and a run that goes on from any record comes to the same end; with steps as
    /// long as the time between records, so that some of them break something.
    #[test]
    fn a_net_that_breaks_keeps_account_and_can_go_on(mut net in nets::any_net_of_any_law(0.05), stiff: bool) {
        if stiff {
            net.stiffen(0.5);
        }
        let system = net.build();
        let dt = 0.05 * step_limit(&system).dt.min(1e-3);
        let schedule = Schedule::new(2000.0 * dt, dt, dt);
        let mut keeper = Keeper::default();
        let outcome = simulate(&system, &net.state, &schedule, 1, &mut keeper);
        prop_assert!(outcome.balance.closure() < 3e-3, "{:?}", outcome);
        let at_breaks = keeper.0.iter().filter(|kept| outcome.breaks.iter().any(|b| b.step.abs_diff(kept.step()) < 2));
        for snapshot in at_breaks.chain([&keeper.0[500]]) {
            prop_assert_eq!(&resume(&system, snapshot, &schedule, 2, &mut Film::default()), &outcome);
        }
    }
}

//! Ropes that are jerked along and hit across, against the exact waves.

use crate::nets::{self, Net};
use glam::DVec3;
use netcast_dynamics::simulate::{Frame, Live, Observer, Schedule, simulate};
use netcast_dynamics::step_size::step_limit;

/// Tension of every segment at every record.
#[derive(Default)]
struct Tensions(Vec<(f64, Vec<f64>)>);

impl Observer for Tensions {
    fn step(&mut self, _: &Live) {}
    fn record(&mut self, frame: &Frame) {
        self.0.push((frame.time, frame.tension.to_vec()));
    }
}

impl Tensions {
    /// Mean over a window in time, of `segments`.
    fn mean(&self, from: f64, to: f64, segments: std::ops::Range<usize>) -> f64 {
        let rows: Vec<f64> = self
            .0
            .iter()
            .filter(|(t, _)| (from..to).contains(t))
            .map(|(_, tension)| tension[segments.clone()].iter().sum::<f64>() / segments.len() as f64)
            .collect();
        rows.iter().sum::<f64>() / rows.len() as f64
    }
}

/// One-dimensional wave equation: a rope whose end is jerked along it at V is pulled with rho A c V until the wave
/// comes back. The paper's rope at 71 m/s: 66.99 kN.
#[test]
fn a_rope_jerked_along_itself_pulls_with_rho_a_c_v() {
    // seen from the jerked end: the end is held, the rope runs away from it
    let (length, count, speed) = (5.0, 250, 71.0);
    let mut net = Net::rope(length, count, nets::paper_rope(0.05));
    net.state.velocity = vec![DVec3::X * speed; count + 1];
    net.parts.held[0] = true;
    let system = net.build();
    let wave_speed = (78e9f64 / 1850.0).sqrt();
    let back = 2.0 * length / wave_speed;
    let mut tensions = Tensions::default();
    simulate(&system, &net.state, &Schedule::new(back, back / 400.0, 0.3 * step_limit(&system).dt), 1, &mut tensions);

    let plateau = tensions.mean(0.3 * back, 0.9 * back, 0..5);
    println!("plateau {plateau:.1} N");
    assert!((plateau / 66_990.0 - 1.0).abs() < 2e-3, "{plateau} N");
}

/// A long rope hit across at V: a kink runs outwards, inside it the rope is straight and its strain e obeys V = c
/// sqrt(2 e sqrt(e (1 + e)) - e^2) (Smith, McCrackin, Schiefer 1958). The paper's rope at 50 m/s: 5928 N, at 71 m/s:
/// 9486 N.
#[test]
fn a_rope_hit_across_takes_the_tension_of_smith_mccrackin_and_schiefer() {
    for (speed, expected) in [(50.0, 5928.0), (71.0, 9486.0)] {
        let (length, count) = (4.0, 400);
        let mut net = Net::rope(length, count, nets::paper_rope(0.1));
        // the middle is held; the rest of the rope comes at it
        net.state.velocity = vec![DVec3::Y * speed; count + 1];
        net.parts.held[count / 2] = true;
        let system = net.build();
        let to_the_end = 0.5 * length / (78e9f64 / 1850.0).sqrt();
        let mut tensions = Tensions::default();
        let schedule = Schedule::new(to_the_end, to_the_end / 200.0, 0.3 * step_limit(&system).dt);
        simulate(&system, &net.state, &schedule, 1, &mut tensions);
        let found = tensions.mean(0.5 * to_the_end, 0.95 * to_the_end, count / 2 - 10..count / 2 + 10);
        println!("{speed} m/s: {found:.0} N, exact {expected} N");
        assert!((found / expected - 1.0).abs() < 0.02, "{found} N instead of {expected} N");
    }
}

//! Free flight of nets, against results that do not depend on the forces inside the net.

use crate::support::{Run, assert_close};
use glam::DVec3;

/// A net without tension rises under mass-proportional damping alpha as a body does: its apex comes at
/// t = ln(1 + alpha v/g)/alpha, at the height z = v/alpha - g t/alpha. 50 m/s and 8 1/s give 0.467 s and 5.68 m.
#[test]
fn damped_flight_has_the_apex_of_the_closed_form() {
    let nodes = "id,x,y,z,vz\nn1,1,1,0,50\nn2,-1,1,0,50\nn3,-1,-1,0,50\nn4,1,-1,0,50\n";
    let ropes = "a,b\nn1,n2\nn2,n3\nn3,n4\nn4,n1\n";
    let scenario = "points = { P = \"n1\" }\n\
                    rope = { diameter = \"10 mm\", density = 1850, elastic_modulus = \"78 GPa\" }\n\
                    environment = { damping = \"8 1/s\" }\n\
                    solve = { duration = \"0.6 s\", segment_length = \"2 m\" }\n";
    let run = Run::graph(scenario, nodes, ropes);

    let (speed, damping, gravity): (f64, f64, f64) = (50.0, 8.0, 9.80665);
    let time = libm::log(1.0 + damping * speed / gravity) / damping;
    let height = speed / damping - gravity * time / damping;
    let apex = run.summary.points["P"].clone().expect("a feature point");
    let found = (apex.peak_travel_time_s.expect("it rises"), apex.peak_height_m.expect("it rises"));
    println!("apex at {:.5} s, {:.6} m; exact {time:.5} s, {height:.6} m", found.0, found.1);
    assert!((time - 0.467).abs() < 5e-4 && (height - 5.68).abs() < 5e-3);
    // the time of the apex is known to one step
    assert!((found.0 - time).abs() <= run.summary.step.dt_s);
    assert_close("height, m", found.1, height, 1e-6);
}

/// Sums over all nodes of a recorded frame.
struct Sums {
    mass: f64,
    /// Centre of mass, m.
    centre: DVec3,
    /// Momentum, kg m/s.
    momentum: DVec3,
    /// Angular momentum about the origin, kg m^2/s, and the sum of |r x p|.
    angular: DVec3,
    angular_size: f64,
}

fn sums(run: &Run, frame: usize) -> Sums {
    let mass = run.model.system.mass();
    let (x, v) = (run.fields.positions(frame), run.fields.velocities(frame));
    let mut sums = Sums {
        mass: mass.iter().sum(),
        centre: DVec3::ZERO,
        momentum: DVec3::ZERO,
        angular: DVec3::ZERO,
        angular_size: 0.0,
    };
    for ((&m, &x), &v) in mass.iter().zip(x).zip(v) {
        let turning = x.cross(m * v);
        sums.centre += m * x / sums.mass;
        sums.momentum += m * v;
        sums.angular += turning;
        sums.angular_size += turning.length();
    }
    sums
}

/// The square net without gravity: internal forces change neither momentum nor angular momentum. One tractor has a launch
/// of its own, which makes both large in every direction.
#[test]
fn free_flight_keeps_momentum_and_angular_momentum() {
    let tractors = "tractors=[{ corner = 2, particle = { mass = \"0.7 kg\" }, axial_speed = \"26 m/s\", \
                    azimuth = \"70 deg\", elevation = \"60 deg\" }]";
    let run = Run::example("04_square_net/square_net.toml", &["launch.elevation=50 deg", tractors]);
    let start = sums(&run, 0);
    let (mut momentum, mut angular) = (0.0, 0.0);
    for frame in 1..run.fields.times.len() {
        let now = sums(&run, frame);
        momentum = f64::max(momentum, (now.momentum - start.momentum).length() / start.momentum.length());
        angular = f64::max(angular, (now.angular - start.angular).length() / now.angular_size);
    }
    println!("momentum kept to {momentum:.1e}, angular momentum to {angular:.1e} of sum |r x p|");
    assert!(start.angular.length() > 1.0, "nothing turns");
    assert!(momentum < 1e-9 && angular < 1e-9, "{momentum:e}, {angular:e}");
}

/// Under gravity the centre of mass of an opening net moves on a parabola.
#[test]
fn the_centre_of_mass_is_ballistic() {
    let run = Run::example(
        "04_square_net/square_net.toml",
        &["environment.gravity=9.80665 m/s^2", "launch.elevation=50 deg", "launch.azimuth=20 deg"],
    );
    let start = sums(&run, 0);
    let velocity = start.momentum / start.mass;
    let mut error: f64 = 0.0;
    for (frame, &t) in run.fields.times.iter().enumerate() {
        let exact = start.centre + velocity * t - DVec3::Z * (0.5 * 9.80665 * t * t);
        error = error.max((sums(&run, frame).centre - exact).length());
    }
    let way = velocity.length() * run.fields.times[run.fields.times.len() - 1];
    println!("centre of mass off by {error:.1e} m at most on a way of {way:.1} m");
    assert!(error < 1e-9 * way, "{error} m");
}

//! A cable that swings in three dimensions (Gerstmayr and Shabana, Nonlinear Dynamics 45, 2006; numbers from the test data of
//! Project Chrono). It is 1 m long, hinged at x = 0, 5.6419 mm thick, E 1.6 MPa, 320 kg/m^3, EI 7.9577e-5 N m^2. Gravity of
//! 9.81 m/s^2 acts along -y there and -z here. It starts with a spin about its hinge: v_z = -4 x there, v_y = 4 x here. Up to
//! 1 s a cable without bending stiffness stays within 3 cm of the reference, one with bending stiffness within 2 cm.

use crate::support::Run;

/// Time, s; height of the middle, x of the tip, y of the tip, m.
const REFERENCE: [(f64, [f64; 3]); 4] = [
    (0.2, [-0.18520, 0.65522, 0.70432]),
    (0.5, [-0.37309, -0.69026, 0.09211]),
    (0.8, [-0.06077, -0.16500, -0.97875]),
    (1.0, [-0.10952, 0.65069, -0.66897]),
];

const SEGMENTS: usize = 40;

/// Largest deviation from the reference along any axis, m.
fn largest_miss(properties: &str) -> f64 {
    let scenario = format!(
        "rope = {{ diameter = 5.6419e-3, density = 320, elastic_modulus = \"1.6 MPa\", {properties} }}\n\
         environment.gravity = 9.81\nlaunch.spin = \"4 rad/s\"\n\
         solve = {{ duration = \"1 s\", segment_length = 1 }}\nrecord.every = \"5 ms\"\n"
    );
    let nodes = "id,x,y,z,fixed\nhinge,0,0,0,1\ntip,1,0,0,0\n";
    let run = Run::graph(&scenario, nodes, &format!("a,b,segments\nhinge,tip,{SEGMENTS}\n"));
    // nodes inside the rope follow its two knots
    let (tip, middle) = (1, 1 + SEGMENTS / 2);
    let misses = REFERENCE.map(|(at, expected)| {
        let record = run.fields.times.iter().position(|time| (time - at).abs() < 1e-9).expect("a record then");
        let now = run.fields.positions(record);
        let [z, x, y] = [now[middle].z, now[tip].x, now[tip].y];
        let misses = [z - expected[0], x - expected[1], y - expected[2]];
        println!("{at} s: the middle misses by {:.4} m, the tip by {:.4} and {:.4} m", misses[0], misses[1], misses[2]);
        misses.into_iter().map(f64::abs).fold(0.0, f64::max)
    });
    misses.into_iter().fold(0.0, f64::max)
}

#[test]
fn a_swinging_cable_stays_near_the_reference() {
    let miss = largest_miss("damping_ratio = 0.02");
    assert!(miss < 0.03, "{miss} m");
}

#[test]
fn a_swinging_cable_with_bending_stiffness_stays_nearer_to_the_reference() {
    let miss = largest_miss("damping_ratio = 0.02, bending_stiffness = 7.9577e-5");
    assert!(miss < 0.02, "{miss} m");
}

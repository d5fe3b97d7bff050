//! A rope with bending stiffness between two supports, under its own weight, against the beam with hinged ends:
//!
//! ```text
//! sag in the middle = 5 q L^4 / (384 EI),        first period = (2 L^2 / pi) sqrt(mu / EI)
//! ```
//!
//! (Timoshenko, Strength of Materials; Vibration Problems in Engineering.) Knots turn freely, so a rope between two knots
//! is hinged. Its axial stiffness is negligible: else tension between the fixed supports would hold it up.

use std::f64::consts::PI;

use crate::support::{Run, assert_close};

const EI: f64 = 2.0;
const SEGMENTS: usize = 20;
/// Mass per length, kg/m, of a rope of 10 mm at 1000 kg/m^3. Gravity is 1 m/s^2 and the span 1 m.
const MU: f64 = 1000.0 * 0.25 * PI * 1e-4;
const SAG: f64 = 5.0 * MU / (384.0 * EI);

/// Times, s, and heights, m, of the middle of the rope after its weight is suddenly applied.
fn beam(damping: f64, duration: f64) -> (Vec<f64>, Vec<f64>) {
    let scenario = format!(
        "rope = {{ diameter = 0.01, density = 1000, elastic_modulus = 1e5, damping_ratio = 0, bending_stiffness = {EI} }}\n\
         environment = {{ gravity = 1, damping = {damping} }}\n\
         solve = {{ duration = {duration}, segment_length = 1 }}\n\
         record.every = 0.002\n"
    );
    let nodes = "id,x,y,z,mass,fixed\na,0,0,0,0,1\nb,1,0,0,0,1\n";
    let run = Run::graph(&scenario, nodes, &format!("a,b,segments\na,b,{SEGMENTS}\n"));
    // nodes inside the rope follow its two knots
    let middle = |step| run.fields.positions(step)[1 + SEGMENTS / 2].z;
    ((run.fields.times.clone()), (0..run.fields.times.len()).map(middle).collect())
}

#[test]
fn a_rope_that_resists_bending_sags_as_a_beam() {
    let (_, height) = beam(60.0, 1.0);
    let sag = -height[height.len() - 1];
    println!("sag {:.4} mm, of a beam {:.4} mm", 1e3 * sag, 1e3 * SAG);
    assert_close("sag, m", sag, SAG, 5e-3);
}

#[test]
fn a_rope_that_resists_bending_vibrates_as_a_beam() {
    // it vibrates about its sag in the first mode, with 1/243 of the third
    let (time, height) = beam(0.0, 1.2);
    let rising = |&i: &usize| height[i - 1] < -SAG && height[i] >= -SAG;
    let crossing =
        |i: usize| time[i - 1] + (time[i] - time[i - 1]) * (-SAG - height[i - 1]) / (height[i] - height[i - 1]);
    let ups: Vec<f64> = (1..height.len()).filter(rising).map(crossing).collect();
    let period = (ups[ups.len() - 1] - ups[0]) / (ups.len() - 1) as f64;
    let expected = 2.0 / PI * (MU / EI).sqrt();
    println!("period {period:.5} s, of a beam {expected:.5} s");
    assert_close("period, s", period, expected, 1e-2);
}

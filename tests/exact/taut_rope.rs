//! A taut rope pulled at its middle, section 4.1 and Figure 5 of the founding paper: EA 100 kN, ends 2.5 m apart.
//!
//! ```text
//! exact           F = 2 T sin a,   tan a = 2l/L,   T = EA [(1 + e0) sec a - 1],   e0 = T0/EA        (1), (4), (5)
//! small slopes    F = (EA + T0) 8 l^3/L^3 + 4 T0 l/L                                                (6)
//! ```
//!
//! The numbers of both equations are in docs/theory/rope.md.

use crate::support::{Run, assert_close};

const AXIAL_STIFFNESS: f64 = 100e3;
const SPAN: f64 = 2.5;
const GRAVITY: f64 = 9.80665;
const PRETENSIONS: [f64; 6] = [0.0, 200.0, 400.0, 600.0, 800.0, 1000.0];
const DISPLACEMENTS: [f64; 3] = [0.1, 0.3, 0.5];

/// Tension, N, and sine of the slope of the rope after its middle is displaced by `displacement`, m.
fn exact_tension(pretension: f64, displacement: f64) -> (f64, f64) {
    let slope = 2.0 * displacement / SPAN;
    let secant = (1.0 + slope * slope).sqrt();
    let tension = AXIAL_STIFFNESS * ((1.0 + pretension / AXIAL_STIFFNESS) * secant - 1.0);
    (tension, slope / secant)
}

fn exact_force(pretension: f64, displacement: f64) -> f64 {
    let (tension, sine) = exact_tension(pretension, displacement);
    2.0 * tension * sine
}

/// Equation (6) of the paper.
fn cubic_force(pretension: f64, displacement: f64) -> f64 {
    let (l, span) = (displacement, SPAN);
    (AXIAL_STIFFNESS + pretension) * 8.0 * l * l * l / (span * span * span) + 4.0 * pretension * l / span
}

/// A rope with that EA, 10 mm thick and almost without weight.
fn scenario(rest: &str) -> String {
    let modulus = AXIAL_STIFFNESS / (0.25 * std::f64::consts::PI * 0.01 * 0.01);
    format!(
        "points = {{ M = \"middle\" }}\n\
         rope = {{ diameter = \"10 mm\", density = 0.01, elastic_modulus = {modulus} }}\n{rest}"
    )
}

#[test]
fn the_closed_forms_give_the_numbers_of_the_page() {
    let expected = [
        (0.0, [(51.2, 51.0), (1382.4, 1325.4), (6400.0, 5721.9)]),
        (1000.0, [(211.7, 211.0), (1876.2, 1805.4), (7264.0, 6521.9)]),
    ];
    for (pretension, row) in expected {
        for (displacement, (cubic, exact)) in DISPLACEMENTS.into_iter().zip(row) {
            let found = (cubic_force(pretension, displacement), exact_force(pretension, displacement));
            println!("T0 {pretension} N, l {displacement} m: equation (6) {:.1} N, exact {:.1} N", found.0, found.1);
            assert!((found.0 - cubic).abs() <= 0.05 && (found.1 - exact).abs() <= 0.05, "{found:?}");
        }
    }
}

/// A weight equal to the exact force hangs on the middle of the drawn rope and comes to rest at the exact displacement.
#[test]
fn a_weight_on_the_middle_comes_to_rest_at_the_exact_displacement() {
    let rest = format!(
        "environment = {{ gravity = {GRAVITY}, damping = \"12 1/s\" }}\n\
         solve = {{ duration = \"5 s\", segment_length = \"2.5 m\" }}\nrecord = {{ every = \"0.1 s\" }}\n"
    );
    for pretension in PRETENSIONS {
        for displacement in DISPLACEMENTS {
            let mass = exact_force(pretension, displacement) / GRAVITY;
            let nodes = format!("id,x,y,z,mass,fixed\nleft,-1.25,0,0,0,1\nmiddle,0,0,0,{mass},0\nright,1.25,0,0,0,1\n");
            let ropes = format!("a,b,pretension,segments\nleft,middle,{pretension},1\nmiddle,right,{pretension},1\n");
            let run = Run::graph(&scenario(&rest), &nodes, &ropes);

            let (tension, _) = exact_tension(pretension, displacement);
            let (found_l, found_t) = (-run.last("M_z_m"), run.last("M_tension_n"));
            println!("T0 {pretension} N, F {:.1} N: l {found_l:.7} m, T {found_t:.3} N", mass * GRAVITY);
            assert_close("displacement, m", found_l, displacement, 1e-6);
            assert_close("tension, N", found_t, tension, 1e-6);
        }
    }
}

/// The middle is drawn displaced and held. Each half, cut into eight segments, keeps its rest length of the straight rope.
#[test]
fn a_rope_held_at_its_middle_has_the_tension_of_the_law_in_every_segment() {
    let rest = "environment = { gravity = 0 }\nsolve = { duration = \"5 ms\", segment_length = \"1 m\" }\n";
    for pretension in PRETENSIONS {
        for displacement in DISPLACEMENTS {
            let rest_length = 0.5 * SPAN / (1.0 + pretension / AXIAL_STIFFNESS);
            let (tension, _) = exact_tension(pretension, displacement);
            let nodes = format!("id,x,y,z,fixed\nleft,-1.25,0,0,1\nmiddle,0,0,{displacement},1\nright,1.25,0,0,1\n");
            let ropes =
                format!("a,b,rest_length,segments\nleft,middle,{rest_length},8\nmiddle,right,{rest_length},8\n");
            let run = Run::graph(&scenario(rest), &nodes, &ropes);
            for &found in run.fields.tensions(run.fields.times.len() - 1) {
                assert_close("tension, N", found, tension, 1e-9);
            }
        }
    }
}

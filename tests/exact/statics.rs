//! Equilibria by `[solve.static]` against closed forms.
//!
//! Heavy extensible cable, SSNL114 of Code_Aster (V6.02.114): span and unstretched length 325 m, A 2.2783e-4 m^2, E 57 GPa,
//! density 2844.23 kg/m^3, g 9.81 m/s^2. Its sag is 6.352 m; with a thermal strain of 2.3e-5 * 39.26 it is 8.195 m. By the
//! elastic catenary the horizontal reaction is 13206 N and the largest tension 13247 N; warmed, the reaction is 10234 N.
//!
//! Square frame of bars with two tension-only diagonals, SSNL105 of Code_Aster (V6.02.105): sides of 1 m, two corners held,
//! 1000 N along the upper side. The loaded diagonal bears 1414.2 N, the bar below the load -1000 N, all others nothing.
//!
//! Catenary, Irvine, Cable Structures, 1981: weight w per length, parameter a = H/w, length S between two ends at one height,
//! L apart. S = 2 a sinh(L/2a); the sag is a (cosh(L/2a) - 1) and the tension at the ends w (a + sag).
//!
//! Taut rope pulled at its middle: section 4.1 of the founding paper; its equations are in taut_rope.rs.

use crate::support::{Run, assert_close};

const GRAVITY: f64 = 9.81;

/// A rope of 1 mm^2 between ends of equal height, cut into `segments`, in equilibrium.
fn rope_at_rest(span: f64, length: f64, axial_stiffness: f64, mass_per_length: f64, segments: usize) -> Run {
    let area = 1e-6;
    let diameter = (4.0 * area / std::f64::consts::PI).sqrt();
    let scenario = format!(
        "rope = {{ diameter = {diameter}, density = {}, elastic_modulus = {} }}\n\
         environment = {{ gravity = {GRAVITY} }}\nsolve.static = {{ tolerance = 1e-8 }}\n",
        mass_per_length / area,
        axial_stiffness / area
    );
    let nodes = format!("id,x,y,z,fixed\nleft,0,0,0,1\nright,{span},0,0,1\n");
    Run::graph(&scenario, &nodes, &format!("a,b,rest_length,segments\nleft,right,{length},{segments}\n"))
}

/// Sag, m, horizontal reaction, N, and tension at an end, N. Masses are lumped at nodes, so the end carries half the weight
/// of a segment more than the first segment does.
fn sag_and_reactions(run: &Run, weight: f64, segments: usize) -> (f64, f64, f64) {
    let last = run.fields.times.len() - 1;
    let x = run.fields.positions(last);
    let lowest = x.iter().map(|x| x.z).fold(0.0, f64::min);
    // the run lists both ends, then the inner nodes; the first segment joins the left end to the first inner node
    let (tension, span) = (run.fields.tensions(last)[0], x[2] - x[0]);
    let horizontal = tension * span.x / span.length();
    let vertical = tension * -span.z / span.length() + 0.5 * weight / segments as f64;
    (-lowest, horizontal, libm::hypot(horizontal, vertical))
}

/// Horizontal reaction of the elastic catenary, N: span = H S/EA + 2 (H S/W) asinh(W/2H).
fn elastic_catenary(span: f64, length: f64, axial_stiffness: f64, weight: f64) -> f64 {
    let (mut low, mut high) = (1e-3 * weight, 1e3 * weight);
    for _ in 0..100 {
        let h = 0.5 * (low + high);
        let reached = h * length / axial_stiffness + 2.0 * h * length / weight * libm::asinh(0.5 * weight / h);
        if reached > span { high = h } else { low = h }
    }
    low
}

#[test]
fn a_heavy_extensible_cable_has_the_sag_of_code_aster() {
    let (area, modulus, density, span) = (2.2783e-4, 57e9, 2844.23, 325.0);
    let weight = density * area * span * GRAVITY;
    for (strain, sag) in [(0.0, 6.352), (2.3e-5 * 39.26, 8.195)] {
        // the warmed rope is longer and has the same mass
        let length = span * (1.0 + strain);
        let run = rope_at_rest(span, length, modulus * area, density * area * span / length, 200);
        let (found_sag, found_h, found_t) = sag_and_reactions(&run, weight, 200);
        let horizontal = elastic_catenary(span, length, modulus * area, weight);
        let largest = libm::hypot(horizontal, 0.5 * weight);
        let found = run.summary.statics.as_ref().expect("an equilibrium");
        println!(
            "strain {strain:.4e}: sag {found_sag:.4} m ({sag}), H {found_h:.1} N ({horizontal:.1}), T {found_t:.1} N \
             ({largest:.1}); {} iterations, residual {:.1e}",
            found.iterations,
            found.residual_relative.unwrap()
        );
        assert_close("sag, m", found_sag, sag, 2e-4);
        assert_close("horizontal reaction, N", found_h, horizontal, 2e-5);
        assert_close("largest tension, N", found_t, largest, 2e-5);
        if strain == 0.0 {
            assert!((found_h - 13206.0).abs() < 0.5 && (found_t - 13246.6).abs() < 0.5);
        }
    }
}

#[test]
fn a_stiff_rope_hangs_in_the_catenary() {
    let (span, length, mass_per_length, segments) = (2.0, 2.6, 0.1, 64);
    // EA is 4000 times the tension: the stretch is smaller than the error of the polygon
    let run = rope_at_rest(span, length, 1e4, mass_per_length, segments);
    let weight = mass_per_length * length * GRAVITY;
    let (sag, horizontal, tension) = sag_and_reactions(&run, weight, segments);

    let (mut low, mut high) = (0.1, 10.0);
    for _ in 0..100 {
        let a: f64 = 0.5 * (low + high);
        // the lower the parameter, the longer the rope
        if 2.0 * a * libm::sinh(0.5 * span / a) > length { low = a } else { high = a }
    }
    let exact_sag = low * (libm::cosh(0.5 * span / low) - 1.0);
    let (exact_h, exact_t) = (mass_per_length * GRAVITY * low, mass_per_length * GRAVITY * (low + exact_sag));
    println!("sag {sag:.6} m ({exact_sag:.6}), H {horizontal:.6} N ({exact_h:.6}), T {tension:.6} N ({exact_t:.6})");
    assert_close("sag, m", sag, exact_sag, 1e-3);
    assert_close("horizontal reaction, N", horizontal, exact_h, 1e-3);
    assert_close("tension at the ends, N", tension, exact_t, 1e-3);
}

#[test]
fn a_taut_rope_is_displaced_as_in_the_paper() {
    const AXIAL_STIFFNESS: f64 = 100e3;
    let modulus = AXIAL_STIFFNESS / (0.25 * std::f64::consts::PI * 0.01 * 0.01);
    for (pretension, row) in [(0.0, [51.0, 1325.4, 5721.9]), (1000.0, [211.0, 1805.4, 6521.9])] {
        for (displacement, paper) in [0.1f64, 0.3, 0.5].into_iter().zip(row) {
            let slope = 2.0 * displacement / 2.5;
            let secant = (1.0 + slope * slope).sqrt();
            let tension = AXIAL_STIFFNESS * ((1.0 + pretension / AXIAL_STIFFNESS) * secant - 1.0);
            let force = 2.0 * tension * slope / secant;
            let scenario = format!(
                "points = {{ M = \"middle\" }}\nenvironment = {{ gravity = 0 }}\nsolve.static = {{ tolerance = 1e-8 }}\n\
                 load.pull = {{ force = [0, 0, {force}], points = [\"M\"] }}\n\
                 rope = {{ diameter = \"10 mm\", density = 1000, elastic_modulus = {modulus} }}\n"
            );
            let nodes = "id,x,y,z,fixed\nleft,-1.25,0,0,1\nmiddle,0,0,0,0\nright,1.25,0,0,1\n";
            let ropes = format!("a,b,pretension,segments\nleft,middle,{pretension},8\nmiddle,right,{pretension},8\n");
            let run = Run::graph(&scenario, nodes, &ropes);
            let (found_l, found_t) = (run.last("M_z_m"), run.last("M_tension_n"));
            println!("T0 {pretension} N, F {force:.1} N: l {found_l:.7} m, T {found_t:.3} N");
            assert!((force - paper).abs() <= 0.05, "{force}");
            assert_close("displacement, m", found_l, displacement, 1e-6);
            assert_close("tension, N", found_t, tension, 1e-6);
        }
    }
}

#[test]
fn a_frame_with_tension_only_diagonals_has_the_forces_of_code_aster() {
    let scenario = "environment = { gravity = 0 }\nsolve = { static = { tolerance = 1e-9 }, segment_length = 2 }\n\
                    load.side = { force = [\"1000 N\", 0, 0], nodes = [\"3\"] }\n\
                    rope = { diameter = \"36 mm\", density = 7800, elastic_modulus = \"200 GPa\" }\n\
                    ropes.bar = { diameter = \"36 mm\", density = 7800, elastic_modulus = \"200 GPa\", law.strut = {} }\n";
    let nodes = "id,x,y,z,fixed\n1,0,0,0,1\n2,1,0,0,1\n3,1,1,0,0\n4,0,1,0,0\n";
    let ropes = "a,b,rope\n1,2,bar\n2,3,bar\n3,4,bar\n4,1,bar\n1,3,\n2,4,\n";
    let run = Run::graph(scenario, nodes, ropes);
    let tension = run.fields.tensions(0);
    println!("bars {:?} N, diagonals {:?} N", &tension[..4], &tension[4..]);
    let expected = [0.0, -1000.0, 0.0, 0.0, 1000.0 * 2f64.sqrt(), 0.0];
    for (found, expected) in tension.iter().zip(expected) {
        assert!((found - expected).abs() < 0.1, "{found} instead of {expected}");
    }
}

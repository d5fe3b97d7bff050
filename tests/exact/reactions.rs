//! The forces of supports against statics: the weight of what hangs, the end of an elastic catenary (Irvine, Cable Structures,
//! 1981, section 2.2), the pivot of a pendulum that is let go level, which bears 3 m g at its lowest point.

use crate::support::{Run, assert_close};

const GRAVITY: f64 = 9.80665;

#[test]
fn supports_of_a_hanging_net_bear_its_weight() {
    let scenario = "rope = { diameter = \"2 mm\", density = 970, elastic_modulus = \"50 MPa\" }\n\
                    solve.static = { tolerance = 1e-10 }\n";
    // a rectangle with a cross, hung at three places of different heights
    let nodes = "id,x,y,z,fixed\na,0,0,0,1\nb,2,0.2,0.3,1\nc,2.1,1.6,-0.2,0\nd,0.1,1.5,0.4,1\ne,1,0.8,0,0\n";
    let ropes = "a,b,rest_length\na,b,2.2\nb,c,1.7\nc,d,2.4\nd,a,1.8\na,e,1.5\nb,e,1.4\nc,e,1.6\nd,e,1.3\n";
    let run = Run::graph(scenario, nodes, ropes);
    let weight = run.summary.model.web_mass_kg * GRAVITY;
    let all = &run.summary.reactions["supports"];
    let [x, y, z] = [all.x_n, all.y_n, all.z_n].map(Option::unwrap);
    println!("weight {weight} N, reactions {x} {y} {z} N");
    for (found, exact) in [(x, 0.0), (y, 0.0), (z, weight)] {
        assert!((found - exact).abs() <= 1e-9 * weight, "{found} instead of {exact}");
    }
    // the sum is that of the three, and the history tells the same
    assert_eq!(run.summary.reactions.len(), 4, "{:?}", run.summary.reactions.keys());
    let each: f64 =
        run.summary.reactions.iter().filter(|(name, _)| *name != "supports").map(|(_, r)| r.z_n.unwrap()).sum();
    assert_close("sum of the supports, N", each, z, 1e-12);
    assert_eq!(run.last("supports_reaction_z_n"), z);
}

#[test]
fn the_end_of_a_cable_bears_the_force_of_the_catenary() {
    let (span, length, diameter, modulus, density) = (20.0, 21.0, 4e-3, 2e9, 1000.0);
    let area = 0.25 * std::f64::consts::PI * diameter * diameter;
    let (weight, stiffness) = (density * area * length * GRAVITY, modulus * area);
    let scenario = format!(
        "rope = {{ diameter = {diameter}, density = {density}, elastic_modulus = {modulus} }}\n\
         solve.static = {{ tolerance = 1e-9 }}\n"
    );
    let nodes = format!("id,x,y,z,fixed\nleft,0,0,0,1\nright,{span},0,0,1\n");
    let ends = |segments: usize| {
        let ropes = format!("a,b,rest_length,segments\nleft,right,{length},{segments}\n");
        let run = Run::graph(&scenario, &nodes, &ropes);
        let ends = run.summary.reactions.into_iter().filter(|(name, _)| name != "supports");
        ends.map(|(name, end)| (name, end.x_n.unwrap(), end.z_n.unwrap())).collect::<Vec<_>>()
    };

    // span = H S/EA + 2 (H S/W) asinh(W/2H)
    let (mut low, mut high) = (1e-3 * weight, 1e3 * weight);
    for _ in 0..100 {
        let h = 0.5 * (low + high);
        let reached = h * length / stiffness + 2.0 * h * length / weight * libm::asinh(0.5 * weight / h);
        if reached > span { high = h } else { low = h }
    }
    // the error of a polygon falls with the square of its segments: two of them tell the limit
    for ((coarse, fine), pull) in ends(40).iter().zip(&ends(80)).zip([-low, low]) {
        let (name, x, z) = (&fine.0, (4.0 * fine.1 - coarse.1) / 3.0, fine.2);
        println!("{name}: H {x:.9} N ({pull:.9}), V {z:.9} N ({:.9})", 0.5 * weight);
        assert_close("horizontal force, N", x, pull, 1e-6);
        assert_close("vertical force, N", z, 0.5 * weight, 1e-6);
    }
}

#[test]
fn the_pivot_of_a_pendulum_let_go_level_bears_three_times_its_weight() {
    let (length, mass) = (1.0, 1.0);
    let scenario = "rope = { diameter = \"2 mm\", density = 1, elastic_modulus = \"50 GPa\" }\n\
                    solve = { duration = \"0.9 s\" }\nrecord.every = \"10 ms\"\n";
    let nodes = "id,x,y,z,fixed,mass\npivot,0,0,0,1,0\nbob,1,0,0,0,1\n";
    let run = Run::graph(scenario, nodes, "a,b,segments\npivot,bob,1\n");
    let pivot = &run.summary.reactions["supports"];
    let exact = 3.0 * mass * GRAVITY;
    println!("{} N at {} s instead of {exact} N", pivot.peak_n.unwrap(), pivot.peak_time_s.unwrap());
    assert_close("peak reaction, N", pivot.peak_n.unwrap(), exact, 1e-3);
    // K(sin 45 deg) sqrt(L/g) from level to the lowest point
    assert_close("its time, s", pivot.peak_time_s.unwrap(), 1.854_074_677 * (length / GRAVITY).sqrt(), 1e-2);
}

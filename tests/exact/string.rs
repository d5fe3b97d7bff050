//! A string between two ends is displaced and released: its modes have the frequencies n/(2L) sqrt(T/mu).

use crate::support::{Run, assert_close};

#[test]
fn a_string_under_a_static_pretension_vibrates_at_its_first_frequency() {
    // 1 m long as drawn, EA 1e5 N, pretension 50 N; a small load displaces the middle at the start
    let (tension, axial_stiffness) = (50.0, 1e5);
    let area = 0.25 * std::f64::consts::PI * 0.002 * 0.002;
    let scenario = format!(
        "points = {{ M = \"middle\" }}\nenvironment = {{ gravity = 0 }}\n\
         rope = {{ diameter = \"2 mm\", density = 1000, elastic_modulus = {}, damping_ratio = 0 }}\n\
         load.sides = {{ force = [0, 0, 0.05], points = [\"M\"] }}\nload.off = {{ force = [0, 0, -0.05], points = [\"M\"], ramp = 1e-9 }}\n\
         solve = {{ duration = \"0.25 s\", static = {{ tolerance = 1e-9, then_run = true }} }}\nrecord.every = \"0.1 ms\"\n",
        axial_stiffness / area
    );
    let nodes = "id,x,y,z,fixed\nleft,0,0,0,1\nmiddle,0.5,0,0,0\nright,1,0,0,1\n";
    let ropes = format!("a,b,pretension,segments\nleft,middle,{tension},20\nmiddle,right,{tension},20\n");
    let run = Run::graph(&scenario, nodes, &ropes);

    // the mass is that of the unstretched rope
    let mass_per_length = 1000.0 * area / (1.0 + tension / axial_stiffness);
    let expected = 0.5 * (tension / mass_per_length).sqrt();
    // the share of the first mode in the shape
    let shape = |frame: usize| -> f64 {
        let nodes = run.fields.positions(frame).iter();
        nodes.map(|x| x.z * libm::sin(std::f64::consts::PI * x.x)).sum()
    };
    let (time, z) = (run.column("time_s"), run.column("M_z_m"));
    let crossings: Vec<f64> = (1..time.len())
        .map(|i| (i, shape(i - 1), shape(i)))
        .filter(|(_, before, now)| *before > 0.0 && *now <= 0.0)
        .map(|(i, before, now)| time[i - 1] + (time[i] - time[i - 1]) * before / (before - now))
        .collect();
    let swings = crossings.len() - 1;
    let frequency = swings as f64 / (crossings[swings] - crossings[0]);
    println!("{frequency:.3} Hz over {swings} swings, expected {expected:.3} Hz");
    assert!((z[0] - 0.05 * 1.0 / (4.0 * tension)).abs() < 1e-3 * z[0], "pulled aside by {} m", z[0]);
    assert_close("frequency, Hz", frequency, expected, 5e-4);
}

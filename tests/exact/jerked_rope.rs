//! A rope whose end is jerked along it at V has the tension rho A c V until the wave returns from its far end, by the
//! one-dimensional wave equation. The founding paper's rope (10 mm, 1850 kg/m^3, 78 GPa) at 71 m/s: 66.99 kN.

use crate::support::{Run, assert_close};

#[test]
fn a_rope_jerked_along_itself_has_the_tension_rho_a_c_v() {
    // the heavy end keeps its speed to one part in a million
    let nodes = "id,x,y,z,mass,fixed,vx\nfar,0,0,0,0,1,0\njerked,5,0,0,1e6,0,71\n";
    let ropes = "a,b,segments\nfar,jerked,250\n";
    let back = 2.0 * 5.0 / (78e9f64 / 1850.0).sqrt();
    let scenario = format!(
        "points = {{ J = \"jerked\" }}\n\
         rope = {{ diameter = \"10 mm\", density = 1850, elastic_modulus = \"78 GPa\", damping_ratio = 0.05 }}\n\
         environment = {{ gravity = 0 }}\n\
         solve = {{ duration = {back}, segment_length = \"0.02 m\" }}\nrecord = {{ every = {} }}\n",
        back / 400.0
    );
    let run = Run::graph(&scenario, nodes, ropes);

    let window = (0.3 * back)..(0.9 * back);
    let rows = run.column("time_s").into_iter().zip(run.column("J_tension_n"));
    let plateau: Vec<f64> = rows.filter(|(time, _)| window.contains(time)).map(|(_, tension)| tension).collect();
    let mean = plateau.iter().sum::<f64>() / plateau.len() as f64;
    let spread = plateau.iter().map(|t| (t - mean).abs()).fold(0.0, f64::max);
    println!("plateau {mean:.1} N, ripple {spread:.0} N");
    assert_close("plateau, N", mean, 66_990.0, 5e-4);
}

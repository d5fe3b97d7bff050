//! A mass on a rope of 1 m, released from the horizontal, swings with the period 4 K(sin 45 deg) sqrt(L/g) = 2.36784 s at
//! g = 9.81 m/s^2, where K is the complete elliptic integral of the first kind.

use crate::support::{Run, assert_close};

#[test]
fn a_pendulum_from_the_horizontal_swings_with_the_elliptic_period() {
    let nodes = "id,x,y,z,mass,fixed\npivot,0,0,0,0,1\nbob,1,0,0,1,0\n";
    let scenario = "points = { P = \"bob\" }\n\
                    rope = { diameter = \"10 mm\", density = 10, elastic_modulus = \"78 GPa\" }\n\
                    environment = { gravity = 9.81 }\n\
                    solve = { duration = \"3.2 s\", segment_length = \"1 m\" }\n";
    let run = Run::graph(scenario, nodes, "a,b,segments\npivot,bob,1\n");

    // the bob passes below its pivot after a quarter of a period, then twice a period
    let (time, x) = (run.column("time_s"), run.column("P_x_m"));
    let below: Vec<f64> = (1..x.len())
        .filter(|&i| x[i - 1] * x[i] < 0.0)
        .map(|i| time[i - 1] + (time[i] - time[i - 1]) * x[i - 1] / (x[i - 1] - x[i]))
        .collect();
    let period = below[2] - below[0];
    println!("period {period:.6} s, quarter {:.6} s", below[0]);
    assert_close("period, s", period, 2.36784, 2e-5);
    assert_close("a quarter, s", below[0], 0.25 * 2.36784, 2e-5);
    // at the bottom the rope bears three times the weight
    let weight = 9.81 * run.model.system.mass()[1];
    assert_close("largest tension, N", run.summary.tension.max_n, 3.0 * weight, 1e-4);
}

//! A spinning ring of rope with the rim speed v has the tension T = mu v^2, whatever its radius. The founding paper's rope
//! at 50 m/s: 363.2 N.
//!
//! The ring stretches by e = T/EA. Its mass per length falls by the factor 1 + e, and so does its speed, since its angular
//! momentum is conserved. With v the speed of the slack ring, T (1 + e)^3 = mu v^2.

use std::fmt::Write;

use crate::support::{Run, assert_close};
use libm::{cos, sin};

const RADIUS: f64 = 0.5;
const SPEED: f64 = 50.0;
const SIDES: usize = 60;

#[test]
fn a_spinning_ring_has_the_tension_mu_v_squared() {
    let section = 0.25 * std::f64::consts::PI * 0.01 * 0.01;
    let (mass_per_metre, axial_stiffness) = (1850.0 * section, 78e9 * section);
    let mut nodes = "id,x,y,z,vx,vy\n".to_owned();
    let mut ropes = "a,b,segments\n".to_owned();
    for i in 0..SIDES {
        let angle = std::f64::consts::TAU * i as f64 / SIDES as f64;
        let (c, s) = (cos(angle), sin(angle));
        writeln!(nodes, "n{i},{},{},0,{},{}", RADIUS * c, RADIUS * s, -SPEED * s, SPEED * c).unwrap();
        writeln!(ropes, "n{i},n{},1", (i + 1) % SIDES).unwrap();
    }
    // the ring starts slack; damping in the rope ends its radial vibration
    let scenario = "rope = { diameter = \"10 mm\", density = 1850, elastic_modulus = \"78 GPa\", \
        damping_time = \"20 us\" }\n\
                    environment = { gravity = 0 }\n\
                    solve = { duration = \"20 ms\", segment_length = \"1 m\" }\n";
    let run = Run::graph(scenario, &nodes, &ropes);

    let simple = mass_per_metre * SPEED * SPEED;
    assert_close("mu v^2, N", simple, 363.2, 2e-4);
    // T (1 + T/EA)^3 = mu v^2 by iteration
    let exact = (0..20).fold(simple, |tension, _| simple / (1.0 + tension / axial_stiffness).powi(3));
    let tensions = run.fields.tensions(run.fields.times.len() - 1);
    let turns = SPEED * 20e-3 / (std::f64::consts::TAU * RADIUS);
    println!("after {turns:.2} turns {:.4} N, exact {exact:.4} N, mu v^2 {simple:.4} N", tensions[0]);
    for &found in tensions {
        assert_close("tension, N", found, exact, 1e-6);
    }
}

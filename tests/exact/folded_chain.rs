//! A chain is folded in the middle; one end is held, the other is released and falls faster than a free body (Calkin and
//! March, Am. J. Phys. 57, 1989; Wong and Yasui, Am. J. Phys. 74, 2006). Conservation of energy gives the speed v of the
//! free end after a fall y:
//!
//! ```text
//! v^2 = 2 g y (1 - y/2L) / (1 - y/L)        time to y = L: 0.84721 sqrt(2L/g)
//! ```

use crate::support::{Run, assert_close};

const LENGTH: f64 = 2.0;
const GRAVITY: f64 = 9.81;

/// v^2, m^2/s^2, after a fall of `y`, m.
fn speed_squared(y: f64) -> f64 {
    2.0 * GRAVITY * y * (1.0 - 0.5 * y / LENGTH) / (1.0 - y / LENGTH)
}

#[test]
fn the_free_end_of_a_folded_chain_falls_with_the_speed_of_energy_conservation() {
    // both legs hang side by side, 0.01 m apart at the fold; the chain starts in its hanging shape
    let count = 200;
    let link = LENGTH / count as f64;
    let mut nodes = String::from("id,x,y,z,mass,fixed\n");
    let mut ropes = String::from("a,b,segments\n");
    for i in 0..=count {
        let (down, far) = (i.min(count - i) as f64, i > count / 2);
        // the legs are one link apart: the lowest link is horizontal
        let x = if far { link } else { 0.0 };
        nodes += &format!("n{i},{x},0,{},0,{}\n", -down * link, u8::from(i == 0));
        if i > 0 {
            ropes += &format!("n{},n{i},1\n", i - 1);
        }
    }
    let scenario = format!(
        "points = {{ E = \"n{count}\" }}\nenvironment = {{ gravity = {GRAVITY} }}\n\
         rope = {{ diameter = \"2 mm\", density = 1000, elastic_modulus = \"1 GPa\", damping_ratio = 0.05 }}\n\
         solve = {{ duration = \"0.55 s\", segment_length = 1 }}\nrecord.every = \"1 ms\"\n"
    );
    let run = Run::graph(&scenario, &nodes, &ropes);
    let (time, z, speed) = (run.column("time_s"), run.column("E_z_m"), run.column("E_speed_m_s"));
    for share in [0.25, 0.5, 0.75, 0.9] {
        let i = z.iter().position(|z| -z >= share * LENGTH).expect("it falls");
        let expected = speed_squared(-z[i]).sqrt();
        println!("fallen {:.3} L at {:.4} s: {:.4} m/s, expected {expected:.4} m/s", -z[i] / LENGTH, time[i], speed[i]);
        assert_close("speed, m/s", speed[i], expected, 0.02);
    }
    // the closed form gives the time of the last stretch of the fall
    let i = z.iter().position(|z| -z >= 0.95 * LENGTH).expect("it falls");
    let rest = 100_000;
    let step = (LENGTH + z[i]) / f64::from(rest);
    let left: f64 = (0..rest).map(|k| step / speed_squared(-z[i] + step * (f64::from(k) + 0.5)).sqrt()).sum();
    let free = (2.0 * LENGTH / GRAVITY).sqrt();
    println!("time of fall {:.4} of free fall, expected 0.8472", (time[i] + left) / free);
    assert_close("time of fall over that of free fall", (time[i] + left) / free, 0.84721, 0.01);
}

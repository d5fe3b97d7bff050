//! A jerked rope breaks at its weak piece, at the load and time of the wave equation. Summary, fields, words and energy
//! report the break.

use crate::support::{Run, assert_close};

const NODES: &str =
    "id,x,y,z,mass,fixed,vx\nfar,0,0,0,0,1,0\none,2,0,0,0,0,0\ntwo,2.02,0,0,0,0,0\njerked,5,0,0,1e3,0,71\n";
const ROPES: &str = "a,b,rope,class,segments\nfar,one,,shank,100\none,two,weak,weak link,1\ntwo,jerked,,shank,149\n";

/// The founding paper's rope with a `weak` piece. Its end is jerked along it at 71 m/s: 66.99 kN until the wave returns.
fn jerked(weak: &str) -> Run {
    let material = "diameter = \"10 mm\", density = 1850, elastic_modulus = \"78 GPa\", damping_ratio = 0.05";
    let scenario = format!(
        "rope = {{ {material} }}\nropes.weak = {{ {material}, {weak} }}\nenvironment = {{ gravity = 0 }}\n\
         solve = {{ duration = \"1.4 ms\", segment_length = 1 }}\nrecord = {{ every = \"10 us\" }}\n"
    );
    Run::graph(&scenario, NODES, ROPES)
}

#[test]
fn a_jerked_rope_breaks_at_its_weak_piece() {
    let load = 30e3;
    let run = jerked("strength = \"30 kN\", breaking = {}");
    let [told] = &run.summary.breaks[..] else { panic!("{:?}", run.summary.breaks) };
    assert_eq!((&told.place[..], &told.class[..], told.segment), ("segment 1 of weak link rope 1", "weak link", 100));
    // the front starts at the jerked end, 3 m away, and is a few segments wide
    let wave_speed = (78e9f64 / 1850.0).sqrt();
    assert_close("time, s", told.time_s, 2.99 / wave_speed, 0.01);
    let gain = 78e9 * 0.25e-4 * std::f64::consts::PI / 0.02 * 71.0 * run.summary.step.dt_s;
    println!("{:.0} N at {:.1} us; a step gains at most {gain:.0} N", told.tension_n, 1e6 * told.time_s);
    assert!(told.tension_n > load && told.tension_n < load + gain);

    let tension = &run.summary.tension;
    assert_eq!((told.released, tension.broken_segments, tension.first_break_time_s), (false, 1, Some(told.time_s)));

    // after the break the weak piece has no tension, written as NaN
    let fields = &run.fields;
    for (frame, &time) in fields.times.iter().enumerate() {
        let tension = fields.tensions(frame)[told.segment];
        assert_eq!(tension.is_nan(), time > told.time_s, "{tension} N at {time} s");
    }
    // the ends fly apart and the energy of the break is in the ledger
    let last = fields.positions(fields.times.len() - 1);
    assert!((last[2] - last[1]).length() > 0.04, "{} m", (last[2] - last[1]).length());
    assert!(run.summary.energy.channels["rupture"] > 0.0);
    let words = netcast::report::words(&run.summary);
    assert!(words.iter().any(|s| s.starts_with("Something breaks: segment 1 of weak link rope 1 at ")), "{words:?}");
}

#[test]
fn the_energy_balance_of_the_rope_itself_closes_through_the_break() {
    let run = jerked("breaking.strain = 0.005");
    assert_eq!(run.summary.breaks.len(), 1);
    // the rope's own energy at 71 m/s: mass 0.73 kg
    let own = 0.5 * 0.25e-4 * std::f64::consts::PI * 5.0 * 1850.0 * 71.0 * 71.0;
    let missing = run.summary.energy.largest_residual_j / own;
    println!("{:.2e} of the rope's own energy is missing", missing);
    assert!(missing < 1e-3, "{missing}");
}

#[test]
fn a_rope_with_a_strength_alone_has_a_margin_and_does_not_break() {
    let run = jerked("strength = \"30 kN\"");
    assert!(run.summary.breaks.is_empty());
    assert!(run.summary.tension.by_class["weak link"].margin.unwrap() < 0.5);
}

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

/// A mass of 1 kg that hangs on two metres of rope in equilibrium, cut halfway after 50 ms.
#[test]
fn a_mass_falls_freely_from_the_time_at_which_its_rope_is_cut() {
    let (cut_at, end) = (0.05, 0.25);
    let scenario = format!(
        "rope = {{ diameter = \"4 mm\", density = 1000, elastic_modulus = \"0.2 GPa\", damping_ratio = 0.05 }}\n\
         environment = {{ gravity = 9.80665, damping = 0 }}\nrecord.every = \"10 ms\"\npoints.M = \"mass\"\n\
         solve = {{ duration = {end}, segment_length = 0.25, static = {{ then_run = true, tolerance = 1e-9 }} }}\n\
         [[cuts]]\nlink = \"inner\"\ntime = {cut_at}\n"
    );
    let nodes = "id,x,y,z,mass,fixed\ntop,0,0,0,0,1\nmass,0,0,-2,1,0\n";
    let run = Run::graph(&scenario, nodes, "a,b,class\ntop,mass,inner\n");
    let [told] = &run.summary.breaks[..] else { panic!("{:?}", run.summary.breaks) };
    assert!(told.cut && told.released && told.place.starts_with("segment 5"), "{told:?}");
    assert!((0.0..=run.summary.step.dt_s).contains(&(told.time_s - cut_at)), "{}", told.time_s);
    assert_eq!(run.summary.tension.broken_segments, 0);

    // the mass and the rope that is left below the cut fall freely; what the rope stretched by goes round in it, as a shiver
    let fields = &run.fields;
    let centre = |frame: usize| {
        let (places, mass) = (fields.positions(frame), run.model.system.parts().mass.as_slice());
        // the top and the last node above the cut stay
        let below: Vec<usize> = (1..places.len()).filter(|&node| node == 1 || node > 5).collect();
        let total: f64 = below.iter().map(|&node| mass[node]).sum();
        below.iter().map(|&node| mass[node] * places[node].z).sum::<f64>() / total
    };
    let last = fields.times.len() - 1;
    let fallen = centre(0) - centre(last);
    let time = fields.times[last] - told.time_s;
    println!("fallen {fallen:.6} m, freely {:.6} m", 0.5 * 9.80665 * time * time);
    // its last tension acts for one step more, the same time as a step of the fall
    assert_close("fall, m", fallen, 0.5 * 9.80665 * time * time, 3.0 * run.summary.step.dt_s / time);
    assert!(run.summary.energy.closure < 3e-3, "{}", run.summary.energy.closure);
}

#[test]
fn a_cut_names_a_link_that_the_web_has() {
    let scenario = "rope = { diameter = \"4 mm\", density = 1000, elastic_modulus = \"1 GPa\" }\nsolve.duration = \"1 ms\"\n\
                    [[cuts]]\nlink = \"iner\"\ntime = \"2 ms\"\n";
    let refused = std::panic::catch_unwind(|| Run::graph(scenario, "id,x,y,z\na,0,0,0\nb,1,0,0\n", "a,b\na,b\n"));
    let told = refused.err().and_then(|panic| panic.downcast_ref::<String>().cloned()).expect("a refusal");
    assert!(told.contains("did you mean \"inner\"?") && told.contains("graph.toml:4"), "{told}");

    let run = Run::graph(&scenario.replace("iner", "inner"), "id,x,y,z\na,0,0,0\nb,1,0,0\n", "a,b\na,b\n");
    let notes = &run.model.notes;
    assert!(run.summary.breaks.is_empty() && notes.iter().any(|note| note.contains("is not cut")), "{notes:?}");
}

//! Break ties and stitches break at their load, at the time of a closed form.

use crate::support::{Run, assert_close};

/// A mass of about 1 kg, 0.1 m from a held point. The ropes that make the web always stay slack.
const NODES: &str = "id,x,y,z,mass,fixed,vx\nheld,-0.1,0,0,0,1,0\nmass,0,0,0,1,0,SPEED\nend,0,1,0,0.1,0,0\n";
const ROPES: &str = "a,b,rest_length,segments\nmass,end,50,1\nheld,end,50,1\n";

fn run(speed: &str, ties: &str) -> Run {
    let scenario = format!(
        "points.M = \"mass\"\nrope = {{ diameter = \"1 mm\", density = 1000, elastic_modulus = \"1 GPa\" }}\n\
         environment.gravity = 0\nsolve = {{ duration = \"0.2 s\", segment_length = 1, step_fraction = 0.001 }}\n\
         record.every = \"1 ms\"\n{ties}"
    );
    Run::graph(&scenario, &NODES.replace("SPEED", speed), ROPES)
}

/// The tied mass, kg.
fn mass(run: &Run) -> f64 {
    run.model.system.mass()[1]
}

#[test]
fn a_tie_under_a_rising_load_breaks_at_its_breaking_load() {
    // 10 % at 50 N over 0.1 m: 5000 N/m
    let (load, stiffness, rate) = (50.0, 5e3, 500.0);
    let ties = "break_ties = [{ pairs = [[\"held\", \"mass\"]], breaking_load = \"50 N\" }]\n\
                load.pull = { force = [100, 0, 0], nodes = [\"mass\"], ramp = \"0.2 s\" }\n";
    let run = run("0", ties);
    let [told] = &run.summary.breaks[..] else { panic!("{:?}", run.summary.breaks) };
    assert_eq!(
        (&told.place[..], &told.class[..], told.released),
        ("break tie 1 at knot held to knot mass", "tie", true)
    );
    // a mass on a spring under a load that grows at a constant rate: T = rate (t - sin(w t) / w)
    let omega = (stiffness / mass(&run)).sqrt();
    let tension = |t: f64| rate * (t - libm::sin(omega * t) / omega);
    let (mut early, mut late) = (0.05, 0.15);
    for _ in 0..60 {
        let middle = 0.5 * (early + late);
        if tension(middle) < load { early = middle } else { late = middle }
    }
    let dt = run.summary.step.dt_s;
    println!("lets go at {:.6} s, {:.3} N; {early:.6} s by the closed form", told.time_s, told.tension_n);
    assert!((told.time_s - early).abs() < 1.5 * dt, "{} and not {early}", told.time_s);
    assert!(told.tension_n > load && told.tension_n < load + 2.0 * rate * dt);
    // a tie is not a rope: it counts neither in the largest tension nor among the broken segments
    assert_eq!((run.summary.tension.max_n, run.summary.tension.broken_segments), (0.0, 0));
    assert_close("tie, N", run.summary.tension.by_class["tie"].max_n, told.tension_n, 1e-12);
    assert_close("rupture, J", run.last("energy_rupture_j"), 0.5 * load * load / stiffness, 1e-3);
    assert!(run.summary.energy.closure < 1e-5, "{}", run.summary.energy.closure);
    let words = netcast::report::words(&run.summary);
    assert!(words.iter().any(|said| said.starts_with("One tie lets go: break tie 1 at ")), "{words:?}");
}

#[test]
fn a_flying_mass_breaks_its_tie_and_loses_the_energy_of_the_break() {
    let (load, length, stiffness, speed) = (200.0, 0.05, 200.0 / (0.2 * 0.05), 4.0);
    let ties =
        "break_ties = [{ points = [\"M\"], breaking_load = \"200 N\", breaking_strain = 0.2, length = \"50 mm\" }]\n";
    let run = run("4", ties);
    let [told] = &run.summary.breaks[..] else { panic!("{:?}", run.summary.breaks) };
    let mass = mass(&run);
    let omega = (stiffness / mass).sqrt();
    let at = length / speed + libm::asin(load * omega / (stiffness * speed)) / omega;
    assert!((told.time_s - at).abs() < 1.5 * run.summary.step.dt_s, "{} and not {at}", told.time_s);
    let left = (speed * speed - load * load / (stiffness * mass)).sqrt();
    assert_close("speed after it, m/s", run.last("M_speed_m_s"), left, 1e-3);
    assert!(run.summary.energy.closure < 1e-3, "{}", run.summary.energy.closure);
}

#[test]
fn a_slow_mass_does_not_break_its_tie() {
    let ties = "break_ties = [{ nodes = [\"mass\"], breaking_load = \"200 N\", breaking_strain = 0.2 }]\n";
    let run = run("0.5", ties);
    assert!(run.summary.breaks.is_empty());
    let farthest = run.column("M_x_m").into_iter().fold(0.0, f64::max);
    // 10 mm and the stretch of a spring of 100 kN/m
    assert_close("farthest, m", farthest, 0.01 + 0.5 * (mass(&run) / 1e5).sqrt(), 2e-3);
}

/// A strap is folded once; its legs are 20 mm apart and stitched every 0.1 m, and its ends are drawn apart. One stitch after
/// the other bears the whole pull and breaks when the strap between it and the ends is straight.
#[test]
fn stitches_of_a_folded_strap_break_one_after_the_other() {
    let speed = 1.0;
    let nodes = "id,x,y,z,fixed\nheld,0,0,0,1\nfold,0.5,0,0,0\nback,0.5,0.02,0,0\npulled,0,0.02,0,0\n";
    let ropes = "a,b,class,segments\nheld,fold,strap,5\nfold,back,strap,1\nback,pulled,strap,5\n";
    let scenario = "rope = { diameter = \"2 mm\", density = 1000, elastic_modulus = \"5 GPa\", damping_ratio = 0.2 }\n\
         stitches = [{ class = \"strap\", reach = \"25 mm\", breaking_load = \"20 N\", breaking_strain = 0.05 }]\n\
         drive.away = { path = [{ time = \"1 s\", by = [0, \"1 m\", 0] }], nodes = [\"pulled\"] }\n\
         environment = { gravity = 0, damping = 20 }\nsolve = { duration = \"1 s\", segment_length = 1 }\n\
         record.every = \"10 ms\"\n";
    let run = Run::graph(scenario, nodes, ropes);
    // one stitch at the ends and four along the legs
    assert_eq!(run.summary.breaks.len(), 5);
    for (number, told) in run.summary.breaks.iter().enumerate() {
        assert_eq!((&told.place[..], &told.class[..]), (&format!("stitch {} of row 1", number + 1)[..], "stitch"));
        let (stitch, leg) = (0.02 * 1.05, 0.1 * number as f64);
        let at = (2.0 * leg + stitch - 0.02) / speed;
        println!("{}: {:.4} s, {:.2} N; straight at {at:.4} s", told.place, told.time_s, told.tension_n);
        assert!((told.time_s - at).abs() < 2e-3, "{} and not {at}", told.time_s);
        assert!(told.tension_n > 20.0 && told.tension_n < 24.0, "{told:?}");
    }
    assert!(run.summary.energy.closure < 5e-3, "{}", run.summary.energy.closure);
}

//! What a run leaves: the last row of a rope's table, the peak of a gust shorter than its step.

use crate::support::Run;
use netcast::scenario::Source;
use netcast::{Case, Document, Failure};
use tempfile::TempDir;

/// A mass of 1 kg on 1 m of rope that is pulled straight at 5 m/s, with a table that ends at a strain of 1 % and 100 N.
fn jerked(beyond: &str) -> (Option<Failure>, netcast::results::Summary) {
    let inputs = TempDir::new().unwrap();
    let write = |name: &str, text: &str| std::fs::write(inputs.path().join(name), text).unwrap();
    write("nodes.csv", "id,x,y,z,mass,vx,fixed\na,0,0,0,0,0,1\nb,1,0,0,1,5,0\n");
    write("ropes.csv", "a,b,segments\na,b,1\n");
    write("table.csv", "strain,tension\n0,0\n0.005,20\n0.01,100\n");
    let text = format!(
        "[web.graph]\nnodes = \"nodes.csv\"\nropes = \"ropes.csv\"\n[rope]\ndiameter = \"4 mm\"\ndensity = 1000\n\
         elastic_modulus = \"1 GPa\"\ndamping_ratio = 0\nlaw.table = {{ file = \"table.csv\"{beyond} }}\n\
         [environment]\ngravity = 0\n[solve]\nduration = \"50 ms\"\nstep_fraction = 0.02\n[record]\nevery = \"1 ms\"\n"
    );
    let document = Document::parse(Source { name: "jerk.toml".into(), text }, inputs.path(), &[]);
    let case = Case::of(document.unwrap_or_else(|e| panic!("{e}"))).unwrap_or_else(|e| panic!("{e}"));
    let target = inputs.path().join("run");
    let ran = case.simulation().threads(1).run_to(&target).unwrap_or_else(|e| panic!("{e}"));
    (ran.failure, ran.summary)
}

#[test]
fn a_rope_stretched_beyond_its_table_is_told_stops_the_run_or_breaks() {
    let (failure, summary) = jerked("");
    let strain = summary.tension.by_rope["rope"].strain_max.unwrap();
    // the mass and half of the rope's; 0.05 J up to 0.5 %, 0.3 J up to 1 %, then a slope of 16,000 N
    let mass = 1.0 + 0.5 * 1000.0 * 0.25 * std::f64::consts::PI * 0.004 * 0.004;
    let exact = 0.01 + (-100.0 + f64::sqrt(100.0 * 100.0 + 2.0 * 16e3 * (12.5 * mass - 0.35))) / 16e3;
    println!("strain {strain} instead of {exact}: {:?}", summary.warnings);
    assert!((strain / exact - 1.0).abs() < 1e-3);
    assert!(failure.is_none() && summary.warnings.iter().any(|told| told.contains("last row of its table")));

    let (failure, summary) = jerked(", beyond = \"stop\"");
    let told = failure.expect("a failure").to_string();
    assert!(told.contains("segment 1") || told.contains("rope 1"), "{told}");
    assert!(told.contains("beyond the last row") && !summary.finished, "{told}");
    // a step adds at most 26 N
    assert!(summary.tension.max_n < 126.0, "{}", summary.tension.max_n);

    let (failure, summary) = jerked(", beyond = \"break\"");
    assert!(failure.is_none() && summary.breaks.len() == 1, "{failure:?} {:?}", summary.breaks);
    assert!((100.0..126.0).contains(&summary.tension.max_n), "{}", summary.tension.max_n);
}

/// A gust of 10 us in a run of steps of 30 us: a rope of 1 g that it meets takes up the impulse of its drag.
#[test]
fn a_gust_shorter_than_a_step_is_not_missed() {
    let peak = |solve: &str| {
        let scenario = format!(
            "rope = {{ diameter = \"3 mm\", density = 1140, elastic_modulus = \"3 GPa\", damping_ratio = 0.05 }}\n\
             environment = {{ gravity = 0, air = {{}}, wind = {{ speed = 1, gust = {{ speed = 5e3, at = \"1 ms\", duration = \
             \"10 us\" }} }} }}\nsolve = {{ duration = \"2 ms\"{solve} }}\nrecord.every = \"1 ms\"\npoints.M = \"m\"\n"
        );
        let nodes = "id,x,y,z\na,0,-1,0\nm,0,0,0\nb,0,1,0\n";
        let run = Run::graph(&scenario, nodes, "a,b,segments\na,m,4\nm,b,4\n");
        run.summary.points["M"].as_ref().unwrap().peak_speed_m_s.unwrap()
    };
    let (chosen, fine) = (peak(""), peak(", step_fraction = 0.002"));
    println!("{chosen} m/s at the chosen step, {fine} m/s at a much finer one");
    assert!((chosen / fine - 1.0).abs() < 0.02);
}

//! Runs that were right and failed: their energy was compared without a scale, or at records only, or the step that
//! netcast chose missed the tolerance that it set itself.

use netcast::scenario::Source;
use netcast::{Case, Document, Run};

use crate::support;

/// A square net of 2 m in the plane, without gravity.
const SQUARE: &str = r#"
    web.square = { side = "2 m", mesh = "0.5 m" }
    rope = { diameter = "3 mm", density = 1440, elastic_modulus = "7 GPa" }
    environment.gravity = 0
    solve = { duration = "20 ms", segment_length = "0.2 m" }
"#;

fn case(text: &str) -> Case {
    let source = Source { name: "case.toml".into(), text: text.to_owned() };
    let document = Document::parse(source, std::path::Path::new("."), &[]).unwrap_or_else(|e| panic!("{e}"));
    Case::of(document).unwrap_or_else(|e| panic!("{e}"))
}

fn run(text: &str) -> Run {
    let run = case(text).simulation().threads(1).run().unwrap();
    assert_eq!(run.failure, None, "{:?}", run.summary.energy);
    run
}

#[test]
fn a_net_that_rests_until_it_is_driven_does_not_gain_energy_without_end() {
    let path = r#"[{ time = "5 ms", by = [0, 0, 0] }, { time = "15 ms", by = [0, 0, "0.05 m"] }]"#;
    let run = run(&format!("{SQUARE}\nhold.corners = true\ndrive.e = {{ points = [\"B\"], path = {path} }}"));
    assert!(run.summary.finished && run.summary.opening.area_max_m2.is_some());
}

#[test]
fn a_net_that_rests_until_all_tractors_are_thrown_does_not_gain_energy_without_end() {
    let delays =
        (1..=4).map(|corner| format!("{{ corner = {corner}, delay = \"5 ms\" }}")).collect::<Vec<_>>().join(",");
    let thrown = r#"tractor.particle.mass = "0.3 kg"
        launch = { axial_speed = "20 m/s", radial_speed = "8 m/s" }"#;
    let run = run(&format!("{SQUARE}\n{thrown}\ntractors = [{delays}]"));
    let tractor = run.summary.points["tractor"].clone().unwrap();
    assert!(tractor.peak_speed_m_s.unwrap() > 20.0);
}

#[test]
fn a_web_that_holds_next_to_no_energy_is_not_judged_by_it() {
    let run = run(r#"
        web.square = { side = "2 m", mesh = "0.5 m" }
        rope = { diameter = "3 mm", density = "1e-3 kg/m^3", elastic_modulus = "3 GPa", damping_ratio = 0.05 }
        tractor.particle.mass = "0.3 kg"
        stow.scale.factor = 0.4
        launch = { axial_speed = "20 m/s", radial_speed = "8 m/s" }
        solve = { duration = "1 ms" }
    "#);
    assert!(run.summary.energy.closure < 1e-5, "{}", run.summary.energy.closure);
}

#[test]
fn what_damping_takes_from_tractors_is_not_charged_to_the_web() {
    for damping in [100.0, 1000.0, 50_000.0] {
        let overrides = [format!("environment.damping={damping}"), "solve.duration=\"0.1 s\"".to_owned()];
        let file = support::examples().join("04_square_net/square_net.toml");
        let run = Case::read(file, &overrides).unwrap().simulation().threads(1).run().unwrap();
        let energy = &run.summary.energy;
        println!("{damping} 1/s: closes to {}, the web's to {:?}", energy.closure, energy.closure_web);
        assert_eq!(run.failure, None, "{damping}");
    }
}

#[test]
fn a_step_that_netcast_chose_and_that_misses_the_tolerance_is_taken_smaller_once() {
    let text = r#"
        [web.graph]
        nodes = "nodes.csv"
        ropes = "ropes.csv"
        [rope]
        material = "nylon rope"
        diameter = "8 mm"
        damping_ratio = 0
        [environment]
        gravity = "0 m/s^2"
        [solve]
        duration = "2 s"
        segment_length = "1 m"
    "#;
    let run = support::Run::graph(text, "id,x,y,z,mass,vx\na,0,0,0,1,0\nb,0.5,0,0,1,10\n", "a,b,rest_length\na,b,5\n");
    let warning = run.summary.warnings.first().expect("it says so");
    assert!(warning.starts_with("the run was done again with solve.step_fraction"), "{warning}");
    assert!(run.summary.energy.closure <= run.summary.energy.tolerance);
}

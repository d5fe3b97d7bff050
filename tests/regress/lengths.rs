//! Lengths that a graph leaves to the program: at rest, where a rope is drawn stretched; of segments, where it hangs straight.

use crate::support::{Run, assert_close};
use netcast::scenario::Source;
use netcast::{Case, Document};
use tempfile::TempDir;

const ROPE: &str = "[rope]\ndiameter = \"8 mm\"\ndensity = 745\nelastic_modulus = \"1.32 GPa\"\n";

/// What is said of a scenario that is refused.
fn refusal(scenario: &str, ropes: &str) -> String {
    let inputs = TempDir::new().unwrap();
    for (name, text) in [("nodes.csv", "id,x,y,z,fixed\na,0,0,0,1\nb,1,0,0,0\n"), ("ropes.csv", ropes)] {
        std::fs::write(inputs.path().join(name), text).unwrap();
    }
    let text = format!("[web.graph]\nnodes = \"nodes.csv\"\nropes = \"ropes.csv\"\n{ROPE}{scenario}");
    match Document::parse(Source { name: "lengths.toml".into(), text }, inputs.path(), &[]) {
        Err(refused) => refused.to_string(),
        Ok(document) => Case::of(document).expect_err("the scenario is refused").to_string(),
    }
}

#[test]
fn a_rope_is_not_given_both_a_rest_length_and_a_pretension() {
    let rest = "[solve]\nduration = \"2 ms\"\nsegment_length = \"0.25 m\"\n";
    let row = refusal(rest, "a,b,rest_length,pretension\na,b,0.999,1000\n");
    assert!(row.contains("ropes.csv:2") && row.contains("two ways"), "{row}");
    let kind = refusal(&format!("pretension = \"1 kN\"\n{rest}"), "a,b,rest_length\na,b,0.999\n");
    assert!(kind.contains("lengths.toml:8") && kind.contains("line 2"), "{kind}");
}

/// A rope of 10 m drawn with a strain of 10 %: 9.09 m at rest.
#[test]
fn the_bill_counts_a_stretched_rope_by_its_length_at_rest() {
    let tension = 0.1 * 1.32e9 * 0.25 * std::f64::consts::PI * 64e-6;
    let solve = "environment.gravity = 0\nsolve = { duration = \"1 ms\", segment_length = \"0.5 m\" }\n";
    let nodes = "id,x,y,z,fixed\na,0,0,0,1\nm,4,0,0,0\nb,10,0,0,1\n";
    let run = Run::graph(&format!("{solve}{ROPE}"), nodes, &format!("a,b,pretension\na,m,{tension}\nm,b,{tension}\n"));
    let (bill, exact) = (&run.model.bill, 10.0 / 1.1);
    assert_close("length of the bill, m", bill.ropes[0].length, exact, 1e-12);
    let links: f64 = run.model.links().iter().map(|link| link.length).sum();
    assert_close("length of the links, m", links, exact, 1e-12);
    assert_close("mass of the bill, kg", bill.total_mass(), run.model.system.parts().mass.iter().sum(), 1e-12);
}

#[test]
fn a_rope_that_hangs_straight_or_nearly_so_is_cut_into_segments_of_its_own_length() {
    for aside in [0.0, 0.001, 1.0] {
        let solve = "environment.gravity = 0\nsolve.duration = \"1 ms\"\n";
        let nodes = format!("id,x,y,z,fixed\na,0,0,0,1\nb,{aside},0,-10,0\n");
        let run = Run::graph(&format!("{solve}{ROPE}"), &nodes, "a,b\na,b\n");
        assert_eq!(run.model.system.parts().segments.len(), 50, "{aside} m aside");
    }
}

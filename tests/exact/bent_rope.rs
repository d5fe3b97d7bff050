//! A rope with bending stiffness between two supports, under its own weight, against the beam with hinged ends:
//!
//! ```text
//! sag in the middle = 5 q L^4 / (384 EI),        first period = (2 L^2 / pi) sqrt(mu / EI)
//! ```
//!
//! (Timoshenko, Strength of Materials; Vibration Problems in Engineering.) A rope turns freely where it is held, so a rope
//! between two supports is hinged; built in at both ends it sags by q L^4 / (384 EI), at one alone by q L^4 / (8 EI). Its axial stiffness is negligible: else tension between the fixed supports would hold it up.

use std::f64::consts::PI;

use crate::support::{Run, assert_close};

const EI: f64 = 2.0;
const SEGMENTS: usize = 20;
/// Mass per length, kg/m, of a rope of 10 mm at 1000 kg/m^3. Gravity is 1 m/s^2 and the span 1 m.
const MU: f64 = 1000.0 * 0.25 * PI * 1e-4;
const SAG: f64 = 5.0 * MU / (384.0 * EI);

/// Times, s, and heights, m, of the middle of the rope after its weight is suddenly applied.
fn beam(damping: f64, duration: f64) -> (Vec<f64>, Vec<f64>) {
    let scenario = format!(
        "rope = {{ diameter = 0.01, density = 1000, elastic_modulus = 1e5, damping_ratio = 0, bending_stiffness = {EI} }}\n\
         environment = {{ gravity = 1, damping = {damping} }}\n\
         solve = {{ duration = {duration}, segment_length = 1 }}\n\
         record.every = 0.002\n"
    );
    let nodes = "id,x,y,z,mass,fixed\na,0,0,0,0,1\nb,1,0,0,0,1\n";
    let run = Run::graph(&scenario, nodes, &format!("a,b,segments\na,b,{SEGMENTS}\n"));
    // nodes inside the rope follow its two knots
    let middle = |step| run.fields.positions(step)[1 + SEGMENTS / 2].z;
    ((run.fields.times.clone()), (0..run.fields.times.len()).map(middle).collect())
}

#[test]
fn a_rope_that_resists_bending_sags_as_a_beam() {
    let (_, height) = beam(60.0, 1.0);
    let sag = -height[height.len() - 1];
    println!("sag {:.4} mm, of a beam {:.4} mm", 1e3 * sag, 1e3 * SAG);
    assert_close("sag, m", sag, SAG, 5e-3);
}

#[test]
fn a_rope_that_resists_bending_vibrates_as_a_beam() {
    // it vibrates about its sag in the first mode, with 1/243 of the third
    let (time, height) = beam(0.0, 1.2);
    let rising = |&i: &usize| height[i - 1] < -SAG && height[i] >= -SAG;
    let crossing =
        |i: usize| time[i - 1] + (time[i] - time[i - 1]) * (-SAG - height[i - 1]) / (height[i] - height[i - 1]);
    let ups: Vec<f64> = (1..height.len()).filter(rising).map(crossing).collect();
    let period = (ups[ups.len() - 1] - ups[0]) / (ups.len() - 1) as f64;
    let expected = 2.0 / PI * (MU / EI).sqrt();
    println!("period {period:.5} s, of a beam {expected:.5} s");
    assert_close("period, s", period, expected, 1e-2);
}

/// The sag, m, of a rope of so many segments at rest, with the notes of its model. `rows`: one row for all segments, or a row
/// a segment as meshes are exported. `right`: whether the right end is fixed. `hold`: more keys of the scenario.
fn at_rest(segments: usize, rows: bool, right: &str, hold: &str) -> (f64, Vec<String>) {
    let scenario = format!(
        "rope = {{ diameter = 0.01, density = 1000, elastic_modulus = 1e5, bending_stiffness = {EI} }}\n\
         environment.gravity = 1\nsolve.static.tolerance = 1e-9\nsolve.segment_length = 0.05\n{hold}"
    );
    let mut nodes = format!("id,x,y,z,fixed\nleft,0,0,0,1\nright,1,0,0,{right}\n");
    let mut ropes = "a,b,segments\n".to_owned();
    if rows {
        let name = |i: usize| match i {
            0 => "left".to_owned(),
            i if i == segments => "right".to_owned(),
            i => format!("p{i}"),
        };
        (1..segments).for_each(|i| nodes += &format!("p{i},{},0,0,0\n", i as f64 / segments as f64));
        (0..segments).for_each(|i| ropes += &format!("{},{},1\n", name(i), name(i + 1)));
    } else {
        ropes += &format!("left,right,{segments}\n");
    }
    let run = Run::graph(&scenario, &nodes, &ropes);
    let places = run.fields.positions(run.fields.times.len() - 1);
    (-places.iter().map(|place| place.z).fold(0.0, f64::min), run.model.notes)
}

#[test]
fn a_rope_that_a_mesh_gives_piece_by_piece_bends_as_one_rope() {
    let [(one, _), (pieces, notes)] = [at_rest(SEGMENTS, false, "1", ""), at_rest(SEGMENTS, true, "1", "")];
    println!("sag {:.6} mm as one rope, {:.6} mm in pieces: {notes:?}", 1e3 * one, 1e3 * pieces);
    assert_close("sag, m", pieces, one, 1e-6);
    assert!(notes.iter().any(|note| note.contains("through 19 knots")), "{notes:?}");
}

#[test]
fn a_rope_clamped_at_one_end_or_both_bends_as_a_built_in_beam() {
    for (what, right, hold, share) in [
        ("both ends", "1", "hold.clamped = [\"left\", \"right\"]\n", 1.0 / 384.0),
        ("a cantilever", "0", "hold.clamped = [\"left\"]\n", 1.0 / 8.0),
    ] {
        let exact = share * MU / EI;
        for rows in [false, true] {
            let [coarse, fine] = [20, 40].map(|segments| at_rest(segments, rows, right, hold).0);
            let order = ((coarse - exact) / (fine - exact)).log2();
            let limit = (4.0 * fine - coarse) / 3.0;
            println!("{what}: sag {:.6} mm, of a beam {:.6} mm, order {order:.3}", 1e3 * limit, 1e3 * exact);
            assert_close("sag in the limit of short segments, m", limit, exact, 5e-4);
            assert!((order - 2.0).abs() < 0.1, "{what}: order {order}");
        }
    }
}

#[test]
fn ropes_that_meet_at_an_angle_turn_freely_at_their_knot() {
    let scenario = "rope = { diameter = 0.01, density = 1000, elastic_modulus = 1e8, bending_stiffness = 2 }\n\
                    environment.gravity = 0\nsolve = { duration = \"10 ms\", segment_length = 1 }\n";
    let nodes = "id,x,y,z\na,0,0,0\nb,1,0,0\nc,1,1,0\n";
    let run = Run::graph(scenario, nodes, "a,b,segments\na,b,1\nb,c,1\n");
    let places = run.fields.positions(run.fields.times.len() - 1);
    assert!(places.iter().zip(run.fields.positions(0)).all(|(now, first)| now == first));
    let notes = &run.model.notes;
    assert!(notes.iter().any(|note| note.contains("rope.bending_stiffness does nothing")), "{notes:?}");
}

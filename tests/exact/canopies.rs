//! Each kind of canopy in a launch: the energy balance closes, the symmetry is kept, and threads change no bit.

use std::f64::consts::FRAC_PI_3;

use crate::support::Run;
use glam::{DMat3, DVec3};
use netcast::dynamics::time::step::Stepper;
use netcast::scenario::Source;
use netcast::{Document, Model};

const KINDS: [(&str, &str); 5] = [
    ("links", "links = {}"),
    ("rigid", "rigid = {}"),
    ("plate", "membrane = {}"),
    // softer and less damped, for a step five times as long
    (
        "plate on patches",
        "membrane = { fineness = 3, tie_radius = \"50 mm\", elastic_modulus = \"9 GPa\", damping_ratio = 0.01 }",
    ),
    ("cloth", "membrane = { thickness = \"1 mm\", wrinkles = true, bending = \"none\" }"),
];

const LAUNCH: &str = r#"
payload.cylinder = {}
web.space.side = "2.5 m"
rope = { diameter = "10 mm", density = 1850, elastic_modulus = "78 GPa", damping_time = "19 us" }
traction_rope = { length = "1 m", count = 2 }
tractor.particle.mass = "5 kg"
stow.bag = { radius = "0.24 m", depth = "0.38 m" }
launch = { axial_speed = "50 m/s", radial_speed = "50 m/s" }
solve = { duration = "25 ms", segment_length = "0.2 m" }
record.every = "1 ms"
"#;

/// The space web of the paper, with coarse segments, run until the tractors have jerked it.
fn launch(canopy: &str) -> Document {
    let source = Source { name: "net.toml".into(), text: format!("canopy.{canopy}{LAUNCH}") };
    Document::parse(source, "".as_ref(), &[]).unwrap_or_else(|errors| panic!("{errors}"))
}

#[test]
fn with_every_kind_of_canopy_the_energy_balance_closes_and_symmetry_is_kept() {
    // one thread each; the scope panics if any of them does
    std::thread::scope(|scope| {
        for (name, canopy) in KINDS {
            scope.spawn(move || assert_closes_and_stays_symmetric(name, canopy));
        }
    });
}

fn assert_closes_and_stays_symmetric(name: &str, canopy: &str) {
    let run = Run::of(&launch(canopy));
    let (closure, web) = (run.summary.energy.closure, run.summary.energy.closure_web.unwrap());
    let asymmetry = asymmetry(&run);
    println!("{name}: closure {closure:.1e}, of the web {web:.1e}; asymmetry {asymmetry:.1e} m");
    // the tractors have jerked the web
    assert!(run.summary.tension.max_n > 1e4, "{name}");
    assert!(closure < 3e-3 && web < 1e-2, "{name}: {closure} and {web}");
    assert!(asymmetry < 1e-7, "{name}: {asymmetry} m");
    assert_eq!(run.summary.canopies.is_some(), canopy.starts_with("membrane"), "{name}");
    if let Some(cloth) = &run.summary.canopies {
        assert!(cloth.max_principal_stress_pa > 1e7 && cloth.max_where.is_some(), "{name}: {cloth:?}");
    }
}

/// Record at which symmetry is judged. A jerked net multiplies a difference by ten every millisecond or two: rounding,
/// 1e-16 m, becomes a millimetre by 30 ms, whatever the kind of canopy.
const SYMMETRIC: usize = 10;

/// Largest distance of a node, turned by a sixth of a turn, from its image at the record [`SYMMETRIC`], m. Such a turn maps
/// the flat web onto itself.
fn asymmetry(run: &Run) -> f64 {
    let flat = &run.model.cut.nodes;
    let turn = DMat3::from_rotation_z(FRAC_PI_3);
    let then = run.fields.positions(SYMMETRIC);
    let off = |(node, &place): (usize, &DVec3)| {
        // nodes of parallel ropes share a place: one of them is the image
        let images = (0..flat.len()).filter(|&other| flat[other].distance(turn * place) < 1e-9);
        images.map(|image| then[image].distance(turn * then[node])).reduce(f64::min).expect("every node has an image")
    };
    flat.iter().enumerate().map(off).fold(0.0, f64::max)
}

#[test]
fn threads_change_no_bit_of_a_web_of_many_triangles() {
    let model = Model::new(&launch("membrane = { fineness = 4 }")).unwrap_or_else(|errors| panic!("{errors}"));
    assert!(model.system.membranes().len() > 2_000 && model.system.parts().hinges.len() > 2_000);
    let [one, other] = [1, 3].map(|threads| -> Vec<DVec3> {
        let mut net = Stepper::new(&model.system, &model.state, model.largest_dt(), threads);
        for _ in 0..300 {
            net.step();
        }
        (0..model.cut.nodes.len()).map(|node| net.position(node)).collect()
    });
    assert!(one == other);
}

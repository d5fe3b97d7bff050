//! What each stage costs: `cargo bench -p netcast`. How near the step comes to the machine's limit: `netcast bench`.

use std::path::Path;

use divan::Bencher;
use divan::counter::ItemsCount;
use netcast::bench::{MESHES, net, net_with};
use netcast::dynamics::time::step::Stepper;
use netcast::{Case, Document, Model};

fn main() {
    divan::main();
}

fn threads() -> Vec<usize> {
    let all = std::thread::available_parallelism().map_or(1, |n| n.get());
    if all > 1 { vec![1, all] } else { vec![1] }
}

/// Steps taken at a time: threads that have just worked together do so faster.
const STEPS: usize = 100;

/// A hundred steps of the contract's square net at four sizes.
#[divan::bench(consts = MESHES, args = threads())]
fn steps<const MESH: usize>(bencher: Bencher, threads: usize) {
    let case = net(MESH).unwrap();
    let net = case.model();
    let mut stepper = Stepper::new(&net.system, &net.state, net.largest_dt(), threads);
    let team = stepper.team();
    let bencher = bencher.counter(ItemsCount::new(STEPS * net.system.segments().len()));
    bencher.bench_local(|| {
        team.lead(|| {
            (0..STEPS).for_each(|_| {
                divan::black_box(stepper.step());
            })
        })
    });
}

/// What the law of the ropes costs: a hundred steps of the square net of 3968 segments, on one thread. `breaking`: by the
/// linear law, with a strength that is never reached.
#[divan::bench(args = ["linear", "breaking", "strut", "bilinear", "table", "hysteresis", "viscoelastic"])]
fn laws(bencher: Bencher, law: &str) {
    let folder = tempfile::tempdir().unwrap();
    let table = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        format!("rope.law.table.file={file:?}")
    };
    let chosen = match law {
        "linear" => "rope.law={linear={}}".to_owned(),
        "breaking" => "rope.breaking={load=1e9,strain=10}".to_owned(),
        "strut" => "rope.law={strut={}}".to_owned(),
        "bilinear" => "rope.law={bilinear={strain=0.001,second_modulus=50e9}}".to_owned(),
        "table" => table("table.csv", "strain,tension\n0,0\n0.001,200\n0.01,3000\n0.1,20000\n"),
        "hysteresis" => {
            table("loop.csv", "strain,tension,unloading\n0,0,0\n0.001,200,20\n0.01,3000,900\n0.1,2e4,2e4\n")
        }
        "viscoelastic" => "rope.law={viscoelastic={instantaneous_modulus=90e9,relaxation_time=0.01}}".to_owned(),
        other => panic!("{other}"),
    };
    // struts cannot be packed: their net is thrown as drawn
    let as_drawn = (law == "strut").then(|| "stow.scale.factor=1".to_owned());
    steps_with(bencher, 20_000, &[Some(chosen), as_drawn].into_iter().flatten().collect::<Vec<_>>());
}

/// What surrounds the same net, or is attached to it, and what that costs. `held`: while a cover holds the whole web.
#[divan::bench(args = [
    "nothing", "drag", "drag, coefficient given", "drag, wind by height", "added mass", "ground", "orbit", "bending",
    "rigid tractors", "held",
])]
fn effects(bencher: Bencher, effect: &str) {
    let overrides: &[&str] = match effect {
        "nothing" => &[],
        "drag" => &["environment.air={}"],
        "drag, coefficient given" => &["environment.air.normal_coefficient=1.1"],
        "drag, wind by height" => &[
            "environment.air={}",
            "environment.wind={speed=5,power={},muzzle_height=1,gust={speed=3,at=0,duration=9}}",
        ],
        "added mass" => &["environment.air={density=1000,viscosity=1e-3,added_mass=1,buoyancy=false}"],
        "ground" => &["environment.ground.height=-20"],
        "orbit" => &["environment={damping=0.1,orbit={altitude=600e3}}"],
        "bending" => &["rope.bending_stiffness=1e-3"],
        "rigid tractors" => &["tractor={cylinder={}}", "traction_rope={length=1,tied_at=\"rear\"}"],
        "held" => &["covers=[{opens=10}]"],
        other => panic!("{other}"),
    };
    let overrides: Vec<String> = overrides.iter().map(|one| one.to_string()).collect();
    steps_with(bencher, 5_000, &overrides);
}

/// A hundred steps of the square net of 3968 segments with overrides, on one thread, after so many that ropes are taut
/// here and slack there.
fn steps_with(bencher: Bencher, before: usize, overrides: &[String]) {
    let case = net_with(31, overrides).unwrap();
    let net = case.model();
    let mut stepper = Stepper::new(&net.system, &net.state, net.largest_dt(), 1);
    (0..before).for_each(|_| {
        stepper.step();
    });
    let bencher = bencher.counter(ItemsCount::new(STEPS * net.system.segments().len()));
    bencher.bench_local(|| {
        (0..STEPS).for_each(|_| {
            divan::black_box(stepper.step());
        })
    });
}

/// From the text of a scenario to what is simulated.
#[divan::bench(args = ["03_space_web/space_web.toml", "04_square_net/square_net.toml"])]
fn model(bencher: Bencher, scenario: &str) {
    let document = example(scenario, &[]);
    bencher.bench(|| Model::new(&document).unwrap());
}

/// A whole run of the square net with its report, 60 ms long; recorded at its end only, or so often.
#[divan::bench(args = ["60 ms", "1 ms", "0.1 ms"])]
fn run(bencher: Bencher, every: &str) {
    let overrides = ["solve.duration=60 ms".to_owned(), format!("record.every={every}")];
    let document = example("04_square_net/square_net.toml", &overrides);
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("run");
    bencher.bench_local(|| Case::of(document.clone()).unwrap().simulation().threads(1).run_to(&target).unwrap());
}

/// The report of a run of the space web, 40 ms long.
#[divan::bench]
fn report(bencher: Bencher) {
    let document = example("03_space_web/space_web.toml", &["solve.duration=40 ms".to_owned()]);
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("run");
    Case::of(document).unwrap().simulation().run_to(&target).unwrap();
    bencher.bench_local(|| netcast::report::write_report(&target).unwrap());
}

fn example(path: &str, overrides: &[String]) -> Document {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    Document::read(&examples.join(path), overrides).unwrap()
}

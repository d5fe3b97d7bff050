//! What each stage costs: `cargo bench -p netcast`. How near the step comes to the machine's limit: `netcast bench`.

use std::path::Path;

use divan::Bencher;
use divan::counter::ItemsCount;
use netcast::bench::{MESHES, net};
use netcast::dynamics::time::step::Stepper;
use netcast::{Document, Model, RunOptions};

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
    let net = net(MESH).unwrap();
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
    let (target, options) = (folder.path().join("run"), RunOptions { threads: 1, ..RunOptions::default() });
    bencher.bench_local(|| netcast::run(&document, &target, &options, &mut |_| {}, &|| false).unwrap());
}

/// The report of a run of the space web, 40 ms long.
#[divan::bench]
fn report(bencher: Bencher) {
    let document = example("03_space_web/space_web.toml", &["solve.duration=40 ms".to_owned()]);
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("run");
    netcast::run(&document, &target, &RunOptions::default(), &mut |_| {}, &|| false).unwrap();
    bencher.bench_local(|| netcast::report::write_report(&target).unwrap());
}

fn example(path: &str, overrides: &[String]) -> Document {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    Document::read(&examples.join(path), overrides).unwrap()
}

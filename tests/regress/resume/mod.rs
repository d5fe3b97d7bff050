//! An interrupted and resumed run gives the bytes of an uninterrupted one: for every key of a scenario, at any record, on any
//! number of threads.

mod scenarios;

use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use netcast::results::{CheckpointEvery, ResultError, folder};
use netcast::{Case, Document, Progress, Ran, RunError, RunOptions};
use tempfile::TempDir;

use scenarios::{missing, read, scenario, scenarios, write_files};

/// A folder with the files that scenarios name.
fn workbench() -> TempDir {
    let workbench = TempDir::new().unwrap();
    write_files(workbench.path());
    workbench
}

fn options(threads: usize, resume: bool) -> RunOptions {
    RunOptions { threads, resume, checkpoint_every: CheckpointEvery::Never }
}

/// Runs until `records` records are taken; returns the run and the number of records.
fn run_for(document: &Document, target: &Path, options: &RunOptions, records: usize) -> (Ran, usize) {
    let taken = AtomicUsize::new(0);
    let count = |progress| {
        if matches!(progress, Progress::Running { .. }) {
            taken.fetch_add(1, Ordering::Relaxed);
        }
    };
    let enough = || taken.load(Ordering::Relaxed) >= records;
    let case = Case::of(document.clone()).unwrap_or_else(|errors| panic!("{errors}"));
    let simulation = case.simulation().options(options.clone()).progress(count).interrupt_when(enough);
    let ran = simulation.run_to(target).unwrap_or_else(|error| panic!("{error}"));
    (ran, taken.into_inner())
}

/// Resumes an earlier run.
fn resumed(document: &Document, target: &Path) -> Result<Ran, RunError> {
    Case::of(document.clone())?.simulation().options(options(1, true)).run_to(target)
}

/// Runs or resumes to the end; returns the number of records.
fn run_to_end(document: &Document, target: &Path, options: &RunOptions) -> usize {
    let (ran, records) = run_for(document, target, options, usize::MAX);
    assert!(ran.summary.finished && !ran.can_resume, "{:?}", ran.failure);
    assert!(!target.join(folder::CHECKPOINT).exists());
    records
}

/// The files that must not differ; the summary without its wall time.
fn bytes(target: &Path) -> [(&'static str, Vec<u8>); 4] {
    let read = |name: &str| fs::read(target.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    let summary = String::from_utf8(read(folder::SUMMARY)).unwrap();
    let told: Vec<&str> = summary.lines().filter(|line| !line.contains("\"wall_time_s\"")).collect();
    [
        (folder::HISTORY, read(folder::HISTORY)),
        (folder::FIELDS, read(folder::FIELDS)),
        (folder::LANDMARKS, read(folder::LANDMARKS)),
        (folder::SUMMARY, told.join("\n").into_bytes()),
    ]
}

#[track_caller]
fn assert_same(whole: &Path, resumed: &Path, of: &str) {
    for ((name, one), (_, other)) in bytes(whole).into_iter().zip(bytes(resumed)) {
        assert!(one == other, "{of}: {name} is not that of the run that was not interrupted");
    }
}

/// Interrupts a run at record number `records` on the first number of threads, and resumes it on the second.
fn interrupt(document: &Document, target: &Path, records: usize, threads: [usize; 2]) {
    let (ran, taken) = run_for(document, target, &options(threads[0], false), records);
    // the last record of a first run that is done again is no place to stop at
    let is_there = (records..=records + 1).contains(&taken);
    assert!(!ran.summary.finished && ran.can_resume && is_there, "{taken} records of {records}");
    assert!(target.join(folder::CHECKPOINT).exists() && target.join(folder::FIELDS).exists());
    run_to_end(document, target, &options(threads[1], true));
}

#[test]
fn the_scenarios_have_every_key_of_the_schema() {
    assert_eq!(missing(), [""; 0], "give tests/resume/ a scenario with it");
}

/// The friction that this scenario is meant to test must occur within its few records.
#[test]
fn a_net_thrown_from_the_ground_slides_on_it() {
    let workbench = workbench();
    let document = read(&scenario("thrown_from_the_ground"), workbench.path());
    let (ran, _) = run_for(&document, &workbench.path().join("whole"), &options(1, false), usize::MAX);
    assert!(ran.summary.energy.channels["ground_friction"] > 0.0, "{:?}", ran.summary.energy.channels);
}

#[test]
fn every_scenario_resumes_to_the_same_bytes() {
    let workbench = workbench();
    let (whole, resumed) = (workbench.path().join("whole"), workbench.path().join("resumed"));
    for (name, text) in &scenarios() {
        let document = read(text, workbench.path());
        let records = run_to_end(&document, &whole, &options(1, false));
        if document.scenario.solve.run_time().is_none() {
            // an equilibrium has one record: there is nothing to resume
            run_to_end(&document, &resumed, &options(3, false));
            assert_same(&whole, &resumed, name);
            continue;
        }
        assert!((8..=30).contains(&records), "{name} has {records} records");
        for at in [1, 2, records / 2, records - 1] {
            interrupt(&document, &resumed, at, [2, 3]);
            assert_same(&whole, &resumed, &format!("{name}, interrupted at record {at} of {records}"));
        }
    }
}

/// Fine enough that threads share the work, and under pretension, so that every segment counts.
#[test]
fn a_large_net_resumes_to_the_same_bytes_on_any_number_of_threads() {
    const NET: &str = r#"
web.square = { side = "2 m", mesh = "0.02 m", segments_per_mesh = 1 }
rope = { diameter = "3 mm", density = 1140, elastic_modulus = "5 GPa", pretension = "5 N" }
tractor.particle.mass = "0.3 kg"
launch.radial_speed = "10 m/s"
solve.duration = "60 us"
record.every = "20 us"
"#;
    let workbench = workbench();
    let (whole, resumed) = (workbench.path().join("whole"), workbench.path().join("resumed"));
    let document = read(NET, workbench.path());
    run_to_end(&document, &whole, &options(1, false));
    for threads in [[1, 2], [2, 3], [3, 1]] {
        interrupt(&document, &resumed, 2, threads);
        assert_same(&whole, &resumed, &format!("{threads:?} threads"));
    }
}

#[test]
fn a_run_interrupted_at_every_record_gives_the_same_bytes() {
    let workbench = workbench();
    let (whole, resumed) = (workbench.path().join("whole"), workbench.path().join("resumed"));
    let document = read(&scenario("space_web_everything_on_board"), workbench.path());
    run_to_end(&document, &whole, &options(1, false));
    let (mut ran, _) = run_for(&document, &resumed, &options(1, false), 1);
    let mut times = 1;
    while ran.can_resume {
        (ran, _) = run_for(&document, &resumed, &options(1, true), 1);
        times += 1;
    }
    assert!(times > 15, "{times}");
    assert_same(&whole, &resumed, "interrupted at every record");
}

#[test]
fn checkpoints_during_a_run_change_no_bytes() {
    let workbench = workbench();
    let (whole, kept) = (workbench.path().join("whole"), workbench.path().join("kept"));
    let document = read(&scenario("traditional_web_no_two_tractors_alike"), workbench.path());
    run_to_end(&document, &whole, &options(1, false));
    for every in [CheckpointEvery::Simulated(1e-9), CheckpointEvery::Clock(Default::default())] {
        run_to_end(&document, &kept, &RunOptions { checkpoint_every: every, ..options(1, false) });
        assert_same(&whole, &kept, "checkpointed at every record");
    }
}

/// A run that cannot put its folder in its place stands where a kill, or a full disk, would leave it.
#[test]
fn a_run_killed_after_its_last_step_goes_on_with_its_summary() {
    let workbench = workbench();
    let (whole, target) = (workbench.path().join("whole"), workbench.path().join("net"));
    for (name, text) in &scenarios() {
        let document = read(text, workbench.path());
        if document.scenario.solve.run_time().is_none() {
            continue;
        }
        run_to_end(&document, &whole, &options(1, false));
        let case = Case::of(document.clone()).unwrap_or_else(|errors| panic!("{errors}"));
        let take_its_place = |_| {
            fs::create_dir_all(&target).unwrap();
            fs::write(target.join("thesis.tex"), "years of work").unwrap();
        };
        let options = RunOptions { checkpoint_every: CheckpointEvery::Simulated(1e9), ..options(1, false) };
        let ended = case.simulation().options(options).progress(take_its_place).run_to(&target);
        assert!(matches!(ended, Err(RunError::CutOff { .. })), "{name}");
        fs::remove_dir_all(&target).unwrap();

        let records = run_to_end(&document, &target, &self::options(1, true));
        assert_eq!(records, 0, "{name}");
        assert_same(&whole, &target, name);
        assert!(!target.join(folder::FIELDS_PART).exists() && !target.join(folder::CHECKPOINT).exists());
        fs::remove_dir_all(&target).unwrap();
    }
}

#[test]
fn a_run_with_other_inputs_is_not_resumed_and_the_difference_is_reported() {
    let workbench = workbench();
    let target = workbench.path().join("net");
    let text = scenario("graph_stowed_from_a_file_one_knot_held");
    run_for(&read(&text, workbench.path()), &target, &options(1, false), 3);
    let before = bytes(&target);

    let faster = text.replace("20 m/s", "30 m/s");
    let refused = resumed(&read(&faster, workbench.path()), &target);
    let told = refused.unwrap_err().to_string();
    assert!(told.contains("launch.axial_speed was \"20 m/s\" and is \"30 m/s\""), "{told}");

    let nodes = fs::read_to_string(workbench.path().join("nodes.csv")).unwrap();
    fs::write(workbench.path().join("nodes.csv"), nodes.replace("0.1", "0.2")).unwrap();
    let refused = resumed(&read(&text, workbench.path()), &target);
    let told = refused.unwrap_err().to_string();
    assert!(told.contains("nodes.csv has changed"), "{told}");

    // the refusals changed nothing
    assert!(bytes(&target) == before);
    assert!(!workbench.path().join("net.running").exists());
    fs::write(workbench.path().join("nodes.csv"), nodes).unwrap();
    run_to_end(&read(&text, workbench.path()), &target, &options(1, true));
}

#[test]
fn a_finished_run_is_not_resumed() {
    let workbench = workbench();
    let target = workbench.path().join("net");
    let document = read(&scenario("square_net_with_a_drawstring"), workbench.path());
    let resumed = || resumed(&document, &target);
    let nothing = |error: RunError| matches!(error, RunError::Result(ResultError::NothingToResume { .. }));
    assert!(nothing(resumed().unwrap_err()));
    run_to_end(&document, &target, &options(1, false));
    assert!(nothing(resumed().unwrap_err()));
}

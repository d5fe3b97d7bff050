//! The golden record holds the bytes of all results of the examples, of tests/resume/ and of tests/golden/. For each of these
//! scenarios tests/golden/record.txt has the SHA-256 of history.csv, fields.vtkhdf and summary.json (without its line
//! `wall_time_s`), in the format of `sha256sum`. A change that should not change results changes no line of it.
//!
//! `cargo test` checks the quick scenarios. The long examples take minutes:
//!
//!     cargo test --test examples golden -- --include-ignored
//!
//! If results change on purpose, write the record again, and say in the commit why they change:
//!
//!     NETCAST_GOLDEN=write cargo test --test examples golden -- --include-ignored

use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use crate::runs::{self, FILES};
use crate::support::{examples, files_of_kind, resume};

/// The examples that take minutes, the longest first.
const LONG: [&str; 3] = [
    "examples/03_space_web/canopies/plate",
    "examples/03_space_web/canopies/cloth",
    "examples/03_space_web/canopies/rigid",
];

/// The command that writes the record again.
const ANEW: &str =
    "if results change on purpose: NETCAST_GOLDEN=write cargo test --test examples golden -- --include-ignored";

/// Held by the test that writes the record.
static WRITING: Mutex<()> = Mutex::new(());

/// The lines of the record: the hash of each file, by `scenario/file`.
type Record = BTreeMap<String, String>;

/// A scenario of the record.
#[derive(Clone)]
struct Golden {
    /// Its path in the repository, without `.toml`.
    name: String,
    path: PathBuf,
}

fn folder_of_golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

fn record_file() -> PathBuf {
    folder_of_golden().join("record.txt")
}

/// The scenarios in `folder` and its subfolders; `name` is the path of the folder in the repository.
fn goldens(folder: &Path, name: &str) -> Vec<Golden> {
    // a folder with reported.toml compares other examples and has no scenario of its own
    if folder.join("reported.toml").exists() {
        return Vec::new();
    }
    let last = |path: &Path| format!("{name}/{}", path.file_stem().unwrap().to_string_lossy());
    let files = files_of_kind(folder, "toml");
    let mut all: Vec<Golden> = files.into_iter().map(|path| Golden { name: last(&path), path }).collect();
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    all.extend(entries.filter(|path| path.is_dir()).flat_map(|path| goldens(&path, &last(&path))));
    all.sort_by(|a, b| a.name.cmp(&b.name));
    all
}

fn example_goldens() -> Vec<Golden> {
    goldens(&examples(), "examples")
}

fn restart_goldens() -> Vec<Golden> {
    goldens(&resume(), "tests/resume")
}

/// The nets on which threads share the work.
fn shared_goldens() -> Vec<Golden> {
    goldens(&folder_of_golden(), "tests/golden")
}

fn all_goldens() -> Vec<Golden> {
    [example_goldens(), restart_goldens(), shared_goldens()].concat()
}

fn long_goldens() -> Vec<Golden> {
    let all = example_goldens();
    let find = |name: &&str| all.iter().find(|golden| golden.name == *name).cloned();
    LONG.iter().map(|name| find(name).unwrap_or_else(|| panic!("{name} is no example"))).collect()
}

/// The record in tests/golden/.
fn kept() -> Record {
    let text = fs::read_to_string(record_file()).unwrap_or_default();
    let line = |line: &str| line.split_once("  ").map(|(hash, file)| (file.to_owned(), hash.to_owned()));
    text.lines().map(|told| line(told).unwrap_or_else(|| panic!("no line of a record: {told}"))).collect()
}

/// The name of the scenario of a file in the record.
fn scenario_of(file: &str) -> &str {
    file.rsplit_once('/').map_or("", |(scenario, _)| scenario)
}

/// Whether to write the record instead of checking it.
fn writes() -> bool {
    match env::var("NETCAST_GOLDEN").as_deref() {
        Err(_) => false,
        Ok("write") => {
            assert!(env::var("CI").as_deref() != Ok("true"), "a record that CI writes would check nothing");
            true
        }
        Ok(other) => panic!("NETCAST_GOLDEN is {other:?}; it is \"write\" or unset"),
    }
}

/// Runs a scenario and returns its lines of the record. An example runs once for all tests, on one thread.
fn found(golden: &Golden, threads: usize) -> Record {
    let name = &golden.name;
    let hashes = if name.starts_with("examples/") {
        runs::example(&golden.path).hashes.clone()
    } else {
        runs::run(&golden.path, threads).hashes
    };
    FILES.iter().zip(hashes).map(|(file, hash)| (format!("{name}/{file}"), hash)).collect()
}

/// Runs scenarios side by side, each on `threads` threads, and returns their lines of the record.
fn found_of_all(goldens: &[Golden], threads: usize) -> Record {
    let (next, record) = (AtomicUsize::new(0), Mutex::new(Record::new()));
    let work = || {
        while let Some(golden) = goldens.get(next.fetch_add(1, Ordering::Relaxed)) {
            let found = found(golden, threads);
            record.lock().unwrap().extend(found);
        }
    };
    let workers = thread::available_parallelism().map_or(1, |n| n.get());
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(work);
        }
    });
    record.into_inner().unwrap()
}

/// Replaces the lines of these scenarios in the record, and removes lines of scenarios that no longer exist.
fn write(found: Record) {
    let _alone = WRITING.lock().unwrap();
    let all: BTreeSet<String> = all_goldens().into_iter().map(|one| one.name).collect();
    let mut record = kept();
    record.retain(|file, _| all.contains(scenario_of(file)));
    record.extend(found);
    let lines: String = record.iter().map(|(file, hash)| format!("{hash}  {file}\n")).collect();
    fs::create_dir_all(folder_of_golden()).unwrap();
    fs::write(record_file(), lines).unwrap();
}

/// Runs these scenarios on `threads` threads each, and compares them with the record or writes it.
#[track_caller]
fn check(goldens: &[Golden], threads: usize) {
    let writes = writes();
    let found = found_of_all(goldens, threads);
    if writes {
        return write(found);
    }
    let kept = kept();
    let differ: Vec<&str> =
        found.iter().filter(|(file, hash)| kept.get(*file) != Some(hash)).map(|(file, _)| &file[..]).collect();
    assert!(differ.is_empty(), "not what the record has: {}\n{ANEW}", differ.join(", "));
}

#[test]
fn the_record_lists_every_scenario_and_no_other() {
    if writes() {
        return;
    }
    let all = all_goldens().into_iter();
    let asked: BTreeSet<String> = all.flat_map(|one| FILES.map(|file| format!("{}/{file}", one.name))).collect();
    let kept: BTreeSet<String> = kept().into_keys().collect();
    let (missing, beyond): (Vec<_>, Vec<_>) = (asked.difference(&kept).collect(), kept.difference(&asked).collect());
    assert!(missing.is_empty() && beyond.is_empty(), "the record lacks {missing:?}, and has {beyond:?}\n{ANEW}");
}

#[test]
fn restarted_scenarios_give_the_bytes_of_the_record() {
    check(&restart_goldens(), 1);
}

#[test]
fn quick_examples_give_the_bytes_of_the_record() {
    let quick: Vec<Golden> = example_goldens().into_iter().filter(|one| !LONG.contains(&&one.name[..])).collect();
    check(&quick, 1);
}

#[test]
fn any_number_of_threads_gives_the_bytes_of_the_record() {
    for threads in [1, 2, 3] {
        check(&shared_goldens(), threads);
    }
    check(&restart_goldens()[..3], 3);
}

#[test]
#[ignore = "takes minutes: cargo test --test examples golden -- --include-ignored"]
fn long_examples_give_the_bytes_of_the_record() {
    check(&long_goldens(), 1);
}

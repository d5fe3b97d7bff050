//! Runs of whole scenarios for the other tests. An example is run once, however many tests need it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};

use netcast::results::{History, folder};
use netcast::{Case, Model, Ran};
use sha2::{Digest, Sha256};
use tempfile::TempDir;

/// The files in the golden record.
pub const FILES: [&str; 3] = [folder::HISTORY, folder::FIELDS, folder::SUMMARY];

/// A finished run.
pub struct Finished {
    pub model: Model,
    /// The result; its folder no longer exists.
    pub ran: Ran,
    pub history: History,
    /// SHA-256 of each of [`FILES`]; that of the summary leaves out its line `wall_time_s`.
    pub hashes: [String; 3],
}

/// Runs a scenario on `threads` threads.
///
/// # Panics
/// If it is wrong or does not run to its end.
pub fn run(scenario: &Path, threads: usize) -> Finished {
    let name = scenario.display();
    let case = Case::read(scenario, &[]).unwrap_or_else(|errors| panic!("{name}: {errors}"));
    let results = TempDir::new().unwrap();
    let target = results.path().join("run");
    let ran = case.simulation().threads(threads).run_to(&target).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert!(ran.summary.finished, "{name}: {:?}", ran.failure);
    println!("{name}: {:.1} s", ran.summary.wall_time_s);
    let hashes = FILES.map(|file| hash(&target, file));
    let history = History::read(&target.join(folder::HISTORY)).unwrap();
    Finished { model: case.model().clone(), ran, history, hashes }
}

fn hash(target: &Path, file: &str) -> String {
    let mut bytes = fs::read(target.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
    if file == folder::SUMMARY {
        let text = String::from_utf8(bytes).unwrap();
        bytes = text.split_inclusive('\n').filter(|line| !line.contains("\"wall_time_s\"")).collect::<String>().into();
    }
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

type Once = Arc<OnceLock<Arc<Finished>>>;

/// The run of an example. The first test to ask runs it, the others wait.
///
/// # Panics
/// As [`run`].
pub fn example(scenario: &Path) -> Arc<Finished> {
    static RUNS: Mutex<BTreeMap<PathBuf, Once>> = Mutex::new(BTreeMap::new());
    let path = scenario.canonicalize().unwrap_or_else(|error| panic!("{}: {error}", scenario.display()));
    let once = RUNS.lock().unwrap().entry(path).or_default().clone();
    once.get_or_init(|| Arc::new(run(scenario, 1))).clone()
}

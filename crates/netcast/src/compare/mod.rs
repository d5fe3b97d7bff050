//! Designs side by side: run at the same time, and put into one folder with one table and one page.

mod lineup;
mod reported;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Instant;

use netcast_report::write_comparison;
use netcast_results::comparison::{Comparison, Entrant};
use netcast_results::{CheckpointEvery, Machine, Manifest, ResultError, ResultFolder, SummaryFile, folder, hash};
use netcast_scenario::tree::Tree;
use serde_json::Value as Json;

use crate::inputs::SCENARIO;
use crate::values::flatten;
use crate::{Failure, Progress, RunError, RunOptions, run, schedule};

pub use lineup::{FEWEST, Lineup, MOST};

use lineup::{Design, Origin};

/// Designs that were compared.
#[derive(Debug)]
pub struct Compared {
    /// What is in the comparison's summary.json.
    pub comparison: Comparison,
    /// The folder of the comparison.
    pub folder: PathBuf,
    /// The designs that failed on the way, with why, in the order of the comparison.
    pub failures: Vec<(String, Failure)>,
}

/// Runs the designs of a line-up and writes their results and the comparison to `target`: several at a time, on so many
/// threads in all, which the results do not depend on. `progress` hears of all runs as if they were one after another;
/// once `interrupted` says so, every run stops at its next record.
///
/// # Errors
/// [`RunError`], with nothing written, where `target` or a result cannot be written. A design that fails on the way is
/// no error: it is compared as far as it came, and told of in [`Compared::failures`].
pub fn compare(
    lineup: &Lineup,
    target: &Path,
    options: &RunOptions,
    progress: &(dyn Fn(Progress) + Sync),
    interrupted: &(dyn Fn() -> bool + Sync),
) -> Result<Compared, RunError> {
    let clock = Instant::now();
    let outer = ResultFolder::create(target)?;
    let ended = run_all(&lineup.designs, outer.path(), options.threads, progress, interrupted)?;

    let read = |(design, failure): (&Design, &Option<Failure>)| {
        let failure = failure.as_ref().map(Failure::to_string);
        entrant(&design.name, &outer.path().join(&design.name), failure)
    };
    let entrants = lineup.designs.iter().zip(&ended).map(read).collect::<Result<Vec<_>, _>>()?;
    let reported = lineup.reported.as_ref().map(|file| &file.reported);
    let comparison = Comparison::of(&entrants, reported);
    comparison.write(&outer.path().join(folder::SUMMARY))?;
    comparison.write_csv(&outer.path().join(folder::SUMMARY_CSV))?;
    if let Some(file) = &lineup.reported {
        let inputs = outer.path().join(folder::INPUTS);
        let path = inputs.join("reported.toml");
        let written = fs::create_dir(&inputs).and_then(|()| fs::write(&path, &file.text));
        written.map_err(ResultError::write(&path))?;
    }
    manifest(&lineup.designs, outer.path(), options.threads, clock)?;
    write_comparison(outer.path())?;

    let names = lineup.designs.iter().map(|design| design.name.clone());
    let failures = names.zip(ended).filter_map(|(name, failure)| Some((name, failure?))).collect();
    Ok(Compared { comparison, folder: outer.publish()?, failures })
}

/// Runs every scenario and copies every result, each into its own folder within `to`; says how each ended.
fn run_all(
    designs: &[Design],
    to: &Path,
    threads: usize,
    progress: &(dyn Fn(Progress) + Sync),
    interrupted: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<Option<Failure>>, RunError> {
    let reached = Reached::new(designs);
    let (next, abandoned) = (AtomicUsize::new(0), AtomicBool::new(false));
    let ended: Vec<Mutex<Result<Option<Failure>, RunError>>> = designs.iter().map(|_| Mutex::new(Ok(None))).collect();
    let work = |threads: usize| {
        // the next design that nobody has taken; after an error the others need not go on
        while let Some(index) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|index| *index < designs.len()) {
            let stop = || interrupted() || abandoned.load(Ordering::Relaxed);
            let mut tell = |own: Progress| {
                if let Progress::Running { time_s, end_s: _ } = own {
                    progress(reached.with(index, time_s));
                }
            };
            let design = &designs[index];
            let result = match &design.origin {
                Origin::Folder(from) => copy_result(from, &to.join(&design.name)).map(|()| None),
                Origin::Scenario { document, .. } => {
                    let ran = run(document, &to.join(&design.name), &options(threads), &mut tell, &stop);
                    ran.map(|ran| ran.failure)
                }
            };
            abandoned.fetch_or(result.is_err(), Ordering::Relaxed);
            *ended[index].lock().expect("no run panics while it tells its end") = result;
        }
    };
    let workers = threads.clamp(1, designs.len());
    let (each, over) = (threads.max(1) / workers, threads.max(1) % workers);
    std::thread::scope(|scope| {
        for worker in 0..workers {
            let work = &work;
            scope.spawn(move || work(each + usize::from(worker < over)));
        }
    });
    ended.into_iter().map(|end| end.into_inner().expect("no run panics while it tells its end")).collect()
}

/// A comparison that is cut off starts anew: its runs need no checkpoints.
fn options(threads: usize) -> RunOptions {
    RunOptions { threads, checkpoint_every: CheckpointEvery::Never, ..RunOptions::default() }
}

/// How far each run is.
struct Reached {
    times: Mutex<Vec<f64>>,
    end_s: f64,
}

impl Reached {
    fn new(designs: &[Design]) -> Self {
        let end = |design: &Design| match &design.origin {
            Origin::Folder(_) => 0.0,
            Origin::Scenario { model, .. } => schedule(model).end,
        };
        Self { times: Mutex::new(vec![0.0; designs.len()]), end_s: designs.iter().map(end).sum() }
    }

    /// All runs together, now that the one at `index` is at `time`.
    fn with(&self, index: usize, time: f64) -> Progress {
        let mut times = self.times.lock().expect("sums do not panic");
        times[index] = time;
        Progress::Running { time_s: times.iter().sum(), end_s: self.end_s }
    }
}

/// Copies all of ours in a result folder.
fn copy_result(from: &Path, to: &Path) -> Result<(), RunError> {
    fs::create_dir(to).map_err(ResultError::write(to))?;
    for name in folder::OURS {
        let source = from.join(name);
        if source.exists() {
            copy(&source, &to.join(name))?;
        }
    }
    Ok(())
}

fn copy(from: &Path, to: &Path) -> Result<(), ResultError> {
    if !from.is_dir() {
        return fs::copy(from, to).map(|_| ()).map_err(ResultError::read(from));
    }
    fs::create_dir(to).map_err(ResultError::write(to))?;
    for entry in fs::read_dir(from).map_err(ResultError::read(from))? {
        let entry = entry.map_err(ResultError::read(from))?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

/// A design as its result folder has it.
fn entrant(name: &str, results: &Path, failure: Option<String>) -> Result<Entrant, ResultError> {
    let summary = SummaryFile::read(results)?;
    let inputs = results.join(folder::INPUTS);
    let path = inputs.join(SCENARIO);
    let text = fs::read_to_string(&path).map_err(ResultError::read(&path))?;
    let mut values = Vec::new();
    // what netcast wrote is TOML; of an input that somebody broke since, nothing is told
    if let Ok(tree) = Tree::parse(&text) {
        flatten(&Default::default(), &tree.root.value, &mut values);
    }
    values.extend(files(&inputs)?);
    Ok(Entrant { name: name.to_owned(), summary, inputs: values, failure })
}

/// The files that a scenario names, each by a hash of what is in it: two webs may be drawn in files of one name.
fn files(inputs: &Path) -> Result<Vec<(String, Json)>, ResultError> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(inputs).map_err(ResultError::read(inputs))? {
        let path = entry.map_err(ResultError::read(inputs))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_file() && name != SCENARIO {
            let bytes = fs::read(&path).map_err(ResultError::read(&path))?;
            let told = format!("{} bytes, SHA-256 {}", bytes.len(), &hash([&bytes])[..12]);
            files.insert(format!("{}/{name}", folder::INPUTS), Json::from(told));
        }
    }
    Ok(files.into_iter().collect())
}

/// Marks the comparison's folder as ours, and says where it comes from.
fn manifest(designs: &[Design], to: &Path, threads: usize, clock: Instant) -> Result<(), ResultError> {
    let mut parts = Vec::new();
    for design in designs {
        let own = Manifest::read(&to.join(&design.name).join(folder::MANIFEST))?;
        parts.extend([design.name.clone(), own.input_hash]);
    }
    let mut manifest = Manifest::new(hash(parts), Machine::this(), threads);
    manifest.wall_time_s = clock.elapsed().as_secs_f64();
    manifest.write(&to.join(folder::MANIFEST))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_one_name_with_other_content_differ() {
        let folder = tempfile::tempdir().unwrap();
        let told = |text: &str| {
            fs::write(folder.path().join("nodes.csv"), text).unwrap();
            fs::write(folder.path().join(SCENARIO), "").unwrap();
            files(folder.path()).unwrap()
        };
        let (one, other) = (told("id,x\n1,0\n"), told("id,x\n1,1\n"));
        assert_eq!((one.len(), &one[0].0), (1, &other[0].0));
        assert_ne!(one, other);
    }
}

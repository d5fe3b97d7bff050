//! Designs side by side: run at the same time, and put into one folder with one table and one page.

mod lineup;
mod reported;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Instant;

use netcast_report::write_comparison;
use netcast_results::comparison::{Comparison, Entrant};
use netcast_results::{CheckpointEvery, Machine, Manifest, ResultError, ResultFolder, SummaryFile, folder, hash};

use crate::case::Case;
use crate::error::RunError;
use crate::inputs::Inputs;
use crate::progress::{Interrupted, Progress};
use crate::simulate::RunOptions;
use crate::verdict::Failure;

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

/// Runs the designs of a line-up and writes their results and the comparison to `target`. Several run at a time, on as
/// many threads in all as `options` allows; the results do not depend on that number. `progress` hears of all runs as if
/// they were one after another. Once `interrupted` says so, every run stops at its next record.
///
/// # Errors
/// [`RunError`], with nothing written, where `target` or a result cannot be written. A design that fails on the way is
/// no error: it is compared as far as it came, and [`Compared::failures`] names it.
pub fn compare(
    lineup: &Lineup,
    target: &Path,
    options: &RunOptions,
    progress: &(dyn Fn(Progress) + Sync),
    interrupted: &Interrupted,
) -> Result<Compared, RunError> {
    let clock = Instant::now();
    let outer = ResultFolder::create(target)?;
    let ended = run_all(&lineup.designs, outer.path(), options.threads, progress, interrupted)?;

    let designs = lineup.designs.iter().zip(&ended);
    let entrants: Vec<Entrant> = designs.map(|(design, result)| result.entrant(&design.name)).collect();
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
    let mut manifest = Manifest::new(input_hash(&lineup.designs, &ended), Machine::this(), options.threads);
    manifest.wall_time_s = clock.elapsed().as_secs_f64();
    manifest.write(&outer.path().join(folder::MANIFEST))?;
    write_comparison(outer.path())?;

    let names = lineup.designs.iter().map(|design| design.name.clone());
    let failures = names.zip(ended).filter_map(|(name, result)| Some((name, result.failure?))).collect();
    Ok(Compared { comparison, folder: outer.publish()?, failures })
}

/// What came of a design: its run, or the results that were there already.
struct DesignResult {
    summary: SummaryFile,
    inputs: Inputs,
    input_hash: String,
    failure: Option<Failure>,
}

impl DesignResult {
    /// Runs a case into the folder `to`.
    fn run(
        case: &Case,
        to: &Path,
        threads: usize,
        progress: impl FnMut(Progress) + Send,
        interrupted: impl Fn() -> bool + Sync,
    ) -> Result<Self, RunError> {
        let simulation = case.simulation().options(options(threads));
        let ran = simulation.progress(progress).interrupt_when(interrupted).run_to(to)?;
        let values = serde_json::to_value(&ran.summary).expect("string keys and plain data");
        let summary = SummaryFile { summary: ran.summary, values };
        let inputs = case.inputs().clone();
        Ok(Self { summary, input_hash: inputs.hash(), inputs, failure: ran.failure })
    }

    /// Copies the results in the folder `from` to the folder `to`.
    fn copy(from: &Path, to: &Path) -> Result<Self, RunError> {
        copy_result(from, to)?;
        let input_hash = Manifest::read(&to.join(folder::MANIFEST))?.input_hash;
        Ok(Self { summary: SummaryFile::read(to)?, inputs: Inputs::read(to)?, input_hash, failure: None })
    }

    fn entrant(&self, name: &str) -> Entrant {
        Entrant {
            name: name.to_owned(),
            summary: self.summary.clone(),
            inputs: self.inputs.values(),
            failure: self.failure.as_ref().map(Failure::to_string),
        }
    }
}

/// What the inputs of all designs are known by.
fn input_hash(designs: &[Design], results: &[DesignResult]) -> String {
    hash(designs.iter().zip(results).flat_map(|(design, result)| [&design.name, &result.input_hash]))
}

/// Runs every scenario and copies every result, each into its own folder within `to`.
fn run_all(
    designs: &[Design],
    to: &Path,
    threads: usize,
    progress: &(dyn Fn(Progress) + Sync),
    interrupted: &Interrupted,
) -> Result<Vec<DesignResult>, RunError> {
    let reached = Reached::new(designs);
    let (next, abandoned) = (AtomicUsize::new(0), AtomicBool::new(false));
    let results: Vec<Mutex<Option<Result<DesignResult, RunError>>>> =
        designs.iter().map(|_| Mutex::default()).collect();
    let work = |threads: usize| {
        // the next design that nobody has taken; after an error the others need not go on
        while let Some(index) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|index| *index < designs.len()) {
            let stop = || interrupted() || abandoned.load(Ordering::Relaxed);
            let tell = |own: Progress| {
                if let Progress::Running { time_s, end_s: _ } = own {
                    progress(reached.with(index, time_s));
                }
            };
            let design = &designs[index];
            let folder = to.join(&design.name);
            let result = match &design.origin {
                Origin::Folder(from) => DesignResult::copy(from, &folder),
                Origin::Scenario(case) => DesignResult::run(case, &folder, threads, tell, stop),
            };
            abandoned.fetch_or(result.is_err(), Ordering::Relaxed);
            *results[index].lock().expect("no run panics while it tells its end") = Some(result);
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
    let ended = results.into_iter().map(|result| result.into_inner().expect("no run panics while it tells its end"));
    ended.map(|result| result.expect("every design was taken")).collect()
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
            Origin::Scenario(case) => case.schedule().end,
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

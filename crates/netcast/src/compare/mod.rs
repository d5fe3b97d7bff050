//! Compares designs: runs them in parallel and writes one folder with their results, one table and one page.

mod lineup;
mod reported;
mod vary;

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

/// A finished comparison.
#[derive(Debug)]
pub struct Compared {
    /// The content of the comparison's summary.json.
    pub comparison: Comparison,
    /// The folder of the comparison.
    pub folder: PathBuf,
    /// The designs whose runs failed, each with the cause, in the order of the comparison.
    pub failures: Vec<(String, Failure)>,
}

/// Runs the designs of a line-up and writes their results and the comparison to `target`. Several run in parallel, with
/// at most the threads of `options` in all; the results do not depend on that number. `progress` gets the sum of the
/// simulated times and of the durations of all runs. Once `interrupted` returns true, each run stops at its next
/// record.
///
/// # Errors
/// [`RunError`] where `target` or a result cannot be written; then nothing is written. A run that fails is no error:
/// the comparison holds it up to its failure, and [`Compared::failures`] names it.
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

/// The result of a design, from a run or from an existing folder.
struct DesignResult {
    summary: SummaryFile,
    inputs: Inputs,
    input_hash: String,
    failure: Option<Failure>,
}

impl DesignResult {
    /// Runs a case and writes its results to the folder `to`.
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

    /// The design as the table of the comparison takes it.
    fn entrant(&self, name: &str) -> Entrant {
        Entrant {
            name: name.to_owned(),
            summary: self.summary.clone(),
            inputs: self.inputs.values(),
            failure: self.failure.as_ref().map(Failure::to_string),
        }
    }
}

/// The hash of the names and inputs of all designs.
fn input_hash(designs: &[Design], results: &[DesignResult]) -> String {
    hash(designs.iter().zip(results).flat_map(|(design, result)| [&design.name, &result.input_hash]))
}

/// Runs every scenario and copies every result folder, each into its own folder within `to`.
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
        // take the next free design; after an error the other runs stop
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
            *results[index].lock().expect("no run panics while it stores its result") = Some(result);
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
    let ended =
        results.into_iter().map(|result| result.into_inner().expect("no run panics while it stores its result"));
    ended.map(|result| result.expect("every design was taken")).collect()
}

/// The options of a run. It writes no checkpoints, because an interrupted comparison cannot be resumed.
fn options(threads: usize) -> RunOptions {
    RunOptions { threads, checkpoint_every: CheckpointEvery::Never, ..RunOptions::default() }
}

/// The progress of all runs together.
struct Reached {
    /// Simulated time of each run, s.
    times: Mutex<Vec<f64>>,
    /// Sum of the durations of all runs, s.
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

    /// The progress of all runs once the run at `index` has reached `time`, s.
    fn with(&self, index: usize, time: f64) -> Progress {
        let mut times = self.times.lock().expect("sums do not panic");
        times[index] = time;
        Progress::Running { time_s: times.iter().sum(), end_s: self.end_s }
    }
}

/// Copies the files of a result folder that netcast wrote.
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

/// Copies a file, or a folder with its contents.
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

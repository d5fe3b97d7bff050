//! The run: from a scenario to a result folder.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use netcast_dynamics::simulate::{Place, Schedule, StepError, simulate};
use netcast_report::ReportError;
use netcast_results::summary::{self, Summary};
use netcast_results::{Machine, Manifest, Recorder, ResultError, ResultFolder, folder, manifest};
use netcast_scenario::lower::Model;
use netcast_scenario::solve::OnEnergyError;
use netcast_scenario::{Diagnostics, Document, resolved_toml};

use crate::landmarks::landmarks;

/// How a run is carried out; nothing here changes its results.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOptions {
    /// Threads that it may use.
    pub threads: usize,
}

impl Default for RunOptions {
    fn default() -> Self {
        RunOptions { threads: std::thread::available_parallelism().map_or(1, |n| n.get()) }
    }
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Time simulated so far, s.
    pub time_s: f64,
    /// Time at which the run ends, s.
    pub end_s: f64,
}

/// A run that was carried out, to its end or not.
#[derive(Debug)]
pub struct Ran {
    /// Its summary, as in summary.json.
    pub summary: Summary,
    /// The result folder.
    pub folder: PathBuf,
    /// Why it failed; what was computed is in the folder all the same.
    pub failure: Option<Failure>,
}

/// Why a run failed although its input was right.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Failure {
    /// It stopped before its end.
    #[error("{0}")]
    Stopped(String),
    /// It ran to its end, but its energy balance misses the tolerance.
    #[error(
        "the energy balance misses its tolerance: {what} is {found:.3} %, at most {asked:.3} % is allowed; \
         a smaller step mends it, try --set solve.step_fraction={smaller}"
    )]
    Unbalanced {
        /// Which measure.
        what: &'static str,
        /// Its value, percent.
        found: f64,
        /// What the scenario asks for, percent.
        asked: f64,
        /// A step fraction that should do.
        smaller: f64,
    },
}

/// Why there is no result.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The input is wrong.
    #[error(transparent)]
    Input(#[from] Diagnostics),
    /// The results cannot be written.
    #[error(transparent)]
    Result(#[from] ResultError),
    /// The report cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// When a model's steps and records happen.
pub fn schedule(model: &Model) -> Schedule {
    let every = model.scenario.record.every.si();
    Schedule::new(model.scenario.solve.duration.si(), every, model.largest_dt())
}

/// Runs a scenario and writes its results to `target`. `progress` hears of every record; once `interrupted` says so,
/// the run stops at the next one.
///
/// # Errors
/// [`RunError`], with nothing written, where the input is wrong or `target` cannot be written. A run that goes
/// wrong on the way is no error: it is a [`Ran`] with a [`Failure`].
pub fn run(
    document: &Document,
    target: &Path,
    options: &RunOptions,
    progress: &mut dyn FnMut(Progress),
    interrupted: &dyn Fn() -> bool,
) -> Result<Ran, RunError> {
    let clock = Instant::now();
    let model = Model::new(document)?;
    let folder = ResultFolder::create(target)?;
    write_inputs(document, &model, folder.path())?;

    let schedule = schedule(&model);
    let record = &model.scenario.record;
    let fields_every = record.fields_every.map_or(1.0, |t| (t.si() / record.every.si()).round().max(1.0)) as u64;
    let end_s = schedule.time(schedule.count);
    let mut tell = |time_s: f64| progress(Progress { time_s, end_s });
    let (system, state) = (&model.system, &model.state);
    let landmarks = landmarks(&model);
    landmarks.write(&folder.path().join(folder::LANDMARKS))?;
    let mut recorder = Recorder::new(system, state, landmarks, fields_every, &mut tell, interrupted)?;
    let outcome = simulate(system, state, &schedule, options.threads, &mut recorder);
    let solve = &model.scenario.solve;
    let recording = recorder.finish(&outcome, (solve.energy_tolerance.si(), solve.web_energy_tolerance.si()))?;

    let stopped = outcome.stopped.as_ref().map(|error| Failure::Stopped(in_words(&model, error)));
    // a run that came apart says so, and what mends it
    let came_apart = matches!(outcome.stopped, Some(StepError::Diverged { .. } | StepError::NotFinite { .. }));
    let unbalanced = match came_apart {
        true => None,
        false => unbalanced(&recording.energy, solve.step_fraction.map_or(1.0, |f| f.si())),
    };
    let mut warnings = model.notes.clone();
    warnings.extend(stopped.iter().chain(&unbalanced).map(Failure::to_string));
    let failure = stopped.or(unbalanced.filter(|_| solve.on_energy_error == OnEnergyError::Stop));

    let limiting = model.limit.segment.map(|segment| model.segment_label(segment));
    let bill = &model.bill;
    let summary = Summary {
        title: model.scenario.title.clone(),
        netcast: env!("CARGO_PKG_VERSION").to_owned(),
        wall_time_s: clock.elapsed().as_secs_f64(),
        finished: outcome.stopped.is_none(),
        model: summary::Model {
            nodes: system.mass().len(),
            segments: system.segments().len(),
            rope_length_m: bill.length_by_class.values().sum(),
            web_mass_kg: system.mass().iter().sum::<f64>() - bill.tractor_mass,
            tractor_mass_kg: (bill.tractors > 0).then_some(bill.tractor_mass),
        },
        step: summary::Step { dt_s: schedule.dt, count: outcome.steps, limited_by: limiting },
        opening: recording.opening.clone(),
        points: recording.points.clone(),
        tension: recording.tension.clone(),
        posture: recording.posture.clone(),
        mouth: recording.mouth.clone(),
        target: recording.target.clone(),
        flight: recording.flight.clone(),
        stowed: stowed(&model),
        energy: recording.energy.clone(),
        warnings,
    };
    recording.write(folder.path())?;
    summary.write(&folder.path().join(folder::SUMMARY))?;
    let hash = manifest::hash_inputs(&folder.path().join(folder::INPUTS))?;
    let mut manifest = Manifest::new(hash, Machine::this(), options.threads);
    manifest.wall_time_s = summary.wall_time_s;
    manifest.write(&folder.path().join(folder::MANIFEST))?;
    netcast_report::write_report(folder.path())?;
    Ok(Ran { summary, folder: folder.publish()?, failure })
}

/// The audit of the state at the start.
fn stowed(model: &Model) -> summary::Stowed {
    let audit = &model.audit;
    summary::Stowed {
        longest_stretch: audit.longest.map(|longest| longest.stretch),
        longest_stretch_where: audit.longest.map(|longest| model.segment_label(longest.segment)),
        stretched: audit.stretched,
        stored_energy_j: audit.stored_energy,
        packed_radius_m: audit.packed_radius,
        packed_height_m: audit.packed_height,
    }
}

/// The first tolerance that the balance misses.
fn unbalanced(energy: &summary::Energy, fraction: f64) -> Option<Failure> {
    let measures = [
        ("the residual over the largest total energy", Some(energy.closure), energy.tolerance),
        ("the residual over the web's largest energy", energy.closure_web, energy.tolerance_web),
    ];
    measures.into_iter().find_map(|(what, found, asked)| {
        let found = found.filter(|found| *found > asked)?;
        // the residual falls with the third power of the step or so; the second is on the safe side
        let smaller = 0.9 * fraction * (asked / found).sqrt();
        let smaller = format!("{smaller:.1e}").parse().unwrap_or(smaller);
        Some(Failure::Unbalanced { what, found: 100.0 * found, asked: 100.0 * asked, smaller })
    })
}

/// A step error with the names of the model's parts.
fn in_words(model: &Model, error: &StepError) -> String {
    let smaller = 0.25 * model.largest_dt() / model.limit.dt;
    let mend = format!("the step is too large for this motion, try --set solve.step_fraction={smaller:.2}");
    match error {
        StepError::NotFinite { step, time, term, place } => {
            let place = match *place {
                Place::Node(node) => model.node_label(node),
                Place::Segment(segment) => model.segment_label(segment),
            };
            format!("step {step} at {time} s: the {term} of {place} is not a finite number; {mend}")
        }
        StepError::Diverged { .. } => format!("{error}; {mend}"),
        StepError::Interrupted { .. } => error.to_string(),
    }
}

/// Writes the scenario as resolved and the files it names, each under a name of its own.
fn write_inputs(document: &Document, model: &Model, to: &Path) -> Result<(), ResultError> {
    let inputs = to.join(folder::INPUTS);
    fs::create_dir_all(&inputs).map_err(ResultError::write(&inputs))?;
    let mut scenario = model.scenario.clone();
    let mut taken = BTreeSet::from(["scenario.toml".to_owned()]);
    for file in scenario.files_mut() {
        let from = document.written.folder.join(&*file);
        let mut name = file.file_name().map_or_else(|| "file".into(), |n| n.to_string_lossy().into_owned());
        while !taken.insert(name.clone()) {
            name.insert(0, '_');
        }
        fs::copy(&from, inputs.join(&name)).map_err(ResultError::read(&from))?;
        *file = name.into();
    }
    let path = inputs.join("scenario.toml");
    fs::write(&path, resolved_toml(&scenario)).map_err(ResultError::write(&path))
}

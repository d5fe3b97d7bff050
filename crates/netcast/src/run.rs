//! The run: from a scenario to a result folder.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use netcast_dynamics::forces::breaking::Break;
use netcast_dynamics::limits::{Excess, Limits, Term};
use netcast_dynamics::simulate::{Outcome, Place, Schedule, StepError, resume, simulate};
use netcast_model::Model;
use netcast_report::ReportError;
use netcast_results::summary::{self, Summary};
use netcast_results::{
    Checkpoint, CheckpointEvery, Checkpoints, Machine, Manifest, Recorder, Recording, ResultError, ResultFolder, disk,
    folder,
};
use netcast_scenario::{Diagnostics, Document, OnEnergyError, Solve};

use crate::inputs::Inputs;
use crate::landmarks::landmarks;
use crate::launched::launched;
use crate::rest::{Rest, equilibrium};

/// How a run is carried out; nothing here changes its results.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOptions {
    /// Threads that it may use.
    pub threads: usize,
    /// Whether it goes on from where an earlier run of the same scenario with the same target stopped or died.
    pub resume: bool,
    /// How often what it takes to go on is written down.
    pub checkpoint_every: CheckpointEvery,
}

impl Default for RunOptions {
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
        RunOptions { threads, resume: false, checkpoint_every: CheckpointEvery::default() }
    }
}

/// How far a run is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Progress {
    /// On the way to its equilibrium.
    Relaxing {
        /// Iterations so far.
        iterations: u64,
        /// Largest force out of balance, over the largest tension or load.
        residual: f64,
        /// The residual that is asked for.
        tolerance: f64,
    },
    /// In time.
    Running {
        /// Time simulated so far, s.
        time_s: f64,
        /// Time at which the run ends, s.
        end_s: f64,
    },
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
    /// Whether it can go on from where it stopped.
    pub can_resume: bool,
}

/// Why a run failed although its input was right.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Failure {
    /// It stopped before its end.
    #[error("{0}")]
    Stopped(String),
    /// Its energy balance misses the tolerance, at the end or by far on the way.
    #[error(
        "the energy balance misses its tolerance: {what} is {found:.3} %, at most {asked:.3} % is allowed{since}; \
         a smaller step mends it, try --set solve.step_fraction={smaller}"
    )]
    Unbalanced {
        /// Which measure.
        what: &'static str,
        /// Its value, percent.
        found: f64,
        /// What the scenario asks for, percent.
        asked: f64,
        /// When it missed it by far and what pulled hardest there and then, for the message; empty where it did not.
        since: String,
        /// A step fraction that should do.
        smaller: f64,
    },
    /// A segment is thrown about by much of its length in one step.
    #[error(
        "step {step} at {time} s: the step does not resolve the motion: {place} changes its length by {found:.0} % in \
         one step, at most {asked:.0} % is allowed; try --set solve.step_fraction={smaller}"
    )]
    Unresolved {
        /// Which step.
        step: u64,
        /// At what time, s.
        time: f64,
        /// Which segment.
        place: String,
        /// The change, percent.
        found: f64,
        /// The most that is allowed, percent.
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
    /// The run that should go on was one of something else.
    #[error("{} was a run of other inputs: {differences}", folder.display())]
    OtherInputs {
        /// Where it is.
        folder: PathBuf,
        /// What differs.
        differences: String,
    },
    /// What the run computed cannot be written any more.
    #[error("{source}; what was computed is in {}", folder.display())]
    CutOff {
        /// What went wrong.
        source: Box<RunError>,
        /// Where it is, as far as it could be written.
        folder: PathBuf,
    },
}

/// The medium and the wind of a run.
fn air(model: &Model) -> Option<summary::Air> {
    let air = model.system.environment().air.as_ref()?;
    Some(summary::Air {
        density_kg_m3: air.medium.density(0.0),
        viscosity_pa_s: air.medium.viscosity(),
        wind_m_s: air.wind.at(0.0, 0.0).into(),
        wind_change_max_m_s: air.wind.fluctuation.values.iter().map(|wind| wind.length()).fold(0.0, f64::max),
        solidity: model.air.as_ref().and_then(|air| air.solidity),
    })
}

/// When a model's steps and records happen.
pub fn schedule(model: &Model) -> Schedule {
    let every = model.scenario.record.every.si();
    match model.scenario.solve.run_time() {
        Some(duration) => Schedule::new(duration, every, model.largest_dt()),
        None => Schedule::at_start(every, model.largest_dt()),
    }
}

/// Records from one frame of the fields to the next.
fn fields_every(model: &Model) -> u64 {
    let record = &model.scenario.record;
    record.fields_every.map_or(1.0, |t| (t.si() / record.every.si()).round().max(1.0)) as u64
}

/// Bytes that the fields of a run take at its end: the frames as they came, and the file that is made of them.
fn written_bytes(model: &Model, schedule: &Schedule) -> f64 {
    let nodes = model.system.mass().len() as f64;
    let cells = (model.system.segments().len() + model.system.membranes().len()) as f64;
    let frames = schedule.count as f64 / (schedule.steps_per_record * fields_every(model)) as f64 + 1.0;
    let bodies = model.system.bodies().len() as f64;
    2.0 * frames * (1.0 + 6.0 * nodes + cells + 4.0 * bodies) * size_of::<f64>() as f64
}

/// Runs a scenario and writes its results to `target`. `progress` hears of every record; once `interrupted` says so,
/// the run stops at the next one.
///
/// While it runs, what it has is in `<target>.running`, and outlasts a crash.
///
/// # Errors
/// [`RunError`], with nothing written, where the input is wrong, `target` cannot be written, or there is nothing to
/// resume; [`RunError::CutOff`] where results cannot be written any more. A run that goes wrong on the way is no
/// error: it is a [`Ran`] with a [`Failure`].
pub fn run(
    document: &Document,
    target: &Path,
    options: &RunOptions,
    progress: &mut (dyn FnMut(Progress) + Send),
    interrupted: &(dyn Fn() -> bool + Sync),
) -> Result<Ran, RunError> {
    let clock = Instant::now();
    let model = Model::new(document)?;
    let inputs = Inputs::new(document, &model)?;
    let input_hash = inputs.hash();
    let schedule = schedule(&model);
    disk::require(target, written_bytes(&model, &schedule))?;
    let (mut folder, checkpoint) = match options.resume {
        true => left_behind(target, &inputs, &input_hash)?,
        false => (ResultFolder::running(target)?, None),
    };
    // first of all what says whose folder it is
    let mut manifest = Manifest::new(input_hash.clone(), Machine::this(), options.threads);
    manifest.write(&folder.path().join(folder::MANIFEST))?;
    inputs.write(folder.path())?;
    let landmarks = landmarks(&model);
    landmarks.write(&folder.path().join(folder::LANDMARKS))?;

    let rest = equilibrium(&model, options.threads, progress, interrupted);
    let schedule = match &rest {
        Some(rest) if !rest.is_found() => Schedule::at_start(schedule.record_every, schedule.dt),
        _ => schedule,
    };
    let fields_every = fields_every(&model);
    let end_s = schedule.time(schedule.count);
    let mut tell = |time_s: f64| progress(Progress::Running { time_s, end_s });
    let system = &model.system;
    let state = &rest.as_ref().map_or_else(|| model.state.clone(), |rest| rest.start(&model));
    let mut recorder = Recorder::new(system, state, landmarks, fields_every, &mut tell, interrupted)?;
    if model.scenario.solve.run_time().is_none() {
        recorder = recorder.travelling_from(&model.state.position, state);
    }
    let recorder = recorder.hold_to(limits(&model.scenario.solve));
    let wall_time_before = checkpoint.as_ref().map_or(Duration::ZERO, Checkpoint::wall_time);
    let checkpoints = Checkpoints { every: options.checkpoint_every, input_hash, wall_time_before, clock };
    let mut recorder = match &checkpoint {
        None => recorder.keep_in(folder.path(), checkpoints)?,
        Some(checkpoint) => {
            let other = |_| ResultError::NotCheckpoint { path: folder.path().join(folder::CHECKPOINT) };
            checkpoint.snapshot.check(system, &schedule).map_err(other)?;
            recorder.go_on_in(folder.path(), checkpoints, checkpoint)?
        }
    };

    // from here on there is something to lose
    folder.keep();
    let kept = folder.path().to_path_buf();
    let outcome = match &checkpoint {
        None => simulate(system, state, &schedule, options.threads, &mut recorder),
        Some(checkpoint) => resume(system, &checkpoint.snapshot, &schedule, options.threads, &mut recorder),
    };
    let solve = &model.scenario.solve;
    let recording = recorder.finish(&outcome, (solve.energy_tolerance.si(), solve.web_energy_tolerance.si()));
    let ran = recording.map_err(RunError::from).and_then(|recording| {
        manifest.wall_time_s = (wall_time_before + clock.elapsed()).as_secs_f64();
        Ended { model: &model, schedule: &schedule, rest, outcome, recording }.publish(folder, &manifest)
    });
    ran.map_err(|source| RunError::CutOff { source: Box::new(source), folder: kept })
}

/// How many times its tolerance the balance may miss on the way. Its error is counted over the largest energy of the
/// run, which may still grow.
const ON_THE_WAY: f64 = 2.0;

/// The largest change of a segment's length in one step, over its rest length.
const LARGEST_SWEEP: f64 = 0.5;

/// What a run is held to while it goes on.
fn limits(solve: &Solve) -> Limits {
    Limits {
        closure: ON_THE_WAY * solve.energy_tolerance.si(),
        sweep: LARGEST_SWEEP,
        stops: solve.on_energy_error == OnEnergyError::Stop,
    }
}

/// The folder of the run that goes on, and its checkpoint; none where that run died before its first, and this one
/// begins at the start.
fn left_behind(
    target: &Path,
    inputs: &Inputs,
    input_hash: &str,
) -> Result<(ResultFolder, Option<Checkpoint<'static>>), RunError> {
    let read = |left: &Path| Checkpoint::read(&left.join(folder::CHECKPOINT));
    let folder = ResultFolder::resuming(target, |left| match read(left)? {
        (_, hash) if hash == input_hash => Ok(()),
        _ => Err(RunError::OtherInputs { folder: left.to_path_buf(), differences: inputs.differences(left) }),
    })?;
    let checkpoint = match folder.path().join(folder::CHECKPOINT).exists() {
        true => Some(read(folder.path())?.0),
        false => None,
    };
    Ok((folder, checkpoint))
}

/// A run that has come to its end, one way or another.
struct Ended<'m> {
    model: &'m Model,
    schedule: &'m Schedule,
    rest: Option<Rest>,
    outcome: Outcome,
    recording: Recording,
}

impl Ended<'_> {
    /// Writes what it comes to and puts its folder in its place.
    fn publish(self, folder: ResultFolder, manifest: &Manifest) -> Result<Ran, RunError> {
        let (failure, warnings) = self.verdict();
        // a run that was interrupted can go on; any other ended, or would end in the same way again
        let can_resume = matches!(self.outcome.stopped, Some(StepError::Interrupted { .. }));
        if !can_resume {
            folder.forget_checkpoint()?;
        }
        let summary = self.summary(manifest.wall_time_s, warnings);
        summary.write(&folder.path().join(folder::SUMMARY))?;
        manifest.write(&folder.path().join(folder::MANIFEST))?;
        netcast_report::write_report(folder.path())?;
        Ok(Ran { summary, folder: folder.publish()?, failure, can_resume })
    }

    /// Why it failed, if it did, and what the reader should know.
    fn verdict(&self) -> (Option<Failure>, Vec<String>) {
        let (stopped, solve) = (&self.outcome.stopped, &self.model.scenario.solve);
        let unrest = self.rest.as_ref().and_then(|rest| rest.failure(self.model)).map(Failure::Stopped);
        // a run that came apart says so, and what mends it
        let came_apart = matches!(stopped, Some(StepError::Diverged { .. } | StepError::NotFinite { .. }));
        let missed = if came_apart { None } else { self.unresolved().or_else(|| self.unbalanced()) };
        let stopped = stopped.as_ref().filter(|error| !matches!(error, StepError::Exceeded(_)));
        let stopped = unrest.or(stopped.map(|error| Failure::Stopped(in_words(self.model, error))));
        let mut warnings = self.model.notes.clone();
        warnings.extend(stopped.iter().chain(&missed).map(Failure::to_string));
        (stopped.or(missed.filter(|_| solve.on_energy_error == OnEnergyError::Stop)), warnings)
    }

    /// That the step does not resolve the motion.
    fn unresolved(&self) -> Option<Failure> {
        let Excess { term, found, allowed, step, time, segment } = self.outcome.exceeded?;
        let place = self.model.segment_label(segment.filter(|_| term == Term::Sweep)?);
        let smaller = sensible(0.5 * self.fraction() * allowed / found);
        Some(Failure::Unresolved { step, time, place, found: 100.0 * found, asked: 100.0 * allowed, smaller })
    }

    /// The first tolerance that the balance misses.
    fn unbalanced(&self) -> Option<Failure> {
        let energy = &self.recording.energy;
        let measures = [
            ("the residual over the largest total energy", Some(energy.closure), energy.tolerance),
            ("the residual over the web's largest energy", energy.closure_web, energy.tolerance_web),
        ];
        let missed = |found: Option<f64>, asked: f64| found.filter(|found| *found > asked);
        let (what, found, asked) =
            measures.into_iter().find_map(|(what, found, asked)| Some((what, missed(found, asked)?, asked)))?;
        let since = self.outcome.exceeded.map_or(String::new(), |excess| {
            let hardest = excess.segment.map(|s| format!(", where {} pulls hardest", self.model.segment_label(s)));
            format!(
                ", and twice that was missed at step {} at {} s{}",
                excess.step,
                excess.time,
                hardest.unwrap_or_default()
            )
        });
        // the residual falls with the third power of the step or so; the second is on the safe side. One that was
        // missed on the way would have grown, as far as one knows in proportion to time
        let at_the_end = found * self.schedule.end / self.outcome.end_time;
        let smaller = sensible(0.9 * self.fraction() * (asked / at_the_end).sqrt());
        Some(Failure::Unbalanced { what, found: 100.0 * found, asked: 100.0 * asked, since, smaller })
    }

    /// The share of the stable step that was taken.
    fn fraction(&self) -> f64 {
        self.model.scenario.solve.step_fraction.map_or(1.0, |fraction| fraction.si())
    }

    fn summary(self, wall_time_s: f64, warnings: Vec<String>) -> Summary {
        let Ended { model, schedule, rest, outcome, recording } = self;
        let (system, bill) = (&model.system, &model.bill);
        let breaks: Vec<summary::Break> = outcome.breaks.iter().map(|broken| told(model, broken)).collect();
        let broken = || breaks.iter().filter(|broken| !broken.released);
        Summary {
            title: model.scenario.title.clone(),
            netcast: env!("CARGO_PKG_VERSION").to_owned(),
            wall_time_s,
            finished: outcome.stopped.is_none() && rest.as_ref().is_none_or(Rest::is_found),
            model: summary::Model {
                nodes: system.mass().len(),
                segments: system.segments().len(),
                rope_length_m: bill.length_by_class.values().sum(),
                web_mass_kg: model.mass - bill.tractor_mass,
                tractor_mass_kg: (bill.tractors > 0).then_some(bill.tractor_mass),
            },
            step: summary::Step {
                dt_s: schedule.dt,
                count: outcome.steps,
                limited_by: model.limited_by(),
                lifted_by: model.step_lift(),
            },
            launch: launched(model, &outcome),
            air: air(model),
            statics: rest.as_ref().map(|rest| rest.summary(model)),
            opening: recording.opening,
            points: recording.points,
            tension: summary::Tension {
                broken_segments: broken().count(),
                first_break_time_s: broken().next().map(|first| first.time_s),
                ..recording.tension
            },
            breaks,
            posture: recording.posture,
            mouth: recording.mouth,
            target: recording.target,
            flight: recording.flight,
            canopies: recording.cloth,
            stowed: stowed(model),
            energy: recording.energy,
            warnings,
        }
    }
}

/// A segment that broke, with the names of the model's parts.
fn told(model: &Model, broken: &Break) -> summary::Break {
    let &Break { segment, step: _, time, tension } = broken;
    let class = &model.groups[model.system.segments()[segment].class].class;
    summary::Break {
        time_s: time,
        place: model.segment_label(segment),
        segment,
        class: class.name().to_owned(),
        tension_n: tension,
        released: class.is_made_to_break(),
    }
}

/// The audit of the state at the start.
fn stowed(model: &Model) -> summary::Stowed {
    let audit = &model.audit;
    let packing = model.packing();
    let closest = packing.closeness.and_then(|closeness| closeness.closest);
    summary::Stowed {
        longest_stretch: audit.longest.map(|longest| longest.stretch),
        longest_stretch_where: audit.longest.map(|longest| model.segment_label(longest.segment)),
        stretched: audit.stretched,
        stored_energy_j: audit.stored_energy,
        packed_radius_m: audit.packed_radius,
        packed_height_m: audit.packed_height,
        density_kg_m3: packing.density,
        solid_fraction: packing.solid_fraction,
        closest_approach_m: closest.map(|closest| closest.distance),
        closest_approach_where: closest.map(|closest| closest.segments.map(|s| model.segment_label(s)).join(" and ")),
        closest_approach_at_m: closest.map(|closest| closest.place.to_array()),
        nearer_than_a_diameter: packing.closeness.map(|closeness| closeness.touching),
    }
}

/// Two digits, as one types them.
fn sensible(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
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
        StepError::Exceeded(_) | StepError::Interrupted { .. } => error.to_string(),
    }
}

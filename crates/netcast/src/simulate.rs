//! A case in time: from its start, or the equilibrium that it begins from, to its end.
//!
//! One way for all runs: [`Start`] finds where a run begins, the recorder measures it, [`Ended`] says what it comes to.
//! In memory the recorder keeps rows and frames ([`Run`]); into a folder it writes them as they come (`publish.rs`).

use netcast_dynamics::limits::Limits;
use netcast_dynamics::simulate::{Frame, Live, Observer, Outcome, Schedule, resume, simulate};
use netcast_dynamics::snapshot::Snapshot;
use netcast_dynamics::state::State;
use netcast_model::Model;
use netcast_results::{Checkpoint, CheckpointEvery, EnergyTolerance, Recorder, ResultError, Series, Summary};
use netcast_scenario::{OnEnergyError, Solve};

use crate::case::Case;
use crate::progress::{Interrupted, Progress, Tell};
use crate::rest::{Rest, equilibrium};
use crate::summary::summary;

/// How a run is carried out; nothing here changes its results.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOptions {
    /// Threads that it may use.
    pub threads: usize,
    /// Whether a run into a folder goes on from where an earlier one of the same scenario stopped or died.
    pub resume: bool,
    /// How often a run into a folder writes down what it takes to go on.
    pub checkpoint_every: CheckpointEvery,
}

impl Default for RunOptions {
    fn default() -> Self {
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
        RunOptions { threads, resume: false, checkpoint_every: CheckpointEvery::default() }
    }
}

/// Looks at a record and says whether the run should stop there.
type Stop<'s> = dyn FnMut(&Frame) -> bool + Send + 's;

/// A run to be: how a case will be simulated, who watches, when it stops.
///
/// Made by [`Case::simulation`]; [`run`](Self::run) carries it out in memory, [`run_to`](Self::run_to) into a folder.
pub struct Simulation<'s> {
    pub(crate) case: &'s Case,
    pub(crate) options: RunOptions,
    pub(crate) watchers: Watchers<'s>,
    pub(crate) progress: Box<Tell<'s>>,
    pub(crate) interrupted: Box<Interrupted<'s>>,
}

/// Who watches a run beside its recorder.
#[derive(Default)]
pub(crate) struct Watchers<'s> {
    observer: Option<&'s mut dyn Observer>,
    stop: Option<Box<Stop<'s>>>,
}

impl Case {
    /// A run to be, with the default options and nobody watching.
    pub fn simulation(&self) -> Simulation<'_> {
        Simulation {
            case: self,
            options: RunOptions::default(),
            watchers: Watchers::default(),
            progress: Box::new(|_| {}),
            interrupted: Box::new(|| false),
        }
    }
}

impl<'s> Simulation<'s> {
    /// Sets all options.
    pub fn options(mut self, options: RunOptions) -> Self {
        self.options = options;
        self
    }

    /// Sets how many threads it may use; its results do not depend on them.
    pub fn threads(mut self, threads: usize) -> Self {
        self.options.threads = threads;
        self
    }

    /// Shows every step and every record to `observer` too. A case whose step netcast chose is run again at a smaller one
    /// where the first misses its energy tolerance; the observer then sees a second run from its start. What the run is
    /// held to, the scenario says; the observer's [`limits`](Observer::limits) are not asked.
    pub fn observe(mut self, observer: &'s mut dyn Observer) -> Self {
        self.watchers.observer = Some(observer);
        self
    }

    /// Stops the run at the first record at which `stop` says so. It has then been interrupted:
    /// [`Summary::finished`](netcast_results::Summary::finished) is false.
    pub fn stop_when(mut self, stop: impl FnMut(&Frame) -> bool + Send + 's) -> Self {
        self.watchers.stop = Some(Box::new(stop));
        self
    }

    /// Tells `progress` of every record, and of the way to an equilibrium.
    pub fn progress(mut self, progress: impl FnMut(Progress) + Send + 's) -> Self {
        self.progress = Box::new(progress);
        self
    }

    /// Stops the run at its next record once `interrupted` says so; also on the way to an equilibrium.
    pub fn interrupt_when(mut self, interrupted: impl Fn() -> bool + Sync + 's) -> Self {
        self.interrupted = Box::new(interrupted);
        self
    }
}

/// Where a run begins: at the start of its model, or at the equilibrium that was found.
pub(crate) struct Start<'c> {
    model: &'c Model,
    case: &'c Case,
    rest: Option<Rest>,
    schedule: Schedule,
    state: State,
}

impl<'c> Start<'c> {
    /// That of a case. Takes the time of its equilibrium, where it asks for one.
    pub fn of(case: &'c Case, threads: usize, progress: &mut Tell, interrupted: &Interrupted) -> Self {
        let model = case.model();
        let rest = equilibrium(model, threads, progress, interrupted);
        let schedule = *case.schedule();
        let schedule = match &rest {
            Some(rest) if !rest.is_found() => Schedule::at_start(schedule.record_every, schedule.dt),
            _ => schedule,
        };
        let state = rest.as_ref().map_or_else(|| model.state.clone(), |rest| rest.start(model));
        Self { model, case, rest, schedule, state }
    }

    /// When steps and records happen: none but the first where no equilibrium was found to begin from.
    pub fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// What measures the run. `tell` hears of the time of every record.
    pub fn recorder<'r>(
        &self,
        tell: &'r mut (dyn FnMut(f64) + Send + 'r),
        interrupted: &'r Interrupted<'r>,
    ) -> Result<Recorder<'r>, ResultError> {
        let Self { model, case, state, .. } = self;
        let landmarks = case.landmarks().clone();
        let mut recorder = Recorder::new(&model.system, state, landmarks, fields_every(model), tell, interrupted)?;
        if model.scenario.solve.run_time().is_none() {
            recorder = recorder.travelling_from(&model.state.position, state);
        }
        Ok(recorder.hold_to(limits(&model.scenario.solve)))
    }

    /// Runs to the end, from `checkpoint` where there is one, else from here.
    pub fn simulate(
        self,
        recorder: Recorder,
        watchers: &mut Watchers,
        checkpoint: Option<&Checkpoint>,
        threads: usize,
    ) -> Result<Ended<'c>, ResultError> {
        let Self { model, case: _, rest, schedule, state } = self;
        let mut watched = Watched::new(recorder, watchers);
        let outcome = match checkpoint {
            None => simulate(&model.system, &state, &schedule, threads, &mut watched),
            Some(checkpoint) => resume(&model.system, &checkpoint.snapshot, &schedule, threads, &mut watched),
        };
        let solve = &model.scenario.solve;
        let (of_total, of_web) = (solve.energy_tolerance.si(), solve.web_energy_tolerance.si());
        let tolerance = EnergyTolerance { of_total, of_web };
        let series = watched.recorder.take_series();
        let measured = watched.recorder.finish(&outcome, tolerance)?;
        Ok(Ended { model, schedule, rest, outcome, measured, series })
    }
}

/// A run that has come to its end, one way or another.
pub(crate) struct Ended<'m> {
    pub model: &'m Model,
    pub schedule: Schedule,
    pub rest: Option<Rest>,
    pub outcome: Outcome,
    /// The sections of its summary that are measured.
    pub measured: Summary,
    /// Its rows and frames, where they were kept in memory.
    pub series: Option<Series>,
}

impl Ended<'_> {
    /// What it comes to, with the time that it took on the clock and what the reader should know.
    pub fn summary(self, wall_time_s: f64, warnings: Vec<String>) -> Summary {
        let Self { model, schedule, rest, outcome, measured, series: _ } = self;
        let summary = summary(model, schedule.dt, rest.as_ref(), &outcome, measured);
        Summary { wall_time_s, warnings, ..summary }
    }
}

/// Records from one frame of the fields to the next.
pub(crate) fn fields_every(model: &Model) -> u64 {
    let record = &model.scenario.record;
    record.fields_every.map_or(1.0, |t| (t.si() / record.every.si()).round().max(1.0)) as u64
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

/// The recorder, and who watches beside it.
struct Watched<'r, 'w, 's> {
    recorder: Recorder<'r>,
    watchers: &'w mut Watchers<'s>,
    is_stopped: bool,
    /// Who asked for a snapshot: the recorder, the observer.
    wanted: [bool; 2],
    /// Who asked for the net at the next step: the recorder, the observer.
    wants_a_moment: [bool; 2],
}

impl<'r, 'w, 's> Watched<'r, 'w, 's> {
    fn new(recorder: Recorder<'r>, watchers: &'w mut Watchers<'s>) -> Self {
        Self { recorder, watchers, is_stopped: false, wanted: [false; 2], wants_a_moment: [false; 2] }
    }
}

impl Observer for Watched<'_, '_, '_> {
    fn step(&mut self, live: &Live) {
        self.recorder.step(live);
        if let Some(observer) = &mut self.watchers.observer {
            observer.step(live);
        }
    }

    fn record(&mut self, frame: &Frame) {
        self.recorder.record(frame);
        if let Some(observer) = &mut self.watchers.observer {
            observer.record(frame);
        }
        if let Some(stop) = &mut self.watchers.stop {
            self.is_stopped |= stop(frame);
        }
    }

    fn check(&mut self, frame: &Frame) {
        self.recorder.check(frame);
        if let Some(observer) = &mut self.watchers.observer {
            observer.check(frame);
        }
    }

    fn wants_moment(&mut self) -> bool {
        let by_observer = self.watchers.observer.as_mut().is_some_and(|observer| observer.wants_moment());
        self.wants_a_moment = [self.recorder.wants_moment(), by_observer];
        self.wants_a_moment != [false; 2]
    }

    fn moment(&mut self, frame: &Frame) {
        let [for_recorder, for_observer] = self.wants_a_moment;
        if for_recorder {
            self.recorder.moment(frame);
        }
        if let Some(observer) = self.watchers.observer.as_mut().filter(|_| for_observer) {
            observer.moment(frame);
        }
    }

    fn limits(&self) -> Limits {
        self.recorder.limits()
    }

    fn watches(&self) -> Vec<&'static str> {
        self.watchers.observer.as_ref().map_or(Vec::new(), |observer| observer.watches())
    }

    fn interrupted(&self) -> bool {
        let by_observer = self.watchers.observer.as_ref().is_some_and(|observer| observer.interrupted());
        self.is_stopped || by_observer || self.recorder.interrupted()
    }

    fn wants_snapshot(&mut self) -> bool {
        let by_observer = self.watchers.observer.as_mut().is_some_and(|observer| observer.wants_snapshot());
        self.wanted = [self.recorder.wants_snapshot(), by_observer];
        self.wanted != [false; 2]
    }

    fn wants_last_snapshot(&mut self) -> bool {
        let by_observer = self.watchers.observer.as_mut().is_some_and(|observer| observer.wants_last_snapshot());
        self.wanted = [self.recorder.wants_last_snapshot(), by_observer];
        self.wanted != [false; 2]
    }

    fn snapshot(&mut self, snapshot: &Snapshot) {
        let [for_recorder, for_observer] = self.wanted;
        let at_the_end = self.interrupted();
        if for_recorder || at_the_end {
            self.recorder.snapshot(snapshot);
        }
        if let Some(observer) = self.watchers.observer.as_mut().filter(|_| for_observer || at_the_end) {
            observer.snapshot(snapshot);
        }
    }
}

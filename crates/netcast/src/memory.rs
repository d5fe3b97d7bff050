//! Runs a case in memory: summary, history and frames are values, and no file is written.

use std::path::{Path, PathBuf};
use std::time::Instant;

use glam::{DQuat, DVec3};
use netcast_results::{Fields, History, Machine, Manifest, ResultFolder, SecondRun, Series, Summary, require_room};

use crate::case::Case;
use crate::error::RunError;
use crate::progress::Progress;
use crate::publish::{begin, complete, written_bytes};
use crate::simulate::{Simulation, Start};
use crate::verdict::Failure;

/// A run in memory. A run that failed holds its results up to the failure.
#[derive(Debug, Clone)]
pub struct Run {
    /// The content of `summary.json`: opening, points, tension, energy, breaks and others.
    pub summary: Summary,
    /// The cause of the failure; none where the run reached its end.
    pub failure: Option<Failure>,
    series: Series,
    manifest: Manifest,
    case: Case,
}

/// The whole net at a record time of a [`Run`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunFrame<'r> {
    /// Time, s.
    pub time_s: f64,
    /// Positions in the world frame, m, (nodes,).
    pub position_m: &'r [DVec3],
    /// Velocities, m/s, (nodes,).
    pub velocity_m_s: &'r [DVec3],
    /// Tensions, N, (segments,); NaN for a broken segment.
    pub tension_n: &'r [f64],
    /// Rotations from the axes of each rigid body to the world frame, (bodies,).
    pub orientation: &'r [DQuat],
}

impl Case {
    /// Simulates the case in memory with the default options and without observers.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    pub fn simulate(&self) -> Result<Run, RunError> {
        self.simulation().run()
    }
}

impl Simulation<'_> {
    /// Runs the simulation in memory and writes nothing. All rows and frames stay in memory: a frame takes 48 bytes for
    /// each node and 8 bytes for each segment.
    ///
    /// # Errors
    /// [`RunError::Result`] where the landmarks do not fit the model. A run that fails is no error: it is a [`Run`]
    /// with a [`Failure`].
    pub fn run(self) -> Result<Run, RunError> {
        let clock = Instant::now();
        let Simulation { case, options, mut watchers, mut progress, interrupted } = self;
        let mut manifest = Manifest::new(case.inputs().hash(), Machine::this(), options.threads);
        let (mut case, mut second) = (case.clone(), None::<SecondRun>);
        loop {
            let start = Start::of(&case, options.threads, &mut *progress, &*interrupted);
            let end_s = start.schedule().time(start.schedule().count);
            let mut tell = |time_s: f64| progress(Progress::Running { time_s, end_s });
            let recorder = start.recorder(&mut tell, &*interrupted)?.keep_in_memory();
            let mut ended = start.simulate(recorder, &mut watchers, None, options.threads)?;
            if let Some(again) = ended.second_run(&case, second.is_none()) {
                drop(ended);
                case = case.with_step_fraction(again.step_fraction);
                second = Some(again);
                continue;
            }
            manifest.wall_time_s = clock.elapsed().as_secs_f64();
            let series = ended.series.take().expect("it was kept in memory");
            let (failure, warnings) = ended.verdict(second.as_ref());
            let summary = ended.summary(manifest.wall_time_s, warnings);
            return Ok(Run { summary, failure, series, manifest, case });
        }
    }
}

impl Run {
    /// The case that was run.
    pub fn case(&self) -> &Case {
        &self.case
    }

    /// The content of `history.csv`: one row for each record time, columns by name.
    pub fn history(&self) -> &History {
        &self.series.history
    }

    /// The content of `fields.vtkhdf`: all nodes and segments in each frame, and the ends of the segments.
    pub fn fields(&self) -> &Fields {
        &self.series.fields
    }

    /// The frames in order of time: one for each record time, or one every `record.fields_every`.
    pub fn frames(&self) -> impl ExactSizeIterator<Item = RunFrame<'_>> {
        let fields = &self.series.fields;
        fields.times.iter().enumerate().map(|(step, &time_s)| RunFrame {
            time_s,
            position_m: fields.positions(step),
            velocity_m_s: fields.velocities(step),
            tension_n: fields.tensions(step),
            orientation: fields.orientations(step),
        })
    }

    /// Writes the result folder with its report, as `netcast run` does, and returns its path.
    ///
    /// # Errors
    /// [`RunError`] where `target` holds files that netcast did not write, or cannot be written; nothing is left
    /// behind.
    pub fn write(&self, target: impl AsRef<Path>) -> Result<PathBuf, RunError> {
        let target = target.as_ref();
        require_room(target, written_bytes(&self.case))?;
        let folder = ResultFolder::create(target)?;
        begin(folder.path(), &self.case, &self.manifest)?;
        self.series.write(folder.path())?;
        complete(folder, &self.summary, &self.manifest)
    }
}

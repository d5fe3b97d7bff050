//! A run in memory: its summary, history and frames as values. It writes nothing.

use std::path::{Path, PathBuf};
use std::time::Instant;

use glam::{DQuat, DVec3};
use netcast_results::{Fields, History, Machine, Manifest, ResultFolder, Series, Summary, require_room};

use crate::case::Case;
use crate::error::RunError;
use crate::progress::Progress;
use crate::publish::{begin, complete, written_bytes};
use crate::simulate::{Simulation, Start};
use crate::verdict::Failure;

/// A run that was carried out in memory, to its end or not.
#[derive(Debug, Clone)]
pub struct Run {
    /// What `summary.json` holds: opening, points, tension, energy, breaks and the rest.
    pub summary: Summary,
    /// Why it failed; what was computed up to then is here all the same.
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
    /// Tensions, N, (segments,); NaN where a segment is gone.
    pub tension_n: &'r [f64],
    /// From the axes of each rigid body to the world, (bodies,).
    pub orientation: &'r [DQuat],
}

impl Case {
    /// Simulates the case in memory, with the default options and nobody watching.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    pub fn simulate(&self) -> Result<Run, RunError> {
        self.simulation().run()
    }
}

impl Simulation<'_> {
    /// Carries the run out in memory and writes nothing. Its rows and frames stay in memory: a frame takes 8 bytes for
    /// each of six numbers a node and one number a segment.
    ///
    /// # Errors
    /// [`RunError::Result`] where what is measured does not fit the model. A run that goes wrong on the way is no
    /// error: it is a [`Run`] with a [`Failure`].
    pub fn run(self) -> Result<Run, RunError> {
        let clock = Instant::now();
        let Simulation { case, options, watchers, mut progress, interrupted } = self;
        let mut manifest = Manifest::new(case.inputs().hash(), Machine::this(), options.threads);
        let start = Start::of(case, options.threads, &mut *progress, &*interrupted);
        let end_s = start.schedule().time(start.schedule().count);
        let mut tell = |time_s: f64| progress(Progress::Running { time_s, end_s });
        let recorder = start.recorder(&mut tell, &*interrupted)?.keep_in_memory();
        let mut ended = start.simulate(recorder, watchers, None, options.threads)?;
        manifest.wall_time_s = clock.elapsed().as_secs_f64();
        let series = ended.series.take().expect("it was kept in memory");
        let (failure, warnings) = ended.verdict();
        let summary = ended.summary(manifest.wall_time_s, warnings);
        Ok(Run { summary, failure, series, manifest, case: case.clone() })
    }
}

impl Run {
    /// The case that was run.
    pub fn case(&self) -> &Case {
        &self.case
    }

    /// What `history.csv` holds: one row a record time, columns by name.
    pub fn history(&self) -> &History {
        &self.series.history
    }

    /// What `fields.vtkhdf` holds: every node and segment in time, and how they hang together.
    pub fn fields(&self) -> &Fields {
        &self.series.fields
    }

    /// The frames in order of time: one a record time, or one every `record.fields_every`.
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

    /// Writes the result folder, the one that `netcast run` writes, with its report; returns where it stands.
    ///
    /// # Errors
    /// [`RunError`], with nothing left behind, where `target` holds what netcast did not write, or cannot be written.
    pub fn write(&self, target: impl AsRef<Path>) -> Result<PathBuf, RunError> {
        let target = target.as_ref();
        require_room(target, written_bytes(&self.case))?;
        let folder = ResultFolder::create(target)?;
        begin(folder.path(), &self.case, &self.manifest)?;
        self.series.write(folder.path())?;
        complete(folder, &self.summary, &self.manifest)
    }
}

//! The observer that turns a run into results: measures at every step, rows and frames at records. Rows and frames
//! go to the disk as they come, or stay in memory; the measures are few, and are kept in checkpoints.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use glam::DVec3;
use netcast_dynamics::limits::Limits;
use netcast_dynamics::simulate::{Frame, Live, Observer, Outcome, StepError};
use netcast_dynamics::snapshot::Snapshot;
use netcast_dynamics::state::State;
use netcast_dynamics::system::System;

use crate::checkpoint::{Checkpoint, CheckpointEvery, SecondRun};
use crate::landmarks::Landmarks;
use crate::measures::{EnergyTolerance, MeasuredNet, Measures, WebState};
use crate::row::{ClassTensions, RowLayout, RunRecord};
use crate::series::Series;
use crate::stream::Stream;
use crate::summary::Summary;
use crate::{FieldsTopology, ResultError, folder};

/// Called at every record with the time that the run has reached, s.
pub type ProgressCallback<'p> = dyn FnMut(f64) + Send + 'p;

/// Records a run.
pub struct Recorder<'r> {
    of: MeasuredNet,
    measures: Measures,
    fields_every: u64,
    layout: RowLayout,
    topology: FieldsTopology,
    keeping: Keeping,
    progress: &'r mut ProgressCallback<'r>,
    interrupted: &'r (dyn Fn() -> bool + Sync),
    limits: Limits,
    wants_moment: bool,
    error: Option<ResultError>,
}

/// How a run is checkpointed.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoints {
    /// How often.
    pub every: CheckpointEvery,
    /// What the inputs are known by; see [`crate::hash_files`].
    pub input_hash: String,
    /// Time on the clock that the run had taken before this program took it over.
    pub wall_time_before: Duration,
    /// When this program took it over.
    pub clock: Instant,
    /// Set where the run is the second one of its case.
    pub second_run: Option<SecondRun>,
}

/// Time on the clock after which the end of a run is worth a checkpoint.
const WORTH_A_LAST: Duration = Duration::from_secs(1);

/// Where rows and frames go.
enum Keeping {
    /// Nowhere: only measures are taken.
    Nowhere,
    /// Into memory.
    InMemory(Box<Series>),
    /// Onto the disk, as they come.
    OnDisk(Box<Kept>),
}

/// What of a run is on the disk while it goes on.
struct Kept {
    stream: Stream,
    checkpoints: Checkpoints,
    checkpoint: PathBuf,
    /// Time simulated, s, and time on the clock at the last checkpoint.
    last: (f64, Instant),
}

impl<'r> Recorder<'r> {
    /// A recorder of `system` from `state` on, that measures. With [`Recorder::keep_in`] it writes rows and frames as
    /// well, with [`Recorder::keep_in_memory`] it keeps them: a frame at every `fields_every`-th record. `progress` hears
    /// of every record; the run stops at the next one once `interrupted` says so.
    ///
    /// # Errors
    /// [`ResultError::Length`] where `landmarks` do not fit the system.
    pub fn new(
        system: &System,
        state: &State,
        landmarks: Landmarks,
        fields_every: u64,
        progress: &'r mut ProgressCallback<'r>,
        interrupted: &'r (dyn Fn() -> bool + Sync),
    ) -> Result<Recorder<'r>, ResultError> {
        ResultError::length("groups of segments", system.group_count(), landmarks.groups.len())?;
        let topology = topology(system, &landmarks);
        let of_web = system.mass().iter().zip(system.tractor());
        let of = MeasuredNet {
            web_mass: of_web.map(|(&mass, &tractor)| if tractor { 0.0 } else { mass }).collect(),
            groups: system.segments().iter().map(|segment| segment.group).collect(),
            membranes: system.membranes().to_vec(),
            channels: system.channels().collect(),
            landmarks,
        };
        Ok(Recorder {
            measures: Measures::new(&of, &state.position, &state.position),
            layout: RowLayout::new(&of.landmarks, &of.channels),
            topology,
            of,
            fields_every,
            keeping: Keeping::Nowhere,
            progress,
            interrupted,
            limits: Limits::NONE,
            wants_moment: false,
            error: None,
        })
    }

    /// Counts travel from `reference` positions, m, (nodes,), in place of those of the `state` that it starts from.
    pub fn travelling_from(mut self, reference: &[DVec3], state: &State) -> Self {
        self.measures = Measures::new(&self.of, reference, &state.position);
        self
    }

    /// Holds the run to `limits`.
    pub fn hold_to(self, limits: Limits) -> Self {
        Self { limits, ..self }
    }

    /// Keeps rows and frames in memory; [`Recorder::take_series`] hands them over.
    pub fn keep_in_memory(mut self) -> Self {
        let series = Series::new(self.layout.columns.clone(), self.topology.clone());
        self.keeping = Keeping::InMemory(Box::new(series));
        self
    }

    /// What was kept in memory, where it was asked to be; from then on nothing is kept.
    pub fn take_series(&mut self) -> Option<Series> {
        match std::mem::replace(&mut self.keeping, Keeping::Nowhere) {
            Keeping::InMemory(mut series) => {
                for frame in self.measures.moments().iter() {
                    series.fields.insert(frame);
                }
                Some(*series)
            }
            other => {
                self.keeping = other;
                None
            }
        }
    }

    /// Writes rows and frames into `folder` from the start of the run on, and checkpoints.
    ///
    /// # Errors
    /// [`ResultError`] names the file that cannot be written.
    pub fn keep_in(mut self, folder: &Path, checkpoints: Checkpoints) -> Result<Self, ResultError> {
        let stream = Stream::create(folder, &self.layout.columns, &self.topology)?;
        self.keeping = Keeping::OnDisk(Box::new(Kept::new(folder, stream, checkpoints, 0.0)));
        Ok(self)
    }

    /// Goes on writing into `folder` from `checkpoint` on: the recorder of a run that is resumed from its snapshot.
    ///
    /// # Errors
    /// [`ResultError::NotCheckpoint`] where it is one of another system, [`ResultError::Changed`] where the files in
    /// `folder` are no longer those of the checkpoint.
    pub fn go_on_in(
        mut self,
        folder: &Path,
        checkpoints: Checkpoints,
        checkpoint: &Checkpoint,
    ) -> Result<Self, ResultError> {
        if !checkpoint.measures.fit(&self.of.landmarks) {
            return Err(ResultError::NotCheckpoint { path: folder.join(folder::CHECKPOINT) });
        }
        let stream = Stream::reopen(folder, checkpoint.written)?;
        self.measures = checkpoint.measures.clone().into_owned();
        self.keeping = Keeping::OnDisk(Box::new(Kept::new(folder, stream, checkpoints, checkpoint.time_s)));
        Ok(self)
    }

    /// One row of the history.
    fn row(&self, frame: &Frame, web: &WebState) -> Vec<Option<f64>> {
        let (landmarks, at_steps) = (&self.of.landmarks, &self.measures.at_steps);
        let class_tensions = self.class_tensions(frame.tension);
        self.layout.row(&RunRecord { landmarks, frame, at_steps, class_tensions, web })
    }

    /// Tension of each class, of the segments that are not gone.
    fn class_tensions(&self, tension: &[f64]) -> Vec<ClassTensions> {
        let landmarks = &self.of.landmarks;
        let mut found = vec![ClassTensions::default(); landmarks.classes.len()];
        let mut count = vec![0.0; landmarks.classes.len()];
        for (&tension, &group) in tension.iter().zip(&self.of.groups).filter(|(tension, _)| !tension.is_nan()) {
            let class = landmarks.groups[group].class;
            let of = &mut found[class];
            (of.mean, of.now, count[class]) = (of.mean + tension, of.now.max(tension), count[class] + 1.0);
        }
        let peaks = &self.measures.at_steps.since_record().class_tension;
        for ((of, count), peak) in found.iter_mut().zip(count).zip(peaks) {
            of.mean /= f64::max(count, 1.0);
            of.peak = of.now.max(*peak);
        }
        found
    }

    /// Keeps a record where it is asked to.
    fn keep(&mut self, frame: &Frame, web: &WebState) -> Result<(), ResultError> {
        if matches!(self.keeping, Keeping::Nowhere) {
            return Ok(());
        }
        let row = self.row(frame, web);
        let has_fields = self.measures.rows.is_multiple_of(self.fields_every);
        let orientations = frame.rotation.iter().map(|rotation| rotation.orientation);
        match &mut self.keeping {
            Keeping::Nowhere => Ok(()),
            Keeping::InMemory(series) => {
                if has_fields {
                    series.fields.push(frame.time, frame.position, frame.velocity, frame.tension, orientations);
                }
                series.history.push(row)
            }
            Keeping::OnDisk(kept) => {
                let stream = &mut kept.stream;
                stream.row(&row)?;
                if has_fields {
                    stream.fields().push(frame.time, frame.position, frame.velocity, frame.tension, orientations)?;
                }
                stream.keep_up()
            }
        }
    }

    /// Ends the recording with how the run ended, and closes its files. Returns the sections of the summary that are
    /// measured. `tolerance` is what the balance was asked to reach.
    ///
    /// # Errors
    /// The first one that came up while recording.
    pub fn finish(self, outcome: &Outcome, tolerance: EnergyTolerance) -> Result<Summary, ResultError> {
        if let Some(error) = self.error {
            return Err(error);
        }
        if let Keeping::OnDisk(kept) = self.keeping {
            // a run that can go on keeps its frames as they came: it appends to them
            let is_over = !matches!(outcome.stopped, Some(StepError::Interrupted { .. }));
            kept.stream.finish(self.measures.moments().iter().filter(|_| is_over))?;
        }
        Ok(self.measures.finish(&self.of, outcome, tolerance))
    }
}

impl Observer for Recorder<'_> {
    fn step(&mut self, live: &Live) {
        self.wants_moment = self.measures.step(&self.of, live);
    }

    fn record(&mut self, frame: &Frame) {
        let web = self.measures.web(&self.of, frame);
        let kept = self.keep(frame, &web);
        self.remember(kept);
        self.measures.recorded(&self.of, frame);
        (self.progress)(frame.time);
    }

    fn check(&mut self, frame: &Frame) {
        self.measures.check(&self.of, frame);
    }

    fn wants_moment(&mut self) -> bool {
        self.wants_moment
    }

    fn moment(&mut self, frame: &Frame) {
        self.measures.keep(&self.of, frame);
    }

    fn limits(&self) -> Limits {
        self.limits
    }

    fn interrupted(&self) -> bool {
        self.error.is_some() || (self.interrupted)()
    }

    fn wants_snapshot(&mut self) -> bool {
        match &self.keeping {
            Keeping::OnDisk(kept) => kept.is_due(self.measures.last_time),
            _ => false,
        }
    }

    fn wants_last_snapshot(&mut self) -> bool {
        matches!(&self.keeping, Keeping::OnDisk(kept) if kept.is_worth_a_last())
    }

    fn snapshot(&mut self, snapshot: &Snapshot) {
        // what could not be recorded is not to be gone on from
        if let (Keeping::OnDisk(kept), None) = (&mut self.keeping, &self.error) {
            let written = kept.write_checkpoint(snapshot, &self.measures);
            self.remember(written);
        }
    }
}

impl Recorder<'_> {
    /// Keeps the first error, to be told at the end; the run stops at this record.
    fn remember(&mut self, result: Result<(), ResultError>) {
        if let Err(error) = result {
            self.error.get_or_insert(error);
        }
    }
}

/// What stays the same in every frame of the fields.
fn topology(system: &System, landmarks: &Landmarks) -> FieldsTopology {
    let labels = landmarks.points.iter().filter(|p| p.nodes.len() == 1).map(|p| (p.nodes[0] as u32, p.name.clone()));
    let triangles = landmarks.canopies.iter().flat_map(|canopy| &canopy.triangles);
    let class_of = |group: usize| landmarks.groups[group].class as u32;
    FieldsTopology {
        nodes: system.mass().len(),
        segments: system.segments().iter().map(|s| s.ends.map(|n| n as u32)).collect(),
        classes: system.segments().iter().map(|segment| class_of(segment.group)).collect(),
        triangles: triangles.map(|nodes| nodes.map(|node| node as u32)).collect(),
        class_names: landmarks.classes.iter().map(|class| class.name.clone()).collect(),
        labels: labels.collect(),
        bodies: system.bodies().iter().map(|body| body.centre as u32).collect(),
    }
}

impl Kept {
    fn new(folder: &Path, stream: Stream, checkpoints: Checkpoints, time: f64) -> Self {
        let last = (time, checkpoints.clock);
        Self { stream, checkpoints, checkpoint: folder.join(folder::CHECKPOINT), last }
    }

    /// Whether it is time for another checkpoint.
    fn is_due(&self, time: f64) -> bool {
        match self.checkpoints.every {
            CheckpointEvery::Never => false,
            // records fall on it only to rounding
            CheckpointEvery::Simulated(every) => time - self.last.0 >= every * (1.0 - 1e-9),
            CheckpointEvery::Clock(every) => self.last.1.elapsed() >= every,
        }
    }

    /// Whether the end of the run is worth a checkpoint: what follows it, fields, summary, report, takes time as well and
    /// can fail, and the run shall not be computed again for it.
    fn is_worth_a_last(&self) -> bool {
        match self.checkpoints.every {
            CheckpointEvery::Never => false,
            CheckpointEvery::Simulated(_) => true,
            CheckpointEvery::Clock(_) => self.last.1.elapsed() >= WORTH_A_LAST,
        }
    }

    fn write_checkpoint(&mut self, snapshot: &Snapshot, measures: &Measures) -> Result<(), ResultError> {
        let Checkpoints { every: _, input_hash, wall_time_before, clock, second_run } = &self.checkpoints;
        let checkpoint = Checkpoint {
            time_s: measures.last_time,
            wall_time_s: (*wall_time_before + clock.elapsed()).as_secs_f64(),
            snapshot: Cow::Borrowed(snapshot),
            measures: Cow::Borrowed(measures),
            // the files reach the disk before the checkpoint that counts on them
            written: self.stream.sync()?,
            second_run: second_run.clone(),
        };
        checkpoint.write(&self.checkpoint, input_hash)?;
        self.last = (measures.last_time, Instant::now());
        Ok(())
    }
}

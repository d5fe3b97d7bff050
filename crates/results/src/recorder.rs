//! The observer that turns a run into results: measures at every step, rows and frames at record times. Rows and frames
//! go to the disk as they come; the measures are few, and are kept in checkpoints.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::forces::membrane::Membrane;
use netcast_dynamics::limits::Limits;
use netcast_dynamics::simulate::{Frame, Live, Observer, Outcome};
use netcast_dynamics::snapshot::Snapshot;
use netcast_dynamics::state::State;
use netcast_dynamics::system::System;
use serde::{Deserialize, Serialize};

use crate::checkpoint::{Checkpoint, CheckpointEvery};
use crate::cloth::ClothMeasures;
use crate::landmarks::Landmarks;
use crate::measures::{Measures, mean};
use crate::moments::{Moment, MomentMeasures};
use crate::stream::Stream;
use crate::summary::{Cloth, Energy, Flight, Mouth, Opening, PointExtremes, Posture, Target, Tension};
use crate::utilisation::RopeMeasures;
use crate::{FieldsTopology, ResultError, folder, history};

/// What is told of a run's progress at every record time: (time reached, s).
pub type Progress<'p> = dyn FnMut(f64) + Send + 'p;

/// Records a run.
pub struct Recorder<'r> {
    landmarks: Landmarks,
    /// Mass of each node, kg; zero for tractors.
    web_mass: Vec<f64>,
    /// The class of each segment in the system.
    groups: Vec<usize>,
    membranes: Vec<Membrane>,
    /// The channels of the energy balance that are listed.
    channels: Vec<Channel>,
    fields_every: u64,
    columns: Vec<String>,
    topology: FieldsTopology,
    measured: Measured,
    kept: Option<Kept>,
    progress: &'r mut Progress<'r>,
    interrupted: &'r (dyn Fn() -> bool + Sync),
    limits: Limits,
    error: Option<ResultError>,
}

/// All that has been measured of a run so far: what a later record or the end of the run depends on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    at_steps: Measures,
    at_records: MomentMeasures,
    ropes: RopeMeasures,
    cloth: ClothMeasures,
    rows: u64,
    last_time: f64,
    last_residual: f64,
}

/// How a run is checkpointed.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoints {
    /// How often.
    pub every: CheckpointEvery,
    /// What the inputs are known by; see [`crate::manifest::hash_inputs`].
    pub input_hash: String,
    /// Time on the clock that the run had taken before this program took it over.
    pub wall_time_before: Duration,
    /// When this program took it over.
    pub clock: Instant,
}

/// What of a run is on the disk while it goes on.
struct Kept {
    stream: Stream,
    checkpoints: Checkpoints,
    checkpoint: PathBuf,
    /// Time simulated, s, and time on the clock at the last checkpoint.
    last: (f64, Instant),
}

/// What a run comes to.
pub struct Recording {
    /// How far the web opened.
    pub opening: Opening,
    /// Extremes of the landmarks.
    pub points: std::collections::BTreeMap<String, Option<PointExtremes>>,
    /// Tensions.
    pub tension: Tension,
    /// Concave and convex.
    pub posture: Posture,
    /// How the mouth stands.
    pub mouth: Mouth,
    /// How much of the target is covered.
    pub target: Option<Target>,
    /// How long the web hangs about its apex.
    pub flight: Flight,
    /// What sheets bear.
    pub cloth: Option<Cloth>,
    /// The energy balance.
    pub energy: Energy,
}

impl<'r> Recorder<'r> {
    /// A recorder of `system` from `state` on, that measures. With [`Recorder::keep_in`] it writes as well, fields at
    /// every `fields_every`-th record. `progress` hears of every record; the run stops at the next one once
    /// `interrupted` says so.
    ///
    /// # Errors
    /// [`ResultError::Length`] where `landmarks` do not fit the system.
    pub fn new(
        system: &System,
        state: &State,
        landmarks: Landmarks,
        fields_every: u64,
        progress: &'r mut Progress<'r>,
        interrupted: &'r (dyn Fn() -> bool + Sync),
    ) -> Result<Recorder<'r>, ResultError> {
        ResultError::length("groups of segments", system.class_count(), landmarks.groups.len())?;
        let groups: Vec<usize> = system.segments().iter().map(|s| s.class).collect();
        let point_names: Vec<&str> = landmarks.points.iter().map(|p| &p.name[..]).collect();
        let class_names: Vec<&str> = landmarks.classes.iter().map(|c| &c.name[..]).collect();
        let listed: Vec<Channel> = system.channels().collect();
        let channels: Vec<&str> = listed.iter().map(|channel| channel.name()).chain(["residual"]).collect();
        let labels =
            landmarks.points.iter().filter(|p| p.nodes.len() == 1).map(|p| (p.nodes[0] as u32, p.name.clone()));
        let triangles = landmarks.canopies.iter().flat_map(|canopy| &canopy.triangles);
        let topology = FieldsTopology {
            nodes: system.mass().len(),
            segments: system.segments().iter().map(|s| s.ends.map(|n| n as u32)).collect(),
            classes: groups.iter().map(|&group| landmarks.groups[group].class as u32).collect(),
            triangles: triangles.map(|nodes| nodes.map(|node| node as u32)).collect(),
            class_names: class_names.iter().map(|c| c.to_string()).collect(),
            labels: labels.collect(),
            bodies: system.bodies().iter().map(|body| body.centre as u32).collect(),
        };
        let of_web = system.mass().iter().zip(system.tractor());
        let web_mass: Vec<f64> = of_web.map(|(&mass, &tractor)| if tractor { 0.0 } else { mass }).collect();
        let measured = Measured {
            at_steps: Measures::new(&landmarks, &state.position, &state.position),
            at_records: MomentMeasures::new(&web_mass, &state.position),
            ropes: RopeMeasures::new(landmarks.ropes.len()),
            cloth: ClothMeasures::default(),
            rows: 0,
            last_time: 0.0,
            last_residual: 0.0,
        };
        Ok(Recorder {
            columns: history::columns(&point_names, &class_names, &channels),
            topology,
            measured,
            landmarks,
            web_mass,
            groups,
            membranes: system.membranes().to_vec(),
            channels: listed,
            fields_every,
            kept: None,
            progress,
            interrupted,
            limits: Limits::NONE,
            error: None,
        })
    }

    /// Counts travel from `reference` positions, m, (nodes,), in place of those of the `state` that it starts from.
    pub fn travelling_from(mut self, reference: &[DVec3], state: &State) -> Self {
        self.measured.at_steps = Measures::new(&self.landmarks, reference, &state.position);
        self.measured.at_records = MomentMeasures::new(&self.web_mass, reference);
        self
    }

    /// Holds the run to `limits`.
    pub fn hold_to(self, limits: Limits) -> Self {
        Self { limits, ..self }
    }

    /// Writes rows and frames into `folder` from the start of the run on, and checkpoints.
    ///
    /// # Errors
    /// [`ResultError`] names the file that cannot be written.
    pub fn keep_in(mut self, folder: &Path, checkpoints: Checkpoints) -> Result<Self, ResultError> {
        let stream = Stream::create(folder, &self.columns, &self.topology)?;
        self.kept = Some(Kept::new(folder, stream, checkpoints, 0.0));
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
        if !checkpoint.measured.fit(&self.landmarks) {
            return Err(ResultError::NotCheckpoint { path: folder.join(folder::CHECKPOINT) });
        }
        let stream = Stream::reopen(folder, checkpoint.written)?;
        self.measured = checkpoint.measured.clone().into_owned();
        self.kept = Some(Kept::new(folder, stream, checkpoints, checkpoint.time_s));
        Ok(self)
    }

    /// One row of the history, in the order of [`history::columns`].
    fn row(&self, frame: &Frame, moment: &Moment) -> Vec<Option<f64>> {
        let landmarks = &self.landmarks;
        let at = |node: usize| frame.position[node];
        let travel = |index: usize, place: DVec3| self.measured.at_steps.displacement(index, place).dot(landmarks.axis);
        let axis = landmarks.axis;
        let outline = landmarks.outline_area(at);
        let travel_of = |name: &str| {
            let index = landmarks.points.iter().position(|p| p.name == name)?;
            Some(travel(index, mean(&landmarks.points[index].nodes, at)))
        };
        let per_class = self.class_tensions(frame.tension);
        let rope_max = landmarks.classes.iter().zip(&per_class).filter(|(c, _)| c.is_rope).map(|(_, t)| t.1);

        let mut row = vec![
            Some(frame.time),
            outline.map(|s| s.dot(axis).abs()),
            outline.map(DVec3::length),
            landmarks.tractor_area(at),
            travel_of("centre"),
            travel_of("corner"),
            travel_of("tractor"),
            Some(rope_max.fold(0.0, f64::max)),
        ];
        for (index, point) in landmarks.points.iter().enumerate() {
            let place = mean(&point.nodes, at);
            row.extend([place.x, place.y, place.z].map(Some));
            // the mean travel of tractors and corners stands in the common columns already
            if !["tractor", "corner", "centre"].contains(&&point.name[..]) {
                row.push(Some(travel(index, place)));
            }
            row.push(Some(point.speed(|n| frame.velocity[n])));
            row.push(point.segments.iter().map(|&s| frame.tension[s]).reduce(f64::max));
        }
        row.extend(per_class.into_iter().flat_map(|(mean, max)| [Some(mean), Some(max)]));
        row.extend(self.channels.iter().map(|&channel| Some(frame.ledger[channel])));
        row.push(Some(frame.residual));
        row.extend(moment.row());
        // what overflows as a run diverges has no value
        row.into_iter().map(|cell| cell.filter(|value| value.is_finite())).collect()
    }

    /// (mean, largest) tension of each class, N, of the segments that are not gone.
    fn class_tensions(&self, tension: &[f64]) -> Vec<(f64, f64)> {
        let landmarks = &self.landmarks;
        let mut sums = vec![(0.0, 0.0, 0.0); landmarks.classes.len()];
        for (&tension, &group) in tension.iter().zip(&self.groups).filter(|(tension, _)| !tension.is_nan()) {
            let (sum, count, max) = &mut sums[landmarks.groups[group].class];
            (*sum, *count, *max) = (*sum + tension, *count + 1.0, f64::max(*max, tension));
        }
        sums.into_iter().map(|(sum, count, max)| (sum / f64::max(count, 1.0), max)).collect()
    }

    /// Writes down a record.
    fn keep(&mut self, frame: &Frame, row: &[Option<f64>]) -> Result<(), ResultError> {
        let Some(Kept { stream, .. }) = &mut self.kept else { return Ok(()) };
        stream.row(row)?;
        if self.measured.rows.is_multiple_of(self.fields_every) {
            let orientations = frame.rotation.iter().map(|rotation| rotation.orientation);
            stream.fields().push(frame.time, frame.position, frame.velocity, frame.tension, orientations)?;
        }
        stream.keep_up()
    }

    /// Ends the recording with how the run ended, and closes its files. `tolerance` is what the balance was asked to
    /// reach, closure and closure of the web.
    ///
    /// # Errors
    /// The first one that came up while recording.
    pub fn finish(self, outcome: &Outcome, tolerance: (f64, f64)) -> Result<Recording, ResultError> {
        if let Some(error) = self.error {
            return Err(error);
        }
        if let Some(kept) = self.kept {
            kept.stream.finish()?;
        }
        let landmarks = &self.landmarks;
        let Measured { at_steps, at_records, ropes, cloth, rows: _, last_time: _, last_residual } = self.measured;
        let by_rope = ropes.finish(landmarks, |rope| at_steps.largest_in_rope(landmarks, rope));
        let cloth = cloth.finish(&self.membranes, landmarks);
        let shadow = at_records.shadow_area();
        let (mouth, target, flight) = at_records.finish(landmarks);
        let (mut opening, points, mut tension, posture) = at_steps.finish(landmarks);
        (opening.shadow_area_max_m2, opening.shadow_area_max_time_s) = (shadow.value(), shadow.time());
        tension.by_rope = by_rope;
        let (ledger, balance) = (outcome.ledger, outcome.balance);
        let energy = Energy {
            initial_j: balance.initial(),
            final_j: ledger.stored(),
            closure: balance.closure(),
            closure_web: Some(balance.closure_web()),
            channels: self.channels.iter().map(|&channel| (channel.name().to_owned(), ledger[channel])).collect(),
            residual_j: last_residual,
            largest_residual_j: balance.largest_residual(),
            tolerance: tolerance.0,
            tolerance_web: tolerance.1,
        };
        Ok(Recording { opening, points, tension, posture, mouth, target, flight, cloth, energy })
    }
}

impl Observer for Recorder<'_> {
    fn step(&mut self, live: &Live) {
        self.measured.at_steps.step(&self.landmarks, live);
        self.measured.cloth.add(&self.membranes, live.position_time, |node| live.net.position(node));
    }

    fn record(&mut self, frame: &Frame) {
        let (landmarks, measured) = (&self.landmarks, &mut self.measured);
        let touches = frame.ledger[Channel::Ground] > 0.0;
        let moment = measured.at_records.add(landmarks, &self.web_mass, frame.time, frame.position, touches);
        measured.ropes.add(landmarks, frame.tension, &self.groups);
        let group_of = |segment: usize| self.groups[segment];
        measured.at_steps.ends(landmarks, frame.time, frame.velocity, frame.tension, &group_of);
        if self.kept.is_some() {
            let row = self.row(frame, &moment);
            let kept = self.keep(frame, &row);
            self.remember(kept);
        }
        self.measured.rows += 1;
        self.measured.last_time = frame.time;
        self.measured.last_residual = frame.residual;
        (self.progress)(frame.time);
    }

    fn limits(&self) -> Limits {
        self.limits
    }

    fn interrupted(&self) -> bool {
        self.error.is_some() || (self.interrupted)()
    }

    fn wants_snapshot(&mut self) -> bool {
        self.kept.as_ref().is_some_and(|kept| kept.is_due(self.measured.last_time))
    }

    fn snapshot(&mut self, snapshot: &Snapshot) {
        // what could not be recorded is not to be gone on from
        if let (Some(kept), None) = (&mut self.kept, &self.error) {
            let written = kept.write_checkpoint(snapshot, &self.measured);
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

impl Measured {
    /// Whether it is of a web with such landmarks.
    fn fit(&self, landmarks: &Landmarks) -> bool {
        self.at_steps.fit(landmarks) && self.ropes.fit(landmarks)
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

    fn write_checkpoint(&mut self, snapshot: &Snapshot, measured: &Measured) -> Result<(), ResultError> {
        let Checkpoints { every: _, input_hash, wall_time_before, clock } = &self.checkpoints;
        let checkpoint = Checkpoint {
            time_s: measured.last_time,
            wall_time_s: (*wall_time_before + clock.elapsed()).as_secs_f64(),
            snapshot: Cow::Borrowed(snapshot),
            measured: Cow::Borrowed(measured),
            // the files reach the disk before the checkpoint that counts on them
            written: self.stream.sync()?,
        };
        checkpoint.write(&self.checkpoint, input_hash)?;
        self.last = (measured.last_time, Instant::now());
        Ok(())
    }
}

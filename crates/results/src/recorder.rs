//! The observer that turns a run into results: measures at every step, rows and frames at record times.

use std::path::Path;

use glam::DVec3;
use netcast_dynamics::simulate::{Frame, Live, Observer, Outcome};
use netcast_dynamics::state::State;
use netcast_dynamics::system::System;

use crate::landmarks::Landmarks;
use crate::measures::{Measures, mean};
use crate::moments::{Moment, MomentMeasures};
use crate::summary::{Energy, Flight, Mouth, Opening, PointExtremes, Posture, Target, Tension};
use crate::utilisation::RopeMeasures;
use crate::{FieldsTopology, FieldsWriter, History, ResultError, folder, history};

/// What is told of a run's progress at every record time: (time reached, s).
pub type Progress<'p> = dyn FnMut(f64) + 'p;

/// Records a run.
pub struct Recorder<'r> {
    measures: Measures,
    history: History,
    fields: FieldsWriter,
    moments: MomentMeasures,
    ropes: RopeMeasures,
    groups: Vec<usize>,
    fields_every: u64,
    rows: u64,
    last_residual: f64,
    progress: &'r mut Progress<'r>,
    interrupted: &'r dyn Fn() -> bool,
    error: Option<ResultError>,
}

/// What a run comes to.
pub struct Recording {
    /// One row a record step.
    pub history: History,
    fields: FieldsWriter,
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
    /// The energy balance.
    pub energy: Energy,
}

impl<'r> Recorder<'r> {
    /// A recorder of `system` from `state` on. Fields are kept at every `fields_every`-th record.
    /// `progress` hears of every record; the run stops at the next one once `interrupted` says so.
    ///
    /// # Errors
    /// [`ResultError::Length`] where `landmarks` do not fit the system.
    pub fn new(
        system: &System,
        state: &State,
        landmarks: Landmarks,
        fields_every: u64,
        progress: &'r mut Progress<'r>,
        interrupted: &'r dyn Fn() -> bool,
    ) -> Result<Recorder<'r>, ResultError> {
        ResultError::length("groups of segments", system.class_count(), landmarks.groups.len())?;
        let groups: Vec<usize> = system.segments().iter().map(|s| s.class).collect();
        let point_names: Vec<&str> = landmarks.points.iter().map(|p| &p.name[..]).collect();
        let class_names: Vec<&str> = landmarks.classes.iter().map(|c| &c.name[..]).collect();
        let channels = netcast_dynamics::energy::Ledger::default().channels().map(|(name, _)| name);
        let channels: Vec<&str> = channels.into_iter().chain(["residual"]).collect();
        let labels =
            landmarks.points.iter().filter(|p| p.nodes.len() == 1).map(|p| (p.nodes[0] as u32, p.name.clone()));
        let topology = FieldsTopology {
            nodes: system.mass().len(),
            segments: system.segments().iter().map(|s| s.ends.map(|n| n as u32)).collect(),
            classes: groups.iter().map(|&group| landmarks.groups[group].class as u32).collect(),
            class_names: class_names.iter().map(|c| c.to_string()).collect(),
            labels: labels.collect(),
        };
        let of_web = system.mass().iter().zip(system.tractor());
        let web_mass = of_web.map(|(&mass, &tractor)| if tractor { 0.0 } else { mass }).collect();
        Ok(Recorder {
            history: History::new(history::columns(&point_names, &class_names, &channels)),
            fields: FieldsWriter::new(topology)?,
            moments: MomentMeasures::new(&landmarks, web_mass, &state.position),
            ropes: RopeMeasures::new(landmarks.ropes.len()),
            measures: Measures::new(landmarks, &state.position),
            groups,
            fields_every,
            rows: 0,
            last_residual: 0.0,
            progress,
            interrupted,
            error: None,
        })
    }

    /// One row of the history, in the order of [`history::columns`].
    fn row(&self, frame: &Frame, moment: &Moment) -> Vec<Option<f64>> {
        let landmarks = self.measures.landmarks();
        let at = |node: usize| frame.position[node];
        let axis = landmarks.axis;
        let outline = landmarks.outline_area(at);
        let travel_of = |name: &str| {
            let index = landmarks.points.iter().position(|p| p.name == name)?;
            Some(self.measures.travel(index, mean(&landmarks.points[index].nodes, at)))
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
                row.push(Some(self.measures.travel(index, place)));
            }
            row.push(Some(point.speed(|n| frame.velocity[n])));
            row.push(point.segments.iter().map(|&s| frame.tension[s]).reduce(f64::max));
        }
        row.extend(per_class.into_iter().flat_map(|(mean, max)| [Some(mean), Some(max)]));
        row.extend(frame.ledger.channels().map(|(_, energy)| Some(energy)));
        row.push(Some(frame.residual));
        row.extend(moment.row());
        // what overflows as a run diverges has no value
        row.into_iter().map(|cell| cell.filter(|value| value.is_finite())).collect()
    }

    /// (mean, largest) tension of each class, N.
    fn class_tensions(&self, tension: &[f64]) -> Vec<(f64, f64)> {
        let landmarks = self.measures.landmarks();
        let mut sums = vec![(0.0, 0.0, 0.0); landmarks.classes.len()];
        for (&tension, &group) in tension.iter().zip(&self.groups) {
            let (sum, count, max) = &mut sums[landmarks.groups[group].class];
            (*sum, *count, *max) = (*sum + tension, *count + 1.0, f64::max(*max, tension));
        }
        sums.into_iter().map(|(sum, count, max)| (sum / f64::max(count, 1.0), max)).collect()
    }

    /// Ends the recording with how the run ended. `tolerance` is what the balance was asked to reach, closure and
    /// closure of the web.
    ///
    /// # Errors
    /// The first one that came up while recording.
    pub fn finish(self, outcome: &Outcome, tolerance: (f64, f64)) -> Result<Recording, ResultError> {
        if let Some(error) = self.error {
            return Err(error);
        }
        let landmarks = self.measures.landmarks();
        let by_rope = self.ropes.finish(landmarks, |rope| self.measures.largest_in_rope(rope));
        let shadow = self.moments.shadow_area();
        let (mouth, target, flight) = self.moments.finish(landmarks);
        let (mut opening, points, mut tension, posture) = self.measures.finish();
        (opening.shadow_area_max_m2, opening.shadow_area_max_time_s) = (shadow.value(), shadow.time());
        tension.by_rope = by_rope;
        let (ledger, balance) = (outcome.ledger, outcome.balance);
        let stored = ledger.kinetic + ledger.elastic + ledger.gravity;
        let energy = Energy {
            initial_j: balance.initial(),
            final_j: stored,
            closure: balance.closure(),
            closure_web: Some(balance.closure_web()),
            channels: ledger.channels().into_iter().map(|(name, energy)| (name.to_owned(), energy)).collect(),
            residual_j: self.last_residual,
            largest_residual_j: balance.largest_residual(),
            tolerance: tolerance.0,
            tolerance_web: tolerance.1,
        };
        let (history, fields) = (self.history, self.fields);
        Ok(Recording { history, fields, opening, points, tension, posture, mouth, target, flight, energy })
    }
}

impl Observer for Recorder<'_> {
    fn step(&mut self, live: &Live) {
        self.measures.step(live);
    }

    fn record(&mut self, frame: &Frame) {
        let landmarks = self.measures.landmarks();
        let moment = self.moments.add(landmarks, frame.time, frame.position);
        self.ropes.add(landmarks, frame.tension, &self.groups);
        self.measures.ends(frame.time, frame.velocity, frame.tension, &|segment| self.groups[segment]);
        let row = self.row(frame, &moment);
        let mut recorded = self.history.push(row);
        if self.rows.is_multiple_of(self.fields_every) {
            recorded =
                recorded.and_then(|()| self.fields.push(frame.time, frame.position, frame.velocity, frame.tension));
        }
        self.rows += 1;
        self.last_residual = frame.residual;
        if let Err(error) = recorded {
            self.error.get_or_insert(error);
        }
        (self.progress)(frame.time);
    }

    fn interrupted(&self) -> bool {
        self.error.is_some() || (self.interrupted)()
    }
}

impl Recording {
    /// Writes history and fields into `to`.
    ///
    /// # Errors
    /// [`ResultError`] where a file cannot be written.
    pub fn write(self, to: &Path) -> Result<(), ResultError> {
        self.history.write(&to.join(folder::HISTORY))?;
        self.fields.finish(&to.join(folder::FIELDS))
    }
}

//! The cost of a run of a case: steps, memory, time on this machine.

use std::time::{Duration, Instant};

use netcast_dynamics::time::step::Stepper;
use netcast_model::Model;
use serde::Serialize;

use crate::case::Case;

/// The search for the equilibrium of a case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Equilibrium {
    /// Largest number of iterations.
    pub max_iterations: u32,
    /// Largest unbalanced force that is accepted, over the largest tension, bending force or load.
    pub tolerance: f64,
    /// Number of nodes.
    pub nodes: usize,
    /// Number of segments.
    pub segments: usize,
}

/// The cost of a run in time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cost {
    /// Number of nodes.
    pub nodes: usize,
    /// Number of segments.
    pub segments: usize,
    /// Numbers of other elements and of rigid bodies, without those that are 0.
    pub elements: Vec<Count>,
    /// Step, s.
    pub dt_s: f64,
    /// The largest stable step, s.
    pub stable_dt_s: f64,
    /// Largest step that a run takes, over the stable step.
    pub step_fraction: f64,
    /// The part that bounds the stable step; none where it is unbounded.
    pub limited_by: Option<String>,
    /// A change of the scenario that allows a larger step; none where the step is unbounded.
    pub lifted_by: Option<String>,
    /// Number of steps.
    pub steps: u64,
    /// Simulated time, s.
    pub duration_s: f64,
    /// Number of segments times number of steps.
    pub segment_updates: f64,
    /// Number of rows of the history.
    pub records: u64,
    /// Size of the frames of all records, bytes.
    pub frames_bytes: f64,
    /// Time of the run on one core of this machine, s; none until [`Cost::with_step_time`] sets it.
    pub one_core_s: Option<f64>,
}

/// The number of parts of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Count {
    /// The kind.
    pub kind: String,
    /// The number of parts.
    pub count: usize,
}

/// The equilibrium that a scenario asks for; none where it asks for none.
pub(super) fn equilibrium(model: &Model) -> Option<Equilibrium> {
    let wanted = model.scenario.solve.statics?;
    Some(Equilibrium {
        max_iterations: wanted.max_iterations.get(),
        tolerance: wanted.tolerance.si(),
        nodes: model.system.mass().len(),
        segments: model.system.segments().len(),
    })
}

/// The cost of the run in time; none where the scenario asks for an equilibrium alone.
pub(super) fn cost(case: &Case) -> Option<Cost> {
    let (model, schedule) = (case.model(), case.schedule());
    if model.scenario.solve.statics.is_some() && model.scenario.solve.run_time().is_none() {
        return None;
    }
    let (nodes, segments) = (model.system.mass().len(), model.system.segments().len());
    let elements = [
        ("bends", model.system.parts().bends.len()),
        ("triangles", model.system.membranes().len()),
        ("hinges", model.system.parts().hinges.len()),
        ("rigid bodies", model.system.bodies().len()),
    ];
    let records = schedule.record_count();
    let frame = (nodes * 6 + segments + model.system.membranes().len()) * size_of::<f64>();
    Some(Cost {
        nodes,
        segments,
        elements: elements
            .into_iter()
            .filter(|(_, count)| *count > 0)
            .map(|(kind, count)| Count { kind: kind.to_owned(), count })
            .collect(),
        dt_s: schedule.dt,
        stable_dt_s: model.limit.dt,
        step_fraction: model.largest_dt() / model.limit.dt,
        limited_by: model.limited_by(),
        lifted_by: model.step_lift(),
        steps: schedule.count,
        duration_s: schedule.time(schedule.count),
        segment_updates: schedule.count as f64 * segments as f64,
        records,
        frames_bytes: records as f64 * frame as f64,
        one_core_s: None,
    })
}

impl Cost {
    /// Sets the time of the run on one core from the time of a step, s.
    pub fn with_step_time(self, step_time_s: f64) -> Self {
        Self { one_core_s: Some(self.steps as f64 * step_time_s), ..self }
    }
}

impl Case {
    /// The time of the whole run in time on one core of this machine, s, from the time of a step; none where there is no run
    /// in time.
    pub fn expected_time_s(&self) -> Option<f64> {
        let is_at_rest = self.model().scenario.solve.run_time().is_none();
        (!is_at_rest).then(|| self.schedule().count as f64 * self.step_time_s())
    }

    /// Measures the time of a step on one core of this machine, s, as the mean of 200 steps or of those within 50 ms.
    pub fn step_time_s(&self) -> f64 {
        const MEASURED_MAX: Duration = Duration::from_millis(50);
        let model = self.model();
        let mut net = Stepper::new(&model.system, &model.state, self.schedule().dt, 1);
        let (clock, mut steps) = (Instant::now(), 0);
        while steps < 200 && clock.elapsed() < MEASURED_MAX {
            net.step();
            steps += 1;
        }
        clock.elapsed().as_secs_f64() / f64::from(steps)
    }
}

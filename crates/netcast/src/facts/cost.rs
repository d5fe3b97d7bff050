//! What a run of a case costs: steps, memory, time on this machine.

use std::time::{Duration, Instant};

use netcast_dynamics::time::step::Stepper;
use netcast_model::Model;
use serde::Serialize;

use crate::case::Case;

/// The equilibrium that a case asks for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Equilibrium {
    /// Iterations after which it is given up.
    pub max_iterations: u32,
    /// Largest force out of balance, over the largest tension or load.
    pub tolerance: f64,
    /// Nodes.
    pub nodes: usize,
    /// Segments.
    pub segments: usize,
}

/// What a run in time costs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cost {
    /// Nodes.
    pub nodes: usize,
    /// Segments.
    pub segments: usize,
    /// Elements beside segments, and rigid bodies; kinds that there are none of are left out.
    pub elements: Vec<Count>,
    /// Step, s.
    pub dt_s: f64,
    /// The largest stable step, s.
    pub stable_dt_s: f64,
    /// The largest share of it that is wanted.
    pub step_fraction: f64,
    /// What sets the stable step; none where nothing bounds it.
    pub limited_by: Option<String>,
    /// What would allow a larger step; none where nothing bounds it.
    pub lifted_by: Option<String>,
    /// Steps.
    pub steps: u64,
    /// Time simulated, s.
    pub duration_s: f64,
    /// Segments times steps.
    pub segment_updates: f64,
    /// Rows of the history.
    pub records: u64,
    /// What the frames of all records take, bytes.
    pub frames_bytes: f64,
    /// Time of the run on one core of this machine, s; none before [`Case::step_time_s`] measures a step.
    pub one_core_s: Option<f64>,
}

/// Parts of one kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Count {
    /// What they are.
    pub kind: String,
    /// How many.
    pub count: usize,
}

pub(super) fn equilibrium(model: &Model) -> Option<Equilibrium> {
    let wanted = model.scenario.solve.statics?;
    Some(Equilibrium {
        max_iterations: wanted.max_iterations.get(),
        tolerance: wanted.tolerance.si(),
        nodes: model.system.mass().len(),
        segments: model.system.segments().len(),
    })
}

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
    let records = schedule.count / schedule.steps_per_record + 1;
    let frame = (nodes * 6 + segments + model.system.membranes().len()) * size_of::<f64>();
    Some(Cost {
        nodes,
        segments,
        elements: elements.into_iter().filter(|(_, count)| *count > 0).map(Count::new).collect(),
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

impl Count {
    fn new((kind, count): (&str, usize)) -> Self {
        Self { kind: kind.to_owned(), count }
    }
}

impl Cost {
    /// The same with the time of the run on one core, where a step takes `step_time_s`.
    pub fn with_step_time(self, step_time_s: f64) -> Self {
        Self { one_core_s: Some(self.steps as f64 * step_time_s), ..self }
    }
}

impl Case {
    /// Time of a step on one core of this machine, s, from as many steps as fit into a moment.
    pub fn step_time_s(&self) -> f64 {
        const MOMENT: Duration = Duration::from_millis(50);
        let model = self.model();
        let mut net = Stepper::new(&model.system, &model.state, self.schedule().dt, 1);
        let (clock, mut steps) = (Instant::now(), 0);
        while steps < 200 && clock.elapsed() < MOMENT {
            net.step();
            steps += 1;
        }
        clock.elapsed().as_secs_f64() / f64::from(steps)
    }
}

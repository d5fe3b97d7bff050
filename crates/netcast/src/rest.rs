//! Finds the equilibrium that a scenario asks for, alone or as the start of a run.

use netcast_dynamics::state::State;
use netcast_dynamics::statics::{Accuracy, Relaxed, Relaxing, StaticsError, relax};
use netcast_model::Model;
use netcast_results::summary::Equilibrium;

use crate::progress::{Interrupted, Progress, Tell};

/// The equilibrium, or the best state of a search that failed.
pub(crate) struct Rest {
    relaxed: Relaxed,
    tolerance: f64,
}

/// Searches for the equilibrium of a model; none where its scenario asks for none.
pub(crate) fn equilibrium(
    model: &Model,
    threads: usize,
    progress: &mut Tell,
    interrupted: &Interrupted,
) -> Option<Rest> {
    let wanted = model.scenario.solve.statics?;
    let tolerance = wanted.tolerance.si();
    let accuracy = Accuracy { tolerance, max_iterations: wanted.max_iterations.get().into() };
    let mut tell = |Relaxing { iterations, residual }: Relaxing| {
        progress(Progress::Relaxing { iterations, residual: residual.relative(), tolerance });
        !interrupted()
    };
    let relaxed = relax(&model.system, &model.state, &accuracy, threads, &mut tell);
    Some(Rest { relaxed, tolerance })
}

impl Rest {
    /// Whether the residual is within the tolerance.
    pub fn is_found(&self) -> bool {
        self.relaxed.stopped.is_none()
    }

    /// The state that the run starts from. Where a run in time follows, it has the velocities of the launch.
    pub fn start(&self, model: &Model) -> State {
        let mut state = self.relaxed.state.clone();
        if model.scenario.solve.run_time().is_some() {
            state.velocity.clone_from(&model.state.velocity);
            for (rotation, thrown) in state.rotation.iter_mut().zip(&model.state.rotation) {
                rotation.angular_momentum = thrown.angular_momentum;
            }
        }
        state
    }

    /// The reason that no equilibrium was found, in words; none where one was.
    pub fn failure(&self, model: &Model) -> Option<String> {
        let (error, residual) = (self.relaxed.stopped?, &self.relaxed.residual);
        let place = model.node_label(residual.node);
        Some(match error {
            StaticsError::NotConverged { .. } => format!(
                "{error}: {place} is out of balance by {:.3e} N, {:.1e} of the largest tension, bending force \
                 or load where {:.1e} is asked for; allow more by solve.static.max_iterations, or ask for less by solve.static.tolerance",
                residual.force,
                residual.relative(),
                self.tolerance
            ),
            StaticsError::NotFinite { .. } => format!("{error}, at {place}"),
            StaticsError::Interrupted { .. } => error.to_string(),
        })
    }

    /// The section of the summary on the equilibrium.
    pub fn summary(&self, model: &Model) -> Equilibrium {
        let Relaxed { residual, iterations, .. } = &self.relaxed;
        let is_finite = residual.force.is_finite();
        Equilibrium {
            residual_n: is_finite.then_some(residual.force),
            residual_relative: Some(residual.relative()).filter(|relative| relative.is_finite()),
            residual_where: is_finite.then(|| model.node_label(residual.node)),
            tolerance: self.tolerance,
            iterations: *iterations,
            then_run: model.scenario.solve.run_time().is_some(),
        }
    }
}

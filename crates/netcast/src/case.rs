//! A case: a scenario that was read, checked and turned into a model, ready to be simulated.

use std::fmt;
use std::path::Path;
use std::sync::Arc;

use netcast_dynamics::custom::CustomEffect;
use netcast_dynamics::simulate::Schedule;
use netcast_dynamics::step_size::step_limit;
use netcast_dynamics::system::SystemError;
use netcast_model::Model;
use netcast_results::{Clash, Landmarks, clashes};
use netcast_scenario::quantity::Number;
use netcast_scenario::{Diagnostic, Diagnostics, Document, Scenario, Source, resolved_toml};

use crate::inputs::Inputs;
use crate::landmarks::landmarks;

/// What its scenario is called in messages where it was no file.
pub(crate) const IN_CODE: &str = "case.toml";

/// A net, its launch and what surrounds it, ready to be simulated. A clone shares everything with the original.
#[derive(Clone)]
pub struct Case(Arc<Prepared>);

struct Prepared {
    document: Document,
    model: Model,
    inputs: Inputs,
    schedule: Schedule,
    landmarks: Landmarks,
}

impl Case {
    /// Reads the scenario in `file` and the files it names. Each override is `path=value`, as after `--set`.
    ///
    /// # Errors
    /// Everything that is wrong with them, at once, each with its place in the file.
    pub fn read(file: impl AsRef<Path>, overrides: &[String]) -> Result<Self, Diagnostics> {
        Self::of(Document::read(file.as_ref(), overrides)?)
    }

    /// The case of a scenario as a value; relative paths in it start from `folder`.
    ///
    /// # Errors
    /// Everything that does not fit; places are those in the text of the resolved scenario.
    pub fn from_scenario(scenario: &Scenario, folder: impl AsRef<Path>) -> Result<Self, Diagnostics> {
        let source = Source { name: IN_CODE.to_owned(), text: resolved_toml(scenario) };
        Self::of(Document::parse(source, folder.as_ref(), &[])?)
    }

    /// The case of a scenario that was read.
    ///
    /// # Errors
    /// Everything that does not fit, each with its place in the file.
    pub fn of(document: Document) -> Result<Self, Diagnostics> {
        let model = Model::new(&document)?;
        let inputs = Inputs::new(&document, &model).map_err(|error| Diagnostic::new("", error.to_string(), None))?;
        let (schedule, landmarks) = (schedule(&model), landmarks(&model));
        let clashes = clashes(&landmarks).into_iter().map(|clash| clash_in_words(&document, clash));
        Diagnostics::fail_if_any(clashes.collect())?;
        Ok(Self(Arc::new(Prepared { document, model, inputs, schedule, landmarks })))
    }

    /// The same case with a force of the caller's own; see [`CustomEffect`]. The step is bounded by it as well. It is no part
    /// of the inputs that a result folder keeps: a run of those is a run without it.
    ///
    /// # Errors
    /// [`SystemError`] where it names a node that the net does not have.
    pub fn with_effect(&self, effect: impl CustomEffect + 'static) -> Result<Self, SystemError> {
        let Prepared { document, model, inputs, .. } = &*self.0;
        let mut model = model.clone();
        let mut parts = model.system.parts().clone();
        parts.custom.push(Box::new(effect));
        model.system = parts.build()?;
        model.limit = step_limit(&model.system);
        let (schedule, landmarks) = (schedule(&model), landmarks(&model));
        let (document, inputs) = (document.clone(), inputs.clone());
        Ok(Self(Arc::new(Prepared { document, model, inputs, schedule, landmarks })))
    }

    /// The same case with steps of this share of the stable one.
    pub(crate) fn with_step_fraction(&self, step_fraction: f64) -> Self {
        let Prepared { document, model, inputs, landmarks, .. } = &*self.0;
        let mut model = model.clone();
        model.scenario.solve.step_fraction = Some(Number::constant(step_fraction));
        let schedule = schedule(&model);
        let (document, inputs, landmarks) = (document.clone(), inputs.clone(), landmarks.clone());
        Self(Arc::new(Prepared { document, model, inputs, schedule, landmarks }))
    }

    /// Whether netcast chose the step, and not the scenario.
    pub(crate) fn has_chosen_step(&self) -> bool {
        self.0.document.scenario.solve.step_fraction.is_none()
    }

    /// The scenario, with everything written out that was chosen on the way.
    pub fn scenario(&self) -> &Scenario {
        &self.0.model.scenario
    }

    /// The scenario as it was written.
    pub fn document(&self) -> &Document {
        &self.0.document
    }

    /// What is simulated, with the names of its parts.
    pub fn model(&self) -> &Model {
        &self.0.model
    }

    /// When steps and records happen.
    pub fn schedule(&self) -> &Schedule {
        &self.0.schedule
    }

    /// What of the nodes and segments has a meaning.
    pub fn landmarks(&self) -> &Landmarks {
        &self.0.landmarks
    }

    /// The files of the `inputs` folder.
    pub(crate) fn inputs(&self) -> &Inputs {
        &self.0.inputs
    }
}

impl fmt::Debug for Case {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Case").field("scenario", self.scenario()).finish_non_exhaustive()
    }
}

/// That a name makes a column of the history that is there already, at the name.
fn clash_in_words(document: &Document, Clash { column, name, other }: Clash) -> Diagnostic {
    let points = &document.scenario.points;
    let named = [Some(&name), other.as_ref()].into_iter().flatten().find(|name| points.contains_key(*name));
    let path = named.map_or("web".to_owned(), |point| format!("points.{point}"));
    let by = other.map_or("of every run".to_owned(), |other| format!("of {other:?}"));
    let message = format!("the name {name:?} makes a column `{column}` of the history, which is one {by}");
    document.diagnostic(&path, message).with_help("choose another name")
}

/// When a model's steps and records happen.
fn schedule(model: &Model) -> Schedule {
    let every = model.scenario.record.every.si();
    match model.scenario.solve.run_time() {
        Some(duration) => Schedule::new(duration, every, model.largest_dt()),
        None => Schedule::at_start(every, model.largest_dt()),
    }
}

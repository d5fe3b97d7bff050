//! Whether a run failed, why, and what mends it.

use netcast_dynamics::forces::law::Law;
use netcast_dynamics::limits::{Excess, Term};
use netcast_dynamics::simulate::{PlaceInNet, StepError};
use netcast_model::Model;
use netcast_results::SecondRun;
use netcast_scenario::OnEnergyError;

use crate::case::Case;
use crate::simulate::Ended;

/// Why a run failed although its input was right.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Failure {
    /// It stopped before its end.
    #[error("{0}")]
    Stopped(String),
    /// Its energy balance misses the tolerance, at the end or by far on the way.
    #[error(
        "the energy balance misses its tolerance: {what} is {found} %, at most {asked} % is allowed{since}; \
         a smaller step mends it, try --set solve.step_fraction={smaller}",
        found = percent(*found), asked = percent(*asked)
    )]
    Unbalanced {
        /// Which measure.
        what: &'static str,
        /// Its value, percent.
        found: f64,
        /// What the scenario asks for, percent.
        asked: f64,
        /// When it missed it by far and what pulled hardest there and then, for the message; empty where it did not.
        since: String,
        /// A step fraction that should do.
        smaller: f64,
    },
    /// A segment is thrown about by much of its length in one step.
    #[error(
        "step {step} at {time} s: the step does not resolve the motion: {place} changes its length by {found:.0} % in \
         one step, at most {asked:.0} % is allowed; try --set solve.step_fraction={smaller}"
    )]
    Unresolved {
        /// Which step.
        step: u64,
        /// At what time, s.
        time: f64,
        /// Which segment.
        place: String,
        /// The change, percent.
        found: f64,
        /// The most that is allowed, percent.
        asked: f64,
        /// A step fraction that should do.
        smaller: f64,
    },
}

impl Ended<'_> {
    /// Why it failed, if it did, and what the reader should know; first that it is a second run, where it is.
    pub fn verdict(&self, second: Option<&SecondRun>) -> (Option<Failure>, Vec<String>) {
        let (stopped, solve) = (&self.outcome.stopped, &self.model.scenario.solve);
        let unrest = self.rest.as_ref().and_then(|rest| rest.failure(self.model)).map(Failure::Stopped);
        // a run that diverged says so, and what mends it
        let missed = if self.diverged() { None } else { self.unresolved().or_else(|| self.unbalanced()) };
        let stopped = stopped.as_ref().filter(|error| !matches!(error, StepError::Exceeded(_)));
        let stopped = unrest.or(stopped.map(|error| Failure::Stopped(in_words(self.model, error))));
        let mut warnings: Vec<String> = second.map(|second| second.why.clone()).into_iter().collect();
        warnings.extend(self.model.notes.iter().cloned());
        warnings.extend(self.beyond_tables());
        warnings.extend(stopped.iter().chain(&missed).map(Failure::to_string));
        (stopped.or(missed.filter(|_| solve.on_energy_error == OnEnergyError::Stop)), warnings)
    }

    /// That ropes were stretched beyond the last rows of their tables.
    fn beyond_tables(&self) -> impl Iterator<Item = String> {
        self.measured.tension.by_rope.iter().filter_map(|(name, used)| {
            let law = self.model.groups.iter().find(|group| group.rope.as_ref() == Some(name)).map(|group| &group.law);
            let (Some(Law::Tabulated(law)), Some(strain)) = (law, used.strain_max) else { return None };
            let (last, time) = (law.last_strain(), used.strain_max_time_s?);
            (strain > last).then(|| {
                format!(
                    "rope `{name}` was strained by {:.3} % at {time:.6} s, in {} ropes; the last row of its table has {:.3} %: \
                     law.table.beyond says what happens there",
                    100.0 * strain,
                    used.strain_max_where.as_deref().unwrap_or_default(),
                    100.0 * last
                )
            })
        })
    }

    /// That the step does not resolve the motion.
    fn unresolved(&self) -> Option<Failure> {
        let Excess { term, found, allowed, step, time, segment } = self.outcome.exceeded?;
        let place = self.model.segment_label(segment.filter(|_| term == Term::Sweep)?);
        let smaller = sensible(0.5 * self.fraction() * allowed / found);
        Some(Failure::Unresolved { step, time, place, found: 100.0 * found, asked: 100.0 * allowed, smaller })
    }

    /// The first tolerance that the balance misses.
    fn unbalanced(&self) -> Option<Failure> {
        let energy = &self.measured.energy;
        let measures = [
            ("the residual over the largest total energy", Some(energy.closure), energy.tolerance),
            ("the residual over the web's largest energy", energy.closure_web, energy.tolerance_web),
        ];
        let missed = |found: Option<f64>, asked: f64| found.filter(|found| *found > asked);
        let (what, found, asked) =
            measures.into_iter().find_map(|(what, found, asked)| Some((what, missed(found, asked)?, asked)))?;
        let since = self.outcome.exceeded.map_or(String::new(), |excess| {
            let hardest = excess.segment.map(|s| format!(", where {} pulls hardest", self.model.segment_label(s)));
            format!(
                ", and twice that was missed at step {} at {} s{}",
                excess.step,
                excess.time,
                hardest.unwrap_or_default()
            )
        });
        // the residual falls with the third power of the step or so; the second is on the safe side. One that was
        // missed on the way would have grown, at least in proportion to time
        let at_the_end = found * self.schedule.end / self.outcome.end_time;
        let margin = if self.outcome.exceeded.is_some() { 0.4 } else { 0.9 };
        let smaller = sensible(margin * self.fraction() * (asked / at_the_end).sqrt());
        Some(Failure::Unbalanced { what, found: 100.0 * found, asked: 100.0 * asked, since, smaller })
    }

    /// How the case is run once more: at a smaller step, where this one was chosen by netcast and missed a tolerance that
    /// stops a run. `is_first` says whether this was the first run.
    pub fn second_run(&self, case: &Case, is_first: bool) -> Option<SecondRun> {
        let is_stopped = matches!(self.outcome.stopped, Some(StepError::Interrupted { .. }));
        let stops = self.model.scenario.solve.on_energy_error == OnEnergyError::Stop;
        if !is_first || is_stopped || !stops || !case.has_chosen_step() {
            return None;
        }
        let (step_fraction, what) = match self.unresolved().or_else(|| self.unbalanced()) {
            _ if self.diverged() => (0.25 * self.fraction(), "the run diverged".to_owned()),
            Some(Failure::Unbalanced { smaller, what, found, asked, .. }) => {
                (smaller, format!("{what} was {} %, at most {} % is allowed", percent(found), percent(asked)))
            }
            Some(Failure::Unresolved { smaller, place, found, .. }) => {
                (smaller, format!("{place} changed its length by {found:.0} % in one step"))
            }
            _ => return None,
        };
        // no run takes a hundred times as long unasked
        let step_fraction = sensible(step_fraction.max(0.01 * self.fraction()));
        let why = format!(
            "the run was done again with solve.step_fraction = {step_fraction}: with {}, which netcast chose, {what}",
            self.fraction()
        );
        Some(SecondRun { step_fraction, why })
    }

    /// Whether its numbers grew without end.
    fn diverged(&self) -> bool {
        matches!(self.outcome.stopped, Some(StepError::Diverged { .. } | StepError::NotFinite { .. }))
    }

    /// The share of the stable step that was taken.
    fn fraction(&self) -> f64 {
        self.model.scenario.solve.step_fraction.map_or(1.0, |fraction| fraction.si())
    }
}

/// A percentage, to three decimals, or in powers of ten where it is huge.
fn percent(value: f64) -> String {
    if value < 1e4 { format!("{value:.3}") } else { format!("{value:.1e}") }
}

/// Two digits, as one types them.
fn sensible(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// A step error with the names of the model's parts.
fn in_words(model: &Model, error: &StepError) -> String {
    let smaller = 0.25 * model.largest_dt() / model.limit.dt;
    let mend = format!("the step is too large for this motion, try --set solve.step_fraction={smaller:.2}");
    match error {
        StepError::NotFinite { step, time, term, place } => {
            let place = match *place {
                PlaceInNet::Node(node) => model.node_label(node),
                PlaceInNet::Segment(segment) => model.segment_label(segment),
            };
            format!("step {step} at {time} s: the {term} of {place} is not a finite number; {mend}")
        }
        StepError::Diverged { .. } => format!("{error}; {mend}"),
        StepError::BeyondTable { step, time, segment } => {
            let place = model.segment_label(*segment);
            format!(
                "step {step} at {time} s: {place} is stretched beyond the last row of its table, where law.table.beyond = \"stop\""
            )
        }
        StepError::Exceeded(_) | StepError::Interrupted { .. } => error.to_string(),
    }
}

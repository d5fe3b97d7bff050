//! What is measured of a run: at every step, or at checks where it takes the whole web. None of it depends on what is
//! recorded. At the end each measure writes what it found into the summary.
//!
//! ```text
//!  steps     areas, points, tensions, posture                    every step
//!  cloth     stress of sheets                                    every step
//!  reactions the force of each support                          every step
//!  moments   the net at the highest tension, the largest area    the steps where they are
//!  web       silhouette, mouth, target, flight                   checks
//!  ropes     least and mean tension of each kind of rope         checks
//! ```

mod cloth;
mod flight;
mod moments;
mod mouth;
mod peak;
mod reactions;
mod ropes;
mod silhouette;
mod since_record;
mod spell;
mod steps;
pub(crate) mod web;

use netcast_dynamics::channel::Channel;
use netcast_dynamics::forces::membrane::Membrane;
use netcast_dynamics::simulate::{Frame, Live, Outcome};
use serde::{Deserialize, Serialize};

use crate::landmarks::Landmarks;
use crate::summary::{EnergyBalance, Summary};

use cloth::ClothMeasures;
use moments::Moments;
use reactions::ReactionMeasures;
use ropes::RopeMeasures;
use web::WebMeasures;

pub(crate) use moments::{KeptFrame, MomentFrames};
pub(crate) use reactions::reaction;
pub use steps::OPEN_SHARE;
pub(crate) use steps::StepMeasures;
pub(crate) use web::WebState;

use glam::DVec3;

/// The largest residual of the energy balance that was asked for, as shares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyTolerance {
    /// Over the largest total energy.
    pub of_total: f64,
    /// Over the web's largest energy.
    pub of_web: f64,
}

/// What of a system the measures go by.
#[derive(Debug)]
pub(crate) struct MeasuredNet {
    pub landmarks: Landmarks,
    /// Mass of each node, kg; zero for tractors.
    pub web_mass: Vec<f64>,
    /// The class of each segment in the system.
    pub groups: Vec<usize>,
    pub membranes: Vec<Membrane>,
    /// The channels of the energy balance.
    pub channels: Vec<Channel>,
}

/// All that has been measured of a run so far: what a later record or the end of the run depends on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measures {
    pub(crate) at_steps: StepMeasures,
    at_checks: WebMeasures,
    ropes: RopeMeasures,
    cloth: ClothMeasures,
    reactions: ReactionMeasures,
    moments: Moments,
    /// Records so far.
    pub(crate) rows: u64,
    /// The time of the last record or check, s.
    pub(crate) last_time: f64,
    last_residual: f64,
}

impl Measures {
    /// Starts measuring at `position`s of time 0, m, (nodes,); travel counts from the `reference`.
    pub(crate) fn new(of: &MeasuredNet, reference: &[DVec3], position: &[DVec3]) -> Self {
        Self {
            at_steps: StepMeasures::new(&of.landmarks, reference, position),
            at_checks: WebMeasures::new(&of.web_mass, reference),
            ropes: RopeMeasures::new(&of.landmarks),
            cloth: ClothMeasures::default(),
            reactions: ReactionMeasures::new(&of.landmarks),
            moments: Moments::default(),
            rows: 0,
            last_time: 0.0,
            last_residual: 0.0,
        }
    }

    /// Whether it is of a web with such landmarks.
    pub(crate) fn fit(&self, landmarks: &Landmarks) -> bool {
        self.at_steps.fit(landmarks) && self.ropes.fit(landmarks) && self.reactions.fit(landmarks)
    }

    /// Takes a step into account. Returns whether the net that it leads to is one of the moments that are kept.
    pub(crate) fn step(&mut self, of: &MeasuredNet, live: &Live) -> bool {
        self.at_steps.step(&of.landmarks, live);
        self.cloth.add(&of.membranes, live.position_time, |node| live.net.position(node));
        self.reactions.step(&of.landmarks, live);
        self.ropes.step(self.at_steps.largest_tensions(), live);
        self.moments.step(self.at_steps.glance(&of.landmarks), live)
    }

    /// Keeps the net at a moment.
    pub(crate) fn keep(&mut self, of: &MeasuredNet, frame: &Frame) {
        let area = of.landmarks.outline_area(|node| frame.position[node]);
        let area = area.map(|area| area.dot(of.landmarks.axis).abs());
        let is_open = self.at_steps.glance(&of.landmarks).is_open;
        self.moments.keep(frame, area, is_open);
    }

    /// Takes a check into account.
    pub(crate) fn check(&mut self, of: &MeasuredNet, frame: &Frame) {
        let landmarks = &of.landmarks;
        let touches = frame.ledger[Channel::Ground] > 0.0;
        self.at_checks.add(landmarks, &of.web_mass, frame.time, frame.position, touches);
        self.ropes.add(landmarks, frame.tension, &of.groups);
        let group_of = |segment: usize| of.groups[segment];
        self.at_steps.check(landmarks, frame.time, frame.velocity, frame.tension, &group_of);
        self.reactions.check(landmarks, frame);
        self.last_residual = frame.residual;
        self.last_time = frame.time;
    }

    /// The web as a whole at a record.
    pub(crate) fn web(&self, of: &MeasuredNet, frame: &Frame) -> WebState {
        self.at_checks.web(&of.landmarks, &of.web_mass, frame.position)
    }

    /// Counts a record that has been written.
    pub(crate) fn recorded(&mut self, of: &MeasuredNet, frame: &Frame) {
        self.at_steps.recorded(&of.landmarks);
        self.rows += 1;
        self.last_time = frame.time;
    }

    /// The frames of the moments so far.
    pub(crate) fn moments(&self) -> MomentFrames<'_> {
        self.moments.finish(self.last_time)
    }

    /// The sections of the summary that are measured; the others are left open. `tolerance` is what the balance was
    /// asked to reach.
    pub(crate) fn finish(self, of: &MeasuredNet, outcome: &Outcome, tolerance: EnergyTolerance) -> Summary {
        let places = self.at_checks.places(&of.landmarks, &of.web_mass, &self.moments());
        let Self { at_steps, at_checks, ropes, cloth, reactions, moments: _, rows: _, last_time: _, last_residual } =
            self;
        let landmarks = &of.landmarks;
        let mut summary = Summary::default();
        ropes.finish(landmarks, |rope| at_steps.largest_in_rope(landmarks, rope), &mut summary);
        summary.canopies = cloth.finish(&of.membranes, landmarks);
        summary.places = places;
        reactions.finish(landmarks, &mut summary);
        at_checks.finish(landmarks, &mut summary);
        at_steps.finish(landmarks, &mut summary);
        let (ledger, balance) = (outcome.ledger, outcome.balance);
        summary.energy = EnergyBalance {
            initial_j: balance.initial(),
            final_j: ledger.stored(),
            closure: balance.closure(),
            closure_web: Some(balance.closure_web()),
            channels: of.channels.iter().map(|&channel| (channel.name().to_owned(), ledger[channel])).collect(),
            residual_j: last_residual,
            largest_residual_j: balance.largest_residual(),
            tolerance: tolerance.of_total,
            tolerance_web: tolerance.of_web,
        };
        summary
    }
}

//! A run in time: steps, records, and the checks that stop a run that has gone wrong.

use crate::channel::Channel;
use crate::effects::Launching;
use crate::energy::{Balance, Ledger, Losses, least_energy, mass_damping_power};
use crate::forces::breaking::Break;
use crate::forces::law::Law;
pub use crate::frame::{Frame, Live};
use crate::limits::{Excess, Limits};
pub use crate::observe::Observer;
pub use crate::schedule::Schedule;
use crate::snapshot::Snapshot;
use crate::state::State;
use crate::system::System;
use crate::time::step::{BreakingSegment, StepSums, Stepper};

/// Closure from which a run has diverged. Energy that the step creates counts in the largest energy too, so that a closure
/// stays below 1 however far a run diverges: here, a hundred times what there was.
const DIVERGED: f64 = 0.99;

/// Why a run stopped before its time. What had been recorded stays valid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StepError {
    /// A value is no longer a finite number.
    #[error("step {step} at {time} s: the {term} of {place} is not finite")]
    NotFinite {
        /// Which step.
        step: u64,
        /// At what time, s.
        time: f64,
        /// Which quantity.
        term: &'static str,
        /// Where.
        place: PlaceInNet,
    },
    /// Nearly all energy of the net is an error of the time integration: the step does not resolve the motion.
    #[error("step {step} at {time:.6} s: the step is unstable, the net has gained {residual:.3e} J from nowhere")]
    Diverged {
        /// Which step.
        step: u64,
        /// At what time, s.
        time: f64,
        /// Energy missing, J.
        residual: f64,
    },
    /// A segment is stretched beyond the last row of its table, whose law asks to stop there.
    #[error("step {step} at {time} s: segment {segment} is stretched beyond the last row of its table")]
    BeyondTable {
        /// Which step.
        step: u64,
        /// At what time, s.
        time: f64,
        /// Which segment.
        segment: usize,
    },
    /// The run exceeds a limit of its observer's.
    #[error("{0}")]
    Exceeded(Excess),
    /// The observer asked for it.
    #[error("interrupted at {time} s")]
    Interrupted {
        /// At what time, s.
        time: f64,
    },
}

/// A place in the system, for messages; the scenario knows its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlaceInNet {
    /// A node.
    Node(usize),
    /// A segment.
    Segment(usize),
}

impl std::fmt::Display for PlaceInNet {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            PlaceInNet::Node(i) => write!(f, "node {i}"),
            PlaceInNet::Segment(i) => write!(f, "segment {i}"),
        }
    }
}

/// How a run ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Steps taken.
    pub steps: u64,
    /// The last time that was recorded, s.
    pub end_time: f64,
    /// How the energy balance closes.
    pub balance: Balance,
    /// The last ledger.
    pub ledger: Ledger,
    /// How the launch came out.
    pub launching: Launching,
    /// The first limit that it exceeded, if it did.
    pub exceeded: Option<Excess>,
    /// The segments that broke, in order.
    pub breaks: Vec<Break>,
    /// Why it stopped early, if it did.
    pub stopped: Option<StepError>,
}

/// Runs `system` from `state` along `schedule` on at most `threads` threads, showing everything to `observer`.
///
/// The result does not depend on the number of threads.
pub fn simulate(
    system: &System,
    state: &State,
    schedule: &Schedule,
    threads: usize,
    observer: &mut dyn Observer,
) -> Outcome {
    let mut net = Stepper::new(system, state, schedule.dt, threads);
    net.watch(&observer.watches());
    let record = FrameBuffers::new(system);
    let (losses, breaks) = (Losses::default(), Vec::new());
    let mut run = Run { net, schedule, limits: observer.limits(), step: 0, wanted: false, losses, breaks, record };
    run.net.team().lead(|| match run.show(observer) {
        Some(outcome) => outcome,
        None => run.run_to_end(observer),
    })
}

/// Goes on from a snapshot of a run of the same `system` along the same `schedule`. `observer` sees what it
/// would have seen after that record in the first run, bit for bit.
///
/// # Panics
/// Where it is a snapshot of something else; [`Snapshot::check`] says so.
pub fn resume(
    system: &System,
    snapshot: &Snapshot,
    schedule: &Schedule,
    threads: usize,
    observer: &mut dyn Observer,
) -> Outcome {
    snapshot.check(system, schedule).unwrap_or_else(|error| panic!("{error}"));
    let Snapshot { motion, losses, balance, ledger, exceeded, breaks } = snapshot;
    let mut net = Stepper::resume(system, motion, schedule.dt, threads);
    net.watch(&observer.watches());
    // the forces at the record; what ropes lost on the way there is in the losses, and what broke among the breaks
    net.forces();
    let record =
        FrameBuffers { balance: Some(*balance), ledger: *ledger, exceeded: *exceeded, ..FrameBuffers::new(system) };
    let (step, losses, breaks) = (motion.step, *losses, breaks.clone());
    let mut run = Run { net, schedule, limits: observer.limits(), step, wanted: false, losses, breaks, record };
    if step == schedule.count {
        return run.outcome(None);
    }
    run.net.team().lead(|| run.run_to_end(observer))
}

/// A run under way.
struct Run<'a> {
    net: Stepper<'a>,
    schedule: &'a Schedule,
    limits: Limits,
    /// The step that is next.
    step: u64,
    /// Whether the observer wants to see the net there.
    wanted: bool,
    losses: Losses,
    breaks: Vec<Break>,
    record: FrameBuffers,
}

impl Run<'_> {
    /// From a record to the end.
    fn run_to_end(&mut self, observer: &mut dyn Observer) -> Outcome {
        loop {
            let sums = self.net.advance();
            self.add_step(sums, observer);
            while !self.is_due(observer) {
                let sums = self.net.step();
                if let Some(stopped) = self.add_forces(&sums) {
                    return self.outcome(Some(stopped));
                }
                if !sums.work[Channel::RopeDamping].is_finite() {
                    return self.outcome(Some(not_finite(&self.net, self.time(), self.step)));
                }
                self.add_step(sums, observer);
            }
            if let Some(outcome) = self.show(observer) {
                return outcome;
            }
        }
    }

    /// Whether the net is shown at the step that is next.
    fn is_due(&mut self, observer: &mut dyn Observer) -> bool {
        self.wanted = observer.wants_moment();
        self.wanted || self.schedule.records(self.step) || self.schedule.checks(self.step)
    }

    /// Shows the net to the observer between its forces and its advance. Where the run ends here, says how.
    fn show(&mut self, observer: &mut dyn Observer) -> Option<Outcome> {
        let (time, step) = (self.time(), self.step);
        let sums = self.net.forces();
        let beyond_table = self.add_forces(&sums);
        let (record, check) = (self.schedule.records(step), self.schedule.checks(step));
        let due = Due { time, step, record, check, moment: self.wanted };
        let measured = sums.work[Channel::RopeDamping].is_finite()
            && self.record.take(&self.net, due, &self.losses, &self.limits, observer);
        if !measured {
            return Some(self.outcome(Some(not_finite(&self.net, time, step))));
        }
        let exceeded = self.record.exceeded.filter(|_| self.limits.stops).map(StepError::Exceeded);
        let stopped = self.record.diverged(time, step).or(beyond_table).or(exceeded);
        if stopped.is_some() {
            return Some(self.outcome(stopped));
        }
        if step == self.schedule.count {
            if observer.wants_last_snapshot() {
                observer.snapshot(&self.snapshot());
            }
            return Some(self.outcome(None));
        }
        if !due.record {
            return None;
        }
        let interrupted = observer.interrupted();
        if observer.wants_snapshot() || interrupted {
            observer.snapshot(&self.snapshot());
        }
        interrupted.then(|| self.outcome(Some(StepError::Interrupted { time })))
    }

    /// Adds the work of a step's forces to the losses, and notes the segments that break. Returns the first of them that
    /// stops the run.
    fn add_forces(&mut self, sums: &StepSums) -> Option<StepError> {
        self.losses.add_work(&sums.work);
        if sums.failing == 0 {
            return None;
        }
        let (step, time, system) = (self.step, self.time(), self.net.system());
        let mut failing: Vec<_> = self.net.failing().collect();
        failing.sort_by_key(|failure| failure.segment);
        let stops =
            |segment: usize| matches!(system.law(&system.segments()[segment]), Law::Tabulated(law) if law.stops());
        if let Some(BreakingSegment { segment, .. }) = failing.iter().find(|failing| stops(failing.segment)) {
            return Some(StepError::BeyondTable { step, time, segment: *segment });
        }
        for BreakingSegment { segment, tension, energy } in failing {
            self.losses.add_rupture(energy);
            self.breaks.push(Break { segment, step, time, tension });
        }
        None
    }

    /// Counts a step that was taken, and shows it to the observer.
    fn add_step(&mut self, sums: StepSums, observer: &mut dyn Observer) {
        let (dt, time) = (self.schedule.dt, self.time());
        self.losses.add_mass_power(sums.mass_power, dt);
        self.step += 1;
        observer.step(&Live {
            position_time: self.time(),
            velocity_time: time + 0.5 * dt,
            tension_time: time,
            dt,
            net: &self.net,
        });
    }

    /// Where the run stands. Taken apart field by field, so that what is new cannot be forgotten here.
    fn snapshot(&self) -> Snapshot {
        let Run { net, schedule: _, limits: _, step: _, wanted: _, losses, breaks, record } = self;
        let FrameBuffers { state: _, tension: _, ledger, balance: _, exceeded } = record;
        let (motion, balance, breaks) = (net.motion(), record.balance(), breaks.clone());
        Snapshot { motion, losses: *losses, balance, ledger: *ledger, exceeded: *exceeded, breaks }
    }

    /// Time of the step that is next, s.
    fn time(&self) -> f64 {
        self.schedule.time(self.step)
    }

    fn outcome(&self, stopped: Option<StepError>) -> Outcome {
        let (balance, ledger, exceeded) = (self.record.balance(), self.record.ledger, self.record.exceeded);
        let (breaks, launching) = (self.breaks.clone(), self.net.launching());
        Outcome { steps: self.step, end_time: self.time(), balance, ledger, launching, exceeded, breaks, stopped }
    }
}

/// A step at which the net is shown, and what for.
#[derive(Clone, Copy)]
struct Due {
    /// Time, s, and number of the step.
    time: f64,
    step: u64,
    record: bool,
    check: bool,
    moment: bool,
}

/// The net at a step that is shown, in buffers that are used again.
struct FrameBuffers {
    state: State,
    tension: Vec<f64>,
    ledger: Ledger,
    balance: Option<Balance>,
    exceeded: Option<Excess>,
}

impl FrameBuffers {
    fn new(system: &System) -> FrameBuffers {
        FrameBuffers {
            state: State::default(),
            tension: vec![0.0; system.segments().len()],
            ledger: Ledger::default(),
            balance: None,
            exceeded: None,
        }
    }

    /// Shows the net to the observer, or returns false where its energy is not finite.
    fn take(&mut self, net: &Stepper, due: Due, losses: &Losses, limits: &Limits, observer: &mut dyn Observer) -> bool {
        net.state(&mut self.state);
        for (segment, tension) in self.tension.iter_mut().enumerate() {
            *tension = if net.is_gone(segment) { f64::NAN } else { net.tension(segment) };
        }
        let stored = net.stored(&self.state);
        let ledger = losses.ledger(stored, mass_damping_power(net.system(), &self.state), net.dt());
        if !ledger.sum().is_finite() {
            return false;
        }
        let balance = self.balance.get_or_insert_with(|| Balance::new(ledger, least_energy(net.system())));
        if due.check {
            balance.add(&ledger);
        }
        self.ledger = ledger;
        let State { position, velocity, rotation } = &self.state;
        let tension = &self.tension;
        let residual = ledger.residual(balance.start());
        let Due { time, step, .. } = due;
        let frame = Frame { time, step, position, velocity, rotation, tension, ledger, residual, net };
        if due.check {
            observer.check(&frame);
            self.exceeded = self.exceeded.or_else(|| limits.exceeded(net.system(), net.dt(), balance, &frame));
        }
        if due.moment {
            observer.moment(&frame);
        }
        if due.record {
            observer.record(&frame);
        }
        true
    }

    fn diverged(&self, time: f64, step: u64) -> Option<StepError> {
        let balance = self.balance();
        let residual = balance.largest_residual();
        (balance.closure() > DIVERGED).then_some(StepError::Diverged { step, time, residual })
    }

    fn balance(&self) -> Balance {
        self.balance.unwrap_or_else(|| Balance::new(self.ledger, 0.0))
    }
}

/// Finds the first value that is not finite; where all are, their squares are too large.
fn not_finite(net: &Stepper, time: f64, step: u64) -> StepError {
    let system = net.system();
    let node = (0..system.mass().len()).find_map(|node| {
        let place = PlaceInNet::Node(node);
        if !net.half_step_velocity(node).is_finite() {
            Some(("velocity", place))
        } else {
            (!net.position(node).is_finite()).then_some(("position", place))
        }
    });
    let segment = || (0..system.segments().len()).find(|&s| !net.tension(s).is_finite());
    match node.or_else(|| segment().map(|s| ("tension", PlaceInNet::Segment(s)))) {
        Some((term, place)) => StepError::NotFinite { step, time, term, place },
        None => StepError::Diverged { step, time, residual: f64::INFINITY },
    }
}

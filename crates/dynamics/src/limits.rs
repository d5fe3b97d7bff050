//! Limits of energy error and of step length, checked at every record.

use serde::{Deserialize, Serialize};

use crate::energy::Balance;
use crate::frame::Frame;
use crate::system::System;

/// Largest errors that a run may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest [`Balance::closure`]. That of the web can be judged at the end only: its largest energy comes late.
    pub closure: f64,
    /// Largest change of a segment's length in one step, over its rest length: beyond, the step does not resolve the
    /// motion, whatever the energy does.
    pub sweep: f64,
    /// Whether a run that exceeds a limit stops; else it goes on, and its outcome tells the first.
    pub stops: bool,
}

/// The quantity that exceeds its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Term {
    /// The energy balance, over the largest energy of the run.
    Closure,
    /// The change of a segment's length in one step, over its rest length.
    Sweep,
}

/// A limit that is exceeded: what, when, where.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Excess {
    /// The quantity that exceeds it.
    pub term: Term,
    /// By how much: its value.
    pub found: f64,
    /// The limit.
    pub allowed: f64,
    /// At which step.
    pub step: u64,
    /// At what time, s.
    pub time: f64,
    /// The segment that changes most; for a balance, the one that pulls hardest there and then.
    pub segment: Option<usize>,
}

impl Limits {
    /// No limit.
    pub const NONE: Limits = Limits { closure: f64::INFINITY, sweep: f64::INFINITY, stops: false };

    /// The first limit that a run exceeds at a record, with steps of `dt` s.
    pub(crate) fn exceeded(&self, system: &System, dt: f64, balance: &Balance, frame: &Frame) -> Option<Excess> {
        let &Frame { step, time, .. } = frame;
        let excess = |term, found, allowed, segment| Excess { term, found, allowed, step, time, segment };
        let closure = balance.closure();
        if closure > self.closure {
            let hardest = largest(frame.tension.iter().copied()).map(|(segment, _)| segment);
            return Some(excess(Term::Closure, closure, self.closure, hardest));
        }
        let sweeps = system.segments().iter().zip(frame.tension).map(|(s, tension)| {
            // a broken segment no longer limits how fast its ends move apart
            if tension.is_nan() {
                return 0.0;
            }
            let [a, b] = s.ends;
            let (span, rate) = (frame.position[b] - frame.position[a], frame.velocity[b] - frame.velocity[a]);
            span.normalize_or_zero().dot(rate).abs() * dt / s.rest_length
        });
        let (segment, sweep) = largest(sweeps)?;
        (sweep > self.sweep).then(|| excess(Term::Sweep, sweep, self.sweep, Some(segment)))
    }
}

/// The largest of some values and its index; the first of equals.
fn largest(values: impl Iterator<Item = f64>) -> Option<(usize, f64)> {
    values.enumerate().reduce(|best, next| if next.1 > best.1 { next } else { best })
}

impl std::fmt::Display for Excess {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Excess { term, found, allowed, step, time, segment: _ } = self;
        let (found, allowed) = (100.0 * found, 100.0 * allowed);
        let what = match term {
            Term::Closure => "the energy balance misses",
            Term::Sweep => "the step does not resolve the motion: in one step a segment changes its length by",
        };
        write!(f, "step {step} at {time} s: {what} {found:.3} %, at most {allowed:.3} % is allowed")
    }
}

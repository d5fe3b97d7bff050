//! How nodes and bodies move within a step, and the constants by which a step moves them.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::body::{Body, Rotation};
use crate::forces::mass_damping;

/// The constants of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepFactors {
    /// Step, s.
    pub dt: f64,
    /// Factor of the half-step velocity before.
    pub p: f64,
    /// Factor of the acceleration, s.
    pub q: f64,
}

impl StepFactors {
    /// The factors of a step of `dt` seconds under mass-proportional `damping`, 1/s.
    pub fn new(dt: f64, damping: f64) -> StepFactors {
        let (p, q) = mass_damping::step_factors(damping, dt);
        StepFactors { dt, p, q }
    }

    /// One kick and drift of one component: (v+, x+, w+) from v-, x and the acceleration a.
    #[inline(always)]
    pub(crate) fn advance(self, velocity: f64, position: f64, acceleration: f64) -> [f64; 3] {
        let next = self.p * velocity + self.q * acceleration;
        [next, position + self.dt * next, 1.5 * next - 0.5 * velocity]
    }

    /// The half-step velocity before a start at velocity `v` with acceleration `a`, so that their mean at the start
    /// is `v`.
    pub(crate) fn before_start(self, velocity: f64, acceleration: f64) -> f64 {
        (2.0 * velocity - self.q * acceleration) / (1.0 + self.p)
    }

    /// The velocity at the step, from the one half a step before and the acceleration.
    pub(crate) fn at_step(self, before: f64, acceleration: f64) -> f64 {
        0.5 * (before + (self.p * before + self.q * acceleration))
    }
}

/// A node as a step has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moving {
    /// Position, m.
    pub x: DVec3,
    /// Half-step velocity, m/s.
    pub v: DVec3,
    /// Velocity extrapolated to the step, m/s.
    pub w: DVec3,
}

/// How a body turns.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Turning {
    /// Orientation at the step, and angular momentum half a step before, kg m^2/s.
    pub half_step: Rotation,
    /// Angular momentum extrapolated to the step, kg m^2/s.
    pub extrapolated: DVec3,
}

impl Turning {
    /// A body that turns like this, whatever half a step before.
    pub fn starting(rotation: Rotation) -> Turning {
        Turning { half_step: rotation, extrapolated: rotation.angular_momentum }
    }

    /// How it turns at the step, under `torque`, N m.
    pub(crate) fn at_step(&self, torque: DVec3, factors: StepFactors) -> Rotation {
        let Rotation { orientation, angular_momentum } = self.half_step;
        let momentum = |k| factors.at_step(angular_momentum[k], torque[k]);
        Rotation { orientation, angular_momentum: DVec3::from_array(std::array::from_fn(momentum)) }
    }

    /// The half-step angular momentum such that it turns as in `start` at the step, under `torque`, N m.
    pub(crate) fn start(&mut self, start: &Rotation, torque: DVec3, factors: StepFactors) {
        for k in 0..3 {
            self.half_step.angular_momentum[k] = factors.before_start(start.angular_momentum[k], torque[k]);
        }
    }

    /// Kick and drift of a rotation.
    pub(crate) fn advance(&mut self, body: &Body, torque: DVec3, factors: StepFactors) {
        let momentum = &mut self.half_step.angular_momentum;
        for k in 0..3 {
            // the third of them is the extrapolation, the second is for what has a place
            [momentum[k], _, self.extrapolated[k]] = factors.advance(momentum[k], 0.0, torque[k]);
        }
        self.half_step.orientation = body.turned(&self.half_step, factors.dt);
    }
}

/// A net as an effect sees it at some forces. Both steps have one.
pub trait Net: Sync {
    /// Where a node is and how it moves.
    fn node(&self, node: usize) -> Moving;
    /// The forces of ropes on a node, N, tension and drag, each added to `force` in turn.
    fn with_ropes(&self, node: usize, force: DVec3) -> DVec3;
}

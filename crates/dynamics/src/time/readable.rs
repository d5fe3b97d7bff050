//! The step as one reads it: a call an effect, then kick and drift, node by node.
//!
//! Slower than [`crate::time::step`], which must give the same bits; a test holds them together. Read this one.

use glam::DVec3;

use super::StepFactors;
use crate::forces::rope_tension::Pull;
use crate::forces::{gravity, rope_tension};
use crate::state::State;
use crate::system::System;

/// A net in motion, in arrays by node and by segment.
pub struct Readable<'a> {
    system: &'a System,
    factors: StepFactors,
    /// Positions, m, (nodes,).
    pub position: Vec<DVec3>,
    /// Half-step velocities, m/s, (nodes,).
    pub velocity: Vec<DVec3>,
    /// Velocities extrapolated to the step, m/s, (nodes,).
    pub extrapolated: Vec<DVec3>,
    /// What each segment did at the last forces, (segments,).
    pub pulls: Vec<Pull>,
    /// Work lost inside ropes between the last two forces, J.
    pub rope_work: f64,
}

impl<'a> Readable<'a> {
    /// Starts from `state` with steps of `dt` seconds.
    pub fn new(system: &'a System, state: &State, dt: f64) -> Readable<'a> {
        let at_rest = |node: usize| if system.held()[node] { DVec3::ZERO } else { state.velocity[node] };
        let velocity: Vec<_> = (0..state.velocity.len()).map(at_rest).collect();
        let mut net = Readable {
            system,
            factors: StepFactors::new(dt, system.environment().mass_damping),
            position: state.position.clone(),
            extrapolated: velocity.clone(),
            velocity,
            pulls: vec![Pull { tension: 0.0, force: [0.0; 3], length: 0.0, friction: 0.0 }; system.segments().len()],
            rope_work: 0.0,
        };
        let acceleration = net.accelerations();
        for node in (0..acceleration.len()).filter(|&n| !system.held()[n]) {
            for k in 0..3 {
                net.velocity[node][k] = net.factors.before_start(state.velocity[node][k], acceleration[node][k]);
            }
        }
        net
    }

    /// One step: forces, kick, drift.
    pub fn step(&mut self) {
        let acceleration = self.accelerations();
        for node in (0..acceleration.len()).filter(|&n| !self.system.held()[n]) {
            for k in 0..3 {
                let (v, x, a) = (self.velocity[node][k], self.position[node][k], acceleration[node][k]);
                let [v, x, w] = self.factors.advance(v, x, a);
                (self.velocity[node][k], self.position[node][k], self.extrapolated[node][k]) = (v, x, w);
            }
        }
    }

    /// The sum of all effects over the mass. Mass-proportional damping is in the factors of the step.
    fn accelerations(&mut self) -> Vec<DVec3> {
        let (system, mut force) = (self.system, vec![DVec3::ZERO; self.position.len()]);
        let before = self.pulls.clone();
        let (x, w, dt) = (&self.position, &self.extrapolated, self.factors.dt);
        rope_tension::add_force(system, x, w, dt, &mut force, &mut self.pulls);
        self.rope_work = rope_tension::lost_work(system, &before, &self.pulls);
        gravity::add_force(system.environment().gravity, system.mass(), &mut force);
        force.iter().zip(system.mass()).map(|(f, m)| *f * (1.0 / m)).collect()
    }
}

//! The pass over a block whose segments follow another law than the linear one: segment by segment, without vectors.

use super::blocks::{Nodes, Ropes};
use crate::forces::law::Memory;
use crate::forces::rope_tension::dissipative_work;
use crate::lanes::{max, sum};

impl Ropes {
    /// Tensions and pulls of all segments of the block; `dt` is the step, s; `moved` whether one has passed since the forces
    /// before.
    pub fn pull_by_law(&mut self, nodes: &Nodes, dt: f64, moved: bool) {
        let ([x, y, z], [u, v, w]) = (&nodes.x, &nodes.w);
        let decay = self.law.decay(if moved { dt } else { 0.0 });
        let mut nothing: Memory = Default::default();
        for i in 0..self.tension.len() {
            let span = [x[i + 1] - x[i], y[i + 1] - y[i], z[i + 1] - z[i]];
            let rate = [u[i + 1] - u[i], v[i + 1] - v[i], w[i + 1] - w[i]];
            let axial = self.axial(i);
            let memory = self.memory.get_mut(i).unwrap_or(&mut nothing);
            let p = self.law.pull(span, rate, axial, memory, dt, &decay);
            self.terms[i] = dissipative_work(self.length[i], self.dissipative[i], &p) + p.lost;
            (self.tension[i], self.length[i], self.dissipative[i]) = (p.tension, p.length, p.dissipative);
            for (pull, force) in self.pull.iter_mut().zip(p.force) {
                pull[i + 1] = force;
            }
        }
        self.rope_work = sum(&self.terms);
        self.max_tension = max(&self.tension);
    }
}

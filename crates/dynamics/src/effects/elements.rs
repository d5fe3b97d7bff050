//! Elements of one kind in motion: their forces on nodes, and the energy that they lose.

use glam::DVec3;

use crate::forces::element::{Element, ElementForces};
use crate::parts::{PartKind, SystemError};
use crate::team::Team;

/// With fewer elements than this, threads wait longer than they work.
const LEAST_FOR_THREADS: usize = 2_000;

/// Elements of one kind.
#[derive(Debug, Clone)]
pub(super) struct Elements<const N: usize> {
    /// The nodes of each.
    nodes: Vec<[usize; N]>,
    /// Forces of each, and the places of its nodes, at the last forces.
    last: Vec<LastForces<N>>,
    /// Work that each has lost since the forces before, J.
    work: Vec<f64>,
    /// Those that pull for the last time at the last forces.
    leaving: Vec<usize>,
    /// Whether each is removed.
    gone: Vec<bool>,
}

/// Forces of an element, N, and the places of its nodes, m, at the last forces.
#[derive(Debug, Clone, Copy)]
struct LastForces<const N: usize> {
    place: [DVec3; N],
    forces: ElementForces<N>,
}

impl<const N: usize> Elements<N> {
    /// Elements between these nodes.
    pub fn new(nodes: Vec<[usize; N]>) -> Self {
        let last = vec![LastForces { place: [DVec3::ZERO; N], forces: ElementForces::NONE }; nodes.len()];
        let (work, gone) = (vec![0.0; nodes.len()], vec![false; nodes.len()]);
        Elements { nodes, last, work, leaving: Vec::new(), gone }
    }

    /// Takes out an element.
    pub fn remove(&mut self, index: usize) {
        self.gone[index] = true;
    }

    /// Takes out an element as soon as nodes have moved. The work of its last force is lost. Returns the positions of
    /// its nodes, m; none where it is removed or leaving already.
    pub fn leave(&mut self, index: usize) -> Option<[DVec3; N]> {
        if self.gone[index] || self.leaving.contains(&index) {
            return None;
        }
        self.leaving.push(index);
        let LastForces { place, forces } = &mut self.last[index];
        for k in 0..N {
            forces.dissipative[k] += forces.elastic[k];
        }
        Some(*place)
    }

    /// Removes the elements that acted for the last time; called after nodes have moved.
    pub fn remove_leaving(&mut self) {
        for index in self.leaving.drain(..) {
            self.gone[index] = true;
        }
    }

    /// Adds their forces to `force`, N, (nodes,), in their order. Returns the work of their dissipative forces since the
    /// forces before, J: force times way, by the trapezoidal rule, as for ropes. `forces` gives the forces of an element
    /// from the positions and velocities of its nodes; `at` gives position, m, and velocity, m/s, of a node.
    pub fn pull(
        &mut self,
        team: &Team,
        forces: impl Fn(usize, [DVec3; N], [DVec3; N]) -> ElementForces<N> + Sync,
        at: impl Fn(usize) -> (DVec3, DVec3) + Sync,
        force: &mut [DVec3],
    ) -> f64 {
        // where nodes have not moved, the same segments break again and name these elements again
        self.leaving.clear();
        let (nodes, gone) = (&self.nodes, &self.gone);
        let alone = Team::default();
        let team = if nodes.len() < LEAST_FOR_THREADS { &alone } else { team };
        team.for_each(&mut self.last, &mut self.work, |index, last, work| {
            let nodes = nodes[index].map(&at);
            let place = nodes.map(|(x, _)| x);
            let forces = if gone[index] { ElementForces::NONE } else { forces(index, place, nodes.map(|(_, w)| w)) };
            *work = 0.0;
            for k in 0..N {
                let mean = 0.5 * (last.forces.dissipative[k] + forces.dissipative[k]);
                *work -= mean.dot(place[k] - last.place[k]);
            }
            *last = LastForces { place, forces };
        });
        for (nodes, last) in nodes.iter().zip(&self.last) {
            for (k, &node) in nodes.iter().enumerate() {
                force[node] += last.forces.elastic[k] + last.forces.dissipative[k];
            }
        }
        self.work.iter().sum()
    }
}

impl<const N: usize> Elements<N> {
    /// Elastic energy of all whole elements, J, with nodes at `position`, m, (nodes,).
    pub fn stored<E: Element<N>>(&self, elements: &[E], position: &[DVec3]) -> f64 {
        let whole = |(index, _): &(usize, &E)| !self.gone[*index] && !self.leaving.contains(index);
        let whole = elements.iter().enumerate().filter(whole);
        whole.map(|(_, element)| element.elastic_energy(element.nodes().map(|node| position[node]))).sum()
    }
}

/// Whether the nodes of all elements are nodes of the system.
pub(super) fn check<E: Element<N>, const N: usize>(
    part: PartKind,
    elements: &[E],
    nodes: usize,
) -> Result<(), SystemError> {
    for (index, element) in elements.iter().enumerate() {
        if let Some(&node) = element.nodes().iter().find(|&&node| node >= nodes) {
            return Err(SystemError::attached(part, index, node, "does not exist"));
        }
    }
    Ok(())
}

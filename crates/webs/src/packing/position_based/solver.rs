//! The time steps of a prescribed packing: predict, project, update; see the [module](super).

use glam::{DMat3, DVec3};

use super::projection::Projection;
use super::rope_pieces::RopePieces;
use super::terms::{DrivenNode, Prescribed, Settled};
use super::walls::Tube;
use crate::CutWeb;
use crate::packing::distance_limits::{self, DistanceLimit};

/// Time step, s.
const STEP: f64 = 2e-3;

/// Number of sweeps in a step.
const SWEEPS: usize = 10;

/// A web on its way into the container.
pub(super) struct Solver<'a> {
    packing: &'a Prescribed,
    cut_web: &'a CutWeb,
    paths: Vec<DrivenNode>,
    /// Time at which the last path ends, s.
    end: f64,
    tube: Tube,
    pieces: RopePieces<'a>,
    /// Distance limits of rope pieces and canopies.
    limits: Vec<DistanceLimit>,
    /// Inverse mass of each node, 1/kg, (nodes,); 0 where a node is driven, lies inside a piece or a plate, or belongs
    /// to a traction rope.
    inverse_mass: Vec<f64>,
    /// Nodes with an inverse mass above 0.
    free: Vec<usize>,
    /// Positions in the launch frame, with the flat web at z = 0, m, (nodes,).
    pub position: Vec<DVec3>,
    /// Velocities, m/s, (nodes,).
    velocity: Vec<DVec3>,
    /// Rotation of each plate against the flat web, (plates,).
    pub turns: Vec<DMat3>,
}

impl<'a> Solver<'a> {
    /// The flat web at rest, before the motion.
    pub fn new(packing: &'a Prescribed, cut_web: &'a CutWeb, paths: Vec<DrivenNode>) -> Self {
        let pieces = RopePieces::of(cut_web, paths.iter().map(|driven| driven.node));
        let is_web = cut_web.is_web();
        let limits = pieces.distance_limits().chain(distance_limits::of_canopies(cut_web));
        let limits: Vec<DistanceLimit> = limits.filter(|limit| limit.ends.iter().all(|&end| is_web[end])).collect();

        let mut inverse_mass = vec![0.0; cut_web.nodes.len()];
        let mass = pieces.lumped_mass(&packing.mass, &packing.plates);
        for &end in limits.iter().flat_map(|limit| &limit.ends) {
            inverse_mass[end] = 1.0 / mass[end];
        }
        for driven in &paths {
            inverse_mass[driven.node] = 0.0;
        }
        let end = paths.iter().map(DrivenNode::end).fold(0.0, f64::max);
        let tube = Tube {
            first_radius: cut_web.web.radius(),
            radius: packing.radius,
            closing_time: end,
            depth: packing.depth,
        };
        Self {
            packing,
            cut_web,
            paths,
            end,
            tube,
            pieces,
            limits,
            free: (0..inverse_mass.len()).filter(|&node| inverse_mass[node] > 0.0).collect(),
            inverse_mass,
            position: cut_web.nodes.iter().map(|&node| (node - cut_web.web.middle).with_z(0.0)).collect(),
            velocity: vec![DVec3::ZERO; cut_web.nodes.len()],
            turns: vec![DMat3::IDENTITY; packing.plates.len()],
        }
    }

    /// Takes steps until the web is at rest, then draws in ropes that are still stretched.
    pub fn run(&mut self) -> Settled {
        let mut settled = Settled { time: 0.0, share: 1.0 };
        let (mut step, mut largest) = (0u32, 0.0f64);
        while !self.is_done(&settled) {
            step += 1;
            settled.time = f64::from(step) * STEP;
            self.step(settled.time);
            let energy = self.twice_the_kinetic_energy();
            largest = largest.max(energy);
            settled.share = if largest > 0.0 { energy / largest } else { 0.0 };
        }
        let Self { packing, cut_web, limits, inverse_mass, position, turns, .. } = self;
        Projection { cut_web, limits, plates: &packing.plates, inverse_mass }.draw_in(turns, position);
        self.pieces.fill_in(&mut self.position);
        settled
    }

    /// Whether the motion ends: all paths have ended, and the web is at rest or its longest time is over.
    fn is_done(&self, settled: &Settled) -> bool {
        let Prescribed { rest, longest, .. } = *self.packing;
        settled.time >= self.end && (settled.share <= rest || settled.time >= longest)
    }

    /// A step to the time `now`, s.
    fn step(&mut self, now: f64) {
        let Prescribed { gravity, damping, .. } = *self.packing;
        let before = self.position.clone();
        // predict
        let damped = libm::exp(-damping * STEP);
        for &node in &self.free {
            let way = damped * (self.velocity[node] - gravity * STEP * DVec3::Z) * STEP;
            self.position[node] += way;
        }
        for driven in &self.paths {
            let flat = (self.cut_web.nodes[driven.node] - self.cut_web.web.middle).with_z(0.0);
            self.position[driven.node] = flat + driven.at(now);
        }
        // project
        let wall = self.tube.radius_at(now);
        let Self { packing, cut_web, limits, inverse_mass, position, turns, free, tube, .. } = self;
        let projection = Projection { cut_web, limits, plates: &packing.plates, inverse_mass };
        for sweep in 0..SWEEPS {
            projection.sweep(sweep % 2 == 1, 0.0, turns, position);
            for &node in &*free {
                tube.push_inside(wall, &mut position[node]);
            }
        }
        projection.place_plates(turns, position);
        // update
        for &node in &self.free {
            self.velocity[node] = (self.position[node] - before[node]) / STEP;
        }
    }

    /// Twice the kinetic energy, J; only ratios of it are used.
    fn twice_the_kinetic_energy(&self) -> f64 {
        let of_node = |&node: &usize| self.velocity[node].length_squared() / self.inverse_mass[node];
        self.free.iter().map(of_node).sum()
    }
}

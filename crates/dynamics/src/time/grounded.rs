//! What the ground does to nodes and to the hulls of rigid bodies, and what it takes from them on the way.

use glam::{DQuat, DVec3};

use super::elements::Elements;
use super::step::Team;
use crate::body::Rotation;
use crate::forces::ground::{Ground, Hull};
use crate::system::System;

/// Nodes and bodies that the ground can touch.
pub(super) struct Grounded<'a> {
    ground: &'a Ground,
    nodes: Elements<1>,
    /// What each point of a hull loses by, N, and how its body was at the last forces.
    hulls: Vec<(DVec3, Placed)>,
}

/// A body where its hull touches: its centre and how it is turned.
#[derive(Debug, Clone, Copy)]
struct Placed {
    centre: DVec3,
    orientation: DQuat,
}

impl Placed {
    /// The way of what touches at `hull`, m, since `before`: a sphere rolls on, and is turned under its lowest point.
    fn way(&self, before: &Placed, hull: &Hull) -> DVec3 {
        let turn = self.orientation * before.orientation.inverse();
        let angle = 2.0 * turn.w.signum() * DVec3::new(turn.x, turn.y, turn.z);
        let arm = self.orientation * hull.arm - before.orientation * hull.arm;
        (self.centre - before.centre) + arm - angle.cross(hull.radius * DVec3::Z)
    }
}

impl<'a> Grounded<'a> {
    /// None where there is no ground.
    pub fn new(system: &'a System) -> Option<Self> {
        let ground = system.environment().ground.as_ref()?;
        Some(Grounded {
            ground,
            nodes: Elements::new(ground.nodes.iter().map(|at| [at.node]).collect()),
            hulls: vec![
                (DVec3::ZERO, Placed { centre: DVec3::ZERO, orientation: DQuat::IDENTITY });
                ground.hulls.len()
            ],
        })
    }

    /// The nodes on which it acts.
    pub fn touched(system: &System) -> impl Iterator<Item = usize> {
        system.environment().ground.iter().flat_map(|ground| ground.nodes.iter().map(|at| at.node))
    }

    /// Adds what it does to nodes in steps of `dt`, s, to `force`, N, (nodes,), and returns the work lost since the forces
    /// before, J. `moving` tells where a node is and how it moves.
    pub fn push(
        &mut self,
        team: &Team,
        dt: f64,
        moving: impl Fn(usize) -> (DVec3, DVec3) + Sync,
        force: &mut [DVec3],
    ) -> f64 {
        let ground = self.ground;
        let pushed = |i: usize, [x]: [DVec3; 1], [v]: [DVec3; 1]| {
            let footing = &ground.nodes[i];
            ground.push(&footing.spring, footing.lowest(x), v, dt)
        };
        self.nodes.pull(team, pushed, moving, force)
    }

    /// The same for the hulls of bodies: `put` takes the point's hull, its arm, m, and the force on it, N. `moving` tells
    /// where a body's centre is, how it moves and how it is turned.
    pub fn push_hulls(
        &mut self,
        system: &System,
        dt: f64,
        moving: impl Fn(&Hull) -> (DVec3, DVec3, Rotation),
        mut put: impl FnMut(&Hull, DVec3, DVec3),
    ) -> f64 {
        let mut work = 0.0;
        for (hull, last) in self.ground.hulls.iter().zip(&mut self.hulls) {
            let (x, v, rotation) = moving(hull);
            let (place, velocity) = hull.moving(&system.bodies()[hull.body], &rotation, x, v);
            let stress = self.ground.push(&hull.spring, place, velocity, dt);
            let ([elastic], [friction]) = (stress.elastic, stress.friction);
            if elastic + friction != DVec3::ZERO {
                put(hull, place - x, elastic + friction);
            }
            let now = (friction, Placed { centre: x, orientation: rotation.orientation });
            let before = std::mem::replace(last, now);
            work -= 0.5 * (before.0 + friction).dot(now.1.way(&before.1, hull));
        }
        work
    }
}

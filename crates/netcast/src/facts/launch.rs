//! Facts on the launch of a case: its rigid tractors, its throws, and the threads that hold the web until they break.

use netcast_model::{Model, Thrown};
use netcast_webs::Class;
use serde::Serialize;

/// A tractor that is a rigid body.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BodyFacts {
    /// The corner that it is tied to, from 1.
    pub corner: u32,
    /// Its mass, kg.
    pub mass_kg: f64,
    /// Its principal moments of inertia about its axes x, y, z, kg m^2.
    pub inertia_kg_m2: [f64; 3],
    /// Position of its rope's knot from its centre, along its axes, m.
    pub tied_at_m: [f64; 3],
}

/// How one tractor is thrown.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ThrowFacts {
    /// The corner that it is tied to, from 1.
    pub corner: u32,
    /// The cause of its motion.
    pub by: Pushed,
    /// The angle between its velocity and the launch axis, rad.
    pub angle_rad: f64,
    /// Time at which its launch begins, s.
    pub delay_s: f64,
}

/// The cause of a tractor's motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Pushed {
    /// Its speed at the start.
    Speed {
        /// The speed, m/s.
        speed_m_s: f64,
    },
    /// A force along a tube.
    Tube {
        /// Length over which the tube guides it, m.
        stroke_m: f64,
        /// Work of the force over the stroke, J; none where the force is given over time.
        work_j: Option<f64>,
    },
}

/// Threads of one kind that hold the web until they break.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Tied {
    /// The kind: `break ties` or `stitches`.
    pub kind: String,
    /// The number of threads.
    pub count: usize,
    /// Load at which the weakest breaks, N.
    pub least_load_n: f64,
    /// Load at which the strongest breaks, N.
    pub largest_load_n: f64,
}

/// The tractors that are rigid bodies, by corner.
pub(super) fn bodies(model: &Model) -> Vec<BodyFacts> {
    let by_corner = model.tractors_by_corner().into_iter().zip(1u32..);
    by_corner
        .filter_map(|(tractor, corner)| {
            let (solid, body) = tractor?;
            Some(BodyFacts {
                corner,
                mass_kg: solid.mass_kg,
                inertia_kg_m2: body.inertia.to_array(),
                tied_at_m: body.ties[0].arm.to_array(),
            })
        })
        .collect()
}

/// The throws of the tractors.
pub(super) fn throws(model: &Model) -> Vec<ThrowFacts> {
    let facts = |throw: &netcast_model::Throw| ThrowFacts {
        corner: throw.corner,
        by: match &throw.by {
            Thrown::At(velocity) => Pushed::Speed { speed_m_s: velocity.length() },
            Thrown::From { stroke, push } => Pushed::Tube { stroke_m: *stroke, work_j: push.work(*stroke) },
        },
        angle_rad: throw.angle_to(model.axis()),
        delay_s: throw.delay,
    };
    model.throws.iter().flatten().map(facts).collect()
}

/// The break ties and stitches, one entry for each group.
pub(super) fn ties(model: &Model) -> Vec<Tied> {
    let breakable = model.groups.iter().enumerate().filter(|(_, group)| group.class.is_made_to_break());
    breakable
        .map(|(number, group)| {
            let loads = model.system.segments().iter().filter(|s| s.group == number).map(|s| s.breaking.load);
            let kind = if group.class == Class::Tie { "break ties" } else { "stitches" };
            Tied {
                kind: kind.to_owned(),
                count: loads.clone().count(),
                least_load_n: group.breaking.load,
                largest_load_n: loads.fold(0.0, f64::max),
            }
        })
        .collect()
}

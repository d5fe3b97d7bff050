//! `[traction_rope]`, `[[tractors]]`: the ropes that tie tractors to the web, and tractors that differ from the others.
//!
//! Points where a rope can be tied to a tractor:
//!
//! ```text
//!                 z, direction of flight             front   middle of the end that flies first
//!            ┌──┬──┐                                 centre  centre of mass: the rope exerts no torque, and
//!            │     │                                         the tractor is a particle
//!   x, away  │  +──┼─▶ x                             rear    middle of the end that flies last
//!   from the │     │                                 tie_point  anywhere: [x, y, z] from the centre
//!   axis     └──┴──┘
//!               │ rope
//! ```

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::body::{Body, Cuboid, Cylinder, Particle, Sphere};
use crate::interval::{NonNegative, QuarterTurns, Splay};
use crate::quantity::{Angle, Length, Speed, Time};

/// `[traction_rope]`: the ropes from a corner of the web to its tractor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["tied_at", "tie_point"]}))]
pub struct TractionRope {
    /// Length, m. With 0 the tractors are tied straight to the corners of the web.
    pub length: Length<NonNegative>,
    /// Number of parallel ropes for each tractor, all tied to it at the same point. Default: 1.
    #[serde(default = "default_count")]
    pub count: NonZeroU32,
    /// Where the ropes are tied to the tractor. Default: at its centre of mass.
    pub tied_at: Option<TiedAt>,
    /// Where the ropes are tied to the tractor, as x, y, z from its centre along its own axes, m. The z axis points
    /// in the direction of flight, the x axis away from the launch axis. It replaces `tied_at`.
    pub tie_point: Option<[Length; 3]>,
}

fn default_count() -> NonZeroU32 {
    NonZeroU32::MIN
}

/// A place on a tractor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TiedAt {
    /// The centre of mass. The rope exerts no torque, and the tractor is a particle.
    Centre,
    /// The middle of the end that flies last.
    Rear,
    /// The middle of the end that flies first.
    Front,
}

/// `[[tractors]]`: a tractor that differs from the others. A key that is left out is as in `[tractor]`,
/// `[traction_rope]` and `[launch]`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("allOf" = [
    {"not": {"required": ["tied_at", "tie_point"]}},
    {"not": {"required": ["radial_speed", "spread"]}}
]))]
pub struct TractorOverride {
    /// The corner that the tractor is tied to, counted from 1.
    pub corner: NonZeroU32,
    /// The tractor is a solid cylinder. A size, density or mass that is left out is that of `[tractor.cylinder]`.
    pub cylinder: Option<Cylinder>,
    /// The tractor is a solid sphere.
    pub sphere: Option<Sphere>,
    /// The tractor is a solid box.
    #[serde(rename = "box")]
    pub cuboid: Option<Cuboid>,
    /// The tractor is a mass without size.
    pub particle: Option<Particle>,
    /// Where its ropes are tied. Default: as in `[traction_rope]`.
    pub tied_at: Option<TiedAt>,
    /// Where its ropes are tied, as x, y, z from its centre along its own axes, m. It replaces `tied_at`.
    pub tie_point: Option<[Length; 3]>,
    /// Speed along the launch axis, m/s. Default: as in `[launch]`.
    pub axial_speed: Option<Speed>,
    /// Speed away from the launch axis, m/s. Default: as in `[launch]`.
    pub radial_speed: Option<Speed>,
    /// Angle between its flight and its launch axis, in place of `radial_speed`, rad. Default: as in `[launch]`.
    // none after reading, as in `[launch]`
    #[serde(default, skip_serializing)]
    pub spread: Option<Angle<Splay>>,
    /// Elevation of its launch axis above the horizontal, rad. Default: as in `[launch]`.
    pub elevation: Option<Angle<QuarterTurns>>,
    /// Azimuth of its launch axis, anticlockwise from x, rad. Default: as in `[launch]`.
    pub azimuth: Option<Angle>,
    /// Time from the start to its launch, s. Until then it stays in place. Default: 0 s.
    pub delay: Option<Time<NonNegative>>,
}

impl TractorOverride {
    /// The shape given here. A cylinder takes the sizes that are left out from `base`.
    pub(crate) fn body(&self, base: Option<&Body>) -> Option<Body> {
        let cylinder = self.cylinder.as_ref().map(|cylinder| match base {
            Some(Body::Cylinder(base)) => Body::Cylinder(cylinder.over(base)),
            _ => Body::Cylinder(cylinder.clone()),
        });
        cylinder
            .or_else(|| self.sphere.clone().map(Body::Sphere))
            .or_else(|| self.cuboid.clone().map(Body::Box))
            .or_else(|| self.particle.clone().map(Body::Particle))
    }
}

//! `[traction_rope]`, `[[tractors]]`: what ties the tractors to the web, and what is different about one of them.
//!
//! Where a rope is tied to a tractor:
//!
//! ```text
//!                 z, the way it flies                front   middle of the end that flies first
//!            ┌──┬──┐                                 centre  centre of mass: the rope turns nothing, and the
//!            │     │                                         tractor is a particle
//!   x, away  │  +──┼─▶ x                             rear    middle of the end that flies last
//!   from the │     │                                 tie_point  anywhere: [x, y, z] from the centre
//!   axis     └──┴──┘
//!               │ rope
//! ```

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::body::{Body, Cuboid, Cylinder, Particle, Sphere};
use crate::interval::{NonNegative, QuarterTurns};
use crate::quantity::{Angle, Length, Speed, Time};

/// `[traction_rope]`: from a web's corner to its tractor.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["tied_at", "tie_point"]}))]
pub struct TractionRope {
    /// Length, m; 0 ties the tractors straight to the web's corners.
    pub length: Length<NonNegative>,
    /// Parallel ropes a tractor; all are tied to it at the same point.
    #[serde(default = "default_count")]
    pub count: NonZeroU32,
    /// Where it is tied to the tractor. Default: at its centre.
    pub tied_at: Option<TiedAt>,
    /// Where it is tied to the tractor, from its centre along its axes x, y, z, m: z the way it flies, x away from the
    /// launch axis.
    pub tie_point: Option<[Length; 3]>,
}

fn default_count() -> NonZeroU32 {
    NonZeroU32::MIN
}

/// A place on a tractor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TiedAt {
    /// Its centre of mass: no rope turns it, and it is a particle.
    Centre,
    /// The middle of the end that flies last.
    Rear,
    /// The middle of the end that flies first.
    Front,
}

/// `[[tractors]]`: what is different about one tractor. What is left out is as in `[tractor]`, `[traction_rope]` and
/// `[launch]`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("not" = {"required": ["tied_at", "tie_point"]}))]
pub struct TractorOverride {
    /// The corner it is tied to, from 1.
    pub corner: NonZeroU32,
    /// A solid cylinder.
    pub cylinder: Option<Cylinder>,
    /// A solid sphere.
    pub sphere: Option<Sphere>,
    /// A solid box.
    #[serde(rename = "box")]
    pub cuboid: Option<Cuboid>,
    /// A mass without size.
    pub particle: Option<Particle>,
    /// Where its rope is tied.
    pub tied_at: Option<TiedAt>,
    /// Where its rope is tied, from its centre along its axes x, y, z, m.
    pub tie_point: Option<[Length; 3]>,
    /// Speed along the launch axis, m/s.
    pub axial_speed: Option<Speed>,
    /// Speed away from the launch axis, m/s.
    pub radial_speed: Option<Speed>,
    /// Elevation of its axis above the horizontal.
    pub elevation: Option<Angle<QuarterTurns>>,
    /// Azimuth of its axis, anticlockwise from x.
    pub azimuth: Option<Angle>,
    /// How long it stays where it is before it is launched, s. Default: not at all.
    pub delay: Option<Time<NonNegative>>,
}

impl TractorOverride {
    /// Its own shape; what a cylinder leaves out is taken from `base`.
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

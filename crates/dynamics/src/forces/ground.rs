//! Ground: a level plane that pushes bodies that sink into it, and rubs against those that slide.
//!
//! ```text
//! p  = h - z                             how deep, m;  p' = -v_z
//! N  = max(0, k p + c p')                where p > 0, else 0
//! F  = N e_z - min(mu N, m |v_t|/(2 dt)) v_t/|v_t|      v_t: the velocity along the plane
//! ```
//!
//! Penalty contact (Cundall & Strack, Geotechnique 29, 1979). Each node has a spring of its own, k = m omega^2, so that
//! all bounce within the same time pi/omega, which is chosen and not a property of any soil: a node that arrives at v
//! sinks by v/omega. c = 2 xi m omega from the coefficient of restitution e (Schwager & Poschel, Granular Matter 9, 2007,
//! eq. (22)):
//!
//! ```text
//! e = exp(-(xi / s) (pi - atan2(2 xi s, s^2 - xi^2))),    s = sqrt(1 - xi^2)
//! ```
//!
//! Coulomb's friction is bounded by what halves the sliding within a step, so that it never reverses it: what is pushed
//! along by less than mu N creeps, by 2 dt F/m, micrometres a second. Next to p = 0 the spring is that of
//! [`rope_tension`](super::rope_tension), for the same reason. A rigid body touches with points of its hull. Stored in
//! `ground`, lost in `ground_friction`; docs/theory/ground.md.

use glam::DVec3;

use super::element::ElementForces;
use super::rope_tension::ramp;
use crate::body::{Body, Rotation};

/// A level plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Ground {
    /// Its height in the world, m.
    pub height: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Nodes that it can touch.
    pub nodes: Vec<Footing>,
    /// Points of rigid bodies that it can touch.
    pub hulls: Vec<Hull>,
}

/// A node on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footing {
    /// Which node.
    pub node: usize,
    /// How far it reaches below its node, m.
    pub radius: f64,
    /// Its spring and damper.
    pub spring: Spring,
}

/// A point of a rigid body on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hull {
    /// Which body, an index in [`SystemParts::bodies`](crate::parts::SystemParts::bodies).
    pub body: usize,
    /// From its centre, along its principal axes, m.
    pub arm: DVec3,
    /// How far it reaches below that point, however the body is turned, m: of a sphere about it.
    pub radius: f64,
    /// Its spring and damper.
    pub spring: Spring,
}

/// The spring and damper of one contact point with the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Stiffness k, N/m.
    pub stiffness: f64,
    /// Damping c, N s/m.
    pub damping: f64,
    /// Effective mass at the contact point, kg.
    pub mass: f64,
}

impl Spring {
    /// A spring under which `mass`, kg, rebounds within `contact_time`, s, with this coefficient of restitution, 0.14 to 1.
    pub fn bouncing(mass: f64, contact_time: f64, restitution: f64) -> Spring {
        let frequency = std::f64::consts::PI / contact_time;
        let damping = 2.0 * damping_ratio(restitution) * mass * frequency;
        Spring { stiffness: mass * frequency * frequency, damping, mass }
    }
}

/// Coefficient of restitution of a spring and damper that never pull; see the head of the file. `ratio` from 0 to 1.
pub fn restitution(ratio: f64) -> f64 {
    let s = (1.0 - ratio * ratio).sqrt();
    if s == 0.0 {
        return libm::exp(-2.0);
    }
    let angle = libm::atan2(2.0 * ratio * s, s * s - ratio * ratio);
    libm::exp(-(ratio / s) * (std::f64::consts::PI - angle))
}

/// The damping ratio that gives the restitution `asked`, by bisection; 1 where `asked` is below exp(-2).
fn damping_ratio(asked: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if restitution(middle) > asked { low = middle } else { high = middle }
    }
    high
}

impl Ground {
    /// Force on a point at `x`, m, that moves at `v`, m/s, in steps of `dt`, s: elastic and dissipative part, N.
    pub fn push(&self, spring: &Spring, x: DVec3, v: DVec3, dt: f64) -> ElementForces<1> {
        let depth = self.height - x.z;
        if depth <= 0.0 {
            return ElementForces::NONE;
        }
        let swept = (v.z * dt).abs();
        let elastic = spring.stiffness * ramp(depth, swept);
        // the damper begins with a jump: at the first step it makes up for the part of a step that it has acted so far
        let acted = if depth < swept { 0.5 + depth / swept } else { 1.0 };
        let normal = (elastic - acted * spring.damping * v.z).max(0.0);
        let sliding = DVec3::new(v.x, v.y, 0.0);
        let speed = sliding.length();
        let rubbing = (self.friction * normal).min(0.5 * spring.mass * speed / dt);
        let along = if speed > 0.0 { sliding * (rubbing / speed) } else { DVec3::ZERO };
        ElementForces { elastic: [DVec3::Z * elastic], dissipative: [DVec3::Z * (normal - elastic) - along] }
    }

    /// Elastic energy in the spring of a point at `x`, m, in J.
    pub(crate) fn energy(&self, spring: &Spring, x: DVec3) -> f64 {
        let depth = (self.height - x.z).max(0.0);
        0.5 * spring.stiffness * depth * depth
    }
}

impl Footing {
    /// The point that touches first, m, of a node at `x`.
    pub(crate) fn lowest(&self, x: DVec3) -> DVec3 {
        x - self.radius * DVec3::Z
    }
}

impl Hull {
    /// A contact point of `body`, which has `mass`, kg: the lowest point of a sphere of `radius`, m, at `arm`, m, from the
    /// centre. `spring` makes the spring and damper of an effective mass, kg. That mass includes rotation: it is
    /// m / (1 + r^2/g^2), with r the distance from the centre and g the least radius of gyration.
    pub fn new(index: usize, body: &Body, mass: f64, arm: DVec3, radius: f64, spring: impl Fn(f64) -> Spring) -> Hull {
        let gyration_squared = body.inertia.min_element() / mass;
        let reach = arm.length() + radius;
        Hull { body: index, arm, radius, spring: spring(mass / (1.0 + reach * reach / gyration_squared)) }
    }

    /// How far from the body's centre it touches at most, m.
    pub(crate) fn reach(&self) -> f64 {
        self.arm.length() + self.radius
    }

    /// Where it touches, from the body's centre, m.
    pub fn offset(&self, rotation: &Rotation) -> DVec3 {
        rotation.orientation * self.arm - self.radius * DVec3::Z
    }

    /// Where it is, m, and how it moves, m/s, on a body whose centre is at `x` and moves at `v`.
    pub(crate) fn moving(&self, body: &Body, rotation: &Rotation, x: DVec3, v: DVec3) -> (DVec3, DVec3) {
        let arm = self.offset(rotation);
        (x + arm, v + body.angular_velocity(rotation).cross(arm))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn restitution_is_that_of_the_linear_dashpot_and_found_again() {
        // without damping 1, critically damped exp(-2)
        assert_eq!(restitution(0.0), 1.0);
        assert!((restitution(0.999_999) - libm::exp(-2.0)).abs() < 1e-4);
        for asked in [0.14, 0.3, 0.7, 1.0] {
            assert!((restitution(damping_ratio(asked)) - asked).abs() < 1e-9, "{asked}");
        }
    }

    #[test]
    fn it_pushes_and_never_pulls_and_rubs_against_sliding() {
        let spring = Spring { stiffness: 1e4, damping: 50.0, mass: 1.0 };
        let ground = Ground { height: 0.0, friction: 0.4, nodes: Vec::new(), hulls: Vec::new() };
        let total = |z: f64, v: DVec3| {
            let forces = ground.push(&spring, DVec3::Z * z, v, 1e-5);
            forces.elastic[0] + forces.dissipative[0]
        };
        assert_eq!(total(1e-3, -5.0 * DVec3::Z), DVec3::ZERO);
        assert!((total(-0.01, DVec3::ZERO) - 100.0 * DVec3::Z).length() < 1e-12);
        // leaving fast: the damper would pull
        assert_eq!(total(-0.01, 5.0 * DVec3::Z), DVec3::ZERO);
        let sliding = total(-0.01, DVec3::new(3.0, 4.0, 0.0));
        assert!((sliding - DVec3::new(-24.0, -32.0, 100.0)).length() < 1e-12, "{sliding}");
    }
}

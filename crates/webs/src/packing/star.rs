//! A star: radial folds, a ridge for each arm and a valley between two, wound round the web's middle.
//!
//! The middle, within r_1, lies flat at half its size. A point farther out, at polar (r, theta), is wound up along a
//! logarithmic spiral and moved up or down by the folds:
//!
//! ```text
//! s = v (r - r_1)      rho = r_1 / 2 + g s      angle = theta + sqrt(1 - g^2) / g ln(2 rho / r_1)
//! z = A(r) w(arms (theta - theta_1))            A = min(height / 2, kappa (r - r_1)),   w: triangle wave from 1 to -1
//! ```
//! The spiral has the speed v in r and the folds at most kappa; round the axis lengths change by at most rho / r <= 1/2
//! and by 2 arms A / (pi r) <= 2 arms kappa / pi. With v^2 = 3/8 and kappa^2 (1 + (2 arms / pi)^2) = 3/8 the squares of
//! all four sum up to 1. They are the entries of the derivative (its Frobenius norm bounds its largest singular value):
//! no two points of the plane come to lie farther apart than they were. The rim keeps its azimuth, the middle is turned.
//!
//! The windings grow from half the container's radius to all of it. On one turn a radius crosses the sheets of all
//! folds, two an arm, so that a turn is at least 2 arms spacing wide.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3, dvec3};

use super::Container;

/// Squared speed of the winding, and the squared share of the folds.
const SHARE: f64 = 0.375;

/// The folds of a star.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Arms {
    /// Number of arms.
    pub count: f64,
    /// Azimuth of the first, rad.
    pub first: f64,
}

/// Winds a web of this radius, m, into a container; layers lie at least `spacing` apart, m.
pub(super) fn fold(reach: f64, arms: Arms, container: &Container, spacing: f64) -> impl Fn(DVec2) -> DVec3 + use<> {
    let speed = SHARE.sqrt();
    let per_arm = 2.0 * arms.count / PI;
    let slope = (SHARE / (1.0 + per_arm * per_arm)).sqrt();
    let radius = container.radius().max(least_radius(reach, arms.count, spacing)).min(0.5 * reach);
    let growth = 0.5 * radius / (speed * (reach - radius));
    let turning = (1.0 - growth * growth).sqrt() / growth;
    let turned = move |rho: f64| turning * libm::log(2.0 * rho / radius);
    let rim = turned(radius);
    let depth = 0.5 * container.height();
    move |point| {
        let r = point.length();
        let wound = (r - radius).max(0.0);
        let rho = if wound > 0.0 { 0.5 * radius + growth * speed * wound } else { 0.5 * r };
        let theta = libm::atan2(point.y, point.x);
        let angle = theta + turned(rho.max(0.5 * radius)) - rim;
        let z = depth.min(slope * wound) * triangle(arms.count * (theta - arms.first));
        dvec3(rho * libm::cos(angle), rho * libm::sin(angle), z)
    }
}

/// The radius at which the innermost turn is as wide as its layers, m: 2 pi (R / 2) g >= 2 arms spacing with
/// g = R / (2 v (reach - R)).
fn least_radius(reach: f64, arms: f64, spacing: f64) -> f64 {
    let k = 4.0 * arms * spacing * SHARE.sqrt() / PI;
    (0.25 * k * k + k * reach).sqrt() - 0.5 * k
}

/// A wave of period 2 pi, 1 at 0, -1 at pi, straight in between.
fn triangle(x: f64) -> f64 {
    let turns = x / TAU;
    1.0 - 4.0 * (turns - turns.round()).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wave() {
        for (x, w) in [(0.0, 1.0), (PI, -1.0), (0.5 * PI, 0.0), (-0.5 * PI, 0.0), (TAU, 1.0), (-5.0 * PI, -1.0)] {
            assert!((triangle(x) - w).abs() < 1e-12, "{x}");
        }
    }

    #[test]
    fn middle_arms_and_rim_lie_where_the_star_says() {
        let container = Container::Cylinder { radius: 0.4, height: 0.3 };
        let place = fold(3.0, Arms { count: 5.0, first: 0.3 }, &container, 0.001);
        assert_eq!(place(DVec2::ZERO), DVec3::ZERO);
        assert!((place(DVec2::new(0.2, 0.1)).length() - 0.5 * DVec2::new(0.2, 0.1).length()).abs() < 1e-12);
        let polar = |r: f64, theta: f64| DVec2::new(r * libm::cos(theta), r * libm::sin(theta));
        let arm = place(polar(3.0, 0.3));
        assert!(arm.distance(polar(0.4, 0.3).extend(0.15)) < 1e-12, "{arm}");
        let valley = place(polar(3.0, 0.3 + 0.2 * PI));
        assert!(valley.distance(polar(0.4, 0.3 + 0.2 * PI).extend(-0.15)) < 1e-12, "{valley}");
    }

    #[test]
    fn neighbouring_turns_have_room_for_their_layers() {
        // in a container that is too narrow the star is as wide as it must be
        let container = Container::Cylinder { radius: 0.05, height: 1.0 };
        let (arms, spacing) = (6.0, 0.004);
        let place = fold(2.5, Arms { count: arms, first: 0.0 }, &container, spacing);
        // along a radius of the flat web, where the winding has come round once
        let inner = place(DVec2::new(0.7, 0.0)).truncate();
        let turned = |r: f64| {
            let to = place(DVec2::new(r, 0.0)).truncate();
            libm::atan2(inner.perp_dot(to), inner.dot(to))
        };
        // the angle falls through zero once a turn
        let (mut r, mut was) = (0.71, turned(0.71));
        while !(was < 0.0 && turned(r) >= 0.0) {
            was = turned(r);
            r += 1e-4;
        }
        let width = place(DVec2::new(r, 0.0)).truncate().length() - inner.length();
        assert!(width >= 2.0 * arms * spacing, "{width}");
    }
}

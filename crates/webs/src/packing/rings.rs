//! The pattern `zigzag` along rings: the web's middle lies flat on the floor, and the rest goes up and down about it in
//! concentric walls.
//!
//! A point of the flat web with polar coordinates (r, theta) is mapped to (rho(r), theta, z(r)) in cylindrical ones.
//! The line (rho, z) has unit speed in r, so that radial lengths stay. As rho(0) = 0, rho <= r, and lengths round the
//! axis shrink by rho / r <= 1. The two directions stay normal to each other, so no rope is stretched.

use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3, dvec3};

use super::Container;
use super::bend::Serpentine;

/// The map that folds a web of radius `reach`, m, into a container, with walls `spacing` apart, m.
pub(super) fn fold(reach: f64, container: &Container, spacing: f64) -> impl Fn(DVec2) -> DVec3 + use<> {
    let (floor, walls) = floor_and_walls(reach, container, spacing);
    move |point| {
        let radius = point.length();
        if radius <= floor {
            return point.extend(0.0);
        }
        let wall = walls.place(radius - floor, 0.0);
        let outwards = point * ((floor + wall.y) / radius);
        dvec3(outwards.x, outwards.y, wall.x)
    }
}

/// The radius of the floor, m, and the walls, as few as the height allows, so that the floor is as wide as possible.
///
/// For n walls with a straight length a, 2 r apart, joined by half circles of radius r = spacing / 2:
/// reach - floor = n a + (n - 1) pi r, and floor + 2 r (n - 1) is the container's radius. The number n is odd, so that
/// the web's rim lies at the top.
fn floor_and_walls(reach: f64, container: &Container, spacing: f64) -> (f64, Serpentine) {
    let (radius, height) = (container.radius(), container.height());
    let least = if reach - radius <= height {
        1.0
    } else {
        // from a + spacing <= height and the two equations above
        let per_bend = spacing * (1.0 - FRAC_PI_2);
        (reach - radius - per_bend) / (height - spacing - per_bend)
    };
    let odd = |count: f64| 2.0 * (0.5 * (count - 1.0)).ceil() + 1.0;
    let most = 2.0 * (0.5 * radius / spacing).floor() + 1.0;
    // in a container too low for the bends no number of walls fits
    let count = if least > 0.0 { odd(least).min(most) } else { most };
    let floor = (radius - (count - 1.0) * spacing).min(reach);
    let wall = (reach - floor - (count - 1.0) * FRAC_PI_2 * spacing) / count;
    (floor, Serpentine::of(count, wall.max(0.0), spacing))
}

//! The outline of a rigid body in the camera's plane.

use glam::{DQuat, DVec2, DVec3};
use netcast_results::BodyShape;

use super::camera::Camera;

/// Corners of the polygon that approximates a circle.
const SIDES: u32 = 24;

/// The projection of a body with an orientation: the corners of a convex polygon about the body's centre, m,
/// anticlockwise. Empty for a particle.
pub(crate) fn outline(shape: &BodyShape, orientation: DQuat, camera: &Camera) -> Vec<DVec2> {
    let half = 0.5 * DVec3::from_array(shape.size_m());
    let round = |side: u32| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(side) / f64::from(SIDES));
        DVec2::new(cos, sin)
    };
    let ends = |rim: Vec<DVec2>| {
        [-1.0, 1.0].into_iter().flat_map(move |z| rim.clone().into_iter().map(move |at| at.extend(z)))
    };
    let seen = |corner: DVec3| camera.project(orientation * (half * corner));
    match shape {
        BodyShape::Particle => Vec::new(),
        BodyShape::Sphere { .. } => (0..SIDES).map(|side| half.x * round(side)).collect(),
        BodyShape::Cylinder { .. } => hull(ends((0..SIDES).map(round).collect()).map(seen).collect()),
        BodyShape::Box { .. } => {
            let square = [DVec2::ONE, DVec2::new(-1.0, 1.0), DVec2::NEG_ONE, DVec2::new(1.0, -1.0)];
            hull(ends(square.to_vec()).map(seen).collect())
        }
    }
}

/// The convex hull of some points, anticlockwise (Andrew's monotone chain, 1979).
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let chain = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && (b - a).perp_dot(point - b) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        // the last point of each chain is the first of the other
        chain.pop();
        chain
    };
    let lower = chain(&mut points.iter().copied());
    let upper = chain(&mut points.iter().rev().copied());
    [lower, upper].concat()
}

#[cfg(test)]
mod tests {
    use super::super::camera::View;
    use super::*;

    fn area(polygon: &[DVec2]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        0.5 * polygon.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>()
    }

    /// Cauchy: the projected area of a convex body, averaged over all directions, is a quarter of its surface.
    #[test]
    fn the_mean_area_of_an_outline_is_a_quarter_of_the_surface() {
        // the camera looks back along z
        let camera = Camera::new(View::Ahead, DVec3::Z);
        let shapes = [
            (BodyShape::Box { size_m: [1.0, 2.0, 3.0] }, 22.0),
            (BodyShape::Cylinder { diameter_m: 2.0, height_m: 3.0 }, 8.0 * std::f64::consts::PI),
            (BodyShape::Sphere { diameter_m: 2.0 }, 4.0 * std::f64::consts::PI),
        ];
        for (shape, surface) in shapes {
            let (mut sum, mut count) = (0.0, 0.0);
            // directions spread evenly over the sphere
            for step in 0..4000 {
                let z = 1.0 - (2.0 * f64::from(step) + 1.0) / 4000.0;
                let turn = 2.399963229728653 * f64::from(step);
                let across = (1.0 - z * z).sqrt();
                let towards = DVec3::new(across * libm::cos(turn), across * libm::sin(turn), z);
                sum += area(&outline(&shape, DQuat::from_rotation_arc(towards, DVec3::Z), &camera));
                count += 1.0;
            }
            let ratio = 4.0 * sum / count / surface;
            assert!((ratio - 1.0).abs() < 0.015, "{shape:?}: {ratio}");
        }
    }
}

//! Plane geometry: unit vectors with exact mirror images, and the vector area of a polygon.

use std::cmp::Ordering;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use glam::{DVec2, DVec3};

/// Unit vector at 30 + 60 k degrees from the x axis, anticlockwise. Opposite directions are exact negatives.
pub(crate) fn compass(k: usize) -> DVec3 {
    let x = 0.75_f64.sqrt();
    match k % 6 {
        0 => DVec3::new(x, 0.5, 0.0),
        1 => DVec3::Y,
        2 => DVec3::new(-x, 0.5, 0.0),
        3 => DVec3::new(-x, -0.5, 0.0),
        4 => DVec3::NEG_Y,
        _ => DVec3::new(x, -0.5, 0.0),
    }
}

/// Unit vector at 60 k degrees from the x axis, anticlockwise: the direction of corner k of a plate. Opposite
/// directions are exact negatives.
pub(crate) fn hexagon_corner(k: usize) -> DVec2 {
    let y = 0.75_f64.sqrt();
    match k % 6 {
        0 => DVec2::X,
        1 => DVec2::new(0.5, y),
        2 => DVec2::new(-0.5, y),
        3 => DVec2::NEG_X,
        4 => DVec2::new(-0.5, -y),
        _ => DVec2::new(0.5, -y),
    }
}

/// Unit vector at 360 k / n degrees from the y axis, anticlockwise. Quarter turns and mirror images about the axes and
/// the diagonals are exact.
pub(crate) fn direction(k: usize, n: usize) -> DVec3 {
    let (quarter, rest) = (4 * k / n % 4, 4 * k % n);
    let eighth = |part: usize| libm::sincos(FRAC_PI_2 * (part as f64 / n as f64));
    let (sin, cos) = match (2 * rest).cmp(&n) {
        Ordering::Less => eighth(rest),
        Ordering::Equal => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
        Ordering::Greater => {
            let (sin, cos) = eighth(n - rest);
            (cos, sin)
        }
    };
    let (x, y) = match quarter {
        0 => (-sin, cos),
        1 => (-cos, -sin),
        2 => (sin, -cos),
        _ => (cos, sin),
    };
    DVec3::new(x, y, 0.0)
}

/// Vector area S = 1/2 sum r_i x r_(i+1) of the closed polygon through these vertices, m^2. Its magnitude is the area
/// of a flat polygon; in a folded polygon, areas with opposite normals cancel. The vectors r_i begin at the first
/// vertex, so that a polygon far from the origin loses no digits.
pub fn vector_area(vertices: &[DVec3]) -> DVec3 {
    let Some((&first, rest)) = vertices.split_first() else { return DVec3::ZERO };
    rest.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum::<DVec3>() * 0.5
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn directions_divide_the_circle_evenly_and_have_exact_mirror_images() {
        for n in 3..50 {
            for k in 0..n {
                let (sin, cos) = libm::sincos(TAU * k as f64 / n as f64);
                assert!(direction(k, n).distance(DVec3::new(-sin, cos, 0.0)) < 1e-14, "{k} of {n}");
                let (left, right) = (direction(k, n), direction(n - k, n));
                assert_eq!((left.x, left.y), (-right.x, right.y), "{k} of {n}");
            }
        }
        assert_eq!(direction(0, 7), DVec3::Y);
        assert_eq!(direction(3, 8), -direction(7, 8));
    }

    #[test]
    fn a_rectangle_has_its_area_and_its_mirror_image_the_opposite() {
        let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)].map(|(x, y)| DVec3::new(x, y, 7.0));
        assert_eq!(vector_area(&corners), DVec3::new(0.0, 0.0, 6.0));
        let mirrored: Vec<DVec3> = corners.iter().rev().copied().collect();
        assert_eq!(vector_area(&mirrored), DVec3::new(0.0, 0.0, -6.0));
    }

    #[test]
    fn a_bow_tie_and_two_points_have_no_vector_area() {
        let bow = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        assert_eq!(vector_area(&bow), DVec3::ZERO);
        assert_eq!(vector_area(&bow[..2]), DVec3::ZERO);
        assert_eq!(vector_area(&[]), DVec3::ZERO);
    }
}

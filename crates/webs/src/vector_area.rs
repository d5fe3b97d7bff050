//! Area of a closed polygon in space.

use glam::DVec3;

/// Vector area S = 1/2 sum r_i x r_(i+1) of the closed polygon through these vertices, m^2; taken about the first
/// vertex, so that a polygon far from the origin loses no digits. Its magnitude is the area where the polygon is
/// flat; folds cancel.
pub fn vector_area(vertices: &[DVec3]) -> DVec3 {
    let Some((&first, rest)) = vertices.split_first() else { return DVec3::ZERO };
    rest.windows(2).map(|pair| (pair[0] - first).cross(pair[1] - first)).sum::<DVec3>() * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rectangle_and_its_mirror_image() {
        let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)].map(|(x, y)| DVec3::new(x, y, 7.0));
        assert_eq!(vector_area(&corners), DVec3::new(0.0, 0.0, 6.0));
        let mirrored: Vec<DVec3> = corners.iter().rev().copied().collect();
        assert_eq!(vector_area(&mirrored), DVec3::new(0.0, 0.0, -6.0));
    }

    #[test]
    fn a_bow_tie_cancels_and_two_points_enclose_nothing() {
        let bow = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| DVec3::new(x, y, 0.0));
        assert_eq!(vector_area(&bow), DVec3::ZERO);
        assert_eq!(vector_area(&bow[..2]), DVec3::ZERO);
        assert_eq!(vector_area(&[]), DVec3::ZERO);
    }
}

//! Mean position of some nodes and vector area of a polygon.

use glam::DVec3;

/// Vector area of a closed polygon, m^2: half the sum of r_i x r_(i+1) over its vertices r_i, m.
pub(crate) fn vector_area(mut vertices: impl Iterator<Item = DVec3>) -> DVec3 {
    let Some(first) = vertices.next() else { return DVec3::ZERO };
    let mut sum = DVec3::ZERO;
    let mut last = first;
    for vertex in vertices.chain([first]) {
        // relative to the first vertex: large common offsets cancel before they are multiplied
        sum += (last - first).cross(vertex - first);
        last = vertex;
    }
    0.5 * sum
}

/// Mean of `of` over `nodes`, which must not be empty.
pub(crate) fn mean(nodes: &[usize], of: impl Fn(usize) -> DVec3) -> DVec3 {
    match nodes {
        [node] => of(*node),
        _ => nodes.iter().map(|&n| of(n)).sum::<DVec3>() / nodes.len() as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tilted_rectangle_far_from_the_origin_has_its_area() {
        let (along, across) = (DVec3::new(3.0, 0.0, 4.0), DVec3::new(0.0, 2.0, 0.0));
        let far = DVec3::new(1e6, -2e6, 3e6);
        let area = vector_area([far, far + along, far + along + across, far + across].into_iter());
        assert!((area.length() - 10.0).abs() < 1e-8);
        assert!((area.dot(DVec3::Z) - 6.0).abs() < 1e-8);
    }
}

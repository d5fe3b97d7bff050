//! The ground under a web: footings of nodes and hulls of bodies, each with its contact spring.

use std::f64::consts::TAU;

use glam::DVec3;
use netcast_dynamics::forces::ground::{Footing, Ground, Hull, Spring};
use netcast_scenario::quantity::Length;
use netcast_scenario::{Diagnostics, Shape};

use super::draft::Draft;

/// Largest height of the muzzle above the ground for which a wind profile is made, m.
const HIGHEST_MUZZLE: f64 = 2000.0;
/// Points on each rim of a cylinder.
const RIM: usize = 8;

/// Adds the ground to the parts of the system. Writes a default height into the scenario: that of the lowest point.
///
/// # Errors
/// A node or body that starts below the ground.
pub fn lay(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, bodies: placed, parts, state, .. } = draft;
    let Some(asked) = &mut scenario.environment.ground else { return Ok(()) };
    let spring = |mass: f64| Spring::bouncing(mass, asked.contact_time.si(), asked.restitution.si());
    let (mut nodes, mut hulls) = (Vec::new(), Vec::new());
    for (index, body) in parts.bodies.iter().enumerate() {
        let (mass, of_it) = (parts.mass[body.centre], placed.iter().find(|placed| placed.rigid == Some(index)));
        let points = match of_it.map(|placed| placed.solid.shape) {
            Some(Shape::Sphere { diameter_m }) => {
                hulls.push(Hull::new(index, body, mass, DVec3::ZERO, 0.5 * diameter_m, spring));
                continue;
            }
            Some(Shape::Cylinder { diameter_m, height_m }) => rims(diameter_m, height_m),
            Some(Shape::Box { size_m }) => corners(size_m),
            // a plate touches the ground at its nodes
            Some(Shape::Particle { .. }) | None => body.ties.iter().map(|tie| tie.arm).collect(),
        };
        hulls.extend(points.into_iter().map(|arm| Hull::new(index, body, mass, arm, 0.0, spring)));
    }
    let is_centre = |node: usize| parts.bodies.iter().any(|body| body.centre == node);
    let movable = (0..parts.mass.len()).filter(|&node| parts.mass[node] > 0.0 && !parts.held[node] && !is_centre(node));
    let mut radius = vec![0.0f64; parts.mass.len()];
    for sitting in placed.iter().filter(|placed| placed.rigid.is_none()) {
        radius[sitting.node] = radius[sitting.node].max(sitting.solid.shape.least_reach_m());
    }
    nodes.extend(movable.map(|node| Footing { node, radius: radius[node], spring: spring(parts.mass[node]) }));

    let of_nodes = nodes.iter().map(|at| (at.node, state.position[at.node].z - at.radius));
    let of_hulls = hulls.iter().map(|hull| {
        let centre = parts.bodies[hull.body].centre;
        (centre, (state.position[centre] + hull.offset(&state.rotation[hull.body])).z)
    });
    let (lowest, bottom) =
        of_nodes.chain(of_hulls).fold((0, f64::INFINITY), |one, other| if other.1 < one.1 { other } else { one });
    // held and driven nodes count for the height too, though the ground does not push them
    let all = state.position.iter().zip(&radius).map(|(place, radius)| place.z - radius);
    let height = asked.height.get_or_insert_with(|| Length::constant(all.fold(bottom, f64::min))).si();
    let profiled = scenario.environment.wind.as_mut().filter(|wind| wind.series.is_none());
    if let Some(wind) = profiled {
        wind.muzzle_height.get_or_insert(Length::constant((-height).clamp(0.0, HIGHEST_MUZZLE)));
    }
    if bottom < height {
        let what = if lowest < cut.nodes.len() { cut.node_label(lowest) } else { "a body".to_owned() };
        let message = format!("{what} starts {:.3} m below the ground", height - bottom);
        let help = format!("expected at most \"{bottom:.3} m\"; left out, the lowest point of all is on the ground");
        return Err(document.diagnostic("environment.ground.height", message).with_help(help).into());
    }
    parts.environment.ground = Some(Ground { height, friction: asked.friction.si(), nodes, hulls });
    Ok(())
}

/// Points round both ends of a cylinder about its centre, m, (2 RIM,).
fn rims(diameter: f64, height: f64) -> Vec<DVec3> {
    let angles = (0..RIM).map(|i| libm::sincos(TAU * i as f64 / RIM as f64));
    let around = |(sin, cos): (f64, f64)| {
        [-0.5, 0.5].map(|end| DVec3::new(0.5 * diameter * cos, 0.5 * diameter * sin, end * height))
    };
    angles.flat_map(around).collect()
}

/// The corners of a box about its centre, m, (8,).
fn corners(size: [f64; 3]) -> Vec<DVec3> {
    let side = |corner: usize, axis: usize| if corner >> axis & 1 == 0 { -0.5 } else { 0.5 };
    (0..8).map(|corner| DVec3::from_array(std::array::from_fn(|axis| side(corner, axis) * size[axis]))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_reaches_as_far_as_its_body() {
        let far = |points: &[DVec3]| points.iter().map(|point| point.length()).fold(0.0, f64::max);
        let cylinder = rims(0.6, 0.8);
        assert!(cylinder.len() == 16 && (far(&cylinder) - 0.5).abs() < 1e-15);
        let cuboid = corners([0.2, 0.4, 0.4]);
        assert!(cuboid.len() == 8 && (far(&cuboid) - 0.3).abs() < 1e-15);
        assert!(cuboid.iter().sum::<DVec3>().length() < 1e-15);
    }
}

//! The air around a web: drag and buoyancy of its ropes, canopies and bodies.
//!
//! Ropes drag by class. Canopies drag as triangles, however they are modelled. Bodies drag by their shape: a rigid body in
//! its present orientation, any other in its orientation at launch. A canopy hides a smaller body that sits on it: the pair
//! drags as the canopy alone.

use std::f64::consts::PI;

use glam::{DMat3, DQuat, DVec3};
use netcast_dynamics::air::atmosphere::Medium;
use netcast_dynamics::air::wind::Wind;
use netcast_dynamics::air::{Air, Attitude, BodyDrag};
use netcast_dynamics::forces::body_drag::Shape as DragShape;
use netcast_dynamics::forces::load::Load;
use netcast_dynamics::forces::rope_drag::RopeDrag;
use netcast_dynamics::forces::sheet_drag::SheetDrag;
use netcast_dynamics::launcher::{Launcher, Means, Push};
use netcast_dynamics::state::State;
use netcast_dynamics::system::SystemParts;
use netcast_scenario::interval::{OpenShare, Within};
use netcast_scenario::{Air as WrittenAir, Canopy, Diagnostic, Diagnostics, Document, Shape, Solidity};
use netcast_webs::{Class, CutWeb};

use super::air_outline::AirOutline;
use super::bodies::at_launch;
use super::canopy_parts::triangles;
use super::draft::Draft;
use super::members::{Group, Member, PlacedBody, Role};
use super::throw::frame;
use super::wind::wind;

/// Apothem over side of a regular hexagon: sqrt(3)/2.
const APOTHEM: f64 = 0.866_025_403_784_438_6;
/// Assumed largest speed of a fall, m/s. It enters the bound of the air speed past the net.
const FALL: f64 = 30.0;
/// Assumed largest speed of a part over the largest launch speed: a jerking rope throws light parts.
const JERKED: f64 = 3.0;
/// Least and largest height above the muzzle up to which a wind profile is tabulated, m.
const LOWEST_TOP: f64 = 100.0;
const HIGHEST_TOP: f64 = 3000.0;

/// Adds air, wind, drag and buoyancy to the parts of the system, if the scenario has air.
///
/// # Errors
/// A wind or a solidity that is impossible.
pub fn surround(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, groups, bodies, .. } = &*draft;
    let Some(asked) = &scenario.environment.air else { return Ok(()) };
    let duration = scenario.solve.run_time().unwrap_or(0.0);
    let launch_speed = launch_speed(&draft.parts, &draft.state);
    let drawn_solidity = drawn_solidity(draft);
    let wind = wind(document, scenario, duration, (launch_speed * duration).clamp(LOWEST_TOP, HIGHEST_TOP));
    let (wind, solidity) = both(wind, solidity(document, asked, drawn_solidity))?;
    let medium = match (asked.density, asked.viscosity) {
        (Some(density), Some(viscosity)) => Medium::uniform(density.si(), viscosity.si()),
        _ => Medium::standard(asked.altitude.map_or(0.0, |altitude| altitude.si())),
    };
    let rope = |group: &Group| {
        let solidity = solidity.filter(|_| group.class != Class::Traction).unwrap_or(0.0);
        let normal = asked.normal_coefficient.map(|coefficient| coefficient.si());
        Some(RopeDrag { diameter: group.diameter?, normal, tangential: asked.tangential_coefficient.si(), solidity })
    };
    let porosity = scenario.canopy.as_ref().map_or(0.0, Canopy::porosity);
    let coefficient = (1.0 - porosity) * asked.sheet_coefficient.si();
    let canopy_side = scenario.canopy.as_ref().map_or(0.0, Canopy::side_m);
    let reach = |shape: &Shape| shape.in_air().map_or(0.0, |shape| shape.radius_m());
    let is_hidden = |body: &&PlacedBody| body.role != Role::Tractor && reach(&body.solid.shape) < APOTHEM * canopy_side;
    let is_sizeless = |body: &&PlacedBody| !is_hidden(body) && drag_shape(&body.solid.shape).is_none();
    let triangles = triangles(&draft.canopies.sheets, cut);
    let dragging = bodies.iter().filter(|body| !is_hidden(body));
    let air = Air {
        ropes: groups.iter().map(rope).collect(),
        sheets: triangles.iter().map(|&nodes| SheetDrag { nodes, coefficient, area: area(cut, nodes) }).collect(),
        bodies: dragging.filter_map(|body| body_drag(draft, body)).collect(),
        added_mass: asked.added_mass.si(),
        fastest: JERKED * launch_speed + fastest(&wind) + FALL,
        ..Air::new(medium, wind)
    };
    let lift = medium.density(0.0) * draft.parts.environment.gravity.length();
    let buoyed = if asked.buoyancy == Some(true) { buoy(draft, &triangles, lift) } else { Buoyancy::default() };
    let outline = AirOutline {
        launch_speed,
        drawn_solidity,
        solidity,
        hidden: bodies.iter().filter(is_hidden).count(),
        sizeless: bodies.iter().filter(is_sizeless).count(),
        buoyancy: buoyed.all,
        web_buoyancy: buoyed.web,
    };
    draft.parts.loads.extend(buoyed.loads);
    draft.parts.environment.air = Some(air);
    draft.air = Some(outline);
    Ok(())
}

/// Both values, or the diagnostics of both.
fn both<A, B>(one: Result<A, Diagnostics>, other: Result<B, Diagnostic>) -> Result<(A, B), Diagnostics> {
    match (one, other) {
        (Ok(one), Ok(other)) => Ok((one, other)),
        (Err(Diagnostics(mut wrong)), other) => {
            wrong.extend(other.err());
            Err(Diagnostics(wrong))
        }
        (Ok(_), Err(wrong)) => Err(wrong.into()),
    }
}

/// Area of a triangle as drawn, m^2.
fn area(cut: &CutWeb, nodes: [usize; 3]) -> f64 {
    let [a, b, c] = nodes.map(|node| cut.nodes[node]);
    0.5 * (b - a).cross(c - a).length()
}

/// The largest speed at which anything is thrown or driven, m/s. If the work of a tube is unknown, its largest force is taken
/// to act along the whole stroke.
fn launch_speed(parts: &SystemParts, state: &State) -> f64 {
    let at_start = state.velocity.iter().map(|velocity| velocity.length());
    let launched = parts.launchers.iter().map(|Launcher { node, by, .. }| match by {
        Means::Velocity(velocity) => velocity.length(),
        Means::Tube(tube) => {
            let (Push::OverStroke(curve) | Push::OverTime(curve)) = &tube.push;
            let most = curve.0.iter().map(|&(_, force)| force).fold(0.0, f64::max);
            let work = tube.push.work(tube.stroke).unwrap_or(most * tube.stroke);
            (2.0 * work / parts.mass[*node]).sqrt()
        }
    });
    let driven = parts.drives.iter().flat_map(|drive| {
        let start = std::iter::once((0.0, state.position[drive.node])).chain(drive.path.iter().copied());
        let legs = start.zip(&drive.path).filter(|(from, to)| to.0 > from.0);
        legs.map(|(from, to)| from.1.distance(to.1) / (to.0 - from.0)).collect::<Vec<_>>()
    });
    at_start.chain(launched).chain(driven).fold(0.0, f64::max)
}

/// An upper bound of the wind speed, m/s.
fn fastest(wind: &Wind) -> f64 {
    let mean = wind.mean.values.iter().copied().fold(0.0, f64::max);
    mean + wind.fluctuation.values.iter().map(|velocity| velocity.length()).fold(0.0, f64::max)
}

/// Solidity of the flat web: projected area of its ropes, without traction ropes, over the area within its outline. None
/// without an outline.
fn drawn_solidity(draft: &Draft) -> Option<f64> {
    let area = draft.cut.web.reference_area().filter(|area| *area > 0.0)?;
    let projected = draft.members.iter().filter_map(|Member { segment, .. }| {
        let group = &draft.groups[segment.group];
        let diameter = group.diameter.filter(|_| group.class != Class::Traction)?;
        let [a, b] = segment.ends.map(|end| draft.cut.nodes[end]);
        Some(a.distance(b) * diameter)
    });
    Some(projected.sum::<f64>() / area)
}

/// The solidity of the screen; none if ropes drag as if alone.
///
/// # Errors
/// A solidity of the web that is unknown or too large for a screen.
fn solidity(document: &Document, asked: &WrittenAir, drawn: Option<f64>) -> Result<Option<f64>, Diagnostic> {
    const KEY: &str = "environment.air.solidity";
    match (asked.solidity, drawn) {
        (None, _) => Ok(None),
        (Some(Solidity::Given(share)), _) => Ok(Some(share.si())),
        (Some(Solidity::Web), Some(drawn)) if OpenShare::INTERVAL.contains(drawn) => Ok(Some(drawn)),
        (Some(Solidity::Web), Some(drawn)) => {
            let message = format!("the web's ropes cover {:.0} % of its outline, too much for a screen", 100.0 * drawn);
            Err(document.diagnostic(KEY, message).with_help("leave it out: each rope then drags as if alone"))
        }
        (Some(Solidity::Web), None) => {
            let message = "the web has no outline, so its solidity is unknown";
            Err(document.diagnostic(KEY, message).with_help("give a number, or `web.graph.outline`"))
        }
    }
}

/// The drag of a body; none for a body without size.
fn body_drag(draft: &Draft, body: &PlacedBody) -> Option<BodyDrag> {
    let Draft { scenario, cut, throws, parts, .. } = draft;
    let shape = drag_shape(&body.solid.shape)?;
    let bound = &draft.canopies.bound;
    let carrying = || bound.iter().position(|bound| bound.body.ties.iter().any(|tie| tie.node == body.node));
    let (node, attitude, shape) = match (body.role, body.rigid) {
        (_, Some(rigid)) => (body.node, Attitude::Body(rigid), shape),
        (Role::Tractor, None) => {
            let corner = cut.web.tractors.iter().position(|&tractor| tractor == body.node)?;
            let turn = at_launch(cut, scenario, throws[corner].as_ref(), corner);
            (body.node, Attitude::Fixed(turn), shape)
        }
        // a part of a rigid canopy turns with it
        (_, None) => match carrying() {
            Some(rigid) => (parts.bodies[rigid].centre, Attitude::Body(rigid), along(&bound[rigid].axes, shape)),
            None => (body.node, Attitude::Fixed(DQuat::from_mat3(&frame(scenario))), shape),
        },
    };
    Some(BodyDrag { node, attitude, shape })
}

/// The shape of a body in the terms of body drag; none for a body without size.
fn drag_shape(shape: &Shape) -> Option<DragShape> {
    Some(match shape.in_air()? {
        Shape::Cylinder { diameter_m: diameter, height_m: height } => DragShape::Cylinder { diameter, height },
        Shape::Sphere { diameter_m } => DragShape::Sphere(diameter_m),
        Shape::Box { size_m } => DragShape::Box(DVec3::from_array(size_m)),
        Shape::Particle { .. } => return None,
    })
}

/// A shape in the axes of the canopy that carries it. They are the axes of the web or a quarter turn from them.
fn along(axes: &DMat3, shape: DragShape) -> DragShape {
    match shape {
        DragShape::Box(sides) => DragShape::Box((axes.transpose() * sides).abs()),
        round => round,
    }
}

/// The buoyancy of a web.
#[derive(Default)]
struct Buoyancy {
    /// Upward forces on the free nodes.
    loads: Vec<Load>,
    /// Buoyancy of the whole net, N.
    all: f64,
    /// Buoyancy of the web without traction ropes and tractors, N.
    web: f64,
}

/// Buoyancy of ropes, canopies and bodies, `lift` in N/m^3. A held node gets no load: it does not move.
fn buoy(draft: &Draft, triangles: &[[usize; 3]], lift: f64) -> Buoyancy {
    let Draft { scenario, cut, groups, members, bodies, parts, .. } = draft;
    let (mut upward, mut of_the_web) = (vec![0.0; parts.mass.len()], 0.0);
    let mut share = |nodes: &[usize], volume: f64, is_web: bool| {
        for &node in nodes {
            upward[node] += lift * volume / nodes.len() as f64;
        }
        of_the_web += if is_web { lift * volume } else { 0.0 };
    };
    for Member { segment, .. } in members {
        let group = &groups[segment.group];
        let section = group.diameter.map_or(0.0, |diameter| 0.25 * PI * diameter * diameter);
        share(&segment.ends, section * segment.rest_length, group.class != Class::Traction);
    }
    let cloth = scenario.canopy.as_ref().map_or(0.0, |canopy| canopy.mass_and_volume().1);
    for nodes in triangles {
        share(nodes, cloth * cut.web.canopies.len() as f64 / triangles.len() as f64, true);
    }
    for body in bodies {
        let volume = body.solid.shape.in_air().map_or(0.0, |shape| shape.volume_m3());
        share(&[body.node], volume, body.role != Role::Tractor);
    }
    let buoyed = upward.iter().enumerate().filter(|&(node, force)| *force > 0.0 && !parts.held[node]);
    let loads = buoyed.map(|(node, &force)| Load { node, force: DVec3::Z * force, ramp: 0.0 }).collect();
    Buoyancy { loads, all: upward.iter().sum(), web: of_the_web }
}

#[cfg(test)]
mod tests {
    use netcast_dynamics::forces::sheet_drag::PLATE;
    use netcast_scenario::Air;

    #[test]
    fn a_canopy_drags_as_a_plate_by_default() {
        assert_eq!(Air::default().sheet_coefficient.si(), PLATE);
    }
}

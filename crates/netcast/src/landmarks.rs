//! The landmarks of a model: the nodes and segments that are measured, and their names.

use glam::DVec3;
use netcast_model::{Model, PlacedBody, Role};
use netcast_results::{
    BodyKind, BodyMark, BodyShape, CanopyMark, Group, Landmark, Landmarks, LinkClass, NamedRope, Support,
};
use netcast_scenario::{Canopy, Shape};

/// The landmarks of a model.
pub fn landmarks(model: &Model) -> Landmarks {
    let web = &model.cut.web;
    let landmark = |name: &str, nodes: Vec<usize>, is_group: bool| Landmark {
        name: name.to_owned(),
        is_group,
        segments: model.ropes_at(&nodes),
        nodes,
    };
    let mut points: Vec<Landmark> =
        model.points().into_iter().map(|(name, node)| landmark(&name, vec![node], false)).collect();
    let means = [("tractor", &model.tractors, true), ("corner", &web.corners, true), ("centre", &web.centre, false)];
    for (name, nodes, is_group) in means {
        if !nodes.is_empty() && points.iter().all(|p| p.name != name) {
            points.push(landmark(name, nodes.clone(), is_group));
        }
    }
    let bottom = points.iter().find(|p| p.name == "B").map_or(Vec::new(), |b| b.segments.clone());
    let (classes, ropes, groups) = groups(model);
    let mouth: Vec<Vec<usize>> = match web.corners.len() {
        0 | 1 => web.outline.clone(),
        _ => web.corners.iter().map(|&corner| vec![corner]).collect(),
    };
    let flat_posture = match web.outline.len() {
        0 => 0.0,
        count => {
            let rim = web.outline.iter().map(|knots| web.mean_position(knots).z).sum::<f64>() / count as f64;
            web.mean_position(&web.centre).z - rim
        }
    };
    Landmarks {
        axis: model.axis(),
        ground: model.system.environment().ground.as_ref().map(|ground| ground.height),
        outline: web.outline.clone(),
        reference_area: web.reference_area(),
        flat_posture,
        corners: web.corners.clone(),
        mouth_reach: reach(&mouth.iter().map(|knots| web.mean_position(knots)).collect::<Vec<_>>()),
        mouth,
        cells: model.cells.clone(),
        target_diameter: model.scenario.measure.target_diameter.map(|diameter| diameter.si()),
        tractors: model.tractors.clone(),
        centre: web.centre.clone(),
        points,
        supports: supports(model),
        bottom,
        classes,
        ropes,
        groups,
        canopies: canopies(model),
        cloth_strength: match &model.scenario.canopy {
            Some(Canopy::Membrane(sheet)) => sheet.strength.map(|strength| strength.si()),
            _ => None,
        },
        bodies: model.bodies.iter().map(body_mark).collect(),
    }
}

/// Most supports that the results show one by one.
const MOST_SUPPORTS: usize = 12;

/// What is held or driven: all of it, and node by node where these are few. A node is called like the feature point there,
/// else as messages call it.
fn supports(model: &Model) -> Vec<Support> {
    let nodes: Vec<usize> = (0..model.system.held().len()).filter(|&node| model.system.held()[node]).collect();
    if nodes.is_empty() {
        return Vec::new();
    }
    let mut supports = vec![Support { name: "supports".to_owned(), nodes: nodes.clone() }];
    if nodes.len() > MOST_SUPPORTS {
        return supports;
    }
    let points = model.points();
    for node in nodes {
        let point = points.iter().find(|(_, at)| *at == node).map(|(name, _)| name.clone());
        let name = point.unwrap_or_else(|| as_key(&model.node_label(node)));
        let alike = supports
            .iter()
            .filter(|support| support.name == name || support.name.starts_with(&(name.clone() + "_")))
            .count();
        let name = if alike == 0 { name } else { format!("{name}_{}", alike + 1) };
        supports.push(Support { name, nodes: vec![node] });
    }
    supports
}

/// A label as it stands in the name of a column.
fn as_key(label: &str) -> String {
    let words = label.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_")
}

/// The canopies, with the triangles of those that are membranes.
fn canopies(model: &Model) -> Vec<CanopyMark> {
    let triangles = |canopy: usize| model.sheets.get(canopy).map_or(Vec::new(), |sheet| sheet.triangles.clone());
    let mark = |(index, canopy): (usize, &netcast_webs::Canopy)| CanopyMark {
        hub: canopy.hub,
        rim: canopy.rim.to_vec(),
        triangles: triangles(index),
    };
    model.cut.web.canopies.iter().enumerate().map(mark).collect()
}

/// The link classes, the ropes, and the link class and rope of each group.
fn groups(model: &Model) -> (Vec<LinkClass>, Vec<NamedRope>, Vec<Group>) {
    let (mut classes, mut ropes): (Vec<LinkClass>, Vec<NamedRope>) = (Vec::new(), Vec::new());
    let mut groups = Vec::new();
    for group in &model.groups {
        let class = classes.iter().position(|class| class.name == group.class.name()).unwrap_or_else(|| {
            let (name, is_rope) = (group.class.name().to_owned(), group.class.is_rope());
            classes.push(LinkClass { name, is_rope, strength: None });
            classes.len() - 1
        });
        // the strength of a class is that of its weakest rope
        let known = classes[class].strength;
        classes[class].strength = known.into_iter().chain(group.strength).reduce(f64::min);
        let rope = group.rope.as_ref().map(|name| {
            ropes.iter().position(|rope| rope.name == *name).unwrap_or_else(|| {
                let (strength, knot_reduction) = (group.strength, group.knot_reduction);
                ropes.push(NamedRope { name: name.clone(), strength, knot_reduction });
                ropes.len() - 1
            })
        });
        groups.push(Group { class, rope });
    }
    (classes, ropes, groups)
}

/// The distance of each position from their mean, m, in the web's plane.
fn reach(places: &[DVec3]) -> Vec<f64> {
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    places.iter().map(|place| (place - middle).truncate().length()).collect()
}

fn body_mark(body: &PlacedBody) -> BodyMark {
    let kind = match body.role {
        Role::Tractor => BodyKind::Tractor,
        Role::Payload => BodyKind::Payload,
        Role::Sensor => BodyKind::Sensor,
    };
    let shape = match body.solid.shape {
        Shape::Cylinder { diameter_m, height_m } => BodyShape::Cylinder { diameter_m, height_m },
        Shape::Sphere { diameter_m } => BodyShape::Sphere { diameter_m },
        Shape::Box { size_m } => BodyShape::Box { size_m },
        Shape::Particle { .. } => BodyShape::Particle,
    };
    BodyMark { kind, node: body.node, shape, rigid: body.rigid }
}

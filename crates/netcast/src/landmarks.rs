//! What a model's nodes and segments mean to who measures them.

use netcast_results::{Landmark, Landmarks, LinkClass};
use netcast_scenario::lower::Model;
use netcast_webs::Class;

/// The landmarks of a model.
pub fn landmarks(model: &Model) -> Landmarks {
    let web = &model.cut.web;
    let followed = |name: &str, nodes: Vec<usize>, is_group: bool| Landmark {
        name: name.to_owned(),
        is_group,
        segments: model.ropes_at(&nodes),
        nodes,
    };
    let mut points: Vec<Landmark> =
        model.points().into_iter().map(|(name, node)| followed(&name, vec![node], false)).collect();
    let means = [("tractor", &model.tractors, true), ("corner", &web.corners, true), ("centre", &web.centre, false)];
    for (name, nodes, is_group) in means {
        if !nodes.is_empty() && points.iter().all(|p| p.name != name) {
            points.push(followed(name, nodes.clone(), is_group));
        }
    }
    let bottom = points.iter().find(|p| p.name == "B").map_or(Vec::new(), |b| b.segments.clone());
    let classes = model.classes.iter().zip(&model.strengths).map(|(class, &strength)| LinkClass {
        name: class.name().to_owned(),
        is_rope: *class != Class::Canopy,
        strength,
    });
    let flat_posture = match web.outline.len() {
        0 => 0.0,
        count => {
            let rim = web.outline.iter().map(|knots| web.mean_position(knots).z).sum::<f64>() / count as f64;
            web.mean_position(&web.centre).z - rim
        }
    };
    Landmarks {
        axis: model.axis(),
        outline: web.outline.clone(),
        reference_area: web.reference_area(),
        flat_posture,
        tractors: model.tractors.clone(),
        centre: web.centre.clone(),
        points,
        bottom,
        classes: classes.collect(),
    }
}

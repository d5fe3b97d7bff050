//! Loads of a scenario as forces on nodes.

use glam::DVec3;
use netcast_dynamics::forces::load::Load;
use netcast_scenario::path::Path;
use netcast_scenario::{Diagnostic, Diagnostics, Document, Load as WrittenLoad, nearest};

use super::draft::Draft;
use super::members::{Group, Member};
use super::selection::resolve;

/// Adds the loads, by name and then by node. A force per length of rope goes half to either end of each segment.
///
/// # Errors
/// An unknown node, feature point or link class.
pub fn load(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, members, groups, parts, .. } = draft;
    let mut found = Vec::new();
    for (name, load) in &scenario.load {
        let path = Path::default().key("load").key(name);
        let ramp = load.ramp.map_or(0.0, |ramp| ramp.si());
        let forces = match load {
            WrittenLoad { force_per_length: Some(force), class: Some(class), .. } => {
                along_ropes(DVec3::from(force.map(|f| f.si())), class, members, groups, cut.nodes.len())
                    .ok_or_else(|| unknown_class(document, &path, class, groups).into())
            }
            _ => {
                let force = DVec3::from(load.force.map_or([0.0; 3], |force| force.map(|f| f.si())));
                let nodes = resolve(&load.on, document, cut, &path);
                nodes.map(|nodes| nodes.into_iter().map(|node| (node, force)).collect::<Vec<_>>())
            }
        };
        match forces {
            Ok(forces) => parts.loads.extend(forces.into_iter().map(|(node, force)| Load { node, force, ramp })),
            Err(Diagnostics(wrong)) => found.extend(wrong),
        }
    }
    Diagnostics::fail_if_any(found)
}

/// Each node of the ropes of `class` with its force, N; none where no rope is of that class.
fn along_ropes(
    force_per_length: DVec3,
    class: &str,
    members: &[Member],
    groups: &[Group],
    nodes: usize,
) -> Option<Vec<(usize, DVec3)>> {
    let mut half_lengths = vec![0.0; nodes];
    for Member { segment, .. } in members.iter().filter(|member| member.is_rope()) {
        if groups[segment.group].class.name() == class {
            for end in segment.ends {
                half_lengths[end] += 0.5 * segment.rest_length;
            }
        }
    }
    let loaded = half_lengths.into_iter().enumerate().filter(|(_, length)| *length > 0.0);
    let forces: Vec<_> = loaded.map(|(node, length)| (node, length * force_per_length)).collect();
    (!forces.is_empty()).then_some(forces)
}

/// The diagnostic that no rope is of `class`, at the key `class` below `path`.
pub fn unknown_class(document: &Document, path: &Path, class: &str, groups: &[Group]) -> Diagnostic {
    let mut known: Vec<&str> = groups.iter().filter(|g| g.rope.is_some()).map(|g| g.class.name()).collect();
    known.dedup();
    let help = match nearest(class, &known) {
        Some(near) => format!("did you mean {near:?}?"),
        None => format!("known classes: {}", known.join(", ")),
    };
    let message = format!("no rope is of the link class {class:?}");
    document.diagnostic(&path.key("class").to_string(), message).with_help(help)
}

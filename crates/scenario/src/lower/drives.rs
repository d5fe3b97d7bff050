//! What a scenario moves along given paths, node by node.

use glam::DVec3;
use netcast_dynamics::drive::Drive;
use netcast_dynamics::system::SystemParts;
use netcast_webs::CutWeb;

use super::selection::Selection;
use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::drive::misplaced;
use crate::path::Path;
use crate::scenario::Scenario;

/// The drives, by name and then by node; `position` is where the nodes start in the world, m.
pub fn drives(
    document: &Document,
    cut: &CutWeb,
    scenario: &Scenario,
    position: &[DVec3],
) -> Result<Vec<Drive>, Diagnostics> {
    let (mut drives, mut found) = (Vec::<Drive>::new(), Vec::new());
    for (name, drive) in &scenario.drive {
        let path = Path::default().key("drive").key(name);
        let mut points = vec![(0.0, DVec3::ZERO)];
        let of_file = document.paths.get(name).into_iter().flatten().map(|row| (row.time_s, row.displacement_m));
        let listed = drive.path.iter().flatten().map(|point| (point.time.si(), point.by.map(|by| by.si())));
        let mut before = None;
        for (index, (time, by)) in of_file.chain(listed).enumerate() {
            // the rows of a file have been looked at
            if let Some(why) = misplaced(time, by, before) {
                found.push(document.diagnostic(&path.key("path").index(index).to_string(), why));
            }
            before = Some(time);
            points.extend((time > 0.0).then_some((time, DVec3::from(by))));
        }
        let nodes = match Selection::from(drive).resolve(document, cut, &path) {
            Ok(nodes) => nodes,
            Err(Diagnostics(wrong)) => {
                found.extend(wrong);
                continue;
            }
        };
        for node in nodes {
            if drives.iter().any(|other| other.node == node) {
                let message = format!("{} is moved by another drive already", cut.node_label(node));
                found.push(document.diagnostic(&path.to_string(), message));
            }
            let path = points.iter().map(|&(time, by)| (time, position[node] + by)).collect();
            drives.push(Drive { node, path });
        }
    }
    Diagnostics::fail_if_any(found)?;
    Ok(drives)
}

/// That nothing is driven that belongs to a rigid body.
pub fn are_no_bodies(document: &Document, cut: &CutWeb, parts: &SystemParts) -> Result<(), Diagnostics> {
    let ties: Vec<usize> = parts.bodies.iter().flat_map(|body| &body.ties).map(|tie| tie.node).collect();
    let Some(drive) = parts.drives.iter().find(|drive| ties.contains(&drive.node)) else { return Ok(()) };
    let message = format!("{} is tied to a rigid body, which a drive does not move", cut.node_label(drive.node));
    Err(document.diagnostic("drive", message).with_help("make that body a particle").into())
}

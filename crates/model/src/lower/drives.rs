//! Drives: nodes that follow given paths.

use std::collections::BTreeMap;

use glam::DVec3;
use netcast_dynamics::drive::Drive;
use netcast_scenario::path::Path;
use netcast_scenario::{Diagnostics, Document, PathRow, misplaced};
use netcast_webs::CutWeb;

use super::draft::Draft;
use super::selection::resolve;

/// Drives as a scenario names them.
pub struct Drives<'s> {
    /// The table of the scenario that holds them.
    pub table: &'s str,
    /// The drives by name.
    pub drives: &'s BTreeMap<String, netcast_scenario::Drive>,
    /// Rows of the path files by the name of the drive.
    pub files: &'s BTreeMap<String, Vec<PathRow>>,
}

impl Drives<'_> {
    /// The drives of all nodes, by name and then by node; `position` is the start of each node, m, (nodes,).
    ///
    /// # Errors
    /// A path whose times do not grow, an unknown node, a node with two drives.
    pub fn resolve(&self, document: &Document, cut: &CutWeb, position: &[DVec3]) -> Result<Vec<Drive>, Diagnostics> {
        let (mut drives, mut found) = (Vec::<Drive>::new(), Vec::new());
        for (name, drive) in self.drives {
            let path = Path::parse(self.table).key(name);
            let mut points = vec![(0.0, DVec3::ZERO)];
            let of_file = self.files.get(name).into_iter().flatten().map(|row| (row.time_s, row.displacement_m));
            let listed = drive.path.iter().flatten().map(|point| (point.time.si(), point.by.map(|by| by.si())));
            let mut before = None;
            for (index, (time, by)) in of_file.chain(listed).enumerate() {
                // rows of a file were checked when it was read
                if let Some(why) = misplaced(time, by, before) {
                    found.push(document.diagnostic(&path.key("path").index(index).to_string(), why));
                }
                before = Some(time);
                points.extend((time > 0.0).then_some((time, DVec3::from(by))));
            }
            let nodes = match resolve(&drive.on, document, cut, &path) {
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
}

/// Finds the driven nodes and their paths.
pub fn drive(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, scenario, parts, state, .. } = draft;
    let named = Drives { table: "drive", drives: &scenario.drive, files: &document.files.paths };
    parts.drives = named.resolve(document, cut, &state.position)?;
    Ok(())
}

/// Marks driven nodes as held. The drive of a tractor or of a canopy's hub moves to the centre of its rigid body, which
/// turns freely about that centre.
///
/// # Errors
/// A drive of any other node of a rigid body.
pub fn take_hold(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, parts, state, .. } = draft;
    let position = &state.position;
    let mut found = Vec::new();
    for drive in &mut parts.drives {
        let node = drive.node;
        if let Some(body) = parts.bodies.iter().find(|body| body.ties.iter().any(|tie| tie.node == node)) {
            let is_its_middle = cut.web.canopies.iter().any(|canopy| canopy.hub == node);
            if !is_its_middle && !cut.web.tractors.contains(&node) {
                let message =
                    format!("{} is a part of a rigid body, which is driven at its middle", cut.node_label(node));
                let help = "name the centre of its canopy, or make the canopy a membrane or links";
                found.push(document.diagnostic("drive", message).with_help(help));
                continue;
            }
            let from_node = position[body.centre] - position[node];
            for (_, place) in &mut drive.path {
                *place += from_node;
            }
            drive.node = body.centre;
        }
        parts.held[drive.node] = true;
    }
    Diagnostics::fail_if_any(found)
}

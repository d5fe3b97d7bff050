//! Which nodes a load or a drive acts on, or are tied.

use netcast_webs::CutWeb;

use super::unknown_knot;
use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::drive::Drive;
use crate::load::Load;
use crate::nearest::nearest;
use crate::path::Path;
use crate::tie::BreakTie;

/// What a scenario names.
pub struct Selection<'s> {
    corners: bool,
    tractors: bool,
    nodes: &'s [String],
    points: &'s [String],
}

impl<'s> From<&'s Load> for Selection<'s> {
    fn from(load: &'s Load) -> Self {
        Self { corners: load.corners, tractors: load.tractors, nodes: &load.nodes, points: &load.points }
    }
}

impl<'s> From<&'s Drive> for Selection<'s> {
    fn from(drive: &'s Drive) -> Self {
        Self { corners: drive.corners, tractors: drive.tractors, nodes: &drive.nodes, points: &drive.points }
    }
}

impl<'s> From<&'s BreakTie> for Selection<'s> {
    fn from(tie: &'s BreakTie) -> Self {
        Self { corners: tie.corners, tractors: tie.tractors, nodes: &tie.nodes, points: &tie.points }
    }
}

impl Selection<'_> {
    /// The nodes, each once, ascending. What is named wrongly stands below `path`.
    pub fn resolve(&self, document: &Document, cut: &CutWeb, path: &Path) -> Result<Vec<usize>, Diagnostics> {
        let (web, mut found) = (&cut.web, Vec::new());
        let mut nodes = Vec::new();
        for (key, asked, named) in [("corners", self.corners, &web.corners), ("tractors", self.tractors, &web.tractors)]
        {
            if asked && named.is_empty() {
                found.push(document.diagnostic(&path.key(key).to_string(), format!("the web has no {key}")));
            }
            nodes.extend(named.iter().filter(|_| asked));
        }
        for (index, id) in self.nodes.iter().enumerate() {
            match web.knot_named(id) {
                Some(knot) => nodes.push(knot),
                None => found.push(unknown_knot(document, &path.key("nodes").index(index).to_string(), id, cut)),
            }
        }
        for (index, name) in self.points.iter().enumerate() {
            match web.points.get(name) {
                Some(&site) => nodes.push(cut.node_of(site)),
                None => {
                    let path = path.key("points").index(index).to_string();
                    let near = nearest(name, web.points.keys()).map(|near| format!("did you mean {near:?}?"));
                    let diagnostic = document.diagnostic(&path, format!("unknown feature point {name:?}"));
                    found.push(diagnostic.with_help_if(near));
                }
            }
        }
        Diagnostics::fail_if_any(found)?;
        nodes.sort_unstable();
        nodes.dedup();
        Ok(nodes)
    }
}

//! Where the nodes lie at launch, in the launch frame, and the audit of that.

use glam::DVec3;
use netcast_dynamics::forces::law::Law;
use netcast_webs::{Audit, Bag, CutWeb, Given, PackingError, Pattern, Scale, StowedSegment, audit as look_over};

use super::material::Materials;
use crate::csv_files::StowRow;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::document::Document;
use crate::nearest::nearest;
use crate::scenario::Scenario;
use crate::stow::Stow;

/// Positions of all nodes in the launch frame, m.
pub fn stow(document: &Document, cut: &CutWeb, scenario: &mut Scenario) -> Result<Vec<DVec3>, Diagnostics> {
    let pattern = match &scenario.stow {
        None => return Ok(cut.nodes.clone()),
        Some(Stow::Scale(scale)) => Pattern::Scale(Scale { factor: scale.factor.si() }),
        Some(Stow::Bag(bag)) => Pattern::Bag(Bag {
            radius: bag.radius.si(),
            depth: bag.depth.map(|d| d.si()),
            tractor_radius: bag.tractor_radius.map(|r| r.si()),
            tractor_gap: bag.tractor_gap.map(|g| g.si()),
        }),
        Some(Stow::File(_)) => {
            let rows = document.stowed.as_ref().expect("a document with a stow file has read it");
            Pattern::Given(Given { positions: given(document, cut, rows)? })
        }
    };
    pattern.pack(cut).map_err(|error| {
        let path = match (&pattern, &error) {
            (Pattern::Scale(_), _) => "stow.scale.factor",
            (Pattern::Given(_), _) => "stow.file.path",
            (Pattern::Bag(_), PackingError::Depth { .. }) => "stow.bag.depth",
            (Pattern::Bag(_), PackingError::TractorOutOfReach { .. }) => "stow.bag.tractor_radius",
            (Pattern::Bag(_), PackingError::Gap { .. }) => "stow.bag.tractor_gap",
            (Pattern::Bag(_), _) => "stow.bag.radius",
        };
        document.diagnostic(path, error.to_string()).into()
    })
}

/// The rows of a stow file by node. Ids are those of knots, or a node's label, as `netcast stow --write` gives them.
fn given(document: &Document, cut: &CutWeb, rows: &[StowRow]) -> Result<Vec<Option<DVec3>>, Diagnostics> {
    let ids: std::collections::BTreeMap<String, usize> = (0..cut.nodes.len()).map(|n| (node_id(cut, n), n)).collect();
    let mut positions = vec![None; cut.nodes.len()];
    let mut found = Vec::new();
    for row in rows {
        match ids.get(&row.id) {
            Some(&node) => positions[node] = Some(DVec3::from_array(row.position_m)),
            None => {
                let message = format!("line {}: the web has no node {:?}", row.line, row.id);
                let help = nearest(&row.id, ids.keys()).map(|near| format!("did you mean {near:?}?"));
                found.push(document.diagnostic("stow.file.path", message).with_help_if(help));
            }
        }
    }
    Diagnostics::fail_if_any(found)?;
    Ok(positions)
}

/// What a stow file calls a node: a knot by its name, a node inside a rope by its label.
pub fn node_id(cut: &CutWeb, node: usize) -> String {
    cut.web.knots.get(node).map_or_else(|| cut.node_label(node), |knot| knot.name.clone())
}

/// Looks the start over. A web that is stowed may not be stretched, nor its struts compressed; one that starts as drawn
/// may.
pub fn audit(
    document: &Document,
    cut: &CutWeb,
    Materials { members, groups, .. }: &Materials,
    positions: &[DVec3],
) -> Result<Audit, Diagnostics> {
    let segments = members.iter().map(|m| {
        let [a, b] = m.segment.ends;
        StowedSegment { a, b, rest_length: m.segment.rest_length, stiffness: m.segment.stiffness }
    });
    let audit = look_over(positions, segments);
    let Some(stow) = &document.scenario.stow else { return Ok(audit) };
    let path = match stow {
        Stow::Scale(_) => "stow.scale",
        Stow::Bag(_) => "stow.bag",
        Stow::File(_) => "stow.file",
    };
    let shortened = members.iter().filter(|m| groups[m.segment.class].law == Law::Strut).find_map(|member| {
        let share = -member.segment.stretch(positions) / member.segment.rest_length;
        (share > Audit::TOLERANCE).then(|| (member.label(cut), 100.0 * share))
    });
    if let Some((label, percent)) = shortened {
        let message = format!("the stowed web compresses struts: {label} by {percent:.3} %");
        let help = "leave the packing out, or give positions at which struts keep their length, by [stow.file]";
        return Err(document.diagnostic(path, message).with_help(help).into());
    }
    match audit.longest {
        Some(longest) if !audit.is_slack() => {
            let message = format!(
                "the stowed web is stretched: {} by {:.3} %, and {} segments in all (a packing may not stretch a rope)",
                members[longest.segment].label(cut),
                100.0 * longest.stretch,
                audit.stretched
            );
            let diagnostic: Diagnostic = document.diagnostic(path, message);
            Err(diagnostic.with_help("pack it closer, or give the rope no pretension").into())
        }
        _ => Ok(audit),
    }
}

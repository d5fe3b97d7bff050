//! Where the nodes lie at launch, in the launch frame, and the audit of that.

use glam::{DMat3, DVec3};
use netcast_dynamics::forces::element::Element;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::membrane::Membrane;
use netcast_webs::{
    Audit, Bag, CutWeb, Given, PackingError, Pattern, Scale, StiffPlate, StowedSegment, audit as look_over,
};

use super::canopies::{Canopies, CutSheet};
use super::material::Materials;
use crate::canopy::Canopy;
use crate::csv_files::StowRow;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::document::Document;
use crate::nearest::nearest;
use crate::scenario::Scenario;
use crate::stow::Stow;

/// Where everything is at launch, in the launch frame.
#[derive(Debug, Clone)]
pub struct Stowed {
    /// Positions of all nodes, m.
    pub positions: Vec<DVec3>,
    /// How each canopy is turned against the flat web, where it keeps its shape.
    pub turns: Vec<DMat3>,
}

/// Packs the web. Canopies that keep their shape lie in it as plates, cloth follows the ropes.
pub fn stow(
    document: &Document,
    cut: &CutWeb,
    scenario: &Scenario,
    canopies: &Canopies,
) -> Result<Stowed, Diagnostics> {
    let mut turns = vec![DMat3::IDENTITY; cut.web.canopies.len()];
    let pattern = match &scenario.stow {
        None => return Ok(Stowed { positions: cut.nodes.clone(), turns }),
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
    let packed = pattern.pack(cut).map_err(|error| {
        let path = match (&pattern, &error) {
            (Pattern::Scale(_), _) => "stow.scale.factor",
            (Pattern::Given(_), _) => "stow.file.path",
            (Pattern::Bag(_), PackingError::Depth { .. }) => "stow.bag.depth",
            (Pattern::Bag(_), PackingError::TractorOutOfReach { .. }) => "stow.bag.tractor_radius",
            (Pattern::Bag(_), PackingError::Gap { .. }) => "stow.bag.tractor_gap",
            (Pattern::Bag(_), _) => "stow.bag.radius",
        };
        document.diagnostic(path, error.to_string())
    })?;
    let mut positions = packed;
    let Pattern::Given(given) = &pattern else {
        StiffPlate::lay(&canopies.plates, cut, &mut positions);
        return Ok(Stowed { positions, turns });
    };
    for sheet in &canopies.sheets {
        spread(sheet, given, &cut.nodes, &mut positions);
    }
    let mut found = Vec::new();
    for plate in &canopies.plates {
        match plate.fit(cut, &mut positions) {
            Ok(turn) => turns[plate.canopy] = turn,
            Err(off) => {
                let number = cut.web.canopies[plate.canopy].number;
                let message = format!(
                    "canopy {number} keeps its shape, and its middle and corners do not lie as in the flat web: one of \
                     them is {off:.3e} m off"
                );
                found.push(document.diagnostic("stow.file.path", message));
            }
        }
    }
    Diagnostics::fail_if_any(found)?;
    Ok(Stowed { positions, turns })
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

/// Puts the nodes of a sheet that no file names where they lie between its middle and its corners.
fn spread(sheet: &CutSheet, given: &Given, flat: &[DVec3], positions: &mut [DVec3]) {
    let hub = sheet.nodes[0];
    let corners = sheet.corners;
    for &node in sheet.nodes.iter().filter(|&&node| given.positions[node].is_none()) {
        let place = flat[node] - flat[hub];
        // the sector that it lies in: the one where both shares are positive, or nothing but rounding
        let shares = (0..6).map(|k| {
            let [a, b] = [k, (k + 1) % 6].map(|k| flat[corners[k]] - flat[hub]);
            let area = a.truncate().perp_dot(b.truncate());
            let share =
                [place.truncate().perp_dot(b.truncate()) / area, a.truncate().perp_dot(place.truncate()) / area];
            (share, [corners[k], corners[(k + 1) % 6]])
        });
        let least = |share: &[f64; 2]| share[0].min(share[1]);
        let sector = shares.reduce(|best, next| if least(&next.0) > least(&best.0) { next } else { best });
        let (share, [a, b]) = sector.expect("there are six sectors");
        let middle = positions[hub];
        positions[node] = middle + share[0] * (positions[a] - middle) + share[1] * (positions[b] - middle);
    }
}

/// A stress that rounding explains, as a share of the elastic modulus.
const ROUNDING: f64 = 1e-9;

/// Looks the start over. A web that is stowed may not be stretched, nor its struts compressed; one that starts as drawn
/// may.
pub fn audit(
    document: &Document,
    cut: &CutWeb,
    materials: &Materials,
    positions: &[DVec3],
) -> Result<Audit, Diagnostics> {
    let Materials { members, groups, canopies, .. } = materials;
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
    stretched_cloth(document, path, cut, canopies, positions)?;
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

/// That a packing, at `path`, stretches no sheet.
fn stretched_cloth(
    document: &Document,
    path: &str,
    cut: &CutWeb,
    canopies: &Canopies,
    positions: &[DVec3],
) -> Result<(), Diagnostics> {
    let Some(Canopy::Membrane(sheet)) = &document.scenario.canopy else { return Ok(()) };
    let stress = |triangle: &Membrane| {
        (triangle.stress(triangle.nodes().map(|node| positions[node])).largest(), triangle.nodes()[0])
    };
    let larger = |one: (f64, usize), other: (f64, usize)| if other.0 > one.0 { other } else { one };
    match canopies.membranes.iter().map(stress).reduce(larger) {
        Some((largest, node)) if largest > ROUNDING * sheet.elastic_modulus.si() => {
            let message = format!(
                "the stowed web is stretched: the cloth at {} bears {largest:.3e} Pa (a packing may not stretch a sheet)",
                cut.node_label(node)
            );
            Err(document.diagnostic(path, message).with_help("pack it closer").into())
        }
        _ => Ok(()),
    }
}

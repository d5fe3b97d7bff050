//! Packs the web: positions of the nodes at launch, in the launch frame, and their audit.

use glam::{DMat3, DVec3};
use netcast_dynamics::forces::element::Element;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::membrane::Membrane;
use netcast_scenario::interval::Positive;
use netcast_scenario::quantity::Length;
use netcast_scenario::{
    Along, Canopy, Container as Room, Diagnostic, Diagnostics, Document, PrescribedStow, Stow, StowRow, Stowage,
    nearest,
};
use netcast_webs::{
    Audit, Bag, Container, CutWeb, Folded, Folding, Given, Imperfection, Mouth, Pattern, Scale, Settled, StiffPlate,
    StowedSegment, audit as look_over,
};

use super::Stage;
use super::canopy_parts::{Canopies, CutSheet};
use super::draft::Draft;
use super::places;
use super::prescribed::{mouth, prescribed};

/// The packed web in the launch frame.
struct Stowed {
    /// Positions of all nodes, m, (nodes,).
    positions: Vec<DVec3>,
    /// The canopies that keep their shape, each with its rotation from the flat web.
    turns: Vec<(usize, DMat3)>,
    /// How a led web came to rest, in words; none for any other packing.
    settled: Option<String>,
}

impl Stowed {
    fn new(positions: Vec<DVec3>, plates: &[StiffPlate], turns: Vec<DMat3>) -> Self {
        Self { positions, turns: plates.iter().map(|plate| plate.canopy).zip(turns).collect(), settled: None }
    }
}

/// Packs the web. Canopies that keep their shape lie in it as plates; cloth follows the ropes.
///
/// # Errors
/// A packing that is impossible. The list is empty where a led web lacks its masses: another stage has reported why.
pub fn stow(draft: &mut Draft) -> Result<(), Diagnostics> {
    let no_canopies = Canopies::default();
    let knows_masses = draft.has(Stage::Masses);
    let canopies = if knows_masses { &draft.canopies } else { &no_canopies };
    let stowed = match &draft.scenario.stow {
        None => Stowed::new(draft.cut.nodes.clone(), &[], Vec::new()),
        Some(Stowage { pattern: Stow::Prescribed(_), .. }) if !knows_masses => return Err(Diagnostics(Vec::new())),
        Some(Stowage { pattern, imperfection }) => {
            let imperfection = imperfection.as_ref().map(|imperfect| Imperfection {
                scatter: imperfect.scatter.si(),
                twist: imperfect.twist.si(),
                slack: imperfect.slack.si(),
                seed: imperfect.seed.into(),
            });
            match pattern {
                Stow::Prescribed(led) => settle(draft, pattern, led, imperfection.as_ref())?,
                pattern => pack(draft.document, &draft.cut, canopies, pattern, imperfection.as_ref())?,
            }
        }
    };
    draft.state.position = stowed.positions.iter().map(|&place| draft.frame * place).collect();
    draft.stowed = stowed.positions;
    for (canopy, turn) in stowed.turns {
        draft.turns[canopy] = turn;
    }
    draft.notes.extend(stowed.settled);
    Ok(())
}

/// The pattern of a packing whose nodes are not led along paths.
fn pattern(document: &Document, cut: &CutWeb, stow: &Stow) -> Result<Pattern, Diagnostics> {
    Ok(match stow {
        Stow::Scale(scale) => Pattern::Scale(Scale { factor: scale.factor.si() }),
        Stow::Bag(bag) => Pattern::Bag(Bag {
            radius: bag.radius.si(),
            depth: bag.depth.map(|d| d.si()),
            mouth: mouth(bag.tractor_radius, bag.tractor_gap),
        }),
        Stow::Prescribed(_) => unreachable!("a led web has no pattern"),
        Stow::File(_) => {
            let rows = document.files.stowed.as_ref().expect("a document with a stow file has read it");
            Pattern::Given(Given { positions: given_positions(document, cut, rows)? })
        }
        Stow::Zigzag(zigzag) => {
            let folding = match zigzag.along {
                Along::Rings => Folding::Rings,
                Along::Lines => Folding::Lines,
            };
            let mouth = mouth(zigzag.tractor_radius, zigzag.tractor_gap);
            folded(folding, &zigzag.container, zigzag.spacing, mouth)
        }
        Stow::Star(star) => {
            let folding = Folding::Star { arms: star.arms.map(|arms| arms.get()) };
            folded(folding, &star.container, star.spacing, mouth(star.tractor_radius, star.tractor_gap))
        }
        Stow::Roll(roll) => {
            folded(Folding::Roll, &roll.container, roll.spacing, mouth(roll.tractor_radius, roll.tractor_gap))
        }
        Stow::Layers(layers) => {
            let mouth = mouth(layers.tractor_radius, layers.tractor_gap);
            folded(Folding::Layers, &layers.container, layers.spacing, mouth)
        }
    })
}

/// The web packed by a pattern.
fn pack(
    document: &Document,
    cut: &CutWeb,
    canopies: &Canopies,
    stow: &Stow,
    imperfection: Option<&Imperfection>,
) -> Result<Stowed, Diagnostics> {
    let pattern = pattern(document, cut, stow)?;
    let mut positions = pattern
        .pack_imperfectly(cut, imperfection)
        .map_err(|error| document.diagnostic(&places::of_packing(error.argument(), stow), error.to_string()))?;
    match &pattern {
        Pattern::Given(given) => fit_canopies(document, cut, canopies, given, positions),
        Pattern::Folded(_) => {
            let plates = canopies.laid_in_folds();
            let turns = StiffPlate::lay_in_folds(&plates, cut, &mut positions);
            Ok(Stowed::new(positions, &plates, turns))
        }
        Pattern::Scale(_) | Pattern::Bag(_) => {
            StiffPlate::lay(&canopies.plates, cut, &mut positions);
            Ok(Stowed::new(positions, &[], Vec::new()))
        }
    }
}

/// The packing of a file. Canopies lie where the file places their middles and corners.
fn fit_canopies(
    document: &Document,
    cut: &CutWeb,
    canopies: &Canopies,
    given: &Given,
    mut positions: Vec<DVec3>,
) -> Result<Stowed, Diagnostics> {
    for sheet in &canopies.sheets {
        spread(sheet, given, &cut.nodes, &mut positions);
    }
    let (mut turns, mut found) = (Vec::new(), Vec::new());
    for plate in &canopies.plates {
        match plate.fit(cut, &mut positions) {
            Ok(turn) => turns.push(turn),
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
    Ok(Stowed::new(positions, &canopies.plates, turns))
}

/// The web after its nodes were led into the container and it came to rest.
fn settle(
    draft: &Draft,
    stow: &Stow,
    led: &PrescribedStow,
    imperfection: Option<&Imperfection>,
) -> Result<Stowed, Diagnostics> {
    let (document, cut) = (draft.document, &draft.cut);
    let packing = prescribed(document, cut, led, &draft.parts.mass, draft.canopies.laid_in_folds())?;
    let (positions, turns, Settled { time, share }) = packing
        .pack(cut, imperfection)
        .map_err(|error| document.diagnostic(&places::of_packing(error.argument(), stow), error.to_string()))?;
    let how = if share <= packing.rest { "came to rest" } else { "was taken as it was" };
    let settled =
        format!("the web {how} in its container after {time:.2} s, at {share:.1e} of its largest kinetic energy");
    Ok(Stowed { settled: Some(settled), ..Stowed::new(positions, &packing.plates, turns) })
}

/// The pattern that folds the web into a container, `spacing` apart.
fn folded(folding: Folding, room: &Room, spacing: Option<Length<Positive>>, mouth: Mouth) -> Pattern {
    let container = match room {
        Room::Cylinder(tube) => Container::Cylinder { radius: tube.radius.si(), height: tube.height.si() },
        Room::Box(sizes) => {
            let [width, breadth, height] = [sizes.width, sizes.breadth, sizes.height].map(|size| size.si());
            Container::Box { width, breadth, height }
        }
    };
    let spacing = spacing.expect("a complete scenario has it").si();
    Pattern::Folded(Folded { folding, container, spacing, mouth })
}

/// Position of each node in a stow file, launch frame, m, (nodes,); none if the file omits it. A row names a knot or the
/// label of a node, as `netcast stow --write` does.
fn given_positions(document: &Document, cut: &CutWeb, rows: &[StowRow]) -> Result<Vec<Option<DVec3>>, Diagnostics> {
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

/// The name of a node in a stow file: the name of a knot, the label of any other node.
pub fn node_id(cut: &CutWeb, node: usize) -> String {
    cut.web.knots.get(node).map_or_else(|| cut.node_label(node), |knot| knot.name.clone())
}

/// Interpolates the nodes of a sheet that the file omits between its middle and its corners.
fn spread(sheet: &CutSheet, given: &Given, flat: &[DVec3], positions: &mut [DVec3]) {
    let hub = sheet.nodes[0];
    let corners = sheet.corners;
    for &node in sheet.nodes.iter().filter(|&&node| given.positions[node].is_none()) {
        let place = flat[node] - flat[hub];
        // the node lies in the sector where both shares are positive, apart from rounding
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

/// Stress over elastic modulus that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Audits the packed web. A web that starts as drawn may be stretched.
///
/// # Errors
/// A packing that stretches a rope or a sheet, or that compresses a strut.
pub fn audit(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, members, groups, canopies, stowed, .. } = draft;
    let segments = members.iter().map(|m| {
        let [a, b] = m.segment.ends;
        StowedSegment { a, b, rest_length: m.segment.rest_length, stiffness: m.segment.stiffness }
    });
    let audit = look_over(stowed, segments);
    let Some(stow) = &document.scenario.stow else {
        draft.audit = Some(audit);
        return Ok(());
    };
    let path = stow.pattern.table();
    let mut found = Vec::new();
    found.extend(stretched_cloth(document, path, cut, canopies, stowed));
    let shortened = members.iter().filter(|m| groups[m.segment.group].law == Law::Strut).find_map(|member| {
        let share = -member.segment.stretch(stowed) / member.segment.rest_length;
        (share > Audit::TOLERANCE).then(|| (member.label(cut), 100.0 * share))
    });
    if let Some((label, percent)) = shortened {
        let message = format!("the stowed web compresses struts: {label} by {percent:.3} %");
        let help = "leave the packing out, or give positions at which struts keep their length, by [stow.file]";
        found.push(document.diagnostic(path, message).with_help(help));
    }
    if let Some(longest) = audit.longest.filter(|_| !audit.is_slack()) {
        let message = format!(
            "the stowed web is stretched: {} by {:.3} %, and {} segments in all (a packing may not stretch a rope)",
            members[longest.segment].label(cut),
            100.0 * longest.stretch,
            audit.stretched
        );
        let help = "pack it closer, or give the rope no pretension; a slack in [stow.imperfection] shrinks any packing";
        found.push(document.diagnostic(path, message).with_help(help));
    }
    draft.audit = Some(audit);
    Diagnostics::fail_if_any(found)
}

/// The diagnostic, at `path`, that a packing stretches a sheet; none if it does not.
fn stretched_cloth(
    document: &Document,
    path: &str,
    cut: &CutWeb,
    canopies: &Canopies,
    positions: &[DVec3],
) -> Option<Diagnostic> {
    let Some(Canopy::Membrane(sheet)) = &document.scenario.canopy else { return None };
    let stress = |triangle: &Membrane| {
        (triangle.stress(triangle.nodes().map(|node| positions[node])).largest(), triangle.nodes()[0])
    };
    let larger = |one: (f64, usize), other: (f64, usize)| if other.0 > one.0 { other } else { one };
    let (largest, node) = canopies.membranes.iter().map(stress).reduce(larger)?;
    (largest > ROUNDING * sheet.elastic_modulus.si()).then(|| {
        let message = format!(
            "the stowed web is stretched: the cloth at {} bears {largest:.3e} Pa (a packing may not stretch a sheet)",
            cut.node_label(node)
        );
        document.diagnostic(path, message).with_help("pack it closer")
    })
}

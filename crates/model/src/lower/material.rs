//! Stiffness, damping and mass of ropes, canopies and bodies: the segments of the system and the masses of its nodes.

use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::rope_tension::{damping_from_ratio, damping_from_time};
use netcast_dynamics::system::Segment;
use netcast_scenario::{Canopy, Damping, Diagnostics, Document, Rope, RopeRow, Scenario};
use netcast_webs::{BillItem, Class, CutSegment, CutWeb, Parts, RopeKind, bill};

use super::assignment::{self, rings};
use super::draft::Draft;
use super::members::{Group, Link, Member, Part, PlacedBody, Role, section};
use super::{canopy_links, rope_law};

/// The links of a web, in its order; `members` and `groups` are those of its model.
pub fn links(web: &netcast_webs::Web, members: &[Member], groups: &[Group]) -> Vec<Link> {
    let (rings, lengths) = (rings(web), rest_lengths(web.ropes.len(), members));
    let first_pieces = members.iter().filter_map(|member| match member.part {
        Part::Rope(CutSegment { place: 0, rope, .. }) => Some((rope, member.segment.group)),
        _ => None,
    });
    let link = |(rope, group): (usize, usize)| Link {
        name: web.ropes[rope].label.clone(),
        class: web.ropes[rope].class.clone(),
        ring: rings[rope],
        rope: groups[group].rope.clone().unwrap_or_default(),
        length: lengths[rope],
    };
    first_pieces.map(link).collect()
}

/// Rest length of each rope of a web, m, (ropes,): of its segments, which a pretension shortens.
pub fn rest_lengths(ropes: usize, members: &[Member]) -> Vec<f64> {
    let (mut first, mut count) = (vec![0.0; ropes], vec![0.0; ropes]);
    for member in members {
        if let Part::Rope(CutSegment { rope, .. }) = member.part {
            first[rope] = member.segment.rest_length;
            count[rope] += 1.0;
        }
    }
    // the segments of a rope are equally long; the product has no rounding of a sum
    first.iter().zip(count).map(|(length, count)| length * count).collect()
}

/// Finds each pair of link class and rope of the web, in order of class, with the law of the rope.
///
/// # Errors
/// A rope whose law is impossible.
pub fn groups(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, kinds, groups, .. } = draft;
    let known = assignment::ropes(scenario);
    let mut found = Vec::new();
    let mut law_of = |kind: usize| {
        let (name, rope) = known[kind];
        let is_used = kinds.contains(&kind);
        let law = is_used.then(|| rope_law::law(document, &assignment::table_of(name), rope));
        law.and_then(|law| law.map_err(|Diagnostics(wrong)| found.extend(wrong)).ok())
    };
    let laws: Vec<Option<Law>> = (0..known.len()).map(&mut law_of).collect();
    Diagnostics::fail_if_any(found)?;
    for (rope, &kind) in cut.web.ropes.iter().zip(&*kinds) {
        let ((name, made_of), Some(law)) = (known[kind], &laws[kind]) else { continue };
        if !groups.iter().any(|known| known.class == rope.class && known.rope.as_deref() == Some(name)) {
            groups.push(Group {
                class: rope.class.clone(),
                rope: Some(name.to_owned()),
                diameter: Some(made_of.diameter.si()),
                strength: made_of.strength.map(|strength| strength.si()),
                knot_reduction: made_of.knot_reduction.map(|share| share.si()),
                law: law.clone(),
                breaking: rope_law::breaking(made_of, law, false),
            });
        }
    }
    if let Some(Canopy::Links(_)) = canopy_of(scenario, cut) {
        groups.push(Group::of_threads(Class::Canopy, Breaking::NEVER));
    }
    groups.sort_by(|one, other| (&one.class, &one.rope).cmp(&(&other.class, &other.rope)));
    Ok(())
}

/// The canopies of a web; none where it has none.
pub fn canopy_of(scenario: &Scenario, cut: &CutWeb) -> Option<Canopy> {
    (!cut.web.canopies.is_empty()).then(|| scenario.canopy.clone().unwrap_or_default())
}

/// The number of the group of a link class and a rope.
pub fn group_number(groups: &[Group], class: &Class, rope: Option<&str>) -> usize {
    let is_pair = |group: &Group| group.class == *class && group.rope.as_deref() == rope;
    groups.iter().position(is_pair).expect("every class is listed with its ropes")
}

/// Makes the segments of the web's ropes, and puts their masses on its nodes.
///
/// # Errors
/// A rope with a pretension, of which a row of the graph gives the rest length.
pub fn ropes(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, kinds, groups, members, parts, notes, .. } = draft;
    let (web, rows, known) = (&cut.web, assignment::rows(document), assignment::ropes(scenario));
    refuse_pretension_of_measured_rows(document, kinds, &known)?;
    notes.extend(without_pretension(web, kinds, &known));
    let group_of_rope: Vec<usize> =
        web.ropes.iter().zip(&*kinds).map(|(r, &kind)| group_number(groups, &r.class, Some(known[kind].0))).collect();
    parts.mass = vec![0.0; cut.nodes.len()];
    members.reserve(cut.segment_count());
    for segment in cut.segments() {
        let rope = &web.ropes[segment.rope];
        let kind = known[kinds[segment.rope]].1;
        let pretension = pretension(rope.rest_length.is_some(), kind, rows.get(segment.rope));
        let (group, ends) = (group_of_rope[segment.rope], [segment.a, segment.b]);
        let piece = Piece::new(kind, &groups[group].law, segment.rest_length, pretension);
        let breaking = rope_law::breaking(kind, &groups[group].law, ends.iter().any(|&end| end < web.knots.len()));
        let piece = Segment { breaking, ..piece.between(ends, group, &mut parts.mass) };
        members.push(Member { segment: piece, part: Part::Rope(segment) });
    }
    Ok(())
}

/// Refuses a pretension of a rope where a row gives the rest length: two values for one stretch.
fn refuse_pretension_of_measured_rows(
    document: &Document,
    kinds: &[usize],
    known: &[(&str, &Rope)],
) -> Result<(), Diagnostics> {
    let mut found = Vec::new();
    for (kind, (name, rope)) in known.iter().enumerate().filter(|(_, (_, rope))| rope.pretension.si() > 0.0) {
        let measured = |(row, of): &(&RopeRow, &usize)| **of == kind && row.rest_length_m.is_some();
        let Some((row, _)) = assignment::rows(document).iter().zip(kinds).find(measured) else { continue };
        let path = assignment::table_of(name).key("pretension");
        let message = format!(
            "the rest length in line {} of web.graph.ropes says already how far this rope is stretched",
            row.line
        );
        let help = format!("leave the pretension of {} N or that rest length out", rope.pretension.si());
        found.push(document.diagnostic(&path.to_string(), message).with_help(help));
    }
    Diagnostics::fail_if_any(found)
}

/// A note on links that the web draws with a rest length of their own, so that the pretension of their rope does not act;
/// none where there are none.
fn without_pretension(web: &netcast_webs::Web, kinds: &[usize], known: &[(&str, &Rope)]) -> Option<String> {
    let has_length = |(rope, kind): &(&netcast_webs::Rope, &usize)| {
        rope.rest_length.is_some() && known[**kind].1.pretension.si() > 0.0
    };
    let count = web.ropes.iter().zip(kinds).filter(has_length).count();
    let (first, _) = web.ropes.iter().zip(kinds).find(has_length)?;
    Some(format!(
        "the pretension does not act in {count} {} of a given length, such as {}",
        if count == 1 { "rope" } else { "ropes" },
        first.label
    ))
}

/// Adds the masses of bodies and of a graph's nodes, and makes the rigid bodies of canopies.
pub fn masses(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, cut, canopies, bodies, parts, .. } = draft;
    for body in &*bodies {
        if !canopies.carry(body, cut) {
            parts.mass[body.node] += body.solid.mass_kg;
        }
    }
    for (node, row) in document.files.graph.iter().flat_map(|g| &g.nodes).enumerate() {
        parts.mass[node] += row.mass_kg;
    }
    canopies.bind(cut, &mut parts.mass);
    Ok(())
}

/// Makes the bill of materials.
pub fn list(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { scenario, cut, kinds, bodies, members, .. } = draft;
    let known = assignment::ropes(scenario);
    let cloth = canopy_of(scenario, cut).map(|canopy| canopy.mass_and_volume());
    let cloth = cloth.map_or(BillItem::default(), |(mass, volume)| BillItem { mass, volume });
    let tractors = bodies.iter().filter(|body| body.role == Role::Tractor);
    let tractor_masses = tractors.map(|body| body.solid.mass_kg).collect();
    let payload = scenario
        .payload_solid()
        .map_or(BillItem::default(), |p| BillItem { mass: p.mass_kg, volume: p.shape.volume_m3() });
    let rest_lengths = rest_lengths(kinds.len(), members);
    let (ropes, kind_of_rope) = (Vec::new(), Vec::new());
    let mut parts = Parts { ropes, kind_of_rope, rest_lengths, canopy: cloth, payload, tractor_masses };
    for (name, rope) in kinds.iter().map(|&kind| known[kind]) {
        let kind = RopeKind {
            name: name.to_owned(),
            diameter: rope.diameter.si(),
            mass_per_metre: rope.density.si() * section(rope),
        };
        let known = parts.ropes.iter().position(|k| *k == kind).unwrap_or_else(|| {
            parts.ropes.push(kind);
            parts.ropes.len() - 1
        });
        parts.kind_of_rope.push(known);
    }
    draft.bill = Some(bill(&cut.web, &parts));
    Ok(())
}

/// Finds payloads, sensor and tractors with their nodes.
pub fn place_bodies(draft: &mut Draft) -> Result<(), Diagnostics> {
    let (scenario, web) = (&draft.scenario, &draft.cut.web);
    let on_canopies = web.canopies.iter().filter_map(|canopy| {
        let (role, solid) = if canopy.carries_payload {
            (Role::Payload, scenario.payload_solid())
        } else {
            (Role::Sensor, scenario.sensor_solid().filter(|_| canopy.is_centre))
        };
        Some(PlacedBody { role, node: canopy.hub, solid: solid?, rigid: None })
    });
    let tractors = web.tractors.iter().enumerate().filter_map(|(corner, &node)| {
        Some(PlacedBody { role: Role::Tractor, node, solid: scenario.tractor_solid(corner as u32 + 1)?, rigid: None })
    });
    draft.bodies = on_canopies.chain(tractors).collect();
    Ok(())
}

/// Tension of a rope in the drawing, N. A rope with a given rest length has no pretension unless its row gives one.
fn pretension(has_rest_length: bool, rope: &Rope, row: Option<&RopeRow>) -> f64 {
    let own = row.and_then(|r| r.pretension_n);
    if has_rest_length { own.unwrap_or(0.0) } else { own.unwrap_or(rope.pretension.si()) }
}

/// A segment without its ends.
struct Piece {
    rest_length: f64,
    stiffness: f64,
    damping: f64,
    mass: f64,
}

impl Piece {
    /// A segment of rope that is `drawn` m long under `pretension`, N. Its rest length is shorter by the strain of its law
    /// under that tension.
    fn new(rope: &Rope, law: &Law, drawn: f64, pretension: f64) -> Piece {
        let area = section(rope);
        let axial_stiffness = rope.elastic_modulus.si() * area;
        let rest_length = drawn / (1.0 + law.strain_under(pretension, axial_stiffness));
        let mass = rope.density.si() * area * rest_length;
        let stiffness = axial_stiffness / rest_length;
        let damping = match rope.damping() {
            Damping::Time(time) => damping_from_time(axial_stiffness, time, rest_length),
            Damping::Ratio(ratio) => damping_from_ratio(ratio, stiffness, mass),
        };
        Piece { rest_length, stiffness, damping, mass }
    }

    /// A member of a canopy.
    fn of_canopy(made: &canopy_links::Members, stiffness: f64, mass: f64) -> Piece {
        let damping = damping_from_ratio(made.damping_ratio, stiffness, mass);
        Piece { rest_length: made.length, stiffness, damping, mass }
    }

    /// The segment between the nodes `ends`. Half of its mass goes to each of them.
    fn between(&self, ends: [usize; 2], group: usize, mass: &mut [f64]) -> Segment {
        for end in ends {
            mass[end] += 0.5 * self.mass;
        }
        let &Piece { rest_length, stiffness, damping, .. } = self;
        Segment { ends, rest_length, stiffness, damping, group, breaking: Breaking::NEVER }
    }
}

/// Adds the members of all canopies: spokes in three straight lines through the hub, then the sides round the rim. This
/// order makes the longest possible runs of segments.
pub fn add_links(
    cut: &CutWeb,
    made: &canopy_links::Members,
    group: usize,
    members: &mut Vec<Member>,
    mass: &mut [f64],
) {
    let spoke = Piece::of_canopy(made, made.spoke_stiffness, made.spoke_mass);
    let side = Piece::of_canopy(made, made.side_stiffness, made.side_mass);
    let mut add = |piece: &Piece, ends: [usize; 2], part: Part| {
        members.push(Member { segment: piece.between(ends, group, mass), part });
    };
    for (canopy, hexagon) in cut.web.canopies.iter().enumerate() {
        for number in [0, 3, 1, 4, 2, 5] {
            let ends = if number < 3 { [hexagon.rim[number], hexagon.hub] } else { [hexagon.hub, hexagon.rim[number]] };
            add(&spoke, ends, Part::Spoke { canopy, number });
        }
        for number in 0..6 {
            let ends = [hexagon.rim[number], hexagon.rim[(number + 1) % 6]];
            add(&side, ends, Part::Side { canopy, number });
        }
    }
}

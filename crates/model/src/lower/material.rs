//! Ropes, canopies and bodies as stiffness, damping and mass: the segments of the system and the masses of its nodes.

use std::f64::consts::PI;

use netcast_dynamics::forces::bending::Bending;
use netcast_dynamics::forces::breaking::Breaking;
use netcast_dynamics::forces::law::Law;
use netcast_dynamics::forces::rope_tension::{damping_from_ratio, damping_from_time};
use netcast_dynamics::system::Segment;
use netcast_webs::{Bill, Class, CutSegment, CutWeb, Parts, RopeKind, Solid, bill};

use super::assignment::{rings, ropes_of_links};
use super::canopies::Canopies;
use super::{canopy_links, rope_law};
use netcast_scenario::canopy::Canopy;
use netcast_scenario::csv_files::RopeRow;
use netcast_scenario::diagnostic::Diagnostics;
use netcast_scenario::document::Document;
use netcast_scenario::rope::{Damping, Rope};
use netcast_scenario::scenario::Scenario;

/// A segment of the system and what it is a part of.
#[derive(Debug, Clone, Copy)]
pub struct Member {
    /// As the system has it.
    pub segment: Segment,
    /// What it is a part of.
    pub part: Part,
}

/// What a segment is a part of; numbers count from 0.
#[derive(Debug, Clone, Copy)]
pub enum Part {
    Rope(CutSegment),
    Spoke { canopy: usize, number: usize },
    Side { canopy: usize, number: usize },
    Tie { number: usize },
    Stitch { row: usize, number: usize },
}

impl Member {
    /// What a message calls it.
    pub fn label(&self, cut: &CutWeb) -> String {
        let of = |what: &str, number: usize, canopy: usize| {
            format!("{what} {} of canopy {}", number + 1, cut.web.canopies[canopy].number)
        };
        match self.part {
            Part::Rope(segment) => cut.segment_label(&segment),
            Part::Spoke { canopy, number } => of("spoke", number, canopy),
            Part::Side { canopy, number } => of("side", number, canopy),
            Part::Tie { number } => {
                let [node, other] = self.segment.ends;
                let to = if other < cut.nodes.len() { format!(" to {}", cut.node_label(other)) } else { String::new() };
                format!("break tie {} at {}{to}", number + 1, cut.node_label(node))
            }
            Part::Stitch { row, number } => format!("stitch {} of row {}", number + 1, row + 1),
        }
    }

    /// Whether it is a piece of rope.
    pub fn is_rope(&self) -> bool {
        matches!(self.part, Part::Rope(_))
    }
}

/// What the web is made of.
pub struct Materials {
    pub members: Vec<Member>,
    pub mass: Vec<f64>,
    pub groups: Vec<Group>,
    pub bends: Vec<Bending>,
    pub canopies: Canopies,
    pub bodies: Vec<PlacedBody>,
    pub bill: Bill,
}

/// Segments of one link class that are made of one kind of rope.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Their link class.
    pub class: Class,
    /// The name of their rope, `rope` for the default one; none for members of canopies, ties and stitches.
    pub rope: Option<String>,
    /// Diameter of the rope, m; none for the members of canopies.
    pub diameter: Option<f64>,
    /// Its breaking load, N, where it is given.
    pub strength: Option<f64>,
    /// The share of its strength that knots take from it, where it is given.
    pub knot_reduction: Option<f64>,
    /// By which its tension follows from its stretch.
    pub law: Law,
    /// What it bears at most away from knots; the weakest of ties and stitches.
    pub breaking: Breaking,
}

/// What a body is there for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Pulls the web out.
    Tractor,
    /// Is carried.
    Payload,
    /// Sits in the middle.
    Sensor,
}

/// A body and the node that it sits on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacedBody {
    /// What it is there for.
    pub role: Role,
    /// Its node.
    pub node: usize,
    /// Its size and mass.
    pub solid: netcast_scenario::body::Solid,
    /// The system's rigid body that it is; none for a mass on a node.
    pub rigid: Option<usize>,
}

/// A rope from knot to knot, as `[assign]` can name it.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Its link class.
    pub class: Class,
    /// Its ring, from 1 in the middle, where it is of class `ring`.
    pub ring: Option<usize>,
    /// The name of its rope, `rope` for the default one.
    pub rope: String,
    /// Its length without tension as drawn, m.
    pub length: f64,
}

/// The links of a web whose segments and groups these are, in the order of the web.
pub fn links(web: &netcast_webs::Web, members: &[Member], groups: &[Group]) -> Vec<Link> {
    let rings = rings(web);
    let first_pieces = members.iter().filter_map(|member| match member.part {
        Part::Rope(CutSegment { place: 0, rope, .. }) => Some((rope, member.segment.class)),
        _ => None,
    });
    let link = |(rope, group): (usize, usize)| Link {
        name: web.ropes[rope].label.clone(),
        class: web.ropes[rope].class.clone(),
        ring: rings[rope],
        rope: groups[group].rope.clone().unwrap_or_default(),
        length: web.rest_length(&web.ropes[rope]),
    };
    first_pieces.map(link).collect()
}

/// Makes segments and masses of a cut web.
pub fn materials(
    document: &Document,
    cut: &mut CutWeb,
    scenario: &Scenario,
    notes: &mut Vec<String>,
) -> Result<Materials, Diagnostics> {
    let web = &cut.web.clone();
    let rows = document.graph.as_ref().map_or(&[][..], |g| &g.ropes);
    let kinds = ropes_of_links(document, scenario, web, rows, notes)?;
    let canopy = (!web.canopies.is_empty()).then(|| scenario.canopy.clone().unwrap_or_default());
    let groups = groups(document, scenario, web, &kinds, matches!(canopy, Some(Canopy::Links(_))))?;
    let group_number = |class: &Class, rope: Option<&str>| {
        let is_it = |group: &Group| group.class == *class && group.rope.as_deref() == rope;
        groups.iter().position(is_it).expect("every class is listed with its ropes")
    };
    let group_of_rope: Vec<usize> =
        web.ropes.iter().zip(&kinds).map(|(rope, (name, _))| group_number(&rope.class, Some(name))).collect();

    let mut mass = vec![0.0; cut.nodes.len()];
    let mut members = Vec::with_capacity(cut.segment_count());
    for segment in cut.segments() {
        let rope = &web.ropes[segment.rope];
        let pretension = pretension(rope.rest_length.is_some(), kinds[segment.rope].1, rows.get(segment.rope));
        let (kind, group, ends) = (kinds[segment.rope].1, group_of_rope[segment.rope], [segment.a, segment.b]);
        let piece = Piece::new(kind, &groups[group].law, segment.rest_length, pretension);
        let breaking = rope_law::breaking(kind, ends.iter().any(|&end| end < web.knots.len()));
        let piece = Segment { breaking, ..piece.between(ends, group, &mut mass) };
        members.push(Member { segment: piece, part: Part::Rope(segment) });
    }

    let bends = bends(document, cut, &kinds)?;

    let bodies = bodies(scenario, web);
    let (mut canopies, mut cloth) = (Canopies::default(), Solid::default());
    if let Some(canopy) = &canopy {
        (cloth.mass, cloth.volume) = canopy.mass_and_volume();
        if let Canopy::Links(links) = canopy {
            let made = canopy_links::members(links, cloth.mass);
            add_canopies(cut, &made, group_number(&Class::Canopy, None), &mut members, &mut mass);
        }
        canopies = Canopies::new(document, canopy, &bodies, cut, &mut mass)?;
    }
    for body in &bodies {
        if !canopies.carry(body, cut) {
            mass[body.node] += body.solid.mass_kg;
        }
    }
    for (node, row) in document.graph.iter().flat_map(|g| &g.nodes).enumerate() {
        mass[node] += row.mass_kg;
    }
    canopies.bind(cut, &mut mass);
    let tractors = bodies.iter().filter(|body| body.role == Role::Tractor);
    let tractor_masses = tractors.map(|body| body.solid.mass_kg).collect();
    let payload =
        scenario.payload_solid().map_or(Solid::default(), |p| Solid { mass: p.mass_kg, volume: p.shape.volume_m3() });
    let mut parts = Parts { ropes: Vec::new(), kind_of_rope: Vec::new(), canopy: cloth, payload, tractor_masses };
    for (name, rope) in &kinds {
        let kind = RopeKind {
            name: (*name).to_owned(),
            diameter: rope.diameter.si(),
            mass_per_metre: rope.density.si() * section(rope),
        };
        let known = parts.ropes.iter().position(|k| *k == kind).unwrap_or_else(|| {
            parts.ropes.push(kind);
            parts.ropes.len() - 1
        });
        parts.kind_of_rope.push(known);
    }
    Ok(Materials { members, mass, groups, bends, canopies, bodies, bill: bill(web, &parts) })
}

/// Each pair of link class and rope that the web has, in order of class.
fn groups(
    document: &Document,
    scenario: &Scenario,
    web: &netcast_webs::Web,
    kinds: &[(&str, &Rope)],
    canopies_are_links: bool,
) -> Result<Vec<Group>, Diagnostics> {
    let mut groups: Vec<Group> = Vec::new();
    for (rope, (name, kind)) in web.ropes.iter().zip(kinds) {
        if !groups.iter().any(|known| known.class == rope.class && known.rope.as_deref() == Some(name)) {
            let law = rope_law::law(document, &rope_law::path_of(scenario, name, kind), kind)?;
            groups.push(Group {
                class: rope.class.clone(),
                rope: Some((*name).to_owned()),
                diameter: Some(kind.diameter.si()),
                strength: kind.strength.map(|strength| strength.si()),
                knot_reduction: kind.knot_reduction.map(|share| share.si()),
                law,
                breaking: rope_law::breaking(kind, false),
            });
        }
    }
    if canopies_are_links {
        let (class, law, breaking) = (Class::Canopy, Law::Linear, Breaking::NEVER);
        groups.push(Group { class, rope: None, diameter: None, strength: None, knot_reduction: None, law, breaking });
    }
    groups.sort_by(|one, other| (&one.class, &one.rope).cmp(&(&other.class, &other.rope)));
    Ok(groups)
}

/// Where ropes resist bending: at every node inside a rope that has a bending stiffness. Knots turn freely.
fn bends(document: &Document, cut: &CutWeb, kinds: &[(&str, &Rope)]) -> Result<Vec<Bending>, Diagnostics> {
    let mut bends = Vec::new();
    for (rope, (name, kind)) in kinds.iter().enumerate() {
        let Some(stiffness) = kind.bending_stiffness else { continue };
        let Piece { rest_length, damping, stiffness: axial, .. } =
            Piece::new(kind, &Law::Linear, cut.ropes[rope].segment_length, 0.0);
        for nodes in cut.nodes_of(rope).windows(3) {
            let nodes = [nodes[0], nodes[1], nodes[2]];
            let bend = Bending::new(nodes, [rest_length; 2], stiffness.si(), damping / axial);
            bends.push(bend.map_err(|error| {
                let table = if *name == "rope" { "rope".to_owned() } else { format!("ropes.{name}") };
                document.diagnostic(&format!("{table}.bending_stiffness"), error.to_string())
            })?);
        }
    }
    Ok(bends)
}

/// Payloads, sensor and tractors where they sit.
fn bodies(scenario: &Scenario, web: &netcast_webs::Web) -> Vec<PlacedBody> {
    let on_canopies = web.canopies.iter().filter_map(|canopy| {
        let (role, solid) = match canopy.carries_payload {
            true => (Role::Payload, scenario.payload_solid()),
            false => (Role::Sensor, scenario.sensor_solid().filter(|_| canopy.is_centre)),
        };
        Some(PlacedBody { role, node: canopy.hub, solid: solid?, rigid: None })
    });
    let tractors = web.tractors.iter().enumerate().filter_map(|(corner, &node)| {
        Some(PlacedBody { role: Role::Tractor, node, solid: scenario.tractor_solid(corner as u32 + 1)?, rigid: None })
    });
    on_canopies.chain(tractors).collect()
}

/// Area of a rope's cross-section, m^2.
pub(super) fn section(rope: &Rope) -> f64 {
    0.25 * PI * rope.diameter.si() * rope.diameter.si()
}

/// Tension as drawn, N. A rope whose rest length is given has the tension that follows from it.
fn pretension(has_rest_length: bool, rope: &Rope, row: Option<&RopeRow>) -> f64 {
    let own = row.and_then(|r| r.pretension_n);
    if has_rest_length { own.unwrap_or(0.0) } else { own.unwrap_or(rope.pretension.si()) }
}

/// A segment before it has a place.
struct Piece {
    rest_length: f64,
    stiffness: f64,
    damping: f64,
    mass: f64,
}

impl Piece {
    /// A segment of rope `drawn` metres long under `pretension`, N: its rest length is shorter by the strain that its law
    /// has there.
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

    /// The segment between these nodes; half its mass goes to each.
    fn between(&self, ends: [usize; 2], class: usize, mass: &mut [f64]) -> Segment {
        for end in ends {
            mass[end] += 0.5 * self.mass;
        }
        let &Piece { rest_length, stiffness, damping, .. } = self;
        Segment { ends, rest_length, stiffness, damping, class, breaking: Breaking::NEVER }
    }
}

/// Spokes in three straight lines through the hub, then the sides round the rim: runs as long as they can be.
fn add_canopies(cut: &CutWeb, made: &canopy_links::Members, class: usize, members: &mut Vec<Member>, mass: &mut [f64]) {
    let spoke = Piece::of_canopy(made, made.spoke_stiffness, made.spoke_mass);
    let side = Piece::of_canopy(made, made.side_stiffness, made.side_mass);
    let mut add = |piece: &Piece, ends: [usize; 2], part: Part| {
        members.push(Member { segment: piece.between(ends, class, mass), part });
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

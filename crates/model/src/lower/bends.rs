//! Where ropes resist bending: at nodes inside ropes, at knots that ropes run through, and at clamped ends.

use netcast_dynamics::forces::bending::{Bending, Clamp};
use netcast_dynamics::forces::element::ElementError;
use netcast_dynamics::system::Segment;
use netcast_scenario::Diagnostics;
use netcast_webs::{CutSegment, CutWeb};

use super::assignment;
use super::draft::Draft;
use super::members::Part;
use super::selection::unknown_knot;

/// Two ropes that alone meet at a knot are one rope for bending if their directions in the drawing differ by less than
/// this angle, rad.
const RUNS_ON: f64 = 30.0 / 180.0 * std::f64::consts::PI;

/// A rope that resists bending.
#[derive(Clone, Copy)]
struct Beam {
    /// Bending stiffness EI, N m^2.
    stiffness: f64,
    /// Rest length of its segments, m.
    rest_length: f64,
    /// Damping over stiffness, s.
    damping_time: f64,
}

/// The end of a rope at a knot.
#[derive(Clone, Copy)]
struct End {
    rope: usize,
    /// The node next to the knot.
    next: usize,
}

/// A knot that a rope runs through for bending, with the ends of the two ropes that meet there.
struct Joint {
    knot: usize,
    ends: [End; 2],
}

/// Adds a bend at every node inside a rope that has a bending stiffness, and at knots where just two such ropes meet in
/// line. Other knots turn freely.
///
/// # Errors
/// A bending stiffness that the segments do not allow.
pub fn bend(draft: &mut Draft) -> Result<(), Diagnostics> {
    let beams = beams(draft);
    let joints = joints(&draft.cut, &beams);
    let Draft { document, scenario, cut, kinds, parts, notes, .. } = draft;
    let inside = beams.iter().enumerate().filter_map(|(rope, beam)| Some((rope, (*beam)?)));
    let inside = inside.flat_map(|(rope, Beam { stiffness, rest_length, damping_time })| {
        let nodes = cut.nodes_of(rope);
        let bend = |n: &[usize]| Bending::new([n[0], n[1], n[2]], [rest_length; 2], stiffness, damping_time);
        nodes.windows(3).map(|nodes| (rope, bend(nodes))).collect::<Vec<_>>()
    });
    let at_knots = joints.iter().map(|joint| (joint.ends[0].rope, through(joint, &beams)));
    let mut refused: Vec<(usize, ElementError)> = Vec::new();
    for (rope, bend) in inside.chain(at_knots) {
        match bend {
            Ok(bend) => parts.bends.push(bend),
            // one message a kind of rope
            Err(_) if refused.iter().any(|(other, _)| kinds[*other] == kinds[rope]) => {}
            Err(error) => refused.push((rope, error)),
        }
    }
    if !joints.is_empty() {
        let knots = if joints.len() == 1 { "1 knot".to_owned() } else { format!("{} knots", joints.len()) };
        notes.push(format!(
            "bending goes on through {knots} where just two ropes meet in line, to {:.0} degrees; other knots turn freely",
            RUNS_ON.to_degrees()
        ));
    }
    let known = assignment::ropes(scenario);
    let refused = refused.into_iter().map(|(rope, error)| {
        let path = assignment::table_of(known[kinds[rope]].0).key("bending_stiffness");
        document.diagnostic(&path.to_string(), error.to_string())
    });
    Diagnostics::fail_if_any(refused.collect())
}

/// Adds the clamps: ropes that resist bending keep the direction that they have at the start where they end at a node of
/// `hold.clamped`. Notes the ropes whose bending stiffness acts nowhere.
///
/// # Errors
/// An unknown node, and a node where no rope that resists bending ends.
pub fn clamp(draft: &mut Draft) -> Result<(), Diagnostics> {
    let (beams, ends) = (beams(draft), ends(&draft.cut));
    let mut is_bent: Vec<bool> = draft.cut.ropes.iter().map(|rope| rope.segments > 1).collect();
    for joint in joints(&draft.cut, &beams) {
        joint.ends.iter().for_each(|end| is_bent[end.rope] = true);
    }
    let Draft { document, scenario, cut, kinds, parts, state, notes, .. } = draft;
    let mut found = Vec::new();
    for (index, id) in scenario.hold.iter().flat_map(|hold| &hold.clamped).enumerate() {
        let path = format!("hold.clamped.{index}");
        let Some(knot) = cut.web.knot_named(id) else {
            found.push(unknown_knot(document, &path, id, cut));
            continue;
        };
        let resisting: Vec<(End, Beam)> = ends[knot].iter().filter_map(|end| Some((*end, beams[end.rope]?))).collect();
        if resisting.is_empty() {
            let message = format!("no rope with a bending stiffness ends at node {id:?}");
            found.push(document.diagnostic(&path, message).with_help("give its rope a `bending_stiffness`"));
        }
        for (End { rope, next }, Beam { stiffness, rest_length, damping_time }) in resisting {
            is_bent[rope] = true;
            let direction = state.position[next] - state.position[knot];
            match Clamp::new([knot, next], direction, rest_length, stiffness, damping_time) {
                Ok(clamp) => parts.clamps.push(clamp),
                Err(error) => found.push(document.diagnostic(&path, error.to_string())),
            }
        }
    }
    for (kind, (name, _)) in assignment::ropes(scenario).iter().enumerate() {
        let of_kind: Vec<usize> = (0..kinds.len()).filter(|&r| kinds[r] == kind && beams[r].is_some()).collect();
        if !of_kind.is_empty() && of_kind.iter().all(|&rope| !is_bent[rope]) {
            notes.push(format!(
                "{}.bending_stiffness does nothing: its ropes have no node inside",
                assignment::table_of(name)
            ));
        }
    }
    Diagnostics::fail_if_any(found)
}

/// The ropes that resist bending, (ropes,).
fn beams(draft: &Draft) -> Vec<Option<Beam>> {
    let known = assignment::ropes(&draft.scenario);
    let mut beams = vec![None; draft.kinds.len()];
    for member in &draft.members {
        let Part::Rope(CutSegment { rope, .. }) = member.part else { continue };
        let Segment { rest_length, damping, stiffness: axial, .. } = member.segment;
        beams[rope] = known[draft.kinds[rope]].1.bending_stiffness.map(|stiffness| Beam {
            stiffness: stiffness.si(),
            rest_length,
            damping_time: damping / axial,
        });
    }
    beams
}

/// The ends of ropes at each knot, (knots,).
fn ends(cut: &CutWeb) -> Vec<Vec<End>> {
    let mut ends = vec![Vec::new(); cut.web.knots.len()];
    for rope in 0..cut.ropes.len() {
        let nodes = cut.nodes_of(rope);
        ends[nodes[0]].push(End { rope, next: nodes[1] });
        ends[nodes[nodes.len() - 1]].push(End { rope, next: nodes[nodes.len() - 2] });
    }
    ends
}

/// The knots where just two ropes meet, both of which resist bending, nearly in line. Knots of canopies are none.
fn joints(cut: &CutWeb, beams: &[Option<Beam>]) -> Vec<Joint> {
    let on_canopy = |knot: usize| cut.web.canopies.iter().any(|c| c.hub == knot || c.rim.contains(&knot));
    let direction = |from: usize, to: usize| (cut.nodes[to] - cut.nodes[from]).normalize_or_zero();
    let joint = |(knot, ends): (usize, Vec<End>)| {
        let ends: [End; 2] = ends.try_into().ok()?;
        let [before, after] = ends.map(|end| direction(knot, end.next));
        let in_line = before.dot(after) < -libm::cos(RUNS_ON);
        (in_line && ends.iter().all(|end| beams[end.rope].is_some()) && !on_canopy(knot))
            .then_some(Joint { knot, ends })
    };
    ends(cut).into_iter().enumerate().filter_map(joint).collect()
}

/// The bend at a knot: half a segment of each rope bends, one after the other.
fn through(Joint { knot, ends }: &Joint, beams: &[Option<Beam>]) -> Result<Bending, ElementError> {
    let [before, after] = ends.map(|end| beams[end.rope].expect("both ropes of a joint resist bending"));
    let [soft_before, soft_after] = [before, after].map(|beam| beam.rest_length / beam.stiffness);
    let softness = soft_before + soft_after;
    let stiffness = (before.rest_length + after.rest_length) / softness;
    let damping_time = (soft_before * before.damping_time + soft_after * after.damping_time) / softness;
    let nodes = [ends[0].next, *knot, ends[1].next];
    Bending::new(nodes, [before.rest_length, after.rest_length], stiffness, damping_time)
}

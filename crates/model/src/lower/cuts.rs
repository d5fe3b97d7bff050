//! Ropes that are cut at a time: the segment of each in which the cut lies.

use netcast_scenario::Diagnostics;
use netcast_scenario::path::Path;
use netcast_webs::CutSegment;

use super::assignment::links_named;
use super::draft::Draft;
use super::members::Part;

/// Gives the segments that are cut the time of their cut. Notes cuts that the run does not reach.
///
/// # Errors
/// A link that the web does not have.
pub fn cut(draft: &mut Draft) -> Result<(), Diagnostics> {
    let Draft { document, scenario, cut, members, notes, .. } = draft;
    let mut found = Vec::new();
    for (index, asked) in scenario.cuts.iter().enumerate() {
        let path = Path::default().key("cuts").index(index);
        let links = match links_named(document, &path.key("link"), &cut.web, &asked.link) {
            Ok(links) => links,
            Err(unknown) => {
                found.push(unknown);
                continue;
            }
        };
        let time = asked.time.si();
        if scenario.solve.run_time().is_none_or(|end| time > end) {
            notes.push(format!("{:?} is not cut: the run does not reach {time} s", asked.link));
        }
        for member in members.iter_mut() {
            let Part::Rope(CutSegment { rope, place, .. }) = member.part else { continue };
            let segments = cut.ropes[rope].segments;
            let lies_in = ((asked.at.si() * segments as f64) as usize).min(segments - 1);
            if links.contains(&rope) && place == lies_in {
                let breaking = &mut member.segment.breaking;
                breaking.cut_at = breaking.cut_at.min(time);
            }
        }
    }
    Diagnostics::fail_if_any(found)
}

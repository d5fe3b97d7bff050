//! A web whose nodes are led along paths into its container.

use glam::DVec3;
use netcast_scenario::dimension::Dimension;
use netcast_scenario::interval::{PackingTime, Within};
use netcast_scenario::path::Path;
use netcast_scenario::quantity::Length;
use netcast_scenario::{Diagnostic, Diagnostics, Document, PrescribedStow};
use netcast_webs::{CutWeb, DrivenNode, Mouth, Prescribed, StiffPlate};

use super::drives::Drives;

/// The packing of a web whose nodes have `mass`, kg, (nodes,), and whose canopies keep their shape as `plates`.
///
/// # Errors
/// A path that cannot be followed, a led node that is not of the web itself.
pub fn prescribed(
    document: &Document,
    cut: &CutWeb,
    stow: &PrescribedStow,
    mass: &[f64],
    plates: Vec<StiffPlate>,
) -> Result<Prescribed, Diagnostics> {
    let flat = vec![DVec3::ZERO; cut.nodes.len()];
    let named = Drives { table: DRIVES, drives: &stow.drive, files: &document.files.stow_paths };
    let mut found = late_points(document, stow);
    let led = named.resolve(document, cut, &flat).unwrap_or_else(|Diagnostics(wrong)| {
        found.extend(wrong);
        Vec::new()
    });
    Diagnostics::fail_if_any(found)?;
    let is_web = cut.is_web();
    if let Some(drive) = led.iter().find(|drive| !is_web[drive.node]) {
        let message = format!(
            "{} is no part of the web itself: it is placed after the web is packed",
            cut.node_label(drive.node)
        );
        return Err(document.diagnostic(DRIVES, message).into());
    }
    Ok(Prescribed {
        radius: stow.radius.si(),
        depth: stow.depth.map(|depth| depth.si()),
        paths: led.into_iter().map(|drive| DrivenNode { node: drive.node, path: drive.path }).collect(),
        time: stow.time.si(),
        gravity: stow.gravity.si(),
        damping: stow.damping.si(),
        rest: stow.rest.si(),
        longest: stow.longest.si(),
        mass: mass.to_vec(),
        plates,
        mouth: mouth(stow.tractor_radius, stow.tractor_gap),
    })
}

/// Reports points of paths that lie beyond the longest time of a packing.
fn late_points(document: &Document, stow: &PrescribedStow) -> Vec<Diagnostic> {
    let late = stow.drive.iter().filter_map(|(name, drive)| {
        let path = Path::parse(DRIVES).key(name);
        let listed = drive.path.iter().flatten().enumerate();
        let listed = listed.map(|(index, point)| (path.key("path").index(index).key("time"), point.time.si()));
        let rows = document.files.stow_paths.get(name).into_iter().flatten();
        let points = listed.chain(rows.map(|row| (path.key("file"), row.time_s)));
        let (place, time) =
            points.into_iter().find(|&(_, time)| time > 0.0 && !PackingTime::INTERVAL.contains(time))?;
        let most = PackingTime::INTERVAL.describe(Dimension::default());
        Some(document.diagnostic(&place.to_string(), format!("expected a time {most} s, found {time} s")))
    });
    late.collect()
}

/// The table of the led nodes.
const DRIVES: &str = "stow.prescribed.drive";

/// The place of the tractors above a packed web: radius of their ring and gap to the web, m.
pub(super) fn mouth<A, B>(tractor_radius: Option<Length<A>>, tractor_gap: Option<Length<B>>) -> Mouth {
    Mouth { tractor_radius: tractor_radius.map(|r| r.si()), tractor_gap: tractor_gap.map(|g| g.si()) }
}

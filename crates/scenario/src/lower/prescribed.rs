//! A web that is led into its container: what is led, along which paths.

use glam::DVec3;
use netcast_webs::{CutWeb, Led, Prescribed, StiffPlate};

use super::drives::Drives;
use super::stowing::mouth;
use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::stow::PrescribedStow;

/// The packing of a web whose nodes have `mass`, kg, and whose canopies keep their shape as `plates`.
pub fn prescribed(
    document: &Document,
    cut: &CutWeb,
    stow: &PrescribedStow,
    mass: &[f64],
    plates: Vec<StiffPlate>,
) -> Result<Prescribed, Diagnostics> {
    let flat = vec![DVec3::ZERO; cut.nodes.len()];
    let named = Drives { table: DRIVES, drives: &stow.drive, files: &document.stow_paths };
    let led = named.resolve(document, cut, &flat)?;
    let is_web = cut.is_web();
    if let Some(drive) = led.iter().find(|drive| !is_web[drive.node]) {
        let message =
            format!("{} is no part of the web itself: it is placed when that is packed", cut.node_label(drive.node));
        return Err(document.diagnostic(DRIVES, message).into());
    }
    Ok(Prescribed {
        radius: stow.radius.si(),
        depth: stow.depth.map(|depth| depth.si()),
        paths: led.into_iter().map(|drive| Led { node: drive.node, path: drive.path }).collect(),
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

/// Where what is led stands.
const DRIVES: &str = "stow.prescribed.drive";

//! The launch frame and the velocities at the start.

use std::f64::consts::FRAC_PI_2;

use glam::{DMat3, DVec3};
use netcast_webs::CutWeb;

use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::launch::Launch;
use crate::scenario::Scenario;

/// Turns the launch frame to the world: z to (azimuth, elevation).
pub fn frame(scenario: &Scenario) -> DMat3 {
    turned(&scenario.launch.clone().unwrap_or_default())
}

/// First about y by the angle from the vertical, then about z by the azimuth.
fn turned(launch: &Launch) -> DMat3 {
    let tilt = FRAC_PI_2 - launch.elevation.si();
    let azimuth = launch.azimuth.si();
    let (ct, st) = (libm::cos(tilt), libm::sin(tilt));
    let (ca, sa) = (libm::cos(azimuth), libm::sin(azimuth));
    let about_y = DMat3::from_cols(DVec3::new(ct, 0.0, -st), DVec3::Y, DVec3::new(st, 0.0, ct));
    let about_z = DMat3::from_cols(DVec3::new(ca, sa, 0.0), DVec3::new(-sa, ca, 0.0), DVec3::Z);
    about_z * about_y
}

/// Velocities of all nodes at the start, world frame, m/s: what a graph's file says, and the tractors' launch along
/// the axis and away from it, in the direction of their own corner.
pub fn velocities(document: &Document, cut: &CutWeb, scenario: &Scenario) -> Result<Vec<DVec3>, Diagnostics> {
    let web = &cut.web;
    let mut velocity = vec![DVec3::ZERO; cut.nodes.len()];
    let web_frame = frame(scenario);
    for (node, row) in document.graph.iter().flat_map(|g| &g.nodes).enumerate() {
        velocity[node] = web_frame * DVec3::from_array(row.velocity_m_s);
    }

    let mut found = Vec::new();
    for (index, tractor) in scenario.tractors.iter().enumerate() {
        let corner = tractor.corner.get() as usize;
        if corner > web.corners.len() {
            let message = format!("the web has {} corners, not {corner}", web.corners.len());
            found.push(document.diagnostic(&format!("tractors.{index}.corner"), message));
        }
    }
    let moves = |launch: &Launch| launch.axial_speed.si() != 0.0 || launch.radial_speed.si() != 0.0;
    if web.tractors.is_empty() && scenario.launch.as_ref().is_some_and(moves) {
        let message = "nothing to launch: the scenario has no tractors";
        found.push(document.diagnostic("launch", message).with_help("add [tractor.particle] or [tractor.cylinder]"));
    }
    Diagnostics::fail_if_any(found)?;

    for (index, (&corner, &tractor)) in web.corners.iter().zip(&web.tractors).enumerate() {
        let Some(launch) = scenario.tractor_launch(index as u32 + 1) else { continue };
        let outwards = web.knots[corner].position - web.middle;
        let radial = DVec3::new(outwards.x, outwards.y, 0.0).normalize_or_zero();
        let in_frame = launch.radial_speed.si() * radial + launch.axial_speed.si() * DVec3::Z;
        velocity[tractor] = turned(&launch) * in_frame;
    }
    Ok(velocity)
}

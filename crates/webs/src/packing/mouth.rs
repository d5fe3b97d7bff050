//! Places tractors and traction ropes above a packed web. The tractors stand in the muzzle's plane, and the web hangs
//! below them.

use glam::DVec3;

use super::PackingError;
use crate::{CutWeb, Rope, Web};

/// Default gap as a share of the traction ropes' length; the ropes are then slack.
const DEFAULT_SHARE: f64 = 0.6;

/// Largest relative excess of a size over its limit that is ascribed to rounding.
pub(super) const ROUNDING: f64 = 1e-12;

/// Places of the tractors; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Mouth {
    /// Radius of the circle of tractors, each in the direction of its corner; none: the packed web's radius.
    pub tractor_radius: Option<f64>,
    /// Distance from the top of the packed web up to the tractors; none: 0.6 of the traction ropes' length, or less if
    /// this would stretch them. Without traction ropes the tractors lie at the corners, and this is the distance from
    /// the top of the web to the muzzle; none: 0.
    pub tractor_gap: Option<f64>,
}

impl Mouth {
    /// Lowers a packed web by the gap and places tractors and traction ropes above it. The web comes with its top at z
    /// = 0 and this radius, m. Nodes of traction ropes are spaced evenly on the line from corner to tractor.
    pub(super) fn close(&self, cut_web: &CutWeb, packed: &mut [DVec3], radius: f64) -> Result<(), PackingError> {
        let web = &cut_web.web;
        let radius = size("tractor_radius", "tractors' radius", self.tractor_radius.unwrap_or(radius))?;
        let gap = self.gap(web, packed, radius)?;
        for node in packed.iter_mut() {
            *node -= DVec3::Z * gap;
        }
        for (tractor, ropes) in web.traction.iter().enumerate() {
            packed[web.tractors[tractor]] = place(web, tractor, radius);
            for &rope in ropes {
                let Rope { a, b, .. } = web.ropes[rope];
                let (corner, end) = (packed[a], packed[b]);
                for (node, place) in cut_web.ropes[rope].interior().zip(1..) {
                    packed[node] = corner + (end - corner) * (f64::from(place) / cut_web.ropes[rope].segments as f64);
                }
            }
        }
        Ok(())
    }

    /// Distance from the top of the packed web up to the muzzle, m.
    fn gap(&self, web: &Web, packed: &[DVec3], radius: f64) -> Result<f64, PackingError> {
        let stated = self.tractor_gap.map(|gap| size("tractor_gap", "tractor gap", gap)).transpose()?;
        let mut default = f64::INFINITY;
        for (tractor, ropes) in web.traction.iter().enumerate() {
            // `corner` lies where a gap of 0 leaves it; `limit` is the largest gap that the rope can bridge
            let corner = packed[web.corners[tractor]];
            let place = place(web, tractor, radius);
            let aside = corner.truncate().distance(place.truncate());
            for &rope in ropes {
                let length = web.rest_length(&web.ropes[rope]);
                let limit = (length * length - aside * aside).max(0.0).sqrt() + corner.z;
                if aside > length || limit < 0.0 {
                    let tractor = web.knots[web.tractors[tractor]].label.clone();
                    return Err(PackingError::TractorOutOfReach { tractor, distance: corner.distance(place), length });
                }
                if let Some(gap) = stated.filter(|&gap| gap > limit * (1.0 + ROUNDING)) {
                    return Err(PackingError::Gap { gap, limit, rope: web.ropes[rope].label.clone() });
                }
                default = default.min(limit).min(DEFAULT_SHARE * length);
            }
        }
        Ok(stated.unwrap_or(if web.traction.is_empty() { 0.0 } else { default }))
    }
}

/// A tractor's place on its circle in the muzzle's plane, m, in the direction of its corner in the flat web.
fn place(web: &Web, tractor: usize, radius: f64) -> DVec3 {
    let corner = web.knots[web.corners[tractor]].position - web.middle;
    corner.with_z(0.0).normalize_or_zero() * radius
}

/// Returns a size, m, unless it is negative or not finite. `what` names it in the message.
pub(super) fn size(argument: &'static str, what: &'static str, value: f64) -> Result<f64, PackingError> {
    if value >= 0.0 && value.is_finite() { Ok(value) } else { Err(PackingError::Size { argument, what, value }) }
}

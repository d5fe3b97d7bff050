//! Tractors and traction ropes above a packed web: the tractors stand in the muzzle's plane, the web hangs a gap below.

use glam::DVec3;

use super::PackingError;
use crate::{CutWeb, PackingField, Rope, Web};

/// Share of the traction ropes' length that the gap takes where none is stated: far from stretched.
const DEFAULT_SHARE: f64 = 0.6;

/// What rounding may add to a size at its limit, relative.
pub(super) const ROUNDING: f64 = 1e-12;

/// Where the tractors stand; lengths in m.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Mouth {
    /// Radius of the circle that the tractors stand on, each in the direction of its corner; the packed web's own
    /// where none is stated.
    pub tractor_radius: Option<f64>,
    /// How far the packed web lies below the tractors; 0.6 of the traction ropes' length where none is stated, or less
    /// where they would be stretched. Without traction ropes the tractors are the corners: the gap then only sets the
    /// web back from the muzzle, by 0 where none is stated.
    pub tractor_gap: Option<f64>,
}

impl Mouth {
    /// Lowers a packed web, whose top lies at z = 0, by the gap, and puts tractors and traction ropes above it; `radius`
    /// is that of the packed web, m. Nodes of traction ropes lie evenly on the line from corner to tractor.
    pub(super) fn close(&self, cut_web: &CutWeb, packed: &mut [DVec3], radius: f64) -> Result<(), PackingError> {
        let web = &cut_web.web;
        let radius = size(PackingField::TractorRadius, self.tractor_radius.unwrap_or(radius))?;
        let gap = self.gap(web, packed, radius)?;
        packed.iter_mut().for_each(|node| *node -= DVec3::Z * gap);
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

    /// How far the top of the packed web lies below the muzzle, m.
    fn gap(&self, web: &Web, packed: &[DVec3], radius: f64) -> Result<f64, PackingError> {
        let stated = self.tractor_gap.map(|gap| size(PackingField::TractorGap, gap)).transpose()?;
        let mut default = f64::INFINITY;
        for (tractor, ropes) in web.traction.iter().enumerate() {
            // the corner as it lies with no gap, and how far down the rope still reaches from its tractor
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

/// A tractor's place in the muzzle's plane, in the direction of its corner.
fn place(web: &Web, tractor: usize, radius: f64) -> DVec3 {
    let corner = web.knots[web.corners[tractor]].position - web.middle;
    corner.with_z(0.0).normalize_or_zero() * radius
}

/// A size that is not negative.
pub(super) fn size(what: PackingField, value: f64) -> Result<f64, PackingError> {
    if value >= 0.0 && value.is_finite() { Ok(value) } else { Err(PackingError::Size { what, value }) }
}

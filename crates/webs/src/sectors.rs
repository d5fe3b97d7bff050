//! The drawing that the polygon web and the radial-and-ring web share: concentric regular polygons joined by radials.
//!
//! A sector lies between the radials to two neighbouring corners and has radials of its own inside. Every radial lies
//! on a ray from the middle: radial k of m in a sector meets each ring at the share k / m of its side.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::plane::direction;
use crate::rope_list::RopeList;
use crate::{Class, Knot, Site, Web};

/// Sizes of such a web.
pub(crate) struct Sectors {
    /// Number of corners of each ring.
    pub(crate) corners: usize,
    /// Number of web corners, evenly spaced among the corners of the outline: a divisor of `corners`.
    pub(crate) web_corners: usize,
    /// Distance of each ring's corners from the middle, ascending, m; a first radius of 0 gives one knot in the middle.
    pub(crate) radii: Vec<f64>,
    /// Number of radials in a sector between each ring and the next, (rings - 1,). The radial to the sector's first
    /// corner counts, the one to its second corner does not. Each number divides the one after it.
    pub(crate) divisions: Vec<usize>,
}

impl Sectors {
    /// Draws the web. Knots are numbered ring by ring outwards, each ring anticlockwise from 90 degrees. Classes:
    /// outline, ring, radial. Feature points lie on the ray at 90 degrees: B is the innermost knot, C the corner, D the
    /// knot half way between or, if there is none, the middle of the rope.
    pub(crate) fn web(&self) -> Web {
        let mut web = Web::default();
        let rings: Vec<Vec<usize>> = (0..self.radii.len()).map(|ring| self.add_ring(&mut web.knots, ring)).collect();
        let (inmost, outline) = (&rings[0], &rings[rings.len() - 1]);
        web.corners = outline.iter().step_by(outline.len() / self.web_corners).copied().collect();
        for (&corner, number) in web.corners.iter().zip(1..) {
            web.knots[corner] = Knot::new(format!("web corner {number}"), web.knots[corner].position);
        }

        let mut ropes = RopeList::default();
        for (number, ring) in rings.iter().enumerate().filter(|(_, ring)| ring.len() > 1) {
            let closed: Vec<usize> = ring.iter().chain(&ring[..1]).copied().collect();
            ropes.tie_along(&closed, if number + 1 == rings.len() { Class::Outline } else { Class::Ring });
        }
        for (band, pair) in rings.windows(2).enumerate() {
            let radials = self.corners * self.divisions[band];
            for radial in 0..radials {
                // all radials share the knot in the middle
                let on = |ring: &[usize]| ring[radial * ring.len() / radials];
                ropes.tie(on(&pair[0]), on(&pair[1]), Class::Radial);
            }
        }
        web.ropes = ropes.into_ropes();

        web.outline = outline.iter().map(|&knot| vec![knot]).collect();
        web.centre = inmost.clone();
        let (b, c) = (inmost[0], outline[0]);
        let half_way = match &rings[1..rings.len() - 1] {
            [] => {
                let rope = web.ropes.iter().position(|rope| rope.a == b && rope.b == c);
                Site::OnRope { rope: rope.expect("a radial runs to every corner"), fraction: 0.5 }
            }
            between => Site::Knot(between[(between.len() - 1) / 2][0]),
        };
        web.points = BTreeMap::from([("B".into(), Site::Knot(b)), ("C".into(), Site::Knot(c)), ("D".into(), half_way)]);
        web
    }

    /// Adds the knots of a ring: at its corners, and where the radials of the band outside it begin.
    fn add_ring(&self, knots: &mut Vec<Knot>, ring: usize) -> Vec<usize> {
        let first = knots.len();
        let mut add = |position| knots.push(Knot::new(format!("knot {}", knots.len() + 1), position));
        let (radius, per_side) = (self.radii[ring], self.divisions[ring.min(self.divisions.len() - 1)]);
        if radius == 0.0 {
            add(DVec3::ZERO);
        } else {
            for corner in 0..self.corners {
                let ends = [corner, corner + 1].map(|corner| direction(corner, self.corners) * radius);
                for place in 0..per_side {
                    // a symmetric expression in the two corners, so that mirror images are exact
                    add((ends[0] * (per_side - place) as f64 + ends[1] * place as f64) / per_side as f64);
                }
            }
        }
        (first..knots.len()).collect()
    }
}

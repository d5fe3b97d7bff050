//! The triangular lattice of the topological web and the space web: a hexagon cut into equilateral triangles, three
//! along each side.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::Class;

/// Number of links along a side of the hexagon: the lattice's frequency.
const FREQUENCY: i32 = 3;

/// A place for a knot: its coordinates along the directions of 30 and 90 degrees, in links.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct LatticeSite {
    q: i32,
    r: i32,
}

impl LatticeSite {
    const CENTRE: LatticeSite = LatticeSite { q: 0, r: 0 };

    /// The neighbour at 30 + 60 `direction` degrees.
    fn neighbour(self, direction: usize) -> LatticeSite {
        let (q, r) = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)][direction % 6];
        LatticeSite { q: self.q + q, r: self.r + r }
    }

    /// Number of links from the centre.
    fn ring(self) -> i32 {
        self.q.abs().max(self.r.abs()).max((self.q + self.r).abs())
    }

    /// Whether it lies on one of the three lattice lines through the centre.
    fn is_on_axis(self) -> bool {
        self.q == 0 || self.r == 0 || self.q + self.r == 0
    }

    /// Position, in links: x = sqrt(3)/2 q, y = q/2 + r.
    fn position(self) -> DVec3 {
        let (q, r) = (f64::from(self.q), f64::from(self.r));
        DVec3::new(0.75_f64.sqrt() * q, 0.5 * q + r, 0.0)
    }
}

/// What stands on a knot of the lattice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Occupant {
    /// The plate (canopy or rope hexagon) with this number, from 1.
    Plate(usize),
    /// The bare web corner with this number, from 1.
    Corner(usize),
}

/// A knot of the lattice.
pub(crate) struct LatticeKnot {
    pub(crate) position: DVec3,
    pub(crate) occupant: Occupant,
    /// Number of links from the centre: 0 in the centre, [`FREQUENCY`] on the outline.
    pub(crate) ring: i32,
}

/// A link between two neighbouring knots. Knot `a` lies on the same ring as knot `b`, or on the ring inside it.
pub(crate) struct LatticeLink {
    pub(crate) a: usize,
    pub(crate) b: usize,
    /// The link points from `a` to `b` at 30 + 60 `direction` degrees.
    pub(crate) direction: usize,
    pub(crate) class: Class,
}

/// The lattice of a web.
pub(crate) struct Lattice {
    /// Length of a link, m.
    pub(crate) spacing: f64,
    /// Plates in the order of their numbers, then the six corners. Plates are numbered from the outline inwards, ring
    /// by ring, each ring anticlockwise from 30 degrees.
    pub(crate) knots: Vec<LatticeKnot>,
    /// Links, class by class.
    pub(crate) links: Vec<LatticeLink>,
    /// The knots of the outline, anticlockwise from the corner at 30 degrees.
    pub(crate) outline: Vec<usize>,
}

/// The lattice in a hexagon with this side, m.
pub(crate) fn lattice(side: f64) -> Lattice {
    let spacing = side / f64::from(FREQUENCY);
    let rings = (1..=FREQUENCY).rev().map(ring);

    // plates from the outline inwards, then the corners without plates
    let is_corner = |site: &LatticeSite| site.ring() == FREQUENCY && site.is_on_axis();
    let walk: Vec<LatticeSite> = rings.flatten().chain([LatticeSite::CENTRE]).collect();
    let (corners, plates): (Vec<_>, Vec<_>) = walk.iter().copied().partition(is_corner);
    let occupants = (1..=plates.len()).map(Occupant::Plate).chain((1..=corners.len()).map(Occupant::Corner));
    let sites: Vec<LatticeSite> = plates.iter().chain(&corners).copied().collect();
    let index: BTreeMap<LatticeSite, usize> = sites.iter().enumerate().map(|(knot, &site)| (site, knot)).collect();
    let knots = sites
        .iter()
        .zip(occupants)
        .map(|(&site, occupant)| LatticeKnot { position: site.position() * spacing, occupant, ring: site.ring() })
        .collect();

    let mut links = Vec::new();
    for (a, &site) in sites.iter().enumerate() {
        for direction in 0..6 {
            let neighbour = site.neighbour(direction);
            let Some(&b) = index.get(&neighbour) else { continue };
            // each link once, from the inner ring to the outer
            if (site.ring(), a) < (neighbour.ring(), b) {
                links.push(LatticeLink { a, b, direction, class: class(site, neighbour) });
            }
        }
    }
    links.sort_by(|a, b| a.class.cmp(&b.class));

    let outline = ring(FREQUENCY).iter().map(|site| index[site]).collect();
    Lattice { spacing, knots, links, outline }
}

/// The sites k links from the centre, anticlockwise from the one at 30 degrees.
fn ring(k: i32) -> Vec<LatticeSite> {
    let mut site = LatticeSite { q: k, r: 0 };
    let mut sites = Vec::new();
    for side in 0..6 {
        for _ in 0..k {
            sites.push(site);
            site = site.neighbour(side + 2);
        }
    }
    sites
}

/// Link class of the link between two neighbouring sites.
fn class(a: LatticeSite, b: LatticeSite) -> Class {
    if a.ring() == b.ring() {
        if a.ring() == FREQUENCY { Class::Outline } else { Class::Ring }
    } else if a.q * b.r == a.r * b.q {
        // the two sites and the centre lie on one line
        Class::Radial
    } else {
        Class::Inner
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plane::compass;

    #[test]
    fn the_lattice_has_37_knots_and_90_links() {
        let lattice = lattice(2.5);
        assert_eq!(lattice.knots.len(), 37);
        assert_eq!(lattice.links.len(), 90);
        let count = |class| lattice.links.iter().filter(|link| link.class == class).count();
        assert_eq!(count(Class::Outline), 18);
        assert_eq!(count(Class::Ring), 12 + 6);
        assert_eq!(count(Class::Radial), 6 * 3);
        assert_eq!(count(Class::Inner), 90 - 3 * 18);
    }

    #[test]
    fn plates_are_numbered_from_the_outline_to_the_centre() {
        let lattice = lattice(2.5);
        for (index, knot) in lattice.knots.iter().enumerate() {
            let expected = if index < 31 { Occupant::Plate(index + 1) } else { Occupant::Corner(index - 30) };
            assert_eq!(knot.occupant, expected);
        }
        let ring = |number: usize| lattice.knots[number - 1].ring;
        assert!((1..=12).all(|number| ring(number) == 3));
        assert!((13..=24).all(|number| ring(number) == 2));
        assert!((25..=30).all(|number| ring(number) == 1));
        assert_eq!(lattice.knots[30].position, DVec3::ZERO);
    }

    #[test]
    fn every_link_is_a_third_of_the_side_long_and_points_in_its_direction() {
        let lattice = lattice(2.5);
        for link in &lattice.links {
            let run = lattice.knots[link.b].position - lattice.knots[link.a].position;
            assert!(run.distance(compass(link.direction) * 2.5 / 3.0) < 1e-12);
            assert!(lattice.knots[link.a].ring <= lattice.knots[link.b].ring);
        }
    }

    #[test]
    fn a_sixth_of_a_turn_maps_the_lattice_onto_itself() {
        let lattice = lattice(1.0);
        for knot in &lattice.knots {
            let (p, cos, sin) = (knot.position, 0.5, 0.75_f64.sqrt());
            let turned = DVec3::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y, 0.0);
            assert!(lattice.knots.iter().any(|other| other.position.distance(turned) < 1e-12));
        }
    }
}

//! The triangular lattice that the topological and the space web share: a hexagon cut into equilateral triangles,
//! three to a side.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::Class;

/// Lattice links along a side of the hexagon: its "frequency".
const FREQUENCY: i32 = 3;

/// Steps to a knot's six neighbours. A site of the lattice has the coordinates (q, r), in links along the directions of 30
/// and 90 degrees; step k points to 30 + 60 k degrees.
const STEPS: [(i32, i32); 6] = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];

/// What stands on a lattice knot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Occupant {
    /// A plate (canopy or rope hexagon) of this number, from 1.
    Plate(usize),
    /// The bare corner of this number, from 1.
    Corner(usize),
}

/// A knot of the lattice.
pub(crate) struct LatticeKnot {
    pub(crate) position: DVec3,
    pub(crate) occupant: Occupant,
    /// The lattice hexagon that it stands on: 0 for the centre, [`FREQUENCY`] for the outline.
    pub(crate) ring: i32,
}

/// A link between two neighbouring knots. The ring of `a` is never the outer one of the two.
pub(crate) struct LatticeLink {
    pub(crate) a: usize,
    pub(crate) b: usize,
    /// From a to b is 30 + 60 `direction` degrees.
    pub(crate) direction: usize,
    pub(crate) class: Class,
}

/// Knots: plates in the order of their numbers (the outline's, then ring by ring inwards, the centre's last; each
/// ring anticlockwise from 30 degrees), then the six corners. Links: class by class.
pub(crate) struct Lattice {
    pub(crate) spacing: f64,
    pub(crate) knots: Vec<LatticeKnot>,
    pub(crate) links: Vec<LatticeLink>,
    /// The knots of the outline, anticlockwise from the corner at 30 degrees.
    pub(crate) outline: Vec<usize>,
}

/// The lattice in a hexagon of this side, m.
pub(crate) fn lattice(side: f64) -> Lattice {
    let spacing = side / f64::from(FREQUENCY);
    let rings = (1..=FREQUENCY).rev().map(ring);

    // plates from the outline inwards, then the corners that have none
    let is_corner = |&(q, r): &(i32, i32)| ring_of((q, r)) == FREQUENCY && is_on_axis((q, r));
    let walk: Vec<(i32, i32)> = rings.flatten().chain([(0, 0)]).collect();
    let (corners, plates): (Vec<_>, Vec<_>) = walk.iter().copied().partition(is_corner);
    let occupants = (1..=plates.len()).map(Occupant::Plate).chain((1..=corners.len()).map(Occupant::Corner));
    let sites: Vec<(i32, i32)> = plates.iter().chain(&corners).copied().collect();
    let index: BTreeMap<(i32, i32), usize> = sites.iter().enumerate().map(|(knot, &site)| (site, knot)).collect();
    let knots = sites
        .iter()
        .zip(occupants)
        .map(|(&site, occupant)| LatticeKnot { position: position(site) * spacing, occupant, ring: ring_of(site) })
        .collect();

    let mut links = Vec::new();
    for (a, &site) in sites.iter().enumerate() {
        for (direction, step) in STEPS.iter().enumerate() {
            let neighbour = (site.0 + step.0, site.1 + step.1);
            let Some(&b) = index.get(&neighbour) else { continue };
            // each link once, from the inner ring outwards
            if (ring_of(site), a) < (ring_of(neighbour), b) {
                links.push(LatticeLink { a, b, direction, class: class(site, neighbour) });
            }
        }
    }
    links.sort_by(|a, b| a.class.cmp(&b.class));

    let outline = ring(FREQUENCY).iter().map(|site| index[site]).collect();
    Lattice { spacing, knots, links, outline }
}

/// The sites of the k-th lattice hexagon, anticlockwise from the one at 30 degrees.
fn ring(k: i32) -> Vec<(i32, i32)> {
    let mut site = (k * STEPS[0].0, k * STEPS[0].1);
    let mut sites = Vec::new();
    for side in 0..6 {
        let step = STEPS[(side + 2) % 6];
        for _ in 0..k {
            sites.push(site);
            site = (site.0 + step.0, site.1 + step.1);
        }
    }
    sites
}

/// Number of links from the centre.
fn ring_of((q, r): (i32, i32)) -> i32 {
    q.abs().max(r.abs()).max((q + r).abs())
}

/// Whether a site lies on one of the three lattice lines through the centre.
fn is_on_axis((q, r): (i32, i32)) -> bool {
    q == 0 || r == 0 || q + r == 0
}

/// Where a site lies, in links: x = sqrt(3)/2 q, y = q/2 + r.
fn position((q, r): (i32, i32)) -> DVec3 {
    DVec3::new(0.75_f64.sqrt() * f64::from(q), 0.5 * f64::from(q) + f64::from(r), 0.0)
}

fn class(a: (i32, i32), b: (i32, i32)) -> Class {
    if ring_of(a) == ring_of(b) {
        if ring_of(a) == FREQUENCY { Class::Outline } else { Class::Ring }
    } else if a.0 * b.1 == a.1 * b.0 {
        // neighbours in line with the centre
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
    fn thirty_seven_knots_and_ninety_links() {
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
        for (knot, of) in lattice.knots.iter().enumerate() {
            let expected = if knot < 31 { Occupant::Plate(knot + 1) } else { Occupant::Corner(knot - 30) };
            assert_eq!(of.occupant, expected);
        }
        let ring = |number: usize| lattice.knots[number - 1].ring;
        assert!((1..=12).all(|number| ring(number) == 3));
        assert!((13..=24).all(|number| ring(number) == 2));
        assert!((25..=30).all(|number| ring(number) == 1));
        assert_eq!(lattice.knots[30].position, DVec3::ZERO);
    }

    #[test]
    fn every_link_is_a_third_of_the_side_and_points_where_it_says() {
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

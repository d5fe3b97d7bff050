//! The drawing that the topological web and the space web share: hexagonal plates on a triangular lattice, joined by
//! double ropes.
//!
//! Each side of a plate faces one of its six neighbours. A link is a pair of parallel ropes between two facing sides,
//! from corner to corner. The six corners of the web have no plate: both ropes of a link run to the corner's knot.

use std::collections::BTreeMap;

use glam::DVec3;

use crate::error::{positive, rounded};
use crate::lattice::{Lattice, LatticeLink, Occupant, lattice};
use crate::plane::hexagon_corner;
use crate::{Class, Knot, Rope, Site, Web, WebError};

/// The kind of plate on the knots of the lattice.
pub(crate) struct PlateKind {
    /// Singular of its name, for labels.
    pub(crate) name: &'static str,
    /// Plural of its name, for errors.
    pub(crate) names: &'static str,
    /// Name of the argument for the side of a plate.
    pub(crate) side_argument: &'static str,
    /// Whether a plate has a knot in its centre.
    pub(crate) has_hub: bool,
}

/// The knots of a plate.
pub(crate) struct Plate {
    /// The knot in the centre, if there is one.
    pub(crate) hub: Option<usize>,
    /// The knots at its corners, anticlockwise; corner k lies at 60 k degrees from the x axis.
    pub(crate) rim: [usize; 6],
}

impl Plate {
    /// The knots whose mean is the plate's centre.
    pub(crate) fn centre(&self) -> Vec<usize> {
        self.hub.map_or_else(|| self.rim.to_vec(), |hub| vec![hub])
    }
}

/// Draws the plates and the links between them: a web with this side and plates with side `plate_side`, both m. Returns
/// the web and its plates in the order of their numbers.
pub(crate) fn plated_web(kind: &PlateKind, side: f64, plate_side: f64) -> Result<(Web, Vec<Plate>), WebError> {
    positive("side", "the web's side", side)?;
    positive(kind.side_argument, &format!("the {}' side", kind.names), plate_side)?;
    let lattice = lattice(side);
    let limit = lattice.spacing / 3.0_f64.sqrt();
    if plate_side >= limit {
        let (names, limit) = (kind.names, rounded(limit));
        return Err(WebError::argument(
            kind.side_argument,
            format!(
                "{names} with sides of {plate_side} m leave no room for the ropes between them; their side must be less \
                 than {limit} m"
            ),
        ));
    }

    let mut web = Web::default();
    let mut plates = Vec::new();
    for knot in &lattice.knots {
        match knot.occupant {
            Occupant::Plate(number) => {
                let label = format!("{} {number}", kind.name);
                plates.push(add_plate(&mut web.knots, &label, knot.position, plate_side, kind.has_hub));
            }
            Occupant::Corner(number) => {
                web.corners.push(web.knots.len());
                web.knots.push(Knot::new(format!("web corner {number}"), knot.position));
            }
        }
    }
    for link in &lattice.links {
        web.ropes.extend(double_rope(&lattice, link, &plates, &web.corners));
    }
    web.outline = lattice
        .outline
        .iter()
        .map(|&knot| match lattice.knots[knot].occupant {
            Occupant::Plate(number) => plates[number - 1].centre(),
            Occupant::Corner(number) => vec![web.corners[number - 1]],
        })
        .collect();
    web.centre = plates[plates.len() - 1].centre();
    web.points = feature_points(&lattice, &plates);
    Ok((web, plates))
}

/// Adds the knots of a plate with this centre and side, m.
fn add_plate(knots: &mut Vec<Knot>, label: &str, centre: DVec3, side: f64, has_hub: bool) -> Plate {
    let hub = has_hub.then(|| {
        knots.push(Knot::new(format!("centre of {label}"), centre));
        knots.len() - 1
    });
    let rim = std::array::from_fn(|corner| {
        knots.push(Knot::new(
            format!("corner {} of {label}", corner + 1),
            centre + hexagon_corner(corner).extend(0.0) * side,
        ));
        knots.len() - 1
    });
    Plate { hub, rim }
}

/// The two ropes of a link; rope 1 runs on the right as seen from a to b.
fn double_rope(lattice: &Lattice, link: &LatticeLink, plates: &[Plate], corners: &[usize]) -> [Rope; 2] {
    let tie = |knot: usize, corner: usize| match lattice.knots[knot].occupant {
        Occupant::Plate(number) => plates[number - 1].rim[corner % 6],
        Occupant::Corner(number) => corners[number - 1],
    };
    let name = |knot: usize| match lattice.knots[knot].occupant {
        Occupant::Plate(number) => number.to_string(),
        Occupant::Corner(number) => format!("web corner {number}"),
    };
    // a's side that faces b runs from corner k to k + 1, b's side that faces a from k + 3 to k + 4
    let k = link.direction;
    [(1, k, k + 4), (2, k + 1, k + 3)].map(|(number, at_a, at_b)| Rope {
        a: tie(link.a, at_a),
        b: tie(link.b, at_b),
        class: link.class.clone(),
        label: format!("{} link {}-{}, rope {number}", link.class, name(link.a), name(link.b)),
        rest_length: None,
        segments: None,
    })
}

/// The feature points B, C and D, to the right of the line to the web's corner at 90 degrees.
fn feature_points(lattice: &Lattice, plates: &[Plate]) -> BTreeMap<String, Site> {
    let centre = &plates[plates.len() - 1];
    // the second of the two plates between the corners at 30 and 90 degrees; plates are the lattice's first knots
    let beside_corner = &plates[lattice.outline[2]];
    let mut points = BTreeMap::from([
        ("B".to_owned(), Site::Knot(centre.rim[1])),
        ("C".to_owned(), Site::Knot(beside_corner.rim[2])),
    ]);
    // the right rope of the radial link from the first ring towards 90 degrees; each link has two ropes
    let half_way = lattice
        .links
        .iter()
        .position(|link| link.class == Class::Radial && link.direction == 1 && lattice.knots[link.a].ring == 1);
    points.extend(half_way.map(|link| ("D".to_owned(), Site::OnRope { rope: 2 * link, fraction: 0.5 })));
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::refused;
    use crate::{space, topological};

    fn webs() -> [Web; 2] {
        [topological(2.5, 0.14).unwrap(), space(2.5, 0.14).unwrap()]
    }

    #[test]
    fn links_have_180_ropes_with_a_total_length_of_110_84_m() {
        for web in webs() {
            let links: Vec<&Rope> = web.ropes.iter().filter(|rope| rope.class != Class::Hexagon).collect();
            assert_eq!(links.len(), 180);
            let length: f64 = links.iter().map(|rope| web.drawn_length(rope)).sum();
            assert!((length - 110.84).abs() < 5e-3, "{length}");
            assert!((web.reference_area().unwrap() - 16.238).abs() < 5e-4);
            assert_eq!(web.check(), []);
        }
    }

    #[test]
    fn each_class_has_its_share_of_ropes_between_plates_and_to_corners() {
        let plate_to_plate = 2.5 / 3.0 - 3.0_f64.sqrt() * 0.14;
        let to_a_corner = (2.5 / 3.0 - 0.75_f64.sqrt() * 0.14).hypot(0.07);
        for web in webs() {
            let length = web.rope_length_by_class();
            for (class, between_plates, to_corners) in [
                (Class::Outline, 12.0, 24.0),
                (Class::Ring, 36.0, 0.0),
                (Class::Radial, 24.0, 12.0),
                (Class::Inner, 72.0, 0.0),
            ] {
                let expected = between_plates * plate_to_plate + to_corners * to_a_corner;
                assert!((length[&class] - expected).abs() < 1e-9, "{class}: {} of {expected}", length[&class]);
            }
        }
    }

    #[test]
    fn rope_hexagons_have_26_04_m_of_rope_and_canopies_have_none() {
        let [topological, space] = webs();
        let length = topological.rope_length_by_class();
        assert!((length[&Class::Hexagon] - 26.04).abs() < 1e-9);
        assert!(!space.rope_length_by_class().contains_key(&Class::Hexagon));
        assert!(topological.canopies.is_empty());
    }

    #[test]
    fn the_ropes_of_a_link_are_parallel_and_0_14_m_apart_with_0_591_m_between_plates() {
        let clear = 2.5 / 3.0 - 2.0 * 0.14 * 0.75_f64.sqrt();
        for web in webs() {
            for pair in web.ropes[..180].chunks(2) {
                let at = |knot: usize| web.knots[knot].position;
                let run = |rope: &Rope| at(rope.b) - at(rope.a);
                assert!((at(pair[0].a).distance(at(pair[1].a)) - 0.14).abs() < 1e-12);
                if pair[0].b == pair[1].b {
                    assert!(web.corners.contains(&pair[0].b));
                    let expected = (clear / 2.0 + 2.5 / 6.0).hypot(0.07);
                    assert!((run(&pair[0]).length() - expected).abs() < 1e-12);
                } else {
                    assert!(run(&pair[0]).distance(run(&pair[1])) < 1e-12);
                    assert!((run(&pair[0]).length() - clear).abs() < 1e-12);
                    // rope 1 on the right
                    assert!(run(&pair[0]).cross(at(pair[1].a) - at(pair[0].a)).z > 0.0);
                }
            }
        }
    }

    #[test]
    fn a_sixth_of_a_turn_maps_ropes_onto_ropes_of_their_class() {
        let turn = |p: DVec3| DVec3::new(0.5 * p.x - 0.75_f64.sqrt() * p.y, 0.75_f64.sqrt() * p.x + 0.5 * p.y, 0.0);
        for web in webs() {
            for rope in &web.ropes {
                let at = |knot: usize| web.knots[knot].position;
                let (a, b) = (turn(at(rope.a)), turn(at(rope.b)));
                let is_image = |other: &Rope| {
                    let (c, d) = (at(other.a), at(other.b));
                    a.distance(c).max(b.distance(d)).min(a.distance(d).max(b.distance(c))) < 1e-12
                };
                assert!(web.ropes.iter().any(|other| other.class == rope.class && is_image(other)), "{}", rope.label);
            }
        }
    }

    #[test]
    fn canopies_1_to_12_lie_on_the_outline_13_to_30_carry_payloads_and_31_is_the_centre() {
        let [_, web] = webs();
        assert_eq!(web.canopies.len(), 31);
        for canopy in &web.canopies {
            let radius = web.knots[canopy.hub].position.length();
            assert_eq!(canopy.carries_payload, (13..=30).contains(&canopy.number));
            assert_eq!(canopy.is_centre, canopy.number == 31);
            assert_eq!(canopy.number <= 12, web.outline.contains(&vec![canopy.hub]));
            assert_eq!(canopy.is_centre, radius == 0.0);
            for corner in canopy.rim {
                assert!((web.knots[corner].position.distance(web.knots[canopy.hub].position) - 0.14).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn feature_points_lie_on_one_side_of_the_line_to_90_degrees() {
        for web in webs() {
            let at = |point: &str| web.position(web.points[point]);
            assert!(at("B").distance(DVec3::new(0.07, 0.14 * 0.75_f64.sqrt(), 0.0)) < 1e-12);
            assert!(at("D").distance(DVec3::new(0.07, 1.25, 0.0)) < 1e-12);
            // a third of a side from the corner at 90 degrees, towards the corner at 30 degrees
            let plate = DVec3::new(0.75_f64.sqrt() * 2.5 / 3.0, 2.5 - 2.5 / 6.0, 0.0);
            assert!((at("C").distance(plate) - 0.14).abs() < 1e-12);
            assert!(at("C").x > 0.0);
        }
    }

    #[test]
    fn labels_of_links_name_their_plates_and_corners() {
        let [_, web] = webs();
        let labels: Vec<&str> = web.ropes.iter().map(|rope| rope.label.as_str()).collect();
        for expected in ["ring link 13-14, rope 1", "outline link 1-web corner 1, rope 2", "radial link 31-25, rope 1"]
        {
            assert!(labels.contains(&expected), "{expected}");
        }
    }

    #[test]
    fn plates_that_touch_are_refused() {
        let limit = 2.5 / 3.0 / 3.0_f64.sqrt();
        assert!(space(2.5, 0.999 * limit).is_ok());
        assert_eq!(refused(space(2.5, 1.001 * limit)), Some("canopy_side"));
        assert_eq!(refused(topological(2.5, -0.1)), Some("hexagon_side"));
    }
}

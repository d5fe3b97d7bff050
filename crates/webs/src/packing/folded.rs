//! Folds a web into a container, by one of five patterns.
//!
//! A pattern is a map of the plane that moves no two points farther apart (proved in `bend.rs`, `rings.rs` and
//! `star.rs`). Folding thus stretches no rope and no cloth. A web that is not flat is first projected on its plane,
//! which moves no two points farther apart either.

use glam::{DVec2, DVec3};

use super::folds::{self, Legs};
use super::mouth::Mouth;
use super::star::{self, Arms};
use super::{Container, Imperfection, PackingError, rings};
use crate::{CutWeb, Web};

/// The pattern of a folded web.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Folding {
    /// An accordion along rings: the middle lies on the floor, the rest goes up and down in walls about it.
    Rings,
    /// An accordion along parallel lines with upright layers, folded a second time across.
    Lines,
    /// An accordion along parallel lines with flat layers, folded a second time across.
    Layers,
    /// An accordion along parallel lines with upright layers, rolled up from its middle.
    Roll,
    /// Radial folds, wound round the middle.
    Star {
        /// Number of arms; none: the number of corners, or 6 where there are fewer than 3 corners.
        arms: Option<u32>,
    },
}

/// The web folded into a container.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Folded {
    /// Pattern.
    pub folding: Folding,
    /// Container.
    pub container: Container,
    /// Distance between the centre lines of neighbouring layers, m: the thickness of a layer.
    pub spacing: f64,
    /// Where the tractors stand.
    pub mouth: Mouth,
}

/// A map of the flat web, relative to its middle, into a container.
type Map = Box<dyn Fn(DVec2) -> DVec3>;

impl Folded {
    pub(super) fn pack(
        &self,
        cut_web: &CutWeb,
        imperfection: Option<&Imperfection>,
    ) -> Result<Vec<DVec3>, PackingError> {
        let flat = Flat::of(cut_web);
        let Some(mut packed) = self.within(&flat, &self.container) else {
            return Err(PackingError::Room { container: self.container, enough: self.enough(&flat) });
        };
        if let Some(imperfection) = imperfection {
            imperfection.disturb(cut_web, &flat.is_web, &mut packed);
        }
        self.mouth.close(cut_web, &mut packed, self.container.radius())?;
        Ok(packed)
    }

    /// Positions of the web in this container with its top at z = 0, m, (nodes,); none if the web does not fit.
    fn within(&self, flat: &Flat, container: &Container) -> Option<Vec<DVec3>> {
        let room = container.for_centre_lines(self.spacing);
        let map = self.map(flat, &room);
        let mut packed: Vec<DVec3> = flat.nodes.iter().map(|&node| map(node)).collect();
        let of_the_web = || flat.is_web.iter().zip(&packed).filter(|(is_web, _)| **is_web).map(|(_, &place)| place);
        let least = of_the_web().fold(DVec3::INFINITY, DVec3::min);
        let most = of_the_web().fold(DVec3::NEG_INFINITY, DVec3::max);
        // rings and star are centred on the axis already, the other patterns are not
        let aside = match self.folding {
            Folding::Rings | Folding::Star { .. } => DVec3::ZERO,
            Folding::Lines | Folding::Layers | Folding::Roll => 0.5 * (least + most),
        };
        for place in &mut packed {
            *place -= aside.with_z(most.z);
        }
        let web = flat.is_web.iter().zip(&packed).filter(|(is_web, _)| **is_web).map(|(_, &place)| place);
        room.holds(web).then_some(packed)
    }

    /// The map of the pattern for a container of this size.
    fn map(&self, flat: &Flat, room: &Container) -> Map {
        let legs = match self.folding {
            Folding::Rings => return Box::new(rings::fold(flat.radius, room, self.spacing)),
            Folding::Star { arms } => return Box::new(star::fold(flat.radius, flat.arms(arms), room, self.spacing)),
            Folding::Lines => Legs::Upright,
            Folding::Layers => Legs::Flat,
            Folding::Roll => Legs::Rolled,
        };
        Box::new(folds::fold(legs, flat.least, flat.most, room, self.spacing))
    }

    /// The smallest container of the same proportions that holds the web, in steps of 1 %, with its sizes rounded up to
    /// three digits; none if one a thousand times as large does not hold it.
    fn enough(&self, flat: &Flat) -> Option<Container> {
        // no bisection: layers come in whole numbers, so a larger container can fail where a smaller one holds the web
        let factors = std::iter::successors(Some(1.01), |factor| Some(1.01 * factor));
        let containers = factors.map(|factor| self.container.with_sizes(|size| round_up(size * factor)));
        containers.take(700).find(|container| self.within(flat, container).is_some())
    }
}

/// Rounds up to three significant digits.
fn round_up(value: f64) -> f64 {
    let digit = libm::pow(10.0, libm::log10(value).floor() - 2.0);
    let rounded = (value / digit).ceil() * digit;
    // the decimal itself, without the last bits of the product
    format!("{rounded:.2e}").parse().unwrap_or(rounded)
}

/// The flat web, projected on its plane.
struct Flat<'a> {
    web: &'a Web,
    /// Positions of all nodes relative to the middle, m, (nodes,).
    nodes: Vec<DVec2>,
    /// Whether each node belongs to the web itself, (nodes,): see [`CutWeb::is_web`].
    is_web: Vec<bool>,
    /// Smallest coordinates of the web's nodes, m.
    least: DVec2,
    /// Largest coordinates of the web's nodes, m.
    most: DVec2,
    /// The web's radius, m.
    radius: f64,
}

impl Flat<'_> {
    fn of(cut_web: &CutWeb) -> Flat<'_> {
        let web = &cut_web.web;
        let nodes: Vec<DVec2> = cut_web.nodes.iter().map(|&node| (node - web.middle).truncate()).collect();
        let is_web = cut_web.is_web();
        let of_the_web = || nodes.iter().zip(&is_web).filter(|(_, is_web)| **is_web).map(|(&node, _)| node);
        let least = of_the_web().fold(DVec2::INFINITY, DVec2::min);
        let most = of_the_web().fold(DVec2::NEG_INFINITY, DVec2::max);
        Flat { web, least, most, radius: web.radius(), nodes, is_web }
    }

    /// The arms of a star, the first towards the first corner.
    fn arms(&self, stated: Option<u32>) -> Arms {
        let corners = &self.web.corners;
        let count = stated.map_or(if corners.len() < 3 { 6.0 } else { corners.len() as f64 }, f64::from);
        let first = corners.first().map_or(DVec2::X, |&corner| self.nodes[corner]);
        Arms { count, first: libm::atan2(first.y, first.x) }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;
    use crate::packing::{Pattern, longest_stretch};
    use crate::samples::SAMPLES;
    use crate::{Cutting, cut, square};

    const FOLDINGS: [Folding; 6] = [
        Folding::Rings,
        Folding::Lines,
        Folding::Layers,
        Folding::Roll,
        Folding::Star { arms: None },
        Folding::Star { arms: Some(9) },
    ];

    fn folded(folding: Folding, container: Container, spacing: f64) -> Folded {
        Folded { folding, container, spacing, mouth: Mouth::default() }
    }

    /// Packs a square net of 4 m and 5 x 5 knots. Returns the positions of a corner, of the middle of a side, of the
    /// centre, and of the knot half way from the centre to the corner.
    fn packed_square(folding: Folding, container: Container, spacing: f64) -> [DVec3; 4] {
        let net = cut(&square(4.0, 1.0).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        let packed = folded(folding, container, spacing).pack(&net, None).unwrap();
        let at = |x: f64, y: f64| {
            let found = net.nodes.iter().position(|node| node.distance(DVec3::new(x, y, 0.0)) < 1e-9);
            packed[found.expect("a knot lies there")]
        };
        [at(-2.0, -2.0), at(0.0, -2.0), at(0.0, 0.0), at(-1.0, -1.0)]
    }

    #[test]
    fn a_net_that_fits_its_container_unfolded_lies_flat() {
        for folding in [Folding::Rings, Folding::Lines, Folding::Layers] {
            let container = Container::Box { width: 6.0, breadth: 6.0, height: 5.0 };
            let [corner, side, centre, _] = packed_square(folding, container, 0.01);
            assert!((corner.distance(centre) - 8.0_f64.sqrt()).abs() < 1e-12);
            assert!((side.distance(centre) - 2.0).abs() < 1e-12);
        }
    }

    #[test]
    fn rings_stand_in_walls_about_a_floor_and_end_at_the_top() {
        // a floor with a radius of 0.5 m - 2 x 0.1 m, three walls and two bends take up the web's radius of sqrt(8) m
        let container = Container::Cylinder { radius: 0.55, height: 1.1 };
        let [corner, _, centre, halfway] = packed_square(Folding::Rings, container, 0.1);
        let wall = (8.0_f64.sqrt() - 0.3 - 0.1 * PI) / 3.0;
        assert!((corner.truncate().length() - 0.5).abs() < 1e-12);
        assert!((corner.z - centre.z - wall).abs() < 1e-12);
        // up the first wall, through its bend, down the second
        let down = 2.0_f64.sqrt() - 0.3 - wall - 0.05 * PI;
        assert!((halfway.truncate().length() - 0.4).abs() < 1e-12);
        assert!((halfway.z - centre.z - (wall - down)).abs() < 1e-12);
    }

    #[test]
    fn the_radius_of_a_roll_of_one_layer_follows_from_its_area() {
        // a band 4 m long is wound at a pitch of 0.02 m: pi R^2 is about 4 m x 0.02 m
        let container = Container::Cylinder { radius: 0.2, height: 5.0 };
        let [corner, side, centre, _] = packed_square(Folding::Roll, container, 0.02);
        assert!((corner.z - centre.z).abs() - 2.0 < 1e-12);
        assert!((side - centre).truncate().length() < 1e-12);
        let radius = (corner - centre).truncate().length();
        assert!((radius - (4.0 * 0.02 / PI).sqrt()).abs() < 0.01, "{radius}");
    }

    #[test]
    fn the_error_of_a_container_too_small_names_one_that_is_large_enough() {
        let net = cut(&square(4.0, 1.0).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        let container = Container::Box { width: 0.5, breadth: 0.5, height: 0.05 };
        let error = folded(Folding::Layers, container, 0.01).pack(&net, None).unwrap_err();
        let PackingError::Room { enough: Some(enough), .. } = error else { panic!("{error}") };
        assert!(folded(Folding::Layers, enough, 0.01).pack(&net, None).is_ok());
        // the net's volume, 16 m^2 x 0.01 m, and not much more
        let Container::Box { width, breadth, height } = enough else { panic!() };
        let volume = width * breadth * height;
        assert!(volume > 0.16 && volume < 0.3, "{error}: {volume} m^3");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(512))]
        #[test]
        fn no_folding_and_no_imperfection_stretches_a_rope(
            kind in 0..SAMPLES.len(),
            folding in 0..FOLDINGS.len(),
            radius in 0.1..2.0_f64,
            slender in 0.2..4.0_f64,
            spacing in 0.001..0.02_f64,
            segment_length in 0.05..1.0_f64,
            is_box in any::<bool>(),
            imperfection in prop::option::of((0.0..0.05_f64, -1.0..1.0_f64, 0.0..0.2_f64, any::<u64>())),
        ) {
            let web = SAMPLES[kind]().with_traction(6.0, 1).unwrap();
            let net = cut(&web, &Cutting::SegmentLength(segment_length)).unwrap();
            let height = slender * radius;
            let container = if is_box {
                Container::Box { width: 2.0 * radius, breadth: 1.5 * radius, height }
            } else {
                Container::Cylinder { radius, height }
            };
            let imperfection =
                imperfection.map(|(scatter, twist, slack, seed)| Imperfection { scatter, twist, slack, seed });
            let pack = |container| {
                let folded = Pattern::Folded(folded(FOLDINGS[folding], container, spacing));
                folded.pack_imperfectly(&net, imperfection.as_ref())
            };
            let packed = match pack(container) {
                Err(PackingError::Room { enough, .. }) => pack(enough.expect("some container does")),
                packed => packed,
            };
            let longest = longest_stretch(&net, &packed.unwrap());
            prop_assert!(longest < 1e-11, "{longest}");
        }

        #[test]
        fn every_node_of_a_folded_web_lies_in_its_container(
            kind in 0..SAMPLES.len(), folding in 0..FOLDINGS.len(), radius in 0.2..1.0_f64, height in 0.2..3.0_f64,
        ) {
            let net = cut(&SAMPLES[kind](), &Cutting::SegmentLength(0.1)).unwrap();
            let container = Container::Cylinder { radius, height };
            let spacing = 0.004;
            let folding = FOLDINGS[folding];
            let (packed, container) = match folded(folding, container, spacing).pack(&net, None) {
                Ok(packed) => (packed, container),
                Err(PackingError::Room { enough: Some(enough), .. }) => {
                    (folded(folding, enough, spacing).pack(&net, None).unwrap(), enough)
                }
                Err(error) => panic!("{error}"),
            };
            let Container::Cylinder { radius, height } = container else { unreachable!() };
            for node in packed {
                prop_assert!(node.truncate().length() <= radius - 0.5 * spacing + 1e-9);
                prop_assert!(node.z < 1e-12 && node.z > spacing - height - 1e-9);
            }
        }
    }
}

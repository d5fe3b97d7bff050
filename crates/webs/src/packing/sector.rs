//! A sector of a web: its nodes in a range of directions from the middle of the flat web.

use std::f64::consts::TAU;

use glam::DVec3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::CutWeb;
use crate::chance::uniform;

/// A sector; angles in rad, anticlockwise from x of the flat web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sector {
    /// Direction of its middle line.
    pub direction: f64,
    /// From edge to edge: more than 0, at most a whole turn.
    pub width: f64,
}

/// Distance from an edge within which a node lies on it, as a share of the web's radius.
const ROUNDING: f64 = 1e-9;

/// The stream of ChaCha8 that directions are drawn from; the scatter of nodes has the first.
const STREAM: u64 = 1;

impl Sector {
    /// A sector of this width, rad, whose direction is drawn from a seed; every direction is equally likely.
    pub fn by_chance(width: f64, seed: u64) -> Sector {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(STREAM);
        Sector { direction: TAU * uniform(&mut random), width }
    }

    /// Whether each node lies in it, (nodes,). The web's middle does, and so do nodes on an edge.
    pub fn of(&self, cut_web: &CutWeb) -> Vec<bool> {
        let (sin, cos) = libm::sincos(self.direction);
        let hair = ROUNDING * cut_web.web.radius();
        let edge = libm::cos(0.5 * self.width);
        let holds = |node: &DVec3| {
            let from_middle = (*node - cut_web.web.middle).truncate();
            from_middle.x * cos + from_middle.y * sin >= from_middle.length() * edge - hair
        };
        cut_web.nodes.iter().map(holds).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

    use super::*;
    use crate::{Cutting, Radial, cut, radial, square};

    #[test]
    fn a_sixth_of_a_web_is_a_sixth_of_it_and_its_edges() {
        let web = radial(&Radial { diameter: 4.0, radials: 12, rings: 5, hub_diameter: None, corners: 6 }).unwrap();
        let net = cut(&web, &Cutting::SegmentLength(4.0)).unwrap();
        let count = |sector: Sector| sector.of(&net).iter().filter(|is_in| **is_in).count();
        let first = net.nodes[net.web.corners[0]] - net.web.middle;
        // edges along the radial ropes to two corners: the six sectors have six edges and the middle in common
        let sixths: Vec<usize> = (0..6)
            .map(|k| {
                let direction = libm::atan2(first.y, first.x) + FRAC_PI_3 * (f64::from(k) + 0.5);
                count(Sector { direction, width: FRAC_PI_3 })
            })
            .collect();
        assert_eq!(sixths, [sixths[0]; 6]);
        // each edge has the five rings' knots, and all have the middle
        assert_eq!(6 * sixths[0] - 6 * 5 - 5, net.nodes.len());
        assert_eq!(count(Sector { direction: 1.0, width: 2.0 * PI }), net.nodes.len());
    }

    #[test]
    fn half_of_a_square_is_what_lies_on_one_side() {
        let net = cut(&square(4.0, 1.0).unwrap(), &Cutting::SegmentLength(0.5)).unwrap();
        let upper = Sector { direction: FRAC_PI_2, width: PI }.of(&net);
        for (node, is_in) in net.nodes.iter().zip(upper) {
            assert_eq!(is_in, node.y >= net.web.middle.y - 1e-12, "{node}");
        }
    }

    #[test]
    fn directions_by_chance_go_all_round() {
        let directions: Vec<f64> = (0..2000).map(|seed| Sector::by_chance(1.0, seed).direction).collect();
        for quarter in 0..4 {
            let from = FRAC_PI_2 * f64::from(quarter);
            let count = directions.iter().filter(|&&d| (from..from + FRAC_PI_2).contains(&d)).count();
            // four standard deviations
            assert!(count.abs_diff(500) < 80, "{count}");
        }
        assert_eq!(Sector::by_chance(1.0, 7), Sector::by_chance(1.0, 7));
    }
}

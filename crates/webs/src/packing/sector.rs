//! A sector of a web: the nodes in a range of directions from the middle of the flat web.

use std::f64::consts::TAU;

use glam::DVec3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use crate::CutWeb;
use crate::chance::uniform;

/// A sector; angles in rad, anticlockwise from the x axis of the flat web.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sector {
    /// Direction of its bisector.
    pub direction: f64,
    /// Angle between its edges: more than 0, at most 2 pi.
    pub width: f64,
}

/// A node nearer to an edge than this share of the web's radius lies on the edge.
const ROUNDING: f64 = 1e-9;

/// Stream of ChaCha8 for directions; the scatter of nodes uses stream 0.
const STREAM: u64 = 1;

impl Sector {
    /// A sector with this width, rad, and a random direction from this seed; all directions are equally likely.
    pub fn by_chance(width: f64, seed: u64) -> Sector {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(STREAM);
        Sector { direction: TAU * uniform(&mut random), width }
    }

    /// Whether each node lies in the sector, (nodes,). The web's middle and nodes on an edge do.
    pub fn of(&self, cut_web: &CutWeb) -> Vec<bool> {
        let (sin, cos) = libm::sincos(self.direction);
        let tolerance = ROUNDING * cut_web.web.radius();
        let edge = libm::cos(0.5 * self.width);
        let holds = |node: &DVec3| {
            let from_middle = (*node - cut_web.web.middle).truncate();
            from_middle.x * cos + from_middle.y * sin >= from_middle.length() * edge - tolerance
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
    fn six_sectors_of_a_sixth_share_only_their_edges_and_the_middle() {
        let web = radial(&Radial { diameter: 4.0, radials: 12, rings: 5, hub_diameter: None, corners: 6 }).unwrap();
        let net = cut(&web, &Cutting::SegmentLength(4.0)).unwrap();
        let count = |sector: Sector| sector.of(&net).iter().filter(|is_in| **is_in).count();
        let first = net.nodes[net.web.corners[0]] - net.web.middle;
        // the edges lie along the radial ropes to two corners
        let sixths: Vec<usize> = (0..6)
            .map(|k| {
                let direction = libm::atan2(first.y, first.x) + FRAC_PI_3 * (f64::from(k) + 0.5);
                count(Sector { direction, width: FRAC_PI_3 })
            })
            .collect();
        assert_eq!(sixths, [sixths[0]; 6]);
        // each of the six edges has five knots and lies in two sectors; the middle lies in all six
        assert_eq!(6 * sixths[0] - 6 * 5 - 5, net.nodes.len());
        assert_eq!(count(Sector { direction: 1.0, width: 2.0 * PI }), net.nodes.len());
    }

    #[test]
    fn a_sector_of_half_a_turn_holds_the_nodes_on_one_side() {
        let net = cut(&square(4.0, 1.0).unwrap(), &Cutting::SegmentLength(0.5)).unwrap();
        let upper = Sector { direction: FRAC_PI_2, width: PI }.of(&net);
        for (node, is_in) in net.nodes.iter().zip(upper) {
            assert_eq!(is_in, node.y >= net.web.middle.y - 1e-12, "{node}");
        }
    }

    #[test]
    fn random_directions_are_uniform_and_follow_their_seed() {
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

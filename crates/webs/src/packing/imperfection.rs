//! Seeded imperfection of a packed web: the web is twisted, shrunk a little and scattered, but no rope is stretched.
//!
//! 1. Twist: every node is turned about the launch axis in proportion to its depth, by 0 at the top and by `twist` at
//!    the lowest node.
//! 2. Shrink: the web is scaled about the axis at its top, so that the twist exceeds no distance limit, and then by
//!    1 - `slack`.
//! 3. Scatter: each node in turn is moved normal to the axis, by two normal deviates of standard deviation `scatter`.
//!    If this would exceed a distance limit, the node moves by the largest share of the way that does not. The nodes of
//!    a canopy move together, so that cloth is not stretched and a plate not bent.
//!
//! The distance limits are those of ropes and canopies. If the packed web keeps them, the disturbed web keeps them too.
//! Deviates come from ChaCha8 (stream 0) by the transform of Box and Muller (Ann. Math. Stat. 29 (1958) 610-611) and
//! the elementary functions from libm, so that a seed gives the same bits on every machine.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3, dvec2};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

use super::distance_limits::{self, DistanceLimit};
use crate::CutWeb;
use crate::chance::uniform;

/// How a packed web differs from its pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Imperfection {
    /// Standard deviation of a node's displacement in each of the two directions normal to the launch axis, m.
    pub scatter: f64,
    /// Rotation of the lowest node about the launch axis against the highest, rad.
    pub twist: f64,
    /// Share by which the web is shrunk before it is scattered, so that nodes can move: 0 or more, less than 1.
    pub slack: f64,
    /// Seed of the scatter.
    pub seed: u64,
}

/// Largest relative excess over a distance limit that is ascribed to rounding and does not shrink the web.
const ROUNDING: f64 = 1e-12;

impl Imperfection {
    /// Disturbs those nodes of a packed web for which `is_part`, (nodes,), is true. `packed` are positions in the
    /// launch frame, m, (nodes,).
    pub(super) fn disturb(&self, cut_web: &CutWeb, is_part: &[bool], packed: &mut [DVec3]) {
        let is_within = |limit: &DistanceLimit| limit.ends.iter().all(|&end| is_part[end]);
        let limits = distance_limits::of_ropes(cut_web).chain(distance_limits::of_canopies(cut_web));
        let limits: Vec<DistanceLimit> = limits.filter(is_within).collect();
        let parts: Vec<usize> = (0..packed.len()).filter(|&node| is_part[node]).collect();
        let top = parts.iter().map(|&node| packed[node].z).fold(f64::NEG_INFINITY, f64::max);
        let bottom = parts.iter().map(|&node| packed[node].z).fold(f64::INFINITY, f64::min);
        if self.twist != 0.0 && top > bottom {
            for &node in &parts {
                let angle = self.twist * (top - packed[node].z) / (top - bottom);
                let turned = dvec2(libm::cos(angle), libm::sin(angle)).rotate(packed[node].truncate());
                packed[node] = turned.extend(packed[node].z);
            }
        }
        let stretch = |limit: &DistanceLimit| packed[limit.ends[0]].distance(packed[limit.ends[1]]) / limit.length;
        let longest = limits.iter().map(stretch).fold(0.0, f64::max);
        let factor = (1.0 - self.slack) / if longest > 1.0 + ROUNDING { longest } else { 1.0 };
        let anchor = DVec3::Z * top;
        for &node in &parts {
            packed[node] = anchor + (packed[node] - anchor) * factor;
        }
        self.scatter(&groups(cut_web, &parts), &Neighbours::of(&limits, packed.len()), packed);
    }

    /// Scatters each group of nodes in turn, as far as the distance limits to its neighbours allow.
    fn scatter(&self, groups: &[Vec<usize>], neighbours: &Neighbours, packed: &mut [DVec3]) {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        for group in groups {
            let way = (self.scatter * normal_pair(&mut random)).extend(0.0);
            let mut allowed = 1.0_f64;
            for &node in group {
                for &(neighbour, length) in neighbours.of_node(node) {
                    if !group.contains(&neighbour) {
                        allowed = allowed.min(reach(packed[node] - packed[neighbour], way, length));
                    }
                }
            }
            for &node in group {
                packed[node] += way * allowed;
            }
        }
    }
}

/// The groups of nodes that move together, in the order of their smallest node: canopies and single nodes.
fn groups(cut_web: &CutWeb, parts: &[usize]) -> Vec<Vec<usize>> {
    let mut groups = cut_web.canopy_nodes();
    let mut is_grouped = vec![false; cut_web.nodes.len()];
    for &node in groups.iter().flatten() {
        is_grouped[node] = true;
    }
    groups.extend(parts.iter().filter(|&&node| !is_grouped[node]).map(|&node| vec![node]));
    groups.sort_by_key(|group| group.iter().copied().min());
    groups
}

/// The neighbours of each node: the other ends of its distance limits.
struct Neighbours {
    /// Where the neighbours of each node begin in `all`, and the length of `all`, (nodes + 1,).
    first: Vec<usize>,
    /// Neighbours, node by node, and the limit of each, m.
    all: Vec<(usize, f64)>,
}

impl Neighbours {
    fn of(limits: &[DistanceLimit], nodes: usize) -> Neighbours {
        let mut directed: Vec<(usize, usize, f64)> = Vec::with_capacity(2 * limits.len());
        for &DistanceLimit { ends: [a, b], length } in limits {
            directed.extend([(a, b, length), (b, a, length)]);
        }
        directed.sort_by_key(|&(from, to, _)| (from, to));
        let first = (0..=nodes).map(|node| directed.partition_point(|&(from, ..)| from < node)).collect();
        Neighbours { first, all: directed.into_iter().map(|(_, to, length)| (to, length)).collect() }
    }

    fn of_node(&self, node: usize) -> impl Iterator<Item = &(usize, f64)> {
        self.all[self.first[node]..self.first[node + 1]].iter()
    }
}

/// Largest share, 0 to 1, of a displacement `way` that keeps a point at `from` within `length` of the origin, all in m;
/// 0 if it is farther away.
fn reach(from: DVec3, way: DVec3, length: f64) -> f64 {
    let (square, along) = (way.length_squared(), from.dot(way));
    // a little less, against rounding
    let room = length * length * (1.0 - ROUNDING) - from.length_squared();
    if room <= 0.0 {
        return 0.0;
    }
    // the positive root of a quadratic, in the form without cancellation
    let root = (along * along + square * room).sqrt();
    let share = if along > 0.0 { room / (along + root) } else { (root - along) / square };
    share.min(1.0)
}

/// Two independent standard normal deviates.
fn normal_pair(random: &mut ChaCha8Rng) -> DVec2 {
    let radius = (-2.0 * libm::log(1.0 - uniform(random))).sqrt();
    let angle = TAU * uniform(random);
    dvec2(radius * libm::cos(angle), radius * libm::sin(angle))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cutting, cut, square};

    #[test]
    fn the_share_of_a_way_ends_at_the_sphere_of_the_limit() {
        let from = DVec3::new(3.0, 0.0, 0.0);
        assert_eq!(reach(from, DVec3::X, 10.0), 1.0);
        assert!((reach(from, DVec3::X * 4.0, 5.0) - 0.5).abs() < 1e-11);
        assert!((reach(from, DVec3::X * -16.0, 5.0) - 0.5).abs() < 1e-11);
        assert!((reach(from, DVec3::Y * 8.0, 5.0) - 0.5).abs() < 1e-11);
        assert_eq!(reach(from, DVec3::X, 2.0), 0.0);
        assert_eq!(reach(from, DVec3::ZERO, 5.0), 1.0);
    }

    #[test]
    fn deviates_have_the_moments_of_a_normal_distribution_and_follow_their_seed() {
        let mut random = ChaCha8Rng::seed_from_u64(5);
        let pairs: Vec<DVec2> = (0..20_000).map(|_| normal_pair(&mut random)).collect();
        let mean = |of: &dyn Fn(&DVec2) -> f64| pairs.iter().map(of).sum::<f64>() / pairs.len() as f64;
        // four standard errors
        for axis in [DVec2::X, DVec2::Y] {
            assert!(mean(&|p| p.dot(axis)).abs() < 0.03);
            assert!((mean(&|p| p.dot(axis).powi(2)) - 1.0).abs() < 0.04);
            assert!((mean(&|p| p.dot(axis).powi(4)) - 3.0).abs() < 0.3);
        }
        assert!(mean(&|p| p.x * p.y).abs() < 0.03);
        let again = normal_pair(&mut ChaCha8Rng::seed_from_u64(5));
        assert_eq!(again, pairs[0]);
    }

    #[test]
    fn slack_ropes_scatter_with_the_standard_deviation_asked_for() {
        let net = cut(&square(4.0, 0.5).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        let half: Vec<DVec3> = net.nodes.iter().map(|&node| 0.5 * node).collect();
        let mut packed = half.clone();
        let imperfection = Imperfection { scatter: 0.02, twist: 0.0, slack: 0.0, seed: 1 };
        imperfection.disturb(&net, &vec![true; half.len()], &mut packed);
        let moved: f64 = packed.iter().zip(&half).map(|(a, b)| a.distance_squared(*b)).sum();
        let deviation = (moved / (2 * half.len()) as f64).sqrt();
        assert!((deviation - 0.02).abs() < 0.001, "{deviation}");
    }

    #[test]
    fn a_twist_turns_the_lowest_nodes_and_shrinks_the_web_until_no_rope_is_stretched() {
        let net = cut(&square(1.0, 1.0).unwrap(), &Cutting::SegmentLength(1.0)).unwrap();
        // the net stands on edge: two knots at the top, two 1 m below
        let stood: Vec<DVec3> = net.nodes.iter().map(|node| DVec3::new(node.x, 0.0, node.y)).collect();
        let mut packed = stood.clone();
        Imperfection { scatter: 0.0, twist: 1.0, slack: 0.0, seed: 0 }.disturb(&net, &[true; 4], &mut packed);
        let longest = net.segments().map(|s| packed[s.a].distance(packed[s.b]) / s.rest_length).fold(0.0, f64::max);
        assert!((longest - 1.0).abs() < 1e-12, "{longest}");
        let low = (0..4).filter(|&node| stood[node].z < 0.0);
        for node in low {
            let turned = packed[node].truncate().normalize().angle_to(stood[node].truncate().normalize()).abs();
            assert!((turned - 1.0).abs() < 1e-12, "{turned}");
        }
    }
}

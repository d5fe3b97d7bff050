//! Ropes in straight pieces: a prescribed packing moves coarse ropes, however finely the web is cut.
//!
//! A piece is at most about a 25th of the web's radius long. Nodes inside a piece do not take part in the motion: their
//! mass is lumped at the ends of the piece, and after the motion they are spaced evenly between these ends.

use std::collections::BTreeSet;

use glam::DVec3;

use crate::packing::StiffPlate;
use crate::packing::distance_limits::DistanceLimit;
use crate::{CutRope, CutWeb};

/// Length of a piece as a share of the web's radius.
const LENGTH: f64 = 1.0 / 25.0;

/// The pieces of all ropes.
pub(super) struct RopePieces<'a> {
    cut_web: &'a CutWeb,
    /// Ends of the pieces of each rope, as places of nodes along the rope from 0, (ropes,).
    ends: Vec<Vec<usize>>,
}

impl<'a> RopePieces<'a> {
    /// Divides every rope into pieces of about equal length, and at each of the `driven` nodes.
    pub fn of(cut_web: &'a CutWeb, driven: impl Iterator<Item = usize>) -> Self {
        let longest = LENGTH * cut_web.web.radius();
        let mut is_driven = vec![false; cut_web.nodes.len()];
        for node in driven {
            is_driven[node] = true;
        }
        let of_rope = |cut: &CutRope| {
            let whole = cut.segments as f64 * cut.segment_length;
            let pieces = ((whole / longest).ceil().max(1.0) as usize).min(cut.segments);
            let mut ends: BTreeSet<usize> = (0..=pieces).map(|piece| piece * cut.segments / pieces).collect();
            for (node, place) in cut.interior().zip(1..) {
                if is_driven[node] {
                    ends.insert(place);
                }
            }
            ends.into_iter().collect()
        };
        Self { cut_web, ends: cut_web.ropes.iter().map(of_rope).collect() }
    }

    /// One limit for every piece: its rest length.
    pub fn distance_limits(&self) -> impl Iterator<Item = DistanceLimit> {
        self.ends.iter().enumerate().flat_map(|(rope, ends)| {
            let nodes = self.cut_web.nodes_of(rope);
            let segment = self.cut_web.ropes[rope].segment_length;
            let limit = move |pair: &[usize]| DistanceLimit {
                ends: [nodes[pair[0]], nodes[pair[1]]],
                length: (pair[1] - pair[0]) as f64 * segment,
            };
            ends.windows(2).map(limit)
        })
    }

    /// Lumped mass of each node, kg, (nodes,), from the `mass` of each node, kg, (nodes,). Half of the mass inside a
    /// piece goes to each end; the mass of a plate is shared equally by its seven knots. Nodes inside keep their own
    /// mass too, but do not move.
    pub fn lumped_mass(&self, mass: &[f64], plates: &[StiffPlate]) -> Vec<f64> {
        let mut lumped = mass.to_vec();
        for (rope, ends) in self.ends.iter().enumerate() {
            let nodes = self.cut_web.nodes_of(rope);
            for piece in ends.windows(2) {
                let inside = &nodes[piece[0] + 1..piece[1]];
                let half = 0.5 * inside.iter().map(|&node| lumped[node]).sum::<f64>();
                lumped[nodes[piece[0]]] += half;
                lumped[nodes[piece[1]]] += half;
            }
        }
        for plate in plates {
            let canopy = &self.cut_web.web.canopies[plate.canopy];
            let whole: f64 = plate.nodes.iter().map(|&node| lumped[node]).sum();
            for knot in canopy.rim.into_iter().chain([canopy.hub]) {
                lumped[knot] = whole / 7.0;
            }
        }
        lumped
    }

    /// Spaces the nodes inside pieces evenly between the ends of their pieces.
    pub fn fill_in(&self, position: &mut [DVec3]) {
        for (rope, ends) in self.ends.iter().enumerate() {
            let nodes = self.cut_web.nodes_of(rope);
            for piece in ends.windows(2) {
                let (first, last) = (piece[0], piece[1]);
                let (a, b) = (position[nodes[first]], position[nodes[last]]);
                for place in first + 1..last {
                    position[nodes[place]] = a.lerp(b, (place - first) as f64 / (last - first) as f64);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cutting, cut, space};

    fn net() -> CutWeb {
        cut(&space(2.5, 0.14).unwrap(), &Cutting::SegmentLength(0.02)).unwrap()
    }

    #[test]
    fn pieces_make_up_their_ropes_and_are_about_a_25th_of_the_radius_long() {
        let net = net();
        let driven = net.ropes[7].first_interior;
        let pieces = RopePieces::of(&net, std::iter::once(driven));
        let whole: f64 = pieces.distance_limits().map(|limit| limit.length).sum();
        let rope: f64 = net.web.rope_length_by_class().values().sum();
        assert!((whole - rope).abs() < 1e-9);
        // a piece has a whole number of segments, so it may be up to one segment longer
        assert!(pieces.distance_limits().all(|limit| limit.length < 2.5 / 25.0 + 0.021));
        assert!(pieces.distance_limits().count() * 3 < net.segment_count());
        assert_eq!(pieces.distance_limits().filter(|limit| limit.ends.contains(&driven)).count(), 2);
    }

    #[test]
    fn the_ends_of_pieces_and_the_plates_have_the_whole_mass() {
        let net = net();
        let pieces = RopePieces::of(&net, std::iter::empty());
        let mass: Vec<f64> = (0..net.nodes.len()).map(|node| 1.0 + (node % 5) as f64).collect();
        let hub = net.web.canopies[0].hub;
        let plate = StiffPlate { canopy: 0, nodes: net.web.canopies[0].rim.into_iter().chain([hub]).collect() };
        let lumped = pieces.lumped_mass(&mass, std::slice::from_ref(&plate));
        // hubs and bare corners of canopies have no rope
        let mut ends: BTreeSet<usize> = net.canopy_nodes().into_iter().flatten().collect();
        ends.extend(pieces.distance_limits().flat_map(|limit| limit.ends));
        let lumped_at_ends: f64 = ends.into_iter().map(|node| lumped[node]).sum();
        let whole: f64 = mass.iter().sum();
        assert!((lumped_at_ends / whole - 1.0).abs() < 1e-12, "{lumped_at_ends} of {whole} kg");
        assert!(plate.nodes.iter().all(|&node| lumped[node] == lumped[hub]));
    }

    #[test]
    fn nodes_inside_pieces_are_spaced_evenly_between_their_ends() {
        let net = net();
        let pieces = RopePieces::of(&net, std::iter::empty());
        let mut position: Vec<DVec3> = net.nodes.iter().map(|node| 0.5 * *node).collect();
        let halved = position.clone();
        for inside in net.ropes.iter().flat_map(CutRope::interior) {
            position[inside] = DVec3::NAN;
        }
        for end in pieces.distance_limits().flat_map(|limit| limit.ends) {
            position[end] = halved[end];
        }
        pieces.fill_in(&mut position);
        assert!(position.iter().zip(&halved).all(|(filled, half)| filled.distance(*half) < 1e-12));
    }
}

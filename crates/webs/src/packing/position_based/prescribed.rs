//! Packs a web by a prescribed motion, as in the founding paper: some nodes of the flat web move along given paths, the
//! others follow under weight and damping until the web rests in its container.
//!
//! The container is an upright tube about the launch axis with its mouth in the plane of the flat web. While nodes are
//! driven, the radius of its wall shrinks from that of the web to that of the container.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};

use super::solver::Solver;
use super::terms::{DrivenNode, Prescribed, Settled};
use crate::CutWeb;
use crate::packing::mouth::size;
use crate::packing::{Imperfection, PackingError, StiffPlate};

/// Number of straight parts in the path of a knot of the outline.
const PARTS: u32 = 32;

impl Prescribed {
    /// Positions of all nodes of the packed web in the launch frame, m, (nodes,); rotations of its plates against the
    /// flat web, (plates,); and how the web came to rest.
    ///
    /// # Errors
    /// [`PackingError`]: a size is out of its range, there is no node to drive, or a traction rope does not reach its
    /// tractor.
    pub fn pack(
        &self,
        cut_web: &CutWeb,
        imperfection: Option<&Imperfection>,
    ) -> Result<(Vec<DVec3>, Vec<DMat3>, Settled), PackingError> {
        let reach = cut_web.web.radius();
        if !(self.radius > 0.0 && self.radius <= reach) {
            return Err(PackingError::Radius { radius: self.radius, limit: reach });
        }
        if let Some(depth) = self.depth {
            size("depth", "depth", depth)?;
        }
        let paths = if self.paths.is_empty() { self.drawn_in(cut_web)? } else { self.paths.clone() };
        let mut solver = Solver::new(self, cut_web, paths);
        let settled = solver.run();
        let Solver { mut position, mut turns, .. } = solver;
        let is_web = cut_web.is_web();
        if let Some(imperfection) = imperfection {
            imperfection.disturb(cut_web, &is_web, &mut position);
        }
        let mut top = f64::NEG_INFINITY;
        for (place, &is_web) in position.iter().zip(&is_web) {
            if is_web {
                top = top.max(place.z);
            }
        }
        for place in &mut position {
            place.z -= top;
        }
        self.mouth.close(cut_web, &mut position, self.radius)?;
        if imperfection.is_some() {
            turns = StiffPlate::lay_in_folds(&self.plates, cut_web, &mut position);
        }
        Ok((position, turns, settled))
    }

    /// Straight paths of the outline's knots to a ring of the container's radius. The speed is half a sine wave in
    /// time.
    fn drawn_in(&self, cut_web: &CutWeb) -> Result<Vec<DrivenNode>, PackingError> {
        let web = &cut_web.web;
        if web.outline.is_empty() {
            return Err(PackingError::NothingDriven);
        }
        let path_of = |&knot: &usize| {
            let from = (web.knots[knot].position - web.middle).with_z(0.0);
            let by = from.normalize_or_zero() * (self.radius - from.length()).min(0.0);
            let point = |k: u32| {
                let share = f64::from(k) / f64::from(PARTS);
                (share * self.time, 0.5 * (1.0 - libm::cos(PI * share)) * by)
            };
            DrivenNode { node: knot, path: (0..=PARTS).map(point).collect() }
        };
        Ok(web.outline.iter().flatten().map(path_of).collect())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::super::rope_pieces::RopePieces;
    use super::*;
    use crate::packing::Mouth;
    use crate::packing::longest_stretch;
    use crate::{Cutting, Graph, GraphNode, GraphRope, cut, graph, polygon, space, square, traditional};

    fn prescribed(net: &CutWeb, radius: f64, depth: Option<f64>) -> Prescribed {
        Prescribed {
            radius,
            depth,
            paths: Vec::new(),
            time: 1.0,
            gravity: 9.80665,
            damping: 5.0,
            rest: 1e-4,
            longest: 20.0,
            mass: vec![1.0; net.nodes.len()],
            plates: Vec::new(),
            mouth: Mouth::default(),
        }
    }

    #[test]
    fn every_web_comes_to_rest_in_its_container_and_no_rope_is_stretched() {
        let webs = [
            ("traditional", traditional(2.5, 6), 0.1),
            ("space", space(2.5, 0.14), 0.2),
            ("polygon", polygon(5, 2.5, 0.4), 0.05),
            ("square", square(3.5, 0.5), 0.5),
        ];
        for (name, web, segment_length) in webs {
            let web = web.unwrap().with_traction(1.2, 1).unwrap();
            let net = cut(&web, &Cutting::SegmentLength(segment_length)).unwrap();
            for depth in [None, Some(0.6)] {
                let packing = prescribed(&net, 0.4, depth);
                let (packed, _, settled) = packing.pack(&net, None).unwrap();
                let case = format!("{name}, {depth:?}, {settled:?}");
                assert!(longest_stretch(&net, &packed) < 1e-10, "{case}: {}", longest_stretch(&net, &packed));
                assert!(settled.share <= 1e-4 && settled.time < 20.0, "{case}");
                let ring = packed[web.outline[0][0]].z;
                for (node, place) in packed.iter().enumerate().filter(|(node, _)| net.is_web()[*node]) {
                    assert!(place.truncate().length() < 0.4 + 1e-3, "{case}: {node}");
                    assert!(depth.is_none_or(|depth| place.z > ring - depth - 1e-3), "{case}: {node}");
                }
                // a second packing has the same bits
                assert_eq!(packing.pack(&net, None).unwrap().0, packed, "{case}");
            }
        }
    }

    #[test]
    fn plates_keep_their_shape_in_a_prescribed_packing() {
        let net = cut(&space(2.5, 0.14).unwrap(), &Cutting::SegmentLength(0.1)).unwrap();
        let plates = net.web.canopies.iter().enumerate();
        let plates: Vec<StiffPlate> = plates
            .map(|(canopy, c)| StiffPlate { canopy, nodes: c.rim.into_iter().chain([c.hub]).collect() })
            .collect();
        let packing = Prescribed { plates: plates.clone(), ..prescribed(&net, 0.5, Some(0.6)) };
        let (packed, turns, settled) = packing.pack(&net, None).unwrap();
        assert!(longest_stretch(&net, &packed) < 1e-10, "{settled:?} {}", longest_stretch(&net, &packed));
        for (plate, turn) in plates.iter().zip(turns) {
            let hub = net.web.canopies[plate.canopy].hub;
            for &node in &plate.nodes {
                let place = packed[hub] + turn * (net.nodes[node] - net.nodes[hub]);
                assert!(place.distance(packed[node]) < 1e-12);
            }
        }
    }

    /// A rope of length L between points d apart: L = 2 a sinh(d / 2a), sag a (cosh(d / 2a) - 1).
    #[test]
    fn a_rope_whose_ends_are_brought_together_hangs_as_a_catenary() {
        let node = |id: &str, x: f64| GraphNode { id: id.into(), position: DVec3::new(x, 0.0, 0.0) };
        let rope = GraphRope { a: "a".into(), b: "b".into(), ..GraphRope::default() };
        let listed = Graph { nodes: vec![node("a", -1.0), node("b", 1.0)], ropes: vec![rope], ..Graph::default() };
        let net = cut(&graph(&listed).unwrap(), &Cutting::SegmentLength(0.04)).unwrap();
        let to =
            |node: usize, x: f64| DrivenNode { node, path: vec![(0.0, DVec3::ZERO), (1.0, DVec3::new(x, 0.0, 0.0))] };
        let mut packing = prescribed(&net, 1.0, None);
        packing.paths = vec![to(0, 0.5), to(1, -0.5)];
        // the mass of a segment at every node inside, of half a segment at the ends
        packing.mass[..2].fill(0.5);
        packing.rest = 1e-8;
        let (packed, ..) = packing.pack(&net, None).unwrap();
        let (mut low, mut high) = (0.1, 1.0);
        for _ in 0..60 {
            let a = 0.5 * (low + high);
            if 2.0 * a * libm::sinh(0.5 / a) > 2.0 { low = a } else { high = a }
        }
        let sag = low * (libm::cosh(0.5 / low) - 1.0);
        let found = -packed.iter().map(|place| place.z).fold(0.0, f64::min);
        assert!((found / sag - 1.0).abs() < 0.005, "{found} for {sag} m");
    }

    /// The driven node would lie inside a piece if it were not driven.
    #[test]
    fn a_driven_node_inside_a_rope_follows_its_path() {
        let net = cut(&square(2.0, 0.5).unwrap(), &Cutting::SegmentLength(0.02)).unwrap();
        let mut packing = prescribed(&net, 1.0, None);
        let pieces = RopePieces::of(&net, std::iter::empty());
        let ends: BTreeSet<usize> = pieces.distance_limits().flat_map(|limit| limit.ends).collect();
        let inside = net.nodes_of(3)[1..25].iter().copied().find(|node| !ends.contains(node));
        let driven = inside.expect("pieces have nodes inside");
        let by = DVec3::new(0.0, 0.0, 0.3);
        packing.paths = vec![DrivenNode { node: driven, path: vec![(0.0, DVec3::ZERO), (0.5, by)] }];
        let mut solver = Solver::new(&packing, &net, packing.paths.clone());
        solver.run();
        assert!(solver.position[driven].distance(net.nodes[driven] - net.web.middle + by) < 1e-12);
        assert!(longest_stretch(&net, &solver.position) < 1e-10);
        // and the web hangs from it
        assert!(solver.position.iter().all(|place| place.z <= by.z));
    }

    #[test]
    fn sizes_out_of_range_and_webs_without_an_outline_are_refused() {
        let net = cut(&square(2.0, 0.5).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        for radius in [0.0, -1.0, 3.0, f64::NAN] {
            let refused = prescribed(&net, radius, None).pack(&net, None);
            assert!(matches!(refused, Err(PackingError::Radius { .. })));
        }
        assert!(matches!(prescribed(&net, 0.3, Some(-1.0)).pack(&net, None), Err(PackingError::Size { .. })));
        let mut bare = net.clone();
        bare.web.outline.clear();
        assert_eq!(prescribed(&bare, 0.3, None).pack(&bare, None).unwrap_err(), PackingError::NothingDriven);
    }
}

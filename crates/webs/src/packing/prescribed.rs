//! Packing by prescribed motion, as the founding paper does it: some knots of the flat web are led along given paths, the
//! rest follows under weight and damping, until it rests in its container.
//!
//! The container is an upright tube about the launch axis with its mouth in the plane of the flat web. Its wall closes in
//! from the web's own radius while knots are led; what hangs into it falls on its floor. Ropes are lines that do not give,
//! in pieces of a 25th of the web's radius, however finely it is cut; they pass through one another, and slide on wall
//! and floor.
//!
//! Position-based dynamics (Müller, Heidelberger, Hennix, Ratcliff, J. Vis. Commun. Image R. 18, 2007): in every step each
//! node goes on at its velocity, less damping, plus weight; then ties, plates, wall and floor move it to where it may be, in
//! sweeps; its velocity is the way that it came. At the end what sweeps have left of stretch is drawn in.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use glam::{DMat3, DVec3};

use super::mouth::size;
use super::plate::StiffPlate;
use super::ties::{self, Drawn, Tie};
use super::{Imperfection, Mouth, PackingError};
use crate::{CutRope, CutWeb, PackingField};

/// A step, s.
const STEP: f64 = 2e-3;

/// Sweeps a step.
const SWEEPS: usize = 10;

/// Length of the pieces that ropes hang in, as a share of the web's radius.
const PIECE: f64 = 1.0 / 25.0;

/// Points of the path that a knot is drawn in along.
const POINTS: u32 = 32;

/// How a web is led into its container. Lengths in m, times in s.
#[derive(Debug, Clone, PartialEq)]
pub struct Prescribed {
    /// Radius of the container.
    pub radius: f64,
    /// How far its floor lies below the flat web; without, there is no floor.
    pub depth: Option<f64>,
    /// What is led, and along which path; none: the outline is drawn in, to a ring of the container's radius.
    pub paths: Vec<Led>,
    /// Time in which the outline is drawn in.
    pub time: f64,
    /// Acceleration into the container, m/s^2.
    pub gravity: f64,
    /// Mass-proportional damping, 1/s.
    pub damping: f64,
    /// It rests when its kinetic energy is this share of what it was at most.
    pub rest: f64,
    /// It is taken as it is after this time at the latest.
    pub longest: f64,
    /// Mass of each node, kg, (nodes,).
    pub mass: Vec<f64>,
    /// What keeps its shape.
    pub plates: Vec<StiffPlate>,
    /// Where the tractors stand.
    pub mouth: Mouth,
}

/// A node that is led.
#[derive(Debug, Clone, PartialEq)]
pub struct Led {
    /// Which node.
    pub node: usize,
    /// Times, s, ascending, and displacements from where it lies in the flat web, m, in the launch frame; it goes straight
    /// and at constant speed from one to the next, and rests before the first and after the last.
    pub path: Vec<(f64, DVec3)>,
}

/// How a packing came to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settled {
    /// When it was taken, s.
    pub time: f64,
    /// Its kinetic energy then, over the largest that it had.
    pub share: f64,
}

impl Led {
    fn at(&self, time: f64) -> DVec3 {
        let after = self.path.partition_point(|&(t, _)| t <= time);
        match (after, self.path.get(after)) {
            (_, None) => self.path[after - 1].1,
            (0, Some(first)) => first.1,
            (_, Some(&(t1, by))) => {
                let (t0, from) = self.path[after - 1];
                from + (time - t0) / (t1 - t0) * (by - from)
            }
        }
    }

    fn end(&self) -> f64 {
        self.path[self.path.len() - 1].0
    }
}

impl Prescribed {
    /// Positions of all nodes of the packed web in the launch frame, m, how its plates are turned, and how it came to rest.
    ///
    /// # Errors
    /// [`PackingError`]: a size that cannot be, nothing to lead, or a traction rope that does not reach.
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
            size(PackingField::Depth, depth)?;
        }
        let paths = if self.paths.is_empty() { self.drawn_in(cut_web)? } else { self.paths.clone() };
        let mut settling = Settling::new(self, cut_web, paths);
        let settled = settling.run();
        let Settling { mut position, mut turns, .. } = settling;
        if let Some(imperfection) = imperfection {
            imperfection.disturb(cut_web, &cut_web.is_web(), &mut position);
        }
        let is_web = cut_web.is_web();
        let top = position.iter().zip(&is_web).filter(|(_, is_web)| **is_web).map(|(place, _)| place.z);
        let top = top.fold(f64::NEG_INFINITY, f64::max);
        position.iter_mut().for_each(|place| place.z -= top);
        self.mouth.close(cut_web, &mut position, self.radius)?;
        if imperfection.is_some() {
            turns = StiffPlate::lay_in_folds(&self.plates, cut_web, &mut position);
        }
        Ok((position, turns, settled))
    }

    /// Paths of the outline's knots straight to the ring, at a speed that rises and falls as a sine.
    fn drawn_in(&self, cut_web: &CutWeb) -> Result<Vec<Led>, PackingError> {
        let web = &cut_web.web;
        if web.outline.is_empty() {
            return Err(PackingError::NothingLed);
        }
        let led = |&knot: &usize| {
            let from = (web.knots[knot].position - web.middle).with_z(0.0);
            let by = from.normalize_or_zero() * (self.radius - from.length()).min(0.0);
            let point = |k: u32| {
                let share = f64::from(k) / f64::from(POINTS);
                (share * self.time, 0.5 * (1.0 - libm::cos(PI * share)) * by)
            };
            Led { node: knot, path: (0..=POINTS).map(point).collect() }
        };
        Ok(web.outline.iter().flatten().map(led).collect())
    }
}

/// A web on its way into the container.
struct Settling<'a> {
    packing: &'a Prescribed,
    cut_web: &'a CutWeb,
    paths: Vec<Led>,
    /// Where each rope's pieces end, counted in its nodes from 0, (ropes,).
    ends: Vec<Vec<usize>>,
    /// Ropes in pieces, and canopies.
    ties: Vec<Tie>,
    /// Inverse of the mass of what moves by itself, 1/kg, (nodes,); 0 for what is led, follows others or is no part.
    ease: Vec<f64>,
    /// Which nodes move by themselves.
    free: Vec<usize>,
    position: Vec<DVec3>,
    turns: Vec<DMat3>,
}

impl<'a> Settling<'a> {
    fn new(packing: &'a Prescribed, cut_web: &'a CutWeb, paths: Vec<Led>) -> Self {
        let is_web = cut_web.is_web();
        let is_within = |tie: &Tie| tie.ends.iter().all(|&end| is_web[end]);
        let ends = piece_ends(cut_web, &paths);
        let pieces = pieces(cut_web, &ends);
        let ties: Vec<Tie> = pieces.chain(ties::of_canopies(cut_web)).filter(is_within).collect();
        let mut ease = vec![0.0; cut_web.nodes.len()];
        let mass = lumped(packing, cut_web, &ends);
        for &end in ties.iter().flat_map(|tie| &tie.ends) {
            ease[end] = 1.0 / mass[end];
        }
        paths.iter().for_each(|led| ease[led.node] = 0.0);
        let free = (0..ease.len()).filter(|&node| ease[node] > 0.0).collect();
        let position = cut_web.nodes.iter().map(|&node| (node - cut_web.web.middle).with_z(0.0)).collect();
        let turns = vec![DMat3::IDENTITY; packing.plates.len()];
        Self { packing, cut_web, paths, ends, ties, ease, free, position, turns }
    }

    /// Runs until it rests.
    fn run(&mut self) -> Settled {
        let end = self.paths.iter().map(Led::end).fold(0.0, f64::max);
        let mut velocity = vec![DVec3::ZERO; self.position.len()];
        let (mut step, mut largest, mut share) = (0u32, 0.0f64, 1.0);
        loop {
            let time = f64::from(step) * STEP;
            if time >= end && (share <= self.packing.rest || time >= self.packing.longest) {
                break;
            }
            step += 1;
            let now = f64::from(step) * STEP;
            let closed = if end > 0.0 { 0.5 * (1.0 - libm::cos(PI * (now / end).min(1.0))) } else { 1.0 };
            self.step(&mut velocity, now, closed);
            let energy = self.free.iter().map(|&node| velocity[node].length_squared() / self.ease[node]).sum::<f64>();
            largest = largest.max(energy);
            share = if largest > 0.0 { energy / largest } else { 0.0 };
        }
        let Self { packing, cut_web, ties, ease, position, turns, .. } = self;
        Drawn { cut_web, ties, plates: &packing.plates, ease }.draw_in(turns, position);
        self.fill_in();
        Settled { time: f64::from(step) * STEP, share }
    }

    /// A step to the time `now`, s, where the wall has closed in by the share `closed` of its way.
    fn step(&mut self, velocity: &mut [DVec3], now: f64, closed: f64) {
        let Prescribed { radius, depth, gravity, damping, .. } = *self.packing;
        let before = self.position.clone();
        let keeps = libm::exp(-damping * STEP);
        for &node in &self.free {
            let way = keeps * (velocity[node] - gravity * STEP * DVec3::Z) * STEP;
            self.position[node] += way;
        }
        for led in &self.paths {
            let flat = (self.cut_web.nodes[led.node] - self.cut_web.web.middle).with_z(0.0);
            self.position[led.node] = flat + led.at(now);
        }
        let reach = self.cut_web.web.radius();
        let wall = reach + closed * (radius - reach);
        let floor = depth.map_or(f64::NEG_INFINITY, |depth| -depth);
        let Self { packing, cut_web, ties, ease, position, turns, free, .. } = self;
        let drawn = Drawn { cut_web, ties, plates: &packing.plates, ease };
        for sweep in 0..SWEEPS {
            drawn.sweep(sweep % 2 == 1, 0.0, turns, position);
            for &node in &*free {
                let place = &mut position[node];
                let away = place.truncate().length();
                if away > wall {
                    (place.x, place.y) = (place.x * wall / away, place.y * wall / away);
                }
                place.z = place.z.max(floor);
            }
        }
        drawn.place_plates(turns, position);
        for &node in &self.free {
            velocity[node] = (self.position[node] - before[node]) / STEP;
        }
    }

    /// Lays the nodes inside pieces evenly between their ends.
    fn fill_in(&mut self) {
        for (rope, ends) in self.ends.iter().enumerate() {
            let nodes = self.cut_web.nodes_of(rope);
            for piece in ends.windows(2) {
                let (a, b) = (self.position[nodes[piece[0]]], self.position[nodes[piece[1]]]);
                for place in piece[0] + 1..piece[1] {
                    self.position[nodes[place]] = a.lerp(b, (place - piece[0]) as f64 / (piece[1] - piece[0]) as f64);
                }
            }
        }
    }
}

/// The places along each rope, counted in its nodes from 0, between which it is straight: pieces of much the same length,
/// which end wherever a node is led.
fn piece_ends(cut_web: &CutWeb, paths: &[Led]) -> Vec<Vec<usize>> {
    let longest = PIECE * cut_web.web.radius();
    let mut is_led = vec![false; cut_web.nodes.len()];
    paths.iter().for_each(|led| is_led[led.node] = true);
    let of_rope = |cut: &CutRope| {
        let whole = cut.segments as f64 * cut.segment_length;
        let pieces = ((whole / longest).ceil().max(1.0) as usize).min(cut.segments);
        let even = (0..=pieces).map(|piece| piece * cut.segments / pieces);
        let led = cut.interior().zip(1..).filter(|(node, _)| is_led[*node]).map(|(_, place)| place);
        let ends: BTreeSet<usize> = even.chain(led).collect();
        ends.into_iter().collect()
    };
    cut_web.ropes.iter().map(of_rope).collect()
}

/// All ropes in pieces with these `ends`.
fn pieces(cut_web: &CutWeb, ends: &[Vec<usize>]) -> impl Iterator<Item = Tie> {
    ends.iter().enumerate().flat_map(|(rope, ends)| {
        let nodes = cut_web.nodes_of(rope);
        let segment = cut_web.ropes[rope].segment_length;
        let tie = move |pair: &[usize]| Tie {
            ends: [nodes[pair[0]], nodes[pair[1]]],
            length: (pair[1] - pair[0]) as f64 * segment,
        };
        ends.windows(2).map(tie)
    })
}

/// The web's mass at the ends of ties, kg, (nodes,): that inside a piece at its ends, that of a plate at its knots.
fn lumped(packing: &Prescribed, cut_web: &CutWeb, ends: &[Vec<usize>]) -> Vec<f64> {
    let mut mass = packing.mass.clone();
    for (rope, ends) in ends.iter().enumerate() {
        let nodes = cut_web.nodes_of(rope);
        for piece in ends.windows(2) {
            let inside = &nodes[piece[0] + 1..piece[1]];
            let half = 0.5 * inside.iter().map(|&node| mass[node]).sum::<f64>();
            [piece[0], piece[1]].iter().for_each(|&end| mass[nodes[end]] += half);
        }
    }
    for plate in &packing.plates {
        let canopy = &cut_web.web.canopies[plate.canopy];
        let whole: f64 = plate.nodes.iter().map(|&node| mass[node]).sum();
        let knots = || canopy.rim.into_iter().chain([canopy.hub]);
        knots().for_each(|knot| mass[knot] = whole / 7.0);
    }
    mass
}

#[cfg(test)]
mod tests {
    use super::super::longest_stretch;
    use super::*;
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
    fn every_web_comes_to_rest_in_its_container_and_nothing_is_stretched() {
        let webs = [traditional(2.5, 6), space(2.5, 0.14), polygon(5, 2.5, 0.4), square(3.5, 0.5)];
        for (web, segment_length) in webs.into_iter().zip([0.1, 0.2, 0.05, 0.5]) {
            let web = web.unwrap().with_traction(1.2, 1).unwrap();
            let net = cut(&web, &Cutting::SegmentLength(segment_length)).unwrap();
            for depth in [None, Some(0.6)] {
                let packing = prescribed(&net, 0.4, depth);
                let (packed, _, settled) = packing.pack(&net, None).unwrap();
                let case = format!("{:?}, {depth:?}, {settled:?}", web.kind);
                assert!(longest_stretch(&net, &packed) < 1e-10, "{case}: {}", longest_stretch(&net, &packed));
                assert!(settled.share <= 1e-4 && settled.time < 20.0, "{case}");
                let ring = packed[web.outline[0][0]].z;
                for (node, place) in packed.iter().enumerate().filter(|(node, _)| net.is_web()[*node]) {
                    assert!(place.truncate().length() < 0.4 + 1e-3, "{case}: {node}");
                    assert!(depth.is_none_or(|depth| place.z > ring - depth - 1e-3), "{case}: {node}");
                }
                // bits do not depend on anything else
                assert_eq!(packing.pack(&net, None).unwrap().0, packed, "{case}");
            }
        }
    }

    #[test]
    fn plates_keep_their_shape_on_the_way() {
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
        let to = |node: usize, x: f64| Led { node, path: vec![(0.0, DVec3::ZERO), (1.0, DVec3::new(x, 0.0, 0.0))] };
        let mut packing = prescribed(&net, 1.0, None);
        packing.paths = vec![to(0, 0.5), to(1, -0.5)];
        // nodes inside bear a segment, the ends half of one
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

    /// The middle of a rope is inside a piece, unless it is led.
    #[test]
    fn a_node_inside_a_rope_goes_where_it_is_led() {
        let net = cut(&square(2.0, 0.5).unwrap(), &Cutting::SegmentLength(0.02)).unwrap();
        let mut packing = prescribed(&net, 1.0, None);
        let nodes = net.nodes_of(3);
        let free = piece_ends(&net, &[]);
        let led = (1..25).map(|place| nodes[place]).find(|node| !free[3].iter().any(|&end| nodes[end] == *node));
        let led = led.expect("pieces have nodes inside");
        let by = DVec3::new(0.0, 0.0, 0.3);
        packing.paths = vec![Led { node: led, path: vec![(0.0, DVec3::ZERO), (0.5, by)] }];
        let mut settling = Settling::new(&packing, &net, packing.paths.clone());
        settling.run();
        assert!(settling.position[led].distance(net.nodes[led] - net.web.middle + by) < 1e-12);
        assert!(longest_stretch(&net, &settling.position) < 1e-10);
        // and the web hangs from it
        assert!(settling.position.iter().all(|place| place.z <= by.z));
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let net = cut(&square(2.0, 0.5).unwrap(), &Cutting::SegmentLength(0.25)).unwrap();
        for radius in [0.0, -1.0, 3.0, f64::NAN] {
            let refused = prescribed(&net, radius, None).pack(&net, None);
            assert!(matches!(refused, Err(PackingError::Radius { .. })));
        }
        assert!(matches!(prescribed(&net, 0.3, Some(-1.0)).pack(&net, None), Err(PackingError::Size { .. })));
        let mut bare = net.clone();
        bare.web.outline.clear();
        assert_eq!(prescribed(&bare, 0.3, None).pack(&bare, None).unwrap_err(), PackingError::NothingLed);
    }
}

//! Joins the ropes of a net into few long polylines.
//!
//! Two thousand separate segments take five times the bytes of the same segments in trails that continue through knots.
//! Where a net has more segments than a picture can show, nodes inside ropes are left out.

use glam::IVec2;

use super::colour::{BINS, TensionScale};
use crate::results::Scene;

/// Most segments that are drawn with every node.
const MOST_SEGMENTS: usize = 6000;

/// The ropes of a net as trails; each segment is in exactly one.
pub(crate) struct Strands {
    trails: Vec<Trail>,
    /// Segments in the order of the trails.
    order: Vec<usize>,
    /// Whether nodes inside ropes are left out.
    pub thinned: bool,
}

/// A polyline along segments.
struct Trail {
    /// The first node.
    start: usize,
    links: Vec<Link>,
}

/// A straight piece of a trail: one segment, or consecutive ones without the nodes between them.
struct Link {
    /// The node at its end.
    to: usize,
    /// End of its range in [`Strands::order`], exclusive; the range begins where that of the link before ends.
    until: usize,
}

impl Strands {
    /// The ropes of a scene, without the members of canopies.
    pub fn new(scene: &Scene) -> Self {
        let topology = &scene.fields.topology;
        let ropes: Vec<usize> = (0..topology.segments.len()).filter(|segment| scene.is_rope(*segment)).collect();
        let stride = ropes.len().div_ceil(MOST_SEGMENTS).max(1);
        let meeting = Meeting::new(scene, &ropes);

        let mut strands = Self { trails: Vec::new(), order: Vec::with_capacity(ropes.len()), thinned: false };
        let mut used = vec![false; topology.segments.len()];
        // at a node with an odd number of segments a trail must begin or end: begin at those first (Euler)
        let is_odd = |node: &usize| meeting.at(*node).len() % 2 == 1;
        let odd = (0..topology.nodes).filter(is_odd);
        for start in odd.chain(0..topology.nodes) {
            while let Some(trail) = strands.walk(scene, &meeting, &mut used, start, stride) {
                strands.trails.push(trail);
            }
        }
        let links: usize = strands.trails.iter().map(|trail| trail.links.len()).sum();
        strands.thinned = links < strands.order.len();
        strands
    }

    /// Follows unused segments from node `start` until none is left; none where none begins there. It marks them as
    /// used, and makes a link of up to `stride` segments inside a rope.
    fn walk(
        &mut self,
        scene: &Scene,
        meeting: &Meeting,
        used: &mut [bool],
        start: usize,
        stride: usize,
    ) -> Option<Trail> {
        let topology = &scene.fields.topology;
        let mut trail = Trail { start, links: Vec::new() };
        let (mut node, mut class, mut begin) = (start, None, self.order.len());
        loop {
            let left = || meeting.at(node).iter().copied().filter(|&segment| !used[segment]);
            // prefer the same link class beyond a knot
            let alike = left().find(|&segment| Some(topology.classes[segment]) == class);
            let Some(segment) = alike.or_else(|| left().next()) else { break };
            used[segment] = true;
            class = Some(topology.classes[segment]);
            let [one, other] = topology.segments[segment].map(|end| end as usize);
            node = if one == node { other } else { one };
            self.order.push(segment);
            let until = self.order.len();
            let inside_rope = meeting.at(node).len() == 2;
            if inside_rope && until - begin < stride {
                continue;
            }
            trail.links.push(Link { to: node, until });
            begin = until;
        }
        // the last segments of a loop without knots may be fewer than a stride
        if self.order.len() > begin {
            trail.links.push(Link { to: node, until: self.order.len() });
        }
        (!trail.links.is_empty()).then_some(trail)
    }

    /// The ropes of each bin as SVG path data; the last entry holds the slack ropes. `points` holds the picture
    /// coordinates of all nodes, `tensions` those of all segments, N, NaN for a broken one. A link of several segments
    /// has the highest of their tensions, and is left out once any of them has broken.
    pub fn paths(&self, points: &[IVec2], tensions: &[f64], scale: &TensionScale) -> [String; BINS + 1] {
        let mut pens = [const { Pen::new() }; BINS + 1];
        let mut from = 0;
        for trail in &self.trails {
            let mut here = points[trail.start];
            for link in &trail.links {
                let borne = || self.order[from..link.until].iter().map(|&segment| tensions[segment]);
                let there = points[link.to];
                if !borne().any(f64::is_nan) {
                    let tension = borne().fold(0.0, f64::max);
                    pens[scale.bin(tension).unwrap_or(BINS)].line(here, there);
                }
                (here, from) = (there, link.until);
            }
        }
        pens.map(|pen| pen.path)
    }
}

/// The rope segments at each node.
struct Meeting {
    begins: Vec<usize>,
    segments: Vec<usize>,
}

impl Meeting {
    fn new(scene: &Scene, ropes: &[usize]) -> Self {
        let topology = &scene.fields.topology;
        let ends = || ropes.iter().flat_map(|&segment| topology.segments[segment].map(|end| (end as usize, segment)));
        let mut begins = vec![0; topology.nodes + 1];
        for (node, _) in ends() {
            begins[node + 1] += 1;
        }
        for node in 0..topology.nodes {
            begins[node + 1] += begins[node];
        }
        let (mut next, mut segments) = (begins.clone(), vec![0; 2 * ropes.len()]);
        for (node, segment) in ends() {
            segments[next[node]] = segment;
            next[node] += 1;
        }
        Self { begins, segments }
    }

    fn at(&self, node: usize) -> &[usize] {
        &self.segments[self.begins[node]..self.begins[node + 1]]
    }
}

/// Writes lines as SVG path data in relative whole numbers.
struct Pen {
    path: String,
    at: Option<IVec2>,
    /// The last command: SVG repeats it where the letter is left out.
    letter: char,
}

impl Pen {
    const fn new() -> Self {
        Self { path: String::new(), at: None, letter: ' ' }
    }

    fn line(&mut self, from: IVec2, to: IVec2) {
        // too short to be seen; the next line begins at the same place
        if from == to {
            return;
        }
        match self.at {
            None => self.step('M', from),
            Some(at) if at != from => self.step('m', from - at),
            Some(_) => {}
        }
        self.step('l', to - from);
        self.at = Some(to);
    }

    fn step(&mut self, letter: char, by: IVec2) {
        if letter != self.letter {
            self.path.push(letter);
        } else if by.x >= 0 {
            self.path.push(' ');
        }
        self.letter = letter;
        let gap = if by.y >= 0 { " " } else { "" };
        self.path.push_str(&format!("{}{gap}{}", by.x, by.y));
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use netcast_results::{FieldsTopology, FieldsWriter, Landmarks, read_fields};
    use serde_json::{from_value, json};

    use super::*;

    /// A scene of ropes between nodes.
    fn scene(nodes: usize, segments: Vec<[u32; 2]>) -> Scene {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.vtkhdf");
        let count = segments.len();
        let topology = FieldsTopology {
            nodes,
            segments,
            classes: vec![0; count],
            triangles: Vec::new(),
            class_names: vec!["rope".into()],
            ..FieldsTopology::default()
        };
        let mut fields = FieldsWriter::new(topology).unwrap();
        fields.push(0.0, &vec![DVec3::ZERO; nodes], &vec![DVec3::ZERO; nodes], &vec![0.0; count], &[]).unwrap();
        fields.finish(&path).unwrap();
        let landmarks: Landmarks = from_value(json!({
            "axis": [0.0, 0.0, 1.0], "outline": [], "reference_area_m2": null, "flat_posture_m": 0.0, "corners": [],
            "mouth": [], "mouth_reach_m": [], "cells": [], "target_diameter_m": null, "tractors": [], "centre": [],
            "points": [], "bottom": [], "classes": [], "ropes": [], "groups": [], "canopies": [], "bodies": []
        }))
        .unwrap();
        Scene::new(read_fields(&path).unwrap(), landmarks)
    }

    fn links(strands: &Strands) -> usize {
        strands.trails.iter().map(|trail| trail.links.len()).sum()
    }

    #[test]
    fn every_segment_is_drawn_once_in_few_trails() {
        // a star of three ropes with a triangle at one end, a separate loop, and a node without ropes
        let segments = vec![[0, 1], [0, 2], [0, 3], [3, 4], [4, 5], [5, 3], [6, 7], [7, 8], [8, 6]];
        let strands = Strands::new(&scene(10, segments.clone()));
        let mut order = strands.order.clone();
        order.sort();
        assert_eq!(order, (0..segments.len()).collect::<Vec<_>>());
        assert_eq!(links(&strands), segments.len());
        assert!(!strands.thinned);
        assert!(strands.trails.len() <= 4, "{}", strands.trails.len());
    }

    #[test]
    fn thinned_ropes_keep_their_ends_and_their_highest_tension() {
        // two ropes in line with 1.5 times the limit of segments, and a third at the knot between them
        let half = MOST_SEGMENTS * 3 / 4;
        let mut segments: Vec<[u32; 2]> = (0..2 * half as u32).map(|node| [node, node + 1]).collect();
        let count = segments.len();
        segments.push([half as u32, 2 * half as u32 + 1]);
        let strands = Strands::new(&scene(count + 2, segments));
        assert!(strands.thinned);
        assert!(links(&strands) <= MOST_SEGMENTS, "{}", links(&strands));
        let points: Vec<IVec2> = (0..count as i32 + 2).map(|node| IVec2::new(node, 0)).collect();
        let scale = TensionScale::up_to(100.0);
        for hardest in [0, 1, half - 1, half, count - 1, count] {
            let mut tensions = vec![0.0; count + 1];
            tensions[hardest] = 100.0;
            let paths = strands.paths(&points, &tensions, &scale);
            assert!(!paths[BINS - 1].is_empty(), "segment {hardest}");
        }
        // ends and knots stay
        let ends = strands.trails.iter().flat_map(|trail| trail.links.iter().map(|link| link.to).chain([trail.start]));
        let drawn: Vec<usize> = ends.collect();
        for kept in [0, half, count, count + 1] {
            assert!(drawn.contains(&kept), "node {kept}");
        }
    }

    #[test]
    fn path_data_leaves_out_repeated_letters_and_needless_spaces() {
        let mut pen = Pen::new();
        pen.line(IVec2::new(10, 20), IVec2::new(13, 16));
        pen.line(IVec2::new(13, 16), IVec2::new(13, 16));
        pen.line(IVec2::new(13, 16), IVec2::new(8, 17));
        pen.line(IVec2::new(8, 17), IVec2::new(9, 17));
        pen.line(IVec2::new(0, 0), IVec2::new(1, 1));
        assert_eq!(pen.path, "M10 20l3-4-5 1 1 0m-9-17l1 1");
    }
}

//! Merges stubs: short ropes between the outline and the first knot inside it. A stub would limit the time step of the
//! whole web, so its inner knot is merged into its knot on the outline.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Class, Rope, Site, Web};

/// A stub that was removed together with its inner knot.
#[derive(Debug, Clone, PartialEq)]
pub struct Merged {
    /// Label of the rope removed.
    pub rope: String,
    /// Length as drawn, m.
    pub length: f64,
    /// Label of the inner knot, which was removed.
    pub knot: String,
    /// Label of the outline's knot in its place.
    pub into: String,
}

/// A stub, by the indices of its rope and its two knots.
struct Stub {
    rope: usize,
    /// Its knot inside the outline.
    inner: usize,
    /// Its knot on the outline.
    outer: usize,
}

/// The changes that a merge makes to a web.
struct Plan {
    /// The outline knot in the place of each merged knot.
    into: BTreeMap<usize, usize>,
    /// Ropes to remove; each begins or ends at a merged knot.
    removed: BTreeSet<usize>,
}

impl Web {
    /// Merges the inner knots of stubs into the outline and returns the ropes removed.
    ///
    /// A stub joins a knot of the outline to a knot inside. It is shorter than `min_length`, m, and shorter than half
    /// the longest rope at its inner knot: a whole mesh is thus no stub, for any `min_length`. A knot with several
    /// stubs moves along the shortest. If another of its stubs then lies along a rope of the outline, this stub is
    /// removed too. The outline keeps its shape. Knots of canopies, rope hexagons and the centre are never merged.
    /// Ropes and knots keep their labels but not their indices. A rope that was tied to a merged knot gets its new
    /// length as drawn, unless it has a rest length of its own.
    pub fn merge_stubs(&mut self, min_length: f64) -> Vec<Merged> {
        let stubs = self.stubs(min_length);
        let plan = self.plan(&stubs);
        let merged = plan.removed.iter().map(|&rope| self.describe(&plan, rope)).collect();
        self.apply(&plan);
        merged
    }

    fn stubs(&self, min_length: f64) -> Vec<Stub> {
        let on_outline: BTreeSet<usize> =
            self.outline.iter().filter(|knots| knots.len() == 1).flatten().copied().collect();
        let kept = self.knots_that_stay();
        let mut longest = vec![0.0_f64; self.knots.len()];
        for rope in &self.ropes {
            for knot in [rope.a, rope.b] {
                longest[knot] = longest[knot].max(self.drawn_length(rope));
            }
        }
        let mut stubs = Vec::new();
        for (index, rope) in self.ropes.iter().enumerate() {
            let length = self.drawn_length(rope);
            for (inner, outer) in [(rope.a, rope.b), (rope.b, rope.a)] {
                let is_short = length < min_length && length < 0.5 * longest[inner];
                if is_short && on_outline.contains(&outer) && !kept.contains(&inner) {
                    stubs.push(Stub { rope: index, inner, outer });
                }
            }
        }
        stubs
    }

    /// Knots that are never merged: those of the outline, canopies, rope hexagons, corners, tractors and the centre.
    fn knots_that_stay(&self) -> BTreeSet<usize> {
        let outline = self.outline.iter().flatten().copied();
        let canopies = self.canopies.iter().flat_map(|canopy| canopy.rim.into_iter().chain([canopy.hub]));
        let hexagons = self.ropes.iter().filter(|rope| rope.class == Class::Hexagon).flat_map(|rope| [rope.a, rope.b]);
        let named = [&self.corners, &self.tractors, &self.centre].into_iter().flatten().copied();
        outline.chain(canopies).chain(hexagons).chain(named).collect()
    }

    /// Where each inner knot goes, and which ropes are removed.
    fn plan(&self, stubs: &[Stub]) -> Plan {
        // the shortest stub of each knot; of equal stubs the first
        let mut shortest: BTreeMap<usize, (f64, usize)> = BTreeMap::new();
        for &Stub { rope, inner, outer } in stubs {
            let length = self.drawn_length(&self.ropes[rope]);
            let best = shortest.entry(inner).or_insert((length, outer));
            if length < best.0 {
                *best = (length, outer);
            }
        }
        let into: BTreeMap<usize, usize> = shortest.into_iter().map(|(inner, (_, outer))| (inner, outer)).collect();

        let outline_ropes: BTreeSet<(usize, usize)> =
            self.ropes.iter().filter(|rope| rope.class == Class::Outline).map(|rope| sorted(rope.a, rope.b)).collect();
        let removed = stubs
            .iter()
            .filter(|stub| {
                let into = into[&stub.inner];
                into == stub.outer || outline_ropes.contains(&sorted(into, stub.outer))
            })
            .map(|stub| stub.rope)
            .collect();
        Plan { into, removed }
    }

    fn describe(&self, plan: &Plan, index: usize) -> Merged {
        let rope = &self.ropes[index];
        let inner = if plan.into.contains_key(&rope.a) { rope.a } else { rope.b };
        let label = |knot: usize| self.knots[knot].label.clone();
        let length = self.drawn_length(rope);
        Merged { rope: rope.label.clone(), length, knot: label(inner), into: label(plan.into[&inner]) }
    }

    fn apply(&mut self, plan: &Plan) {
        // new indices of knots and ropes; a merged knot has the index of the knot in its place
        let mut knot_index = new_indices(self.knots.len(), |knot| plan.into.contains_key(&knot));
        for (&inner, &outer) in &plan.into {
            knot_index[inner] = knot_index[outer];
        }
        let rope_index = new_indices(self.ropes.len(), |rope| plan.removed.contains(&rope));

        for site in self.points.values_mut() {
            *site = match *site {
                Site::Knot(knot) => Site::Knot(knot_index[knot]),
                Site::OnRope { rope, .. } if plan.removed.contains(&rope) => Site::Knot(knot_index[self.ropes[rope].a]),
                Site::OnRope { rope, fraction } => Site::OnRope { rope: rope_index[rope], fraction },
            };
        }
        retain_indexed(&mut self.knots, |knot| !plan.into.contains_key(&knot));
        retain_indexed(&mut self.ropes, |rope| !plan.removed.contains(&rope));
        for Rope { a, b, .. } in &mut self.ropes {
            (*a, *b) = (knot_index[*a], knot_index[*b]);
        }
        for canopy in &mut self.canopies {
            canopy.hub = knot_index[canopy.hub];
            canopy.rim = canopy.rim.map(|knot| knot_index[knot]);
        }
        let lists = [&mut self.corners, &mut self.tractors, &mut self.centre];
        for knot in self.outline.iter_mut().chain(lists).flatten() {
            *knot = knot_index[*knot];
        }
        for rope in self.traction.iter_mut().flatten() {
            *rope = rope_index[*rope];
        }
    }
}

fn sorted(a: usize, b: usize) -> (usize, usize) {
    (a.min(b), a.max(b))
}

/// New index of each of `count` items after some are removed; a removed item has the index of the next one that stays.
fn new_indices(count: usize, is_removed: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut next = 0;
    (0..count)
        .map(|index| {
            let new = next;
            next += usize::from(!is_removed(index));
            new
        })
        .collect()
}

/// Keeps the items whose indices `keep` accepts.
fn retain_indexed<T>(items: &mut Vec<T>, keep: impl Fn(usize) -> bool) {
    let mut index = 0;
    items.retain(|_| {
        index += 1;
        keep(index - 1)
    });
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::{space, square, topological, traditional};

    fn shortest(web: &Web) -> f64 {
        web.ropes.iter().map(|rope| web.drawn_length(rope)).fold(f64::MAX, f64::min)
    }

    #[test]
    fn a_least_length_of_0_05_m_merges_the_four_stubs_of_0_047_m() {
        let mut web = traditional(2.5, 6).unwrap();
        let before = web.clone();
        let merged = web.merge_stubs(0.05);
        // four stubs of 0.047 m; their knots have another short rope each, which is 0.082 m long and stays
        assert_eq!(merged.len(), 4);
        assert!(merged.iter().all(|stub| (stub.length - 0.0472).abs() < 1e-4));
        assert_eq!(web.knots.len(), before.knots.len() - 4);
        assert_eq!(web.ropes.len(), before.ropes.len() - 4);
        assert!(shortest(&web) > 0.05);
        assert_eq!(web.check(), []);
    }

    #[test]
    fn a_second_stub_that_would_lie_along_the_outline_is_removed_too() {
        let mut web = traditional(2.5, 6).unwrap();
        let before = web.clone();
        // on either side seven rows end 0.082 m outside the outermost column; the first and last also have the stubs of
        // 0.047 m
        assert_eq!(web.merge_stubs(0.1).len(), 2 * 7 + 4);
        assert_eq!(web.knots.len(), before.knots.len() - 2 * 7);
        assert_eq!(web.ropes.len(), before.ropes.len() - (2 * 7 + 4));
    }

    #[test]
    fn the_outline_and_the_feature_points_keep_their_places() {
        for min_length in [0.05, 0.1, 0.2, 1.0] {
            let before = traditional(2.5, 6).unwrap().with_traction(1.0, 2).unwrap();
            let mut web = before.clone();
            assert!(!web.merge_stubs(min_length).is_empty());
            let outline =
                |web: &Web| -> Vec<DVec3> { web.outline.iter().map(|knots| web.mean_position(knots)).collect() };
            assert_eq!(outline(&web), outline(&before));
            for (point, site) in &before.points {
                assert_eq!(web.position(web.points[point]), before.position(*site), "{point} at {min_length}");
            }
            let at = |web: &Web, knots: &[usize]| -> Vec<String> {
                knots.iter().map(|&knot| web.knots[knot].label.clone()).collect()
            };
            assert_eq!(at(&web, &web.corners), at(&before, &before.corners));
            assert_eq!(at(&web, &web.tractors), at(&before, &before.tractors));
            assert_eq!(web.ropes[web.traction[3][1]].label, before.ropes[before.traction[3][1]].label);
            assert_eq!(web.check(), [], "{min_length}");
            let outline_length = web.rope_length_by_class()[&Class::Outline];
            assert!((outline_length - 15.0).abs() < 1e-12);
        }
    }

    #[test]
    fn whole_meshes_are_never_stubs() {
        let mut web = traditional(2.5, 6).unwrap();
        let merged = web.merge_stubs(10.0);
        assert!(merged.iter().all(|stub| stub.length < 0.5 * 2.5 / 6.0));
        let mut net = square(2.0, 0.5).unwrap();
        assert_eq!(net.merge_stubs(10.0), []);
    }

    #[test]
    fn canopies_and_rope_hexagons_are_never_merged() {
        for web in [space(2.5, 0.14).unwrap(), topological(2.5, 0.14).unwrap()] {
            let mut merged = web.clone();
            assert_eq!(merged.merge_stubs(10.0), []);
            assert_eq!(merged, web);
        }
    }

    #[test]
    fn a_removed_rope_is_reported_with_the_labels_of_its_knots() {
        let mut web = traditional(2.5, 6).unwrap();
        let stub = web.merge_stubs(0.05).remove(0);
        assert!(stub.rope.starts_with("inner rope "), "{}", stub.rope);
        assert!(web.knots.iter().any(|knot| knot.label == stub.into));
        assert!(web.knots.iter().all(|knot| knot.label != stub.knot));
    }
}

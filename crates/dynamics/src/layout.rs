//! The order of nodes and segments in memory: each run of rope fills consecutive slots.
//!
//! A *run* is a walk along segments of one group that uses each segment once. Its nodes are copied, in order, into
//! *slots*; the segment of slot `i` joins it to slot `i + 1`, so that the hot loop reads its neighbours without an
//! index. The last slot of a node is its *home*, where the node is advanced. A node with several slots is a *knot*. Before
//! a knot is advanced, its home adds up the forces of its other slots, in ascending order. Afterwards the other slots get
//! the new values. The layout alone fixes that order, so any number of threads gives the same bits.
//!
//! Runs of one group fill *blocks* of at most [`BLOCK_SLOTS`] slots, the unit of work of a thread and of the cache. A run
//! that does not fit continues in the next block, and the node at the cut becomes a knot.

use crate::forces::segment::Segment;

/// Largest number of slots in a block: the data of one step for them fits a core's first-level cache.
pub const BLOCK_SLOTS: usize = 512;

/// A place of a node in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Slot {
    /// The node of which this slot has a copy.
    pub node: usize,
    /// The segment from this slot to the next; `None` at the end of a run.
    pub segment: Option<usize>,
}

/// The slots of one block; their segments are of one group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockPlan {
    /// The group of all its segments; the number of groups if it has no segments.
    pub group: usize,
    /// The slots, run after run.
    pub slots: Vec<Slot>,
}

/// Where a slot lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Address {
    /// Index of the block.
    pub block: usize,
    /// Index of the slot in the block.
    pub slot: usize,
}

/// The blocks of a net, and the slots of its nodes and segments.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    blocks: Vec<BlockPlan>,
    homes: Vec<Address>,
    knots: Vec<Vec<Address>>,
    segment_slots: Vec<Address>,
}

impl Layout {
    /// Lays out `segments` between `nodes` nodes in O(nodes + segments) time. `resting`, (nodes,): whether a node never moves.
    pub fn new(nodes: usize, segments: &[Segment], resting: &[bool], group_count: usize) -> Layout {
        let mut blocks = Vec::new();
        for group in 0..group_count {
            pack(group, runs(nodes, segments, group), &mut blocks);
        }
        pack(group_count, lone_nodes(nodes, segments), &mut blocks);

        let slots_of = slots_by_node(nodes, &blocks);
        let mut segment_slots = vec![Address { block: usize::MAX, slot: usize::MAX }; segments.len()];
        for (block, plan) in blocks.iter().enumerate() {
            for (slot, content) in plan.slots.iter().enumerate() {
                if let Some(segment) = content.segment {
                    segment_slots[segment] = Address { block, slot };
                }
            }
        }
        let homes = slots_of.iter().map(|slots| *slots.last().expect("every node has a slot")).collect();
        // a resting node has the same place in every slot: there is nothing to exchange
        let exchanging = slots_of.into_iter().zip(resting).filter(|(slots, resting)| slots.len() > 1 && !**resting);
        let mut knots: Vec<Vec<Address>> = exchanging.map(|(slots, _)| slots).collect();
        knots.sort_unstable_by_key(|slots| slots.last().copied());
        Layout { blocks, homes, knots, segment_slots }
    }

    /// The blocks, in the order of the groups.
    pub fn blocks(&self) -> &[BlockPlan] {
        &self.blocks
    }

    /// The home of each node; shape (nodes,).
    pub fn homes(&self) -> &[Address] {
        &self.homes
    }

    /// The slots of each knot that can move, ascending, so the last is its home. Knots are in the order of their homes.
    pub fn knots(&self) -> &[Vec<Address>] {
        &self.knots
    }

    /// The slot in which each segment starts; shape (segments,).
    pub fn segment_slots(&self) -> &[Address] {
        &self.segment_slots
    }

    /// All slots of each node, ascending; shape (nodes,).
    pub fn slots_by_node(&self) -> Vec<Vec<Address>> {
        slots_by_node(self.homes.len(), &self.blocks)
    }

    /// Number of slots in all blocks.
    pub fn slot_count(&self) -> usize {
        self.blocks.iter().map(|b| b.slots.len()).sum()
    }
}

/// All slots of each node, ascending.
fn slots_by_node(nodes: usize, blocks: &[BlockPlan]) -> Vec<Vec<Address>> {
    let mut slots_of = vec![Vec::new(); nodes];
    for (block, plan) in blocks.iter().enumerate() {
        for (slot, content) in plan.slots.iter().enumerate() {
            slots_of[content.node].push(Address { block, slot });
        }
    }
    slots_of
}

/// Walks that together use every segment of `group` once, each as a list of slots.
///
/// The first walks start at nodes where an odd number of segments meet, since a walk must end there anyway. Then only
/// closed loops are left. At a node a walk takes the first unused segment in the order given, so that a rope stays in
/// one run.
fn runs(nodes: usize, segments: &[Segment], group: usize) -> Vec<Vec<Slot>> {
    let mut meeting = vec![Vec::new(); nodes];
    for (i, s) in segments.iter().enumerate().filter(|(_, s)| s.group == group) {
        meeting[s.ends[0]].push(i);
        meeting[s.ends[1]].push(i);
    }
    let mut used = vec![false; segments.len()];
    let mut next_untried = vec![0; nodes];
    let mut found = Vec::new();
    let mut walk = |start: usize, used: &mut Vec<bool>| {
        let mut slots = Vec::new();
        let mut node = start;
        loop {
            let untried = &mut next_untried[node];
            while *untried < meeting[node].len() && used[meeting[node][*untried]] {
                *untried += 1;
            }
            let segment = meeting[node].get(*untried).copied();
            slots.push(Slot { node, segment });
            let Some(segment) = segment else { break };
            used[segment] = true;
            node = segments[segment].other_end(node);
        }
        if slots.len() > 1 {
            found.push(slots);
        }
    };
    for node in (0..nodes).filter(|&n| meeting[n].len() % 2 == 1) {
        walk(node, &mut used);
    }
    for (i, s) in segments.iter().enumerate().filter(|(_, s)| s.group == group) {
        if !used[i] {
            walk(s.ends[0], &mut used);
        }
    }
    found
}

/// Nodes without a segment, each as a run of its own.
fn lone_nodes(nodes: usize, segments: &[Segment]) -> Vec<Vec<Slot>> {
    let mut lone = vec![true; nodes];
    for node in segments.iter().flat_map(|s| s.ends) {
        lone[node] = false;
    }
    (0..nodes).filter(|&node| lone[node]).map(|node| vec![Slot { node, segment: None }]).collect()
}

/// Fills blocks of one group with runs, and cuts runs that do not fit.
fn pack(group: usize, runs: Vec<Vec<Slot>>, blocks: &mut Vec<BlockPlan>) {
    let mut open: Vec<Slot> = Vec::new();
    let mut close = |open: &mut Vec<Slot>| {
        if !open.is_empty() {
            blocks.push(BlockPlan { group, slots: std::mem::take(open) });
        }
    };
    for run in runs {
        if open.len() + run.len() > BLOCK_SLOTS {
            close(&mut open);
        }
        for slot in run {
            // a full block ends with a copy of the node at which the next block starts
            if open.len() + 1 == BLOCK_SLOTS && slot.segment.is_some() {
                open.push(Slot { segment: None, ..slot });
                close(&mut open);
            }
            open.push(slot);
        }
    }
    close(&mut open);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(a: usize, b: usize, group: usize) -> Segment {
        Segment { ends: [a, b], rest_length: 1.0, stiffness: 1.0, damping: 0.0, group, breaking: Default::default() }
    }

    fn layout(nodes: usize, segments: &[Segment]) -> Layout {
        let groups = segments.iter().map(|s| s.group + 1).max().unwrap_or(0);
        Layout::new(nodes, segments, &vec![false; nodes], groups)
    }

    /// Every segment lies in exactly one slot, between its own two ends.
    fn holds_every_segment_once(layout: &Layout, segments: &[Segment]) {
        let mut seen = vec![0; segments.len()];
        for block in layout.blocks() {
            assert!(block.slots.len() <= BLOCK_SLOTS);
            assert_eq!(block.slots.last().unwrap().segment, None);
            for pair in block.slots.windows(2) {
                if let Some(i) = pair[0].segment {
                    seen[i] += 1;
                    assert_eq!(segments[i].group, block.group);
                    assert_eq!(segments[i].other_end(pair[0].node), pair[1].node);
                }
            }
        }
        assert!(seen.iter().all(|&n| n == 1), "{seen:?}");
    }

    #[test]
    fn a_rope_is_one_run_of_private_nodes() {
        let rope: Vec<_> = (0..9).map(|i| segment(i, i + 1, 0)).collect();
        let layout = layout(10, &rope);
        assert_eq!(layout.slot_count(), 10);
        assert!(layout.knots().is_empty());
        holds_every_segment_once(&layout, &rope);
    }

    #[test]
    fn a_square_mesh_needs_hardly_more_slots_than_segments() {
        let (n, id) = (11, |i: usize, j: usize| i * 11 + j);
        let mut segments = Vec::new();
        for i in 0..n {
            for j in 0..n - 1 {
                segments.push(segment(id(i, j), id(i, j + 1), 0));
                segments.push(segment(id(j, i), id(j + 1, i), 0));
            }
        }
        let layout = layout(n * n, &segments);
        holds_every_segment_once(&layout, &segments);
        // 36 knots on the border have three ropes: at least 18 runs, each with one slot more than segments
        assert!(layout.slot_count() <= segments.len() + 20, "{}", layout.slot_count());
    }

    #[test]
    fn a_run_longer_than_a_block_is_continued_in_the_next() {
        let rope: Vec<_> = (0..2 * BLOCK_SLOTS).map(|i| segment(i, i + 1, 0)).collect();
        let layout = layout(2 * BLOCK_SLOTS + 1, &rope);
        holds_every_segment_once(&layout, &rope);
        assert_eq!(layout.blocks().len(), 3);
        assert_eq!(layout.knots().len(), 2);
    }

    #[test]
    fn a_lone_mass_has_a_home() {
        let layout = layout(3, &[segment(0, 1, 0)]);
        assert_eq!(layout.homes()[2], Address { block: 1, slot: 0 });
    }

    #[test]
    fn a_closed_loop_meets_itself_in_a_knot() {
        let ring: Vec<_> = (0..6).map(|i| segment(i, (i + 1) % 6, 0)).collect();
        let layout = layout(6, &ring);
        holds_every_segment_once(&layout, &ring);
        assert_eq!((layout.slot_count(), layout.knots().len()), (7, 1));
    }
}

//! A web at given positions: of every knot, and of any nodes inside ropes. The other nodes are spaced evenly on the
//! line between the nearest given nodes of their rope.

use glam::DVec3;

use super::PackingError;
use crate::CutWeb;

/// Positions that a user gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Given {
    /// Position of each node in the launch frame, m, (nodes,). Every knot must have one.
    pub positions: Vec<Option<DVec3>>,
}

impl Given {
    pub(super) fn pack(&self, cut_web: &CutWeb) -> Result<Vec<DVec3>, PackingError> {
        let (given, nodes) = (self.positions.len(), cut_web.nodes.len());
        if given != nodes {
            return Err(PackingError::Count { given, nodes });
        }
        let is_missing = |knot: &usize| self.positions[*knot].is_none();
        let knots: Vec<String> =
            (0..cut_web.web.knots.len()).filter(is_missing).map(|knot| cut_web.node_label(knot)).collect();
        if !knots.is_empty() {
            return Err(PackingError::Missing { knots });
        }
        let is_wrong = |position: &Option<DVec3>| position.is_some_and(|position| !position.is_finite());
        if let Some(node) = self.positions.iter().position(is_wrong) {
            return Err(PackingError::NotFinite(cut_web.node_label(node)));
        }

        // every other node lies inside a rope, between two given nodes
        let mut packed: Vec<DVec3> = self.positions.iter().map(|position| position.unwrap_or_default()).collect();
        for rope in 0..cut_web.ropes.len() {
            let nodes = cut_web.nodes_of(rope);
            let known: Vec<usize> = (0..nodes.len()).filter(|&place| self.positions[nodes[place]].is_some()).collect();
            for between in known.windows(2) {
                let (first, last) = (between[0], between[1]);
                let (start, end) = (packed[nodes[first]], packed[nodes[last]]);
                for place in first + 1..last {
                    let share = (place - first) as f64 / (last - first) as f64;
                    packed[nodes[place]] = start + (end - start) * share;
                }
            }
        }
        Ok(packed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Cutting, cut, square};

    fn net() -> CutWeb {
        cut(&square(1.0, 1.0).unwrap(), &Cutting::SegmentLength(0.25)).unwrap()
    }

    fn knots_only(net: &CutWeb) -> Vec<Option<DVec3>> {
        net.nodes.iter().enumerate().map(|(node, &at)| (node < 4).then_some(at)).collect()
    }

    #[test]
    fn with_positions_of_knots_alone_ropes_are_straight() {
        let net = net();
        let packed = Given { positions: knots_only(&net) }.pack(&net).unwrap();
        assert!(packed.iter().zip(&net.nodes).all(|(packed, flat)| packed.distance(*flat) < 1e-15));
    }

    #[test]
    fn a_rope_runs_through_a_given_node_inside_it() {
        let net = net();
        let mut positions = knots_only(&net);
        let nodes = net.nodes_of(0);
        let low = DVec3::new(0.0, -0.5, -0.4);
        positions[nodes[2]] = Some(low);
        let packed = Given { positions }.pack(&net).unwrap();
        assert_eq!(packed[nodes[2]], low);
        assert!(packed[nodes[1]].distance(DVec3::new(-0.25, -0.5, -0.2)) < 1e-15);
        assert!(packed[nodes[3]].distance(DVec3::new(0.25, -0.5, -0.2)) < 1e-15);
    }

    #[test]
    fn all_knots_without_a_position_are_named() {
        let net = net();
        let mut positions = knots_only(&net);
        positions[1] = None;
        positions[3] = None;
        let error = Given { positions }.pack(&net).unwrap_err();
        assert_eq!(error.to_string(), "some knots have no position: web corner 4, web corner 1");
    }

    #[test]
    fn lists_of_a_wrong_length_or_with_positions_not_finite_are_refused() {
        let net = net();
        assert!(matches!(Given { positions: vec![] }.pack(&net), Err(PackingError::Count { .. })));
        let mut positions = knots_only(&net);
        positions[5] = Some(DVec3::NAN);
        assert!(matches!(Given { positions }.pack(&net), Err(PackingError::NotFinite(_))));
    }
}

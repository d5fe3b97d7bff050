//! How stiff and how damped each node is, summed over what meets there: what bounds the step.

use crate::body::Body;
use crate::forces::element::Element;
use crate::forces::ground::Spring;
use crate::parts::SystemParts;

/// The segment or effect that makes a node stiff.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stiff {
    /// A segment, by its number.
    Segment(usize),
    /// An effect, by its name, and which of its elements, where it has some.
    Effect {
        /// The effect's name.
        name: &'static str,
        /// The element's number.
        index: Option<usize>,
    },
}

/// Stiffness and damping at each node, summed over segments and effects: they bound the step.
pub(crate) struct Bound {
    /// Sums of stiffness, N/m, (nodes,). A spring between two nodes counts in full at each; a spring between a
    /// node and the world counts half.
    pub stiffness: Vec<f64>,
    /// Sums of damping, N s/m, (nodes,); likewise.
    pub damping: Vec<f64>,
    stiffest: Vec<Option<(f64, Stiff)>>,
    /// The shares of contact in the stiffness and of drag in the damping, by effect; each (nodes,).
    contact: Vec<(&'static str, Vec<f64>)>,
    drag: Vec<(&'static str, Vec<f64>)>,
}

impl Bound {
    /// For `nodes` nodes, all zero.
    pub fn new(nodes: usize) -> Bound {
        let none = || vec![0.0; nodes];
        let (contact, drag) = (Vec::new(), Vec::new());
        Bound { stiffness: none(), damping: none(), stiffest: vec![None; nodes], contact, drag }
    }

    /// Something that joins a node to others.
    pub fn add(&mut self, node: usize, stiffness: f64, damping: f64, what: Stiff) {
        self.stiffness[node] += stiffness;
        self.damping[node] += damping;
        self.set_stiffest(node, stiffness, what);
    }

    /// The nodes of an element.
    pub fn add_element<E: Element<N>, const N: usize>(&mut self, element: &E, what: Stiff) {
        let (stiffness, damping) = (element.stiffness(), element.damping());
        for (k, node) in element.nodes().into_iter().enumerate() {
            self.add(node, stiffness[k], damping[k], what);
        }
    }

    /// A damper between a node and the world, N s/m.
    pub fn add_drag(&mut self, name: &'static str, node: usize, damping: f64) {
        self.damping[node] += 0.5 * damping;
        share(&mut self.drag, name, self.stiffness.len())[node] += 0.5 * damping;
    }

    /// A spring and damper between a node and the world, of which `part` acts on the node.
    pub fn add_contact(&mut self, name: &'static str, node: usize, part: f64, spring: &Spring) {
        self.stiffness[node] += part * spring.stiffness;
        self.damping[node] += part * spring.damping;
        share(&mut self.contact, name, self.stiffness.len())[node] += part * spring.stiffness;
    }

    /// Adds the stiffness and damping at a tie to those at its body's centre, times `lever`.
    pub fn pass(&mut self, tie: usize, centre: usize, lever: f64) {
        let drag = self.drag.iter_mut().map(|(_, of_node)| of_node);
        for of_node in [&mut self.stiffness, &mut self.damping].into_iter().chain(drag) {
            of_node[centre] += lever * of_node[tie];
        }
        if let Some((stiffness, what)) = self.stiffest[tie] {
            self.set_stiffest(centre, lever * stiffness, what);
        }
    }

    /// The segment or effect that contributes most to the stiffness of a node of this mass, kg.
    pub fn stiffest(&self, node: usize, mass: f64) -> Option<Stiff> {
        let (stiffness, damping) = (self.stiffness[node], self.damping[node]);
        let most = |shares: &[(&'static str, Vec<f64>)], of: f64| {
            let most = shares.iter().find(|(_, share)| share[node] > 0.5 * of)?;
            Some(Stiff::Effect { name: most.0, index: None })
        };
        let is_overdamped = damping * damping > 0.5 * stiffness * mass;
        let drag = most(&self.drag, damping).filter(|_| is_overdamped);
        most(&self.contact, stiffness).or(drag).or(self.stiffest[node].map(|(_, what)| what))
    }

    /// The nodes where an effect has contact or drag; none where it has neither.
    pub fn share_of(&self, name: &str) -> Option<&[f64]> {
        let mut all = self.contact.iter().chain(&self.drag);
        all.find(|(of, _)| *of == name).map(|(_, share)| &share[..])
    }

    fn set_stiffest(&mut self, node: usize, stiffness: f64, what: Stiff) {
        if self.stiffest[node].is_none_or(|(other, _)| stiffness > other) {
            self.stiffest[node] = Some((stiffness, what));
        }
    }
}

/// The share of the effect of this name.
fn share<'s>(shares: &'s mut Vec<(&'static str, Vec<f64>)>, name: &'static str, nodes: usize) -> &'s mut [f64] {
    let at = shares.iter().position(|(of, _)| *of == name).unwrap_or_else(|| {
        shares.push((name, vec![0.0; nodes]));
        shares.len() - 1
    });
    &mut shares[at].1
}

/// By how much what pulls at a point `reach` metres from a body's centre moves it more than what pulls at the centre: at
/// once a push and a turn, 1 + r^2/g^2, with its least radius of gyration g as the measure of turning. A centre that is
/// held is turned only.
pub(crate) fn lever(parts: &SystemParts, body: &Body, reach: f64) -> f64 {
    let gyration_squared = body.inertia.min_element() / turning_mass(parts, body);
    let pushed = if parts.held[body.centre] { 0.0 } else { 1.0 };
    pushed + reach * reach / gyration_squared
}

/// The mass at whose radius of gyration a body's inertia stands for it, kg: its own, or at a metre where it has none.
pub(crate) fn turning_mass(parts: &SystemParts, body: &Body) -> f64 {
    let mass = parts.mass[body.centre];
    if mass == 0.0 { body.inertia.min_element() } else { mass }
}

//! The elements and rigid bodies of canopies that are plates or sheets.

use netcast_dynamics::forces::hinge::Hinge;
use netcast_dynamics::forces::membrane::Membrane;
use netcast_webs::{CutWeb, StiffPlate};

use super::binding::{Binding, Bound, Lump};
use super::members::PlacedBody;

/// The elements and rigid bodies of canopies that are plates or sheets.
#[derive(Debug, Clone, Default)]
pub struct Canopies {
    /// The canopies that are sheets, in the order of the web.
    pub sheets: Vec<CutSheet>,
    /// Triangles of the sheets, sheet by sheet.
    pub membranes: Vec<Membrane>,
    /// Hinges at which sheets resist bending.
    pub hinges: Vec<Hinge>,
    /// The canopies that keep their shape when the web is packed.
    pub plates: Vec<StiffPlate>,
    /// Rigid bodies made of nodes; empty before [`Canopies::bind`].
    pub bound: Vec<Bound>,
    pub(super) bindings: Vec<Binding>,
}

/// A canopy as a sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct CutSheet {
    /// Its nodes in the order of the mesh: its hub, then ring by ring outwards.
    pub nodes: Vec<usize>,
    /// Its triangles, by nodes of the system, (triangles, 3).
    pub triangles: Vec<[usize; 3]>,
    /// The nodes on its corners, anticlockwise.
    pub corners: [usize; 6],
}

impl Canopies {
    /// Adds `body` to the rigid body that its node belongs to. Returns whether there is one.
    pub fn carry(&mut self, body: &PlacedBody, cut: &CutWeb) -> bool {
        let binding = self.bindings.iter_mut().find(|binding| binding.nodes.contains(&body.node));
        if let Some(binding) = binding {
            binding.lumps.push(Lump {
                place: cut.nodes[body.node],
                mass: body.solid.mass_kg,
                inertia: body.solid.inertia_kg_m2().unwrap_or_default(),
            });
            return true;
        }
        false
    }

    /// The canopies that lie flat in a folded web: plates, and cloth too, whose triangles are larger than the bends of a fold.
    pub fn laid_in_folds(&self) -> Vec<StiffPlate> {
        let is_plate = |canopy: usize| self.plates.iter().any(|plate| plate.canopy == canopy);
        let cloth = self.sheets.iter().enumerate().filter(|(canopy, _)| !is_plate(*canopy));
        let cloth = cloth.map(|(canopy, sheet)| StiffPlate { canopy, nodes: sheet.nodes.clone() });
        self.plates.iter().cloned().chain(cloth).collect()
    }

    /// Makes the rigid bodies and adds a node at the centre of each. Needs the `mass` of every node, kg.
    pub fn bind(&mut self, cut: &mut CutWeb, mass: &mut Vec<f64>) {
        for binding in self.bindings.drain(..) {
            let bound = binding.bind(cut, mass);
            let plate = self.plates.iter_mut().find(|plate| plate.canopy == bound.canopy);
            plate.expect("a canopy of which a part is rigid keeps its shape").nodes.push(bound.body.centre);
            self.bound.push(bound);
        }
    }
}

/// The triangles that drag, by nodes, (triangles, 3): those of the sheets, or else six round the hub of each canopy.
pub fn triangles(sheets: &[CutSheet], cut: &CutWeb) -> Vec<[usize; 3]> {
    if !sheets.is_empty() {
        return sheets.iter().flat_map(|sheet| sheet.triangles.iter().copied()).collect();
    }
    let hexagons = cut.web.canopies.iter();
    hexagons.flat_map(|h| (0..6).map(|side| [h.hub, h.rim[side], h.rim[(side + 1) % 6]])).collect()
}

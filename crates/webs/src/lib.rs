//! What is thrown, before any physics: knots, ropes and canopies of each kind of web, cut into segments, packed, and
//! counted.
//!
//! ```text
//! square(..) traditional(..)   ──▶ Web ──with_traction──▶ Web ──cut──▶ CutWeb ──Pattern::pack──▶ positions
//! topological(..) space(..)         │                      │                                         │
//! polygon(..) radial(..)            ├ merge_stubs          └ bill                                    └ audit
//! diamond(..) graph(..)             └ with_gathering
//! ```
//!
//! Everything here is geometry in SI units: metres, kilograms, no files, no forces. A web is drawn flat in the plane
//! z = 0; a packed web lies in the launch frame, whose +z is the launch axis and whose plane z = 0 is the muzzle.
//!
//! ```
//! use netcast_webs::{Bag, Cutting, Pattern, cut, space};
//!
//! let web = space(2.5, 0.14)?.with_traction(1.0355, 1)?;
//! assert_eq!(web.canopies.len(), 31);
//! assert!((web.reference_area().unwrap() - 16.238).abs() < 1e-3);
//!
//! let cut_web = cut(&web, &Cutting::SegmentLength(0.1))?;
//! let packed = Pattern::Bag(Bag::of_radius(0.25)).pack(&cut_web)?;
//! assert_eq!(packed.len(), cut_web.nodes.len());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bill;
mod cells;
pub mod chance;
mod check;
mod class;
mod cut;
mod diamond;
mod error;
mod field;
mod gathering;
mod graph;
mod lattice;
pub mod packing;
mod pieces;
mod plates;
mod polygon;
mod radial;
mod rope_list;
mod sectors;
mod sheet;
mod space;
mod square;
mod stubs;
#[cfg(test)]
mod symmetry;
mod topological;
mod traction;
mod traditional;
mod vector_area;
mod web;

pub use bill::{Bill, PACKED_FILL, Parts, RopeKind, RopeLine, Solid, bill};
pub use class::Class;
pub use cut::{CutError, CutRope, CutSegment, CutWeb, Cutting, MOST_SEGMENTS, cut};
pub use diamond::{Diamond, diamond};
pub use error::WebError;
pub use field::{PackingField, WebField};
pub use graph::{Graph, GraphNode, GraphRope, graph};
pub use packing::{
    Approach, Audit, Bag, Closeness, Container, Folded, Folding, Given, Imperfection, Led, LongestStretch, Mouth,
    PackingError, Pattern, Prescribed, Scale, Sector, Settled, Size, StiffPlate, StowedSegment, audit, closeness,
};
pub use pieces::Pieces;
pub use polygon::{parallel_spacing, polygon};
pub use radial::{Radial, radial};
pub use sheet::{MOST_FINENESS, Sheet, hexagonal_sheet};
pub use space::space;
pub use square::square;
pub use stubs::Merged;
pub use topological::topological;
pub use traditional::{CELLS_PER_SIDE, traditional};
pub use vector_area::vector_area;
pub use web::{Canopy, Kind, Knot, Rope, Site, Web};

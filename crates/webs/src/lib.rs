//! Geometry of a web: draws it as knots, ropes and canopies, cuts it into segments, packs it for the launch, and lists
//! its parts.
//!
//! ```text
//! square(..) traditional(..)   ──▶ Web ──with_traction──▶ Web ──cut──▶ CutWeb ──Pattern::pack──▶ positions
//! topological(..) space(..)         │                      │                                         │
//! polygon(..) radial(..)            ├ merge_stubs          └ bill                                    └ audit
//! diamond(..) graph(..)             └ with_gathering
//! ```
//!
//! Units are SI. Nothing here reads or writes a file. A web is drawn flat in the plane z = 0. A packed web lies in the
//! launch frame: its +z is the launch axis, its plane z = 0 the muzzle.
//!
//! One part of the crate is not pure geometry: [`Prescribed`] lets a web settle in its container under gravity, by
//! position-based dynamics (`packing/position_based/`). A run takes only the positions from it, no velocity or force.
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
mod gathering;
mod graph;
mod lattice;
pub mod packing;
mod plane;
mod plates;
mod polygon;
mod radial;
mod rope_list;
#[cfg(test)]
mod samples;
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
mod web;

pub use bill::{Bill, BillItem, PACKED_FILL, Parts, RopeKind, RopeLine, bill};
pub use check::Pieces;
pub use class::Class;
pub use cut::{CutError, CutRope, CutSegment, CutWeb, Cutting, MOST_SEGMENTS, cut};
pub use diamond::{Diamond, diamond};
pub use error::WebError;
pub use graph::{Graph, GraphNode, GraphRope, graph};
pub use packing::{
    Approach, Audit, Bag, Closeness, Container, DrivenNode, Folded, Folding, Given, Imperfection, LongestStretch,
    Mouth, PackingError, Pattern, Prescribed, Scale, Sector, Settled, Size, StiffPlate, StowedSegment, audit,
    closeness,
};
pub use plane::vector_area;
pub use polygon::{parallel_spacing, polygon};
pub use radial::{Radial, radial};
pub use sheet::{Sheet, hexagonal_sheet};
pub use space::space;
pub use square::square;
pub use stubs::Merged;
pub use topological::topological;
pub use traditional::traditional;
pub use web::{Canopy, Knot, Rope, Site, Web};

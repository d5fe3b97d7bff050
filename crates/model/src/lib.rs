//! What a scenario means: a [`Document`](netcast_scenario::Document) becomes a [`Model`], which is the system that is
//! simulated, its state at the start, and the names of its parts.

mod lower;
mod model;

pub use lower::{
    AirOutline, CutSheet, Fall, Group, Link, Packing, PlacedBody, Role, RopesInAir, Throw, Thrown, node_id,
};
pub use model::Model;

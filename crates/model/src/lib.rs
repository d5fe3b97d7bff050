//! What a scenario means: a [`Document`](netcast_scenario::Document) becomes a [`Model`], which is the system that is
//! simulated, its state at the start, and the names of its parts.

mod lower;

pub use lower::{
    AirOutline, CutSheet, Fall, Group, Link, Model, Packing, PlacedBody, Role, RopesInAir, Throw, Thrown, node_id,
};

//! Turns a scenario into a model: a [`Document`](netcast_scenario::Document) becomes a [`Model`], the simulated system with
//! its state at the start and the names of its parts.

mod lower;
mod model;

pub use lower::{
    AirOutline, CutSheet, Fall, Group, Link, Packing, PlacedBody, Role, RopesInAir, Throw, Thrown, node_id,
};
pub use model::Model;

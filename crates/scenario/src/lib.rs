//! Reads a scenario in TOML, checks it and gives it a type.
//!
//! ```text
//! text ──tree──▶ Written ──check, rules──▶ Diagnostics: all faults, with file, line and column
//!                   └──────serde─────────▶ Scenario
//! ```
//!
//! [`Document::read`] does all of it. [`Scenario`] and its types are the only list of keys: the JSON Schema is
//! derived from them, and the check walks that schema. Their doc comments are the descriptions in the schema, which
//! editors show.

mod air;
mod air_rules;
mod body;
mod canopy;
mod check;
mod cover;
mod csv_table;
mod cut;
mod diagnostic;
pub mod dimension;
mod document;
mod drive;
mod environment;
mod exponents;
mod file_source;
mod files;
mod graph_files;
mod ground;
mod hold;
pub mod init;
pub mod interval;
mod later;
mod launch;
pub mod library;
mod load;
mod measure;
mod memory;
mod nearest;
mod orbit;
mod overrides;
pub mod path;
mod per_length;
pub mod quantity;
mod record;
mod rope;
mod rope_law;
mod rules;
mod scenario;
pub mod schema;
mod selection;
mod shift;
mod solve;
mod stow;
mod tables;
mod text_file;
mod tie;
mod tractor;
pub mod tree;
mod unit_error;
mod unit_table;
mod units;
mod web;
mod wind;
mod written;

pub use air::{Air, Solidity};
pub use body::{Body, Cuboid, Cylinder, Particle, Shape, Solid, Sphere};
pub use canopy::{Canopy, CanopyLinks, CanopyMembrane, CanopyRigid, SheetBending};
pub use cover::Cover;
pub use cut::Cut;
pub use diagnostic::{Diagnostic, Diagnostics, Location, Place, Source};
pub use document::Document;
pub use drive::{Drive, PathRow, Waypoint, misplaced};
pub use environment::Environment;
pub use file_source::FileSource;
pub use files::Files;
pub use graph_files::{GraphFiles, NodeRow, RopeRow};
pub use ground::Ground;
pub use hold::Hold;
pub use launch::{Attitude, Launch, PushRow, Scatter, StrokeForce, TimeForce, Tube};
pub use load::Load;
pub use measure::Measure;
pub use memory::{available as available_memory, in_words as bytes_in_words};
pub use nearest::nearest;
pub use orbit::Orbit;
pub use record::Record;
pub use rope::{Damping, Rope};
pub use rope_law::{
    BeyondTable, BilinearLaw, LawFile, LawFiles, LinearLaw, RopeBreaking, RopeLaw, StrutLaw, TableLaw, ViscoelasticLaw,
};
pub use rules::is_plain;
pub use scenario::{Scenario, resolved_toml};
pub use schema::schema;
pub use selection::Selection;
pub use solve::{OnEnergyError, Solve, Static};
pub use stow::{
    Along, BagStow, BoxRoom, Container, CylinderRoom, FileStow, FoldStow, Imperfect, LateSector, PrescribedStow,
    ScaleStow, StarStow, Stow, StowRow, Stowage, StowedNode, ZigzagStow, write_stow,
};
pub use tie::{BreakTie, Stitching};
pub use tractor::{TiedAt, TractionRope, TractorOverride};
pub use unit_error::UnitError;
pub use web::{Diamond, Gathering, Graph, Polygon, Radial, SpaceWeb, Square, Topological, Traditional, Web};
pub use wind::{Eddies, Gust, LogarithmicProfile, PowerProfile, Turbulence, Wind, WindRow, WindSeries};
pub use written::Written;

//! What the user wrote: a scenario in TOML, read, checked and typed.
//!
//! ```text
//! text ──tree──▶ Written ──check, rules──▶ Diagnostics: everything wrong, with file, line and column
//!                   └──────serde─────────▶ Scenario
//! ```
//!
//! [`Document::read`] does all of it. The types in [`scenario`] are the single source: the JSON Schema is derived from
//! them, and the check walks that schema. Their documentation is what editors show.

pub mod air;
mod air_rules;
pub mod body;
pub mod canopy;
mod check;
pub mod cover;
mod csv_table;
pub mod diagnostic;
pub mod dimension;
pub mod document;
pub mod drive;
pub mod environment;
pub mod files;
pub mod graph_files;
pub mod ground;
pub mod hold;
pub mod init;
pub mod interval;
mod later;
pub mod launch;
pub mod library;
pub mod load;
pub mod measure;
pub mod memory;
pub mod nearest;
pub mod orbit;
mod overrides;
pub mod path;
pub mod quantity;
pub mod record;
pub mod rope;
pub mod rope_law;
mod rules;
pub mod scenario;
pub mod schema;
pub mod selection;
pub mod solve;
pub mod stow;
mod text_file;
pub mod tie;
pub mod tractor;
pub mod tree;
mod unit_table;
pub mod units;
pub mod web;
pub mod wind;
pub mod written;

pub use diagnostic::{Diagnostic, Diagnostics, Location, Place, Source};
pub use document::Document;
pub use rules::is_plain;
pub use scenario::{Scenario, resolved_toml};
pub use schema::schema;

//! What came out of a run, and the folder that keeps it.
//!
//! ```text
//!  Summary   the run in a page of numbers      summary.json
//!  History   one row a record step             history.csv
//!  Fields    every node and rope, in time      fields.vtkhdf   (opens in ParaView)
//!  Landmarks what of these has a meaning       landmarks.json
//!  Manifest  who ran what, where and when      manifest.json
//! ```
//!
//! [`quantities`] is the table of all numbers of the summary: key, name, unit, which way is better, definition; and
//! [`columns`] that of the history.
//!
//! [`ResultFolder`] writes the files aside and swaps them in when they are complete, so that a reader never meets half
//! a result. While a run goes on, its history and fields are on the disk already and a [`Checkpoint`] now and then, so
//! that it can go on after a crash; [`recover`] makes what it left readable. Everything is in SI and says its unit in
//! its name. The same run gives the same bytes in every file but the manifest, which alone knows the clock and the
//! machine, and `wall_time_s` in the summary.

mod checkpoint;
mod column;
pub mod comparison;
mod disk;
mod error;
pub mod folder;
mod geometry;
mod history;
mod journal;
mod json;
mod landmarks;
mod manifest;
mod measures;
mod quantities;
mod quantity;
mod recorder;
mod recovery;
mod result_folder;
mod row;
mod running;
mod sealed;
mod series;
mod stream;
pub mod summary;
mod tally;
mod vtkhdf;
mod whole;

pub use checkpoint::{Checkpoint, CheckpointEvery};
pub use column::Column;
pub use comparison::Comparison;
pub use disk::require_room;
pub use error::ResultError;
pub use history::History;
pub use journal::read_journal;
pub use json::read as read_json;
pub use landmarks::{BodyKind, BodyMark, BodyShape, CanopyMark, Group, Landmark, Landmarks, LinkClass, NamedRope};
pub use manifest::{Machine, Manifest, hash, hash_files};
pub use measures::{Measures, OPEN_SHARE};
pub use quantities::{SECTIONS, Section, expected, leaves, quantities, quantity_at};
pub use quantity::{Better, Dimension, Quantity};
pub use recorder::{Checkpoints, Recorder};
pub use recovery::recover;
pub use result_folder::ResultFolder;
pub use row::columns;
pub use series::Series;
pub use summary::{Summary, SummaryFile};
pub use vtkhdf::{Fields, FieldsTopology, FieldsWriter, read_fields};

//! The observer that measures a run, the summary of the run, and the folder that keeps the results.
//!
//! ```text
//!  Summary   the run in a page of numbers               summary.json
//!  History   one row for each record step               history.csv
//!  Fields    every node and rope at each record step    fields.vtkhdf   (opens in ParaView)
//!  Landmarks names of nodes and segments                landmarks.json
//!  Manifest  program, inputs, machine and time          manifest.json
//! ```
//!
//! [`quantities`] lists all numbers of the summary with key, name, unit, direction of better and definition.
//! [`columns`] lists the columns of the history.
//!
//! [`ResultFolder`] writes the files into a folder aside and swaps it in when it is complete: a reader never sees half
//! a result. During a run the folder aside holds the history, the fields and the last [`Checkpoint`], from which the
//! run can go on after a crash. [`recover`] makes the files of a crashed run readable.
//!
//! All numbers are in SI, with the unit in the name. The same run gives the same bytes in every file, except for the
//! manifest, which holds the clock and the machine, and for `wall_time_s` in the summary.

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
mod visible;
mod vtkhdf;
mod whole;

pub use checkpoint::{Checkpoint, CheckpointEvery, SecondRun};
pub use column::Column;
pub use comparison::Comparison;
pub use disk::require_room;
pub use error::ResultError;
pub use history::History;
pub use journal::read_journal;
pub use json::read as read_json;
pub use landmarks::{
    BodyKind, BodyMark, BodyShape, CanopyMark, Group, Landmark, Landmarks, LinkClass, NamedRope, Support,
};
pub use manifest::{Machine, Manifest, hash, hash_files};
pub use measures::{EnergyTolerance, Measures, OPEN_SHARE};
pub use quantities::{SECTIONS, Section, expected, leaves, quantities, quantity_at};
pub use quantity::{Better, Dimension, Quantity};
pub use recorder::{Checkpoints, Recorder};
pub use recovery::recover;
pub use result_folder::ResultFolder;
pub use row::{Clash, clashes, columns};
pub use series::Series;
pub use summary::{Summary, SummaryFile};
pub use visible::visible;
pub use vtkhdf::{Fields, FieldsTopology, FieldsWriter, read_fields};

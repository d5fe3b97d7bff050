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
//! [`ResultFolder`] writes them aside and swaps them in when they are complete, so that a reader never meets half
//! a result. While a run goes on, its history and fields are on the disk already and a [`Checkpoint`] now and then, so
//! that it can go on after a crash; [`recover`] makes what it left readable. Everything is in SI and says its unit in its name. The same run gives the same bytes in every file but
//! the manifest, which alone knows the clock and the machine, and `wall_time_s` in the summary.

pub mod checkpoint;
mod cloth;
pub mod comparison;
pub mod disk;
mod error;
mod flight;
pub mod folder;
pub mod history;
pub mod journal;
pub mod landmarks;
pub mod manifest;
pub mod measures;
mod moments;
mod mouth;
pub mod recorder;
mod recovery;
mod running;
mod sealed;
mod silhouette;
mod spell;
pub mod stream;
pub mod summary;
mod tally;
mod utilisation;
pub mod vtkhdf;
mod whole;

pub use checkpoint::{Checkpoint, CheckpointEvery};
pub use comparison::Comparison;
pub use error::ResultError;
pub use folder::ResultFolder;
pub use history::History;
pub use landmarks::{BodyKind, BodyMark, BodyShape, CanopyMark, Group, Landmark, Landmarks, LinkClass, NamedRope};
pub use manifest::{Machine, Manifest};
pub use recorder::{Checkpoints, Recorder, Recording};
pub use recovery::recover;
pub use summary::Summary;
pub use vtkhdf::{Fields, FieldsTopology, FieldsWriter, read_fields};

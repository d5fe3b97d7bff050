//! What came out of a run, and the folder that keeps it.
//!
//! ```text
//!  Summary   the run in a page of numbers      summary.json
//!  History   one row a record step             history.csv
//!  Fields    every node and rope, in time      fields.vtkhdf   (opens in ParaView)
//!  Manifest  who ran what, where and when      manifest.json
//! ```
//!
//! [`ResultFolder`] writes them aside and swaps them in when they are complete, so that a reader never meets half
//! a result. Everything is in SI and says its unit in its name. The same run gives the same bytes in every file but
//! the manifest, which alone knows the clock and the machine, and `wall_time_s` in the summary.

mod error;
pub mod folder;
pub mod history;
pub mod landmarks;
pub mod manifest;
pub mod measures;
pub mod recorder;
mod spell;
pub mod summary;
pub mod vtkhdf;

pub use error::ResultError;
pub use folder::ResultFolder;
pub use history::History;
pub use landmarks::{Landmark, Landmarks, LinkClass};
pub use manifest::{Machine, Manifest};
pub use recorder::{Recorder, Recording};
pub use summary::Summary;
pub use vtkhdf::{Fields, FieldsTopology, FieldsWriter, read_fields};

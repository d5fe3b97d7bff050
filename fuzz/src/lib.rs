//! Fuzz targets: one function for each thing that netcast reads and somebody else may have written.
//!
//! A target takes any bytes. It may refuse them, with a message that says where; it may not panic, hang, or take memory
//! out of proportion. cargo-fuzz drives the functions through `fuzz_targets/`; an ordinary test,
//! `tests/regress/fuzz_corpus.rs`, replays the corpus through [`TARGETS`] on every machine.

mod input_files;
mod refusal;
mod result_files;
mod small;

pub use input_files::{graph_files, overrides, scenario, units};
pub use result_files::{checkpoint, fields, history, journal, landmarks, summary};

/// A reader under attack.
pub type Target = fn(&[u8]);

/// Every target by the name of its folder in the corpus.
pub const TARGETS: [(&str, Target); 10] = [
    ("scenario", scenario),
    ("units", units),
    ("graph_files", graph_files),
    ("overrides", overrides),
    ("history", history),
    ("summary", summary),
    ("landmarks", landmarks),
    ("fields", fields),
    ("journal", journal),
    ("checkpoint", checkpoint),
];

//! `time_offset` and `scale`, beside the file of a record: a clock that starts elsewhere, values in other units.

use crate::dimension::unit;
use crate::interval::Any;
use crate::path::Path;
use crate::per_length::read;
use crate::written::Written;

/// What is added to the times of a file, s, and what its values are multiplied by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Shift {
    pub time_offset: f64,
    pub scale: f64,
}

impl Shift {
    /// That of the file named at `file`: the keys beside it. What cannot be read, the check of the schema reports.
    pub fn beside(written: &Written, file: &Path) -> Self {
        let node = |key: &str| written.tree.get(&file.parent().key(key));
        let time_offset = node("time_offset").and_then(read::<unit::Second, Any>).unwrap_or(0.0);
        let scale = node("scale").and_then(read::<unit::One, Any>).unwrap_or(1.0);
        Self { time_offset, scale }
    }

    /// A time of the file in the run, s.
    pub fn time(&self, of_file: f64) -> f64 {
        of_file + self.time_offset
    }

    /// A vector of the file in the run.
    pub fn vector(&self, of_file: [f64; 3]) -> [f64; 3] {
        of_file.map(|value| self.scale * value)
    }
}

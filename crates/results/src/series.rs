//! History and fields of a run, kept in memory.

use std::path::Path;

use crate::stream::Stream;
use crate::{Fields, FieldsTopology, History, ResultError};

/// The contents of `history.csv` and `fields.vtkhdf`.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// One row for each record.
    pub history: History,
    /// One frame for each record.
    pub fields: Fields,
}

impl Series {
    /// Without records, with these columns and this topology.
    pub fn new(columns: Vec<String>, topology: FieldsTopology) -> Self {
        Self { history: History::new(columns), fields: Fields::new(topology) }
    }

    /// Writes `history.csv` and `fields.vtkhdf` into `folder`, with the same bytes as a run that appends to its files.
    ///
    /// # Errors
    /// [`ResultError`] names the file that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), ResultError> {
        let Self { history, fields } = self;
        let mut stream = Stream::create(folder, history.columns(), &fields.topology)?;
        history.rows().iter().try_for_each(|row| stream.row(row))?;
        for (frame, &time) in fields.times.iter().enumerate() {
            let orientations = fields.orientations(frame).iter().copied();
            let (positions, velocities) = (fields.positions(frame), fields.velocities(frame));
            stream.fields().push(time, positions, velocities, fields.tensions(frame), orientations)?;
        }
        stream.finish([])
    }
}

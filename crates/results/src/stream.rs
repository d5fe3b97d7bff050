//! History and fields of a run, appended to files while the run goes on.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use crate::journal::{JournalWriter, read_journal};
use crate::measures::KeptFrame;
use crate::tally::{Extent, Tally};
use crate::{FieldsTopology, FieldsWriter, ResultError, folder, history, read_fields, whole};

/// Time between flushes: a record waits no longer in this process, unless the next one comes later.
const FLUSH_EVERY: Duration = Duration::from_secs(1);

/// Extents of the two files of a run at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Extents {
    history: Extent,
    fields: Extent,
}

/// Appends to `history.csv` and `fields.part`.
pub struct Stream {
    folder: PathBuf,
    history: csv::Writer<Tally>,
    fields: JournalWriter,
    flushed: Instant,
}

impl Stream {
    /// Creates both files in `folder`.
    ///
    /// # Errors
    /// [`ResultError`] names the file that cannot be written.
    pub fn create(folder: &Path, columns: &[String], topology: &FieldsTopology) -> Result<Self, ResultError> {
        let path = folder.join(folder::HISTORY);
        let history = Tally::create(&path).map_err(ResultError::write(&path))?;
        let fields = JournalWriter::create(&folder.join(folder::FIELDS_PART), topology)?;
        let mut stream = Self::new(folder, history, fields);
        stream.history.write_record(columns).map_err(ResultError::csv(&path))?;
        stream.flush()?;
        Ok(stream)
    }

    /// Opens both files in `folder` and removes all bytes after the extents in `written`.
    ///
    /// # Errors
    /// [`ResultError::Changed`] names the file whose bytes up to its extent have changed.
    pub fn reopen(folder: &Path, written: Extents) -> Result<Self, ResultError> {
        let path = folder.join(folder::HISTORY);
        let changed = |path: PathBuf| move || ResultError::Changed { path };
        let history = Tally::reopen(&path, written.history).map_err(ResultError::read(&path))?;
        let history = history.ok_or_else(changed(path))?;
        let path = folder.join(folder::FIELDS_PART);
        let fields = JournalWriter::reopen(&path, written.fields)?.ok_or_else(changed(path))?;
        Ok(Self::new(folder, history, fields))
    }

    fn new(folder: &Path, history: Tally, fields: JournalWriter) -> Self {
        let history = csv::WriterBuilder::new().buffer_capacity(1 << 16).from_writer(history);
        Self { folder: folder.to_path_buf(), history, fields, flushed: Instant::now() }
    }

    /// Appends a row to the history.
    ///
    /// # Errors
    /// [`ResultError::Csv`].
    pub fn row(&mut self, row: &[Option<f64>]) -> Result<(), ResultError> {
        let written = self.history.write_record(history::cells(row));
        written.map_err(ResultError::csv(&self.folder.join(folder::HISTORY)))
    }

    /// The journal of fields.
    pub fn fields(&mut self) -> &mut JournalWriter {
        &mut self.fields
    }

    /// Flushes if a second has passed since the last flush.
    ///
    /// # Errors
    /// As [`Stream::flush`].
    pub fn keep_up(&mut self) -> Result<(), ResultError> {
        if self.flushed.elapsed() < FLUSH_EVERY { Ok(()) } else { self.flush() }
    }

    /// Passes all records to the operating system, so that they survive a crash of this process.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn flush(&mut self) -> Result<(), ResultError> {
        self.flushed = Instant::now();
        self.history.flush().map_err(ResultError::write(&self.folder.join(folder::HISTORY)))?;
        self.fields.flush()
    }

    /// Flushes, and returns once all records would survive a loss of power. Returns the extents of both files.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn sync(&mut self) -> Result<Extents, ResultError> {
        self.flush()?;
        self.history.get_ref().sync().map_err(ResultError::write(&self.folder.join(folder::HISTORY)))?;
        Ok(Extents { history: self.history.get_ref().extent(), fields: self.fields.sync()? })
    }

    /// Closes the history and makes `fields.vtkhdf` of the fields and of the frames of `moments`. `fields.part` stays
    /// until the folder is in its place: a run that is killed meanwhile can go on from it.
    ///
    /// # Errors
    /// [`ResultError`] names the file that cannot be read or written.
    pub fn finish<'f>(mut self, moments: impl IntoIterator<Item = &'f KeptFrame>) -> Result<(), ResultError> {
        self.flush()?;
        let part = self.folder.join(folder::FIELDS_PART);
        let (mut fields, _) = read_journal(&part)?;
        for frame in moments {
            fields.insert(frame);
        }
        write_fields(&self.folder, fields)
    }
}

/// Writes `fields.vtkhdf` into `folder`, completely or not at all.
fn write_fields(folder: &Path, fields: FieldsWriter) -> Result<(), ResultError> {
    whole::write(&folder.join(folder::FIELDS), |path| fields.finish(path))
}

/// Copies the history of the result in `from` to `to`, and writes its fields there as a journal, so that a run can append.
///
/// # Errors
/// [`ResultError`] names the file that cannot be read or written.
pub fn bring_back(from: &Path, to: &Path) -> Result<(), ResultError> {
    let (old, new) = (from.join(folder::HISTORY), to.join(folder::HISTORY));
    std::fs::copy(&old, &new).map_err(ResultError::read(&old))?;
    let part = from.join(folder::FIELDS_PART);
    if part.exists() {
        let new = to.join(folder::FIELDS_PART);
        return std::fs::copy(&part, &new).map(drop).map_err(ResultError::read(&part));
    }
    let fields = read_fields(&from.join(folder::FIELDS))?;
    let mut journal = JournalWriter::create(&to.join(folder::FIELDS_PART), &fields.topology)?;
    for (frame, &time) in fields.times.iter().enumerate() {
        let orientations = fields.orientations(frame).iter().copied();
        journal.push(time, fields.positions(frame), fields.velocities(frame), fields.tensions(frame), orientations)?;
    }
    journal.flush()
}

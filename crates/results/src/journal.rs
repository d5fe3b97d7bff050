//! Journal of a run's frames (`fields.part`), appended to while the run goes on.
//!
//! An HDF5 file that was not closed may not open again, so a run cannot append frames to `fields.vtkhdf`. It appends them
//! to a journal, of which every complete frame can be read at any moment. At the end of the run the journal becomes
//! `fields.vtkhdf`.
//!
//! ```text
//! magic          "netcast fields 2"
//! block          topology, by postcard
//! block, ...     one frame each: time, positions, velocities, tensions, orientations; f64, little-endian
//! ```
//!
//! Each block has its length and a checksum; see `sealed.rs`.

use std::fs::File;
use std::io::{BufReader, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

use glam::{DQuat, DVec3};

use crate::tally::{Extent, Tally};
use crate::vtkhdf::{append_quaternions, append_vectors};
use crate::{FieldsTopology, FieldsWriter, ResultError, sealed};

/// The first bytes of a journal; the number is the version of the format.
const MAGIC: &[u8; 16] = b"netcast fields 2";

/// Appends frames to a journal.
#[derive(Debug)]
pub struct JournalWriter {
    path: PathBuf,
    file: BufWriter<Tally>,
    frame: Vec<u8>,
}

impl JournalWriter {
    /// Creates a journal at `path` and writes the topology.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn create(path: &Path, topology: &FieldsTopology) -> Result<Self, ResultError> {
        let mut journal = Self::new(path, Tally::create(path).map_err(ResultError::write(path))?);
        let topology = postcard::to_stdvec(topology).expect("plain data");
        let written = journal.file.write_all(MAGIC).and_then(|()| sealed::write(&mut journal.file, &topology));
        written.map_err(ResultError::write(path))?;
        Ok(journal)
    }

    /// Opens the journal at `path` and removes all bytes after `extent`. Returns `None` if its bytes up to there are not those
    /// of `extent`.
    ///
    /// # Errors
    /// [`ResultError::Read`].
    pub fn reopen(path: &Path, extent: Extent) -> Result<Option<Self>, ResultError> {
        let file = Tally::reopen(path, extent).map_err(ResultError::read(path))?;
        Ok(file.map(|file| Self::new(path, file)))
    }

    fn new(path: &Path, file: Tally) -> Self {
        Self { path: path.to_path_buf(), file: BufWriter::new(file), frame: Vec::new() }
    }

    /// Appends a frame at `time`, s. Positions, m, and velocities, m/s: (nodes,). Tensions, N: (segments,). Orientations of
    /// rigid bodies: (bodies,). The counts are those of the topology.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn push(
        &mut self,
        time: f64,
        positions: &[DVec3],
        velocities: &[DVec3],
        tensions: &[f64],
        orientations: impl IntoIterator<Item = DQuat>,
    ) -> Result<(), ResultError> {
        self.frame.clear();
        self.frame.extend(time.to_le_bytes());
        append_vectors(&mut self.frame, positions);
        append_vectors(&mut self.frame, velocities);
        self.frame.extend(tensions.iter().flat_map(|tension| tension.to_le_bytes()));
        append_quaternions(&mut self.frame, orientations);
        sealed::write(&mut self.file, &self.frame).map_err(ResultError::write(&self.path))
    }

    /// Passes all frames to the operating system, so that they survive a crash of this process.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn flush(&mut self) -> Result<(), ResultError> {
        self.file.flush().map_err(ResultError::write(&self.path))
    }

    /// Flushes, and returns once all frames would survive a loss of power. Returns the extent of the journal.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn sync(&mut self) -> Result<Extent, ResultError> {
        self.flush()?;
        self.file.get_ref().sync().map_err(ResultError::write(&self.path))?;
        Ok(self.file.get_ref().extent())
    }
}

/// Reads the complete frames of a journal. Returns them, and the number of bytes after them that are no complete frame.
///
/// # Errors
/// [`ResultError::Read`], or [`ResultError::NotFields`] if the topology is incomplete or damaged.
pub fn read_journal(path: &Path) -> Result<(FieldsWriter, u64), ResultError> {
    let unreadable = || ResultError::read(path);
    let file = File::open(path).map_err(unreadable())?;
    let mut left = file.metadata().map_err(unreadable())?.len();
    let mut file = BufReader::new(file);
    let not_fields = |what: &str| ResultError::NotFields { path: path.to_path_buf(), what: what.to_owned() };

    let mut magic = [0; MAGIC.len()];
    if left < MAGIC.len() as u64 {
        return Err(not_fields("it was cut off before its first frame"));
    }
    file.read_exact(&mut magic).map_err(unreadable())?;
    if magic != *MAGIC {
        return Err(not_fields("it is no journal of fields, or one of another version"));
    }
    left -= MAGIC.len() as u64;

    let mut block = Vec::new();
    if !sealed::read(&mut file, left, &mut block).map_err(unreadable())? {
        return Err(not_fields("it was cut off before its first frame"));
    }
    left -= sealed::HEAD_BYTES + block.len() as u64;
    let topology: FieldsTopology =
        postcard::from_bytes(&block).map_err(|error| not_fields(&format!("its topology is damaged: {error}")))?;
    if let Some(fault) = topology.fault() {
        return Err(not_fields(&fault));
    }
    let frame_bytes = topology.frame_bytes();
    let mut fields = FieldsWriter::new(topology)?;
    while sealed::read(&mut file, left, &mut block).map_err(unreadable())? && Some(block.len()) == frame_bytes {
        fields.push_bytes(&block);
        left -= sealed::HEAD_BYTES + block.len() as u64;
    }
    Ok((fields, left))
}

//! `checkpoint`: a run as it stands, so that it can go on.
//!
//! ```text
//! magic          "netcast restart1"
//! block          which program wrote it, for which inputs, by postcard
//! block          the snapshot, the state of all measures, how far the files had come; by postcard
//! ```
//!
//! Blocks carry their length and a checksum; see `sealed.rs`. The file is replaced as a whole, after history and
//! fields have been synced: they reach at least as far as the checkpoint says.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::time::Duration;

use netcast_dynamics::snapshot::Snapshot;
use serde::{Deserialize, Serialize};

use crate::measures::Measures;
use crate::stream::Written;
use crate::{ResultError, sealed, whole};

/// The first bytes of a checkpoint; the last is the number of the format of its first block.
const MAGIC: &[u8; 16] = b"netcast restart1";

/// How often a run is checkpointed. It cannot change the results. A checkpoint falls on the next record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CheckpointEvery {
    /// Not unless the run is interrupted.
    Never,
    /// Whenever so much time has been simulated, s.
    Simulated(f64),
    /// Whenever so much time has passed on the clock.
    Clock(Duration),
}

impl Default for CheckpointEvery {
    fn default() -> Self {
        Self::Clock(Duration::from_secs(30))
    }
}

/// A run as it stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint<'a> {
    /// Time that was simulated, s.
    pub time_s: f64,
    /// Time that this took on the clock, s.
    pub wall_time_s: f64,
    /// Where the simulation stands.
    pub snapshot: Cow<'a, Snapshot>,
    /// Where the measures stand.
    pub measures: Cow<'a, Measures>,
    /// How far the files had come.
    pub written: Written,
}

/// Whose checkpoint it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Origin {
    program: String,
    input_hash: String,
}

impl Checkpoint<'_> {
    /// Time that this took on the clock; none where what was read makes no sense.
    pub fn wall_time(&self) -> Duration {
        Duration::try_from_secs_f64(self.wall_time_s).unwrap_or_default()
    }

    /// Writes the checkpoint of a run of the inputs with this hash to `path`, whole or not at all.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn write(&self, path: &Path, input_hash: &str) -> Result<(), ResultError> {
        let origin = Origin { program: program(), input_hash: input_hash.to_owned() };
        let [origin, run] = [postcard::to_stdvec(&origin), postcard::to_stdvec(self)].map(|b| b.expect("plain data"));
        whole::write(path, |path| {
            let written = File::create(path).and_then(|mut file| {
                file.write_all(MAGIC)?;
                sealed::write(&mut file, &origin)?;
                sealed::write(&mut file, &run)
            });
            written.map_err(ResultError::write(path))
        })?;
        whole::sync_folder(path.parent().unwrap_or(path));
        Ok(())
    }

    /// Reads the checkpoint at `path` with the hash of the inputs that it is for.
    ///
    /// # Errors
    /// [`ResultError::Read`], [`ResultError::NotCheckpoint`] where it is damaged, [`ResultError::OtherProgram`] where
    /// this program may compute other bits than the one that wrote it.
    pub fn read(path: &Path) -> Result<(Checkpoint<'static>, String), ResultError> {
        Self::from_bytes(&fs::read(path).map_err(ResultError::read(path))?, path)
    }

    /// Reads a checkpoint from what its file at `path` holds.
    ///
    /// # Errors
    /// As [`Checkpoint::read`].
    pub fn from_bytes(bytes: &[u8], path: &Path) -> Result<(Checkpoint<'static>, String), ResultError> {
        let damaged = || ResultError::NotCheckpoint { path: path.to_path_buf() };
        let mut rest = bytes.strip_prefix(MAGIC).ok_or_else(damaged)?;
        let origin: Origin = postcard::from_bytes(&block(&mut rest).ok_or_else(damaged)?).map_err(|_| damaged())?;
        if origin.program != program() {
            let (wrote, this) = (origin.program, program());
            return Err(ResultError::OtherProgram { path: path.to_path_buf(), wrote, this });
        }
        let run = postcard::from_bytes(&block(&mut rest).ok_or_else(damaged)?).map_err(|_| damaged())?;
        if rest.is_empty() { Ok((run, origin.input_hash)) } else { Err(damaged()) }
    }
}

/// The next block.
fn block(rest: &mut &[u8]) -> Option<Vec<u8>> {
    let mut content = Vec::new();
    let left = rest.len() as u64;
    // reading from memory does not fail
    sealed::read(rest, left, &mut content).ok().filter(|whole| *whole).map(|_| content)
}

/// This program: bits are promised for one version, built from one revision.
fn program() -> String {
    let version = concat!("netcast ", env!("CARGO_PKG_VERSION"));
    option_env!("NETCAST_REVISION").map_or(version.to_owned(), |revision| format!("{version} ({revision})"))
}

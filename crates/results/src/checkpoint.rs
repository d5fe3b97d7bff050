//! `checkpoint`: the file from which a run can go on.
//!
//! ```text
//! magic          "netcast restart1"
//! block          program that wrote it, hash of the inputs; by postcard
//! block          snapshot, state of all measures, lengths of the files; by postcard
//! ```
//!
//! Blocks have their length and a checksum; see `sealed.rs`. The file is replaced as a whole, after history and fields
//! have been synced: both are at least as long as the checkpoint says.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;
use std::time::Duration;

use netcast_dynamics::snapshot::Snapshot;
use serde::{Deserialize, Serialize};

use crate::measures::Measures;
use crate::stream::Extents;
use crate::{ResultError, sealed, whole};

/// The first bytes of a checkpoint; the last one is the version of the format of the first block.
const MAGIC: &[u8; 16] = b"netcast restart1";

/// How often a checkpoint is written. A checkpoint is written at the next record and does not change the results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CheckpointEvery {
    /// Only when the run is interrupted.
    Never,
    /// After each interval of simulated time, s.
    Simulated(f64),
    /// After each interval on the clock.
    Clock(Duration),
}

impl Default for CheckpointEvery {
    fn default() -> Self {
        Self::Clock(Duration::from_secs(30))
    }
}

/// Why a run is carried out for the second time, and how.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SecondRun {
    /// The share of the stable step that it takes.
    pub step_fraction: f64,
    /// What was wrong with the first, for the reader.
    pub why: String,
}

/// All that a run needs to go on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Checkpoint<'a> {
    /// Simulated time, s.
    pub time_s: f64,
    /// Time that the run has taken on the clock, s.
    pub wall_time_s: f64,
    /// State of the simulation.
    pub snapshot: Cow<'a, Snapshot>,
    /// State of the measures.
    pub measures: Cow<'a, Measures>,
    /// Lengths of the files.
    pub written: Extents,
    /// Set where the run is the second one of its case.
    pub second_run: Option<SecondRun>,
}

/// The program and the inputs that a checkpoint belongs to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Origin {
    program: String,
    input_hash: String,
}

impl Checkpoint<'_> {
    /// Time that the run has taken on the clock; zero if the stored number is not a duration.
    pub fn wall_time(&self) -> Duration {
        Duration::try_from_secs_f64(self.wall_time_s).unwrap_or_default()
    }

    /// Writes the checkpoint to `path`, completely or not at all. `input_hash` is the hash of the run's inputs.
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

    /// Reads the checkpoint at `path`; returns it with the hash of its inputs.
    ///
    /// # Errors
    /// [`ResultError::Read`]; [`ResultError::NotCheckpoint`] if it is damaged; [`ResultError::OtherProgram`] if another
    /// version of the program wrote it, which may compute other bits.
    pub fn read(path: &Path) -> Result<(Checkpoint<'static>, String), ResultError> {
        Self::from_bytes(&fs::read(path).map_err(ResultError::read(path))?, path)
    }

    /// Reads a checkpoint from the bytes of its file at `path`.
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

/// Content of the next block; none if it is cut short or damaged.
fn block(rest: &mut &[u8]) -> Option<Vec<u8>> {
    let mut content = Vec::new();
    let left = rest.len() as u64;
    // reading from memory does not fail
    sealed::read(rest, left, &mut content).ok().filter(|whole| *whole).map(|_| content)
}

/// Name, version and revision of this program: only the same revision is sure to compute the same bits.
fn program() -> String {
    let version = concat!("netcast ", env!("CARGO_PKG_VERSION"));
    option_env!("NETCAST_REVISION").map_or(version.to_owned(), |revision| format!("{version} ({revision})"))
}

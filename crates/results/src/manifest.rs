//! `manifest.json`: the program, the inputs, the machine and the time of a run.
//!
//! The manifest may differ between two runs of one scenario; the other files must not. netcast also recognises its own
//! result folders by the manifest.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::thread::available_parallelism;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use time::OffsetDateTime;
use time::format_description::well_known::Rfc3339;

use crate::folder::MANIFEST;
use crate::{ResultError, json};

/// The program's name, as the manifest gives it.
const PROGRAM: &str = "netcast";

/// Origin of a result. A key that an older file lacks is empty or 0.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Manifest {
    /// The program that wrote the folder: `netcast`.
    pub program: String,
    /// Version of the program.
    pub version: String,
    /// The commit from which it was built, if it was built in its repository.
    pub revision: Option<String>,
    /// SHA-256 of the files of the `inputs` folder, by [`hash_files`].
    pub input_hash: String,
    /// The machine of the run.
    pub machine: Machine,
    /// Number of threads of the run.
    pub threads: usize,
    /// Seed of the random numbers; none if the run draws none.
    pub seed: Option<u64>,
    /// Time the run took on the clock, s.
    pub wall_time_s: f64,
    /// Start of the run: UTC, RFC 3339, to the second.
    pub started: String,
}

/// The machine that computed a result.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Machine {
    /// Operating system, such as `linux`.
    pub os: String,
    /// Instruction set, such as `x86_64`.
    pub arch: String,
    /// Name of the processor, if the system tells it.
    pub cpu: Option<String>,
    /// Number of threads that can run at once.
    pub cores: Option<usize>,
}

impl Manifest {
    /// The manifest of a run on `threads` threads that starts now. The wall time is 0; the caller sets it at the end.
    pub fn new(input_hash: String, machine: Machine, threads: usize) -> Self {
        Self {
            program: PROGRAM.into(),
            version: env!("CARGO_PKG_VERSION").into(),
            revision: option_env!("NETCAST_REVISION").map(str::to_owned),
            input_hash,
            machine,
            threads,
            seed: None,
            wall_time_s: 0.0,
            started: rfc3339(OffsetDateTime::now_utc()),
        }
    }

    /// Writes the manifest to `path`.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn write(&self, path: &Path) -> Result<(), ResultError> {
        let mut text = serde_json::to_string_pretty(self).expect("plain data");
        text.push('\n');
        fs::write(path, text).map_err(ResultError::write(path))
    }

    /// Reads a manifest from `path`.
    ///
    /// # Errors
    /// [`ResultError::Read`], or [`ResultError::Json`] with line, column and key.
    pub fn read(path: &Path) -> Result<Self, ResultError> {
        json::read(path)
    }

    /// Whether `folder` has a manifest of netcast, of any version.
    pub fn marks(folder: &Path) -> bool {
        let path = folder.join(MANIFEST);
        // a named pipe would wait for a writer
        Some(path)
            .filter(|path| path.is_file())
            .and_then(|path| fs::read_to_string(path).ok())
            .and_then(|text| serde_json::from_str::<serde_json::Value>(&text).ok())
            .is_some_and(|manifest| manifest["program"] == PROGRAM)
    }
}

impl Machine {
    /// The machine on which this program runs.
    pub fn this() -> Self {
        Self {
            os: std::env::consts::OS.into(),
            arch: std::env::consts::ARCH.into(),
            cpu: cpu_name(),
            cores: available_parallelism().ok().map(usize::from),
        }
    }
}

#[cfg(target_os = "linux")]
fn cpu_name() -> Option<String> {
    let text = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    line.split_once(':').map(|(_, name)| name.trim().to_owned())
}

#[cfg(target_os = "macos")]
fn cpu_name() -> Option<String> {
    let output = std::process::Command::new("sysctl").args(["-n", "machdep.cpu.brand_string"]).output().ok()?;
    String::from_utf8(output.stdout).ok().map(|name| name.trim().to_owned()).filter(|name| !name.is_empty())
}

#[cfg(not(any(target_os = "linux", target_os = "macos")))]
fn cpu_name() -> Option<String> {
    std::env::var("PROCESSOR_IDENTIFIER").ok()
}

/// A moment as `2026-11-22T01:33:00Z`.
fn rfc3339(moment: OffsetDateTime) -> String {
    let to_the_second = moment.replace_nanosecond(0).expect("zero is a nanosecond");
    to_the_second.format(&Rfc3339).expect("a clock between the years 0 and 9999")
}

/// SHA-256 over the names and contents of files, in the order of the names, as hexadecimal; see [`hash`].
pub fn hash_files(files: &BTreeMap<String, Vec<u8>>) -> String {
    hash(files.iter().flat_map(|(name, content)| [name.as_bytes(), content]))
}

/// SHA-256 over some parts, as hexadecimal. Each part enters with its length, so that lists with other boundaries have
/// other hashes.
pub fn hash<P: AsRef<[u8]>>(parts: impl IntoIterator<Item = P>) -> String {
    let mut hash = Sha256::new();
    for part in parts {
        hash.update((part.as_ref().len() as u64).to_le_bytes());
        hash.update(part);
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_written_in_utc_to_the_second() {
        // 1 700 000 000 s after the epoch, a published date
        let moment = OffsetDateTime::from_unix_timestamp_nanos(1_700_000_000_987_654_321).unwrap();
        assert_eq!(rfc3339(moment), "2023-11-14T22:13:20Z");
    }

    #[test]
    fn a_manifest_reads_back_equal_and_marks_its_folder() {
        let folder = tempfile::tempdir().unwrap();
        assert!(!Manifest::marks(folder.path()));
        let manifest = Manifest::new("0f".into(), Machine::this(), 2);
        manifest.write(&folder.path().join(MANIFEST)).unwrap();
        assert_eq!(Manifest::read(&folder.path().join(MANIFEST)).unwrap(), manifest);
        assert!(Manifest::marks(folder.path()));
    }

    #[test]
    fn the_revision_is_the_hash_of_a_commit() {
        if let Some(revision) = option_env!("NETCAST_REVISION") {
            assert!(revision.len() >= 40 && revision.bytes().all(|byte| byte.is_ascii_hexdigit()), "{revision}");
        }
    }

    #[test]
    fn inputs_are_hashed_by_content_and_name() {
        let hash = |files: &[(&str, &str)]| {
            hash_files(&files.iter().map(|(name, content)| (name.to_string(), content.as_bytes().to_vec())).collect())
        };
        let written = hash(&[("scenario.toml", "a"), ("nodes.csv", "b")]);
        assert_eq!(written.len(), 64);
        assert_ne!(written, hash(&[("scenario.toml", "b"), ("nodes.csv", "a")]));
        assert_ne!(written, hash(&[("scenario.toml", "a"), ("ropes.csv", "b")]));
        // the published SHA-256 of no bytes
        assert_eq!(hash(&[]), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }

    #[test]
    fn a_hash_depends_on_the_parts_and_their_order() {
        assert_ne!(hash(["a", "b"]), hash(["b", "a"]));
        assert_ne!(hash(["ab", "c"]), hash(["a", "bc"]));
    }
}

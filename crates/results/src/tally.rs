//! A file that is appended to, with its length and checksum so far.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

use crc32fast::Hasher;
use serde::{Deserialize, Serialize};

/// Length and CRC-32 of the beginning of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Extent {
    /// Length, bytes.
    pub bytes: u64,
    crc: u32,
}

/// A file with the length and the CRC-32 of all bytes written to it.
#[derive(Debug)]
pub struct Tally {
    file: File,
    bytes: u64,
    hasher: Hasher,
}

impl Tally {
    /// A new file at `path`, which replaces an older one.
    pub fn create(path: &Path) -> io::Result<Tally> {
        Ok(Tally { file: File::create(path)?, bytes: 0, hasher: Hasher::new() })
    }

    /// The file at `path`, cut to the length of `extent`. None, and the file unchanged, if it is shorter or the checksum
    /// of its beginning differs.
    pub fn reopen(path: &Path, extent: Extent) -> io::Result<Option<Tally>> {
        let mut file = OpenOptions::new().read(true).write(true).open(path)?;
        let mut hasher = Hasher::new();
        let (mut left, mut buffer) = (extent.bytes, vec![0; 1 << 16]);
        while left > 0 {
            let size = left.min(buffer.len() as u64) as usize;
            match file.read(&mut buffer[..size])? {
                0 => return Ok(None),
                read => {
                    hasher.update(&buffer[..read]);
                    left -= read as u64;
                }
            }
        }
        if hasher.clone().finalize() != extent.crc {
            return Ok(None);
        }
        file.set_len(extent.bytes)?;
        file.seek(SeekFrom::Start(extent.bytes))?;
        Ok(Some(Tally { file, bytes: extent.bytes, hasher }))
    }

    /// Length and checksum of the file so far.
    pub fn extent(&self) -> Extent {
        Extent { bytes: self.bytes, crc: self.hasher.clone().finalize() }
    }

    /// Waits until all written bytes would survive a loss of power.
    pub fn sync(&self) -> io::Result<()> {
        self.file.sync_data()
    }
}

impl Write for Tally {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.hasher.update(&bytes[..written]);
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_reopened_only_if_its_beginning_is_unchanged() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("file");
        let mut file = Tally::create(&path).unwrap();
        file.write_all(b"first ").unwrap();
        let extent = file.extent();
        file.write_all(b"lost").unwrap();

        let mut again = Tally::reopen(&path, extent).unwrap().unwrap();
        again.write_all(b"second").unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), b"first second");
        assert_eq!(again.extent().bytes, 12);
        assert!(Tally::reopen(&path, again.extent()).unwrap().is_some());

        std::fs::write(&path, b"fir").unwrap();
        assert!(Tally::reopen(&path, extent).unwrap().is_none());
        std::fs::write(&path, b"fIrst second").unwrap();
        assert!(Tally::reopen(&path, extent).unwrap().is_none());
        assert_eq!(std::fs::read(&path).unwrap(), b"fIrst second", "a refused file stays unchanged");
    }
}

//! A file that is appended to, and what it has come to.

use std::fs::{File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

use crc32fast::Hasher;
use serde::{Deserialize, Serialize};

/// The beginning of a file: its length in bytes and their CRC-32.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Extent {
    /// Length, bytes.
    pub bytes: u64,
    crc: u32,
}

/// A file that counts and sums what is written to it.
#[derive(Debug)]
pub struct Tally {
    file: File,
    bytes: u64,
    hasher: Hasher,
}

impl Tally {
    /// A new file at `path`, in the place of one that may be there.
    pub fn create(path: &Path) -> io::Result<Tally> {
        Ok(Tally { file: File::create(path)?, bytes: 0, hasher: Hasher::new() })
    }

    /// The file at `path` as it was when it had come to `extent`; what follows is cut off. None where it does not begin
    /// so.
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

    /// What the file has come to.
    pub fn extent(&self) -> Extent {
        Extent { bytes: self.bytes, crc: self.hasher.clone().finalize() }
    }

    /// Returns when what was written outlasts a loss of power.
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
    fn a_file_goes_on_from_where_it_was_and_only_if_it_still_begins_so() {
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
        assert_eq!(std::fs::read(&path).unwrap(), b"fIrst second", "what is refused is left as it is");
    }
}

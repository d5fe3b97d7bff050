//! Finds the files that a scenario names, in a folder or among texts in memory.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::text_file::read_text;

/// Finds the files that a scenario names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FileSource {
    /// The folder that relative paths start from.
    folder: PathBuf,
    /// Texts of files in memory, by their path in the scenario.
    given: BTreeMap<PathBuf, String>,
}

impl FileSource {
    /// Finds files in `folder`.
    pub fn in_folder(folder: &Path) -> Self {
        Self { folder: folder.to_path_buf(), given: BTreeMap::new() }
    }

    /// Adds a text in memory for the file `name`. It replaces a file on disk.
    pub fn give(&mut self, name: impl Into<PathBuf>, text: String) {
        self.given.insert(name.into(), text);
    }

    /// The path of a file for messages.
    pub fn path(&self, name: &Path) -> PathBuf {
        if self.given.contains_key(name) { name.to_path_buf() } else { self.folder.join(name) }
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// Where it is not in memory and cannot be read from disk.
    pub fn bytes(&self, name: &Path) -> io::Result<Vec<u8>> {
        match self.given.get(name) {
            Some(text) => Ok(text.clone().into_bytes()),
            None => fs::read(self.path(name)),
        }
    }

    /// The text of a file. A file on disk can have at most `most` bytes.
    ///
    /// # Errors
    /// The reason why it cannot be read, in words.
    pub(crate) fn text(&self, name: &Path, most: f64) -> Result<String, String> {
        match self.given.get(name) {
            Some(text) => Ok(text.clone()),
            None => read_text(&self.path(name), most),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_in_memory_replaces_the_file_on_disk() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("nodes.csv"), "on the disk").unwrap();
        let mut files = FileSource::in_folder(folder.path());
        let read = |files: &FileSource| files.text("nodes.csv".as_ref(), 100.0).unwrap();
        assert_eq!(read(&files), "on the disk");
        files.give("nodes.csv", "given".to_owned());
        assert_eq!(read(&files), "given");
        assert_eq!(files.bytes("nodes.csv".as_ref()).unwrap(), b"given");
        assert_eq!(files.path("nodes.csv".as_ref()), Path::new("nodes.csv"));
        assert!(files.bytes("ropes.csv".as_ref()).is_err());
    }
}

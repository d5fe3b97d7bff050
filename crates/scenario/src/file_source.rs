//! Where the files that a scenario names are found: in a folder, or given by value.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

use crate::text_file::read_text;

/// Where the files that a scenario names are found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FileSource {
    /// The folder that relative paths start from.
    folder: PathBuf,
    /// The texts of files that are given by value, by the path that the scenario names.
    given: BTreeMap<PathBuf, String>,
}

impl FileSource {
    /// Those in `folder`.
    pub fn in_folder(folder: &Path) -> Self {
        Self { folder: folder.to_path_buf(), given: BTreeMap::new() }
    }

    /// Gives the text of the file that the scenario names `name`, in place of one on the disk.
    pub fn give(&mut self, name: impl Into<PathBuf>, text: String) {
        self.given.insert(name.into(), text);
    }

    /// The path of a file, as messages name it.
    pub fn path(&self, name: &Path) -> PathBuf {
        if self.given.contains_key(name) { name.to_path_buf() } else { self.folder.join(name) }
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// Where it is not given and cannot be read.
    pub fn bytes(&self, name: &Path) -> io::Result<Vec<u8>> {
        match self.given.get(name) {
            Some(text) => Ok(text.clone().into_bytes()),
            None => fs::read(self.path(name)),
        }
    }

    /// The text of a file; one on the disk may have `most` bytes.
    ///
    /// # Errors
    /// Why it cannot be read, in words.
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
    fn a_file_given_by_value_stands_for_the_one_on_the_disk() {
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

//! Reading a text file that somebody named: it may be a folder, another kind of file, or never end.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::memory::in_words;

/// The text of `file`, which may have `most` bytes.
///
/// # Errors
/// Why it cannot be read, in words.
pub(crate) fn read_text(file: &Path, most: f64) -> Result<String, String> {
    let opened = File::open(file).map_err(|error| error.to_string())?;
    let size = opened.metadata().map_or(0, |metadata| metadata.len());
    let mut bytes = Vec::new();
    if size as f64 <= most {
        // a pipe or a device does not say how much it holds
        opened.take(most as u64 + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    }
    if size.max(bytes.len() as u64) as f64 > most {
        return Err(format!("it has more than {}", in_words(most)));
    }
    String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_large_is_refused_whether_it_says_its_size_or_not() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("text");
        std::fs::write(&file, "12345678").unwrap();
        assert_eq!(read_text(&file, 8.0).unwrap(), "12345678");
        assert_eq!(read_text(&file, 7.0).unwrap_err(), "it has more than 1 MB");
    }

    /// It was read until the system killed the program.
    #[test]
    #[cfg(unix)]
    fn a_device_that_never_ends_is_refused() {
        assert_eq!(read_text(Path::new("/dev/zero"), 1e6).unwrap_err(), "it has more than 1 MB");
    }
}

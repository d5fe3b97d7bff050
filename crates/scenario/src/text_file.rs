//! Reads a text file that a user names. It refuses folders, named pipes, devices that never end, and files of another kind.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::memory::in_words;

/// The text of `file`, which can have at most `most` bytes.
///
/// # Errors
/// The reason why it cannot be read, in words.
pub(crate) fn read_text(file: &Path, most: f64) -> Result<String, String> {
    if is_named_pipe(file) {
        return Err("it is a named pipe, which may keep the program waiting for ever".to_owned());
    }
    let opened = File::open(file).map_err(|error| error.to_string())?;
    let size = opened.metadata().map_or(0, |metadata| metadata.len());
    let mut bytes = Vec::new();
    if size as f64 <= most {
        // the size of a pipe or a device is unknown before reading
        opened.take(most as u64 + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    }
    if size.max(bytes.len() as u64) as f64 > most {
        return Err(format!("it has more than {}", in_words(most)));
    }
    String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_string())
}

/// Whether `file` is a pipe in a folder: opening it waits for a writer. Standard input, a pipe too, is open already.
#[cfg(unix)]
fn is_named_pipe(file: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    let is_open = ["/dev", "/proc"].iter().any(|system| file.starts_with(system));
    !is_open && std::fs::metadata(file).is_ok_and(|metadata| metadata.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_named_pipe(_: &Path) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_too_large_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("text");
        std::fs::write(&file, "12345678").unwrap();
        assert_eq!(read_text(&file, 8.0).unwrap(), "12345678");
        assert_eq!(read_text(&file, 7.0).unwrap_err(), "it has more than 1 MB");
    }

    /// Such a device was once read until the system killed the program.
    #[test]
    #[cfg(unix)]
    fn a_device_that_never_ends_is_refused() {
        assert_eq!(read_text(Path::new("/dev/zero"), 1e6).unwrap_err(), "it has more than 1 MB");
    }

    /// Whoever opened it waited for ever, deaf to signals.
    #[test]
    #[cfg(unix)]
    fn a_pipe_that_nobody_writes_to_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        assert!(read_text(&pipe, 1e6).unwrap_err().starts_with("it is a named pipe"));
    }
}

//! Free space on the disk, checked before a run: a run that fills the disk loses the last of its results.

use std::path::Path;

use crate::ResultError;

/// Requires that the disk of `target` has room for another `bytes` bytes.
///
/// # Errors
/// [`ResultError::DiskTooSmall`]; none where the system does not tell the free space.
pub fn require_room(target: &Path, bytes: f64) -> Result<(), ResultError> {
    match available(target) {
        Some(available) if available < bytes => {
            Err(ResultError::DiskTooSmall { path: target.to_path_buf(), needed: bytes, available })
        }
        _ => Ok(()),
    }
}

/// Bytes that this user can still write at `path`; the last parts of the path need not exist yet.
fn available(path: &Path) -> Option<f64> {
    let path = std::path::absolute(path).ok()?;
    let existing = path.ancestors().find(|ancestor| ancestor.exists())?;
    room(existing)
}

#[cfg(unix)]
fn room(path: &Path) -> Option<f64> {
    let disk = rustix::fs::statvfs(path).ok()?;
    // a file system without a disk, such as /proc, has zero blocks
    (disk.f_blocks > 0).then_some(disk.f_bavail as f64 * disk.f_frsize as f64)
}

#[cfg(not(unix))]
fn room(_: &Path) -> Option<f64> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(unix)]
    fn a_byte_fits_and_1e24_bytes_do_not() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("not/there/yet");
        assert!(require_room(&target, 1.0).is_ok());
        assert!(
            matches!(require_room(&target, 1e24), Err(ResultError::DiskTooSmall { available, .. }) if available > 0.0)
        );
    }
}

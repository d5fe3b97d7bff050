//! How much room a disk has. A run that fills it loses what it computes last.

use std::path::Path;

use crate::ResultError;

/// Refuses to write `bytes` to `target` where its disk has less room than that.
///
/// # Errors
/// [`ResultError::DiskTooSmall`]. Where the room cannot be told, there is none.
pub fn require_room(target: &Path, bytes: f64) -> Result<(), ResultError> {
    match available(target) {
        Some(available) if available < bytes => {
            Err(ResultError::DiskTooSmall { path: target.to_path_buf(), needed: bytes, available })
        }
        _ => Ok(()),
    }
}

/// Bytes that this user can still write beside `path`, whose last parts may not exist yet.
fn available(path: &Path) -> Option<f64> {
    let path = std::path::absolute(path).ok()?;
    let existing = path.ancestors().find(|ancestor| ancestor.exists())?;
    room(existing)
}

#[cfg(unix)]
fn room(path: &Path) -> Option<f64> {
    let disk = rustix::fs::statvfs(path).ok()?;
    // what is no disk, such as /proc, has no blocks at all
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
    fn no_disk_holds_everything() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("not/there/yet");
        assert!(require_room(&target, 1.0).is_ok());
        assert!(
            matches!(require_room(&target, 1e24), Err(ResultError::DiskTooSmall { available, .. }) if available > 0.0)
        );
    }
}

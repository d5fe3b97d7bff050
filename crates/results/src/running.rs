//! `<target>.running`: the folder in which a run writes, locked against other runs.
//!
//! The operating system holds the lock and frees it when the process ends, also by a crash. A folder without a lock
//! was therefore left by a run that died.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

use crate::folder::{LOCK, OURS, require_files};
use crate::{ResultError, whole};

/// The lock on the folder of a run, held until it is dropped.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Removes the lock file, so that the folder can be published.
    pub fn release(self) -> Result<(), ResultError> {
        drop(self.file);
        fs::remove_file(&self.path).map_err(ResultError::write(&self.path))
    }
}

/// The folder in which a run with this target writes.
pub fn beside(target: &Path) -> PathBuf {
    let mut name = OsString::from(target.file_name().unwrap_or_default());
    name.push(".running");
    target.with_file_name(name)
}

/// Locks the folder beside `target`, and makes it and its parents if they are missing. Files in the folder stay.
pub fn claim(target: &Path) -> Result<(PathBuf, Lock), ResultError> {
    let aside = beside(target);
    let unwritable = |source| ResultError::TargetUnwritable { path: target.to_path_buf(), source };
    fs::create_dir_all(target.parent().unwrap_or(Path::new("/"))).map_err(unwritable)?;
    loop {
        match fs::create_dir(&aside) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => require_ours(&aside)?,
            made => made.map_err(unwritable)?,
        }
        let path = aside.join(LOCK);
        let mut file = match OpenOptions::new().create(true).truncate(false).write(true).open(&path) {
            // another run has published the folder meanwhile
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            opened => opened.map_err(unwritable)?,
        };
        if is_held(&file).map_err(unwritable)? {
            return Err(ResultError::InUse { path: aside });
        }
        // the lock is ours; the folder may have been published between its creation and the lock
        if path.exists() {
            // the process id helps a user to find the run; a failure here shows at the next write
            let _ = file.set_len(0).and_then(|()| writeln!(file, "process {}", process::id()));
            return Ok((aside, Lock { path, file }));
        }
    }
}

/// Whether a run holds the lock on `folder`.
pub fn is_busy(folder: &Path) -> Result<bool, ResultError> {
    let path = folder.join(LOCK);
    match OpenOptions::new().write(true).open(&path) {
        Ok(file) => is_held(&file).map_err(ResultError::read(&path)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(source) => Err(ResultError::Read { path, source }),
    }
}

/// Takes the lock if it is free, and returns whether another process has it. Without locks in the file system it is free.
fn is_held(file: &File) -> io::Result<bool> {
    match file.try_lock() {
        Ok(()) => Ok(false),
        Err(TryLockError::WouldBlock) => Ok(true),
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => Ok(false),
        Err(TryLockError::Error(error)) => Err(error),
    }
}

/// Removes all files of a locked folder but the lock.
pub fn clear(folder: &Path) -> Result<(), ResultError> {
    for entry in fs::read_dir(folder).map_err(ResultError::read(folder))? {
        let path = entry.map_err(ResultError::read(folder))?.path();
        if path.file_name().is_some_and(|name| name != LOCK) {
            remove(&path)?;
        }
    }
    Ok(())
}

/// Removes the named files and folders that exist in a locked folder.
pub fn forget(folder: &Path, names: &[&str]) -> Result<(), ResultError> {
    names.iter().map(|name| folder.join(name)).filter(|path| path.exists()).try_for_each(|path| remove(&path))
}

fn remove(path: &Path) -> Result<(), ResultError> {
    let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    removed.map_err(ResultError::write(path))
}

/// Refuses a folder that holds a file or folder which no run writes.
fn require_ours(folder: &Path) -> Result<(), ResultError> {
    let path = || folder.to_path_buf();
    if !folder.is_dir() {
        return Err(ResultError::TargetIsFile { path: path() });
    }
    for entry in fs::read_dir(folder).map_err(ResultError::read(folder))? {
        let name = entry.map_err(ResultError::read(folder))?.file_name();
        let name = name.to_string_lossy();
        if !OURS.contains(&name.trim_end_matches(whole::UNFINISHED)) {
            return Err(ResultError::TargetNotOurs { path: path() });
        }
    }
    require_files(folder, false)
}

//! `<target>.running`: where a run writes, in sight of the user, locked against other runs.
//!
//! The lock is the operating system's and ends with the process, however that ends: what is not locked was left by a
//! run that died.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;

use crate::folder::{LOCK, OURS};
use crate::{ResultError, whole};

/// The lock on the folder of a run, held as long as this lives.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Takes the lock file away, so that the folder can be published.
    pub fn release(self) -> Result<(), ResultError> {
        drop(self.file);
        fs::remove_file(&self.path).map_err(ResultError::write(&self.path))
    }
}

/// The folder where a run with this target writes.
pub fn beside(target: &Path) -> PathBuf {
    let mut name = OsString::from(target.file_name().unwrap_or_default());
    name.push(".running");
    target.with_file_name(name)
}

/// Locks the folder beside `target`, made where it is missing with its parents. What a run left in it stays.
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
            // its run was published meanwhile
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            opened => opened.map_err(unwritable)?,
        };
        if is_held(&file).map_err(unwritable)? {
            return Err(ResultError::InUse { path: aside });
        }
        // nobody else takes this folder from here on, unless it was published since it was looked for
        if path.exists() {
            // for who wonders whose it is; where it cannot be written, what follows says so
            let _ = file.set_len(0).and_then(|()| writeln!(file, "process {}", process::id()));
            return Ok((aside, Lock { path, file }));
        }
    }
}

/// Whether a run is at work in `folder`.
pub fn is_busy(folder: &Path) -> Result<bool, ResultError> {
    let path = folder.join(LOCK);
    match OpenOptions::new().write(true).open(&path) {
        Ok(file) => is_held(&file).map_err(ResultError::read(&path)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(false),
        Err(source) => Err(ResultError::Read { path, source }),
    }
}

/// Takes the lock, or says that somebody has it. Where the file system knows no locks, nobody has.
fn is_held(file: &File) -> io::Result<bool> {
    match file.try_lock() {
        Ok(()) => Ok(false),
        Err(TryLockError::WouldBlock) => Ok(true),
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => Ok(false),
        Err(TryLockError::Error(error)) => Err(error),
    }
}

/// Empties a locked folder.
pub fn clear(folder: &Path) -> Result<(), ResultError> {
    for entry in fs::read_dir(folder).map_err(ResultError::read(folder))? {
        let path = entry.map_err(ResultError::read(folder))?.path();
        if path.file_name().is_some_and(|name| name != LOCK) {
            remove(&path)?;
        }
    }
    Ok(())
}

/// Removes some of the files and folders of a locked folder, where they are there.
pub fn forget(folder: &Path, names: &[&str]) -> Result<(), ResultError> {
    names.iter().map(|name| folder.join(name)).filter(|path| path.exists()).try_for_each(|path| remove(&path))
}

fn remove(path: &Path) -> Result<(), ResultError> {
    let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    removed.map_err(ResultError::write(path))
}

/// Refuses a folder that holds anything but what a run leaves.
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
    Ok(())
}

//! The result folder, written beside its target and moved into place when it is complete.
//!
//! A command writes into a folder beside its target, and [`ResultFolder::publish`] puts that folder in the target's place.
//! So a reader sees the old result or the new one, never a mixture. A run that failed publishes what it computed in the
//! same way, with `finished: false` in its summary. A command of seconds writes into a hidden folder, which is removed if
//! the command fails. A run writes into a visible one, `<target>.running`, which survives a crash so that the run can be
//! resumed (`running.rs`).
//!
//! A target that netcast wrote, which its manifest shows, is replaced as a whole. Any other folder that is not empty is
//! refused.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{env, fs, io, process};

use crate::folder::{CHECKPOINT, FIELDS, FIELDS_PART, OURS, PICTURES, REPORT, SUMMARY, require_files};
use crate::running::{self, Lock};
use crate::{Manifest, ResultError, stream, whole};

/// A result folder that is not published yet. If it is dropped before [`publish`](Self::publish) it is removed, unless
/// [`keep`](Self::keep) was called.
#[derive(Debug)]
pub struct ResultFolder {
    target: PathBuf,
    aside: PathBuf,
    /// The lock of a run's folder; `None` for any other.
    lock: Option<Lock>,
    kept: bool,
    /// Whether its run can go on.
    goes_on: bool,
}

impl ResultFolder {
    /// Creates a hidden folder beside `target`, and the missing parents of `target`.
    ///
    /// # Errors
    /// [`ResultError::TargetIsFile`], [`ResultError::TargetNotOurs`] or [`ResultError::TargetHoldsCurrent`] if `target` must
    /// not be replaced; nothing is written then. [`ResultError::TargetUnwritable`] if the folder cannot be created.
    pub fn create(target: &Path) -> Result<Self, ResultError> {
        let target = resolve(target)?;
        require_replaceable(&target)?;
        let parent = target.parent().unwrap_or(Path::new("/"));
        remove_abandoned(parent, &target);
        let aside = unused_beside(&target, "new");
        let made = fs::create_dir_all(parent).and_then(|()| fs::create_dir(&aside));
        made.map_err(|source| ResultError::TargetUnwritable { path: target.clone(), source })?;
        Ok(Self { target, aside, lock: None, kept: false, goes_on: false })
    }

    /// Creates `<target>.running`, or takes it over from a run that died before its first checkpoint.
    ///
    /// # Errors
    /// Those of [`create`](Self::create). [`ResultError::InUse`] if another run writes there, [`ResultError::LeftBehind`] if
    /// an earlier run left a checkpoint there.
    pub fn running(target: &Path) -> Result<Self, ResultError> {
        let target = resolve(target)?;
        require_replaceable(&target)?;
        let (aside, lock) = running::claim(&target)?;
        if aside.join(CHECKPOINT).exists() {
            return Err(ResultError::LeftBehind { path: aside });
        }
        running::clear(&aside)?;
        Ok(Self { target, aside, lock: Some(lock), kept: false, goes_on: false })
    }

    /// Creates the folder of a run that resumes an earlier run with this target. It contains the checkpoint of the earlier
    /// run, unless that died before its first. `agrees` gets the folder of the earlier run and checks that it is the same
    /// run; it is called before anything changes.
    ///
    /// # Errors
    /// Those of [`running`](Self::running) and of `agrees`, and [`ResultError::NothingToResume`]. The folder of the earlier
    /// run does not change then.
    pub fn resuming<E: From<ResultError>>(target: &Path, agrees: impl Fn(&Path) -> Result<(), E>) -> Result<Self, E> {
        let target = resolve(target)?;
        require_replaceable(&target)?;
        let aside = running::beside(&target);
        let left = [&aside, &target].into_iter().find(|path| path.join(CHECKPOINT).exists()).cloned();
        let existed = aside.exists();
        if left.is_none() && !existed {
            let what = if target.exists() {
                "holds no checkpoint: its run came to its end, or failed for good"
            } else {
                "does not exist"
            };
            return Err(ResultError::NothingToResume { path: target, what }.into());
        }
        require_files(&target, false)?;
        let (aside, lock) = running::claim(&target)?;
        let mut folder = Self { target, aside, lock: Some(lock), kept: existed, goes_on: false };
        let Some(left) = left else {
            running::clear(&folder.aside)?;
            folder.kept = false;
            return Ok(folder);
        };
        agrees(&left)?;
        if left == folder.aside {
            // files that were made from it to inspect the run are no part of the resumed run
            running::forget(&folder.aside, &[SUMMARY, FIELDS, REPORT, PICTURES])?;
        } else {
            running::clear(&folder.aside)?;
            folder.kept = false;
            stream::bring_back(&left, &folder.aside)?;
            let (from, to) = (left.join(CHECKPOINT), folder.aside.join(CHECKPOINT));
            fs::copy(&from, &to).map_err(ResultError::write(&to))?;
        }
        Ok(folder)
    }

    /// Keeps the folder when it is dropped: its contents took time to compute.
    pub fn keep(&mut self) {
        self.kept = true;
    }

    /// From now on the folder keeps its checkpoint when it is published: its run can go on.
    pub fn goes_on(&mut self) {
        self.goes_on = true;
    }

    /// Removes the checkpoint, where there is one: what follows does not continue the run so far.
    ///
    /// # Errors
    /// [`ResultError::Write`].
    pub fn forget_checkpoint(&self) -> Result<(), ResultError> {
        running::forget(&self.aside, &[CHECKPOINT])
    }

    /// The folder to write into until it is published.
    pub fn path(&self) -> &Path {
        &self.aside
    }

    /// The path of the folder after it is published.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Moves the folder to its target, and returns the path of that.
    ///
    /// # Errors
    /// Those of [`create`](Self::create), since the target may have changed meanwhile. The old result then stays, and the
    /// new one is removed unless [`keep`](Self::keep) was called.
    pub fn publish(mut self) -> Result<PathBuf, ResultError> {
        require_replaceable(&self.target)?;
        if let Some(lock) = self.lock.take() {
            lock.release()?;
        }
        whole::sync_all(&self.aside)?;
        let target = self.swap_in()?;
        // only now: a run that is killed before goes on from here
        running::forget(&target, if self.goes_on { &[FIELDS_PART] } else { &[CHECKPOINT, FIELDS_PART] })?;
        whole::sync_folder(target.parent().unwrap_or(&target));
        Ok(target)
    }

    fn swap_in(&self) -> Result<PathBuf, ResultError> {
        if !self.target.exists() {
            fs::rename(&self.aside, &self.target).map_err(ResultError::write(&self.target))?;
            return Ok(self.target.clone());
        }
        if exchange(&self.aside, &self.target) {
            // the old result now stands aside; without its checkpoint nobody resumes a run from there
            keep_foreign(&self.aside, &self.target)?;
            running::forget(&self.aside, &[CHECKPOINT])?;
            fs::remove_dir_all(&self.aside).map_err(ResultError::write(&self.aside))?;
            return Ok(self.target.clone());
        }
        let old = unused_beside(&self.target, "old");
        fs::rename(&self.target, &old).map_err(ResultError::write(&self.target))?;
        if let Err(source) = fs::rename(&self.aside, &self.target) {
            // move the old result back; if that fails too, it is still complete beside its place
            let _ = fs::rename(&old, &self.target);
            return Err(ResultError::Write { path: self.target.clone(), source });
        }
        keep_foreign(&old, &self.target)?;
        fs::remove_dir_all(&old).map_err(ResultError::write(&old))?;
        Ok(self.target.clone())
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        // after publishing there is nothing to remove; a destructor cannot report a failure
        if !self.kept {
            let _ = fs::remove_dir_all(&self.aside);
        }
    }
}

/// Exchanges two folders in one step, so that after a kill each place still has a complete folder. Returns false if the
/// file system cannot.
#[cfg(target_os = "linux")]
fn exchange(one: &Path, other: &Path) -> bool {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE).is_ok()
}

#[cfg(not(target_os = "linux"))]
fn exchange(_: &Path, _: &Path) -> bool {
    false
}

/// The absolute path of `target`; links are followed if it exists.
fn resolve(target: &Path) -> Result<PathBuf, ResultError> {
    match fs::canonicalize(target) {
        Ok(path) => Ok(path),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            std::path::absolute(target).map_err(|source| ResultError::TargetUnwritable { path: target.into(), source })
        }
        Err(source) => Err(ResultError::TargetUnwritable { path: target.into(), source }),
    }
}

/// Checks that `target` does not exist, is an empty folder, or is a result of netcast.
fn require_replaceable(target: &Path) -> Result<(), ResultError> {
    let path = || target.to_path_buf();
    match fs::metadata(target) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(source) => return Err(ResultError::Write { path: path(), source }),
        Ok(metadata) if !metadata.is_dir() => return Err(ResultError::TargetIsFile { path: path() }),
        Ok(_) => {}
    }
    let current = env::current_dir().and_then(fs::canonicalize);
    if current.is_ok_and(|current| current.starts_with(target)) {
        return Err(ResultError::TargetHoldsCurrent { path: path() });
    }
    let empty = fs::read_dir(target).map_err(ResultError::read(target))?.next().is_none();
    if !empty && !Manifest::marks(target) {
        return Err(ResultError::TargetNotOurs { path: path() });
    }
    Ok(())
}

/// An unused hidden name beside `target`, thus on the same file system, so that a rename can move the folder to `target`.
fn unused_beside(target: &Path, role: &str) -> PathBuf {
    let candidate = |attempt: u32| {
        let mut name = OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{role}-{}-{attempt}", process::id()));
        target.with_file_name(name)
    };
    (0..).map(candidate).find(|path| !path.exists()).expect("names do not run out")
}

/// Removes the hidden folders beside `target` of commands that were killed: no process has the number in their name. Where
/// that cannot be known they stay.
fn remove_abandoned(parent: &Path, target: &Path) {
    let processes = Path::new("/proc");
    let Some(own) = target.file_name().and_then(|name| name.to_str()).filter(|_| processes.join("self").exists())
    else {
        return;
    };
    let Ok(beside) = fs::read_dir(parent) else { return };
    for entry in beside.flatten() {
        let name = entry.file_name();
        let id = name.to_str().and_then(|name| {
            let (id, attempt) = name.strip_prefix(&format!(".{own}.new-"))?.split_once('-')?;
            attempt.parse::<u32>().ok()?;
            id.parse::<u32>().ok()
        });
        let is_ours = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if id.is_some_and(|id| is_ours && !processes.join(id.to_string()).exists()) {
            // one that cannot be removed harms nobody
            let _ = fs::remove_dir_all(entry.path());
        }
    }
}

/// Moves files that netcast did not write, such as notes of a user, from the old result to the new one, also in the
/// folders of a comparison's designs.
fn keep_foreign(old: &Path, new: &Path) -> Result<(), ResultError> {
    let designs = designs_in(old);
    for entry in fs::read_dir(old).map_err(ResultError::read(old))? {
        let entry = entry.map_err(ResultError::read(old))?;
        let name = entry.file_name();
        let to = new.join(&name);
        if OURS.iter().any(|ours| name == *ours) {
            continue;
        } else if designs.iter().any(|design| name == **design) {
            keep_foreign(&entry.path(), &to)?;
        } else {
            // the folder of a design that is no longer compared remains, for the notes in it
            fs::create_dir_all(new).map_err(ResultError::write(new))?;
            fs::rename(entry.path(), &to).map_err(ResultError::write(&to))?;
        }
    }
    Ok(())
}

/// The folders of the designs of a comparison in `folder`; empty for the result of a run.
fn designs_in(folder: &Path) -> Vec<String> {
    let summary = fs::read_to_string(folder.join(SUMMARY)).ok();
    let summary: Option<serde_json::Value> = summary.and_then(|text| serde_json::from_str(&text).ok());
    let designs = summary.as_ref().and_then(|summary| summary["designs"].as_array());
    designs.into_iter().flatten().filter_map(|design| Some(design["folder"].as_str()?.to_owned())).collect()
}

#[cfg(test)]
mod tests;

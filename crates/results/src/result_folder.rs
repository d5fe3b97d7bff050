//! The result folder: written aside, swapped in when complete.
//!
//! A run writes into a folder beside its target; [`ResultFolder::publish`] puts that in the target's place. So a reader
//! sees the old result or the new one, never a mixture. A run that failed publishes what it computed in the same way,
//! with `finished: false` in its summary. What takes seconds is written into a hidden folder of which nothing is left
//! if it does not come to its end; a run is written into a visible one, `<target>.running`, that outlasts a crash and
//! from which the run can go on (`running.rs`).
//!
//! A folder that netcast wrote (its manifest says so) is replaced as a whole; one that holds anything else is refused.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::{env, fs, io, process};

use crate::folder::{CHECKPOINT, FIELDS, FIELDS_PART, OURS, PICTURES, REPORT, SUMMARY};
use crate::running::{self, Lock};
use crate::{Manifest, ResultError, stream, whole};

/// A result folder in the making. Dropped before [`publish`](Self::publish), it leaves nothing behind, unless it was
/// said to [`keep`](Self::keep) what it has.
#[derive(Debug)]
pub struct ResultFolder {
    target: PathBuf,
    aside: PathBuf,
    /// Held where the folder is that of a run.
    lock: Option<Lock>,
    kept: bool,
    /// Whether its run can go on.
    goes_on: bool,
}

impl ResultFolder {
    /// Makes the folder to write into, beside `target`, whose parents are created where they are missing.
    ///
    /// # Errors
    /// [`ResultError::TargetIsFile`], [`ResultError::TargetNotOurs`] or [`ResultError::TargetHoldsCurrent`] where
    /// `target` must not be replaced, with nothing written; [`ResultError::TargetUnwritable`] where it cannot be made.
    pub fn create(target: &Path) -> Result<Self, ResultError> {
        let target = resolve(target)?;
        require_replaceable(&target)?;
        let parent = target.parent().unwrap_or(Path::new("/"));
        let aside = unused_beside(&target, "new");
        let made = fs::create_dir_all(parent).and_then(|()| fs::create_dir(&aside));
        made.map_err(|source| ResultError::TargetUnwritable { path: target.clone(), source })?;
        Ok(Self { target, aside, lock: None, kept: false, goes_on: false })
    }

    /// Makes `<target>.running`, or takes it over from a run that died before its first checkpoint.
    ///
    /// # Errors
    /// Those of [`create`](Self::create), with nothing written; [`ResultError::InUse`] where another run is at work
    /// there, [`ResultError::LeftBehind`] where one left a checkpoint there.
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

    /// Makes the folder of a run that goes on from where an earlier one with this target stopped or died, with its
    /// checkpoint in it; without one where it died before its first. `agrees` is asked first whether the run is the
    /// same, with the folder that it left.
    ///
    /// # Errors
    /// Those of [`running`](Self::running) and of `agrees`, [`ResultError::NothingToResume`]; what the earlier run left
    /// is then as it was.
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
        let (aside, lock) = running::claim(&target)?;
        let mut folder = Self { target, aside, lock: Some(lock), kept: existed, goes_on: false };
        let Some(left) = left else {
            running::clear(&folder.aside)?;
            folder.kept = false;
            return Ok(folder);
        };
        agrees(&left)?;
        if left == folder.aside {
            // what was made of it since to be looked at is not of the run that goes on
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

    /// From now on the folder stays where it is when it is dropped, whatever happens: what is in it took time.
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

    /// Where to write until the folder is published.
    pub fn path(&self) -> &Path {
        &self.aside
    }

    /// Where the folder will stand once published.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Puts the folder in its target's place and returns that.
    ///
    /// # Errors
    /// Those of [`create`](Self::create), since the target may have changed meanwhile. The old result then still stands
    /// and the new one is removed, unless it was to be kept.
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
            // the old result now stands aside; a run of its own that did not end is not to be gone on with from there
            keep_foreign(&self.aside, &self.target)?;
            running::forget(&self.aside, &[CHECKPOINT])?;
            fs::remove_dir_all(&self.aside).map_err(ResultError::write(&self.aside))?;
            return Ok(self.target.clone());
        }
        let old = unused_beside(&self.target, "old");
        fs::rename(&self.target, &old).map_err(ResultError::write(&self.target))?;
        if let Err(source) = fs::rename(&self.aside, &self.target) {
            // the old result goes back; should that fail too, it is still whole, beside its place
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
        // after publishing there is nothing here; a destructor has nobody to tell of a failure
        if !self.kept {
            let _ = fs::remove_dir_all(&self.aside);
        }
    }
}

/// Lets two folders change places in one step, so that a kill finds one of them in either place; false where the file
/// system cannot.
#[cfg(target_os = "linux")]
fn exchange(one: &Path, other: &Path) -> bool {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE).is_ok()
}

#[cfg(not(target_os = "linux"))]
fn exchange(_: &Path, _: &Path) -> bool {
    false
}

/// The absolute path that `target` stands for, links followed as far as it exists.
fn resolve(target: &Path) -> Result<PathBuf, ResultError> {
    match fs::canonicalize(target) {
        Ok(path) => Ok(path),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            std::path::absolute(target).map_err(|source| ResultError::TargetUnwritable { path: target.into(), source })
        }
        Err(source) => Err(ResultError::TargetUnwritable { path: target.into(), source }),
    }
}

/// Refuses a target that is not free, empty, or a result of ours.
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

/// A hidden name beside `target`, on the same file system so that a rename swaps it in, that nothing bears yet.
fn unused_beside(target: &Path, role: &str) -> PathBuf {
    let candidate = |attempt: u32| {
        let mut name = OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{role}-{}-{attempt}", process::id()));
        target.with_file_name(name)
    };
    (0..).map(candidate).find(|path| !path.exists()).expect("names do not run out")
}

/// Moves what is not netcast's own from the old result to the new one: notes that a user left there stay, in the
/// folders of a comparison's designs too.
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
            // where a design is not compared any more, its folder remains for the notes in it
            fs::create_dir_all(new).map_err(ResultError::write(new))?;
            fs::rename(entry.path(), &to).map_err(ResultError::write(&to))?;
        }
    }
    Ok(())
}

/// The folders of the designs that a comparison in `folder` holds; none in the result of a run.
fn designs_in(folder: &Path) -> Vec<String> {
    let summary = fs::read_to_string(folder.join(SUMMARY)).ok();
    let summary: Option<serde_json::Value> = summary.and_then(|text| serde_json::from_str(&text).ok());
    let designs = summary.as_ref().and_then(|summary| summary["designs"].as_array());
    designs.into_iter().flatten().filter_map(|design| Some(design["folder"].as_str()?.to_owned())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Machine;
    use crate::folder::{HISTORY, MANIFEST};

    fn sign(folder: &Path) {
        let manifest = Manifest::new(String::new(), Machine::this(), 1);
        manifest.write(&folder.join(MANIFEST)).unwrap();
    }

    fn publish(target: &Path, text: &str) -> Result<PathBuf, ResultError> {
        let folder = ResultFolder::create(target)?;
        fs::write(folder.path().join("summary.json"), text).unwrap();
        sign(folder.path());
        folder.publish()
    }

    fn names_in(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> =
            fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn a_result_is_made_with_its_parents_and_replaced_as_a_whole() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("results/deep/net");
        publish(&target, "first").unwrap();
        fs::write(target.join("report.html"), "of the first").unwrap();
        publish(&target, "second").unwrap();
        assert_eq!(names_in(&target), ["manifest.json", "summary.json"]);
        assert_eq!(fs::read_to_string(target.join("summary.json")).unwrap(), "second");
        assert_eq!(names_in(target.parent().unwrap()), ["net"], "nothing is left beside the result");
    }

    #[test]
    fn nothing_shows_before_it_is_complete_and_nothing_is_left_of_an_abandoned_run() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("net");
        publish(&target, "first").unwrap();
        let folder = ResultFolder::create(&target).unwrap();
        fs::write(folder.path().join("summary.json"), "half of the second").unwrap();
        assert_eq!(fs::read_to_string(target.join("summary.json")).unwrap(), "first");
        drop(folder);
        assert_eq!(fs::read_to_string(target.join("summary.json")).unwrap(), "first");
        assert_eq!(names_in(root.path()), ["net"]);
    }

    #[test]
    fn a_comparison_replaces_the_folders_of_its_designs_and_keeps_the_notes_in_them() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("comparison");
        let compare = |designs: &[&str]| {
            let folder = ResultFolder::create(&target).unwrap();
            let listed: Vec<_> = designs.iter().map(|name| serde_json::json!({"folder": name})).collect();
            fs::write(folder.path().join(SUMMARY), serde_json::json!({"designs": listed}).to_string()).unwrap();
            for design in designs {
                fs::create_dir(folder.path().join(design)).unwrap();
                fs::write(folder.path().join(design).join(HISTORY), "").unwrap();
            }
            sign(folder.path());
            folder.publish().unwrap();
        };
        compare(&["ring", "square"]);
        fs::write(target.join("ring").join("notes.md"), "").unwrap();
        fs::create_dir(target.join("photographs")).unwrap();
        compare(&["ring", "star"]);
        assert_eq!(names_in(&target), ["manifest.json", "photographs", "ring", "star", "summary.json"]);
        assert_eq!(names_in(&target.join("ring")), ["history.csv", "notes.md"]);
        // what is left of a design that is compared no more is what the user wrote
        compare(&["square", "star"]);
        assert_eq!(names_in(&target.join("ring")), ["notes.md"]);
    }

    #[test]
    fn an_empty_folder_is_taken() {
        let root = tempfile::tempdir().unwrap();
        publish(&root.path().join("net"), "first").unwrap();
        let target = root.path().join("empty");
        fs::create_dir(&target).unwrap();
        publish(&target, "first").unwrap();
        assert!(target.join("summary.json").is_file());
    }

    #[test]
    fn what_is_not_ours_is_refused_and_kept() {
        let root = tempfile::tempdir().unwrap();
        let thesis = root.path().join("thesis");
        fs::create_dir(&thesis).unwrap();
        fs::write(thesis.join("chapter.tex"), "years of work").unwrap();
        assert!(matches!(publish(&thesis, "new"), Err(ResultError::TargetNotOurs { .. })));

        // a manifest of some other program is not ours either
        fs::write(thesis.join(MANIFEST), r#"{"name": "something else"}"#).unwrap();
        assert!(matches!(publish(&thesis, "new"), Err(ResultError::TargetNotOurs { .. })));
        assert_eq!(names_in(&thesis), ["chapter.tex", "manifest.json"]);

        let file = thesis.join("chapter.tex");
        assert!(matches!(publish(&file, "new"), Err(ResultError::TargetIsFile { .. })));
        assert_eq!(names_in(root.path()), ["thesis"]);
    }

    #[test]
    fn a_parent_that_is_a_file_is_an_error_that_names_it() {
        let root = tempfile::tempdir().unwrap();
        let file = root.path().join("file");
        fs::write(&file, "").unwrap();
        let error = publish(&file.join("net"), "new").unwrap_err();
        assert!(error.to_string().contains("file"), "{error}");
    }

    #[test]
    fn the_current_folder_is_not_swapped_away() {
        for target in [Path::new("."), Path::new("..")] {
            assert!(matches!(ResultFolder::create(target), Err(ResultError::TargetHoldsCurrent { .. })));
        }
    }

    #[test]
    fn a_run_is_in_sight_and_keeps_others_out_until_it_is_published() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("net");
        let folder = ResultFolder::running(&target).unwrap();
        assert_eq!(names_in(root.path()), ["net.running"]);
        assert!(matches!(ResultFolder::running(&target), Err(ResultError::InUse { .. })));
        assert!(running::is_busy(folder.path()).unwrap());
        fs::write(folder.path().join("summary.json"), "").unwrap();
        folder.publish().unwrap();
        assert_eq!(names_in(root.path()), ["net"]);
        assert_eq!(names_in(&target), ["summary.json"]);
    }

    #[test]
    fn a_run_that_did_not_begin_leaves_nothing_and_one_that_did_leaves_all() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("net");
        drop(ResultFolder::running(&target).unwrap());
        assert_eq!(names_in(root.path()), [""; 0]);

        let mut folder = ResultFolder::running(&target).unwrap();
        folder.keep();
        fs::write(folder.path().join("history.csv"), "").unwrap();
        drop(folder);
        assert_eq!(names_in(&running::beside(&target)), ["history.csv", "lock"]);
        // nobody is at work there any more, and there is nothing to go on from
        drop(ResultFolder::running(&target).unwrap());
        assert_eq!(names_in(root.path()), [""; 0]);
    }

    #[test]
    fn what_took_time_to_compute_is_not_thrown_away_by_the_next_run() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("net");
        let mut folder = ResultFolder::running(&target).unwrap();
        folder.keep();
        fs::write(folder.path().join(CHECKPOINT), "").unwrap();
        drop(folder);
        assert!(matches!(ResultFolder::running(&target), Err(ResultError::LeftBehind { .. })));
        assert_eq!(names_in(&running::beside(&target)), ["checkpoint", "lock"]);
    }

    #[test]
    fn a_folder_of_that_name_which_is_not_ours_is_refused_and_kept() {
        let root = tempfile::tempdir().unwrap();
        let target = root.path().join("net");
        fs::create_dir(running::beside(&target)).unwrap();
        fs::write(running::beside(&target).join("chapter.tex"), "years of work").unwrap();
        assert!(matches!(ResultFolder::running(&target), Err(ResultError::TargetNotOurs { .. })));
        assert_eq!(names_in(&running::beside(&target)), ["chapter.tex"]);
    }

    #[test]
    fn there_is_nothing_to_resume_where_nothing_was_run() {
        let root = tempfile::tempdir().unwrap();
        let resumed = ResultFolder::resuming::<ResultError>(&root.path().join("net"), |_| Ok(()));
        assert!(matches!(resumed, Err(ResultError::NothingToResume { .. })));
        assert_eq!(names_in(root.path()), [""; 0]);
    }
}

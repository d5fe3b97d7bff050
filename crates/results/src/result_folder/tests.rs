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
fn the_old_result_stays_until_the_new_one_is_complete_and_an_abandoned_one_is_removed() {
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
#[cfg(target_os = "linux")]
fn the_hidden_folder_of_a_command_that_was_killed_is_removed_by_the_next() {
    let root = tempfile::tempdir().unwrap();
    let target = root.path().join("net");
    let mut gone = process::Command::new("true").spawn().unwrap();
    gone.wait().unwrap();
    // those of a process that is gone, of one that lives, and a folder of the user
    let [left, busy] = [gone.id(), process::id()].map(|id| root.path().join(format!(".net.new-{id}-7")));
    let notes = root.path().join(".net.new-ideas");
    for folder in [&left, &busy, &notes] {
        fs::create_dir(folder).unwrap();
    }
    drop(ResultFolder::create(&target).unwrap());
    assert_eq!([left.exists(), busy.exists(), notes.exists()], [false, true, true]);
}

/// A pipe as history once kept the command waiting for ever; a link was written through.
#[test]
#[cfg(unix)]
fn links_and_pipes_under_names_of_ours_are_refused() {
    let root = tempfile::tempdir().unwrap();
    let aside = running::beside(&root.path().join("net"));
    for name in OURS {
        fs::create_dir_all(&aside).unwrap();
        let victim = root.path().join("victim");
        fs::write(&victim, "mine").unwrap();
        std::os::unix::fs::symlink(&victim, aside.join(name)).unwrap();
        let refused = ResultFolder::running(&root.path().join("net")).unwrap_err();
        assert!(matches!(refused, ResultError::NotAFile { .. }), "{name}: {refused}");
        assert_eq!(fs::read_to_string(&victim).unwrap(), "mine");
        fs::remove_dir_all(&aside).unwrap();
    }
    let target = root.path().join("done");
    publish(&target, "{}").unwrap();
    assert!(process::Command::new("mkfifo").arg(target.join(HISTORY)).status().unwrap().success());
    assert!(matches!(crate::recover(&target), Err(ResultError::NotAFile { .. })));
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
fn an_empty_folder_is_accepted_as_target() {
    let root = tempfile::tempdir().unwrap();
    publish(&root.path().join("net"), "first").unwrap();
    let target = root.path().join("empty");
    fs::create_dir(&target).unwrap();
    publish(&target, "first").unwrap();
    assert!(target.join("summary.json").is_file());
}

#[test]
fn a_target_that_netcast_did_not_write_is_refused_and_stays() {
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
fn if_the_parent_is_a_file_the_error_names_it() {
    let root = tempfile::tempdir().unwrap();
    let file = root.path().join("file");
    fs::write(&file, "").unwrap();
    let error = publish(&file.join("net"), "new").unwrap_err();
    assert!(error.to_string().contains("file"), "{error}");
}

#[test]
fn the_current_folder_and_its_parents_are_refused_as_target() {
    for target in [Path::new("."), Path::new("..")] {
        assert!(matches!(ResultFolder::create(target), Err(ResultError::TargetHoldsCurrent { .. })));
    }
}

#[test]
fn the_folder_of_a_run_is_visible_and_locked_until_it_is_published() {
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
fn the_folder_of_a_run_is_removed_unless_it_was_to_be_kept() {
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
fn a_new_run_refuses_to_replace_a_checkpoint() {
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
fn a_running_folder_that_netcast_did_not_write_is_refused_and_stays() {
    let root = tempfile::tempdir().unwrap();
    let target = root.path().join("net");
    fs::create_dir(running::beside(&target)).unwrap();
    fs::write(running::beside(&target).join("chapter.tex"), "years of work").unwrap();
    assert!(matches!(ResultFolder::running(&target), Err(ResultError::TargetNotOurs { .. })));
    assert_eq!(names_in(&running::beside(&target)), ["chapter.tex"]);
}

#[test]
fn resuming_without_an_earlier_run_is_an_error_and_leaves_nothing() {
    let root = tempfile::tempdir().unwrap();
    let resumed = ResultFolder::resuming::<ResultError>(&root.path().join("net"), |_| Ok(()));
    assert!(matches!(resumed, Err(ResultError::NothingToResume { .. })));
    assert_eq!(names_in(root.path()), [""; 0]);
}

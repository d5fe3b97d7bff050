//! Sets `NETCAST_REVISION` to the commit from which the crate is built, if it is built in its repository.
//!
//! It reads the files of git directly: the build needs neither the git program nor a repository.

use std::fs;
use std::path::{Path, PathBuf};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if let Some(revision) = git_folder().and_then(|git| head(&git)) {
        println!("cargo:rustc-env=NETCAST_REVISION={revision}");
    }
}

/// The git folder of the repository. In a linked worktree `.git` is a file with the path of that folder.
fn git_folder() -> Option<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let git = root.join(".git");
    if git.is_dir() {
        return Some(git);
    }
    let pointer = fs::read_to_string(git).ok()?;
    Some(root.join(pointer.strip_prefix("gitdir:")?.trim()))
}

/// The commit of `HEAD`.
fn head(git: &Path) -> Option<String> {
    let head = read(&git.join("HEAD"))?;
    // a commit on the branch leaves HEAD unchanged, but git appends it to this log: read it to rebuild
    read(&git.join("logs/HEAD"));
    let Some(branch) = head.strip_prefix("ref: ") else { return Some(head) };
    // a linked worktree keeps its branches in the folder of its repository
    let common = match fs::read_to_string(git.join("commondir")) {
        Ok(path) => git.join(path.trim()),
        Err(_) => git.to_path_buf(),
    };
    read(&common.join(branch)).or_else(|| packed(&common, branch))
}

/// The commit of a branch in the file of packed references.
fn packed(git: &Path, branch: &str) -> Option<String> {
    let list = read(&git.join("packed-refs"))?;
    let line = list.lines().find(|line| line.split_once(' ').is_some_and(|(_, name)| name == branch))?;
    line.split_once(' ').map(|(commit, _)| commit.to_owned())
}

/// Text of a file; cargo builds again when the file changes.
fn read(path: &Path) -> Option<String> {
    let text = fs::read_to_string(path).ok()?;
    println!("cargo:rerun-if-changed={}", path.display());
    Some(text.trim().to_owned())
}

//! Tells the crate the commit it is built from as `NETCAST_REVISION`, where it is built in its repository.
//!
//! The files of git are read directly: neither git itself nor a repository is needed to build.

use std::fs;
use std::path::{Path, PathBuf};

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if let Some(revision) = git_folder().and_then(|git| head(&git)) {
        println!("cargo:rustc-env=NETCAST_REVISION={revision}");
    }
}

/// The repository's `.git`; in a linked worktree that is a file which says where the folder is.
fn git_folder() -> Option<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let git = root.join(".git");
    if git.is_dir() {
        return Some(git);
    }
    let pointer = fs::read_to_string(git).ok()?;
    Some(root.join(pointer.strip_prefix("gitdir:")?.trim()))
}

/// The commit that `HEAD` stands for.
fn head(git: &Path) -> Option<String> {
    let head = read(&git.join("HEAD"))?;
    // every commit and checkout is logged here, also one that leaves HEAD on its branch
    read(&git.join("logs/HEAD"));
    let Some(branch) = head.strip_prefix("ref: ") else { return Some(head) };
    // the branches of a worktree are kept with the repository it belongs to
    let common = match fs::read_to_string(git.join("commondir")) {
        Ok(path) => git.join(path.trim()),
        Err(_) => git.to_path_buf(),
    };
    read(&common.join(branch)).or_else(|| packed(&common, branch))
}

/// The commit of a branch that git has packed away.
fn packed(git: &Path, branch: &str) -> Option<String> {
    let list = read(&git.join("packed-refs"))?;
    let line = list.lines().find(|line| line.split_once(' ').is_some_and(|(_, name)| name == branch))?;
    line.split_once(' ').map(|(commit, _)| commit.to_owned())
}

/// A file's text; a change to the file builds again.
fn read(path: &Path) -> Option<String> {
    let text = fs::read_to_string(path).ok()?;
    println!("cargo:rerun-if-changed={}", path.display());
    Some(text.trim().to_owned())
}

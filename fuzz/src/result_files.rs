//! What a result folder holds, read back: it may be of another version, cut short, or damaged.

use std::path::PathBuf;

use netcast_results::{Checkpoint, History, Landmarks, ResultError, Summary, folder, read_fields, read_journal};
use tempfile::TempDir;

use crate::refusal::check_result_error;

/// A history.csv. What is read has one cell a column.
pub fn history(bytes: &[u8]) {
    let path = written(folder::HISTORY, bytes);
    match History::read(&path) {
        Err(refused) => check_result_error(&refused, &path),
        Ok(history) => assert!(history.rows().iter().all(|row| row.len() == history.columns().len())),
    }
}

/// A summary.json. What is read and can be written reads back equal; what lacks numbers is read, and not written.
pub fn summary(bytes: &[u8]) {
    let path = written(folder::SUMMARY, bytes);
    match Summary::read(&path) {
        Err(refused) => check_result_error(&refused, &path),
        Ok(summary) => match summary.write(&path) {
            Ok(()) => assert_eq!(Summary::read(&path).expect("what was written"), summary),
            Err(refused) => assert!(matches!(refused, ResultError::NotFinite { .. }), "{refused}"),
        },
    }
}

/// A landmarks.json. What is read is written and reads back equal.
pub fn landmarks(bytes: &[u8]) {
    let path = written(folder::LANDMARKS, bytes);
    match Landmarks::read(&path) {
        Err(refused) => check_result_error(&refused, &path),
        Ok(landmarks) => {
            landmarks.write(&path).expect("a temporary file");
            assert_eq!(Landmarks::read(&path).expect("what was written"), landmarks);
        }
    }
}

/// A fields.vtkhdf. Of what is read, every step is there, and every number of a node or class is that of one.
pub fn fields(bytes: &[u8]) {
    let path = written(folder::FIELDS, bytes);
    let fields = match read_fields(&path) {
        Err(refused) => return check_result_error(&refused, &path),
        Ok(fields) => fields,
    };
    let topology = &fields.topology;
    for step in 0..fields.times.len() {
        assert_eq!(fields.positions(step).len(), topology.nodes);
        assert_eq!(fields.velocities(step).len(), topology.nodes);
        assert_eq!(fields.tensions(step).len(), topology.segments.len());
    }
    let nodes = topology.segments.iter().flatten().chain(topology.labels.iter().map(|(node, _)| node));
    assert!(nodes.copied().all(|node| (node as usize) < topology.nodes), "a node that is not there");
    assert!(topology.classes.iter().all(|&class| (class as usize) < topology.class_names.len()), "an unknown class");
}

thread_local! {
    static FOLDER: TempDir = TempDir::new().expect("a temporary folder");
}

/// A fields.part. What is read is written as fields, and no more is lost than there was.
pub fn journal(bytes: &[u8]) {
    let path = written(folder::FIELDS_PART, bytes);
    match read_journal(&path) {
        Err(refused) => check_result_error(&refused, &path),
        Ok((fields, lost)) => {
            assert!(lost < bytes.len() as u64);
            fields.finish(&path.with_file_name(folder::FIELDS)).expect("a temporary file");
        }
    }
}

/// A checkpoint: read or refused.
pub fn checkpoint(bytes: &[u8]) {
    let path = PathBuf::from(folder::CHECKPOINT);
    if let Err(refused) = Checkpoint::from_bytes(bytes, &path) {
        check_result_error(&refused, &path);
    }
}

/// A file of this name and content, in a folder of this thread.
fn written(name: &str, bytes: &[u8]) -> PathBuf {
    let path = FOLDER.with(|folder| folder.path().join(name));
    // some file systems flush what is written over a file that was there
    let _ = std::fs::remove_file(&path);
    std::fs::write(&path, bytes).expect("a temporary file");
    path
}

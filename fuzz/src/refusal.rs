//! What a refusal owes the user: a message, and the place in the text that it is about.

use std::path::Path;

use netcast_results::ResultError;
use netcast_scenario::{Diagnostics, Place};

/// Holds every diagnostic to having a message and a place that exists.
///
/// # Panics
/// Where one does not.
pub fn check_diagnostics(diagnostics: &Diagnostics) {
    assert!(!diagnostics.0.is_empty(), "a refusal without a reason");
    for diagnostic in &diagnostics.0 {
        assert!(!diagnostic.message.is_empty(), "no message: {diagnostic:?}");
        match diagnostic.place.as_ref().expect("what was read has places") {
            Place::File { source, span } => {
                let marked = source.text.get(span.clone());
                assert!(marked.is_some(), "{span:?} of {} bytes: {}", source.text.len(), diagnostic.message);
                let at = diagnostic.location().expect("it stands in a file");
                assert!(at.line >= 1 && at.line <= source.text.matches('\n').count() + 1 && at.column >= 1);
            }
            Place::Override(text) => assert!(diagnostic.to_string().contains(text.as_str())),
        }
    }
}

/// Holds an error of a result file to naming the file.
///
/// # Panics
/// Where it does not.
pub fn check_result_error(error: &ResultError, path: &Path) {
    let message = error.to_string();
    let name = path.file_name().expect("a file has a name").to_string_lossy();
    assert!(message.contains(&*name), "which file? {message}");
}

//! Reads and checks a scenario, together with the files that it names.

use std::path::Path as FilePath;

use crate::check;
use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::file_source::FileSource;
use crate::files::Files;
use crate::library::{self, FromLibrary};
use crate::path::Path;
use crate::per_length;
use crate::rules;
use crate::scenario::Scenario;
use crate::text_file::read_text;
use crate::written::Written;

/// The largest size, bytes, of a file that is read as a scenario. A larger file is of another kind or a device.
const MOST_BYTES: f64 = 64e6;

/// A scenario that was read and checked.
#[derive(Clone, Debug)]
pub struct Document {
    /// The keys as written, with the values that the library of materials adds.
    pub written: Written,
    /// The values that the library of materials adds.
    pub library: FromLibrary,
    /// The typed scenario, with every default filled in.
    pub scenario: Scenario,
    /// The contents of the files that it names.
    pub files: Files,
}

impl Document {
    /// Reads the scenario in `file` and the files that it names. An override is `path=value`, as after `--set`.
    ///
    /// # Errors
    /// All faults of the scenario and its files at once.
    pub fn read(file: &FilePath, overrides: &[String]) -> Result<Self, Diagnostics> {
        let unreadable =
            |reason: String| Diagnostic::new("", format!("cannot read {}: {reason}", file.display()), None);
        let text = read_text(file, MOST_BYTES).map_err(unreadable)?;
        let source = Source { name: file.display().to_string(), text };
        Self::parse(source, file.parent().unwrap_or(FilePath::new("")), overrides)
    }

    /// Reads a scenario from its text. The files that it names are in `folder`.
    ///
    /// # Errors
    /// All faults of the scenario and its files at once.
    pub fn parse(source: Source, folder: &FilePath, overrides: &[String]) -> Result<Self, Diagnostics> {
        Self::parse_with(source, FileSource::in_folder(folder), overrides)
    }

    /// Reads a scenario from its text. The files that it names are found by `files`.
    ///
    /// # Errors
    /// All faults of the scenario and its files at once.
    pub fn parse_with(source: Source, files: FileSource, overrides: &[String]) -> Result<Self, Diagnostics> {
        let (mut written, mut found) = match Written::parse(source, files, overrides) {
            Ok(parsed) => parsed,
            Err(faults) => return Err(Diagnostics::fail_if_any(faults).unwrap_err()),
        };
        found.extend(check::check(&written));
        per_length::over_section(&mut written.tree);
        let library = library::fill(&mut written.tree);
        found.extend(rules::check(&written));
        let files = Files::read(&written, &mut found);
        Diagnostics::fail_if_any(found)?;
        let mut scenario: Scenario = serde_path_to_error::deserialize(written.tree.root.value.to_toml())
            .map_err(|error| written.at_value(&Path::parse(&error.path().to_string()), error.inner().message()))?;
        scenario.complete();
        Ok(Self { written, library, scenario, files })
    }

    /// A diagnostic of a later stage about the value at `path`, such as `web.space.side`. It points to that value, or
    /// to the nearest parent in the file.
    pub fn diagnostic(&self, path: &str, message: impl Into<String>) -> Diagnostic {
        self.written.at_value(&self.written.tree.resolve(&Path::parse(path)), message)
    }
}

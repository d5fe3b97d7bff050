//! A scenario that was read and checked, with the files it names and the text it came from.

use std::path::Path as FilePath;

use crate::check;
use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::file_source::FileSource;
use crate::files::Files;
use crate::library::{self, FromLibrary};
use crate::path::Path;
use crate::rules;
use crate::scenario::Scenario;
use crate::text_file::read_text;
use crate::written::Written;

/// The largest file that is read as a scenario: larger ones are results, or never end.
const MOST_BYTES: f64 = 64e6;

/// A scenario that was read and checked.
#[derive(Clone, Debug)]
pub struct Document {
    /// As it was written, with what the library of materials adds.
    pub written: Written,
    /// What the library of materials adds.
    pub library: FromLibrary,
    /// As it is meant, with every default filled in.
    pub scenario: Scenario,
    /// What stands in the files that it names.
    pub files: Files,
}

impl Document {
    /// Reads the scenario in `file` and the files it names. Each override is `path=value`, as after `--set`.
    ///
    /// # Errors
    /// Everything that is wrong with them, at once.
    pub fn read(file: &FilePath, overrides: &[String]) -> Result<Self, Diagnostics> {
        let unreadable =
            |reason: String| Diagnostic::new("", format!("cannot read {}: {reason}", file.display()), None);
        let text = read_text(file, MOST_BYTES).map_err(unreadable)?;
        let source = Source { name: file.display().to_string(), text };
        Self::parse(source, file.parent().unwrap_or(FilePath::new("")), overrides)
    }

    /// Reads a scenario from its text; the files it names are looked for in `folder`.
    ///
    /// # Errors
    /// Everything that is wrong with them, at once.
    pub fn parse(source: Source, folder: &FilePath, overrides: &[String]) -> Result<Self, Diagnostics> {
        Self::parse_with(source, FileSource::in_folder(folder), overrides)
    }

    /// Reads a scenario from its text; the files it names are those of `files`.
    ///
    /// # Errors
    /// Everything that is wrong with them, at once.
    pub fn parse_with(source: Source, files: FileSource, overrides: &[String]) -> Result<Self, Diagnostics> {
        let (mut written, mut found) = match Written::parse(source, files, overrides) {
            Ok(parsed) => parsed,
            Err(faults) => return Err(Diagnostics::fail_if_any(faults).unwrap_err()),
        };
        found.extend(check::check(&written));
        let library = library::fill(&mut written.tree);
        found.extend(rules::check(&written));
        let files = Files::read(&written, &mut found);
        Diagnostics::fail_if_any(found)?;
        let mut scenario: Scenario = serde_path_to_error::deserialize(written.tree.root.value.to_toml())
            .map_err(|error| written.at_value(&Path::parse(&error.path().to_string()), error.inner().message()))?;
        scenario.complete();
        Ok(Self { written, library, scenario, files })
    }

    /// Something a later stage finds wrong with what stands at `path`, such as `web.space.side`. It is shown there, or
    /// at the nearest parent that was written.
    pub fn diagnostic(&self, path: &str, message: impl Into<String>) -> Diagnostic {
        self.written.at_value(&self.written.tree.resolve(&Path::parse(path)), message)
    }
}

//! A scenario as a tree of keys and values, before it is typed; diagnostics take their places from it.

use std::fmt::Display;
use std::sync::Arc;

use crate::diagnostic::{Diagnostic, Place, Source};
use crate::file_source::FileSource;
use crate::path::Path;
use crate::tree::{Origin, Tree, TreeFault};

/// A scenario as it was written.
#[derive(Clone, Debug)]
pub struct Written {
    /// Its file.
    pub source: Arc<Source>,
    /// Where the files that it names are.
    pub files: FileSource,
    /// The overrides, such as `launch.axial_speed=60 m/s`.
    pub overrides: Vec<String>,
    /// Its keys and values, with the overrides.
    pub tree: Tree,
}

impl Written {
    /// Reads the text of `source` as TOML and puts the overrides in. The second value is the faults of the overrides.
    ///
    /// # Errors
    /// All faults of a text that is not TOML.
    pub(crate) fn parse(
        source: Source,
        files: FileSource,
        overrides: &[String],
    ) -> Result<(Self, Vec<Diagnostic>), Vec<Diagnostic>> {
        let source = Arc::new(source);
        let report =
            |fault: TreeFault| Diagnostic::new("", fault.message, Some(place(&source, overrides, &fault.origin)));
        let mut tree =
            Tree::parse(&source.text).map_err(|faults| faults.into_iter().map(report).collect::<Vec<_>>())?;
        let faults = overrides.iter().enumerate().filter_map(|(index, text)| tree.set(text, index).err()).map(report);
        let found = faults.collect();
        Ok((Self { source, files, overrides: overrides.to_vec(), tree }, found))
    }

    /// A diagnostic about the value at `path`. It points to that value, or to its nearest parent in the text.
    pub fn at_value(&self, path: &Path, message: impl Into<String>) -> Diagnostic {
        self.diagnostic(path, message, &self.tree.origin(path))
    }

    /// A diagnostic about the key at `path`.
    pub fn at_key(&self, path: &Path, message: impl Into<String>) -> Diagnostic {
        self.diagnostic(path, message, &self.tree.key_origin(path))
    }

    fn diagnostic(&self, path: impl Display, message: impl Into<String>, origin: &Origin) -> Diagnostic {
        Diagnostic::new(path, message, Some(place(&self.source, &self.overrides, origin)))
    }
}

fn place(source: &Arc<Source>, overrides: &[String], origin: &Origin) -> Place {
    match origin {
        Origin::File(span) => Place::File { source: source.clone(), span: span.clone() },
        Origin::Override(index) => Place::Override(overrides[*index].clone()),
    }
}

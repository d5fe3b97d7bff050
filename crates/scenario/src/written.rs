//! A scenario as it was written, before it has a type: the place to ask where something stands.

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
    /// Its keys and values, overrides included.
    pub tree: Tree,
}

impl Written {
    /// Reads `text` as TOML and puts the overrides in; also gives what is wrong with the overrides.
    ///
    /// # Errors
    /// Everything in the text that is no TOML.
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

    /// Something wrong with the value at `path`; it is shown there, or at the nearest parent that was written.
    pub fn at_value(&self, path: &Path, message: impl Into<String>) -> Diagnostic {
        self.diagnostic(path, message, &self.tree.origin(path))
    }

    /// Something wrong with the key at `path`.
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

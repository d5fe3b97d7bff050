//! Reads, lists and renames the files that a scenario names.
//!
//! The schema marks a key that names a file with `x-file`. Files are listed and renamed by this mark. The rows of a
//! file and their reader are beside the section that names the file; [`Files`] holds all rows.

use std::collections::BTreeMap;
use std::path::{Path as FilePath, PathBuf};

use serde::Deserialize;
use serde_json::{Map, Value as Json};
use toml::Value as Toml;

use crate::diagnostic::Diagnostic;
use crate::drive::{PathRow, read_paths};
use crate::graph_files::{GraphFiles, read_graph};
use crate::launch::{PushRow, read_push};
use crate::rope_law::{LawFiles, read_law_files};
use crate::scenario::Scenario;
use crate::schema::{schema, variants};
use crate::stow::{StowRow, read_stow};
use crate::wind::{WindRow, read_wind};
use crate::written::Written;

/// The contents of the files that a scenario names.
#[derive(Clone, Debug, Default)]
pub struct Files {
    /// Nodes and ropes of `[web.graph]`.
    pub graph: Option<GraphFiles>,
    /// Rows of the file of `[stow.file]`.
    pub stowed: Option<Vec<StowRow>>,
    /// Files of `[rope.law.table]`, by their names in the scenario.
    pub laws: LawFiles,
    /// Rows of the file of the force in `[launch.tube]`.
    pub push: Option<Vec<PushRow>>,
    /// Rows of the files of `[drive.NAME]`, by the names of the drives.
    pub paths: BTreeMap<String, Vec<PathRow>>,
    /// Rows of the files of `[stow.prescribed.drive.NAME]`, by the names of the drives.
    pub stow_paths: BTreeMap<String, Vec<PathRow>>,
    /// Rows of the file of `[environment.wind.series]`.
    pub wind: Option<Vec<WindRow>>,
}

impl Files {
    /// Reads all files. One that cannot be read is reported and left out.
    pub(crate) fn read(written: &Written, found: &mut Vec<Diagnostic>) -> Self {
        Self {
            graph: read_graph(written, found),
            stowed: read_stow(written, found),
            laws: read_law_files(written, found),
            push: read_push(written, found),
            paths: read_paths(written, "drive", found),
            stow_paths: read_paths(written, "stow.prescribed.drive", found),
            wind: read_wind(written, found),
        }
    }
}

impl Scenario {
    /// The files that the scenario names, relative to it.
    pub fn files(&self) -> Vec<PathBuf> {
        let mut files = Vec::new();
        self.visit_files(&mut |file: &mut String| files.push(PathBuf::from(&*file)));
        files
    }

    /// The same scenario, with its files renamed by `rename`.
    ///
    /// # Errors
    /// The error of `rename`.
    pub fn with_files<E>(&self, mut rename: impl FnMut(&FilePath) -> Result<String, E>) -> Result<Self, E> {
        let mut failed = None;
        let renamed = self.visit_files(&mut |file: &mut String| match rename(FilePath::new(file)) {
            Ok(name) => *file = name,
            Err(error) => failed = Some(error),
        });
        failed.map_or(Ok(renamed), Err)
    }

    /// Calls `visit` with the name of each file, which it can change. Returns the scenario with these names.
    fn visit_files(&self, visit: &mut dyn FnMut(&mut String)) -> Self {
        let mut value = Toml::try_from(self).expect("scenario: keys are strings and values are those of TOML");
        if let Some(root) = schema().as_object() {
            visit_below(root, &mut value, visit);
        }
        Self::deserialize(value).expect("a scenario that was written out reads back")
    }
}

fn visit_below(schema: &Map<String, Json>, value: &mut Toml, visit: &mut dyn FnMut(&mut String)) {
    let properties = schema.get("properties").and_then(Json::as_object);
    let named = schema.get("additionalProperties").and_then(Json::as_object);
    let kinds: BTreeMap<&str, &Map<String, Json>> = variants(schema).into_iter().flatten().collect();
    match value {
        Toml::String(file) if schema.contains_key("x-file") => visit(file),
        Toml::Table(table) => {
            for (key, value) in table.iter_mut() {
                let known = properties.and_then(|known| known.get(key)?.as_object());
                if let Some(below) = known.or_else(|| kinds.get(&key[..]).copied()).or(named) {
                    visit_below(below, value, visit);
                }
            }
        }
        Toml::Array(elements) => {
            if let Some(below) = schema.get("items").and_then(Json::as_object) {
                for value in elements {
                    visit_below(below, value, visit);
                }
            }
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Path;

    /// Each key whose description begins with "CSV file", with whether the schema marks it as a file.
    fn described(schema: &Map<String, Json>, path: &Path, found: &mut Vec<(String, bool)>) {
        let is_file = |content: &Map<String, Json>| {
            content.get("description").and_then(Json::as_str).is_some_and(|text| text.starts_with("CSV file"))
        };
        if is_file(schema) {
            found.push((path.to_string(), schema.contains_key("x-file")));
        }
        let properties = schema.get("properties").and_then(Json::as_object).into_iter().flatten();
        for (key, content) in properties.filter_map(|(key, content)| Some((key, content.as_object()?))) {
            described(content, &path.key(key), found);
        }
        for (key, content) in variants(schema).into_iter().flatten() {
            described(content, &path.key(key), found);
        }
        if let Some(named) = schema.get("additionalProperties").and_then(Json::as_object) {
            described(named, &path.key("NAME"), found);
        }
    }

    #[test]
    fn every_key_that_names_a_file_is_marked() {
        let mut found = Vec::new();
        described(schema().as_object().unwrap(), &Path::default(), &mut found);
        assert!(found.len() >= 9 && found.iter().all(|(_, is_marked)| *is_marked), "{found:#?}");
    }
}

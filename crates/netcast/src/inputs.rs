//! The inputs of a run: the resolved scenario, and the files that it names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use netcast_model::Model;
use netcast_results::{ResultError, folder, hash, hash_files};
use netcast_scenario::tree::Tree;
use netcast_scenario::{Document, resolved_toml};

use serde_json::Value as Json;

use crate::values::flatten;

/// The name of the scenario's file among the inputs.
pub(crate) const SCENARIO: &str = "scenario.toml";

/// The files of the `inputs` folder, by name. A run of the scenario among them gives the same result bit for bit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Inputs(BTreeMap<String, Vec<u8>>);

impl Inputs {
    /// The inputs of a document: the scenario with all defaults written out, and its files under unique names.
    ///
    /// # Errors
    /// [`ResultError`] where a file cannot be read.
    pub fn new(document: &Document, model: &Model) -> Result<Self, ResultError> {
        let mut contents = BTreeMap::from([(SCENARIO.to_owned(), Vec::new())]);
        let files = &document.written.files;
        let scenario = model.scenario.with_files(|file| {
            let mut name = file.file_name().map_or_else(|| "file".into(), |n| n.to_string_lossy().into_owned());
            while contents.contains_key(&name) {
                name.insert(0, '_');
            }
            let bytes = files.bytes(file).map_err(ResultError::read(&files.path(file)))?;
            contents.insert(name.clone(), bytes);
            Ok::<_, ResultError>(name)
        })?;
        let resolved = document.library.comments() + &resolved_toml(&scenario);
        contents.insert(SCENARIO.to_owned(), resolved.into_bytes());
        Ok(Self(contents))
    }

    /// Reads the inputs of a result folder.
    ///
    /// # Errors
    /// [`ResultError`] where a file or the folder `inputs` cannot be read.
    pub fn read(result: &Path) -> Result<Self, ResultError> {
        let inputs = result.join(folder::INPUTS);
        let mut contents = BTreeMap::new();
        for entry in fs::read_dir(&inputs).map_err(ResultError::read(&inputs))? {
            let path = entry.map_err(ResultError::read(&inputs))?.path();
            if path.is_file() {
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                contents.insert(name, fs::read(&path).map_err(ResultError::read(&path))?);
            }
        }
        Ok(Self(contents))
    }

    /// Every value of the scenario under its dotted path, and after them the size and hash of each file that it names:
    /// files of one name may differ.
    pub fn values(&self) -> Vec<(String, Json)> {
        let mut values = Vec::new();
        let scenario = self.0.get(SCENARIO).map_or(&[][..], Vec::as_slice);
        // a scenario that was damaged after the run has no values
        if let Ok(tree) = Tree::parse(&String::from_utf8_lossy(scenario)) {
            flatten(&Default::default(), &tree.root.value, &mut values);
        }
        for (name, bytes) in self.0.iter().filter(|(name, _)| *name != SCENARIO) {
            let contents = format!("{} bytes, SHA-256 {}", bytes.len(), &hash([bytes])[..12]);
            values.push((format!("{}/{name}", folder::INPUTS), Json::from(contents)));
        }
        values
    }

    /// The hash of the inputs; see [`hash_files`].
    pub fn hash(&self) -> String {
        hash_files(&self.0)
    }

    /// Writes the inputs into the `inputs` folder of a result.
    ///
    /// # Errors
    /// [`ResultError`] where a file or the folder cannot be written.
    pub fn write(&self, result: &Path) -> Result<(), ResultError> {
        let inputs = result.join(folder::INPUTS);
        fs::create_dir_all(&inputs).map_err(ResultError::write(&inputs))?;
        for (name, content) in &self.0 {
            let path = inputs.join(name);
            fs::write(&path, content).map_err(ResultError::write(&path))?;
        }
        Ok(())
    }

    /// The differences from the inputs of a result folder in words; a file that cannot be read counts as empty.
    pub fn differences(&self, result: &Path) -> String {
        let before = |name: &str| fs::read(result.join(folder::INPUTS).join(name)).unwrap_or_default();
        let (was, is) = (values(&before(SCENARIO)), values(&self.0[SCENARIO]));
        let keys: BTreeSet<&String> = was.keys().chain(is.keys()).collect();
        let value = |of: &BTreeMap<String, String>, key: &str| of.get(key).map_or("left out".into(), String::clone);
        let changed =
            keys.into_iter().map(|key| (key, value(&was, key), value(&is, key))).filter(|(_, was, is)| was != is);
        let mut listed: Vec<String> = changed.map(|(key, was, is)| format!("{key} was {was} and is {is}")).collect();
        let files = self.0.iter().filter(|(name, content)| *name != SCENARIO && before(name) != **content);
        listed.extend(files.map(|(name, _)| format!("{name} has changed")));
        match listed.len() {
            0 => "their hash differs, but no value or file of the scenario does".to_owned(),
            1..=MOST_LISTED => listed.join("; "),
            more => format!("{}; and {} more", listed[..MOST_LISTED].join("; "), more - MOST_LISTED),
        }
    }
}

/// Most differences that a message lists.
const MOST_LISTED: usize = 4;

/// The values of a resolved scenario by their dotted paths; none where it is not valid TOML.
fn values(scenario: &[u8]) -> BTreeMap<String, String> {
    let mut values = Vec::new();
    if let Ok(tree) = Tree::parse(&String::from_utf8_lossy(scenario)) {
        flatten(&Default::default(), &tree.root.value, &mut values);
    }
    values.into_iter().map(|(path, value)| (path, value.to_string())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_one_name_with_different_contents_differ() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join(folder::INPUTS)).unwrap();
        let values = |text: &str| {
            fs::write(folder.path().join("inputs/nodes.csv"), text).unwrap();
            fs::write(folder.path().join("inputs/scenario.toml"), "").unwrap();
            Inputs::read(folder.path()).unwrap().values()
        };
        let (one, other) = (values("id,x\n1,0\n"), values("id,x\n1,1\n"));
        assert_eq!((one.len(), &one[0].0), (1, &other[0].0));
        assert_ne!(one, other);
    }
}

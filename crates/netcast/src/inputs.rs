//! What a result was computed from: the scenario as resolved, and the files it names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use netcast_model::Model;
use netcast_results::{ResultError, folder, hash, hash_files};
use netcast_scenario::tree::Tree;
use netcast_scenario::{Document, resolved_toml};

use serde_json::Value as Json;

use crate::values::flatten;

/// The scenario among the inputs.
pub(crate) const SCENARIO: &str = "scenario.toml";

/// The files of the `inputs` folder, by name. Running the scenario among them gives the same bits again.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Inputs(BTreeMap<String, Vec<u8>>);

impl Inputs {
    /// Of a document, with all defaults written out, and its files each under a name of its own.
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

    /// Those of a result folder.
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

    /// Every value of the scenario under its dotted path; after them each file that it names, with a hash of what is in
    /// it: two webs may be drawn in files of one name.
    pub fn values(&self) -> Vec<(String, Json)> {
        let mut values = Vec::new();
        let scenario = self.0.get(SCENARIO).map_or(&[][..], Vec::as_slice);
        // netcast wrote TOML; a file that somebody has broken since has no values
        if let Ok(tree) = Tree::parse(&String::from_utf8_lossy(scenario)) {
            flatten(&Default::default(), &tree.root.value, &mut values);
        }
        for (name, bytes) in self.0.iter().filter(|(name, _)| *name != SCENARIO) {
            let told = format!("{} bytes, SHA-256 {}", bytes.len(), &hash([bytes])[..12]);
            values.push((format!("{}/{name}", folder::INPUTS), Json::from(told)));
        }
        values
    }

    /// What they are known by; see [`hash_files`].
    pub fn hash(&self) -> String {
        hash_files(&self.0)
    }

    /// Writes them into the `inputs` folder of a result.
    pub fn write(&self, result: &Path) -> Result<(), ResultError> {
        let inputs = result.join(folder::INPUTS);
        fs::create_dir_all(&inputs).map_err(ResultError::write(&inputs))?;
        for (name, content) in &self.0 {
            let path = inputs.join(name);
            fs::write(&path, content).map_err(ResultError::write(&path))?;
        }
        Ok(())
    }

    /// Where they differ from the inputs of a result, in a few words, as far as those can be read.
    pub fn differences(&self, result: &Path) -> String {
        let before = |name: &str| fs::read(result.join(folder::INPUTS).join(name)).unwrap_or_default();
        let (was, is) = (values(&before(SCENARIO)), values(&self.0[SCENARIO]));
        let keys: BTreeSet<&String> = was.keys().chain(is.keys()).collect();
        let value = |of: &BTreeMap<String, String>, key: &str| of.get(key).map_or("left out".into(), String::clone);
        let changed =
            keys.into_iter().map(|key| (key, value(&was, key), value(&is, key))).filter(|(_, was, is)| was != is);
        let mut told: Vec<String> = changed.map(|(key, was, is)| format!("{key} was {was} and is {is}")).collect();
        let files = self.0.iter().filter(|(name, content)| *name != SCENARIO && before(name) != **content);
        told.extend(files.map(|(name, _)| format!("{name} has changed")));
        match told.len() {
            0 => "something that cannot be told".to_owned(),
            1..=MOST_TOLD => told.join("; "),
            more => format!("{}; and {} more", told[..MOST_TOLD].join("; "), more - MOST_TOLD),
        }
    }
}

/// Differences that are told, where there are many.
const MOST_TOLD: usize = 4;

/// The values of a resolved scenario by their dotted paths; none where it does not read.
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
    fn files_of_one_name_with_other_content_differ() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join(folder::INPUTS)).unwrap();
        let told = |text: &str| {
            fs::write(folder.path().join("inputs/nodes.csv"), text).unwrap();
            fs::write(folder.path().join("inputs/scenario.toml"), "").unwrap();
            Inputs::read(folder.path()).unwrap().values()
        };
        let (one, other) = (told("id,x\n1,0\n"), told("id,x\n1,1\n"));
        assert_eq!((one.len(), &one[0].0), (1, &other[0].0));
        assert_ne!(one, other);
    }
}

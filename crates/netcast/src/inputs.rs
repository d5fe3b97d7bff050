//! What a result was computed from: the scenario as resolved, and the files it names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use netcast_model::Model;
use netcast_results::{ResultError, folder, manifest};
use netcast_scenario::tree::Tree;
use netcast_scenario::{Document, resolved_toml};

use crate::values::flatten;

/// The scenario among the inputs.
pub(crate) const SCENARIO: &str = "scenario.toml";

/// The files of the `inputs` folder, by name. Running the scenario among them gives the same bits again.
pub(crate) struct Inputs(BTreeMap<String, Vec<u8>>);

impl Inputs {
    /// Of a document, with all defaults written out, and its files each under a name of its own.
    pub fn new(document: &Document, model: &Model) -> Result<Self, ResultError> {
        let mut files = BTreeMap::from([(SCENARIO.to_owned(), Vec::new())]);
        let scenario = model.scenario.with_files(|file| {
            let from = document.written.folder.join(file);
            let mut name = file.file_name().map_or_else(|| "file".into(), |n| n.to_string_lossy().into_owned());
            while files.contains_key(&name) {
                name.insert(0, '_');
            }
            files.insert(name.clone(), fs::read(&from).map_err(ResultError::read(&from))?);
            Ok::<_, ResultError>(name)
        })?;
        let resolved = document.library.comments() + &resolved_toml(&scenario);
        files.insert(SCENARIO.to_owned(), resolved.into_bytes());
        Ok(Self(files))
    }

    /// What they are known by; see [`manifest::hash_inputs`].
    pub fn hash(&self) -> String {
        manifest::hash_files(&self.0)
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

    /// Where they differ from the inputs of a result, told in a few words; as far as those can be read.
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

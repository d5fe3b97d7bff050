//! Overrides, as after `--set`: puts `path=value` into the tree of a scenario.

use toml::de::DeValue;

use crate::path::{Path, Step};
use crate::tree::{Entry, Node, Origin, Table, Tree, TreeFault, Value};

/// Largest number of steps in the path of an override. Functions that walk the tree recurse; TOML has a similar limit.
const DEEPEST: usize = 64;

impl Tree {
    /// Puts the override `path=value`, which is number `place` of the overrides, into the tree. A value that is not
    /// TOML is taken as a string.
    ///
    /// # Errors
    /// Where it has no `=`, or its path leads through a value that is neither table nor array.
    pub fn set(&mut self, text: &str, place: usize) -> Result<(), TreeFault> {
        let origin = Origin::Override(place);
        let fault = |message: String| TreeFault { origin: Origin::Override(place), message };
        let (path, value) = text
            .split_once('=')
            .ok_or_else(|| fault("expected path=value, such as launch.axial_speed=\"60 m/s\"".into()))?;
        let steps = Path::parse(path.trim()).0;
        if steps.is_empty() {
            return Err(fault("expected a path before \"=\"".into()));
        }
        if steps.len() > DEEPEST {
            return Err(fault(format!("a path has at most {DEEPEST} steps")));
        }
        let mut faults = Vec::new();
        let value = match DeValue::parse(value.trim()) {
            Ok(parsed) => Value::from_toml(parsed.get_ref(), &|_| Origin::Override(place), &mut faults, &origin),
            Err(_) => Value::String(value.trim().to_string()),
        };
        if let Some(first) = faults.into_iter().next() {
            return Err(first);
        }
        *self.descend(&steps, place).map_err(fault)? = Node { origin, value };
        Ok(())
    }

    /// The node at the end of `steps`. Missing tables on the way are added.
    fn descend(&mut self, steps: &[Step], place: usize) -> Result<&mut Node, String> {
        let mut node = &mut self.root;
        let mut walked = Path::default();
        for step in steps {
            let name = match step {
                Step::Key(key) => key.clone(),
                Step::Index(index) => index.to_string(),
            };
            node = match &mut node.value {
                Value::Table(table) => {
                    let entry = match table.0.iter().position(|entry| entry.key == name) {
                        Some(found) => found,
                        None => {
                            let origin = Origin::Override(place);
                            let value = Value::Table(Table::default());
                            let node = Node { origin: origin.clone(), value };
                            table.0.push(Entry { key: name.clone(), origin, node });
                            table.0.len() - 1
                        }
                    };
                    walked = walked.key(&name);
                    &mut table.0[entry].node
                }
                Value::Array(elements) => {
                    let count = elements.len();
                    let element = name.parse().ok().and_then(|index: usize| elements.get_mut(index));
                    let node =
                        element.ok_or_else(|| format!("{walked} has no element {name}; it has {count}, from 0"))?;
                    walked = walked.key(&name);
                    node
                }
                other => return Err(format!("{walked} is {}, which has no {name:?}", other.describe())),
            };
        }
        Ok(node)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_override_replaces_adds_and_indexes() {
        let mut tree = Tree::parse("[launch]\naxial_speed = 50\n[[tractors]]\ncorner = 3\n").unwrap();
        for (place, text) in [
            "launch.axial_speed=60 m/s",
            "launch.radial_speed = \"7 m/s\"",
            "tractors.0.corner=4",
            "solve.duration=0.5",
        ]
        .into_iter()
        .enumerate()
        {
            tree.set(text, place).unwrap();
        }
        let value = |path: &str| tree.get(&Path::parse(path)).unwrap().value.to_toml();
        assert_eq!(value("launch.axial_speed"), toml::Value::from("60 m/s"));
        assert_eq!(value("launch.radial_speed"), toml::Value::from("7 m/s"));
        assert_eq!(value("tractors[0].corner"), toml::Value::from(4));
        assert_eq!(value("solve.duration"), toml::Value::from(0.5));
        assert_eq!(tree.origin(&Path::parse("tractors[0].corner")), Origin::Override(2));
    }

    #[test]
    fn an_override_with_an_impossible_path_is_refused() {
        let mut tree = Tree::parse("title = \"a\"\n[[tractors]]\ncorner = 3\n").unwrap();
        assert!(tree.set("launch.axial_speed", 0).unwrap_err().message.starts_with("expected path=value"));
        assert_eq!(
            tree.set("tractors.4.corner=1", 0).unwrap_err().message,
            "tractors has no element 4; it has 1, from 0"
        );
        assert_eq!(tree.set("title.x=1", 0).unwrap_err().message, "title is the string \"a\", which has no \"x\"");
    }
}

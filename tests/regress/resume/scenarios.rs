//! The small, short scenarios of tests/resume/. Together they have every key of the schema.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{files_of_kind, resume};
use netcast::Document;
use netcast::scenario::Source;
use netcast::scenario::schema;
use netcast::scenario::tree::{Tree, Value};
use serde_json::{Map, Value as Json};

/// Name and text of each scenario, sorted by name.
pub fn scenarios() -> Vec<(String, String)> {
    let name = |path: &PathBuf| path.file_stem().unwrap().to_string_lossy().into_owned();
    files_of_kind(&resume(), "toml").iter().map(|path| (name(path), fs::read_to_string(path).unwrap())).collect()
}

/// The text of the scenario called `name`.
pub fn scenario(name: &str) -> String {
    let found = scenarios().into_iter().find(|(known, _)| known == name);
    found.unwrap_or_else(|| panic!("tests/resume/{name}.toml is missing")).1
}

/// Copies the files that the scenarios name to `folder`.
pub fn write_files(folder: &Path) {
    for path in files_of_kind(&resume(), "csv") {
        fs::copy(&path, folder.join(path.file_name().unwrap())).unwrap();
    }
}

/// Reads a scenario whose files are in `folder`.
pub fn read(text: &str, folder: &Path) -> Document {
    let source = Source { name: "scenario.toml".into(), text: text.into() };
    Document::parse(source, folder, &[]).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Every key, variant and choice of the schema that no scenario has, and every optional section that all scenarios have. A
/// new key of the schema is missing here until a scenario has it.
pub fn missing() -> Vec<String> {
    let mut missing = BTreeSet::new();
    let trees: Vec<Tree> =
        scenarios().iter().map(|(name, text)| Tree::parse(text).unwrap_or_else(|_| panic!("{name}"))).collect();
    let roots: Vec<&Value> = trees.iter().map(|tree| &tree.root.value).collect();
    walk(schema().as_object().unwrap(), "", &roots, &mut missing);
    let required: Vec<&Json> = schema()["required"].as_array().unwrap().iter().collect();
    for key in
        schema()["properties"].as_object().unwrap().keys().filter(|key| !required.contains(&&Json::from(&key[..])))
    {
        if roots.iter().all(|root| child(root, key).is_some()) {
            missing.insert(format!("a scenario without {key}"));
        }
    }
    missing.into_iter().collect()
}

fn child<'v>(value: &'v Value, key: &str) -> Option<&'v Value> {
    value.as_table()?.0.iter().find(|entry| entry.key == key).map(|entry| &entry.node.value)
}

/// Adds to `missing` each key and choice that `schema` allows at `path` and none of `values` has.
fn walk(schema: &Map<String, Json>, path: &str, values: &[&Value], missing: &mut BTreeSet<String>) {
    let mut below = |step: String, schema: &Json, values: Vec<&Value>| {
        let path = format!("{path}{step}");
        match schema.as_object() {
            _ if values.is_empty() => drop(missing.insert(path)),
            Some(schema) => walk(schema, &path, &values, missing),
            None => {}
        }
    };
    let named = |key: &str| values.iter().filter_map(|value| child(value, key)).collect();
    let objects = |of: &str| schema.get(of).and_then(Json::as_object).into_iter().flatten();
    for (key, content) in objects("properties") {
        below(format!(".{key}"), content, named(key));
    }
    for branch in schema.get("oneOf").and_then(Json::as_array).into_iter().flatten() {
        for (variant, content) in branch.get("properties").and_then(Json::as_object).into_iter().flatten() {
            below(format!(".{variant}"), content, named(variant));
        }
        if let Some(choice) = branch.get("const") {
            below(format!(" = {choice}"), &Json::Null, equal(values, choice));
        }
    }
    for choice in schema.get("enum").and_then(Json::as_array).into_iter().flatten() {
        below(format!(" = {choice}"), &Json::Null, equal(values, choice));
    }
    if schema.get("type") == Some(&Json::from("boolean")) {
        for choice in [true, false] {
            below(format!(" = {choice}"), &Json::Null, equal(values, &Json::from(choice)));
        }
    }
    // keys that the user chooses, and elements of a list
    if let Some(content) = schema.get("additionalProperties").filter(|content| content.is_object()) {
        let all = values.iter().filter_map(|value| value.as_table());
        below(".NAME".into(), content, all.flat_map(|table| &table.0).map(|entry| &entry.node.value).collect());
    }
    if let Some(content) = schema.get("items") {
        let elements = values.iter().flat_map(|value| match value {
            Value::Array(elements) => &elements[..],
            _ => &[],
        });
        below("[]".into(), content, elements.map(|element| &element.value).collect());
    }
}

/// The values that equal this choice.
fn equal<'v>(values: &[&'v Value], choice: &Json) -> Vec<&'v Value> {
    let is = |value: &Value| match value {
        Value::String(text) => *choice == text[..],
        Value::Boolean(value) => *choice == *value,
        _ => false,
    };
    values.iter().copied().filter(|value| is(value)).collect()
}

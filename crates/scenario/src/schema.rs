//! The JSON Schema of a scenario, derived from its types. Editors complete keys from it, and the check walks it.

use std::sync::LazyLock;

use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::transform_subschemas;
use serde_json::{Map, Value};

use crate::path::Path;
use crate::scenario::Scenario;

/// The JSON Schema of a scenario. Beside the standard keywords it has `x-dimension` and `x-unit`, the kind and the SI
/// unit of a quantity, `x-word`, a word that is allowed in place of the quantity, and `x-file`, which marks the name
/// of a file. Bounds such as `minimum` are in the SI unit.
pub fn schema() -> &'static Value {
    static SCHEMA: LazyLock<Value> = LazyLock::new(generate);
    &SCHEMA
}

fn generate() -> Value {
    let settings = SchemaSettings::draft2020_12()
        .with(|settings| settings.inline_subschemas = true)
        .with_transform(fit_toml)
        .for_deserialize();
    let mut schema: Value = settings.into_generator().into_root_schema_for::<Scenario>().into();
    if let Some(root) = schema.as_object_mut() {
        root.insert("title".into(), "netcast scenario".into());
    }
    schema
}

/// Removes null from the schema, as TOML has no null and an optional key is left out. States the largest whole number.
fn fit_toml(schema: &mut Schema) {
    transform_subschemas(&mut fit_toml, schema);
    let Some(object) = schema.as_object_mut() else { return };
    if object.get("format").is_some_and(|format| format == "uint32") {
        object.entry("maximum").or_insert(u32::MAX.into());
    }
    if let Some(Value::Array(types)) = object.get_mut("type") {
        types.retain(|kind| kind != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            object.insert("type".into(), only);
        }
    }
    if let Some(Value::Array(choices)) = object.get_mut("anyOf") {
        choices.retain(|choice| choice.get("type") != Some(&Value::from("null")));
        if let [Value::Object(only)] = choices.as_slice() {
            let only = only.clone();
            object.remove("anyOf");
            for (keyword, value) in only {
                object.entry(keyword).or_insert(value);
            }
        }
    }
}

/// The variants of an externally tagged enum, with name and schema. `None` where `schema` is of another kind.
pub(crate) fn variants(schema: &Map<String, Value>) -> Option<Vec<(&str, &Map<String, Value>)>> {
    let branches = schema.get("oneOf")?.as_array()?;
    let properties = branches.iter().map(|branch| branch.get("properties")?.as_object()?.iter().next());
    properties.map(|first| first.and_then(|(name, content)| Some((name.as_str(), content.as_object()?)))).collect()
}

/// The strings that a key can take. `None` where `schema` is of another kind.
pub(crate) fn choices(schema: &Map<String, Value>) -> Option<Vec<&str>> {
    if let Some(listed) = schema.get("enum") {
        return listed.as_array()?.iter().map(Value::as_str).collect();
    }
    schema.get("oneOf")?.as_array()?.iter().map(|branch| branch.get("const")?.as_str()).collect()
}

/// The keys of the table at `path`, or the names of its variants. Empty where there is no such table.
pub(crate) fn keys_at(path: &str) -> Vec<&'static str> {
    let below = |schema: &'static Map<String, Value>, key: &str| {
        let property = schema.get("properties").and_then(|known| known.get(key)?.as_object());
        property.or_else(|| variants(schema)?.into_iter().find(|(name, _)| *name == key).map(|(_, content)| content))
    };
    let table = path.split('.').fold(schema().as_object(), |at, key| below(at?, key));
    table.map_or(Vec::new(), keys)
}

/// The keys of the table of the type `T`.
pub(crate) fn keys_of<T: schemars::JsonSchema>() -> Vec<String> {
    let schema = schemars::SchemaGenerator::default().into_root_schema_for::<T>();
    schema.as_object().map_or(Vec::new(), |table| keys(table).into_iter().map(str::to_owned).collect())
}

fn keys(table: &Map<String, Value>) -> Vec<&str> {
    match (variants(table), table.get("properties").and_then(Value::as_object)) {
        (Some(kinds), _) => kinds.into_iter().map(|(name, _)| name).collect(),
        (None, known) => known.into_iter().flat_map(|known| known.keys().map(String::as_str)).collect(),
    }
}

/// The paths of all keys of a scenario that have the name `key`.
pub fn find_key(schema: &Value, key: &str) -> Vec<String> {
    let mut found = Vec::new();
    if let Some(root) = schema.as_object() {
        find_below(root, key, &Path::default(), &mut found);
    }
    found
}

fn find_below(schema: &Map<String, Value>, key: &str, path: &Path, found: &mut Vec<String>) {
    let properties = schema.get("properties").and_then(Value::as_object);
    let known =
        properties.into_iter().flatten().filter_map(|(name, content)| Some((name.as_str(), content.as_object()?)));
    for (name, content) in known.chain(variants(schema).into_iter().flatten()) {
        let here = path.key(name);
        if name == key {
            found.push(here.to_string());
        }
        find_below(content, key, &here, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dimension::Kind;
    use crate::interval::Interval;

    #[test]
    fn the_schema_has_descriptions_dimensions_and_defaults() {
        let schema = schema();
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
        assert_eq!(schema["title"], "netcast scenario");
        assert_eq!(schema["required"], serde_json::json!(["web", "rope", "solve"]));
        assert_eq!(schema["additionalProperties"], false);
        let every = &schema["properties"]["record"]["properties"]["every"];
        assert_eq!(every["default"], "0.001 s");
        assert_eq!(every["x-dimension"], "time");
        assert_eq!(every["exclusiveMinimum"], 0.0);
        assert!(every["description"].as_str().unwrap().contains("rows of the history"));
        // TOML has no null
        assert!(!schema.to_string().contains("null\""), "{schema:#}");
        assert!(!schema.to_string().contains("$ref"), "{schema:#}");
    }

    #[test]
    fn every_key_has_a_description() {
        fn walk(path: &Path, schema: &Map<String, Value>, missing: &mut Vec<String>) {
            let properties = schema.get("properties").and_then(Value::as_object);
            for (name, content) in properties.into_iter().flatten() {
                let (here, content) = (path.key(name), content.as_object().unwrap());
                if !content.contains_key("description") {
                    missing.push(here.to_string());
                }
                walk(&here, content, missing);
            }
            for (name, content) in variants(schema).into_iter().flatten() {
                walk(&path.key(name), content, missing);
            }
        }
        let mut missing = Vec::new();
        walk(&Path::default(), schema().as_object().unwrap(), &mut missing);
        assert_eq!(missing, Vec::<String>::new());
    }

    /// The value after "Default: " in a description, which ends at a comma, a semicolon or the end of the sentence.
    fn described_default(description: &str) -> &str {
        let (_, stated) = description.split_once("Default: ").unwrap_or_default();
        let stated = stated.split(". ").next().unwrap_or_default();
        stated.split([',', ';']).next().unwrap_or_default().trim_end_matches('.')
    }

    /// Whether `described` and `default` are the same value, each read as a quantity of the key.
    fn is_same(described: &str, default: &Value, key: &Map<String, Value>) -> bool {
        let Some(kind) = key.get("x-dimension").and_then(Value::as_str).and_then(Kind::named) else {
            let text = default.to_string();
            return described == text || [("none", "[]"), ("empty", "\"\"")].contains(&(described, &text));
        };
        let default = match default {
            Value::String(text) => kind.read_text(text, &Interval::ALL).ok(),
            other => other.as_f64(),
        };
        match described.split_once('/').filter(|_| kind.unit.is_empty()) {
            Some((over, under)) => default == Some(over.parse::<f64>().unwrap() / under.parse::<f64>().unwrap()),
            None => default == kind.read_text(described, &Interval::ALL).ok(),
        }
    }

    #[test]
    fn every_description_states_the_default_of_its_key() {
        fn walk(path: &Path, schema: &Map<String, Value>, wrong: &mut Vec<String>) {
            let properties = schema.get("properties").and_then(Value::as_object);
            for (name, content) in properties.into_iter().flatten() {
                let (here, content) = (path.key(name), content.as_object().unwrap());
                let default = content.get("default").filter(|default| !default.is_object() && !default.is_null());
                let description = content["description"].as_str().unwrap().replace('\n', " ");
                if let Some(default) = default
                    && !is_same(described_default(&description), default, content)
                {
                    wrong.push(format!("{here}: {description:?}, default {default}"));
                }
                walk(&here, content, wrong);
            }
            for (name, content) in variants(schema).into_iter().flatten() {
                walk(&path.key(name), content, wrong);
            }
            for key in ["items", "additionalProperties"] {
                if let Some(content) = schema.get(key).and_then(Value::as_object) {
                    walk(&path.key("NAME"), content, wrong);
                }
            }
        }
        let mut wrong = Vec::new();
        walk(&Path::default(), schema().as_object().unwrap(), &mut wrong);
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn every_number_has_a_smallest_and_a_largest_value() {
        fn walk(path: &Path, schema: &Value, count: &mut usize, missing: &mut Vec<String>) {
            let (fields, lists) = (schema.as_object(), schema.as_array());
            let is_number =
                schema.get("x-dimension").is_some() || schema["type"] == "integer" || schema["type"] == "number";
            if is_number {
                let has = |keys: [&str; 2]| keys.iter().any(|key| schema[*key].is_number());
                *count += 1;
                if !has(["minimum", "exclusiveMinimum"]) || !has(["maximum", "exclusiveMaximum"]) {
                    missing.push(path.to_string());
                }
            }
            for (name, below) in fields.into_iter().flatten() {
                walk(&path.key(name), below, count, missing);
            }
            for below in lists.into_iter().flatten() {
                walk(path, below, count, missing);
            }
        }
        let (mut count, mut missing) = (0, Vec::new());
        walk(&Path::default(), schema(), &mut count, &mut missing);
        assert!(count > 100, "{count}");
        assert_eq!(missing, Vec::<String>::new());
    }

    #[test]
    fn the_keys_of_a_table_are_those_of_its_type() {
        assert_eq!(keys_at("tractor"), ["cylinder", "sphere", "box", "particle"]);
        assert_eq!(keys_at("web.space"), ["side"]);
        assert_eq!(keys_at("web.nothing"), Vec::<&str>::new());
        assert_eq!(keys_of::<crate::selection::Selection>(), ["corners", "tractors", "nodes", "points"]);
    }

    #[test]
    fn a_key_is_found_in_every_section_that_has_it() {
        assert_eq!(find_key(schema(), "segment_length"), ["solve.segment_length"]);
        assert!(find_key(schema(), "side").contains(&"web.space.side".to_string()));
    }
}

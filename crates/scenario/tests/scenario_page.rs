//! `docs/scenario.md` lists every key of a scenario, from the schema.
//!
//! `NETCAST_WRITE_DOCS=1 cargo test -p netcast-scenario --test scenario_page` writes the lists anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use netcast_scenario::schema;
use serde_json::Value;

const START: &str = "<!-- From the schema; crates/scenario/tests/scenario_page.rs writes it. -->\n";
const END: &str = "<!-- End of the lists. -->\n";

/// A row of the page: what a key takes, its default, what it means.
#[derive(PartialEq)]
struct Row {
    takes: String,
    default: String,
    meaning: String,
}

/// The keys below a schema, with dots; `NAME` stands for a name of the user's, `[]` for an entry of a list.
fn collect(
    path: &str,
    schema: &Value,
    inherited: &str,
    rows: &mut BTreeMap<String, Vec<Row>>,
    order: &mut Vec<String>,
) {
    let below = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    let meaning = schema["description"].as_str().unwrap_or(inherited);
    let mut is_table = false;
    for variant in ["oneOf", "anyOf", "allOf"].iter().filter_map(|of| schema[*of].as_array()).flatten() {
        if variant["const"].is_null() && variant["enum"].is_null() {
            is_table = true;
            collect(path, variant, meaning, rows, order);
        }
    }
    for (key, of_key) in schema["properties"].as_object().into_iter().flatten() {
        is_table = true;
        collect(&below(key), of_key, schema["description"].as_str().unwrap_or_default(), rows, order);
    }
    for (map, name) in [("additionalProperties", "NAME"), ("patternProperties", "NAME")] {
        let entries = match &schema[map] {
            Value::Object(of_pattern) if map == "patternProperties" => of_pattern.values().collect(),
            Value::Object(_) => vec![&schema[map]],
            _ => Vec::new(),
        };
        for entry in entries {
            is_table = true;
            collect(&below(name), entry, meaning, rows, order);
        }
    }
    let items = &schema["items"];
    if items["properties"].is_object() || items["oneOf"].is_array() {
        is_table = true;
        collect(&format!("{path}[]"), items, meaning, rows, order);
    }
    if !is_table && !path.is_empty() {
        let row = Row { takes: takes(schema), default: default(schema), meaning: cell(meaning) };
        let known = rows.entry(path.to_owned()).or_default();
        if known.is_empty() {
            order.push(path.to_owned());
        }
        if !known.contains(&row) {
            known.push(row);
        }
    }
}

/// What may stand there: a dimension with its unit, a kind of value, or the words to choose from; and its range.
fn takes(schema: &Value) -> String {
    let words = |of: &str| {
        let variants = schema[of].as_array().into_iter().flatten();
        variants
            .flat_map(|variant| [&variant["const"], &variant["enum"][0]])
            .filter_map(Value::as_str)
            .collect::<Vec<_>>()
    };
    let mut choices: Vec<&str> = schema["enum"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    choices.extend(schema["const"].as_str());
    choices.extend(words("oneOf").into_iter().chain(words("anyOf")));
    let kind = match (&schema["x-dimension"], &schema["type"]) {
        _ if !choices.is_empty() => choices.iter().map(|word| format!("`{word:?}`")).collect::<Vec<_>>().join(" or "),
        (Value::String(dimension), _) => match schema["x-unit"].as_str().unwrap_or_default() {
            "" => dimension.clone(),
            unit => format!("{dimension}, {unit}"),
        },
        (_, Value::String(kind)) => match &kind[..] {
            "string" => "text".to_owned(),
            "boolean" => "true or false".to_owned(),
            "array" => format!("list of {}", takes(&schema["items"])),
            "integer" => "whole number".to_owned(),
            other => other.to_owned(),
        },
        (_, Value::Array(kinds)) => kinds
            .iter()
            .filter_map(Value::as_str)
            .map(|k| if k == "string" { "text" } else { k })
            .collect::<Vec<_>>()
            .join(" or "),
        _ => "a value".to_owned(),
    };
    let bounds = [("minimum", "≥"), ("exclusiveMinimum", ">"), ("maximum", "≤"), ("exclusiveMaximum", "<")];
    let bounds =
        bounds.iter().filter(|(key, _)| schema[*key].is_number() && schema[*key].as_f64() != Some(4_294_967_295.0));
    bounds.fold(kind, |text, (key, sign)| format!("{text}, {sign} {}", schema[*key]))
}

fn default(schema: &Value) -> String {
    match &schema["default"] {
        Value::Null => String::new(),
        value => format!("`{}`", cell(&value.to_string())),
    }
}

/// Text that fits one cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

/// The lists as they should stand on the page.
fn lists() -> String {
    let (mut rows, mut order) = (BTreeMap::new(), Vec::new());
    collect("", schema(), "", &mut rows, &mut order);
    let section_of = |path: &str| path.split(['.', '[']).next().unwrap_or_default().to_owned();
    let mut sections: Vec<String> = Vec::new();
    for path in &order {
        if !sections.contains(&section_of(path)) {
            sections.push(section_of(path));
        }
    }
    let mut page = String::new();
    for section in sections {
        page += &format!("\n## {section}\n\n| key | takes | default | meaning |\n|---|---|---|---|\n");
        for path in order.iter().filter(|path| section_of(path) == section) {
            for Row { takes, default, meaning } in &rows[path] {
                page += &format!("| `{path}` | {takes} | {default} | {meaning} |\n");
            }
        }
    }
    page + "\n"
}

#[test]
fn the_page_of_the_scenario_lists_every_key() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/scenario.md");
    let page = fs::read_to_string(&path).unwrap();
    let (before, rest) = page.split_once(START).expect("the page has a place for the lists");
    let (found, after) = rest.split_once(END).expect("the lists have an end");
    let expected = lists();
    if std::env::var_os("NETCAST_WRITE_DOCS").is_some() {
        fs::write(&path, [before, START, &expected, END, after].concat()).unwrap();
        return;
    }
    for (found, expected) in found.lines().zip(expected.lines()) {
        assert_eq!(found, expected, "write the lists anew by NETCAST_WRITE_DOCS=1");
    }
    let (found, expected) = (found.lines().count(), expected.lines().count());
    assert_eq!(found, expected, "lines of the lists; write them anew by NETCAST_WRITE_DOCS=1");
}

#[test]
fn every_key_has_a_meaning() {
    let (mut rows, mut order) = (BTreeMap::new(), Vec::new());
    collect("", schema(), "", &mut rows, &mut order);
    for (path, rows) in rows {
        assert!(rows.iter().all(|row| !row.meaning.is_empty()), "{path} says nothing of itself");
    }
}

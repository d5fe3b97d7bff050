//! Checks the text of a scenario against its schema, and collects every fault.

use std::f64::consts::TAU;

use serde_json::{Map, Value as Json};

use crate::diagnostic::{Diagnostic, Place};
use crate::dimension::Kind;
use crate::interval::Interval;
use crate::later::is_reserved;
use crate::nearest::nearest;
use crate::path::Path;
use crate::schema::{choices, find_key, schema, variants};
use crate::tree::{Node, Table, Value};
use crate::written::Written;

type Schema = Map<String, Json>;

/// Number of faults that are reported one by one. More are only counted: the file may be of another kind.
const MOST_FAULTS: usize = 100;

/// Every fault of `written` that the schema shows.
pub(crate) fn check(written: &Written) -> Vec<Diagnostic> {
    let mut check = Check { written, found: Vec::new(), more: 0 };
    if let Some(root) = schema().as_object() {
        check.value(&written.tree.root, root, &Path::default());
    }
    if check.more > 0 {
        let end = written.source.text.len();
        let place = Place::File { source: written.source.clone(), span: end..end };
        check.found.push(Diagnostic::new("", format!("and {} more faults", check.more), Some(place)));
    }
    check.found
}

struct Check<'a> {
    written: &'a Written,
    found: Vec<Diagnostic>,
    /// Number of faults that are counted but not reported.
    more: usize,
}

impl Check<'_> {
    fn value(&mut self, node: &Node, schema: &Schema, path: &Path) {
        if let Some(kind) = schema.get("x-dimension").and_then(Json::as_str).and_then(Kind::named) {
            self.quantity(node, kind, schema, path);
        } else if let Some(variants) = variants(schema) {
            self.variant(node, &variants, schema, path);
        } else if let Some(choices) = choices(schema) {
            self.choice(node, &choices, path);
        } else {
            match (schema.get("type").and_then(Json::as_str), &node.value) {
                (Some("object"), Value::Table(table)) => self.table(table, schema, path),
                (Some("array"), Value::Array(elements)) => self.array(elements, schema, path),
                (Some("integer"), Value::Integer(number)) if Interval::from_schema(schema).contains(*number as f64) => {
                }
                (Some("string"), Value::String(_)) | (Some("boolean"), Value::Boolean(_)) => {}
                (expected, found) => {
                    let expected = describe(expected, schema);
                    self.at_value(path, format!("expected {expected}, found {}", found.describe()), None);
                }
            }
        }
    }

    fn quantity(&mut self, node: &Node, kind: &Kind, schema: &Schema, path: &Path) {
        let interval = Interval::from_schema(schema);
        let word = schema.get("x-word").and_then(Json::as_str);
        let read = match &node.value {
            Value::String(text) if word == Some(text) => return,
            Value::String(text) => kind.read_text(text, &interval).map_err(|error| error.to_string()),
            Value::Integer(number) => kind.read_number(*number as f64, &interval).map_err(|error| error.to_string()),
            Value::Float(number) => kind.read_number(*number, &interval).map_err(|error| error.to_string()),
            other => Err(format!("expected {}, found {}", kind.expected(&interval), other.describe())),
        };
        let bare = match node.value {
            Value::Integer(number) => Some(number as f64),
            Value::Float(number) => Some(number),
            _ => None,
        };
        let degrees = bare.filter(|number| kind.name == "angle" && number.abs() > TAU);
        let in_degrees = degrees.map(|number| format!("a bare number is in radians; write \"{number} deg\""));
        match (read, in_degrees) {
            (Err(message), help) => {
                self.at_value(path, message, help.or(word.map(|word| format!("or write {word:?}"))));
            }
            (Ok(_), Some(help)) => {
                let message = format!("expected {}, found more than a turn", kind.expected(&interval));
                self.at_value(path, message, Some(help));
            }
            (Ok(_), None) => {}
        }
    }

    /// Checks a table that holds one of several tables, and keys that are allowed beside any of them.
    fn variant(&mut self, node: &Node, variants: &[(&str, &Schema)], schema: &Schema, path: &Path) {
        let tables: Vec<String> = variants.iter().map(|(name, _)| format!("[{}]", path.key(name))).collect();
        let expected = match tables.as_slice() {
            [only] => only.clone(),
            several => format!("one of {}", several.join(", ")),
        };
        let Value::Table(table) = &node.value else {
            let message = format!("expected {expected}, found {}", node.value.describe());
            return self.at_value(path, message, None);
        };
        let beside = schema.get("properties").and_then(Json::as_object);
        let known = || variants.iter().map(|(name, _)| *name);
        let mut first: Option<&str> = None;
        let mut has_unknown_key = false;
        for entry in &table.0 {
            let here = path.key(&entry.key);
            if let Some(content) = beside.and_then(|beside| beside.get(&entry.key)?.as_object()) {
                self.value(&entry.node, content, &here);
                continue;
            }
            match (variants.iter().find(|(name, _)| *name == entry.key), first) {
                (None, _) => {
                    has_unknown_key = true;
                    let help = match entry.node.value.as_text() {
                        Some(kind) if entry.key == "type" || entry.key == "kind" => {
                            let kind = nearest(kind, known());
                            let table = kind.map_or(expected.clone(), |kind| format!("[{}]", path.key(&kind)));
                            Some(format!("the kind is the name of a table: write {table}"))
                        }
                        _ => None,
                    };
                    let beside = beside.into_iter().flat_map(|beside| beside.keys().map(String::as_str));
                    self.unknown_key(&here, &entry.key, known().chain(beside).collect(), help);
                }
                (Some((name, schema)), None) => {
                    first = Some(name);
                    self.value(&entry.node, schema, &here);
                }
                (Some((_, schema)), Some(first)) => {
                    let message = format!("expected only one of these tables, found `{first}` and `{}`", entry.key);
                    let help =
                        format!("an override can replace the whole table: --set '{path}={{{} = {{...}}}}'", entry.key);
                    self.found.push(self.written.at_key(&here, message).with_help(help));
                    self.value(&entry.node, schema, &here);
                }
            }
        }
        if first.is_none() && !has_unknown_key {
            let found = if table.0.is_empty() { "an empty table" } else { "none" };
            self.at_value(path, format!("expected {expected}, found {found}"), None);
        }
    }

    fn choice(&mut self, node: &Node, choices: &[&str], path: &Path) {
        let text = node.value.as_text();
        if text.is_some_and(|text| choices.contains(&text)) {
            return;
        }
        let listed: Vec<String> = choices.iter().map(|choice| format!("{choice:?}")).collect();
        let near = text.and_then(|text| nearest(text, choices)).map(|near| vec![near]);
        // a part of a name, such as a fibre, finds the names that have it
        let with_it = |text: &str| {
            let part = text.to_lowercase();
            let named = choices.iter().filter(|choice| part.len() > 2 && choice.to_lowercase().contains(&part));
            named.map(|choice| (*choice).to_owned()).collect::<Vec<_>>()
        };
        let near = near.or_else(|| text.map(with_it)).filter(|near| !near.is_empty());
        let help = near.map(|near| format!("did you mean \"{}\"?", near.join("\" or \"")));
        self.at_value(path, format!("expected {}, found {}", listed.join(" or "), node.value.describe()), help);
    }

    fn array(&mut self, elements: &[Node], schema: &Schema, path: &Path) {
        let Some(items) = schema.get("items").and_then(Json::as_object) else { return };
        let count = |keyword: &str| schema.get(keyword).and_then(Json::as_u64);
        if let Some(count) = count("minItems").filter(|least| Some(*least) == count("maxItems"))
            && elements.len() as u64 != count
        {
            self.at_value(path, format!("expected {count} values, found {}", elements.len()), None);
        }
        for (index, element) in elements.iter().enumerate() {
            self.value(element, items, &path.index(index));
        }
    }

    fn table(&mut self, table: &Table, schema: &Schema, path: &Path) {
        // a table whose keys are names that the user chooses
        if let Some(named) = schema.get("additionalProperties").and_then(Json::as_object) {
            for entry in &table.0 {
                self.value(&entry.node, named, &path.key(&entry.key));
            }
            return;
        }
        let empty = Schema::new();
        let properties = schema.get("properties").and_then(Json::as_object).unwrap_or(&empty);
        let known: Vec<&str> = properties.keys().map(String::as_str).collect();
        let mut misspelt = Vec::new();
        for entry in &table.0 {
            let here = path.key(&entry.key);
            match properties.get(&entry.key).and_then(Json::as_object) {
                Some(content) => self.value(&entry.node, content, &here),
                None if self.found.len() >= MOST_FAULTS => self.more += 1,
                None => {
                    misspelt.extend(nearest(&entry.key, &known));
                    self.unknown_key(&here, &entry.key, known.clone(), None);
                }
            }
        }
        // a required key that is only misspelt has been reported already
        let needed = strings(schema.get("required")).chain(least_alternative(schema, table));
        let missing = needed.filter(|key| table.get(key).is_none());
        for key in missing.filter(|key| !misspelt.iter().any(|meant| meant == key)) {
            let content = properties.get(key).and_then(Json::as_object).unwrap_or(&empty);
            let help = expected_at(&path.key(key), key, content);
            self.at_value(&path.key(key), format!("missing key `{key}`"), Some(help));
        }
        // keys that exclude each other: one set in `not`, or several in `allOf`
        let several = schema.get("allOf").and_then(Json::as_array).into_iter().flatten().map(|rule| rule.get("not"));
        for excluded in several.chain([schema.get("not")]).flatten() {
            let exclusive: Vec<&str> = strings(excluded.get("required")).collect();
            if !exclusive.is_empty() && exclusive.iter().all(|key| table.get(key).is_some()) {
                let written_last = table.keys().filter(|key| exclusive.contains(key)).last().unwrap_or_default();
                let message = format!("expected only one of `{}`", exclusive.join("` and `"));
                self.found.push(self.written.at_key(&path.key(written_last), message));
            }
        }
    }

    fn unknown_key(&mut self, path: &Path, key: &str, known: Vec<&str>, help: Option<String>) {
        if self.found.len() >= MOST_FAULTS {
            return self.more += 1;
        }
        if is_reserved(&path.to_string()) {
            let message = format!("`{path}` is not available in this version yet");
            return self.found.push(self.written.at_key(path, message));
        }
        let listed = || format!("known here: {}", known.join(", "));
        let ours =
            OTHER_WORDS.iter().filter(|(word, ours)| *word == key && known.contains(ours)).map(|(_, ours)| *ours);
        let ours: Vec<&str> = ours.collect();
        let help = help.or_else(|| {
            let of_muzzle = key == "height" && path.parent().to_string() == "launch";
            let elsewhere = of_muzzle.then(|| {
                "the muzzle is at height 0; `environment.ground.height = \"-2 m\"` puts the ground 2 m below it"
                    .to_owned()
            });
            elsewhere
                .or((!ours.is_empty()).then(|| format!("netcast calls it `{}`; {}", ours.join("` or `"), listed())))
        });
        let help = help.unwrap_or_else(|| match (nearest(key, &known), find_key(schema(), key).as_slice()) {
            (Some(near), _) => format!("did you mean `{near}`? {}", listed()),
            (None, []) => listed(),
            (None, elsewhere) => format!("it exists at {}; {}", elsewhere.join(", "), listed()),
        });
        self.found.push(self.written.at_key(path, format!("unknown key `{key}`")).with_help(help));
    }

    fn at_value(&mut self, path: &Path, message: String, help: Option<String>) {
        if self.found.len() >= MOST_FAULTS {
            return self.more += 1;
        }
        self.found.push(self.written.at_value(path, message).with_help_if(help));
    }
}

/// Words that people write, and keys that they may mean.
const OTHER_WORDS: [(&str, &str); 13] = [
    ("speed", "axial_speed"),
    ("velocity", "axial_speed"),
    ("angle", "elevation"),
    ("pitch", "elevation"),
    ("direction", "azimuth"),
    ("heading", "azimuth"),
    ("splay", "spread"),
    ("weight", "mass"),
    ("bullet", "tractor"),
    ("bullets", "tractor"),
    ("projectile", "tractor"),
    ("thickness", "diameter"),
    ("stiffness", "axial_stiffness"),
];

/// The keys that `table` lacks of the alternative sets of keys in `schema`, such as a material or its values: the
/// last set where no set is complete, else nothing.
fn least_alternative<'s>(schema: &'s Schema, table: &Table) -> Vec<&'s str> {
    let sets = schema.get("anyOf").and_then(Json::as_array).into_iter().flatten();
    let sets: Vec<Vec<&str>> = sets.map(|set| strings(set.get("required")).collect()).collect();
    if sets.iter().any(|set| set.iter().all(|key| table.get(key).is_some())) {
        Vec::new()
    } else {
        sets.last().cloned().unwrap_or_default()
    }
}

fn strings(list: Option<&Json>) -> impl Iterator<Item = &str> {
    list.and_then(Json::as_array).into_iter().flatten().filter_map(Json::as_str)
}

/// What a key takes whose value is not a quantity, in words.
fn describe(kind: Option<&str>, schema: &Schema) -> String {
    match kind {
        Some("object") => "a table".to_string(),
        Some("array") => "an array".to_string(),
        Some("string") => "a string".to_string(),
        Some("boolean") => "true or false".to_string(),
        Some("integer") => {
            let bounds = Interval::from_schema(schema).describe(Default::default());
            format!("a whole number {bounds}").trim_end().to_string()
        }
        _ => "something else".to_string(),
    }
}

/// What a missing key takes, as a help.
fn expected_at(path: &Path, key: &str, schema: &Schema) -> String {
    if let Some(kind) = schema.get("x-dimension").and_then(Json::as_str).and_then(Kind::named) {
        return format!("`{key}` is {}", kind.expected(&Interval::from_schema(schema)));
    }
    match variants(schema) {
        Some(variants) => {
            let tables: Vec<String> = variants.iter().map(|(name, _)| format!("[{}]", path.key(name))).collect();
            format!("write one of {}", tables.join(", "))
        }
        None if schema.get("type").and_then(Json::as_str) == Some("object") => format!("write [{path}]"),
        None => format!("`{key}` is {}", describe(schema.get("type").and_then(Json::as_str), schema)),
    }
}

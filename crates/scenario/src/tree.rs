//! A scenario as a tree of TOML values, each with its place in the text.

use std::ops::Range;

use toml::de::{DeTable, DeValue};
use toml::value::Datetime;

use crate::path::{Path, Step};

/// Number of lines that are reported as not TOML. More are only counted: the file may be of another kind.
const MOST_FAULTS: usize = 20;

/// Where a key or value was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// In the scenario's file, at these bytes.
    File(Range<usize>),
    /// In the override with this index in the list.
    Override(usize),
}

/// A value and where it was written.
#[derive(Clone, Debug)]
pub struct Node {
    /// Where it was written.
    pub origin: Origin,
    /// The value.
    pub value: Value,
}

/// A TOML value.
#[derive(Clone, Debug)]
pub enum Value {
    /// A string.
    String(String),
    /// A whole number.
    Integer(i64),
    /// A number with a point or an exponent.
    Float(f64),
    /// `true` or `false`.
    Boolean(bool),
    /// A date or a time, which no key of a scenario takes.
    Datetime(Datetime),
    /// An array.
    Array(Vec<Node>),
    /// A table.
    Table(Table),
}

/// The entries of a table, in the order they were written.
#[derive(Clone, Debug, Default)]
pub struct Table(pub Vec<Entry>);

/// A key, where it was written, and its value.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key.
    pub key: String,
    /// Where the key was written.
    pub origin: Origin,
    /// Its value.
    pub node: Node,
}

impl Table {
    /// The value of `key`.
    pub fn get(&self, key: &str) -> Option<&Node> {
        self.entry(key).map(|entry| &entry.node)
    }

    /// The entry of `key`.
    pub fn entry(&self, key: &str) -> Option<&Entry> {
        self.0.iter().find(|entry| entry.key == key)
    }

    /// The keys, in the order they were written.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|entry| entry.key.as_str())
    }
}

impl Value {
    /// The value in words, for a message: `the string "2.5 m"`, `a table`.
    pub fn describe(&self) -> String {
        match self {
            Self::String(text) => format!("the string {text:?}"),
            Self::Integer(number) => format!("the number {number}"),
            Self::Float(number) => format!("the number {number:?}"),
            Self::Boolean(value) => format!("{value}"),
            Self::Datetime(datetime) => format!("the date or time {datetime}"),
            Self::Array(_) => "an array".to_string(),
            Self::Table(_) => "a table".to_string(),
        }
    }

    /// The entries, if it is a table.
    pub fn as_table(&self) -> Option<&Table> {
        if let Self::Table(table) = self { Some(table) } else { None }
    }

    /// The text, if it is a string.
    pub fn as_text(&self) -> Option<&str> {
        if let Self::String(text) = self { Some(text) } else { None }
    }

    /// The elements, if it is an array.
    pub fn as_array(&self) -> Option<&[Node]> {
        if let Self::Array(elements) = self { Some(elements) } else { None }
    }

    pub(crate) fn from_toml(
        value: &DeValue<'_>,
        origin: &dyn Fn(Range<usize>) -> Origin,
        faults: &mut Vec<TreeFault>,
        at: &Origin,
    ) -> Self {
        match value {
            DeValue::String(text) => Self::String(text.to_string()),
            DeValue::Boolean(value) => Self::Boolean(*value),
            DeValue::Datetime(datetime) => Self::Datetime(*datetime),
            DeValue::Integer(digits) => match i64::from_str_radix(digits.as_str(), digits.radix()) {
                Ok(number) => Self::Integer(number),
                Err(_) => {
                    faults.push(TreeFault { origin: at.clone(), message: "a whole number must fit in 64 bits".into() });
                    Self::Integer(0)
                }
            },
            // "inf" and "nan" are floats in TOML; they are refused where a quantity is read
            DeValue::Float(digits) => Self::Float(digits.as_str().parse().unwrap_or(f64::NAN)),
            DeValue::Array(elements) => Self::Array(
                elements
                    .iter()
                    .map(|element| {
                        let here = origin(element.span());
                        Node { value: Self::from_toml(element.get_ref(), origin, faults, &here), origin: here }
                    })
                    .collect(),
            ),
            DeValue::Table(table) => Self::Table(table_from_toml(table, origin, faults)),
        }
    }

    /// The same value without its origins.
    pub fn to_toml(&self) -> toml::Value {
        match self {
            Self::String(text) => toml::Value::String(text.clone()),
            Self::Integer(number) => toml::Value::Integer(*number),
            Self::Float(number) => toml::Value::Float(*number),
            Self::Boolean(value) => toml::Value::Boolean(*value),
            Self::Datetime(datetime) => toml::Value::Datetime(*datetime),
            Self::Array(elements) => toml::Value::Array(elements.iter().map(|node| node.value.to_toml()).collect()),
            Self::Table(table) => toml::Value::Table(
                table.0.iter().map(|entry| (entry.key.clone(), entry.node.value.to_toml())).collect(),
            ),
        }
    }
}

fn table_from_toml(table: &DeTable<'_>, origin: &dyn Fn(Range<usize>) -> Origin, faults: &mut Vec<TreeFault>) -> Table {
    let entries = table.iter().map(|(key, value)| {
        let here = origin(value.span());
        Entry {
            key: key.get_ref().to_string(),
            origin: origin(key.span()),
            node: Node { value: Value::from_toml(value.get_ref(), origin, faults, &here), origin: here },
        }
    });
    Table(entries.collect())
}

/// A fault of a text that is not TOML.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TreeFault {
    /// Its place.
    pub origin: Origin,
    /// What is wrong.
    pub message: String,
}

/// The whole scenario as a tree.
#[derive(Clone, Debug)]
pub struct Tree {
    /// The table of the whole file.
    pub root: Node,
}

impl Tree {
    /// Reads TOML.
    ///
    /// # Errors
    /// The first fault of every line that is not TOML.
    pub fn parse(text: &str) -> Result<Self, Vec<TreeFault>> {
        let (table, errors) = DeTable::parse_recoverable(text);
        let mut faults: Vec<TreeFault> = Vec::new();
        let (mut line, mut counted_to, mut last_line, mut overflow) = (0, 0, None, 0);
        for error in errors {
            let span = error.span().unwrap_or(text.len()..text.len());
            // errors come in the order of the text, with few exceptions
            if span.start < counted_to {
                (line, counted_to) = (0, 0);
            }
            line += text.as_bytes()[counted_to..span.start.min(text.len())].iter().filter(|&&b| b == b'\n').count();
            counted_to = span.start.min(text.len());
            // further errors on a line follow from its first one
            if last_line.replace(line) == Some(line) {
                continue;
            }
            if faults.len() < MOST_FAULTS {
                faults.push(TreeFault { origin: Origin::File(span), message: error.message().to_string() });
            } else {
                overflow += 1;
            }
        }
        if overflow > 0 {
            let origin = Origin::File(text.len()..text.len());
            faults.push(TreeFault { origin, message: format!("and {overflow} more lines that are not TOML") });
        }
        let root = Value::Table(table_from_toml(table.get_ref(), &Origin::File, &mut faults));
        if faults.is_empty() {
            Ok(Self { root: Node { origin: Origin::File(0..0), value: root } })
        } else {
            Err(faults)
        }
    }

    /// The node at `path`.
    pub fn get(&self, path: &Path) -> Option<&Node> {
        path.0.iter().try_fold(&self.root, |node, step| child(node, step).map(|(_, child)| child))
    }

    /// `path`, with whole numbers turned into indices where the tree has arrays.
    pub fn resolve(&self, path: &Path) -> Path {
        let mut node = Some(&self.root);
        let steps = path.0.iter().map(|step| {
            let parent = node;
            node = parent.and_then(|parent| child(parent, step)).map(|(_, child)| child);
            match (parent.map(|parent| &parent.value), step) {
                (Some(Value::Array(_)), Step::Key(key)) => key.parse().map_or_else(|_| step.clone(), Step::Index),
                _ => step.clone(),
            }
        });
        Path(steps.collect())
    }

    /// The place of the value at `path`, or of its nearest parent in the text. For a table it is the place of its key.
    pub fn origin(&self, path: &Path) -> Origin {
        let mut node = &self.root;
        let mut origin = &node.origin;
        for step in &path.0 {
            let Some((key_origin, next)) = child(node, step) else { break };
            origin = match (&next.value, key_origin) {
                (Value::Table(_), Some(key_origin)) => key_origin,
                _ => &next.origin,
            };
            node = next;
        }
        origin.clone()
    }

    /// The place of the key at the end of `path`, or of its nearest parent in the text.
    pub fn key_origin(&self, path: &Path) -> Origin {
        let parent = self.get(&path.parent());
        match (parent.and_then(|parent| parent.value.as_table()), path.0.last()) {
            (Some(table), Some(Step::Key(key))) => {
                table.entry(key).map_or_else(|| self.origin(path), |entry| entry.origin.clone())
            }
            _ => self.origin(path),
        }
    }
}

/// The child of `node` at `step`, with the origin of its key where it has one.
fn child<'a>(node: &'a Node, step: &Step) -> Option<(Option<&'a Origin>, &'a Node)> {
    match (&node.value, step) {
        (Value::Table(table), Step::Key(key)) => table.entry(key).map(|entry| (Some(&entry.origin), &entry.node)),
        (Value::Array(elements), Step::Index(index)) => elements.get(*index).map(|element| (None, element)),
        (Value::Array(elements), Step::Key(key)) => {
            elements.get(key.parse::<usize>().ok()?).map(|element| (None, element))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text_at<'a>(text: &'a str, origin: &Origin) -> &'a str {
        match origin {
            Origin::File(span) => &text[span.clone()],
            Origin::Override(_) => panic!("not in the file"),
        }
    }

    #[test]
    fn keys_and_values_have_their_place_in_the_text() {
        let text = "[web.space]\nside = \"2.5 m\"\n[[tractors]]\ncorner = 3\n";
        let tree = Tree::parse(text).unwrap();
        assert_eq!(text_at(text, &tree.origin(&Path::parse("web.space.side"))), "\"2.5 m\"");
        assert_eq!(text_at(text, &tree.key_origin(&Path::parse("web.space.side"))), "side");
        assert_eq!(text_at(text, &tree.origin(&Path::parse("web.space.mesh"))), "space");
        assert_eq!(text_at(text, &tree.origin(&Path::parse("tractors[0].corner"))), "3");
    }

    #[test]
    fn every_broken_line_is_reported_once() {
        let faults = Tree::parse("a = \nb = 2\nc = = 3\nb = 4\n").unwrap_err();
        let lines: Vec<_> = faults
            .iter()
            .map(|fault| match &fault.origin {
                Origin::File(span) => span.start,
                Origin::Override(_) => unreachable!(),
            })
            .collect();
        assert_eq!(lines.len(), 3, "{faults:?}");
    }
}

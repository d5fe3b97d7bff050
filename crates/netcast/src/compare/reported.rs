//! Reads numbers on designs from another source: a paper, a test, another program.
//!
//! ```toml
//! source = "Drop test of 12 May"
//!
//! [square_net]                          # a design of the comparison
//! opening.area_max_time_s = 0.35        # a quantity of its summary.json, in the same unit
//! tension.max_where = "outline"
//! ```

use std::path::Path;
use std::sync::Arc;

use netcast_results::Dimension;
use netcast_results::comparison::{Reported, ReportedValue};
use netcast_scenario::path::Path as ValuePath;
use netcast_scenario::tree::{Origin, Table, Tree, Value};
use netcast_scenario::{Diagnostic, Place, Source, nearest};
use serde_json::Value as Json;

/// The key of the source's name, at the top of the file.
const SOURCE: &str = "source";

/// A file of reported numbers.
#[derive(Debug)]
pub(super) struct ReportedFile {
    pub reported: Reported,
    /// The text of the file.
    pub text: String,
}

/// A design that may have reported numbers.
pub(super) struct KnownDesign {
    pub name: String,
    /// The quantities of its summary; none where the summary could not be read, and any quantity may be reported.
    pub quantities: Option<Vec<KnownQuantity>>,
}

/// A quantity of a summary.
pub(super) struct KnownQuantity {
    /// Its path in the summary.
    pub path: String,
    pub kind: Kind,
}

/// The type of a reported value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Number,
    Text,
    /// A number or a text.
    Unknown,
}

impl Kind {
    /// The type of the values of a dimension.
    pub fn of(dimension: Dimension) -> Self {
        if dimension == Dimension::Text { Self::Text } else { Self::Number }
    }
}

impl ReportedFile {
    /// Reads a file and checks it against the designs.
    ///
    /// # Errors
    /// All mistakes in the file.
    pub(super) fn read(file: &Path, known: &[KnownDesign]) -> Result<Self, Vec<Diagnostic>> {
        let text = std::fs::read_to_string(file)
            .map_err(|error| vec![Diagnostic::new("", format!("cannot read {}: {error}", file.display()), None)])?;
        let source = Arc::new(Source { name: file.display().to_string(), text: text.clone() });
        let mut reader = Reader { source, known, reported: Reported::default(), found: Vec::new() };
        match Tree::parse(&text) {
            Ok(tree) => reader.read_root(&tree),
            Err(faults) => {
                for fault in &faults {
                    reader.report("", &fault.message, &fault.origin, None);
                }
            }
        }
        if reader.found.is_empty() { Ok(Self { reported: reader.reported, text }) } else { Err(reader.found) }
    }
}

/// Reads the values of a file and collects its mistakes.
struct Reader<'k> {
    source: Arc<Source>,
    known: &'k [KnownDesign],
    reported: Reported,
    found: Vec<Diagnostic>,
}

impl Reader<'_> {
    /// Reads the top of the file: the source, and a table for each design.
    fn read_root(&mut self, tree: &Tree) {
        let Some(table) = tree.root.value.as_table() else { return };
        match table.get(SOURCE).map(|node| (&node.value, &node.origin)) {
            Some((Value::String(text), _)) => self.reported.source = text.clone(),
            Some((other, origin)) => {
                self.report(SOURCE, &format!("expected a text, found {}", other.describe()), origin, None);
            }
            None => {
                let help = "write source = \"...\": where the numbers come from";
                self.report("", "missing key `source`", &tree.root.origin, Some(help.into()));
            }
        }
        for entry in table.0.iter().filter(|entry| entry.key != SOURCE) {
            let path = ValuePath::default().key(&entry.key);
            match (self.known.iter().find(|known| known.name == entry.key), &entry.node.value) {
                (Some(known), Value::Table(quantities)) => self.read_design(known, quantities, &path),
                (Some(_), other) => {
                    let message = format!("expected a table of quantities, found {}", other.describe());
                    self.report(&path.to_string(), &message, &entry.node.origin, None);
                }
                (None, _) => {
                    let names: Vec<&str> = self.known.iter().map(|known| &known.name[..]).collect();
                    let near = nearest(&entry.key, &names).map(|near| format!("did you mean `{near}`? "));
                    let help = format!("{}compared here: {}", near.unwrap_or_default(), names.join(", "));
                    let message = format!("no design is called `{}`", entry.key);
                    self.report(&path.to_string(), &message, &entry.origin, Some(help));
                }
            }
        }
    }

    /// Reads the quantities of a design from `table`; `path` is that of the table, whose first step names the design.
    fn read_design(&mut self, known: &KnownDesign, table: &Table, path: &ValuePath) {
        for entry in &table.0 {
            let here = path.key(&entry.key);
            if let Value::Table(inner) = &entry.node.value {
                self.read_design(known, inner, &here);
                continue;
            }
            let quantity = ValuePath(here.0[1..].to_vec()).to_string();
            let kind = match &known.quantities {
                None => Kind::Unknown,
                Some(all) => match all.iter().find(|known| known.path == quantity) {
                    Some(known) => known.kind,
                    None => {
                        let near = nearest_quantity(&quantity, all.iter().map(|known| &known.path[..]));
                        let message = format!("`{quantity}` is no quantity of its summary.json");
                        let help = near.map(|near| format!("did you mean `{near}`?"));
                        self.report(&here.to_string(), &message, &entry.origin, help);
                        continue;
                    }
                },
            };
            let value = match (&entry.node.value, kind) {
                (Value::Float(number), Kind::Number | Kind::Unknown) if number.is_finite() => Json::from(*number),
                (Value::Integer(number), Kind::Number | Kind::Unknown) => Json::from(*number),
                (Value::String(text), Kind::Text | Kind::Unknown) => Json::from(text.as_str()),
                (other, kind) => {
                    let expected =
                        if kind == Kind::Text { "a text" } else { "a number in the unit that the key names" };
                    let message = format!("expected {expected}, found {}", other.describe());
                    self.report(&here.to_string(), &message, &entry.node.origin, None);
                    continue;
                }
            };
            self.reported.values.push(ReportedValue { design: known.name.clone(), quantity, value });
        }
    }

    /// Adds a mistake.
    fn report(&mut self, path: &str, message: &str, origin: &Origin, help: Option<String>) {
        let place = match origin {
            Origin::File(span) => Some(Place::File { source: self.source.clone(), span: span.clone() }),
            Origin::Override(_) => None,
        };
        self.found.push(Diagnostic { help, ..Diagnostic::new(path, message, place) });
    }
}

/// The known quantity nearest to a path: the only one with the same last key, or else the one with the fewest changed
/// letters.
fn nearest_quantity<'q>(path: &str, known: impl Iterator<Item = &'q str> + Clone) -> Option<String> {
    let last = |path: &str| path.rsplit('.').next().unwrap_or_default().to_owned();
    let same_end: Vec<&str> = known.clone().filter(|known| last(known) == last(path)).collect();
    match same_end[..] {
        [only] => Some(only.to_owned()),
        _ => nearest(path, known),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use netcast_scenario::Diagnostics;

    fn read(text: &str) -> Result<Reported, Vec<String>> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("reported.toml");
        std::fs::write(&file, text).unwrap();
        let quantities = [
            ("opening.area_max_time_s", Kind::Number),
            ("opening.area_max_m2", Kind::Number),
            ("tension.max_where", Kind::Text),
            ("tension.max_n", Kind::Number),
            ("tension.by_class.\"rope hexagon\".max_n", Kind::Number),
        ];
        let quantities = quantities.map(|(path, kind)| KnownQuantity { path: path.into(), kind }).into();
        let known = [
            KnownDesign { name: "ring".into(), quantities: Some(quantities) },
            KnownDesign { name: "star".into(), quantities: None },
        ];
        // in the order of the file
        let lines = |faults: Vec<Diagnostic>| {
            let text = Diagnostics::fail_if_any(faults).unwrap_err().to_string();
            text.split('\n').map(|line| line.split_once("reported.toml:").unwrap().1.to_owned()).collect()
        };
        ReportedFile::read(&file, &known).map(|file| file.reported).map_err(lines)
    }

    #[test]
    fn numbers_and_texts_are_read_by_design_and_path() {
        let reported = read(
            "source = \"a test\"\n[ring]\nopening.area_max_time_s = 0.12\ntension.max_where = \"outline\"\n\
             tension.by_class.\"rope hexagon\".max_n = 5\n[star]\nanything.goes_n = 1.5\n",
        )
        .unwrap();
        assert_eq!(reported.source, "a test");
        let values: Vec<String> =
            reported.values.iter().map(|v| format!("{} {} {}", v.design, v.quantity, v.value)).collect();
        assert_eq!(
            values,
            [
                "ring opening.area_max_time_s 0.12",
                "ring tension.max_where \"outline\"",
                "ring tension.by_class.\"rope hexagon\".max_n 5",
                "star anything.goes_n 1.5",
            ]
        );
    }

    #[test]
    fn every_mistake_is_reported_with_its_place_and_the_nearest_name() {
        let faults = read(
            "[rinng]\nopening.area_max_m2 = 1\n[ring]\nopening.area_max_times_s = 0.1\narea_max_m2 = 3\n\
             opening.area_max_m2 = \"15 m^2\"\nopening.area_max_time_s = \"soon\"\n[star]\n",
        )
        .unwrap_err();
        let expected = [
            "1:1: missing key `source`",
            "1:2: rinng: no design is called `rinng` (did you mean `ring`? compared here: ring, star)",
            "4:9: ring.opening.area_max_times_s: `opening.area_max_times_s` is no quantity of its summary.json \
             (did you mean `opening.area_max_time_s`?)",
            "5:1: ring.area_max_m2: `area_max_m2` is no quantity of its summary.json \
             (did you mean `opening.area_max_m2`?)",
            "6:23: ring.opening.area_max_m2: expected a number in the unit that the key names, found the string",
            "7:27: ring.opening.area_max_time_s: expected a number in the unit that the key names, found the string",
        ];
        assert_eq!(faults.len(), expected.len(), "{faults:#?}");
        for (found, expected) in faults.iter().zip(expected) {
            assert!(found.starts_with(expected), "{found}\nis not\n{expected}");
        }
    }

    #[test]
    fn malformed_toml_is_reported_with_its_line() {
        assert!(read("source = \n").unwrap_err()[0].starts_with("1:"));
    }
}

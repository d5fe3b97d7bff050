//! Puts values of the library into the tree of a scenario, in tables that have `material` and lack the value.

use schemars::{Schema, SchemaGenerator, json_schema};

use super::{Fibre, RopeMaterial, library, three_digits};
use crate::dimension::unit;
use crate::interval::Positive;
use crate::path::Path;
use crate::per_length::read;
use crate::quantity::{Density, Force};
use crate::tree::{Entry, Node, Table, Tree, Value};

/// A value that the library supplies to a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Taken {
    /// Its table, such as `ropes.border`.
    pub table: String,
    /// The name in the library.
    pub material: String,
    /// The key of the value.
    pub key: &'static str,
    /// The value, as a scenario writes it.
    pub value: String,
    /// Short names of its sources in [`super::Library::sources`].
    pub sources: Vec<String>,
}

/// The values that the library supplies to a scenario.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FromLibrary {
    /// The values, in the order of the scenario.
    pub taken: Vec<Taken>,
    /// Tables with a material whose values are all written beside it, so that the material has no effect.
    pub idle: Vec<String>,
}

impl FromLibrary {
    /// Notes to the user about materials that have no effect.
    pub fn notes(&self) -> Vec<String> {
        let note = |table: &String| format!("{table}.material changes nothing: all its values are written beside it");
        self.idle.iter().map(note).collect()
    }

    /// The values as comments, for the top of a scenario in which they are written out. Empty where there are none.
    pub fn comments(&self) -> String {
        let line = |one: &Taken| {
            let Taken { table, material, key, value, sources } = one;
            format!("# [{table}] {material}: {key} = {value} ({})\n", sources.join(", "))
        };
        let lines: String = self.taken.iter().map(line).collect();
        if lines.is_empty() {
            lines
        } else {
            format!("# From the library of materials; its sources are in docs/materials.md:\n{lines}\n")
        }
    }
}

/// Fills in the values that are not written, and returns them. Unknown names are skipped: the check of the schema
/// reports them.
pub(crate) fn fill(tree: &mut Tree) -> FromLibrary {
    let mut filled = FromLibrary::default();
    let Value::Table(root) = &mut tree.root.value else { return filled };
    for Entry { key, node, .. } in &mut root.0 {
        let Value::Table(table) = &mut node.value else { continue };
        let path = Path::default().key(key);
        match &key[..] {
            "rope" => filled.fill(table, &path, rope),
            "ropes" => filled.fill_each(table, &path, rope),
            "canopy" => filled.fill_each(table, &path, cloth),
            _ => {}
        }
    }
    filled
}

/// Key, value and sources of a value of a material.
type Known = (&'static str, String, Vec<String>);
/// Looks up the values of the material of this name for a table.
type Lookup = fn(&str, &Table) -> Option<Vec<Known>>;

impl FromLibrary {
    fn fill_each(&mut self, tables: &mut Table, path: &Path, lookup: Lookup) {
        for Entry { key, node, .. } in &mut tables.0 {
            if let Value::Table(table) = &mut node.value {
                self.fill(table, &path.key(key), lookup);
            }
        }
    }

    fn fill(&mut self, table: &mut Table, path: &Path, lookup: Lookup) {
        let Some(Node { origin, value }) = table.get("material").cloned() else { return };
        let Some((material, known)) = value.as_text().and_then(|name| Some((name, lookup(name, table)?))) else {
            return;
        };
        let before = self.taken.len();
        for (key, value, sources) in known {
            if table.get(key).is_none() {
                let node = Node { origin: origin.clone(), value: Value::String(value.clone()) };
                table.0.push(Entry { key: key.into(), origin: origin.clone(), node });
                self.taken.push(Taken { table: path.to_string(), material: material.to_owned(), key, value, sources });
            }
        }
        if self.taken.len() == before {
            self.idle.push(path.to_string());
        }
    }
}

fn rope(name: &str, table: &Table) -> Option<Vec<Known>> {
    let material = library().ropes.get(name)?;
    let density = Density::<Positive>::constant(material.nominal_density());
    let modulus = gigapascals(material.nominal_elastic_modulus());
    let mut known = vec![
        ("density", density.to_string(), material.density.sources.clone()),
        ("elastic_modulus", modulus, material.modulus_sources().to_vec()),
    ];
    known.extend(strength(material, table));
    Some(known)
}

/// A modulus, Pa, as text in GPa.
fn gigapascals(modulus: f64) -> String {
    format!("{} GPa", three_digits(1e-9 * modulus))
}

/// The breaking load, which follows from the diameter. `None` where the diameter cannot be read; the check reports
/// that.
fn strength(material: &RopeMaterial, table: &Table) -> Option<Known> {
    let diameter = read::<unit::Metre, Positive>(table.get("diameter")?)?;
    let load = Force::<Positive>::from_si(material.breaking_load(diameter)).ok()?;
    Some(("strength", load.to_string(), material.strength.sources.clone()))
}

fn cloth(name: &str, _: &Table) -> Option<Vec<Known>> {
    let material = library().cloths.get(name)?;
    let fibre: &Fibre = library().fibres.get(&material.fibre)?;
    Some(vec![
        ("density", fibre.density.value.to_string(), fibre.density.sources.clone()),
        ("elastic_modulus", gigapascals(material.elastic_modulus(fibre)), fibre.modulus_n_tex.sources.clone()),
    ])
}

/// The schema of `material` in a rope: one of the library's names.
pub(crate) fn rope_names(_: &mut SchemaGenerator) -> Schema {
    let names: Vec<&String> = library().ropes.keys().collect();
    json_schema!({ "type": "string", "enum": names })
}

/// The schema of `material` in a canopy: one of the library's names.
pub(crate) fn cloth_names(_: &mut SchemaGenerator) -> Schema {
    let names: Vec<&String> = library().cloths.keys().collect();
    json_schema!({ "type": "string", "enum": names })
}

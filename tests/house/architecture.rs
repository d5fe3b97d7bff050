//! ARCHITECTURE.md lists the imports that each crate may have. These tests compare it with the manifests.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Package};

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests are a folder of the repository")
}

fn metadata() -> Metadata {
    let manifest = repository().join("Cargo.toml");
    // dependencies are not resolved, so that no network is needed
    MetadataCommand::new().manifest_path(manifest).no_deps().exec().expect("cargo reads the workspace")
}

/// The name of a package in the documents: `webs` for `netcast-webs`.
fn short(package: &str) -> &str {
    package.strip_prefix("netcast-").unwrap_or(package)
}

/// Our crates by their names in the documents, each with our crates that it depends on outside its tests.
fn imports(metadata: &Metadata) -> BTreeMap<String, BTreeSet<String>> {
    let ours = metadata.workspace_packages();
    let names: BTreeSet<&str> = ours.iter().map(|package| package.name.as_str()).collect();
    let of = |package: &Package| {
        let needed = package.dependencies.iter().filter(|dependency| dependency.kind != DependencyKind::Development);
        needed.filter(|dependency| names.contains(&*dependency.name)).map(|d| short(&d.name).to_owned()).collect()
    };
    ours.iter().map(|package| (short(&package.name).to_owned(), of(package))).collect()
}

/// The table of ARCHITECTURE.md: each crate with the crates that it may import.
fn table() -> BTreeMap<String, BTreeSet<String>> {
    let text = std::fs::read_to_string(repository().join("ARCHITECTURE.md")).expect("there is an ARCHITECTURE.md");
    let rows = text.lines().skip_while(|line| !line.starts_with("| crate |")).skip(2);
    let mut table = BTreeMap::new();
    let mut above = BTreeSet::new();
    for row in rows.take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [name, _, may_import] = cells[..] else { panic!("a row of {} cells: {row}", cells.len()) };
        let name = name.trim_matches('`').to_owned();
        table.insert(name.clone(), allowed(may_import, &above));
        above.insert(name);
    }
    assert!(!table.is_empty(), "ARCHITECTURE.md has no table that begins with `| crate |`");
    table
}

/// The crates that a cell of the table names; `above` are the crates of the rows above. A program is not an import.
fn allowed(cell: &str, above: &BTreeSet<String>) -> BTreeSet<String> {
    let names = cell.split(',').map(str::trim).filter(|name| !name.ends_with("(as a program)"));
    let names = names.map(|name| name.split(" (").next().unwrap_or(name));
    names
        .flat_map(|name| match name {
            "nothing" => BTreeSet::new(),
            "all of the above" => above.clone(),
            _ => BTreeSet::from([name.to_owned()]),
        })
        .collect()
}

#[test]
fn the_table_lists_every_crate_and_no_other() {
    let (table, imports) = (table(), imports(&metadata()));
    assert_eq!(table.keys().collect::<Vec<_>>(), imports.keys().collect::<Vec<_>>());
    for (name, allowed) in &table {
        for import in allowed {
            assert!(table.contains_key(import), "the row of {name} names {import}, which is no crate");
        }
    }
}

#[test]
fn no_crate_imports_more_than_the_table_allows() {
    let table = table();
    for (name, imports) in imports(&metadata()) {
        let beyond: Vec<_> = imports.difference(&table[&name]).collect();
        assert!(beyond.is_empty(), "{name} may not import {beyond:?}");
    }
}

/// Geometry and numerics depend on no file format; serde alone is allowed.
#[test]
fn webs_and_dynamics_read_and_write_no_files() {
    let metadata = metadata();
    for package in metadata.workspace_packages() {
        if !["webs", "dynamics"].contains(&short(&package.name)) {
            continue;
        }
        let needed = package.dependencies.iter().filter(|dependency| dependency.kind != DependencyKind::Development);
        for dependency in needed {
            let formats = ["serde_json", "toml", "csv", "hdf5-pure", "schemars", "postcard"];
            assert!(!formats.contains(&&*dependency.name), "{} depends on {}", package.name, dependency.name);
        }
    }
}

//! Imports within a crate run one way: the modules of one folder import each other in no circle, and a module of `dynamics`
//! imports only modules that ARCHITECTURE.md lists before it. A file and its own submodules may import each other. Unit tests
//! do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// A module by the names on its path from the root of the crate; the root is empty.
type Module = Vec<String>;

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests are a folder of the repository")
}

/// The crates in `crates/`, by name.
fn crates() -> BTreeMap<String, PathBuf> {
    let folders = fs::read_dir(repository().join("crates")).unwrap().map(|entry| entry.unwrap().path());
    let name = |folder: &Path| folder.file_name().unwrap().to_string_lossy().into_owned();
    folders.map(|folder| (name(&folder), folder.join("src"))).collect()
}

/// Every module of a crate with its text, without unit tests and comments.
fn modules(source: &Path) -> BTreeMap<Module, String> {
    let (mut modules, mut folders) = (BTreeMap::new(), vec![source.to_owned()]);
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let inside = path.strip_prefix(source).unwrap().with_extension("");
                let mut module: Module = inside.iter().map(|name| name.to_string_lossy().into_owned()).collect();
                if ["mod", "lib", "main"].contains(&&module.last().unwrap()[..]) {
                    module.pop();
                }
                modules.entry(module).or_insert_with(String::new).push_str(&code(&fs::read_to_string(&path).unwrap()));
            }
        }
    }
    modules
}

/// The text of a file up to its unit tests, without comments.
fn code(text: &str) -> String {
    let text = text.split("\n#[cfg(test)]").next().unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// The paths in a text that begin with `crate::` or `super::`, with groups in braces expanded.
fn paths(text: &str) -> Vec<Vec<String>> {
    let mut paths = Vec::new();
    for start in ["crate::", "super::"] {
        for (at, _) in text.match_indices(start) {
            // `super::super::` is found at its first `super`
            let is_inside =
                text[..at].ends_with("::") || text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
            if !is_inside {
                read_path(&text[at..], &mut Vec::new(), &mut paths);
            }
        }
    }
    paths
}

/// Reads a path at the start of `text` that continues `before`, adds it to `paths`, and returns the rest of the text.
fn read_path<'t>(mut text: &'t str, before: &mut Vec<String>, paths: &mut Vec<Vec<String>>) -> &'t str {
    let depth = before.len();
    loop {
        let end = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
        if end > 0 {
            before.push(text[..end].to_owned());
        }
        text = &text[end..];
        let Some(next) = text.strip_prefix("::") else { break };
        text = next;
        if let Some(group) = text.strip_prefix('{') {
            text = group;
            while !text.is_empty() && !text.starts_with('}') {
                text = read_path(text.trim_start_matches([' ', '\n', ',']), before, paths);
                text = text.trim_start_matches([' ', '\n', ',', '*']);
            }
            before.truncate(depth);
            return text.strip_prefix('}').unwrap_or(text);
        }
    }
    paths.push(before.clone());
    before.truncate(depth);
    text
}

/// The module that a path in `module` names: the longest part of the path that is a module.
fn resolve(module: &Module, path: &[String], all: &BTreeMap<Module, String>) -> Module {
    let mut at = if path[0] == "crate" { Vec::new() } else { module.clone() };
    for name in path {
        match &name[..] {
            "crate" => {}
            "super" => {
                at.pop();
            }
            name => {
                at.push(name.to_owned());
                if !all.contains_key(&at) {
                    at.pop();
                    break;
                }
            }
        }
    }
    at
}

/// The imports among the modules of each folder, by the module of the folder.
fn imports(source: &Path) -> BTreeMap<Module, BTreeMap<String, BTreeSet<String>>> {
    let all = modules(source);
    let mut imports: BTreeMap<Module, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
    for (module, text) in &all {
        for path in paths(text) {
            let target = resolve(module, &path, &all);
            let same = module.iter().zip(&target).take_while(|(one, other)| one == other).count();
            if let (Some(one), Some(other)) = (module.get(same), target.get(same)) {
                let of_folder = imports.entry(module[..same].to_vec()).or_default();
                of_folder.entry(one.clone()).or_default().insert(other.clone());
            }
        }
    }
    imports
}

/// The modules that `from` imports, directly or not; it contains `from` only in a circle.
fn reached(from: &str, imports: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
    let (mut reached, mut open) = (BTreeSet::new(), vec![from.to_owned()]);
    while let Some(module) = open.pop() {
        for next in imports.get(&module).into_iter().flatten() {
            if reached.insert(next.clone()) {
                open.push(next.clone());
            }
        }
    }
    reached
}

#[test]
fn modules_of_a_folder_import_each_other_in_no_circle() {
    let mut circles = Vec::new();
    for (name, source) in crates() {
        for (folder, imports) in imports(&source) {
            let circle: Vec<&String> =
                imports.keys().filter(|module| reached(module, &imports).contains(*module)).collect();
            if !circle.is_empty() {
                circles.push(format!("{name}/src/{}: {circle:?}", folder.join("/")));
            }
        }
    }
    assert!(circles.is_empty(), "circles of modules:\n{}", circles.join("\n"));
}

/// The modules of `dynamics` in the order of ARCHITECTURE.md.
fn order() -> Vec<String> {
    let text = fs::read_to_string(repository().join("ARCHITECTURE.md")).unwrap();
    let rows = text.lines().skip_while(|line| !line.starts_with("| modules of `dynamics` |")).skip(2);
    let cells = rows.take_while(|line| line.starts_with('|')).map(|line| line.split('|').nth(1).unwrap_or_default());
    let names = cells.flat_map(|cell| cell.split(',')).map(|name| name.trim().trim_matches('`').to_owned());
    names.collect()
}

#[test]
fn modules_of_dynamics_import_only_modules_listed_before_them() {
    let (order, source) = (order(), crates()["dynamics"].clone());
    let place = |name: &str| order.iter().position(|other| other == name);
    let tops: BTreeSet<String> = modules(&source).into_keys().filter_map(|module| module.first().cloned()).collect();
    assert_eq!(tops, order.iter().cloned().collect(), "ARCHITECTURE.md does not list these modules");
    for (module, imported) in &imports(&source)[&Vec::new()] {
        let behind: Vec<&String> = imported.iter().filter(|import| place(import) >= place(module)).collect();
        assert!(behind.is_empty(), "{module} may not import {behind:?}, which stand behind it");
    }
}

#[test]
fn paths_are_read_with_groups_expanded() {
    let found = paths("use crate::a::{b, c::{d, E}, self};\nlet x = super::super::f::g(crate::h);");
    let joined: Vec<String> = found.iter().map(|path| path.join("::")).collect();
    let expected =
        ["crate::a::b", "crate::a::c::d", "crate::a::c::E", "crate::a::self", "crate::h", "super::super::f::g"];
    assert_eq!(joined, expected);
}

//! Markdown files of the repository: the length of lines, and links whose targets exist.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Longest line, characters; rows of tables and code blocks are exempt.
const LONGEST: usize = 160;

/// Folders that a build, a run or an editor leaves behind.
const NOT_OURS: [&str; 3] = ["target", "results", "node_modules"];

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests are a folder of the repository")
}

/// Every Markdown file below `folder`, except in hidden folders.
fn documents(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder that can be read") {
        let path = entry.expect("an entry that can be read").path();
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default().to_owned();
        if path.is_dir() && !name.starts_with('.') && !NOT_OURS.contains(&name.as_str()) {
            found.extend(documents(&path));
        } else if name.ends_with(".md") {
            found.push(path);
        }
    }
    found
}

/// The lines outside code blocks with their numbers. A code block is fenced, or indented after a blank line.
fn prose(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let (mut fenced, mut indented, mut blank) = (false, false, true);
    for (number, line) in text.lines().enumerate() {
        let fence = line.trim_start().starts_with("```");
        if fence {
            fenced = !fenced;
        }
        indented = line.starts_with("    ") && (blank || indented);
        blank = line.trim().is_empty();
        if !fence && !fenced && !indented && !blank {
            found.push((number + 1, line));
        }
    }
    found
}

/// `place: length` of each line that is too long.
fn long_lines(text: &str) -> Vec<String> {
    let lines = prose(text).into_iter().filter(|(_, line)| !line.starts_with('|'));
    let counted = lines.map(|(number, line)| (number, line.chars().count()));
    counted.filter(|(_, length)| *length > LONGEST).map(|(number, length)| format!("{number}: {length}")).collect()
}

/// The targets of all links and pictures, with the number of their line; inline code is left out.
fn links(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (number, line) in prose(text) {
        // text between two backticks is code
        let plain: String = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
        for part in plain.split("](").skip(1) {
            let target = part.split(')').next().unwrap_or_default();
            found.push((number, target.to_owned()));
        }
    }
    found
}

/// The anchors of headings: lower case, hyphens for spaces, without punctuation.
fn anchors(text: &str) -> BTreeSet<String> {
    let headings = prose(text).into_iter().filter(|(_, line)| line.starts_with('#'));
    let titles = headings.map(|(_, line)| line.trim_start_matches('#').trim().to_lowercase());
    let kept = |c: &char| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_');
    titles.map(|title| title.chars().filter(kept).collect::<String>().replace(' ', "-")).collect()
}

/// The fault of a relative link in a file of `folder`, if there is one; `own` is the text of that file.
fn fault(folder: &Path, own: &str, link: &str) -> Option<String> {
    if link.contains("://") {
        return None;
    }
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let path = folder.join(file);
    if !file.is_empty() && !path.exists() {
        return Some(format!("{link} does not exist"));
    }
    let text = if file.is_empty() { own.to_owned() } else { fs::read_to_string(&path).unwrap_or_default() };
    (!anchor.is_empty() && !anchors(&text).contains(anchor)).then(|| format!("{link} has no such heading"))
}

/// All faults that `look` finds in the documents, as `file:fault`.
fn faults(look: impl Fn(&Path, &str) -> Vec<String>) -> Vec<String> {
    let root = repository();
    let found = documents(root);
    assert!(found.iter().any(|path| path.ends_with("README.md")), "{} has no README.md", root.display());
    let mut wrong = Vec::new();
    for path in found {
        let text = fs::read_to_string(&path).expect("a document that can be read");
        let name = path.strip_prefix(root).expect("below the root").display().to_string();
        let folder = path.parent().expect("it is in a folder");
        wrong.extend(look(folder, &text).into_iter().map(|fault| format!("{name}:{fault}")));
    }
    wrong
}

#[test]
fn lines_of_documents_have_at_most_160_characters() {
    let wrong = faults(|_, text| long_lines(text));
    assert!(wrong.is_empty(), "longer than {LONGEST} characters:\n{}", wrong.join("\n"));
}

#[test]
fn links_of_documents_have_targets() {
    let wrong = faults(|folder, text| {
        let broken = links(text).into_iter().filter_map(|(number, link)| Some((number, fault(folder, text, &link)?)));
        broken.map(|(number, fault)| format!("{number}: {fault}")).collect()
    });
    assert!(wrong.is_empty(), "broken links:\n{}", wrong.join("\n"));
}

#[test]
fn a_long_line_is_found_in_prose_but_not_in_tables_or_code() {
    let long = "x".repeat(LONGEST + 1);
    let short = "é".repeat(LONGEST);
    let text = format!("{long}\n| {long} |\n\n    {long}\n\n```sh\n{long}\n```\n{short}\n* {long}\n");
    assert_eq!(long_lines(&text), ["1: 161", "10: 163"]);
}

#[test]
fn a_broken_link_is_found_unless_it_is_in_code() {
    let text = "# How fast, and `why`\n\n[a](b.md) ![c](d.png) `[e](f)`\n\n```\n[g](h)\n```\n[i](#how-fast-and-why)\n";
    let found = links(text);
    assert_eq!(found, [(3, "b.md".to_owned()), (3, "d.png".to_owned()), (8, "#how-fast-and-why".to_owned())]);
    let broken: Vec<bool> = found.iter().map(|(_, link)| fault(repository(), text, link).is_some()).collect();
    assert_eq!(broken, [true, true, false]);
    assert!(fault(repository(), text, "README.md#two-commands").is_none());
    assert!(fault(repository(), text, "README.md#three-commands").is_some());
}

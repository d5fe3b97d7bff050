//! `docs/theory/measures.md` lists every number of summary.json and history.csv as the table of quantities has it.
//!
//! `NETCAST_WRITE_DOCS=1 cargo test -p netcast-results --test measures_page` rewrites the lists.

use std::fs;
use std::path::Path;

use netcast_results::{Better, SECTIONS, columns};

const START: &str = "<!-- From the table of quantities; crates/results/tests/measures_page.rs writes it. -->\n";
const END: &str = "<!-- End of the lists. -->\n";

/// The lists that the page must have.
fn lists() -> String {
    let mut page = "\n### summary.json\n".to_owned();
    let mut last = "";
    for section in &SECTIONS {
        if section.title != last {
            page += &format!(
                "\n**{}**\n\n| key | name | unit | better | what it is |\n|---|---|---|---|---|\n",
                section.title
            );
            last = section.title;
        }
        // rows of single points differ from those of `points.*` only in name and direction of better
        for quantity in
            section.quantities().filter(|row| !row.parent.starts_with("points.") || row.path().contains('*'))
        {
            let better = match quantity.better {
                Some(Better::Lower) => "lower",
                Some(Better::Higher) => "higher",
                None => "",
            };
            let (path, unit, name) = (quantity.path(), quantity.dimension.unit(), quantity.name.replace("{}", "..."));
            page += &format!("| `{path}` | {name} | {unit} | {better} | {} |\n", cell(quantity.definition()));
        }
    }
    page += "\n### history.csv\n\n| column | unit | what it holds |\n|---|---|---|\n";
    for (column, of) in columns() {
        let (name, unit) = (column.name_of(of), column.dimension.unit());
        page += &format!("| `{name}` | {unit} | {} |\n", cell(column.definition));
    }
    page + "\n"
}

/// Text with its column separators escaped.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

#[test]
fn the_page_of_measures_lists_every_quantity() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/theory/measures.md");
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

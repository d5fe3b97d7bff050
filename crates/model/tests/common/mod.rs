//! Helper shared by the tests of this crate.

use std::path::Path;

use netcast_scenario::{Diagnostics, Document, Source};

/// Reads the scenario `text` under the name `net.toml`, with overrides as `--set` has them.
pub fn parse(text: &str, overrides: &[&str]) -> Result<Document, Diagnostics> {
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    Document::parse(Source { name: "net.toml".into(), text: text.into() }, Path::new(""), &overrides)
}

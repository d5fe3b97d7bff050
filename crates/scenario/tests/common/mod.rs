//! Functions that the tests of this crate share.

use std::path::Path;

use netcast_scenario::{Diagnostics, Document, Source};

/// A scenario with most sections.
#[allow(dead_code, reason = "not every test reads it")]
pub const CONTRACT: &str = include_str!("../contract.toml");

/// Reads a scenario named `net.toml` from its text.
pub fn parse(text: &str, overrides: &[&str]) -> Result<Document, Diagnostics> {
    let overrides: Vec<String> = overrides.iter().map(|text| text.to_string()).collect();
    Document::parse(Source { name: "net.toml".into(), text: text.into() }, Path::new(""), &overrides)
}

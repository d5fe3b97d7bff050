//! `[points]`: names for places of the web.

use netcast_scenario::{Diagnostics, is_plain};

use super::draft::Draft;

/// Checks the names of feature points and that the web has their nodes.
///
/// # Errors
/// A reserved name, a name with other characters, an unknown node.
pub fn check(draft: &mut Draft) -> Result<(), Diagnostics> {
    let (document, web) = (draft.document, &draft.cut.web);
    let mut found = Vec::new();
    for (name, id) in &draft.scenario.points {
        let path = format!("points.{name}");
        let why = match &name[..] {
            "tractor" | "corner" | "centre" => Some("is followed in every run already"),
            name if !is_plain(name) => Some("has other characters than letters, digits, spaces, `_`, `-` and `.`"),
            _ => None,
        };
        if let Some(why) = why {
            let message = format!("the feature point {name:?} {why}");
            found.push(document.diagnostic(&path, message).with_help("choose another name"));
        }
        if !web.points.contains_key(name) {
            found.push(document.diagnostic(&path, format!("unknown node {id:?}")));
        }
    }
    Diagnostics::fail_if_any(found)
}

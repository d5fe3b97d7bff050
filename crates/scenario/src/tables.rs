//! The tables of a scenario as they were written, found by their paths.

use crate::path::Path;
use crate::tree::Table;
use crate::written::Written;

/// The table at `path`; none where there is no such table.
pub(crate) fn table_at<'a>(written: &'a Written, path: &str) -> Option<&'a Table> {
    written.tree.get(&Path::parse(path)).and_then(|node| node.value.as_table())
}

/// The tables of all ropes, the default one last.
pub(crate) fn ropes(written: &Written) -> impl Iterator<Item = Path> {
    let named = table_at(written, "ropes").into_iter().flat_map(Table::keys);
    named.map(|name| Path::default().key("ropes").key(name)).chain([Path::default().key("rope")])
}

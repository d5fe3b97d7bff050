//! Finds tables of a scenario by their paths.

use crate::path::Path;
use crate::tree::Table;
use crate::written::Written;

/// The table at `path`. `None` where there is no such table.
pub(crate) fn table_at<'a>(written: &'a Written, path: &str) -> Option<&'a Table> {
    written.tree.get(&Path::parse(path)).and_then(|node| node.value.as_table())
}

/// The paths of the tables of all ropes, the default rope last.
pub(crate) fn ropes(written: &Written) -> impl Iterator<Item = Path> {
    let named = table_at(written, "ropes").into_iter().flat_map(Table::keys);
    named.map(|name| Path::default().key("ropes").key(name)).chain([Path::default().key("rope")])
}

//! Keys that are reserved for later versions. Messages say so, as they are not spelling mistakes.

const LATER: &[&str] = &["contact", "measured", "targets"];

/// Whether the key at `path` is reserved for a later version.
pub(crate) fn is_reserved(path: &str) -> bool {
    LATER.contains(&path)
}

#[cfg(test)]
mod tests {
    use super::LATER;
    use crate::path::Path;
    use crate::schema::{find_key, schema};

    #[test]
    fn no_reserved_key_exists_yet() {
        for path in LATER {
            let steps = Path::parse(path);
            let Some(crate::path::Step::Key(key)) = steps.0.last() else { panic!("{path}") };
            assert!(!find_key(schema(), key).contains(&path.to_string()), "{path}");
        }
    }
}

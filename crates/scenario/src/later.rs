//! Keys of the contract that this version does not know yet: named as such, so that nobody looks for a slip of the pen.

const LATER: &[&str] = &["contact", "measured", "targets"];

/// Whether the key at `path` is kept free for a later version.
pub(crate) fn is_kept_for_later(path: &str) -> bool {
    LATER.contains(&path)
}

#[cfg(test)]
mod tests {
    use super::LATER;
    use crate::path::Path;
    use crate::schema::{find_key, schema};

    #[test]
    fn what_is_kept_for_later_is_not_there_yet() {
        for path in LATER {
            let steps = Path::parse(path);
            let Some(crate::path::Step::Key(key)) = steps.0.last() else { panic!("{path}") };
            assert!(!find_key(schema(), key).contains(&path.to_string()), "{path}");
        }
    }
}

//! Escapes text for SVG.

use crate::format::escape;

/// Text escaped for an SVG file, with spaces for control characters, which XML does not allow.
pub(crate) fn text(content: &str) -> String {
    escape(&content.replace(char::is_control, " "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_and_control_characters_are_escaped() {
        assert_eq!(text("<b>\u{0} & \"net\"\n"), "&lt;b&gt;  &amp; &quot;net&quot; ");
    }
}

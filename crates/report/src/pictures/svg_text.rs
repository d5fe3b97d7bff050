//! Text within SVG.

use crate::format::escape;

/// Text for an SVG file. XML has no place for control characters.
pub(crate) fn text(content: &str) -> String {
    escape(&content.replace(char::is_control, " "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_may_hold_anything() {
        assert_eq!(text("<b>\u{0} & \"net\"\n"), "&lt;b&gt;  &amp; &quot;net&quot; ");
    }
}

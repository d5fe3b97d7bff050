//! Text of a user's, such as a title or a name, made safe to be shown.

/// `text` with a symbol for each control character but the end of a line. Such a character could clear a terminal, set
/// its title, or break a page.
pub fn visible(text: &str) -> String {
    let symbol = |character: char| match character {
        '\n' => character,
        '\u{7f}' => '\u{2421}',
        '\0'..='\u{1f}' => char::from_u32(0x2400 + u32::from(character)).unwrap_or('\u{fffd}'),
        other if other.is_control() => '\u{fffd}',
        other => other,
    };
    text.chars().map(symbol).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_control_character_is_left() {
        assert_eq!(visible("\u{1b}]0;x\u{7}\0 \u{7f}\u{9b}"), "\u{241b}]0;x\u{2407}\u{2400} \u{2421}\u{fffd}");
        assert_eq!(visible("two\nlines \u{e4}"), "two\nlines \u{e4}");
    }
}

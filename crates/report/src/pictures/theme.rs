//! The colours of the page, for pictures in files.
//!
//! Pictures within the page take their colours from the variables of `page.css`, so they follow its theme. Programs
//! other than browsers do not know variables, so a picture in a file has the light colours written out.

use super::colour::{BINS, bin_colour, hex};

const PAGE: &str = include_str!("../page/page.css");
const PICTURE: &str = include_str!("picture.css");

/// The CSS of pictures within a page.
pub(crate) fn page_style() -> String {
    format!("{PICTURE}{}", include_str!("sheet.css"))
}

/// The CSS of a picture in a file: every variable is replaced by its light value.
pub(crate) fn standalone_style() -> String {
    let (_, rules) = PICTURE.split_once("/* rules */").expect("the style says where its rules begin");
    let mut style = String::new();
    let mut rest = rules;
    while let Some((before, after)) = rest.split_once("var(") {
        let (name, after) = after.split_once(')').expect("the style closes its brackets");
        style.push_str(before);
        style.push_str(light(name));
        rest = after;
    }
    style + rest
}

/// The value of a variable in the light theme, such as `#1c2126` for `--ink`. It is the first in the style sheets.
pub(crate) fn light(name: &str) -> &'static str {
    let value = |style: &'static str| {
        let (_, after) = style.split_once(&format!("{name}:"))?;
        Some(after.split_once(';')?.0.trim())
    };
    value(PAGE).or_else(|| value(PICTURE)).expect("the styles define the variables that pictures use")
}

/// A variable of the light theme as red, green and blue.
pub(crate) fn light_rgb(name: &str) -> [u8; 3] {
    let digits = light(name).trim_start_matches('#');
    let channel = |from: usize| digits.get(from..from + 2).and_then(|pair| u8::from_str_radix(pair, 16).ok());
    [0, 2, 4].map(|from| channel(from).expect("a colour of six digits"))
}

/// The colour of a bin of tension in SVG; none for the slack ropes, index [`BINS`].
pub(crate) fn bin_stroke(bin: usize) -> Option<String> {
    (bin < BINS).then(|| hex(bin_colour(bin)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_style_of_a_file_has_values_for_all_variables() {
        let style = standalone_style();
        assert!(!style.contains("var(") && !style.contains("--"), "{style}");
        assert_eq!(light("--ink"), "#1c2126");
        assert_eq!(light_rgb("--slack"), [0xb3, 0xba, 0xc0]);
        for curve in 0..8 {
            light_rgb(&format!("--curve-{curve}"));
        }
    }
}

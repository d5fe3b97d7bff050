//! The page's colours, for pictures that stand alone.
//!
//! Pictures in the page follow its theme by the variables of `page.css`. A file of its own has the light ones written
//! out, which every program understands.

use super::colour::{BINS, bin_colour, hex};

const PAGE: &str = include_str!("../page/page.css");
const PICTURE: &str = include_str!("picture.css");

/// What a page needs to show pictures of nets.
pub(crate) fn page_style() -> String {
    format!("{PICTURE}{}", include_str!("sheet.css"))
}

/// The style of a picture that stands alone: every variable replaced by its light value.
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

/// The value of a variable in the light theme, such as `#1c2126` for `--ink`: the first that the styles give it.
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

/// The colour of a bin of tension in SVG.
pub(crate) fn bin_stroke(bin: usize) -> Option<String> {
    (bin < BINS).then(|| hex(bin_colour(bin)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_that_stand_alone_know_every_colour() {
        let style = standalone_style();
        assert!(!style.contains("var(") && !style.contains("--"), "{style}");
        assert_eq!(light("--ink"), "#1c2126");
        assert_eq!(light_rgb("--slack"), [0xb3, 0xba, 0xc0]);
        for curve in 0..8 {
            light_rgb(&format!("--curve-{curve}"));
        }
    }
}

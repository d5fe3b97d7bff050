//! Renders SVG to pixels. The font is embedded, so that every machine makes the same picture.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};

static OPTIONS: LazyLock<Options<'static>> = LazyLock::new(|| {
    let mut fonts = Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.set_sans_serif_family("DejaVu Sans");
    Options { fontdb: Arc::new(fonts), font_family: "DejaVu Sans".into(), ..Options::default() }
});

/// Renders an SVG that this crate drew, with `zoom` pixels for each of its own.
///
/// # Panics
/// Where `svg` is malformed, which is a fault of this crate.
pub(crate) fn pixels(svg: &str, zoom: f32) -> Pixmap {
    let tree = Tree::from_str(svg, &OPTIONS).expect("pictures are well-formed SVG");
    let size = tree.size().to_int_size().scale_by(zoom).expect("pictures have a size");
    let mut pixels = Pixmap::new(size.width(), size.height()).expect("pictures have a size");
    resvg::render(&tree, Transform::from_scale(zoom, zoom), &mut pixels.as_mut());
    pixels
}

/// Renders an SVG that this crate drew to the bytes of a PNG file, with `zoom` pixels for each of its own.
///
/// # Panics
/// Where `svg` is malformed, which is a fault of this crate.
pub(crate) fn png(svg: &str, zoom: f32) -> Vec<u8> {
    pixels(svg, zoom).encode_png().expect("memory takes everything")
}

//! A sheet of captioned pictures with one scale of length and one of colour, as HTML figures or as one SVG file.

use glam::{DVec2, DVec3};

use super::camera::{Camera, View};
use super::colour::{BINS, TensionScale};
use super::net_picture::{Labelling, NetPicture, extent};
use super::strands::Strands;
use super::svg_text::text;
use super::theme::{bin_stroke, standalone_style};
use crate::format::escape;
use crate::results::Scene;

/// Fonts of SVG files; `raster` embeds the first.
pub(crate) const FONT: &str = "DejaVu Sans, sans-serif";

/// Room around a net for its labels, and below it for the scale bar, px.
const MARGIN: DVec2 = DVec2::new(20.0, 22.0);

/// Least and largest height of a picture over its width.
const HEIGHT_RATIO: (f64, f64) = (0.5, 1.1);

/// Pictures with common scales.
pub(crate) struct Sheet<'a> {
    pub scene: &'a Scene,
    pub cells: Vec<Cell>,
    pub columns: usize,
    /// Width of a picture, px.
    pub width: f64,
    /// CSS class of the grid of pictures.
    pub class: &'static str,
    pub scale: TensionScale,
    /// Whether the key of the colours is shown.
    pub has_key: bool,
    /// World position to mark with a ring, m.
    pub mark: Option<DVec3>,
    /// Notes below the pictures, one line each.
    pub notes: Vec<String>,
}

/// A picture of a sheet.
pub(crate) struct Cell {
    pub frame: usize,
    pub view: View,
    pub name: String,
    pub caption: String,
}

impl Sheet<'_> {
    /// The pictures as figures of an HTML page.
    pub fn html(&self) -> String {
        let (strands, size, px_per_m) = self.prepared();
        let mut html = format!("<div class=\"net-sheet {}\">\n", self.class);
        for cell in &self.cells {
            let (name, caption) = (escape(&cell.name), escape(&cell.caption));
            html.push_str(&format!(
                "<figure><svg class=\"net\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{name}, {caption}\">",
                size.x, size.y
            ));
            self.draw(cell, &strands, size, px_per_m, &mut html);
            html.push_str(&format!("</svg><figcaption><b>{name}</b>{caption}</figcaption></figure>\n"));
        }
        html.push_str("</div>\n<div class=\"net-key\">");
        if self.has_key {
            let (width, height) = KEY_SIZE;
            html.push_str(&format!("<svg class=\"net\" viewBox=\"0 0 {width} {height}\">{}</svg>", key(&self.scale)));
        }
        for note in self.all_notes(&strands) {
            html.push_str(&format!("<p>{}</p>", escape(&note)));
        }
        html + "</div>\n"
    }

    /// The pictures as one SVG file with a title at the top.
    pub fn svg(&self, title: &str) -> String {
        const GAP: f64 = 16.0;
        const TOP: f64 = 44.0;
        const CAPTION: f64 = 40.0;
        const LINE: f64 = 17.0;
        let (strands, size, px_per_m) = self.prepared();
        let rows = self.cells.len().div_ceil(self.columns);
        let notes = self.all_notes(&strands);
        let step = size + DVec2::new(GAP, CAPTION + GAP);
        let width = 2.0 * GAP + self.columns as f64 * step.x - GAP;
        let below = TOP + rows as f64 * step.y;
        let key_height = if self.has_key { KEY_SIZE.1 + 10.0 } else { 0.0 };
        let height = below + key_height + LINE * notes.len() as f64 + 8.0;

        let mut svg = standalone(width, height);
        svg.push_str(&format!("<text class=\"title\" x=\"{GAP}\" y=\"28\">{}</text>\n", text(title)));
        for (place, cell) in self.cells.iter().enumerate() {
            let (column, row) = (place % self.columns, place / self.columns);
            let corner = DVec2::new(GAP, TOP) + step * DVec2::new(column as f64, row as f64);
            svg.push_str(&format!("<g transform=\"translate({} {})\">", corner.x, corner.y));
            self.draw(cell, &strands, size, px_per_m, &mut svg);
            let (name, caption) = (text(&cell.name), text(&cell.caption));
            svg.push_str(&format!(
                "<path class=\"rule\" d=\"M0 {0}H{1}\"/><text class=\"name\" x=\"0\" y=\"{2}\">{name}</text>\
                 <text class=\"soft\" x=\"0\" y=\"{3}\">{caption}</text></g>\n",
                size.y + 4.0,
                size.x,
                size.y + 20.0,
                size.y + 35.0
            ));
        }
        if self.has_key {
            svg.push_str(&format!("<g transform=\"translate({GAP} {below})\">{}</g>\n", key(&self.scale)));
        }
        for (line, note) in notes.iter().enumerate() {
            let y = below + key_height + LINE * line as f64 + 8.0;
            svg.push_str(&format!("<text class=\"soft\" x=\"{GAP}\" y=\"{y}\">{}</text>\n", text(note)));
        }
        svg + "</svg>\n"
    }

    /// The ropes, and the picture's size, px, and scale, px/m, at which the largest of the nets fits.
    fn prepared(&self) -> (Strands, DVec2, f64) {
        let extents = self.cells.iter().map(|cell| {
            let (least, most) = extent(self.scene, cell.frame, &self.camera(cell));
            most - least
        });
        let largest = extents.fold(DVec2::splat(1e-3), DVec2::max);
        let (size, px_per_m) = fitted(largest, self.width);
        (Strands::new(self.scene), size, px_per_m)
    }

    fn camera(&self, cell: &Cell) -> Camera {
        Camera::new(cell.view, self.scene.landmarks.axis)
    }

    fn draw(&self, cell: &Cell, strands: &Strands, size: DVec2, px_per_m: f64, svg: &mut String) {
        let camera = self.camera(cell);
        let (least, most) = extent(self.scene, cell.frame, &camera);
        let picture = NetPicture {
            scene: self.scene,
            strands,
            scale: &self.scale,
            camera,
            px_per_m,
            size,
            mark: self.mark,
            labelling: Labelling::Apart,
        };
        picture.draw(cell.frame, 0.5 * (least + most), svg);
    }

    /// The notes, with one on thinning where nodes are left out.
    fn all_notes(&self, strands: &Strands) -> Vec<String> {
        let thinned = "Drawn without some of the nodes inside ropes; each piece has the highest tension along it.";
        self.notes.iter().cloned().chain(strands.thinned.then(|| thinned.into())).collect()
    }
}

/// Size, px, and scale, px/m, of a picture of `width`, px, in which a net of `extent`, m, fits.
fn fitted(extent: DVec2, width: f64) -> (DVec2, f64) {
    let across = (width - 2.0 * MARGIN.x) / extent.x;
    let height_max = HEIGHT_RATIO.1 * width - 2.0 * MARGIN.y;
    let px_per_m = across.min(height_max / extent.y);
    let height = (extent.y * px_per_m + 2.0 * MARGIN.y).max(HEIGHT_RATIO.0 * width);
    (DVec2::new(width, height.round()), px_per_m)
}

/// The head of an SVG file with its style, on a white background; the caller closes the element.
pub(crate) fn standalone(width: f64, height: f64) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"net\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"{FONT}\">\n<style>{}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
        standalone_style()
    )
}

/// Width and height of the key of the colours, px.
pub(crate) const KEY_SIZE: (f64, f64) = (460.0, 46.0);

/// The key of the colours of tension as SVG.
pub(crate) fn key(scale: &TensionScale) -> String {
    const BOX: f64 = 32.0;
    const LEFT: f64 = 60.0;
    let mut svg = "<text x=\"0\" y=\"10\">tension of a rope, N</text><rect class=\"none\" y=\"17\" width=\"32\" \
                   height=\"10\"/><text class=\"soft\" x=\"16\" y=\"41\" text-anchor=\"middle\">slack</text>"
        .to_owned();
    for bin in 0..BINS {
        let colour = bin_stroke(bin).unwrap_or_default();
        let x = LEFT + BOX * bin as f64;
        svg.push_str(&format!("<rect x=\"{x}\" y=\"17\" width=\"{BOX}\" height=\"10\" fill=\"{colour}\"/>"));
    }
    for (place, &edge) in scale.edges().iter().enumerate() {
        let x = LEFT + BOX * place as f64;
        let label = short(edge);
        svg.push_str(&format!("<text class=\"soft\" x=\"{x}\" y=\"41\" text-anchor=\"middle\">{label}</text>"));
    }
    svg
}

/// A round number in few letters: `200`, `5k`, `1M`.
fn short(number: f64) -> String {
    match number {
        large if large >= 1e6 => format!("{}M", large / 1e6),
        large if large >= 1e3 => format!("{}k", large / 1e3),
        small => small.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_net_fits_its_picture_in_both_directions() {
        for extent in [DVec2::new(8.0, 3.0), DVec2::new(1.0, 30.0), DVec2::new(50.0, 0.001), DVec2::new(3.0, 3.0)] {
            let (size, px_per_m) = fitted(extent, 300.0);
            assert!((extent * px_per_m).cmple(size - 2.0 * MARGIN + 0.5).all(), "{extent}: {size}");
            assert!(size.y >= 150.0 && size.y <= 330.0, "{size}");
        }
    }

    #[test]
    fn round_numbers_are_short() {
        assert_eq!([0.05, 200.0, 5e3, 1e5, 2e6].map(short), ["0.05", "200", "5k", "100k", "2M"]);
    }
}

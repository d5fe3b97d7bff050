//! The report's curves as SVG files, drawn by `plotters` in the page's light colours.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::theme::light_rgb;
use crate::figures::{Curve, Figure, Style};

/// Width and height of a figure, px.
const SIZE: (u32, u32) = (900, 480);

/// `plotters` rounds to whole pixels. Curves stay smooth because the drawing is this many times larger than the file.
const FINE: i32 = 4;

/// Room on the right for the names of the curves, px.
const LEGEND: i32 = 170;

/// Colours of `page.css` for curves.
const PALETTE: usize = 8;

/// A figure as an SVG file.
pub(crate) fn svg(figure: &Figure) -> String {
    let (width, height) = SIZE;
    let mut svg = String::new();
    let fine = SVGBackend::with_string(&mut svg, (width * FINE as u32, height * FINE as u32)).into_drawing_area();
    draw(figure, &fine).expect("a string takes everything");
    drop(fine);
    let grid = format!("<svg width=\"{}\" height=\"{}\"", width * FINE as u32, height * FINE as u32);
    svg.replacen(&grid, &format!("<svg width=\"{width}\" height=\"{height}\""), 1)
}

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn<'a> = Result<(), DrawingAreaErrorKind<<SVGBackend<'a> as DrawingBackend>::ErrorType>>;

fn draw<'a>(figure: &Figure, canvas: &Canvas<'a>) -> Drawn<'a> {
    canvas.fill(&WHITE)?;
    let (width, _) = canvas.dim_in_pixel();
    let has_legend = figure.curves.len() > 1;
    let (chart, legend) = canvas.split_horizontally(width as i32 - if has_legend { fine(LEGEND) } else { 0 });
    chart.draw(&Text::new(figure.title, (fine(16), fine(12)), text(17)))?;
    chart.draw(&Text::new(figure.note, (fine(16), fine(36)), text(11).color(&colour("--soft"))))?;

    let (times, values) = ranges(figure);
    let mut context = ChartBuilder::on(&chart)
        .margin_top(fine(62))
        .margin_right(fine(24))
        .margin_bottom(fine(8))
        .margin_left(fine(8))
        .x_label_area_size(fine(46))
        .y_label_area_size(fine(66))
        .build_cartesian_2d(times.0..times.1, values.0..values.1)?;
    if let Some((from, to)) = figure.shaded {
        let shade = colour("--accent").mix(0.1).filled();
        context.draw_series([Rectangle::new([(from, values.0), (to, values.1)], shade)])?;
    }
    context
        .configure_mesh()
        .x_labels(8)
        .y_labels(8)
        .max_light_lines(0)
        .set_all_tick_mark_size(fine(4))
        .bold_line_style(colour("--grid").stroke_width(FINE as u32))
        .axis_style(colour("--soft").stroke_width(FINE as u32))
        .label_style(text(11).color(&colour("--soft")))
        .x_label_formatter(&|value| tick(*value))
        .y_label_formatter(&|value| tick(*value))
        .axis_desc_style(text(12))
        .x_desc("time, s")
        .y_desc(format!("{}, {}", figure.quantity, figure.unit))
        .draw()?;
    for curve in &figure.curves {
        let (colour, dash) = look(curve);
        // a gap in the numbers is a gap in the curve
        for run in curve.points.split(|(_, value)| value.is_none()).filter(|run| !run.is_empty()) {
            let points = run.iter().filter_map(|(time, value)| Some((*time, (*value)?)));
            match dash {
                None => context.draw_series(LineSeries::new(points, colour))?,
                Some((dash, gap)) => {
                    context.draw_series(DashedLineSeries::new(points, fine(dash), fine(gap), colour))?
                }
            };
        }
    }
    if has_legend { draw_legend(figure, &legend) } else { Ok(()) }
}

fn draw_legend<'a>(figure: &Figure, area: &Canvas<'a>) -> Drawn<'a> {
    let named = figure.curves.iter().filter(|curve| curve.style != Style::Companion);
    for (line, curve) in named.enumerate() {
        let y = fine(72 + 20 * line as i32);
        let (colour, dash) = look(curve);
        let (mut x, end) = (0, 24);
        let (dash, gap) = dash.unwrap_or((end, 0));
        while x < end {
            area.draw(&PathElement::new([(fine(x), y), (fine((x + dash).min(end)), y)], colour))?;
            x += dash + gap;
        }
        let left = text(11).pos(Pos::new(HPos::Left, VPos::Center));
        area.draw(&Text::new(curve.name.as_str(), (fine(end + 8), y), left))?;
    }
    Ok(())
}

/// The style of a curve's line, and the lengths of its dashes and gaps, px.
fn look(curve: &Curve) -> (ShapeStyle, Option<(i32, i32)>) {
    let colour = curve.colour.map_or(colour("--soft"), |place| colour(&format!("--curve-{}", place % PALETTE)));
    // past the end of the palette, colours repeat with dashes
    let round = curve.colour.map_or(0, |place| place / PALETTE);
    let (tenths, dash) = match curve.style {
        Style::Line => (13, [None, Some((9, 2)), Some((3, 3)), Some((14, 4))][round.min(3)]),
        Style::Dashed => (13, Some((6, 4))),
        Style::Companion => (11, Some((2, 2))),
    };
    (colour.stroke_width((tenths * FINE as u32).div_ceil(10)), dash)
}

/// The ranges of time and of values; that of values holds zero and ends above the highest.
fn ranges(figure: &Figure) -> ((f64, f64), (f64, f64)) {
    let points = || figure.curves.iter().flat_map(|curve| &curve.points);
    let span = |numbers: &mut dyn Iterator<Item = f64>| {
        numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), number| (least.min(number), most.max(number)))
    };
    let (from, to) = span(&mut points().map(|(time, _)| *time));
    let (least, most) = span(&mut points().filter_map(|(_, value)| *value).chain([0.0]));
    let room = 0.05 * (most - least);
    let below = if least < 0.0 { least - room } else { 0.0 };
    // a range of no length cannot be drawn
    let end = |from: f64, to: f64| if to > from { to } else { from + 1.0 };
    ((from, end(from, to)), (below, end(below, most + room)))
}

/// A number on an axis, without the rounding error of sums of tenths.
fn tick(value: f64) -> String {
    let rounded: f64 = format!("{value:.9e}").parse().unwrap_or(value);
    // the tick at zero may be off by a rounding error
    if rounded.abs() < 1e-12 { "0".into() } else { rounded.to_string() }
}

fn text(px: i32) -> TextStyle<'static> {
    // the backend divides font sizes by this factor
    ("sans-serif", 1.24 * f64::from(fine(px))).into_font().color(&colour("--ink"))
}

fn colour(name: &str) -> RGBColor {
    let [red, green, blue] = light_rgb(name);
    RGBColor(red, green, blue)
}

fn fine(px: i32) -> i32 {
    px * FINE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_on_axes_have_no_rounding_errors() {
        assert_eq!([0.1 + 0.2, 0.0, 1e-17, -2.5, 20_000.0].map(tick), ["0.3", "0", "0", "-2.5", "20000"]);
    }
}

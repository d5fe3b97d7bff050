//! The charts of a report: each is a set of columns of the history.
//!
//! A figure holds places in a palette, not colours; `charts.js` takes the colours from the reader's theme.

use netcast_results::{Column, Dimension, OPEN_SHARE, columns};
use serde_json::{Value, json};

use crate::format::{Scale, percent};
use crate::results::Results;

/// Most points of a curve; a longer one is thinned. A screen resolves half as many.
const MOST_POINTS: usize = 4000;

/// A chart: curves over time with a title, a note on how to read it, and a unit.
pub(crate) struct Figure {
    pub id: &'static str,
    pub title: &'static str,
    pub note: &'static str,
    pub quantity: &'static str,
    pub unit: String,
    pub curves: Vec<Curve>,
    /// Start and end of the interval to shade, s.
    pub shaded: Option<(f64, f64)>,
}

pub(crate) struct Curve {
    pub name: String,
    /// Time, s, and value in the figure's unit; `None` is a gap.
    pub points: Vec<(f64, Option<f64>)>,
    /// Place in the palette; `None` for a reference line, drawn in the soft colour.
    pub colour: Option<usize>,
    pub style: Style,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    Line,
    Dashed,
    /// A companion of the line before it, in the same colour and without a name of its own in the legend.
    Companion,
}

/// The figures with at least one curve, in the order of the page.
pub(crate) fn figures(results: &Results) -> Vec<Figure> {
    let before: [MakeFigure; 9] =
        [areas, coverage, speeds, travels, class_tensions, point_tensions, canopy_tensions, thread_tensions, postures];
    let after: [MakeFigure; 3] = [heights, energies, residual];
    let made = |figures: &[MakeFigure]| figures.iter().filter_map(|figure| figure(results)).collect::<Vec<_>>();
    let alone = columns().filter_map(|(column, _)| of_column(results, &column));
    let all = made(&before).into_iter().chain(alone).chain(made(&after));
    all.filter(|figure| !figure.curves.is_empty()).collect()
}

type MakeFigure = fn(&Results) -> Option<Figure>;

fn areas(results: &Results) -> Option<Figure> {
    let time = times(results)?;
    let named = [
        ("area_m2", "outline area", Style::Line),
        // dashed, because it covers the outline area wherever the web faces along the axis
        ("vector_area_m2", "vector area", Style::Dashed),
        ("shadow_area_m2", "silhouette", Style::Line),
        ("tractor_area_m2", "tractors' polygon", Style::Line),
    ];
    let mut curves = Vec::new();
    for (colour, (column, name, style)) in named.into_iter().enumerate() {
        if let Some(values) = results.column(column) {
            curves.push(Curve { style, ..Curve::new(name, &time, &values, colour) });
        }
    }
    let opening = &results.summary().opening;
    if let (false, Some(reference)) = (curves.is_empty(), opening.reference_area_m2) {
        let ends = [time.first(), time.last()].into_iter().flatten().flatten();
        curves.push(Curve {
            name: format!("{} of the flat web", percent(OPEN_SHARE)),
            points: ends.map(|&end| (end, Some(OPEN_SHARE * reference))).collect(),
            colour: None,
            style: Style::Dashed,
        });
    }
    Some(Figure {
        id: "areas",
        title: "Area",
        note: "Seen along the launch axis; vector area: along its own normal; silhouette: folds count once. Shaded: 80 % open.",
        quantity: "area",
        unit: "m²".into(),
        curves,
        shaded: opening.effective_from_s.zip(opening.effective_to_s),
    })
}

fn coverage(results: &Results) -> Option<Figure> {
    let target = results.summary().target.as_ref();
    Some(Figure {
        id: "coverage",
        title: "Target covered",
        note: "Share of a disc of the target's size, centred on the mouth, within the silhouette. Shaded: wholly covered.",
        quantity: "covered",
        unit: "%".into(),
        curves: vec![single(results, "target_coverage", "target", 100.0)?],
        shaded: target.and_then(|target| target.covered_from_s.zip(target.covered_to_s)),
    })
}

fn postures(results: &Results) -> Option<Figure> {
    let posture = &results.summary().posture;
    Some(Figure {
        id: "posture",
        title: "Posture",
        note: "How far the middle leads the outline, over the flat web's size: below zero concave. Shaded: concave.",
        quantity: "lead of the middle",
        unit: "%".into(),
        curves: vec![single(results, "posture", "posture", 100.0)?],
        shaded: posture.concave_from_s.zip(posture.concave_to_s),
    })
}

/// The figure of a column that is drawn alone; none where the column has no figure of its own.
fn of_column(results: &Results, column: &Column) -> Option<Figure> {
    let (title, name) = column.figure?;
    let (factor, unit) = match (column.dimension, column.dimension.unit()) {
        (Dimension::Angle, _) => (1.0_f64.to_degrees(), "°".into()),
        (Dimension::Share, _) => (100.0, "%".into()),
        (_, unit) => (1.0, unit.replace("^2", "²").replace("^3", "³")),
    };
    let (curves, shaded) = (vec![single(results, column.name, name, factor)?], None);
    let figure = Figure { id: name, title, note: column.definition, quantity: name, unit, curves, shaded };
    let has_prefix = matches!(column.dimension, Dimension::Force | Dimension::Energy);
    Some(if has_prefix { scaled(figure, column.dimension.unit()) } else { figure })
}

fn heights(results: &Results) -> Option<Figure> {
    let flight = &results.summary().flight;
    Some(Figure {
        id: "height",
        title: "Height",
        note: "The web's centre of mass above the muzzle. Shaded: within 5 % of its apex.",
        quantity: "height",
        unit: "m".into(),
        curves: vec![single(results, "mass_centre_height_m", "centre of mass", 1.0)?],
        shaded: flight.hang_from_s.zip(flight.hang_to_s),
    })
}

/// One column as a curve, its values times `factor`.
fn single(results: &Results, column: &str, name: &str, factor: f64) -> Option<Curve> {
    let values: Vec<Option<f64>> = results.column(column)?.iter().map(|v| v.map(|v| factor * v)).collect();
    Some(Curve::new(name, &times(results)?, &values, 0))
}

fn speeds(results: &Results) -> Option<Figure> {
    Some(Figure {
        id: "speeds",
        title: "Speed",
        note: "The highest speed of the tractors and the feature points since the record before.",
        quantity: "speed",
        unit: "m/s".into(),
        curves: by_suffix(results, with_peaks(results, "_speed_peak_m_s", "_speed_m_s"), part_name)?,
        shaded: None,
    })
}

fn travels(results: &Results) -> Option<Figure> {
    Some(Figure {
        id: "travels",
        title: "Travel",
        note: "Displacement along the launch axis since launch.",
        quantity: "travel",
        unit: "m".into(),
        curves: by_suffix(results, "_travel_m", part_name)?,
        shaded: None,
    })
}

fn class_tensions(results: &Results) -> Option<Figure> {
    let note = "Per rope. Solid: the highest of the class since the record before; dotted: its mean at the record.";
    let chosen = |class: &str| class != OF_ALL_ROPES && class != CANOPY && is_rope(results, class);
    tensions(results, "class-tensions", "Tension by link class", note, chosen)
}

/// Tensions in canopies. They are apart from the ropes: cloth is stiffer and would set the scale of both.
fn canopy_tensions(results: &Results) -> Option<Figure> {
    let note = "Per member of a canopy's cloth. Solid: the highest; dotted: the mean.";
    tensions(results, "canopy-tensions", "Tension in canopies", note, |class| class == CANOPY)
}

/// Tensions in ties and stitches.
fn thread_tensions(results: &Results) -> Option<Figure> {
    let note = "Per tie or stitch, until it breaks. Solid: the highest; dotted: the mean.";
    let chosen = |class: &str| class != CANOPY && !is_rope(results, class);
    tensions(results, "thread-tensions", "Tension in ties and stitches", note, chosen)
}

/// The link class of canopy members, and the history's name for the highest tension of all ropes.
const CANOPY: &str = "canopy";
const OF_ALL_ROPES: &str = "tension";

/// Whether the segments of a link class are ropes; true where the folder has no landmarks.
fn is_rope(results: &Results, class: &str) -> bool {
    let classes = results.scene.iter().flat_map(|scene| &scene.landmarks.classes);
    classes.filter(|known| known.name == class).all(|known| known.is_rope)
}

/// The figure of the highest and mean tensions of the link classes that satisfy `chosen`.
fn tensions(
    results: &Results,
    id: &'static str,
    title: &'static str,
    note: &'static str,
    chosen: impl Fn(&str) -> bool,
) -> Option<Figure> {
    let time = times(results)?;
    let mut curves = Vec::new();
    let maxima = results.filled().filter_map(|(column, values)| Some((column.strip_suffix("_max_n")?, values)));
    for (colour, (class, values)) in maxima.filter(|(class, _)| chosen(class)).enumerate() {
        let peaks = results.column(&format!("{class}_peak_n"));
        curves.push(Curve::new(class, &time, peaks.as_ref().unwrap_or(&values), colour));
        if let Some(mean) = results.column(&format!("{class}_mean_n")) {
            let mean = Curve::new(&format!("{class}, mean"), &time, &mean, colour);
            curves.push(Curve { style: Style::Companion, ..mean });
        }
    }
    let unit = String::new();
    Some(scaled(Figure { id, title, note, quantity: "tension", unit, curves, shaded: None }, "N"))
}

fn point_tensions(results: &Results) -> Option<Figure> {
    let name = |point: &str| if point == "B" { "B (bottom ropes)".into() } else { part_name(point) };
    Some(scaled(
        Figure {
            id: "point-tensions",
            title: "Tension at the feature points",
            note: "The highest of the ropes that meet at each point since the record before.",
            quantity: "tension",
            unit: String::new(),
            curves: by_suffix(results, with_peaks(results, "_tension_peak_n", "_tension_n"), name)?,
            shaded: None,
        },
        "N",
    ))
}

/// A channel of energy below this part of the largest is a line on the axis.
const LEAST_PART: f64 = 1e-9;

fn energies(results: &Results) -> Option<Figure> {
    let mut curves = by_suffix(results, "_j", channel_name)?;
    // a channel that is zero all along, or as good as zero beside the others, only fills the legend
    let largest = |curve: &Curve| {
        curve.points.iter().filter_map(|(_, value)| *value).fold(0.0, |most, value| value.abs().max(most))
    };
    let least = LEAST_PART * curves.iter().map(largest).fold(0.0, f64::max);
    curves.retain(|curve| curve.name != "residual" && largest(curve) > least);
    for (place, curve) in curves.iter_mut().enumerate() {
        curve.colour = Some(place);
    }
    Some(scaled(
        Figure {
            id: "energies",
            title: "Energy by channel",
            note: "Each channel is integrated by itself; none is a difference of others.",
            quantity: "energy",
            unit: String::new(),
            curves,
            shaded: None,
        },
        "J",
    ))
}

fn residual(results: &Results) -> Option<Figure> {
    let values = results.column("energy_residual_j")?;
    Some(scaled(
        Figure {
            id: "residual",
            title: "Energy residual",
            note: "The energy that the channels do not account for: the smaller, the better the run.",
            quantity: "residual",
            unit: String::new(),
            curves: vec![Curve::new("residual", &times(results)?, &values, 0)],
            shaded: None,
        },
        "J",
    ))
}

fn times(results: &Results) -> Option<Vec<Option<f64>>> {
    results.column("time_s")
}

/// The suffix of the columns of largest values since the record before, or of those at the record in a result without.
fn with_peaks(results: &Results, peaks: &'static str, at_record: &'static str) -> &'static str {
    if results.filled().any(|(column, _)| column.ends_with(peaks)) { peaks } else { at_record }
}

/// A curve for each column that ends in `suffix`. No two have one place in the palette.
fn by_suffix(results: &Results, suffix: &str, name: fn(&str) -> String) -> Option<Vec<Curve>> {
    let time = times(results)?;
    let columns = results.filled().filter_map(|(column, values)| Some((column.strip_suffix(suffix)?, values)));
    let mut next = PARTS.len();
    let curve = |(part, values): (&str, Vec<Option<f64>>)| {
        let colour = PARTS.iter().position(|known| *known == part).unwrap_or_else(|| {
            next += 1;
            next - 1
        });
        Curve::new(&name(part), &time, &values, colour)
    };
    Some(columns.map(curve).collect())
}

/// The feature points by their place in the palette: the same in every chart.
const PARTS: [&str; 7] = ["tractor", "B", "C", "D", "A", "corner", "centre"];

fn part_name(part: &str) -> String {
    match part {
        "tractor" => "tractors".into(),
        "corner" => "corners".into(),
        "mass_centre" => "centre of mass".into(),
        other => other.to_owned(),
    }
}

fn channel_name(column: &str) -> String {
    column.strip_prefix("energy_").unwrap_or(column).replace('_', " ")
}

/// Divides the figure's values by the prefix of the unit `base` that fits the largest.
fn scaled(mut figure: Figure, base: &str) -> Figure {
    let values = figure.curves.iter().flat_map(|curve| &curve.points).filter_map(|(_, value)| *value);
    let scale = Scale::fitting(values.fold(0.0, |largest, value| value.abs().max(largest)), base);
    for (_, value) in figure.curves.iter_mut().flat_map(|curve| &mut curve.points) {
        *value = value.map(|value| value / scale.divisor);
    }
    Figure { unit: scale.unit, ..figure }
}

impl Curve {
    fn new(name: &str, time: &[Option<f64>], values: &[Option<f64>], colour: usize) -> Self {
        let points = time.iter().zip(values).filter_map(|(time, value)| Some(((*time)?, *value))).collect();
        Self { name: name.into(), points: thinned(points), colour: Some(colour), style: Style::Line }
    }

    fn json(&self) -> Value {
        let style = match self.style {
            Style::Line => "solid",
            Style::Dashed => "dash",
            Style::Companion => "companion",
        };
        json!({
            "name": self.name,
            "x": self.points.iter().map(|(time, _)| six_digits(*time)).collect::<Vec<f64>>(),
            "y": self.points.iter().map(|(_, value)| value.map(six_digits)).collect::<Vec<_>>(),
            "colour": self.colour,
            "style": style,
        })
    }
}

impl Figure {
    /// The figure as `charts.js` reads it.
    pub(crate) fn json(&self) -> Value {
        json!({
            "id": self.id,
            "title": self.title,
            "yTitle": format!("{}, {}", self.quantity, self.unit),
            "unit": self.unit,
            "shaded": self.shaded.map(|(from, to)| [from, to]),
            "curves": self.curves.iter().map(Curve::json).collect::<Vec<Value>>(),
        })
    }
}

/// Thins a curve of more than [`MOST_POINTS`] points. It keeps the lowest and the highest point of each stretch, so
/// that every peak stays.
pub(crate) fn thinned(points: Vec<(f64, Option<f64>)>) -> Vec<(f64, Option<f64>)> {
    if points.len() <= MOST_POINTS {
        return points;
    }
    let stretch = (2 * points.len()).div_ceil(MOST_POINTS);
    let mut kept = Vec::with_capacity(MOST_POINTS);
    for stretch in points.chunks(stretch) {
        let valued = || stretch.iter().enumerate().filter_map(|(place, (_, value))| Some((place, (*value)?)));
        let lowest = valued().min_by(|a, b| a.1.total_cmp(&b.1));
        let highest = valued().max_by(|a, b| a.1.total_cmp(&b.1));
        match (lowest, highest) {
            (Some((low, _)), Some((high, _))) if low != high => {
                kept.extend([stretch[low.min(high)], stretch[low.max(high)]]);
            }
            (Some((only, _)), _) => kept.push(stretch[only]),
            // a gap stays a gap
            _ => kept.push(stretch[0]),
        }
    }
    kept
}

/// Rounds to six significant digits: more than a screen shows, at a third of the bytes.
pub(crate) fn six_digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_every_peak_and_the_order_of_time() {
        let mut points: Vec<(f64, Option<f64>)> =
            (0..100_000).map(|step| (step as f64, Some((step % 7) as f64))).collect();
        points[31_415].1 = Some(1e6);
        points[27_182].1 = Some(-1e6);
        let kept = thinned(points);
        assert!(kept.len() <= MOST_POINTS);
        assert!(kept.contains(&(31_415.0, Some(1e6))) && kept.contains(&(27_182.0, Some(-1e6))));
        assert!(kept.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }

    #[test]
    fn numbers_are_rounded_to_six_significant_digits() {
        assert_eq!(six_digits(1.0 / 3.0), 0.333333);
        assert_eq!(six_digits(123456789.0), 123457000.0);
        assert_eq!(six_digits(0.131), 0.131);
    }
}

//! Curves of several designs laid over each other: a figure a quantity, a curve a design.

use netcast_results::comparison::Design;
use serde_json::{Value, json};

use crate::figures::{six_digits, thinned};
use crate::format::Scale;
use crate::page::figure_frame;
use crate::results::Results;

/// What a figure shows.
struct OverlaidCurve {
    id: &'static str,
    title: &'static str,
    note: &'static str,
    /// Its unit; N and J stand on the page with a prefix that fits.
    unit: &'static str,
    /// What a value of the history is multiplied by to be in that unit.
    factor: f64,
    /// Columns of the history whose sum it is.
    columns: &'static [&'static str],
}

impl OverlaidCurve {
    const fn new(
        id: &'static str,
        title: &'static str,
        note: &'static str,
        unit: &'static str,
        columns: &'static [&'static str],
    ) -> Self {
        Self { id, title, note, unit, factor: 1.0, columns }
    }
}

/// The figures in the order of the page; one without any curve is left out.
const CURVES: [OverlaidCurve; 17] = [
    OverlaidCurve::new("area", "Area inside the outline", "Seen along the launch axis.", "m²", &["area_m2"]),
    OverlaidCurve::new(
        "tractor-area",
        "Tractors' polygon",
        "Its area along the launch axis.",
        "m²",
        &["tractor_area_m2"],
    ),
    OverlaidCurve::new("shadow", "Silhouette", "Area of the web's shadow along the axis.", "m²", &["shadow_area_m2"]),
    OverlaidCurve {
        factor: 100.0,
        ..OverlaidCurve::new("coverage", "Target covered", "Share of the stated target.", "%", &["target_coverage"])
    },
    OverlaidCurve::new("tension", "Highest tension", "Of all ropes, per rope.", "N", &["tension_max_n"]),
    OverlaidCurve::new(
        "bottom-tension",
        "Bottom ropes",
        "Those that meet point B: the hardest pulled.",
        "N",
        &["B_tension_n"],
    ),
    OverlaidCurve::new("ring-tension", "Ring ropes", "Their mean tension.", "N", &["ring_mean_n"]),
    OverlaidCurve::new("radial-tension", "Radial ropes", "Their mean tension.", "N", &["radial_mean_n"]),
    OverlaidCurve::new("tractor-speed", "Speed of the tractors", "Of the mean of them.", "m/s", &["tractor_speed_m_s"]),
    OverlaidCurve::new(
        "tractor-travel",
        "Travel of the tractors",
        "Along the launch axis.",
        "m",
        &["tractor_travel_m"],
    ),
    OverlaidCurve::new("b-speed", "Speed of point B", "The middle of the web's bottom.", "m/s", &["B_speed_m_s"]),
    OverlaidCurve::new("b-travel", "Travel of point B", "Along the launch axis.", "m", &["B_travel_m"]),
    OverlaidCurve::new("centre-travel", "Travel of the centre", "Along the launch axis.", "m", &["centre_travel_m"]),
    OverlaidCurve::new(
        "posture",
        "Posture",
        "Below 0 the middle trails the outline, above it leads.",
        "",
        &["posture"],
    ),
    OverlaidCurve {
        factor: 180.0 / std::f64::consts::PI,
        ..OverlaidCurve::new(
            "tilt",
            "Tilt of the mouth",
            "Between the outline's vector area and the axis.",
            "°",
            &["mouth_tilt_rad"],
        )
    },
    OverlaidCurve::new(
        "asymmetry",
        "Asymmetry of the mouth",
        "How unevenly the corners stand out.",
        "",
        &["mouth_asymmetry"],
    ),
    OverlaidCurve::new(
        "energy",
        "Mechanical energy",
        "Kinetic, elastic and gravity together: what damping has left.",
        "J",
        &["energy_kinetic_j", "energy_elastic_j", "energy_gravity_j"],
    ),
];

/// Time, s, and value.
type Points = Vec<(f64, Option<f64>)>;

/// The curves of all designs, by quantity.
#[derive(Default)]
pub(crate) struct Overlay {
    /// Place of the quantity, place of the design, curve.
    curves: Vec<(usize, usize, Points)>,
}

impl Overlay {
    /// Takes a design in.
    pub(crate) fn add(&mut self, design: usize, results: &Results) {
        let Some(time) = results.column("time_s") else { return };
        for (place, quantity) in CURVES.iter().enumerate() {
            let Some(columns) = quantity.columns.iter().map(|name| results.column(name)).collect::<Option<Vec<_>>>()
            else {
                continue;
            };
            let value = |row: usize| columns.iter().map(|column| column[row]).sum::<Option<f64>>();
            let points = (0..time.len()).filter_map(|row| Some((time[row]?, value(row).map(|v| quantity.factor * v))));
            self.curves.push((place, design, thinned(points.collect())));
        }
    }
}

/// A figure of the page.
pub(crate) struct OverlayFigure<'o> {
    quantity: &'static OverlaidCurve,
    scale: Scale,
    /// Place of the design, and its curve.
    curves: Vec<(usize, &'o Points)>,
}

/// The figures that any design has a curve for.
pub(crate) fn overlays(overlay: &Overlay) -> Vec<OverlayFigure<'_>> {
    let figure = |(place, quantity): (usize, &'static OverlaidCurve)| {
        let own = overlay.curves.iter().filter(|(known, ..)| *known == place);
        let mut curves: Vec<(usize, &Points)> = own.map(|(_, design, points)| (*design, points)).collect();
        curves.sort_by_key(|(design, _)| *design);
        let values = curves.iter().flat_map(|(_, points)| points.iter()).filter_map(|(_, value)| *value);
        let largest = values.fold(0.0, |largest, value: f64| value.abs().max(largest));
        let has_prefix = matches!(quantity.unit, "N" | "J");
        let scale = Scale::fitting(if has_prefix { largest } else { 0.0 }, quantity.unit);
        (!curves.is_empty()).then_some(OverlayFigure { quantity, scale, curves })
    };
    CURVES.iter().enumerate().filter_map(figure).collect()
}

impl OverlayFigure<'_> {
    /// Where the page draws it.
    pub(crate) fn frame(&self) -> String {
        figure_frame(self.quantity.title, self.quantity.note, self.quantity.id)
    }

    /// The figure as `charts.js` takes it, with the designs' names and places in the palette.
    pub(crate) fn json(&self, designs: &[Design]) -> Value {
        let curve = |(design, points): &(usize, &Points)| {
            let value = |value: &Option<f64>| value.map(|value| six_digits(value / self.scale.divisor));
            json!({
                "name": designs[*design].name,
                "x": points.iter().map(|(time, _)| six_digits(*time)).collect::<Vec<f64>>(),
                "y": points.iter().map(|(_, known)| value(known)).collect::<Vec<_>>(),
                "colour": design,
                "style": "solid",
            })
        };
        json!({
            "id": self.quantity.id,
            "yTitle": self.scale.unit,
            "unit": self.scale.unit,
            "shaded": null,
            "curves": self.curves.iter().map(curve).collect::<Vec<_>>(),
        })
    }
}

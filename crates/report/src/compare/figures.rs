//! The figures of a comparison: one for each quantity, with one curve for each design.

use netcast_results::comparison::Design;
use serde_json::{Value, json};

use crate::figures::{six_digits, thinned};
use crate::format::Scale;
use crate::page::figure_frame;
use crate::results::Results;

/// A quantity that a figure shows for all designs.
struct OverlaidQuantity {
    id: &'static str,
    title: &'static str,
    note: &'static str,
    /// The unit; N and J take a fitting prefix on the page.
    unit: &'static str,
    /// Factor from the unit of the history to `unit`.
    factor: f64,
    /// Columns of the history; the quantity is their sum.
    columns: &'static [&'static str],
}

impl OverlaidQuantity {
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

/// The quantities in the order of the page; one that no design has is left out.
const QUANTITIES: [OverlaidQuantity; 17] = [
    OverlaidQuantity::new("area", "Area inside the outline", "Seen along the launch axis.", "m²", &["area_m2"]),
    OverlaidQuantity::new(
        "tractor-area",
        "Tractors' polygon",
        "Its area along the launch axis.",
        "m²",
        &["tractor_area_m2"],
    ),
    OverlaidQuantity::new(
        "shadow",
        "Silhouette",
        "Area of the web's shadow along the axis.",
        "m²",
        &["shadow_area_m2"],
    ),
    OverlaidQuantity {
        factor: 100.0,
        ..OverlaidQuantity::new("coverage", "Target covered", "Share of the stated target.", "%", &["target_coverage"])
    },
    OverlaidQuantity::new("tension", "Highest tension", "Of all ropes, per rope.", "N", &["tension_peak_n"]),
    OverlaidQuantity::new(
        "bottom-tension",
        "Bottom ropes",
        "The highest tension of the ropes at point B.",
        "N",
        &["B_tension_peak_n"],
    ),
    OverlaidQuantity::new("ring-tension", "Ring ropes", "Their mean tension.", "N", &["ring_mean_n"]),
    OverlaidQuantity::new("radial-tension", "Radial ropes", "Their mean tension.", "N", &["radial_mean_n"]),
    OverlaidQuantity::new(
        "tractor-speed",
        "Speed of the tractors",
        "Of their mean point.",
        "m/s",
        &["tractor_speed_peak_m_s"],
    ),
    OverlaidQuantity::new(
        "tractor-travel",
        "Travel of the tractors",
        "Along the launch axis.",
        "m",
        &["tractor_travel_m"],
    ),
    OverlaidQuantity::new(
        "b-speed",
        "Speed of point B",
        "The middle of the web's bottom.",
        "m/s",
        &["B_speed_peak_m_s"],
    ),
    OverlaidQuantity::new("b-travel", "Travel of point B", "Along the launch axis.", "m", &["B_travel_m"]),
    OverlaidQuantity::new("centre-travel", "Travel of the centre", "Along the launch axis.", "m", &["centre_travel_m"]),
    OverlaidQuantity::new(
        "posture",
        "Posture",
        "Below 0 the middle trails the outline; above 0 it leads.",
        "",
        &["posture"],
    ),
    OverlaidQuantity {
        factor: 180.0 / std::f64::consts::PI,
        ..OverlaidQuantity::new(
            "tilt",
            "Tilt of the mouth",
            "Between the outline's vector area and the axis.",
            "°",
            &["mouth_tilt_rad"],
        )
    },
    OverlaidQuantity::new(
        "asymmetry",
        "Asymmetry of the mouth",
        "Spread of the corners' distances from the middle.",
        "",
        &["mouth_asymmetry"],
    ),
    OverlaidQuantity::new(
        "energy",
        "Mechanical energy",
        "Sum of kinetic, elastic and gravity energy.",
        "J",
        &["energy_kinetic_j", "energy_elastic_j", "energy_gravity_j"],
    ),
];

/// Time, s, and value.
type Points = Vec<(f64, Option<f64>)>;

/// The curves of all designs.
#[derive(Default)]
pub(crate) struct Overlay {
    curves: Vec<DesignCurve>,
}

/// The curve of a quantity for one design.
struct DesignCurve {
    /// Index into [`QUANTITIES`].
    quantity: usize,
    /// Index of the design in the comparison.
    design: usize,
    points: Points,
}

impl Overlay {
    /// Adds the curves of a design, given its index in the comparison.
    pub(crate) fn add(&mut self, design: usize, results: &Results) {
        let Some(time) = results.column("time_s") else { return };
        for (index, quantity) in QUANTITIES.iter().enumerate() {
            let Some(columns) =
                quantity.columns.iter().map(|name| results.peak_column(name)).collect::<Option<Vec<_>>>()
            else {
                continue;
            };
            let value = |row: usize| columns.iter().map(|column| column[row]).sum::<Option<f64>>();
            let points = (0..time.len()).filter_map(|row| Some((time[row]?, value(row).map(|v| quantity.factor * v))));
            self.curves.push(DesignCurve { quantity: index, design, points: thinned(points.collect()) });
        }
    }
}

/// A figure of the page.
pub(crate) struct OverlayFigure<'o> {
    quantity: &'static OverlaidQuantity,
    scale: Scale,
    /// In the order of the designs.
    curves: Vec<&'o DesignCurve>,
}

/// The figures with a curve of at least one design.
pub(crate) fn overlays(overlay: &Overlay) -> Vec<OverlayFigure<'_>> {
    let figure = |(index, quantity): (usize, &'static OverlaidQuantity)| {
        let mut curves: Vec<&DesignCurve> = overlay.curves.iter().filter(|curve| curve.quantity == index).collect();
        curves.sort_by_key(|curve| curve.design);
        let values = curves.iter().flat_map(|curve| &curve.points).filter_map(|(_, value)| *value);
        let largest = values.fold(0.0, |largest, value: f64| value.abs().max(largest));
        let has_prefix = matches!(quantity.unit, "N" | "J");
        let scale = Scale::fitting(if has_prefix { largest } else { 0.0 }, quantity.unit);
        (!curves.is_empty()).then_some(OverlayFigure { quantity, scale, curves })
    };
    QUANTITIES.iter().enumerate().filter_map(figure).collect()
}

impl OverlayFigure<'_> {
    /// The HTML element that the page draws the figure in.
    pub(crate) fn frame(&self) -> String {
        figure_frame(self.quantity.title, self.quantity.note, self.quantity.id)
    }

    /// The figure as `charts.js` reads it, with the designs' names and places in the palette.
    pub(crate) fn json(&self, designs: &[Design]) -> Value {
        let curve = |curve: &&DesignCurve| {
            let DesignCurve { design, points, .. } = curve;
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

//! What is measured at checks only, because it takes the whole web: the silhouette, the mouth, the flight.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::flight::FlightMeasures;
use super::moments::{KeptFrame, MomentFrames};
use super::mouth::MouthStance;
use super::peak::Peak;
use super::silhouette::{Projection, Silhouette};
use super::spell::Spells;
use super::steps::OPEN_SHARE;
use crate::column::{Column, ColumnOf};
use crate::geometry::mean;
use crate::landmarks::Landmarks;
use crate::quantity::Dimension::{Angle, Area, Length, Share};
use crate::summary::{Mouth, Place, Places, Summary, TargetCoverage};

/// The share of the target from which it counts as covered.
const COVERED: f64 = 0.99;

/// The web at one time. What the scenario does not have is none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WebState {
    shadow_area: Option<f64>,
    target_coverage: Option<f64>,
    mouth: MouthStance,
    posture: Option<f64>,
    mass_centre_travel: f64,
    mass_centre_height: f64,
}

/// The columns of the history that a record of the whole web fills, each with its value.
pub(crate) const COLUMNS: &[ColumnOf<WebState>] = &[
    (Column::new("shadow_area_m2", Area, "Area of the silhouette along the launch axis."), |web| web.shadow_area),
    (Column::new("target_coverage", Share, "Share of the target that the silhouette covers."), |web| {
        web.target_coverage
    }),
    (
        Column::new("mouth_tilt_rad", Angle, "Angle between the mouth and the launch axis.")
            .drawn("Tilt of the mouth", "tilt"),
        |web| web.mouth.tilt,
    ),
    (
        Column::new("mouth_asymmetry", Share, "Spread of the corners' reach, each over that in the flat web.")
            .drawn("Asymmetry of the mouth", "asymmetry"),
        |web| web.mouth.asymmetry,
    ),
    (Column::new("posture", Share, "How far the middle leads the outline, over the flat web's size."), |web| {
        web.posture
    }),
    (Column::new("mass_centre_travel_m", Length, "Travel of the web's centre of mass along the launch axis."), |web| {
        Some(web.mass_centre_travel)
    }),
    (Column::new("mass_centre_height_m", Length, "Height of the web's centre of mass above the muzzle."), |web| {
        Some(web.mass_centre_height)
    }),
];

/// Takes the checks of a run in.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WebMeasures {
    /// The centre of mass at time 0, m.
    start: DVec3,
    shadow_area: Peak,
    coverage: Peak,
    covered: Spells,
    area: Peak,
    at_largest: MouthStance,
    worst_tilt: Peak,
    worst_asymmetry: Peak,
    flight: FlightMeasures,
}

impl WebMeasures {
    /// Starts at `position`s of time 0; `mass` is that of each node, kg, and zero for tractors.
    pub fn new(mass: &[f64], position: &[DVec3]) -> WebMeasures {
        WebMeasures {
            start: mass_centre(mass, position),
            shadow_area: Peak::default(),
            coverage: Peak::default(),
            covered: Spells::default(),
            area: Peak::default(),
            at_largest: MouthStance::default(),
            worst_tilt: Peak::default(),
            worst_asymmetry: Peak::default(),
            flight: FlightMeasures::default(),
        }
    }

    /// Takes the web at a check in; `mass` is that of each node, kg, and zero for tractors.
    /// `touches` tells whether anything touches the ground.
    pub fn add(&mut self, landmarks: &Landmarks, mass: &[f64], time: f64, position: &[DVec3], touches: bool) {
        let web = self.web(landmarks, mass, position);
        self.flight.add(time, mass_centre(mass, position), touches);
        let area = landmarks.outline_area(|node| position[node]);
        self.follow(landmarks, time, &web, area.map(|area| area.dot(landmarks.axis).abs()));
    }

    /// The web at `position`s, m, (nodes,).
    pub fn web(&self, landmarks: &Landmarks, mass: &[f64], position: &[DVec3]) -> WebState {
        let at = |node: usize| position[node];
        let projection = Projection::along(landmarks.axis);
        let silhouette = Silhouette::new(&projection, &landmarks.cells, at);
        let coverage = silhouette
            .as_ref()
            .zip(landmarks.target_diameter)
            .map(|(silhouette, diameter)| silhouette.coverage(projection.of(middle_of(landmarks, at)), diameter));
        let mass_centre = mass_centre(mass, position);
        WebState {
            shadow_area: silhouette.map(|silhouette| silhouette.area()),
            target_coverage: coverage,
            mouth: MouthStance::new(landmarks, at),
            posture: landmarks.posture(at),
            mass_centre_travel: (mass_centre - self.start).dot(landmarks.axis),
            mass_centre_height: mass_centre.z,
        }
    }

    /// Where the web's centre of mass is at the moments of a run, and how fast.
    pub fn places(&self, landmarks: &Landmarks, mass: &[f64], moments: &MomentFrames) -> Places {
        // a web without mass has no centre of mass
        let number = |value: f64| value.is_finite().then_some(value);
        let place = |frame: &KeptFrame| {
            let centre = mass_centre(mass, &frame.position);
            let over_ground = (centre - self.start).truncate();
            let heading = landmarks.axis.truncate().try_normalize();
            Place {
                time_s: Some(frame.time),
                travel_m: number((centre - self.start).dot(landmarks.axis)),
                ground_distance_m: number(over_ground.length()),
                cross_range_m: heading.and_then(|heading| number(heading.perp_dot(over_ground))),
                height_m: number(centre.z),
                speed_m_s: number(mass_centre(mass, &frame.velocity).length()),
            }
        };
        let moments = [moments.opens, moments.closes, moments.area_max];
        let [opening, closing, largest_area] = moments.map(|frame| frame.map(place).unwrap_or_default());
        Places { opening, closing, largest_area }
    }

    fn follow(&mut self, landmarks: &Landmarks, time: f64, web: &WebState, area: Option<f64>) {
        if let Some(area) = web.shadow_area {
            self.shadow_area.add(time, area);
        }
        if let Some(coverage) = web.target_coverage {
            self.coverage.add(time, coverage);
            self.covered.add(time, coverage - COVERED);
        }
        let Some((area, reference)) = area.zip(landmarks.reference_area) else { return };
        if self.area.add(time, area) {
            self.at_largest = web.mouth;
        }
        if area >= OPEN_SHARE * reference {
            if let Some(tilt) = web.mouth.tilt {
                self.worst_tilt.add(time, tilt);
            }
            if let Some(asymmetry) = web.mouth.asymmetry {
                self.worst_asymmetry.add(time, asymmetry);
            }
        }
    }

    /// Writes the silhouette, the mouth, the target where one is stated, and the flight into the summary.
    pub fn finish(self, landmarks: &Landmarks, summary: &mut Summary) {
        summary.opening.shadow_area_max_m2 = self.shadow_area.value();
        summary.opening.shadow_area_max_time_s = self.shadow_area.time();
        summary.mouth = Mouth {
            tilt_at_area_max_rad: self.at_largest.tilt,
            tilt_max_open_rad: self.worst_tilt.value(),
            asymmetry_at_area_max: self.at_largest.asymmetry,
            asymmetry_max_open: self.worst_asymmetry.value(),
        };
        let (covered, duration) = self.covered.finish();
        let measured = self.coverage.value().is_some();
        summary.target = landmarks.target_diameter.map(|diameter_m| TargetCoverage {
            diameter_m,
            coverage_max: self.coverage.value(),
            coverage_max_time_s: self.coverage.time(),
            covered_from_s: covered.map(|(from, _)| from),
            covered_to_s: covered.map(|(_, to)| to),
            covered_duration_s: measured.then_some(duration),
        });
        summary.flight = self.flight.finish();
    }
}

/// The middle of the mouth: the mean of the outline's vertices, or of the web's centre where it has no outline.
fn middle_of(landmarks: &Landmarks, at: impl Fn(usize) -> DVec3) -> DVec3 {
    match landmarks.outline.len() {
        0 => mean(&landmarks.centre, at),
        count => landmarks.outline.iter().map(|nodes| mean(nodes, &at)).sum::<DVec3>() / count as f64,
    }
}

/// The centre of mass of the web without its tractors, m.
fn mass_centre(mass: &[f64], position: &[DVec3]) -> DVec3 {
    let moment: DVec3 = mass.iter().zip(position).map(|(&mass, &position)| mass * position).sum();
    moment / mass.iter().sum::<f64>()
}

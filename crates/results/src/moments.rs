//! What is measured at record times only, because it takes the whole web: the silhouette, the mouth, the flight.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::flight::FlightMeasures;
use crate::landmarks::Landmarks;
use crate::measures::{EFFECTIVE, Peak, mean};
use crate::mouth::Mouth;
use crate::silhouette::{Silhouette, View};
use crate::spell::Spells;
use crate::summary::{self, Flight, Target};

/// The share of the target from which it counts as covered.
const COVERED: f64 = 0.99;

/// The web at one record time. What the scenario does not have is none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moment {
    /// Area of the silhouette, m^2.
    pub shadow_area: Option<f64>,
    /// Share of the target that the silhouette covers.
    pub target_coverage: Option<f64>,
    /// How the mouth stands.
    pub mouth: Mouth,
    /// How far the middle leads the outline; see [`crate::measures::posture`].
    pub posture: Option<f64>,
    /// Displacement of the web's centre of mass along the axis since launch, m.
    pub mass_centre_travel: f64,
    /// Its height above the muzzle, m.
    pub mass_centre_height: f64,
}

/// The columns of the history that a moment fills.
pub const COLUMNS: [&str; 7] = [
    "shadow_area_m2",
    "target_coverage",
    "mouth_tilt_rad",
    "mouth_asymmetry",
    "posture",
    "mass_centre_travel_m",
    "mass_centre_height_m",
];

impl Moment {
    /// Its values in the order of [`COLUMNS`].
    pub fn row(&self) -> [Option<f64>; 7] {
        [
            self.shadow_area,
            self.target_coverage,
            self.mouth.tilt,
            self.mouth.asymmetry,
            self.posture,
            Some(self.mass_centre_travel),
            Some(self.mass_centre_height),
        ]
    }
}

/// Takes the moments of a run in.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MomentMeasures {
    /// The centre of mass at time 0, m.
    start: DVec3,
    shadow_area: Peak,
    coverage: Peak,
    covered: Spells,
    area: Peak,
    at_largest: Mouth,
    worst_tilt: Peak,
    worst_asymmetry: Peak,
    flight: FlightMeasures,
}

impl MomentMeasures {
    /// Starts at `position`s of time 0; `mass` is that of each node, kg, and zero for tractors.
    pub fn new(mass: &[f64], position: &[DVec3]) -> MomentMeasures {
        MomentMeasures {
            start: mass_centre(mass, position),
            shadow_area: Peak::default(),
            coverage: Peak::default(),
            covered: Spells::default(),
            area: Peak::default(),
            at_largest: Mouth::default(),
            worst_tilt: Peak::default(),
            worst_asymmetry: Peak::default(),
            flight: FlightMeasures::default(),
        }
    }

    /// Measures the web at a record time; `mass` is that of each node, kg, and zero for tractors.
    /// `touches` tells whether anything touches the ground.
    pub fn add(&mut self, landmarks: &Landmarks, mass: &[f64], time: f64, position: &[DVec3], touches: bool) -> Moment {
        let at = |node: usize| position[node];
        let view = View::along(landmarks.axis);
        let silhouette = Silhouette::new(&view, &landmarks.cells, at);
        let coverage = silhouette
            .as_ref()
            .zip(landmarks.target_diameter)
            .map(|(silhouette, diameter)| silhouette.coverage(view.project(middle_of(landmarks, at)), diameter));
        let mass_centre = mass_centre(mass, position);
        let moment = Moment {
            shadow_area: silhouette.map(|silhouette| silhouette.area()),
            target_coverage: coverage,
            mouth: Mouth::new(landmarks, at),
            posture: landmarks.posture(at),
            mass_centre_travel: (mass_centre - self.start).dot(landmarks.axis),
            mass_centre_height: mass_centre.z,
        };
        self.flight.add(time, mass_centre, touches);
        self.follow(landmarks, time, &moment, landmarks.outline_area(at).map(|s| s.dot(landmarks.axis).abs()));
        moment
    }

    fn follow(&mut self, landmarks: &Landmarks, time: f64, moment: &Moment, area: Option<f64>) {
        if let Some(area) = moment.shadow_area {
            self.shadow_area.add(time, area);
        }
        if let Some(coverage) = moment.target_coverage {
            self.coverage.add(time, coverage);
            self.covered.add(time, coverage - COVERED);
        }
        let Some((area, reference)) = area.zip(landmarks.reference_area) else { return };
        if self.area.add(time, area) {
            self.at_largest = moment.mouth;
        }
        if area >= EFFECTIVE * reference {
            moment.mouth.tilt.map(|tilt| self.worst_tilt.add(time, tilt));
            moment.mouth.asymmetry.map(|asymmetry| self.worst_asymmetry.add(time, asymmetry));
        }
    }

    /// Largest silhouette, m^2, and its time, s.
    pub fn shadow_area(&self) -> Peak {
        self.shadow_area
    }

    /// The mouth, the target where one is stated, and the flight.
    pub fn finish(self, landmarks: &Landmarks) -> (summary::Mouth, Option<Target>, Flight) {
        let mouth = summary::Mouth {
            tilt_at_area_max_rad: self.at_largest.tilt,
            tilt_max_open_rad: self.worst_tilt.value(),
            asymmetry_at_area_max: self.at_largest.asymmetry,
            asymmetry_max_open: self.worst_asymmetry.value(),
        };
        let (covered, duration) = self.covered.finish();
        let measured = self.coverage.value().is_some();
        let target = landmarks.target_diameter.map(|diameter_m| Target {
            diameter_m,
            coverage_max: self.coverage.value(),
            coverage_max_time_s: self.coverage.time(),
            covered_from_s: covered.map(|(from, _)| from),
            covered_to_s: covered.map(|(_, to)| to),
            covered_duration_s: measured.then_some(duration),
        });
        (mouth, target, self.flight.finish())
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

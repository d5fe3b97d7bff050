//! What is measured at every step: openings, speeds, travels, tensions, posture. The definitions are the contract's.
//!
//! Areas: with S = 1/2 sum r_i x r_(i+1) over a closed polygon, the area is |S . axis| and the vector area |S|.
//! Travel: displacement along the launch axis since launch. Height: world z above the muzzle, which is the origin.

use std::collections::BTreeMap;

use glam::DVec3;
use netcast_dynamics::simulate::Live;
use serde::{Deserialize, Serialize};

use crate::landmarks::{Group, Landmarks};
use crate::spell::Spells;
use crate::summary::{ClassTension, Opening, PointExtremes, Posture, Tension};
use crate::utilisation::Largest;

/// Share of the reference area from which the web counts as open.
pub(crate) const EFFECTIVE: f64 = 0.8;
/// Posture beyond which the web counts as concave (below) or convex (above).
const POSTURE: f64 = 0.02;
/// Share of its own peak travel at which a point counts as started.
const STARTED: f64 = 0.01;

/// A largest value and its time.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Peak(Option<(f64, f64)>);

impl Peak {
    /// Whether `value` is the largest so far. Of a run that diverges only the finite part counts.
    pub fn add(&mut self, time: f64, value: f64) -> bool {
        let larger = value.is_finite() && self.0.is_none_or(|(largest, _)| value > largest);
        if larger {
            self.0 = Some((value, time));
        }
        larger
    }

    /// The largest value.
    pub fn value(&self) -> Option<f64> {
        self.0.map(|(value, _)| value)
    }

    /// When it occurred, s.
    pub fn time(&self) -> Option<f64> {
        self.0.map(|(_, time)| time)
    }
}

/// Half the sum of r_i x r_(i+1) over a closed polygon, m^2.
pub fn vector_area(mut vertices: impl Iterator<Item = DVec3>) -> DVec3 {
    let Some(first) = vertices.next() else { return DVec3::ZERO };
    let mut sum = DVec3::ZERO;
    let mut last = first;
    for vertex in vertices.chain([first]) {
        // relative to the first vertex: large common offsets cancel before they are multiplied
        sum += (last - first).cross(vertex - first);
        last = vertex;
    }
    0.5 * sum
}

/// Mean of `of` over some nodes.
pub fn mean(nodes: &[usize], of: impl Fn(usize) -> DVec3) -> DVec3 {
    match nodes {
        [node] => of(*node),
        _ => nodes.iter().map(|&n| of(n)).sum::<DVec3>() / nodes.len() as f64,
    }
}

/// How far the middle leads the outline along the axis, over the square root of the reference area, both from the
/// flat web.
/// `rim` is the mean of the outline's vertices, `centre` the middle's place, m.
pub fn posture(landmarks: &Landmarks, rim: DVec3, centre: DVec3) -> Option<f64> {
    let size = landmarks.reference_area?.sqrt();
    let lead = (centre - rim).dot(landmarks.axis) - landmarks.flat_posture;
    (size > 0.0).then(|| lead / size)
}

/// Extremes of one landmark.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct PointMeasures {
    start: DVec3,
    speed: Peak,
    travel: Peak,
    height: Peak,
    /// Time, travel and bottom-tension integral whenever the travel had grown by another part in a thousand: enough
    /// to find, at the end, when 1 % of the peak was reached.
    growth: Vec<(f64, f64, f64)>,
}

/// Everything that is measured at every step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measures {
    points: Vec<PointMeasures>,
    area: Peak,
    vector_area: Peak,
    tractor_area: Peak,
    effective: Spells,
    concave: Spells,
    convex: Spells,
    groups: Vec<Peak>,
    largest: Vec<f64>,
    bottom: Peak,
    /// Integral of the mean bottom tension over time, N s, and its value when the area was largest.
    bottom_integral: f64,
    bottom_integral_at_area_max: f64,
}

impl Measures {
    /// Starts measuring at `position`s of time 0; travel counts from the `reference`.
    pub fn new(landmarks: &Landmarks, reference: &[DVec3], position: &[DVec3]) -> Measures {
        let points = landmarks
            .points
            .iter()
            .map(|p| PointMeasures {
                start: mean(&p.nodes, |node| reference[node]),
                speed: Peak::default(),
                travel: Peak::default(),
                height: Peak::default(),
                growth: Vec::new(),
            })
            .collect();
        let groups = vec![Peak::default(); landmarks.groups.len()];
        let largest = vec![0.0; landmarks.groups.len()];
        let mut measures = Measures {
            points,
            area: Peak::default(),
            vector_area: Peak::default(),
            tractor_area: Peak::default(),
            effective: Spells::default(),
            concave: Spells::default(),
            convex: Spells::default(),
            groups,
            largest,
            bottom: Peak::default(),
            bottom_integral: 0.0,
            bottom_integral_at_area_max: 0.0,
        };
        measures.shape(landmarks, 0.0, |node| position[node]);
        measures
    }

    /// Whether these are measures of a web with such landmarks.
    pub fn fit(&self, landmarks: &Landmarks) -> bool {
        let groups = landmarks.groups.len();
        self.points.len() == landmarks.points.len() && self.groups.len() == groups && self.largest.len() == groups
    }

    /// Displacement of landmark `index` from the reference, m, now that it is at `position`.
    pub fn displacement(&self, index: usize, position: DVec3) -> DVec3 {
        position - self.points[index].start
    }

    /// Takes a step into account.
    pub fn step(&mut self, landmarks: &Landmarks, live: &Live) {
        live.net.largest_tensions(&mut self.largest);
        for (peak, &tension) in self.groups.iter_mut().zip(&self.largest) {
            peak.add(live.tension_time, tension);
        }
        if !landmarks.bottom.is_empty() {
            let tension = |segment: usize| (!live.net.is_gone(segment)).then(|| live.net.tension(segment));
            self.bottom(&landmarks.bottom, live.tension_time, live.dt, &tension);
        }
        for (point, landmark) in self.points.iter_mut().zip(&landmarks.points) {
            point.speed.add(live.velocity_time, landmark.speed(|n| live.net.half_step_velocity(n)));
        }
        self.shape(landmarks, live.position_time, |node| live.net.position(node));
    }

    /// Takes the state at launch or at the end into account, of which [`Measures::step`] sees only a part.
    pub fn ends(
        &mut self,
        landmarks: &Landmarks,
        time: f64,
        velocity: &[DVec3],
        tension: &[f64],
        group_of: &dyn Fn(usize) -> usize,
    ) {
        for (point, landmark) in self.points.iter_mut().zip(&landmarks.points) {
            point.speed.add(time, landmark.speed(|n| velocity[n]));
        }
        for (segment, &tension) in tension.iter().enumerate() {
            self.groups[group_of(segment)].add(time, tension);
        }
    }

    /// `tension` is none where a segment is gone.
    fn bottom(&mut self, segments: &[usize], time: f64, dt: f64, tension: &dyn Fn(usize) -> Option<f64>) {
        let (mut sum, mut count) = (0.0, 0);
        for tension in segments.iter().filter_map(|&segment| tension(segment)) {
            self.bottom.add(time, tension);
            (sum, count) = (sum + tension, count + 1);
        }
        let mean = sum / f64::from(count);
        self.bottom_integral += if mean.is_finite() { dt * mean } else { 0.0 };
    }

    /// All that follows from positions alone.
    fn shape(&mut self, landmarks: &Landmarks, time: f64, position: impl Fn(usize) -> DVec3 + Copy) {
        let axis = landmarks.axis;
        if !landmarks.outline.is_empty() {
            let (area, rim) = landmarks.outline_area_and_middle(position);
            let along = area.dot(axis).abs();
            if self.area.add(time, along) {
                self.bottom_integral_at_area_max = self.bottom_integral;
            }
            self.vector_area.add(time, area.length());
            if let Some(reference) = landmarks.reference_area {
                self.effective.add(time, along - EFFECTIVE * reference);
            }
            if let Some(p) = posture(landmarks, rim, mean(&landmarks.centre, position)) {
                self.concave.add(time, -POSTURE - p);
                self.convex.add(time, p - POSTURE);
            }
        }
        if let Some(area) = landmarks.tractor_area(position) {
            self.tractor_area.add(time, area);
        }
        for (point, landmark) in self.points.iter_mut().zip(&landmarks.points) {
            let place = mean(&landmark.nodes, position);
            let travel = (place - point.start).dot(axis);
            if point.travel.add(time, travel) && travel > 1.001 * point.growth.last().map_or(0.0, |g| g.1) {
                point.growth.push((time, travel, self.bottom_integral));
            }
            point.height.add(time, place.z);
        }
    }

    /// The summary's parts: opening, points, tension, posture.
    pub fn finish(self, landmarks: &Landmarks) -> (Opening, BTreeMap<String, Option<PointExtremes>>, Tension, Posture) {
        let (effective, duration) = self.effective.clone().finish();
        let opening = Opening {
            area_max_m2: self.area.value(),
            area_max_time_s: self.area.time(),
            reference_area_m2: landmarks.reference_area,
            vector_area_max_m2: self.vector_area.value(),
            effective_from_s: effective.map(|(from, _)| from),
            effective_to_s: effective.map(|(_, to)| to),
            effective_duration_s: landmarks.reference_area.map(|_| duration),
            tractor_area_max_m2: self.tractor_area.value(),
            tractor_area_max_time_s: self.tractor_area.time(),
            // taken at record times, elsewhere
            shadow_area_max_m2: None,
            shadow_area_max_time_s: None,
        };
        let tension = self.tension(landmarks);
        let convex_from_s = self.convex.first();
        let (concave, _) = self.concave.finish();
        let posture = Posture {
            concave_from_s: concave.map(|(from, _)| from),
            concave_to_s: concave.map(|(_, to)| to),
            convex_from_s,
        };

        let mut points: BTreeMap<String, Option<PointExtremes>> =
            ["A", "B", "C", "D", "tractor", "corner", "centre"].map(|name| (name.to_owned(), None)).into();
        for (point, landmark) in self.points.into_iter().zip(&landmarks.points) {
            points.insert(landmark.name.clone(), Some(point.finish()));
        }
        (opening, points, tension, posture)
    }

    fn tension(&self, landmarks: &Landmarks) -> Tension {
        let mut tension = Tension::default();
        for (index, class) in landmarks.classes.iter().enumerate() {
            let peak = self.largest_of(landmarks, |group| group.class == index);
            let (max_n, max_time_s) = peak.map_or((0.0, None), |(_, tension, time)| (tension, Some(time)));
            let pulled = max_n > 0.0;
            let max_time_s = max_time_s.filter(|_| pulled);
            let margin = class.strength.filter(|_| pulled).map(|strength| strength / max_n);
            tension.by_class.insert(class.name.clone(), ClassTension { max_n, max_time_s, margin });
            if class.is_rope && max_n > tension.max_n {
                (tension.max_n, tension.max_time_s) = (max_n, max_time_s);
                tension.max_where = Some(class.name.clone());
            }
        }
        tension.bottom_max_n = self.bottom.value();
        tension.bottom_mean_n = self.bottom_mean(landmarks);
        tension
    }

    /// The largest tension of a kind of rope, N, its time, s, and the link class where it occurred.
    pub fn largest_in_rope<'l>(&self, landmarks: &'l Landmarks, rope: usize) -> Largest<'l> {
        let (group, tension, time) = self.largest_of(landmarks, |group| group.rope == Some(rope))?;
        Some((tension, time, &landmarks.classes[group.class].name))
    }

    /// The largest tension of some groups, N, its time, s, and where it occurred; the first of equals.
    fn largest_of<'l>(
        &self,
        landmarks: &'l Landmarks,
        belongs: impl Fn(&Group) -> bool,
    ) -> Option<(&'l Group, f64, f64)> {
        let groups = landmarks.groups.iter().zip(&self.groups).filter(|(group, _)| belongs(group));
        let peaks = groups.filter_map(|(group, peak)| peak.0.map(|(tension, time)| (group, tension, time)));
        peaks.reduce(|one, other| if other.1 > one.1 { other } else { one })
    }

    /// Mean bottom tension from B's start to the time of the largest area, N.
    fn bottom_mean(&self, landmarks: &Landmarks) -> Option<f64> {
        let b = landmarks.points.iter().position(|p| p.name == "B")?;
        let (start, _, integral_at_start) = self.points[b].start_of_motion()?;
        let end = self.area.time()?;
        (end > start).then(|| (self.bottom_integral_at_area_max - integral_at_start) / (end - start))
    }
}

impl PointMeasures {
    /// (time, travel, bottom integral) when the point first reached 1 % of its peak travel.
    fn start_of_motion(&self) -> Option<(f64, f64, f64)> {
        let level = STARTED * self.travel.value()?;
        self.growth.iter().copied().find(|g| g.1 >= level)
    }

    fn finish(self) -> PointExtremes {
        PointExtremes {
            peak_speed_m_s: self.speed.value(),
            peak_speed_time_s: self.speed.time(),
            peak_travel_m: self.travel.value(),
            peak_travel_time_s: self.travel.time(),
            peak_height_m: self.height.value(),
            starts_s: self.start_of_motion().map(|g| g.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_area_of_a_tilted_rectangle_far_away() {
        let (along, across) = (DVec3::new(3.0, 0.0, 4.0), DVec3::new(0.0, 2.0, 0.0));
        let far = DVec3::new(1e6, -2e6, 3e6);
        let area = vector_area([far, far + along, far + along + across, far + across].into_iter());
        assert!((area.length() - 10.0).abs() < 1e-8);
        assert!((area.dot(DVec3::Z) - 6.0).abs() < 1e-8);
    }

    #[test]
    fn a_peak_keeps_the_first_of_equals() {
        let mut peak = Peak::default();
        assert!(peak.add(0.0, 1.0) && peak.add(1.0, 2.0) && !peak.add(2.0, 2.0));
        assert_eq!((peak.value(), peak.time()), (Some(2.0), Some(1.0)));
    }
}

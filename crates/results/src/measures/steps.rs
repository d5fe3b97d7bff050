//! What is measured at every step: openings, speeds, travels, tensions, posture. The definitions are the contract's.
//!
//! Areas: with S = 1/2 sum r_i x r_(i+1) over a closed polygon, the area is |S . axis| and the vector area |S|.
//! Travel: displacement along the launch axis since launch. Height: world z above the muzzle, which is the origin.

use glam::DVec3;
use netcast_dynamics::simulate::Live;
use serde::{Deserialize, Serialize};

use super::moments::Glance;
use super::peak::Peak;
use super::ropes::LargestTension;
use super::since_record::SinceRecord;
use super::spell::Spells;
use crate::geometry::mean;
use crate::landmarks::{Group, Landmarks};
use crate::summary::{ClassTension, PointExtremes, Posture, Summary};

/// Share of the area of the flat web from which a web counts as open.
pub const OPEN_SHARE: f64 = 0.8;
/// Posture beyond which the web counts as concave (below) or convex (above).
const POSTURE: f64 = 0.02;
/// Share of its own peak travel at which a point counts as started.
const STARTED: f64 = 0.01;

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
pub struct StepMeasures {
    points: Vec<PointMeasures>,
    area: Peak,
    vector_area: Peak,
    tractor_area: Peak,
    effective: Spells,
    concave: Spells,
    convex: Spells,
    groups: Vec<Peak>,
    /// Highest tension of each group at the last step, N.
    largest: Vec<f64>,
    /// Outline area along the axis at the last step, m^2.
    area_now: Option<f64>,
    since_record: SinceRecord,
    bottom: Peak,
    /// Integral of the mean bottom tension over time, N s, and its value when the area was largest.
    bottom_integral: f64,
    bottom_integral_at_area_max: f64,
}

impl StepMeasures {
    /// Starts measuring at `position`s of time 0; travel counts from the `reference`.
    pub fn new(landmarks: &Landmarks, reference: &[DVec3], position: &[DVec3]) -> StepMeasures {
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
        let mut measures = StepMeasures {
            points,
            area: Peak::default(),
            vector_area: Peak::default(),
            tractor_area: Peak::default(),
            effective: Spells::default(),
            concave: Spells::default(),
            convex: Spells::default(),
            groups,
            largest,
            area_now: None,
            since_record: SinceRecord::new(landmarks),
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
        self.since_record.add_tensions(landmarks, &self.largest, live);
        if !landmarks.bottom.is_empty() {
            let tension = |segment: usize| (!live.net.is_gone(segment)).then(|| live.net.tension(segment));
            self.bottom(&landmarks.bottom, live.tension_time, live.dt, &tension);
        }
        let speeds = &mut self.since_record.point_speed;
        for ((point, landmark), peak) in self.points.iter_mut().zip(&landmarks.points).zip(speeds) {
            let speed = landmark.speed(|n| live.net.half_step_velocity(n));
            point.speed.add(live.velocity_time, speed);
            *peak = peak.max(speed);
        }
        self.shape(landmarks, live.position_time, |node| live.net.position(node));
    }

    /// Highest tension of each group at the last step, N, (groups,).
    pub fn largest_tensions(&self) -> &[f64] {
        &self.largest
    }

    /// What moments go by, after a step.
    pub fn glance(&self, landmarks: &Landmarks) -> Glance {
        let is_rope = |group: &Group| landmarks.classes[group.class].is_rope;
        let ropes = landmarks.groups.iter().zip(&self.largest).filter(|(group, _)| is_rope(group));
        let tension = ropes.map(|(_, &tension)| tension).fold(0.0, f64::max);
        Glance { tension, area: self.area_now, is_open: self.effective.is_open() }
    }

    /// The largest values since the record before.
    pub fn since_record(&self) -> &SinceRecord {
        &self.since_record
    }

    /// Begins to look for largest values anew, after a record.
    pub fn recorded(&mut self, landmarks: &Landmarks) {
        self.since_record = SinceRecord::new(landmarks);
    }

    /// Takes the state at a check into account, of which [`StepMeasures::step`] sees only a part: the start and the end.
    pub fn check(
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
            self.area_now = Some(along);
            if self.area.add(time, along) {
                self.bottom_integral_at_area_max = self.bottom_integral;
            }
            self.vector_area.add(time, area.length());
            if let Some(reference) = landmarks.reference_area {
                self.effective.add(time, along - OPEN_SHARE * reference);
            }
            if let Some(p) = landmarks.posture_of(rim, mean(&landmarks.centre, position)) {
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

    /// Writes opening, points, tension and posture into the summary.
    pub fn finish(self, landmarks: &Landmarks, summary: &mut Summary) {
        let opening = &mut summary.opening;
        (opening.area_max_m2, opening.area_max_time_s) = (self.area.value(), self.area.time());
        opening.reference_area_m2 = landmarks.reference_area;
        opening.vector_area_max_m2 = self.vector_area.value();
        opening.tractor_area_max_m2 = self.tractor_area.value();
        opening.tractor_area_max_time_s = self.tractor_area.time();
        self.tensions(landmarks, summary);
        let (effective, duration) = self.effective.finish();
        summary.opening.effective_from_s = effective.map(|(from, _)| from);
        summary.opening.effective_to_s = effective.map(|(_, to)| to);
        summary.opening.effective_duration_s = landmarks.reference_area.map(|_| duration);

        let convex_from_s = self.convex.first();
        let (concave, _) = self.concave.finish();
        summary.posture = Posture {
            concave_from_s: concave.map(|(from, _)| from),
            concave_to_s: concave.map(|(_, to)| to),
            convex_from_s,
        };

        summary.points = Landmarks::ALWAYS_NAMED.map(|name| (name.to_owned(), None)).into();
        for (point, landmark) in self.points.into_iter().zip(&landmarks.points) {
            summary.points.insert(landmark.name.clone(), Some(point.finish()));
        }
    }

    fn tensions(&self, landmarks: &Landmarks, summary: &mut Summary) {
        let tension = &mut summary.tension;
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
    }

    /// The largest tension of a kind of rope, N, its time, s, and the link class where it occurred.
    pub fn largest_in_rope<'l>(&self, landmarks: &'l Landmarks, rope: usize) -> LargestTension<'l> {
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
        let peaks = groups.filter_map(|(group, peak)| peak.get().map(|(tension, time)| (group, tension, time)));
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

//! The rows of `history.csv`: which columns there are, and what stands in them at a record.
//!
//! Each list holds a column and its value side by side: first those of the run, then those of each feature point, link
//! class and energy channel, then those of the web as a whole (`measures/web.rs`).

use std::collections::{BTreeMap, BTreeSet};

use glam::DVec3;
use netcast_dynamics::channel::Channel;
use netcast_dynamics::simulate::Frame;

use crate::column::{Column, ColumnOf};
use crate::geometry::mean;
use crate::landmarks::{Landmark, Landmarks};
use crate::measures::{StepMeasures, WebState, reaction, web};
use crate::quantity::Dimension::{Area, Energy, Force, Length, Speed, Time};

/// A record of a run.
pub(crate) struct RunRecord<'r> {
    pub landmarks: &'r Landmarks,
    pub frame: &'r Frame<'r>,
    pub at_steps: &'r StepMeasures,
    /// Tension of each link class.
    pub class_tensions: Vec<ClassTensions>,
    pub web: &'r WebState,
}

/// A feature point at a record.
struct PointRecord<'r> {
    run: &'r RunRecord<'r>,
    point: &'r Landmark,
    index: usize,
    place: DVec3,
    travel: f64,
}

type OfRun = (Column, for<'r> fn(&RunRecord<'r>) -> Option<f64>);
type OfPoint = (Column, for<'r> fn(&PointRecord<'r>) -> Option<f64>);

/// Columns of the run.
const RUN: &[OfRun] = &[
    (Column::new("time_s", Time, "Time since the start."), |run| Some(run.frame.time)),
    (Column::new("area_m2", Area, "Area inside the outline, seen along the launch axis."), |run| {
        Some(run.outline_area()?.dot(run.landmarks.axis).abs())
    }),
    (Column::new("vector_area_m2", Area, "Magnitude of the outline's vector area."), |run| {
        run.outline_area().map(DVec3::length)
    }),
    (Column::new("tractor_area_m2", Area, "Area of the tractors' polygon, seen along the launch axis."), |run| {
        run.landmarks.tractor_area(|node| run.frame.position[node])
    }),
    (Column::new("centre_travel_m", Length, "Travel of the centre along the launch axis."), |run| run.travel("centre")),
    (Column::new("corner_travel_m", Length, "Mean travel of the corners."), |run| run.travel("corner")),
    (Column::new("tractor_travel_m", Length, "Mean travel of the tractors."), |run| run.travel("tractor")),
    (Column::new("tension_max_n", Force, "Highest tension of any rope."), |run| {
        let classes = run.landmarks.classes.iter().zip(&run.class_tensions);
        Some(classes.filter(|(class, _)| class.is_rope).map(|(_, tension)| tension.now).fold(0.0, f64::max))
    }),
];

/// Largest values since the record before, of the run.
const RUN_PEAKS: &[OfRun] =
    &[(Column::new("tension_peak_n", Force, "Highest tension of any rope since the record before."), |run| {
        let classes = run.landmarks.classes.iter().zip(&run.class_tensions);
        Some(classes.filter(|(class, _)| class.is_rope).map(|(_, tension)| tension.peak).fold(0.0, f64::max))
    })];

/// Columns of a feature point, a group of corners or tractors, or the centre.
const POINT: &[OfPoint] = &[
    (Column::new("{}_x_m", Length, "Place in the world frame, x."), |at| Some(at.place.x)),
    (Column::new("{}_y_m", Length, "Place in the world frame, y."), |at| Some(at.place.y)),
    (Column::new("{}_z_m", Length, "Place in the world frame, z."), |at| Some(at.place.z)),
    (Column::new("{}_travel_m", Length, "Travel along the launch axis."), |at| Some(at.travel)),
    (Column::new("{}_speed_m_s", Speed, "Speed."), |at| Some(at.point.speed(|node| at.run.frame.velocity[node]))),
    (Column::new("{}_tension_n", Force, "Highest tension of the segments of rope that meet there."), |at| {
        at.point.segments.iter().map(|&segment| at.run.frame.tension[segment]).reduce(f64::max)
    }),
];

/// Largest values of a feature point since the record before.
const POINT_PEAKS: &[OfPoint] = &[
    (Column::new("{}_speed_peak_m_s", Speed, "Highest speed since the record before."), |at| {
        let now = at.point.speed(|node| at.run.frame.velocity[node]);
        Some(now.max(at.run.at_steps.since_record().point_speed[at.index]))
    }),
    (Column::new("{}_tension_peak_n", Force, "Highest tension there since the record before."), |at| {
        let now = at.point.segments.iter().map(|&segment| at.run.frame.tension[segment]).reduce(f64::max)?;
        Some(now.max(at.run.at_steps.since_record().point_tension[at.index]))
    }),
];

/// Columns of a support.
const SUPPORT: &[ColumnOf<DVec3>] = &[
    (Column::new("{}_reaction_x_n", Force, "Force of a support on what it holds or drives, x."), |at| Some(at.x)),
    (Column::new("{}_reaction_y_n", Force, "Force of a support on what it holds or drives, y."), |at| Some(at.y)),
    (Column::new("{}_reaction_z_n", Force, "Force of a support on what it holds or drives, z."), |at| Some(at.z)),
];

/// Tension of a link class at a record, N.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct ClassTensions {
    pub mean: f64,
    /// The highest of its segments.
    pub now: f64,
    /// The highest of them since the record before.
    pub peak: f64,
}

/// Columns of a link class.
const CLASS: &[ColumnOf<ClassTensions>] = &[
    (Column::new("{}_mean_n", Force, "Mean tension of the segments of a link class."), |of| Some(of.mean)),
    (Column::new("{}_max_n", Force, "Highest tension of the segments of a link class."), |of| Some(of.now)),
];

/// Largest values of a link class since the record before.
const CLASS_PEAKS: &[ColumnOf<ClassTensions>] =
    &[(Column::new("{}_peak_n", Force, "Highest tension of a link class since the record before."), |of| {
        Some(of.peak)
    })];

/// The column of an energy channel.
const CHANNEL: Column =
    Column::new("energy_{}_j", Energy, "Energy of a channel; `residual` is what they do not explain.");

/// The name of what the channels leave unexplained.
const RESIDUAL: &str = "residual";

/// The columns of the history with what each is of: `POINT`, `CLASS`, `CHANNEL`, `SUPPORT`, or nothing.
pub fn columns() -> impl Iterator<Item = (Column, &'static str)> {
    let run = RUN.iter().map(|(column, _)| (*column, ""));
    let points = POINT.iter().map(|(column, _)| (*column, "POINT"));
    let classes = CLASS.iter().map(|(column, _)| (*column, "CLASS"));
    let web = web::COLUMNS.iter().map(|(column, _)| (*column, ""));
    let run_peaks = RUN_PEAKS.iter().map(|(column, _)| (*column, ""));
    let point_peaks = POINT_PEAKS.iter().map(|(column, _)| (*column, "POINT"));
    let class_peaks = CLASS_PEAKS.iter().map(|(column, _)| (*column, "CLASS"));
    let peaks = run_peaks.chain(point_peaks).chain(class_peaks);
    let supports = SUPPORT.iter().map(|(column, _)| (*column, "SUPPORT"));
    run.chain(points).chain(classes).chain([(CHANNEL, "CHANNEL")]).chain(web).chain(peaks).chain(supports)
}

/// How the rows of a run are laid out.
#[derive(Debug)]
pub(crate) struct RowLayout {
    /// The names of the columns, in order.
    pub columns: Vec<String>,
    channels: Vec<Channel>,
    /// Of all values of a record, whether each has a column: what stands there already is not repeated. Of a point
    /// called `tractor`, `tractor_travel_m` is the mean over all tractors.
    kept: Vec<bool>,
}

/// The column of every value of a record, in order, with the point, link class or support that it is of.
fn named_columns<'l>(landmarks: &'l Landmarks, channels: &[Channel]) -> Vec<(String, Option<&'l str>)> {
    type Named<'n> = (String, Option<&'n str>);
    fn of_each<'n, T>(rows: &[ColumnOf<T>], things: impl Iterator<Item = &'n String>) -> Vec<Named<'n>> {
        things.flat_map(|thing| rows.iter().map(|(row, _)| (row.name_of(thing), Some(&thing[..])))).collect()
    }
    fn of_run<'n>(names: impl Iterator<Item = String>) -> impl Iterator<Item = Named<'n>> {
        names.map(|name| (name, None))
    }
    let points = || landmarks.points.iter().map(|point| &point.name);
    let classes = || landmarks.classes.iter().map(|class| &class.name);
    let mut names: Vec<Named> = of_run(RUN.iter().map(|(column, _)| column.name.to_owned())).collect();
    names.extend(of_each(POINT, points()));
    names.extend(of_each(CLASS, classes()));
    let channels = channels.iter().map(|channel| channel.name()).chain([RESIDUAL]);
    names.extend(of_run(channels.map(|channel| CHANNEL.name_of(channel))));
    names.extend(of_run(web::COLUMNS.iter().map(|(column, _)| column.name.to_owned())));
    names.extend(of_run(RUN_PEAKS.iter().map(|(column, _)| column.name.to_owned())));
    names.extend(of_each(POINT_PEAKS, points()));
    names.extend(of_each(CLASS_PEAKS, classes()));
    names.extend(of_each(SUPPORT, landmarks.supports.iter().map(|support| &support.name)));
    names
}

/// Two numbers of a run that would stand in one column of its history.
#[derive(Debug, Clone, PartialEq)]
pub struct Clash {
    /// The column.
    pub column: String,
    /// The point, link class or support whose name makes it.
    pub name: String,
    /// The other one; none where the column is there in every run.
    pub other: Option<String>,
}

/// The names of points, link classes and supports that make a column which stands in the history already, the first of each
/// name. What every run follows, such as the tractors, does not clash with the columns about it.
pub fn clashes(landmarks: &Landmarks) -> Vec<Clash> {
    let names = named_columns(landmarks, Channel::ALL);
    // a column of every run may stand behind that of a point
    let mut first: BTreeMap<&str, Option<&str>> = BTreeMap::new();
    for (column, of) in names.iter().rev() {
        first.insert(column, *of);
    }
    first.extend(names.iter().filter(|(_, of)| of.is_none()).map(|(column, of)| (&column[..], *of)));
    let mut found: Vec<Clash> = Vec::new();
    for (column, of) in &names {
        let (Some(name), other) = (*of, first[&column[..]]) else { continue };
        let is_followed_always = other.is_none() && FOLLOWED.contains(&name);
        if other != Some(name) && !is_followed_always && found.iter().all(|clash| clash.name != name) {
            found.push(Clash { column: column.clone(), name: name.to_owned(), other: other.map(str::to_owned) });
        }
    }
    found
}

/// The points that every run follows where it has them.
const FOLLOWED: [&str; 3] = ["tractor", "corner", "centre"];

impl RowLayout {
    /// For a run with these landmarks and channels of the energy balance.
    pub fn new(landmarks: &Landmarks, channels: &[Channel]) -> Self {
        let names: Vec<String> = named_columns(landmarks, channels).into_iter().map(|(name, _)| name).collect();
        let mut seen = BTreeSet::new();
        let kept: Vec<bool> = names.iter().map(|name| seen.insert(name.clone())).collect();
        let columns = names.into_iter().zip(&kept).filter(|(_, kept)| **kept).map(|(name, _)| name).collect();
        Self { columns, channels: channels.to_vec(), kept }
    }

    /// One row of the history, with a cell a column.
    pub fn row(&self, record: &RunRecord) -> Vec<Option<f64>> {
        let RunRecord { landmarks, frame, .. } = record;
        let mut row: Vec<Option<f64>> = RUN.iter().map(|(_, value)| value(record)).collect();
        let points: Vec<PointRecord> =
            landmarks.points.iter().enumerate().map(|(index, point)| PointRecord::new(record, index, point)).collect();
        for at in &points {
            row.extend(POINT.iter().map(|(_, value)| value(at)));
        }
        for tensions in &record.class_tensions {
            row.extend(CLASS.iter().map(|(_, value)| value(tensions)));
        }
        row.extend(self.channels.iter().map(|&channel| Some(frame.ledger[channel])));
        row.push(Some(frame.residual));
        row.extend(web::COLUMNS.iter().map(|(_, value)| value(record.web)));
        row.extend(RUN_PEAKS.iter().map(|(_, value)| value(record)));
        for at in &points {
            row.extend(POINT_PEAKS.iter().map(|(_, value)| value(at)));
        }
        for tensions in &record.class_tensions {
            row.extend(CLASS_PEAKS.iter().map(|(_, value)| value(tensions)));
        }
        for support in &landmarks.supports {
            let reaction = reaction(support, frame.net);
            row.extend(SUPPORT.iter().map(|(_, value)| value(&reaction)));
        }
        let kept = row.into_iter().zip(&self.kept).filter(|(_, kept)| **kept);
        // what overflows as a run diverges has no value
        kept.map(|(cell, _)| cell.filter(|value| value.is_finite())).collect()
    }
}

/// The energy channels of every run in their order, and what they leave unexplained.
pub(crate) fn channels() -> impl Iterator<Item = &'static str> {
    let of_every_run = Channel::ALL.iter().filter(|channel| **channel != Channel::Custom);
    of_every_run.map(|channel| channel.name()).chain([RESIDUAL])
}

impl<'r> PointRecord<'r> {
    fn new(run: &'r RunRecord<'r>, index: usize, point: &'r Landmark) -> Self {
        let place = mean(&point.nodes, |node| run.frame.position[node]);
        let travel = run.at_steps.displacement(index, place).dot(run.landmarks.axis);
        PointRecord { run, point, index, place, travel }
    }
}

impl RunRecord<'_> {
    fn outline_area(&self) -> Option<DVec3> {
        self.landmarks.outline_area(|node| self.frame.position[node])
    }

    /// Travel of a landmark along the launch axis, m; none where the web has no such landmark.
    fn travel(&self, name: &str) -> Option<f64> {
        let landmarks = self.landmarks;
        let index = landmarks.points.iter().position(|point| point.name == name)?;
        let place = mean(&landmarks.points[index].nodes, |node| self.frame.position[node]);
        Some(self.at_steps.displacement(index, place).dot(landmarks.axis))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::landmarks::LinkClass;

    fn landmarks(points: &[&str], classes: &[&str]) -> Landmarks {
        let point =
            |name: &&str| Landmark { name: name.to_string(), nodes: vec![0], is_group: false, segments: Vec::new() };
        let class = |name: &&str| LinkClass { name: name.to_string(), is_rope: true, strength: None };
        Landmarks {
            points: points.iter().map(point).collect(),
            classes: classes.iter().map(class).collect(),
            ..Landmarks::default()
        }
    }

    fn layout(points: &[&str], classes: &[&str]) -> RowLayout {
        let of_every_run = Channel::ALL.iter().copied().filter(|channel| *channel != Channel::Custom);
        RowLayout::new(&landmarks(points, classes), &of_every_run.collect::<Vec<_>>())
    }

    #[test]
    fn columns_stand_in_the_order_of_the_contract() {
        let names = layout(&["B"], &["ring"]).columns;
        assert_eq!(names[0], "time_s");
        assert_eq!(
            names[8..17],
            [
                "B_x_m",
                "B_y_m",
                "B_z_m",
                "B_travel_m",
                "B_speed_m_s",
                "B_tension_n",
                "ring_mean_n",
                "ring_max_n",
                "energy_kinetic_j",
            ]
        );
        let web = names.iter().position(|name| name == "mass_centre_height_m").unwrap();
        assert_eq!(names[web + 1..], ["tension_peak_n", "B_speed_peak_m_s", "B_tension_peak_n", "ring_peak_n"]);
    }

    /// Names that make each column of a run, were they those of a point, a class or a support.
    #[test]
    fn a_name_that_makes_a_column_of_every_run_clashes_with_it() {
        let named = |points: &[&str], classes: &[&str]| {
            let landmarks = landmarks(points, classes);
            clashes(&landmarks).into_iter().map(|clash| (clash.name, clash.column)).collect::<Vec<_>>()
        };
        let of_run: Vec<String> =
            named_columns(&Landmarks::default(), Channel::ALL).into_iter().map(|(name, _)| name).collect();
        let mut checked = 0;
        for column in &of_run {
            for (pattern, is_point) in POINT
                .iter()
                .chain(POINT_PEAKS)
                .map(|(c, _)| (c.name, true))
                .chain(CLASS.iter().chain(CLASS_PEAKS).map(|(c, _)| (c.name, false)))
            {
                let Some(name) = column.strip_suffix(&pattern[2..]).filter(|name| !FOLLOWED.contains(name)) else {
                    continue;
                };
                let found = if is_point { named(&[name], &[]) } else { named(&[], &[name]) };
                assert!(found.iter().any(|(of, _)| of == name), "{name}: {found:?}");
                checked += 1;
            }
        }
        assert!(checked >= 3, "{checked}");
        // a class against a point, and what is followed in every run
        assert_eq!(named(&["B"], &["B_tension"]), [("B_tension".to_owned(), "B_tension_peak_n".to_owned())]);
        assert_eq!(named(&["B", "tractor", "corner", "centre"], &["ring"]), []);
    }

    #[test]
    fn no_column_stands_twice() {
        let layout = layout(&["B", "tractor"], &["ring"]);
        let names = &layout.columns;
        assert_eq!(names.iter().filter(|name| *name == "tractor_travel_m").count(), 1);
        assert!(names.contains(&"tractor_speed_m_s".to_string()));
        assert_eq!(layout.kept.iter().filter(|kept| **kept).count(), names.len());
    }
}

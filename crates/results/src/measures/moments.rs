//! The moments that every result shows, whatever is recorded: the highest tension, the largest area, when the web
//! becomes 80 % open and when it stops being so.
//!
//! A largest value grows over many steps. Its frame is kept again whenever it has grown by another part, so that a run
//! copies the net at a few hundred steps at most; and when the value begins to fall.
//!
//! Forces are known only once the net has left the place where they act. So the tensions of a step are noted when it is
//! the highest so far, and go into the frame that is kept one or two steps later.

use glam::{DQuat, DVec3};
use netcast_dynamics::simulate::{Frame, Live};
use serde::{Deserialize, Serialize};

/// How much a tension must exceed that of the kept frame.
const TENSION_GROWTH: f64 = 1.005;
/// How much an area must exceed that of the kept frame, while it grows.
const AREA_GROWTH: f64 = 1.01;

/// The whole net at one time, as it goes into the fields.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct KeptFrame {
    /// Time, s.
    pub time: f64,
    /// Positions, m, (nodes,).
    pub position: Vec<DVec3>,
    /// Velocities, m/s, (nodes,).
    pub velocity: Vec<DVec3>,
    /// Tensions, N, (segments,); NaN where a segment is broken.
    pub tension: Vec<f64>,
    /// Orientations of rigid bodies, (bodies,).
    pub orientation: Vec<DQuat>,
}

impl KeptFrame {
    fn of(frame: &Frame) -> KeptFrame {
        KeptFrame {
            time: frame.time,
            position: frame.position.to_vec(),
            velocity: frame.velocity.to_vec(),
            tension: frame.tension.to_vec(),
            orientation: frame.rotation.iter().map(|rotation| rotation.orientation).collect(),
        }
    }
}

/// What a step tells of the web as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Glance {
    /// Highest tension of any rope, N.
    pub tension: f64,
    /// Outline area along the launch axis, m^2; none for a web without an outline.
    pub area: Option<f64>,
    /// Whether the web is at least 80 % open.
    pub is_open: bool,
}

/// The moments of a run so far.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Moments {
    last: Glance,
    /// The highest tension so far, N, and the tensions of its step, N, (segments,).
    highest: (f64, Vec<f64>),
    tension: Option<(f64, KeptFrame)>,
    area: Option<(f64, KeptFrame)>,
    /// The start of the spell that the web is open for now.
    opens: Option<KeptFrame>,
    /// Start and end of the longest spell that is over.
    longest: Option<(KeptFrame, KeptFrame)>,
}

/// The moments of a run, at its end; none where the run has no such thing.
#[derive(Debug, Default)]
pub struct MomentFrames<'m> {
    pub tension_max: Option<&'m KeptFrame>,
    pub area_max: Option<&'m KeptFrame>,
    pub opens: Option<&'m KeptFrame>,
    pub closes: Option<&'m KeptFrame>,
}

impl Moments {
    /// Takes note of a step. Returns whether the net after it belongs to the moments.
    pub fn step(&mut self, now: Glance, live: &Live) -> bool {
        let kept = |moment: &Option<(f64, KeptFrame)>| moment.as_ref().map_or(0.0, |(value, _)| *value);
        let area = now.area.unwrap_or(0.0);
        let last = std::mem::replace(&mut self.last, now);
        let before = last.area.unwrap_or(0.0);
        if now.tension > self.highest.0 {
            self.note_tensions(now.tension, live);
        }
        let shrinks = area < before && before > kept(&self.area) * (1.0 + 1e-9);
        let falls = now.tension < self.highest.0 && self.highest.0 > kept(&self.tension) * (1.0 + 1e-9);
        let (grown, opened) = (now.tension > TENSION_GROWTH * kept(&self.tension), now.is_open != last.is_open);
        grown || falls || shrinks || opened || area > AREA_GROWTH * kept(&self.area)
    }

    fn note_tensions(&mut self, highest: f64, live: &Live) {
        let (value, tensions) = &mut self.highest;
        *value = highest;
        let tension = |segment: usize| if live.net.is_gone(segment) { f64::NAN } else { live.net.tension(segment) };
        tensions.clear();
        tensions.extend((0..live.net.system().segments().len()).map(tension));
    }

    /// Keeps the net at a wanted step. `area`, m^2, is that of the frame; `is_open` says whether the web is open.
    pub fn keep(&mut self, frame: &Frame, area: Option<f64>, is_open: bool) {
        let larger = |moment: &Option<(f64, KeptFrame)>, value: f64| match moment {
            None => value > 0.0,
            Some((kept, _)) => value > *kept,
        };
        let (highest, tensions) = &self.highest;
        if larger(&self.tension, *highest) {
            self.tension = Some((*highest, KeptFrame { tension: tensions.clone(), ..KeptFrame::of(frame) }));
        }
        if let Some(area) = area.filter(|&area| larger(&self.area, area)) {
            self.area = Some((area, KeptFrame::of(frame)));
        }
        if is_open && self.opens.is_none() {
            self.opens = Some(KeptFrame::of(frame));
        }
        if !is_open && let Some(opens) = self.opens.take() {
            let length = frame.time - opens.time;
            if self.longest.as_ref().is_none_or(|(from, to)| length > to.time - from.time) {
                self.longest = Some((opens, KeptFrame::of(frame)));
            }
        }
    }

    /// The moments at the end of a run, `time`, s. A web that is open then does not close.
    pub fn finish(&self, time: f64) -> MomentFrames<'_> {
        let over = self.longest.as_ref().map_or(0.0, |(from, to)| to.time - from.time);
        let (opens, closes) = match (&self.opens, &self.longest) {
            (Some(opens), _) if time - opens.time > over => (Some(opens), None),
            (_, longest) => longest.as_ref().map(|(opens, closes)| (opens, closes)).unzip(),
        };
        let [tension_max, area_max] = [&self.tension, &self.area].map(|moment| moment.as_ref().map(|(_, frame)| frame));
        MomentFrames { tension_max, area_max, opens, closes }
    }
}

impl<'m> MomentFrames<'m> {
    /// The frames, in no order.
    pub fn iter(&self) -> impl Iterator<Item = &'m KeptFrame> + use<'m> {
        [self.tension_max, self.area_max, self.opens, self.closes].into_iter().flatten()
    }
}

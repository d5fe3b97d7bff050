//! Packs a run into few bytes: whole numbers on a grid, differences in time, deflate.
//!
//! ```text
//!  u32          length of the JSON, little endian, as all that follows
//!  JSON         times, meanings, scales; padded with spaces to a multiple of four
//!  u32 * 2 s    ends of the segments, then u8 * s their link classes
//!  u8 * 3 n f   positions, low bytes [frame][axis][node], then as many high bytes
//!  u8 * s f     tensions [frame][segment]
//! ```
//!
//! A position is a 16 bit number of steps in the cube that the run fills. The bytes hold its difference from the linear
//! extrapolation of the last two frames, modulo 2^16, with the sign in the lowest bit. A tension is a code on a
//! logarithmic scale: 0 is slack, 254 is the largest of the run, 1 is a hundred-thousandth of the largest or less, and
//! 255 is a broken segment.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;
use glam::DVec3;
use netcast_results::{BodyShape, OPEN_SHARE};
use serde_json::{Value, json};

use super::thin::Drawn;
use crate::pictures::tension_scale;
use crate::results::Scene;

/// Orders of magnitude between the codes 1 and 254 of a tension.
const TENSION_DECADES: f64 = 5.0;

/// The code of a broken segment.
const BROKEN: u8 = 255;

/// Share of the tensions of taut ropes that are below the end of the linear scale.
const LINEAR_SCALE_SHARE: f64 = 0.995;

/// The part of a run that is kept: every n-th frame, every n-th node inside a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sampling {
    /// Stride of the frames.
    pub frames: usize,
    /// Stride of the nodes inside a rope.
    pub nodes: usize,
}

/// The deflated bytes of a run with every `stride`-th frame; `wind` in m/s.
pub(crate) fn pack(scene: &Scene, drawn: &Drawn, stride: usize, wind: Option<[f64; 3]>) -> Vec<u8> {
    let frames = kept_frames(scene, stride);
    let grid = Grid::around(scene, drawn, &frames);
    let tensions = Tensions::of(scene, drawn, &frames);
    let mut deflated = ZlibEncoder::new(Vec::new(), Compression::default());
    let mut put = |bytes: &[u8]| deflated.write_all(bytes).expect("memory takes what it is given");

    let mut meanings = meanings(scene, drawn, &frames, &grid, &tensions);
    meanings["wind_m_s"] = json!(wind);
    let mut meanings = meanings.to_string();
    meanings.push_str(&" ".repeat(meanings.len().next_multiple_of(4) - meanings.len()));
    put(&(meanings.len() as u32).to_le_bytes());
    put(meanings.as_bytes());
    for segment in &drawn.segments {
        for end in segment.ends {
            put(&end.to_le_bytes());
        }
    }
    put(&drawn.segments.iter().map(|segment| segment.class as u8).collect::<Vec<u8>>());
    let positions = grid.differences(scene, drawn, &frames);
    for byte in 0..2 {
        put(&positions.iter().map(|difference| difference.to_le_bytes()[byte]).collect::<Vec<u8>>());
    }
    for &frame in &frames {
        put(&tensions.codes(scene, drawn, frame));
    }
    deflated.finish().expect("memory takes what it is given")
}

/// Every `stride`-th frame, the last one, and those of the largest area and of the largest tension.
fn kept_frames(scene: &Scene, stride: usize) -> Vec<usize> {
    let last = scene.frames() - 1;
    let largest = |value: &dyn Fn(usize) -> f64| {
        (0..=last).max_by(|&one, &other| value(one).total_cmp(&value(other))).unwrap_or(last)
    };
    let mut frames: Vec<usize> = (0..=last).step_by(stride).collect();
    if stride > 1 {
        let highest = |frame| scene.fields.tensions(frame).iter().copied().fold(0.0, f64::max);
        frames.extend([last, largest(&|frame| area(scene, frame).unwrap_or(0.0)), largest(&highest)]);
        frames.sort_unstable();
        frames.dedup();
    }
    frames
}

/// Area of the outline along the launch axis, m^2.
fn area(scene: &Scene, frame: usize) -> Option<f64> {
    let positions = scene.fields.positions(frame);
    let area = scene.landmarks.outline_area(|node| positions[node])?;
    Some(area.dot(scene.landmarks.axis).abs())
}

/// The cube that the run fills, with 2^16 grid planes along each side.
struct Grid {
    origin: DVec3,
    step: f64,
}

impl Grid {
    fn around(scene: &Scene, drawn: &Drawn, frames: &[usize]) -> Self {
        let all = || {
            let drawn_of = |frame: usize| drawn.nodes.iter().map(move |&node| scene.fields.positions(frame)[node]);
            frames.iter().flat_map(move |&frame| drawn_of(frame)).filter(|position| position.is_finite())
        };
        let low = all().reduce(DVec3::min).unwrap_or_default();
        let high = all().reduce(DVec3::max).unwrap_or_default();
        // a run at a single point can have any step
        let size = (high - low).max_element();
        Self { origin: low, step: if size > 0.0 { size / f64::from(u16::MAX) } else { 1.0 } }
    }

    /// The grid coordinates of a position. A failed run may end in NaN, which becomes 0.
    fn place(&self, position: DVec3) -> [u16; 3] {
        ((position - self.origin) / self.step).round().to_array().map(|steps| steps as u16)
    }

    /// The difference of each position from the linear extrapolation of its last two frames, `[frame][axis][node]`.
    fn differences(&self, scene: &Scene, drawn: &Drawn, frames: &[usize]) -> Vec<u16> {
        let mut differences = Vec::with_capacity(3 * drawn.nodes.len() * frames.len());
        let mut last = vec![[0u16; 3]; drawn.nodes.len()];
        let mut expected = last.clone();
        for (count, &frame) in frames.iter().enumerate() {
            let positions = scene.fields.positions(frame);
            let places: Vec<[u16; 3]> = drawn.nodes.iter().map(|&node| self.place(positions[node])).collect();
            for axis in 0..3 {
                let pairs = places.iter().zip(&expected);
                differences.extend(pairs.map(|(place, expected)| folded(place[axis].wrapping_sub(expected[axis]))));
            }
            for (node, place) in places.iter().enumerate() {
                expected[node] = [0, 1, 2].map(|axis| match count {
                    0 => place[axis],
                    _ => place[axis].wrapping_mul(2).wrapping_sub(last[node][axis]),
                });
            }
            last = places;
        }
        differences
    }
}

/// A difference with its sign in the lowest bit, so that small differences of either sign are small numbers.
fn folded(difference: u16) -> u16 {
    let signed = difference as i16;
    ((signed << 1) ^ (signed >> 15)) as u16
}

/// The scale of the tensions.
struct Tensions {
    /// The largest tension of a rope, N; at least 1e-9, so that its logarithm is finite.
    largest: f64,
    /// End of the linear scale, N: a share [`LINEAR_SCALE_SHARE`] of the taut tensions is below it.
    linear_top: f64,
}

impl Tensions {
    /// The scale of the tensions of ropes; those of canopy members, ties and stitches may exceed it.
    fn of(scene: &Scene, drawn: &Drawn, frames: &[usize]) -> Self {
        let parts = drawn.segments.iter().flat_map(|segment| segment.parts.iter().copied());
        let ropes: Vec<usize> = parts.filter(|part| scene.is_rope(*part)).collect();
        let borne = |&frame: &usize| ropes.iter().map(move |&segment| scene.fields.tensions(frame)[segment]);
        let mut taut: Vec<f64> = frames.iter().flat_map(borne).filter(|&tension| tension > 0.0).collect();
        let place = (taut.len() as f64 * LINEAR_SCALE_SHARE) as usize;
        let linear_top = if place < taut.len() { *taut.select_nth_unstable_by(place, f64::total_cmp).1 } else { 1.0 };
        Self { largest: taut.iter().copied().filter(|tension| tension.is_finite()).fold(1e-9, f64::max), linear_top }
    }

    fn code(&self, tension: f64) -> u8 {
        if tension.is_nan() {
            BROKEN
        } else if tension > 0.0 {
            let decades = (tension / self.largest).log10() + TENSION_DECADES;
            (1.0 + 253.0 * decades / TENSION_DECADES).round().clamp(1.0, 254.0) as u8
        } else {
            0
        }
    }

    fn codes(&self, scene: &Scene, drawn: &Drawn, frame: usize) -> Vec<u8> {
        let tensions = scene.fields.tensions(frame);
        // NaN, a broken segment, prevails: a drawn segment breaks with the first of its parts
        let larger = |one: f64, other: f64| if other > one || other.is_nan() { other } else { one };
        let largest = |parts: &[usize]| parts.iter().map(|&part| tensions[part]).fold(0.0, larger);
        drawn.segments.iter().map(|segment| self.code(largest(&segment.parts))).collect()
    }
}

/// The JSON of all that is not an array of bytes.
fn meanings(scene: &Scene, drawn: &Drawn, frames: &[usize], grid: &Grid, tensions: &Tensions) -> Value {
    let landmarks = &scene.landmarks;
    let place = |node: &usize| drawn.nodes.binary_search(node).expect("what has a meaning is drawn");
    let places = |nodes: &[usize]| nodes.iter().map(place).collect::<Vec<usize>>();
    let points = landmarks.points.iter().filter(|point| !point.is_group);
    let named = ["corner", "centre"];
    let classes = landmarks.classes.iter().map(|class| json!({"name": class.name, "is_rope": class.is_rope}));
    let classes: Vec<Value> = classes.collect();
    let is_aside = |node: &&usize| scene.of_web.binary_search(node).is_err();
    let aside: Vec<usize> = drawn.nodes.iter().filter(is_aside).map(place).collect();
    json!({
        "frames": frames.len(),
        "nodes": drawn.nodes.len(),
        "segments": drawn.segments.len(),
        "times_s": frames.iter().map(|&frame| scene.fields.times[frame]).collect::<Vec<f64>>(),
        "origin_m": grid.origin.to_array(),
        "step_m": grid.step,
        "tension_max_n": tensions.largest,
        "tension_decades": TENSION_DECADES,
        "tension_linear_top_n": tensions.linear_top,
        "tension_edges_n": tension_scale(scene).edges(),
        "classes": classes,
        "aside": aside,
        "axis": landmarks.axis.to_array(),
        "ground_m": landmarks.ground,
        "areas_m2": frames.iter().map(|&frame| area(scene, frame)).collect::<Vec<_>>(),
        "reference_area_m2": landmarks.reference_area,
        "open_share": OPEN_SHARE,
        "outline": landmarks.outline.iter().map(|nodes| places(nodes)).collect::<Vec<_>>(),
        "tractors": places(&landmarks.tractors),
        "points": points
            .filter(|point| !named.contains(&point.name.as_str()))
            .map(|point| json!({"name": point.name, "nodes": places(&point.nodes)}))
            .collect::<Vec<_>>(),
        "canopies": landmarks
            .canopies
            .iter()
            .flat_map(|canopy| canopy.faces())
            .map(|face| places(&face))
            .collect::<Vec<_>>(),
        "bodies": landmarks
            .bodies
            .iter()
            .map(|body| {
                let turned = |body: usize| frames.iter().flat_map(move |&frame| orientation(scene, frame, body));
                json!({
                    "kind": body.kind,
                    "node": place(&body.node),
                    "shape": shape(&body.shape),
                    "size_m": body.shape.size_m(),
                    "turned": body.rigid.map(|body| turned(body).collect::<Vec<f64>>()),
                })
            })
            .collect::<Vec<_>>(),
    })
}

/// A body's orientation in a frame, x, y, z, w, to a ten-thousandth: far finer than a pixel.
fn orientation(scene: &Scene, frame: usize, body: usize) -> [f64; 4] {
    scene.fields.orientations(frame)[body].to_array().map(|part| (1e4 * part).round() / 1e4)
}

/// The mesh that a body is drawn with.
fn shape(shape: &BodyShape) -> &'static str {
    match shape {
        BodyShape::Cylinder { .. } => "cylinder",
        BodyShape::Box { .. } => "box",
        BodyShape::Sphere { .. } | BodyShape::Particle => "sphere",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_differences_of_either_sign_are_small_numbers() {
        let signed = [0i16, -1, 1, -2, 2, i16::MAX, i16::MIN].map(|difference| folded(difference as u16));
        assert_eq!(signed, [0, 1, 2, 3, 4, 65534, 65535]);
    }

    #[test]
    fn codes_of_tensions_are_logarithmic() {
        let scale = Tensions { largest: 1e5, linear_top: 1e4 };
        assert_eq!([-3.0, 0.0, f64::NAN].map(|tension| scale.code(tension)), [0, 0, BROKEN]);
        assert_eq!([1e-4, 1.0, 1e5, 2e5].map(|tension| scale.code(tension)), [1, 1, 254, 254]);
        // equal ratios differ by equally many codes, to within rounding
        assert!((scale.code(10.0) - scale.code(1.0)).abs_diff(scale.code(1e4) - scale.code(1e3)) <= 1);
    }
}

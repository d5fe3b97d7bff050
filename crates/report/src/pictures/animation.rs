//! The launch in slow motion, as a GIF.
//!
//! The frames are evenly spaced in time. They share one fixed palette: each rope colour at several degrees of cover
//! over white. So a colour means the same in every frame, and nothing flickers. A frame stores only the rectangle that
//! changed since the one before.

use std::collections::HashMap;
use std::num::NonZero;
use std::thread;

use gif::{Encoder, Frame, Repeat};
use glam::DVec2;
use resvg::tiny_skia::Pixmap;

use super::camera::{Camera, View};
use super::colour::{BINS, TensionScale, bin_colour};
use super::key_frames::tension_scale;
use super::net_picture::{Labelling, NetPicture, extent, open_share};
use super::raster::pixels;
use super::sheet::{KEY_SIZE, key, standalone};
use super::strands::Strands;
use super::svg_text::text;
use super::theme::light_rgb;
use crate::format::{share_of_flat, time};
use crate::results::Scene;

/// Width and height, px.
const SIZE: (u16, u16) = (640, 480);

/// Height of the text above the net, px.
const HEAD: f64 = 52.0;

/// Height of the key below the net, px.
const FOOT: f64 = 56.0;

/// Most frames of an animation.
const MOST_FRAMES: usize = 120;

/// Time that each frame is shown, hundredths of a second.
const DELAY: u16 = 5;

/// The picture holds the whole flight if that draws the web at this share of its largest possible size or more; else it
/// follows the web.
const LEAST_SHARE: f64 = 0.4;

/// The launch as the bytes of a GIF file, with a title at the top.
pub(crate) fn gif(scene: &Scene, title: &str) -> Vec<u8> {
    let frames = chosen_frames(scene);
    let film = Film::new(scene, title, &frames);
    let palette = Palette::new();
    let threads = thread::available_parallelism().map_or(1, NonZero::get).min(frames.len());
    // each thread draws one stretch of the frames; joining them in order keeps the order of time
    let images: Vec<Vec<u8>> = thread::scope(|scope| {
        let stretches = frames.chunks(frames.len().div_ceil(threads));
        let (film, palette) = (&film, &palette);
        let draw = |stretch: &[usize]| {
            let mut known = HashMap::new();
            stretch.iter().map(|&frame| palette.indices(&pixels(&film.svg(frame), 1.0), &mut known)).collect()
        };
        let workers: Vec<_> = stretches.map(|stretch| scope.spawn(move || -> Vec<Vec<u8>> { draw(stretch) })).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("a worker draws to its end")).collect()
    });
    encode(&images, &palette.colours)
}

/// Indices of at most [`MOST_FRAMES`] frames, evenly spaced in time.
fn chosen_frames(scene: &Scene) -> Vec<usize> {
    let count = scene.frames().min(MOST_FRAMES);
    let times = &scene.fields.times;
    let (from, to) = (times[0], times[scene.frames() - 1]);
    (0..count).map(|place| scene.frame_at(from + (to - from) * place as f64 / (count - 1).max(1) as f64)).collect()
}

/// What all frames of the animation share.
struct Film<'a> {
    scene: &'a Scene,
    strands: Strands,
    scale: TensionScale,
    camera: Camera,
    px_per_m: f64,
    /// The middle of the picture, m in the camera's plane; none where it follows the web.
    centre: Option<DVec2>,
    head: String,
    speed: String,
}

impl<'a> Film<'a> {
    fn new(scene: &'a Scene, title: &str, frames: &[usize]) -> Self {
        let camera = Camera::new(View::ThreeQuarter, scene.landmarks.axis);
        let extents: Vec<(DVec2, DVec2)> = frames.iter().map(|&frame| extent(scene, frame, &camera)).collect();
        let (least, most) = extents
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(least, most), seen| (least.min(seen.0), most.max(seen.1)));
        let largest = extents.iter().fold(DVec2::splat(1e-3), |largest, (least, most)| largest.max(*most - *least));
        // room for the labels at the edges
        let room = picture_size() - DVec2::splat(44.0);
        let scale_for = |extent: DVec2| (room / extent.max(DVec2::splat(1e-3))).min_element();
        let (whole, web) = (scale_for(most - least), scale_for(largest));
        let follows = whole < LEAST_SHARE * web;
        Self {
            scene,
            strands: Strands::new(scene),
            scale: tension_scale(scene),
            camera,
            px_per_m: if follows { web } else { whole },
            centre: (!follows).then_some(0.5 * (least + most)),
            head: shortened(title, 62),
            speed: speed(scene, frames.len()),
        }
    }

    fn svg(&self, frame: usize) -> String {
        let (width, height) = (f64::from(SIZE.0), f64::from(SIZE.1));
        let mut svg = standalone(width, height);
        let share = open_share(self.scene, frame).map(|share| format!("{} of the flat area", share_of_flat(share)));
        svg.push_str(&format!(
            "<text class=\"name\" x=\"12\" y=\"20\">{}</text>\
             <text class=\"name\" x=\"12\" y=\"40\">{}</text><text class=\"soft\" x=\"90\" y=\"40\">{}</text>\
             <text class=\"soft\" x=\"{}\" y=\"40\" text-anchor=\"end\">{}</text><g transform=\"translate(0 {HEAD})\">",
            text(&self.head),
            time(self.scene.fields.times[frame]),
            share.unwrap_or_default(),
            width - 12.0,
            self.speed
        ));
        let centre = self.centre.unwrap_or_else(|| {
            let (least, most) = extent(self.scene, frame, &self.camera);
            0.5 * (least + most)
        });
        let picture = NetPicture {
            scene: self.scene,
            strands: &self.strands,
            scale: &self.scale,
            camera: self.camera,
            px_per_m: self.px_per_m,
            size: picture_size(),
            mark: None,
            labelling: Labelling::Steady,
        };
        picture.draw(frame, centre, &mut svg);
        let (left, top) = (0.5 * (width - KEY_SIZE.0), height - FOOT + 6.0);
        svg.push_str(&format!("</g><g transform=\"translate({left} {top})\">{}</g></svg>", key(&self.scale)));
        svg
    }
}

/// Width and height of the part of the frame that shows the net, px.
fn picture_size() -> DVec2 {
    DVec2::new(SIZE.0.into(), f64::from(SIZE.1) - HEAD - FOOT)
}

/// The playback speed in words.
fn speed(scene: &Scene, frames: usize) -> String {
    let times = &scene.fields.times;
    let shown = frames as f64 * f64::from(DELAY) / 100.0;
    let passed = times[scene.frames() - 1] - times[0];
    match shown / passed {
        slowed if !slowed.is_finite() => String::new(),
        slowed if slowed >= 1.0 => format!("{} times slower than life", two_digits(slowed)),
        slowed => format!("{} times faster than life", two_digits(1.0 / slowed)),
    }
}

/// A ratio of at least 1: `2.4`, `10`, `120`.
fn two_digits(ratio: f64) -> String {
    if ratio < 9.95 { format!("{ratio:.1}") } else { format!("{ratio:.0}") }
}

/// A title of at most `length_max` characters, with an ellipsis where it is cut.
fn shortened(title: &str, length_max: usize) -> String {
    if title.chars().count() <= length_max {
        return title.to_owned();
    }
    title.chars().take(length_max - 1).chain(['…']).collect()
}

/// The colours that all frames share.
struct Palette {
    colours: Vec<[u8; 3]>,
}

/// Degrees of cover of a colour over white, not counting none.
const DEGREES: usize = 14;

impl Palette {
    fn new() -> Self {
        let mut colours = vec![[255; 3]];
        let ropes = (0..BINS).map(bin_colour);
        let full = ropes.chain(["--slack", "--ink", "--soft"].map(light_rgb));
        for colour in full {
            colours.extend((1..=DEGREES).map(|degree| over_white(colour, degree, DEGREES)));
        }
        // the shaded outline and the canopies, which may overlap
        colours.extend((1..=20).map(|degree| over_white(light_rgb("--accent"), degree, 40)));
        Self { colours }
    }

    /// Palette index of each pixel of an opaque picture; `known` caches the colours found so far.
    fn indices(&self, picture: &Pixmap, known: &mut HashMap<[u8; 3], u8>) -> Vec<u8> {
        let index = |pixel: [u8; 3]| *known.entry(pixel).or_insert_with(|| self.nearest(pixel));
        picture.pixels().iter().map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).map(index).collect()
    }

    /// Index of the nearest colour of the palette.
    fn nearest(&self, pixel: [u8; 3]) -> u8 {
        let distance = |colour: &[u8; 3]| -> u32 {
            colour.iter().zip(pixel).map(|(&one, other)| u32::from(one.abs_diff(other)).pow(2)).sum()
        };
        let places = 0..self.colours.len() as u8;
        places.min_by_key(|&place| distance(&self.colours[usize::from(place)])).unwrap_or(0)
    }
}

/// A colour that covers white by `degree / of`.
fn over_white(colour: [u8; 3], degree: usize, of: usize) -> [u8; 3] {
    colour.map(|channel| (255 - (255 - usize::from(channel)) * degree / of) as u8)
}

/// Frames of palette indices as the bytes of a GIF that repeats without end.
fn encode(images: &[Vec<u8>], palette: &[[u8; 3]]) -> Vec<u8> {
    let (width, height) = SIZE;
    let mut encoder = Encoder::new(Vec::new(), width, height, palette.as_flattened()).expect("memory takes everything");
    encoder.set_repeat(Repeat::Infinite).expect("memory takes everything");
    let mut before: Option<&Vec<u8>> = None;
    for image in images {
        let part = before.map_or((0..usize::from(width), 0..usize::from(height)), |before| changed(before, image));
        let rows = part.1.clone().map(|row| row * usize::from(width));
        let cut: Vec<u8> = rows.flat_map(|start| &image[start + part.0.start..start + part.0.end]).copied().collect();
        let frame = Frame {
            delay: DELAY,
            left: part.0.start as u16,
            top: part.1.start as u16,
            ..Frame::from_indexed_pixels(part.0.len() as u16, part.1.len() as u16, cut, None)
        };
        encoder.write_frame(&frame).expect("memory takes everything");
        before = Some(image);
    }
    encoder.into_inner().expect("memory takes everything")
}

/// The columns and rows of the smallest rectangle with every changed pixel. Where none changed it is one pixel, since a
/// frame must not be empty.
fn changed(before: &[u8], image: &[u8]) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
    let width = usize::from(SIZE.0);
    let differs = |row: usize| before[row * width..][..width] != image[row * width..][..width];
    let rows = 0..usize::from(SIZE.1);
    let Some(top) = rows.clone().find(|&row| differs(row)) else { return (0..1, 0..1) };
    let bottom = rows.rev().find(|&row| differs(row)).unwrap_or(top);
    let (mut left, mut right) = (width, 0);
    for row in top..=bottom {
        let pairs = before[row * width..][..width].iter().zip(&image[row * width..][..width]);
        for (column, _) in pairs.enumerate().filter(|(_, (one, other))| one != other) {
            (left, right) = (left.min(column), right.max(column));
        }
    }
    (left..right + 1, top..bottom + 1)
}

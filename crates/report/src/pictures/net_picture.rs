//! Draws one frame of a net as SVG.
//!
//! Ropes have the colour of their bin of tension; slack ropes are drawn first and those of the highest bin last. Bodies
//! have their true size and orientation; a smaller one is a dot that can still be seen. The outline is shaded while the
//! web is at least 80 % open.

use glam::{DVec2, DVec3, IVec2};
use netcast_results::{BodyKind, BodyMark, CanopyMark, OPEN_SHARE};

use super::body_outline::outline;
use super::camera::Camera;
use super::colour::{BINS, TensionScale};
use super::series;
use super::strands::Strands;
use super::svg_text::text as safe;
use super::theme::bin_stroke;
use crate::results::Scene;

/// Units of a coordinate in a pixel.
const TENTHS: f64 = 10.0;

/// With more tractors than this, none is numbered.
const MOST_NUMBERED: usize = 12;

/// Least radius of a tractor, and of a payload or sensor, px.
const LEAST_RADIUS: (f64, f64) = (3.0, 1.4);

/// Radius of the mark of a feature point, px.
const POINT_RADIUS: f64 = 2.0;

/// Radius of the ring round a marked place, px.
const MARK_RADIUS: f64 = 6.0;

/// The settings of a picture, without the frame.
pub(crate) struct NetPicture<'a> {
    pub scene: &'a Scene,
    pub strands: &'a Strands,
    pub scale: &'a TensionScale,
    pub camera: Camera,
    pub px_per_m: f64,
    /// Width and height, px.
    pub size: DVec2,
    /// World position to mark with a ring, m.
    pub mark: Option<DVec3>,
    pub labelling: Labelling,
}

/// How labels of points and tractors are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Labelling {
    /// On a free side; a label without one is left out.
    Apart,
    /// Always at the upper right, so that labels do not jump from frame to frame; tractors have none.
    Steady,
}

impl NetPicture<'_> {
    /// Appends a frame to `svg`, with the point `centre` of the camera's plane, m, in the middle of the picture.
    pub fn draw(&self, frame: usize, centre: DVec2, svg: &mut String) {
        let positions = self.scene.fields.positions(frame);
        let place = |point| self.place(self.camera.project(point), centre);
        let points: Vec<IVec2> = positions.iter().map(|&point| place(point)).collect();
        let mean = |nodes: &[usize]| place(self.scene.mean(frame, nodes));

        svg.push_str("<g transform=\"scale(.1)\">");
        self.draw_outline(frame, mean, svg);
        self.draw_canopies(&points, svg);
        self.draw_ropes(frame, &points, svg);
        svg.push_str("</g>");
        let mut labels = Labels::new(self.size, self.labelling);
        self.draw_bodies(frame, &points, &mut labels, svg);
        self.draw_points(mean, &mut labels, svg);
        if let Some(mark) = self.mark {
            labels.circle("mark", place(mark), MARK_RADIUS, svg);
        }
        svg.push_str(&labels.svg);
        self.draw_scale_bar(svg);
    }

    /// A point of the camera's plane, m, in the picture: tenths of a pixel to the right and down.
    fn place(&self, seen: DVec2, centre: DVec2) -> IVec2 {
        let from_centre = (seen - centre) * DVec2::new(self.px_per_m, -self.px_per_m);
        ((from_centre + 0.5 * self.size) * TENTHS).round().as_ivec2()
    }

    fn draw_outline(&self, frame: usize, mean: impl Fn(&[usize]) -> IVec2, svg: &mut String) {
        if open_share(self.scene, frame).is_some_and(|share| share >= OPEN_SHARE) {
            let vertices = self.scene.landmarks.outline.iter().map(|nodes| mean(nodes));
            svg.push_str(&format!("<path class=\"open\" d=\"{}\"/>", polygon(vertices)));
        }
    }

    fn draw_canopies(&self, points: &[IVec2], svg: &mut String) {
        let canopies = &self.scene.landmarks.canopies;
        if canopies.is_empty() {
            return;
        }
        let path: String = canopies
            .iter()
            .flat_map(CanopyMark::loops)
            .map(|corners| polygon(corners.iter().map(|&node| points[node])))
            .collect();
        svg.push_str(&format!("<path class=\"canopy\" d=\"{path}\"/>"));
    }

    fn draw_ropes(&self, frame: usize, points: &[IVec2], svg: &mut String) {
        let paths = self.strands.paths(points, self.scene.fields.tensions(frame), self.scale);
        // a dense net has thinner lines
        let fineness = (3000.0 / self.scene.fields.topology.segments.len().max(1) as f64).sqrt().clamp(0.4, 1.0);
        svg.push_str("<g class=\"ropes\">");
        for bin in [BINS].into_iter().chain(0..BINS).filter(|&bin| !paths[bin].is_empty()) {
            let colour = bin_stroke(bin).map(|colour| format!(" stroke=\"{colour}\"")).unwrap_or_default();
            let width = if bin == BINS { 6.0 } else { 7.5 + 0.4 * bin as f64 };
            let path = &paths[bin];
            svg.push_str(&format!("<path{colour} stroke-width=\"{:.1}\" d=\"{path}\"/>", fineness * width));
        }
        svg.push_str("</g>");
    }

    fn draw_bodies(&self, frame: usize, points: &[IVec2], labels: &mut Labels, svg: &mut String) {
        let turned = self.scene.fields.orientations(frame);
        let landmarks = &self.scene.landmarks;
        // payloads and sensors first, so that they hide no tractor
        let (tractors, others): (Vec<_>, Vec<_>) =
            landmarks.bodies.iter().partition(|body| body.kind == BodyKind::Tractor);
        let are_numbered = self.labelling == Labelling::Apart && landmarks.tractors.len() <= MOST_NUMBERED;
        for body in others.into_iter().chain(tractors) {
            let (class, least) = match body.kind {
                BodyKind::Tractor => ("tractor", LEAST_RADIUS.0),
                BodyKind::Payload | BodyKind::Sensor => ("payload", LEAST_RADIUS.1),
            };
            let corners = body.rigid.map_or(Vec::new(), |rigid| outline(&body.shape, turned[rigid], &self.camera));
            let reach = self.px_per_m * corners.iter().map(|corner| corner.length()).fold(0.0, f64::max);
            // draw the true size unless it is too small to be seen
            let radius = if reach > least {
                let corners = corners.iter().map(|corner| corner * DVec2::new(self.px_per_m, -self.px_per_m));
                labels.shape(class, points[body.node], reach, corners, svg);
                reach
            } else {
                let radius = (body_radius(body) * self.px_per_m).max(least);
                labels.circle(class, points[body.node], radius, svg);
                radius
            };
            let number = landmarks.tractors.iter().position(|&tractor| tractor == body.node);
            if let Some(place) = number.filter(|_| are_numbered) {
                let text = format!("T{}", place + 1);
                labels.wanted.push(Wanted { at: px(points[body.node]), radius, text, class: "label soft" });
            }
        }
    }

    fn draw_points(&self, mean: impl Fn(&[usize]) -> IVec2, labels: &mut Labels, svg: &mut String) {
        let points = self.scene.landmarks.points.iter().filter(|point| !point.is_group && point.name != "centre");
        let mut wanted = Vec::new();
        for point in points {
            let at = mean(&point.nodes);
            labels.circle("point", at, POINT_RADIUS, svg);
            wanted.push(Wanted { at: px(at), radius: POINT_RADIUS, text: point.name.clone(), class: "label" });
        }
        // names of points take precedence over numbers of tractors
        labels.wanted.splice(0..0, wanted);
        labels.place();
    }

    fn draw_scale_bar(&self, svg: &mut String) {
        let length = series::at_most(0.25 * self.size.x / self.px_per_m);
        let (left, foot, end) = (8.0, self.size.y - 8.0, 8.0 + length * self.px_per_m);
        svg.push_str(&format!(
            "<path class=\"bar\" d=\"M{left} {:.1}v6M{left} {foot:.1}H{end:.1}m0-3v6\"/>\
             <text class=\"soft\" x=\"{:.1}\" y=\"{:.1}\">{length} m</text>",
            foot - 3.0,
            end + 5.0,
            foot + 4.0
        ));
    }
}

/// Area of the outline in a frame over the area of the flat web; none where there is no outline.
pub(crate) fn open_share(scene: &Scene, frame: usize) -> Option<f64> {
    let positions = scene.fields.positions(frame);
    let area = scene.landmarks.outline_area(|node| positions[node])?.dot(scene.landmarks.axis).abs();
    Some(area / scene.landmarks.reference_area?)
}

/// The rectangle of the camera's plane that the web fills in a frame: least and largest coordinates, m.
pub(crate) fn extent(scene: &Scene, frame: usize, camera: &Camera) -> (DVec2, DVec2) {
    let positions = scene.fields.positions(frame);
    let nodes = scene.of_web.iter().map(|&node| (camera.project(positions[node]), 0.0));
    let bodies = scene.landmarks.bodies.iter().map(|body| (camera.project(positions[body.node]), body_radius(body)));
    nodes.chain(bodies).fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(least, most), (point, radius)| {
        (least.min(point - radius), most.max(point + radius))
    })
}

/// Radius of a body, m; 0 for a particle.
fn body_radius(body: &BodyMark) -> f64 {
    0.5 * body.shape.size_m()[0]
}

fn polygon(vertices: impl Iterator<Item = IVec2>) -> String {
    let corners: Vec<String> = vertices.map(|vertex| format!("{} {}", vertex.x, vertex.y)).collect();
    format!("M{}z", corners.join("L"))
}

/// Places labels so that they overlap neither drawn parts nor each other.
struct Labels {
    /// The picture's size, px.
    size: DVec2,
    labelling: Labelling,
    /// Occupied rectangles: least and largest coordinates, px.
    taken: Vec<(DVec2, DVec2)>,
    /// The labels to place, in order of precedence.
    wanted: Vec<Wanted>,
    svg: String,
}

/// A label to be placed.
struct Wanted {
    /// Centre of the part that it names, px, and radius of that part, px.
    at: DVec2,
    radius: f64,
    text: String,
    class: &'static str,
}

/// Width and height of a letter, px, rounded up.
const LETTER: DVec2 = DVec2::new(7.6, 9.0);

const UPPER_RIGHT: DVec2 = DVec2::new(0.85, -0.85);

/// Directions in which a label may lie from its part; a diagonal one is nearer.
const SIDES: [DVec2; 8] = [
    DVec2::new(1.0, 0.0),
    UPPER_RIGHT,
    DVec2::new(0.0, -1.0),
    DVec2::new(-0.85, -0.85),
    DVec2::new(-1.0, 0.0),
    DVec2::new(-0.85, 0.85),
    DVec2::new(0.0, 1.0),
    DVec2::new(0.85, 0.85),
];

impl Labels {
    fn new(size: DVec2, labelling: Labelling) -> Self {
        Self { size, labelling, taken: Vec::new(), wanted: Vec::new(), svg: String::new() }
    }

    /// Draws a circle and keeps labels off it.
    fn circle(&mut self, class: &str, at: IVec2, radius: f64, svg: &mut String) {
        let centre = px(at);
        self.taken.push((centre - radius, centre + radius));
        svg.push_str(&format!("<circle class=\"{class}\" cx=\"{}\" cy=\"{}\" r=\"{radius:.1}\"/>", centre.x, centre.y));
    }

    /// Draws a polygon and keeps labels off it: `corners` lie about the point `at`, at most `reach` px away.
    fn shape(&mut self, class: &str, at: IVec2, reach: f64, corners: impl Iterator<Item = DVec2>, svg: &mut String) {
        let centre = px(at);
        self.taken.push((centre - reach, centre + reach));
        let corners: Vec<String> =
            corners.map(|corner| centre + corner).map(|c| format!("{:.1} {:.1}", c.x, c.y)).collect();
        svg.push_str(&format!("<path class=\"{class}\" d=\"M{}z\"/>", corners.join("L")));
    }

    fn place(&mut self) {
        for Wanted { at, radius, text, class } in std::mem::take(&mut self.wanted) {
            let half = 0.5 * DVec2::new(LETTER.x * text.chars().count() as f64, LETTER.y);
            let rectangle = |side: DVec2| {
                let middle = at + side * (half + radius + 1.5);
                (middle - half, middle + half)
            };
            let is_free = |&(least, most): &(DVec2, DVec2)| {
                let is_apart = |(left, right): &(DVec2, DVec2)| right.cmplt(least).any() || most.cmplt(*left).any();
                least.cmpge(DVec2::ZERO).all() && most.cmple(self.size).all() && self.taken.iter().all(is_apart)
            };
            let found = match self.labelling {
                Labelling::Steady => Some(rectangle(UPPER_RIGHT)),
                Labelling::Apart => {
                    // try the sides away from the middle of the picture first
                    let away = at - 0.5 * self.size;
                    let mut sides = SIDES;
                    sides.sort_by(|one, other| other.dot(away).total_cmp(&one.dot(away)));
                    sides.map(rectangle).into_iter().find(is_free)
                }
            };
            if let Some((least, most)) = found {
                self.taken.push((least, most));
                let (x, y) = (0.5 * (least.x + most.x), most.y - 0.5);
                self.svg.push_str(&format!(
                    "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{}</text>",
                    safe(&text)
                ));
            }
        }
    }
}

fn px(tenths: IVec2) -> DVec2 {
    tenths.as_dvec2() / TENTHS
}

//! Draws the web of a scenario, merges short stubs, adds traction ropes and cuts all ropes into segments.

use glam::DVec3;
use netcast_scenario::quantity::Length;
use netcast_scenario::{
    Diagnostic, Diagnostics, Document, Graph as WrittenGraph, GraphFiles, Scenario, Web as WrittenWeb,
};
use netcast_webs::{
    CutError, CutWeb, Cutting, Diamond, Graph, GraphNode, GraphRope, Merged, Radial, Site, Web, WebError, cut, diamond,
    graph, parallel_spacing, polygon, radial, space, square, topological, traditional,
};

use super::places;
use super::size::Size;

/// Segments along half the extent of a web by default.
const SEGMENTS_PER_RADIUS: f64 = 25.0;

/// Draws and cuts the web. Writes a default segment length into `scenario`.
///
/// # Errors
/// A web that cannot be drawn or cut, or that needs more memory than the machine has.
pub fn draw(document: &Document, scenario: &mut Scenario, notes: &mut Vec<String>) -> Result<CutWeb, Diagnostics> {
    let mut web = draw_kind(document, scenario, notes)?;
    name_points(scenario, &mut web);
    let per_mesh = match &scenario.web {
        WrittenWeb::Square(square) => square.segments_per_mesh.map(|n| square.mesh.si() / f64::from(n.get())),
        _ => None,
    };
    let length = match (per_mesh, scenario.solve.segment_length) {
        (Some(length), _) => length,
        (None, Some(length)) => length.si(),
        (None, None) => {
            let length = two_digits(web.reach() / SEGMENTS_PER_RADIUS);
            scenario.solve.segment_length = Some(Length::constant(length));
            if web.ropes.iter().any(|rope| rope.segments.is_none()) {
                notes.push(format!(
                    "ropes are cut into segments of about {length} m, as solve.segment_length is left out"
                ));
            }
            length
        }
    };
    // only here does the outline cut ropes short; elsewhere a short rope was asked for
    if matches!(scenario.web, WrittenWeb::Traditional(_)) {
        notes.extend(merge_note(web.merge_stubs(0.5 * length)));
    }
    let web = add_traction(document, scenario, web)?;
    let size = Size::of_web(&web, length);
    require_slender(document, scenario, length, per_mesh.is_some())?;
    let path = if per_mesh.is_some() { "web.square.segments_per_mesh" } else { "solve.segment_length" };
    size.require(document, path, "cut it into longer segments, or run it where there is more memory")?;
    let size = size.with_sheets(&web, scenario.canopy.as_ref());
    size.require(document, "canopy.membrane.fineness", "mesh it with fewer triangles")?;
    let path = if scenario.record.fields_every.is_some() { "record.fields_every" } else { "record.every" };
    size.recorded(scenario).require(document, path, "record less often, or give `record.fields_every`")?;
    cut(&web, &Cutting::SegmentLength(length)).map_err(|error| {
        let path = match error {
            CutError::TooMany { .. } | CutError::SegmentLength(_) if per_mesh.is_some() => {
                "web.square.segments_per_mesh"
            }
            CutError::TooMany { .. } | CutError::SegmentLength(_) => "solve.segment_length",
            CutError::Counts { .. } | CutError::NoSegments(_) => "web",
        };
        document.diagnostic(path, error.to_string()).into()
    })
}

/// Least length of a segment, over the diameter of its rope.
const LEAST_SLENDERNESS: f64 = 0.01;

/// Refuses segments that are far shorter than the thinnest rope is thick: a rope is no line there, and most of them are a slip
/// of a unit that costs gigabytes and days.
fn require_slender(document: &Document, scenario: &Scenario, length: f64, per_mesh: bool) -> Result<(), Diagnostics> {
    let ropes = scenario.ropes.values().chain([&scenario.rope]);
    let thinnest = ropes.map(|rope| rope.diameter.si()).fold(f64::INFINITY, f64::min);
    if length >= LEAST_SLENDERNESS * thinnest {
        return Ok(());
    }
    let path = if per_mesh { "web.square.segments_per_mesh" } else { "solve.segment_length" };
    let message =
        format!("segments of {length} m are less than a hundredth as long as the thinnest rope is thick, {thinnest} m");
    Err(document.diagnostic(path, message).with_help("cut ropes into longer segments").into())
}

/// The web of its kind, without traction ropes, uncut.
fn draw_kind(document: &Document, scenario: &Scenario, notes: &mut Vec<String>) -> Result<Web, Diagnostics> {
    let asked = &scenario.web;
    let with_place = |drawn: Result<Web, WebError>| {
        drawn.map_err(|error| {
            let path = error.argument_name().map_or(asked.table().to_owned(), |name| places::of_web(name, asked));
            Diagnostics::from(document.diagnostic(&path, error.to_string()))
        })
    };
    match asked {
        WrittenWeb::Traditional(w) => with_place(traditional(w.side.si(), w.cells_per_side.get() as usize)),
        WrittenWeb::Topological(w) => with_place(topological(w.side.si(), w.hexagon_side.si())),
        WrittenWeb::Space(w) => {
            let canopy = scenario.canopy.clone().unwrap_or_default();
            with_place(space(w.side.si(), canopy.side_m()))
        }
        WrittenWeb::Square(w) => {
            let net = square(w.side.si(), w.mesh.si());
            let net = match &w.gathering {
                Some(rope) => net.and_then(|net| net.with_gathering(rope.every.get() as usize, rope.excess.si())),
                None => net,
            };
            with_place(net)
        }
        WrittenWeb::Polygon(w) => {
            let (sides, side, mesh) = (w.sides.get() as usize, w.side_m(), w.mesh.si());
            let drawn = with_place(polygon(sides, side, mesh))?;
            notes.extend(parallels_apart(sides, side, mesh));
            Ok(drawn)
        }
        WrittenWeb::Radial(w) => with_place(radial(&Radial {
            diameter: w.diameter.si(),
            radials: w.radials.get() as usize,
            rings: w.rings.get() as usize,
            hub_diameter: w.hub_diameter.map(|diameter| diameter.si()),
            corners: w.corners.unwrap_or(w.radials).get() as usize,
        })),
        WrittenWeb::Diamond(w) => {
            let net = Diamond {
                mesh: w.mesh.si(),
                hanging_ratio: w.hanging_ratio(),
                meshes_wide: w.meshes_wide.get() as usize,
                meshes_high: w.meshes_high.get() as usize,
            };
            let drawn = with_place(diamond(&net))?;
            let [width, height] = net.size();
            notes.push(format!("the diamond net is {width:.4} m wide and {height:.4} m high"));
            Ok(drawn)
        }
        WrittenWeb::Graph(w) => {
            let files = document.files.graph.as_ref().expect("a document of a graph has read its files");
            Size::of_graph(files).require(document, "web.graph.ropes", "run it where there is more memory")?;
            graph(&graph_of_files(w, files, scenario)).map_err(|errors| {
                let all = errors.into_iter().map(|error| graph_diagnostic(document, files, error)).collect();
                Diagnostics::fail_if_any(all).expect_err("a web that is refused has errors")
            })
        }
    }
}

/// A note that the parallels of a polygon are not one mesh apart; none where they are.
fn parallels_apart(sides: usize, side: f64, mesh: f64) -> Option<String> {
    let spacing = parallel_spacing(sides, side, mesh).ok()?;
    let differs = (spacing / mesh - 1.0).abs() > 1e-6;
    differs.then(|| {
        format!("the polygon's parallels are {spacing:.4} m apart: so a whole number of them comes nearest to {mesh} m")
    })
}

/// The nodes and ropes of a graph from its files.
fn graph_of_files(web: &WrittenGraph, files: &GraphFiles, scenario: &Scenario) -> Graph {
    let id = |node: usize| files.nodes[node].id.clone();
    Graph {
        nodes: files
            .nodes
            .iter()
            .map(|n| GraphNode { id: n.id.clone(), position: DVec3::from_array(n.position_m) })
            .collect(),
        ropes: files
            .ropes
            .iter()
            .map(|r| GraphRope {
                a: id(r.a),
                b: id(r.b),
                class: r.class.clone(),
                label: None,
                rest_length: r.rest_length_m,
                segments: r.segments.map(|n| n.get() as usize),
            })
            .collect(),
        outline: web.outline.clone().unwrap_or_default(),
        corners: web.corners.clone().unwrap_or_default(),
        points: scenario.points.clone(),
    }
}

/// An error of a graph at its key in the scenario, with the line of the file.
fn graph_diagnostic(document: &Document, files: &GraphFiles, error: WebError) -> Diagnostic {
    let rope_line = |rope: &usize| files.ropes.get(*rope).map(|row| row.line);
    let (path, line) = match &error {
        WebError::Repeated { list, id } => {
            return document.diagnostic(&format!("web.graph.{list}"), format!("node {id:?} is named twice"));
        }
        WebError::OutlineTooShort { .. } => ("web.graph.outline", None),
        WebError::SelfLoop { rope, .. }
        | WebError::ZeroLength { rope, .. }
        | WebError::RestLength { rope, .. }
        | WebError::NoSegments { rope, .. }
        | WebError::UnknownNode { row: rope, .. } => ("web.graph.ropes", rope_line(rope)),
        WebError::DuplicateId { second, .. } => ("web.graph.nodes", files.nodes.get(*second).map(|row| row.line)),
        _ => ("web.graph.ropes", None),
    };
    let at = line.map_or(String::new(), |line| format!("line {line}: "));
    document.diagnostic(path, format!("{at}{error}"))
}

/// Finds the feature points of a web that is not a graph. The stage `Points` reports those that it lacks.
fn name_points(scenario: &Scenario, web: &mut Web) {
    if matches!(scenario.web, WrittenWeb::Graph(_)) {
        return;
    }
    for (name, id) in &scenario.points {
        if let Some(knot) = web.knot_named(id) {
            web.points.insert(name.clone(), Site::Knot(knot));
        }
    }
}

/// Adds the traction ropes and tractors that the scenario asks for.
fn add_traction(document: &Document, scenario: &Scenario, web: Web) -> Result<Web, Diagnostics> {
    let some_tractor = scenario.tractor.is_some() || !scenario.tractors.is_empty();
    if !some_tractor && scenario.traction_rope.is_none() {
        return Ok(web);
    }
    let (length, count) = scenario.traction_rope.as_ref().map_or((0.0, 1), |t| (t.length.si(), t.count.get() as usize));
    web.with_traction(length, count).map_err(|error| {
        let path = match (&error, error.argument_name()) {
            (WebError::NoCorners | WebError::CornerInTheMiddle { .. }, _) if some_tractor => "tractor".to_owned(),
            (_, Some(name)) => format!("traction_rope.{name}"),
            _ => "traction_rope".to_owned(),
        };
        document.diagnostic(&path, error.to_string()).into()
    })
}

/// A note on the merged stubs; none without stubs.
fn merge_note(stubs: Vec<Merged>) -> Option<String> {
    let shortest = stubs.iter().map(|s| s.length).reduce(f64::min)?;
    let longest = stubs.iter().map(|s| s.length).fold(0.0, f64::max);
    let sample = &stubs[0];
    Some(format!(
        "{} stubs of {shortest:.3} to {longest:.3} m, shorter than half a segment, are merged into the outline \
         (such as {}: {} into {})",
        stubs.len(),
        sample.rope,
        sample.knot,
        sample.into
    ))
}

/// A number rounded to two significant digits.
pub(super) fn two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}

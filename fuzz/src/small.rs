//! Which scenarios are small enough to be drawn for every input: a fuzzer tries thousands a second.

use netcast_scenario::{Canopy, Document, Stow, Web};

/// Most cells along a side, and most segments along the web's size.
const MOST_CELLS: f64 = 12.0;
const MOST_SEGMENTS: f64 = 100.0;
const MOST_PARALLEL: u32 = 4;
/// The longest packing by prescribed motion, s: 50 steps.
const LONGEST_PACKING: f64 = 0.1;
/// The longest turbulence, s.
const LONGEST_TURBULENCE: f64 = 0.1;

/// Whether drawing and cutting its web, packing it and tabulating its wind takes milliseconds.
pub fn is_small(document: &Document) -> bool {
    let scenario = &document.scenario;
    let (size, cells, per_cell) = match &scenario.web {
        Web::Traditional(web) => (web.side.si(), f64::from(web.cells_per_side.get()), 1),
        Web::Topological(web) => (web.side.si(), web.side.si() / web.hexagon_side.si(), 1),
        Web::Space(web) => {
            let canopy = scenario.canopy.clone().unwrap_or_default();
            let fineness = if let Canopy::Membrane(sheet) = &canopy { f64::from(sheet.fineness.get()) } else { 1.0 };
            (web.side.si(), fineness.max(web.side.si() / canopy.side_m()), 1)
        }
        Web::Square(web) => {
            let per_mesh = web.segments_per_mesh.map_or(1, |count| count.get());
            let excess = web.gathering.as_ref().map_or(0.0, |rope| rope.excess.si());
            (web.side.si() * (1.0 + excess), web.side.si() / web.mesh.si(), per_mesh)
        }
        Web::Polygon(web) => {
            let size = f64::from(web.sides.get()) * web.side_m();
            (size, size / web.mesh.si(), 1)
        }
        Web::Radial(web) => (web.diameter.si(), f64::from(web.rings.get().max(web.radials.get())), 1),
        Web::Diamond(net) => {
            let cells = f64::from(net.meshes_wide.get().max(net.meshes_high.get()));
            (2.0 * net.mesh.si() * cells, cells, 1)
        }
        Web::Graph(_) => {
            let files = document.files.graph.as_ref().expect("a document of a graph has read its files");
            let largest =
                files.nodes.iter().flat_map(|node| node.position_m).fold(0.0, |most: f64, x| most.max(x.abs()));
            let rests = files.ropes.iter().filter_map(|rope| rope.rest_length_m).fold(0.0, f64::max);
            let segments = files.ropes.iter().filter_map(|rope| rope.segments).max().map_or(1, |count| count.get());
            (2.0 * largest.max(rests), 1.0, segments)
        }
    };
    let (traction, parallel) =
        scenario.traction_rope.as_ref().map_or((0.0, 1), |ropes| (ropes.length.si(), ropes.count.get()));
    // left out, it is a share of the web's size
    let segment_length = scenario.solve.segment_length.map_or(size / 10.0, |length| length.si());
    let is_packed_soon = match scenario.stow.as_ref().map(|stowage| &stowage.pattern) {
        Some(Stow::Prescribed(led)) => {
            let listed = led.drive.values().flat_map(|drive| drive.path.iter().flatten());
            let rows = document.files.stow_paths.values().flatten().map(|row| row.time_s);
            let times = listed.map(|point| point.time.si()).chain(rows);
            times.fold(led.time.si().max(led.longest.si()), f64::max) <= LONGEST_PACKING
        }
        _ => true,
    };
    let turbulence = scenario.environment.wind.as_ref().and_then(|wind| wind.turbulence.as_ref());
    let duration = scenario.solve.run_time().unwrap_or(0.0);
    cells <= MOST_CELLS
        && f64::from(per_cell) <= MOST_SEGMENTS
        && size.max(traction) <= MOST_SEGMENTS * segment_length
        && is_packed_soon
        && parallel <= MOST_PARALLEL
        && !turbulence.is_some_and(|_| duration > LONGEST_TURBULENCE)
}

//! Estimate of the memory that a run takes, made before anything large is allocated.
//!
//! The bytes per item are measured peaks of whole runs, rounded up. A test of the command line runs with no more memory
//! than this estimate.

use netcast_scenario::{Canopy, Diagnostics, Document, GraphFiles, Scenario, available_memory, bytes_in_words};
use netcast_webs::{MOST_SEGMENTS, Web};

/// The most rows of a history. A larger number is a typing error.
pub const MOST_ROWS: f64 = 1e7;

/// Bytes of a run for each knot with its name, rope with its label, and segment with its node.
const KNOT: f64 = 500.0;
const ROPE: f64 = 400.0;
const SEGMENT: f64 = 700.0;
/// Bytes for each triangle of a sheet with its hinges and its share of a node.
const TRIANGLE: f64 = 2500.0;

/// Copies of the recorded fields in memory while their file and the report are written.
const COPIES: f64 = 2.5;

/// Frames that a run keeps in memory as it goes, for the moments that every result shows.
const MOMENTS: f64 = 6.0;

/// Bytes of a row of the history.
const ROW: f64 = 1500.0;

/// Numbers that the memory of a run grows with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Size {
    /// Knots of the web.
    knots: f64,
    /// Ropes of the web.
    ropes: f64,
    /// Segments of the ropes.
    segments: f64,
    /// Triangles of sheets.
    triangles: f64,
    /// Rows of the history.
    rows: f64,
    /// Frames of the fields.
    frames: f64,
}

impl Size {
    /// The size of a graph before it is drawn, with at least one segment a rope.
    pub(super) fn of_graph(files: &GraphFiles) -> Self {
        let (knots, ropes) = (files.nodes.len() as f64, files.ropes.len() as f64);
        Self { knots, ropes, segments: ropes, ..Self::default() }
    }

    /// The size of a web before it is cut into segments of `segment_length`, m.
    pub(super) fn of_web(web: &Web, segment_length: f64) -> Self {
        let cut = web.ropes.iter().map(|rope| match rope.segments {
            Some(segments) => segments as f64,
            None => (web.rest_length(rope) / segment_length).round().max(1.0),
        });
        Self { knots: web.knots.len() as f64, ropes: web.ropes.len() as f64, segments: cut.sum(), ..Self::default() }
    }

    /// The size with the sheets of its canopies.
    pub(super) fn with_sheets(self, web: &Web, canopy: Option<&Canopy>) -> Self {
        let Some(Canopy::Membrane(sheet)) = canopy else { return self };
        let fineness = f64::from(sheet.fineness.get());
        Self { triangles: web.canopies.len() as f64 * 6.0 * fineness * fineness, ..self }
    }

    /// The size with the rows and frames that are recorded.
    pub(super) fn recorded(self, scenario: &Scenario) -> Self {
        let (duration, record) = (scenario.solve.run_time().unwrap_or(0.0), &scenario.record);
        let frames =
            duration / record.fields_every.map_or(record.every.si(), |every| every.si().max(record.every.si()));
        Self { rows: duration / record.every.si(), frames: frames + 1.0, ..self }
    }

    /// Memory that a run takes, bytes.
    fn bytes(&self) -> f64 {
        // a sheet has two triangles for each node inside it
        let nodes = (self.knots + self.segments - self.ropes).max(0.0) + 0.5 * self.triangles;
        // positions, velocities, tensions
        let frame = (6.0 * nodes + self.segments + self.triangles) * size_of::<f64>() as f64;
        let web = KNOT * self.knots + ROPE * self.ropes + SEGMENT * self.segments + TRIANGLE * self.triangles;
        let moments = if self.frames > 0.0 { MOMENTS } else { 0.0 };
        web + ROW * self.rows + frame * (COPIES * self.frames + moments)
    }

    /// Checks that the machine has the memory. Sizes beyond every machine are refused elsewhere, by bounds of their own.
    ///
    /// # Errors
    /// Too little memory, reported at `path`.
    pub(super) fn require(&self, document: &Document, path: &str, help: &str) -> Result<(), Diagnostics> {
        let Self { knots, ropes, segments, triangles, rows, frames } = self;
        let (needed, Some(available)) = (self.bytes(), available_memory()) else { return Ok(()) };
        if needed <= available || *segments > MOST_SEGMENTS as f64 || *rows > MOST_ROWS {
            return Ok(());
        }
        let recorded = if *frames > 0.0 { format!(" recorded {frames:.0} times") } else { String::new() };
        let sheets = if *triangles > 0.0 { format!(" and {triangles:.0} triangles") } else { String::new() };
        let message = format!(
            "{segments:.0} segments in {ropes:.0} ropes between {knots:.0} knots{sheets}{recorded} take about {} of memory, and \
             this machine has {} to give",
            bytes_in_words(needed),
            bytes_in_words(available),
        );
        Err(document.diagnostic(path, message).with_help(help).into())
    }
}

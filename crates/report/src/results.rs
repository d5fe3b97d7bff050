//! What a report reads of a result folder.

use std::collections::BTreeSet;
use std::path::Path;

use glam::DVec3;
use netcast_results::{Fields, History, Landmarks, Manifest, Summary, SummaryFile, folder, read_fields};

use crate::ReportError;

/// A result folder, read.
pub(crate) struct Results {
    pub file: SummaryFile,
    pub manifest: Manifest,
    pub history: History,
    /// The scenario as resolved; empty where the folder does not have it.
    pub scenario: String,
    /// Where everything was; none where the folder does not hold the fields.
    pub scene: Option<Scene>,
}

/// Where every node was and what every segment bore, with what of it has a meaning.
pub(crate) struct Scene {
    pub fields: Fields,
    pub landmarks: Landmarks,
    /// The nodes of the web, ascending: all but those where a tie or stitch ends and nothing else, which stay behind.
    pub of_web: Vec<usize>,
}

impl Results {
    pub(crate) fn read(from: &Path) -> Result<Self, ReportError> {
        let optional = |name: &str| Some(from.join(name)).filter(|path| path.exists());
        let scenario = optional(folder::INPUTS).map(|inputs| inputs.join("scenario.toml"));
        let scene = match (optional(folder::FIELDS), optional(folder::LANDMARKS)) {
            (Some(fields), Some(landmarks)) => Scene::read(&fields, &landmarks)?,
            _ => None,
        };
        Ok(Self {
            file: SummaryFile::read(from)?,
            manifest: Manifest::read(&from.join(folder::MANIFEST))?,
            history: History::read(&from.join(folder::HISTORY))?,
            scenario: scenario
                .filter(|path| path.exists())
                .map(|path| read_text(&path))
                .transpose()?
                .unwrap_or_default(),
            scene,
        })
    }

    /// The run in numbers.
    pub(crate) fn summary(&self) -> &Summary {
        &self.file.summary
    }

    /// The scenario's title, or that it has none.
    pub(crate) fn title(&self) -> &str {
        let title = &self.summary().title;
        if title.trim().is_empty() { "Untitled scenario" } else { title }
    }

    /// The cells of a column of the history, where it holds any number.
    pub(crate) fn column(&self, name: &str) -> Option<Vec<Option<f64>>> {
        let cells: Vec<Option<f64>> = self.history.values(name)?.collect();
        cells.iter().any(Option::is_some).then_some(cells)
    }

    /// The columns that hold any number, in the order of the file.
    pub(crate) fn filled(&self) -> impl Iterator<Item = (&str, Vec<Option<f64>>)> {
        self.history.columns().iter().filter_map(|name| Some((name.as_str(), self.column(name)?)))
    }
}

impl Scene {
    /// None where the run recorded no fields.
    fn read(fields: &Path, landmarks: &Path) -> Result<Option<Self>, ReportError> {
        let (scene, path) = (Self::new(read_fields(fields)?, Landmarks::read(landmarks)?), landmarks);
        if let Some(node) = scene.landmarks.nodes().find(|&node| node >= scene.fields.topology.nodes) {
            let (path, nodes) = (path.to_path_buf(), scene.fields.topology.nodes);
            return Err(ReportError::UnknownNode { path, node, nodes });
        }
        Ok((!scene.fields.times.is_empty()).then_some(scene))
    }

    pub(crate) fn new(fields: Fields, landmarks: Landmarks) -> Self {
        let mut scene = Self { fields, landmarks, of_web: Vec::new() };
        let topology = &scene.fields.topology;
        let ropes = topology.segments.iter().enumerate().filter(|(segment, _)| scene.is_rope(*segment));
        let ends = ropes.flat_map(|(_, ends)| ends.map(|node| node as usize));
        let of_web: BTreeSet<usize> = ends.chain(scene.landmarks.nodes()).collect();
        scene.of_web = of_web.into_iter().collect();
        scene
    }

    /// Whether a segment is one of a rope.
    pub(crate) fn is_rope(&self, segment: usize) -> bool {
        let class = self.fields.topology.classes[segment] as usize;
        self.landmarks.classes.get(class).is_none_or(|class| class.is_rope)
    }

    /// Number of frames; at least one.
    pub(crate) fn frames(&self) -> usize {
        self.fields.times.len()
    }

    /// The frame nearest to a time, s.
    pub(crate) fn frame_at(&self, time: f64) -> usize {
        let distance = |frame: usize| (self.fields.times[frame] - time).abs();
        (0..self.frames()).min_by(|&one, &other| distance(one).total_cmp(&distance(other))).unwrap_or(0)
    }

    /// The mean of some nodes in a frame, m.
    pub(crate) fn mean(&self, frame: usize, nodes: &[usize]) -> DVec3 {
        let positions = self.fields.positions(frame);
        nodes.iter().map(|&node| positions[node]).sum::<DVec3>() / nodes.len() as f64
    }
}

fn read_text(path: &Path) -> Result<String, ReportError> {
    std::fs::read_to_string(path).map_err(|source| ReportError::Read { path: path.to_path_buf(), source })
}

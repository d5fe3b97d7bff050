//! Reads the files of a result folder that a report needs.

use std::collections::BTreeSet;
use std::path::Path;

use glam::DVec3;
use netcast_results::{Fields, History, Landmarks, Manifest, Summary, SummaryFile, folder, read_fields, visible};

use crate::ReportError;

/// The contents of a result folder.
pub(crate) struct Results {
    pub file: SummaryFile,
    pub manifest: Manifest,
    pub history: History,
    /// The resolved scenario as TOML; empty where the folder lacks it.
    pub scenario: String,
    /// The fields with their landmarks; none where the folder lacks either file or the fields hold no frame.
    pub scene: Option<Scene>,
}

/// Positions of all nodes and tensions of all segments in each frame, with the landmarks that name them.
pub(crate) struct Scene {
    pub fields: Fields,
    pub landmarks: Landmarks,
    /// The nodes of the web, ascending: those on a rope and those that a landmark names. A node that only ties or
    /// stitches reach stays behind at the launcher.
    pub of_web: Vec<usize>,
}

impl Results {
    /// Reads the result folder at `folder_path`.
    pub(crate) fn read(folder_path: &Path) -> Result<Self, ReportError> {
        let optional = |name: &str| Some(folder_path.join(name)).filter(|path| path.exists());
        let scenario = optional(folder::INPUTS).map(|inputs| inputs.join("scenario.toml"));
        let scene = match (optional(folder::FIELDS), optional(folder::LANDMARKS)) {
            (Some(fields), Some(landmarks)) => Scene::read(&fields, &landmarks)?,
            _ => None,
        };
        Ok(Self {
            file: SummaryFile::read(folder_path)?,
            manifest: Manifest::read(&folder_path.join(folder::MANIFEST))?,
            history: History::read(&folder_path.join(folder::HISTORY))?,
            scenario: scenario
                .filter(|path| path.exists())
                .map(|path| read_text(&path))
                .transpose()?
                .unwrap_or_default(),
            scene,
        })
    }

    /// The summary of the run.
    pub(crate) fn summary(&self) -> &Summary {
        &self.file.summary
    }

    /// The scenario's title, or `Untitled scenario` where it is blank.
    pub(crate) fn title(&self) -> String {
        let title = &self.summary().title;
        if title.trim().is_empty() { "Untitled scenario".to_owned() } else { visible(title) }
    }

    /// The cells of a column of the history; none where the column is absent or empty.
    pub(crate) fn column(&self, name: &str) -> Option<Vec<Option<f64>>> {
        let cells: Vec<Option<f64>> = self.history.values(name)?.collect();
        cells.iter().any(Option::is_some).then_some(cells)
    }

    /// As [`Self::column`]; of a column of largest values since the record before, which older results lack, the values at
    /// the records.
    pub(crate) fn peak_column(&self, name: &str) -> Option<Vec<Option<f64>>> {
        let at_records = || match name {
            "tension_peak_n" => "tension_max_n".to_owned(),
            _ => name.replace("_peak", ""),
        };
        self.column(name).or_else(|| self.column(&at_records()))
    }

    /// Names and cells of the columns with at least one number, in the order of the file.
    pub(crate) fn filled(&self) -> impl Iterator<Item = (&str, Vec<Option<f64>>)> {
        self.history.columns().iter().filter_map(|name| Some((name.as_str(), self.column(name)?)))
    }
}

impl Scene {
    /// Reads fields and landmarks; none where the fields hold no frame.
    fn read(fields: &Path, landmarks: &Path) -> Result<Option<Self>, ReportError> {
        let scene = Self::new(read_fields(fields)?, Landmarks::read(landmarks)?);
        if let Some(node) = scene.landmarks.nodes().find(|&node| node >= scene.fields.topology.nodes) {
            let (path, nodes) = (landmarks.to_path_buf(), scene.fields.topology.nodes);
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

    /// Whether a segment belongs to a rope.
    pub(crate) fn is_rope(&self, segment: usize) -> bool {
        let class = self.fields.topology.classes[segment] as usize;
        self.landmarks.classes.get(class).is_none_or(|class| class.is_rope)
    }

    /// Number of frames, at least one.
    pub(crate) fn frames(&self) -> usize {
        self.fields.times.len()
    }

    /// Index of the frame nearest to `time`, s.
    pub(crate) fn frame_at(&self, time: f64) -> usize {
        let distance = |frame: usize| (self.fields.times[frame] - time).abs();
        (0..self.frames()).min_by(|&one, &other| distance(one).total_cmp(&distance(other))).unwrap_or(0)
    }

    /// Mean position of `nodes` in a frame, m.
    pub(crate) fn mean(&self, frame: usize, nodes: &[usize]) -> DVec3 {
        let positions = self.fields.positions(frame);
        nodes.iter().map(|&node| positions[node]).sum::<DVec3>() / nodes.len() as f64
    }
}

fn read_text(path: &Path) -> Result<String, ReportError> {
    std::fs::read_to_string(path).map_err(|source| ReportError::Read { path: path.to_path_buf(), source })
}

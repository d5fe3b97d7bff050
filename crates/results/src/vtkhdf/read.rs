//! Reader of `fields.vtkhdf`.

use std::path::Path;

use glam::{DQuat, DVec3};
use hdf5_pure::File;

use super::topology::FieldsTopology;
use crate::ResultError;
use crate::measures::KeptFrame;

/// The fields of a run in memory: topology, and a frame for each record step.
#[derive(Debug, Clone, PartialEq)]
pub struct Fields {
    /// Nodes, segments, triangles and names, the same in every frame.
    pub topology: FieldsTopology,
    /// Time of each frame, s; shape (steps,).
    pub times: Vec<f64>,
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    tensions: Vec<f64>,
    orientations: Vec<DQuat>,
}

impl Fields {
    /// Fields of this topology without a frame.
    pub fn new(topology: FieldsTopology) -> Self {
        let (times, positions, velocities, tensions, orientations) = Default::default();
        Self { topology, times, positions, velocities, tensions, orientations }
    }

    /// Appends a frame: time, s; positions, m, and velocities, m/s, shape (nodes,); tensions, N, shape (segments,);
    /// orientations of rigid bodies, shape (bodies,).
    pub(crate) fn push(
        &mut self,
        time: f64,
        positions: &[DVec3],
        velocities: &[DVec3],
        tensions: &[f64],
        orientations: impl IntoIterator<Item = DQuat>,
    ) {
        self.times.push(time);
        self.positions.extend_from_slice(positions);
        self.velocities.extend_from_slice(velocities);
        self.tensions.extend_from_slice(tensions);
        // triangles of sheets are cells without tension
        self.tensions.resize(self.times.len() * self.topology.cells(), 0.0);
        self.orientations.extend(orientations);
    }

    /// Puts a frame where its time belongs; one of a time that is there already is left out.
    pub(crate) fn insert(&mut self, frame: &KeptFrame) {
        let place = self.times.partition_point(|&time| time < frame.time);
        if self.times.get(place) == Some(&frame.time) {
            return;
        }
        let (nodes, cells, bodies) = (self.topology.nodes, self.topology.cells(), self.topology.bodies.len());
        let mut tension = frame.tension.clone();
        tension.resize(cells, 0.0);
        let at = |count: usize| place * count..place * count;
        self.positions.splice(at(nodes), frame.position.iter().copied());
        self.velocities.splice(at(nodes), frame.velocity.iter().copied());
        self.tensions.splice(at(cells), tension);
        self.orientations.splice(at(bodies), frame.orientation.iter().copied());
        self.times.insert(place, frame.time);
    }

    /// Positions of the nodes at a step, m; shape (nodes,).
    ///
    /// # Panics
    /// If `step` is not less than the length of `times`.
    pub fn positions(&self, step: usize) -> &[DVec3] {
        row(&self.positions, step, self.topology.nodes)
    }

    /// Velocities of the nodes at a step, m/s; shape (nodes,).
    ///
    /// # Panics
    /// If `step` is not less than the length of `times`.
    pub fn velocities(&self, step: usize) -> &[DVec3] {
        row(&self.velocities, step, self.topology.nodes)
    }

    /// Tensions of the segments at a step, N; shape (segments,).
    ///
    /// # Panics
    /// If `step` is not less than the length of `times`.
    pub fn tensions(&self, step: usize) -> &[f64] {
        &row(&self.tensions, step, self.topology.cells())[..self.topology.segments.len()]
    }

    /// Orientations of the rigid bodies at a step, from body axes to the world; shape (bodies,).
    ///
    /// # Panics
    /// If `step` is not less than the length of `times`.
    pub fn orientations(&self, step: usize) -> &[DQuat] {
        row(&self.orientations, step, self.topology.bodies.len())
    }
}

fn row<T>(values: &[T], step: usize, width: usize) -> &[T] {
    &values[step * width..(step + 1) * width]
}

/// Reads a field file that [`super::FieldsWriter`] wrote.
///
/// # Errors
/// [`ResultError::Fields`] if the file cannot be read or lacks an array; [`ResultError::NotFields`] if the lengths or
/// indices of its arrays do not agree.
pub fn read_fields(path: &Path) -> Result<Fields, ResultError> {
    let fields = read_arrays(path).map_err(ResultError::fields(path))?;
    match inconsistency(&fields) {
        None => Ok(fields),
        Some(what) => Err(ResultError::NotFields { path: path.to_path_buf(), what }),
    }
}

fn read_arrays(path: &Path) -> Result<Fields, hdf5_pure::Error> {
    let file = File::open(path)?;
    let names = file.group("netcast")?;
    let present = names.datasets()?;
    let has = |name: &str| present.iter().any(|dataset| dataset == name);
    let strings = |name: &str| if has(name) { names.dataset(name)?.read_string() } else { Ok(Vec::new()) };
    let label_names = strings("label_names")?;
    let label_nodes = if label_names.is_empty() { Vec::new() } else { names.dataset("label_nodes")?.read_u32()? };
    let connectivity = file.dataset("VTKHDF/Lines/Connectivity")?.read_i64()?;
    let corners = file.dataset("VTKHDF/Polygons/Connectivity")?.read_i64()?;
    let classes = file.dataset("VTKHDF/CellData/class")?.read_i32()?;
    let nodes = file.dataset("VTKHDF/NumberOfPoints")?.read_i64()?;
    let topology = FieldsTopology {
        nodes: nodes.first().map_or(0, |&nodes| nodes as usize),
        segments: connectivity.chunks_exact(2).map(|ends| [ends[0] as u32, ends[1] as u32]).collect(),
        classes: classes.iter().take(connectivity.len() / 2).map(|&class| class as u32).collect(),
        triangles: corners.chunks_exact(3).map(|nodes| [0, 1, 2].map(|k| nodes[k] as u32)).collect(),
        class_names: strings("class_names")?,
        labels: label_nodes.into_iter().zip(label_names).collect(),
        bodies: if has("body_nodes") { names.dataset("body_nodes")?.read_u32()? } else { Vec::new() },
    };
    let orientations =
        if has("body_orientations") { names.dataset("body_orientations")?.read_f64()? } else { Vec::new() };
    Ok(Fields {
        topology,
        times: file.dataset("VTKHDF/Steps/Values")?.read_f64()?,
        positions: vectors(&file, "VTKHDF/Points")?,
        velocities: vectors(&file, "VTKHDF/PointData/velocity")?,
        tensions: file.dataset("VTKHDF/CellData/tension")?.read_f64()?,
        orientations: orientations.chunks_exact(4).map(DQuat::from_slice).collect(),
    })
}

fn vectors(file: &File, path: &str) -> Result<Vec<DVec3>, hdf5_pure::Error> {
    let values = file.dataset(path)?.read_f64()?;
    Ok(values.chunks_exact(3).map(DVec3::from_slice).collect())
}

/// A sentence on arrays whose lengths or indices do not agree; none if all do.
fn inconsistency(fields: &Fields) -> Option<String> {
    let Fields { topology, times, positions, velocities, tensions, orientations } = fields;
    let (nodes, segments, steps) = (topology.nodes, topology.segments.len(), times.len());
    let cells = topology.cells();
    // saturate: a damaged count may overflow
    let lengths = [
        ("Points", steps.saturating_mul(nodes), positions.len()),
        ("velocity", steps.saturating_mul(nodes), velocities.len()),
        ("tension", steps.saturating_mul(cells), tensions.len()),
        ("class", segments, topology.classes.len()),
        ("body_orientations", steps.saturating_mul(topology.bodies.len()), orientations.len()),
    ];
    let wrong = lengths.into_iter().find(|(_, expected, found)| expected != found);
    let wrong =
        wrong.map(|(array, expected, found)| format!("array {array} should hold {expected} rows and holds {found}"));
    wrong.or_else(|| topology.fault())
}

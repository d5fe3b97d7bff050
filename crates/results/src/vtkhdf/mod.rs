//! `fields.vtkhdf`: where every node was and what every rope bore, at every record step.
//!
//! One HDF5 file that ParaView opens as a series in time and h5py opens as arrays. The layout is VTKHDF 2.2,
//! `PolyData` (<https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html>):
//!
//! ```text
//! /VTKHDF            Version [2, 2]  Type "PolyData"
//!   Points           (steps * nodes, 3)  m, world frame
//!   Lines            one cell of two points a segment: the topology stays, so it is stored once
//!   Polygons         one cell of three points a triangle of a sheet, stored once
//!   PointData        velocity (steps * nodes, 3)  m/s
//!   CellData         tension (steps * cells)  N;  class (cells), stored once
//!   Steps            Values (steps)  s, and where each step begins in the arrays above
//! /netcast           class_names;  label_nodes, label_names: outside /VTKHDF, so ParaView passes over it
//!                    body_nodes (bodies)  where the centres of rigid bodies are
//!                    body_orientations (steps * bodies, 4)  from a body's axes to the world, quaternions x, y, z, w
//! ```
//!
//! A cell has two points, and not a whole rope, because tension is a number a cell; where ropes run side by side it is
//! that of one of them. Triangles follow the segments; they are no ropes: their tension is 0, their class -1.

use std::path::Path;

use glam::{DQuat, DVec3};
use hdf5_pure::{AttrValue, File, FileBuilder, FinishedGroup, GroupBuilder, make_f64_type};
use serde::{Deserialize, Serialize};

use crate::ResultError;

const VECTOR_BYTES: usize = 3 * size_of::<f64>();
const SCALAR_BYTES: usize = size_of::<f64>();
const QUATERNION_BYTES: usize = 4 * size_of::<f64>();

/// The kinds of cell of a `PolyData`, in the order of its offset columns.
const CELL_KINDS: [&str; 4] = ["Vertices", "Lines", "Polygons", "Strips"];

/// What stays the same in every step.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FieldsTopology {
    /// Number of nodes.
    pub nodes: usize,
    /// The two nodes of each segment.
    pub segments: Vec<[u32; 2]>,
    /// The link class of each segment, an index into `class_names`.
    pub classes: Vec<u32>,
    /// The three nodes of each triangle of a sheet.
    pub triangles: Vec<[u32; 3]>,
    /// The names of the link classes.
    pub class_names: Vec<String>,
    /// Nodes that have a name, such as feature point B.
    pub labels: Vec<(u32, String)>,
    /// The node at the centre of each rigid body.
    pub bodies: Vec<u32>,
}

/// Takes the steps of a run one by one and writes them as one file at its end.
///
/// The values are held once, as the bytes that go to the file.
#[derive(Debug)]
pub struct FieldsWriter {
    topology: FieldsTopology,
    times: Vec<f64>,
    positions: Vec<u8>,
    velocities: Vec<u8>,
    tensions: Vec<u8>,
    orientations: Vec<u8>,
}

impl FieldsWriter {
    /// A writer for this topology.
    ///
    /// # Errors
    /// [`ResultError::Length`] where there is not one class a segment.
    pub fn new(topology: FieldsTopology) -> Result<Self, ResultError> {
        ResultError::length("link classes of the segments", topology.segments.len(), topology.classes.len())?;
        let (times, [positions, velocities, tensions, orientations]) = Default::default();
        Ok(Self { topology, times, positions, velocities, tensions, orientations })
    }

    /// Appends a step: time in s, positions in m, velocities in m/s, the tension of each segment in N, and the orientation
    /// of each rigid body.
    ///
    /// # Errors
    /// [`ResultError::Length`] where an array does not fit the topology; nothing is appended then.
    pub fn push(
        &mut self,
        time: f64,
        positions: &[DVec3],
        velocities: &[DVec3],
        tensions: &[f64],
        orientations: &[DQuat],
    ) -> Result<(), ResultError> {
        ResultError::length("positions", self.topology.nodes, positions.len())?;
        ResultError::length("velocities", self.topology.nodes, velocities.len())?;
        ResultError::length("tensions", self.topology.segments.len(), tensions.len())?;
        ResultError::length("orientations", self.topology.bodies.len(), orientations.len())?;
        self.times.push(time);
        append_vectors(&mut self.positions, positions);
        append_vectors(&mut self.velocities, velocities);
        self.tensions.extend(tensions.iter().flat_map(|tension| tension.to_le_bytes()));
        append_quaternions(&mut self.orientations, orientations.iter().copied());
        self.slacken_triangles();
        Ok(())
    }

    /// Appends a step from its bytes in a journal; see [`crate::journal`]. Its length has been checked.
    pub(crate) fn push_bytes(&mut self, frame: &[u8]) {
        let (time, frame) = frame.split_at(SCALAR_BYTES);
        let (positions, frame) = frame.split_at(self.topology.nodes * VECTOR_BYTES);
        let (velocities, frame) = frame.split_at(self.topology.nodes * VECTOR_BYTES);
        let (tensions, orientations) = frame.split_at(self.topology.segments.len() * SCALAR_BYTES);
        self.times.push(f64::from_le_bytes(time.try_into().expect("split at its size")));
        self.positions.extend_from_slice(positions);
        self.velocities.extend_from_slice(velocities);
        self.tensions.extend_from_slice(tensions);
        self.orientations.extend_from_slice(orientations);
        self.slacken_triangles();
    }

    /// Gives the triangles of a step their tension of none.
    fn slacken_triangles(&mut self) {
        self.tensions.resize(self.times.len() * self.topology.cells() * SCALAR_BYTES, 0);
    }

    /// The time of each step so far, s.
    pub(crate) fn times(&self) -> &[f64] {
        &self.times
    }

    /// Number of steps taken in so far.
    pub fn steps(&self) -> usize {
        self.times.len()
    }

    /// Writes the file. Equal input gives equal bytes.
    ///
    /// # Errors
    /// [`ResultError::Fields`] where the file cannot be written.
    pub fn finish(self, path: &Path) -> Result<(), ResultError> {
        self.build().and_then(|file| file.write(path)).map_err(ResultError::fields(path))
    }

    fn build(self) -> Result<FileBuilder, hdf5_pure::Error> {
        let Self { topology, times, positions, velocities, tensions, orientations } = self;
        let (nodes, cell_count) = (topology.nodes, topology.cells());

        let mut file = FileBuilder::new();
        let mut vtk = file.create_group("VTKHDF");
        vtk.set_attr("Version", AttrValue::I64Array(vec![2, 2]));
        vtk.set_attr("Type", AttrValue::AsciiString("PolyData".into()));

        // geometry: points at every step, cells once
        vtk.create_dataset("NumberOfPoints").with_i64_data(&[nodes as i64]);
        vector_dataset(&mut vtk, "Points", positions);
        for kind in CELL_KINDS {
            let group = vtk.create_group(kind);
            let group = match kind {
                "Lines" => cells(group, &topology.segments),
                "Polygons" => cells(group, &topology.triangles),
                _ => cells::<2>(group, &[]),
            };
            vtk.add_group(group);
        }

        // fields
        let mut point_data = vtk.create_group("PointData");
        vector_dataset(&mut point_data, "velocity", velocities);
        vtk.add_group(point_data.finish());
        let mut cell_data = vtk.create_group("CellData");
        let values = tensions.len() / SCALAR_BYTES;
        cell_data.create_dataset("tension").with_raw_data(make_f64_type(), tensions, values as u64);
        let classes = topology.classes.iter().map(|&class| class as i32);
        let classes: Vec<i32> = classes.chain(topology.triangles.iter().map(|_| -1)).collect();
        cell_data.create_dataset("class").with_i32_data(&classes);
        vtk.add_group(cell_data.finish());

        let steps = steps(vtk.create_group("Steps"), &times, nodes, cell_count);
        vtk.add_group(steps);
        file.add_group(vtk.finish());

        let mut own = file.create_group("netcast");
        if !topology.bodies.is_empty() {
            own.create_dataset("body_nodes").with_u32_data(&topology.bodies);
            let rows = (orientations.len() / QUATERNION_BYTES) as u64;
            let dataset = own.create_dataset("body_orientations");
            dataset.with_raw_data(make_f64_type(), orientations, 4 * rows).with_shape(&[rows, 4]);
        }
        let names = names(own, &topology)?;
        file.add_group(names);
        Ok(file)
    }
}

pub(crate) fn append_vectors(bytes: &mut Vec<u8>, vectors: &[DVec3]) {
    bytes.extend(vectors.iter().flat_map(|vector| vector.to_array()).flat_map(f64::to_le_bytes));
}

pub(crate) fn append_quaternions(bytes: &mut Vec<u8>, quaternions: impl IntoIterator<Item = DQuat>) {
    bytes.extend(quaternions.into_iter().flat_map(|quaternion| quaternion.to_array()).flat_map(f64::to_le_bytes));
}

fn vector_dataset(group: &mut GroupBuilder, name: &str, bytes: Vec<u8>) {
    let rows = (bytes.len() / VECTOR_BYTES) as u64;
    group.create_dataset(name).with_raw_data(make_f64_type(), bytes, 3 * rows).with_shape(&[rows, 3]);
}

/// The cells of one kind: where each begins in the list of its points, and that list.
fn cells<const N: usize>(mut group: GroupBuilder, cells: &[[u32; N]]) -> FinishedGroup {
    let offsets: Vec<i64> = (0..=cells.len()).map(|cell| (N * cell) as i64).collect();
    let connectivity: Vec<i64> = cells.iter().flatten().map(|&node| node.into()).collect();
    group.create_dataset("NumberOfCells").with_i64_data(&[cells.len() as i64]);
    group.create_dataset("NumberOfConnectivityIds").with_i64_data(&[connectivity.len() as i64]);
    group.create_dataset("Offsets").with_i64_data(&offsets);
    group.create_dataset("Connectivity").with_i64_data(&connectivity);
    group.finish()
}

/// Where each step begins: points, velocities and tensions move on, the cells and their class stay at zero.
fn steps(mut group: GroupBuilder, times: &[f64], nodes: usize, cells: usize) -> FinishedGroup {
    let count = times.len();
    let every = |stride: usize| -> Vec<i64> { (0..count).map(|step| (step * stride) as i64).collect() };
    group.set_attr("NSteps", AttrValue::I64(count as i64));
    group.create_dataset("Values").with_f64_data(times);
    group.create_dataset("PartOffsets").with_i64_data(&every(0));
    group.create_dataset("NumberOfParts").with_i64_data(&vec![1; count]);
    group.create_dataset("PointOffsets").with_i64_data(&every(nodes));
    let kinds = CELL_KINDS.len();
    for name in ["CellOffsets", "ConnectivityIdOffsets"] {
        group.create_dataset(name).with_i64_data(&vec![0; count * kinds]).with_shape(&[count as u64, kinds as u64]);
    }
    let mut point_offsets = group.create_group("PointDataOffsets");
    point_offsets.create_dataset("velocity").with_i64_data(&every(nodes));
    group.add_group(point_offsets.finish());
    let mut cell_offsets = group.create_group("CellDataOffsets");
    cell_offsets.create_dataset("tension").with_i64_data(&every(cells));
    cell_offsets.create_dataset("class").with_i64_data(&every(0));
    group.add_group(cell_offsets.finish());
    group.finish()
}

/// The names that VTK has no place for. An array of no strings has no width, so it is left out.
fn names(mut group: GroupBuilder, topology: &FieldsTopology) -> Result<FinishedGroup, hdf5_pure::Error> {
    if !topology.class_names.is_empty() {
        let names: Vec<&str> = topology.class_names.iter().map(String::as_str).collect();
        group.create_dataset("class_names").with_strings(&names)?;
    }
    if !topology.labels.is_empty() {
        let (nodes, names): (Vec<u32>, Vec<&str>) =
            topology.labels.iter().map(|(node, name)| (*node, name.as_str())).unzip();
        group.create_dataset("label_nodes").with_u32_data(&nodes);
        group.create_dataset("label_names").with_strings(&names)?;
    }
    Ok(group.finish())
}

/// What a field file holds, read back.
#[derive(Debug, Clone, PartialEq)]
pub struct Fields {
    /// What stays the same in every step.
    pub topology: FieldsTopology,
    /// The time of each step, s.
    pub times: Vec<f64>,
    positions: Vec<DVec3>,
    velocities: Vec<DVec3>,
    tensions: Vec<f64>,
    orientations: Vec<DQuat>,
}

impl FieldsTopology {
    /// Number of cells: segments and triangles.
    fn cells(&self) -> usize {
        self.segments.len() + self.triangles.len()
    }

    /// What it speaks of and does not have.
    pub(crate) fn fault(&self) -> Option<String> {
        let is_missing = |node: u32| node as usize >= self.nodes;
        let corners = self.segments.iter().flatten().chain(self.triangles.iter().flatten());
        let ends = corners.chain(&self.bodies).copied().find(|&node| is_missing(node));
        let label = || self.labels.iter().map(|(node, _)| *node).find(|&node| is_missing(node));
        if let Some(node) = ends.or_else(label) {
            return Some(format!("it names node {node} of {}", self.nodes));
        }
        let class = self.classes.iter().find(|&&class| class as usize >= self.class_names.len());
        class.map(|class| format!("it names link class {class} of {}", self.class_names.len()))
    }

    /// Bytes of one step: its time, a position and a velocity a node, a tension a segment, an orientation a body. None
    /// where that is beyond any memory.
    pub(crate) fn frame_bytes(&self) -> Option<usize> {
        let nodes = self.nodes.checked_mul(2 * VECTOR_BYTES)?;
        let bodies = self.bodies.len().checked_mul(QUATERNION_BYTES)?;
        let segments = self.segments.len().checked_mul(SCALAR_BYTES)?;
        segments.checked_add(nodes)?.checked_add(bodies)?.checked_add(SCALAR_BYTES)
    }
}

impl Fields {
    /// The position of each node at a step, m.
    ///
    /// # Panics
    /// Where there is no such step; see `times`.
    pub fn positions(&self, step: usize) -> &[DVec3] {
        row(&self.positions, step, self.topology.nodes)
    }

    /// The velocity of each node at a step, m/s.
    ///
    /// # Panics
    /// Where there is no such step; see `times`.
    pub fn velocities(&self, step: usize) -> &[DVec3] {
        row(&self.velocities, step, self.topology.nodes)
    }

    /// The tension of each segment at a step, N.
    ///
    /// # Panics
    /// Where there is no such step; see `times`.
    pub fn tensions(&self, step: usize) -> &[f64] {
        &row(&self.tensions, step, self.topology.cells())[..self.topology.segments.len()]
    }

    /// The orientation of each rigid body at a step: from its axes to the world.
    ///
    /// # Panics
    /// Where there is no such step; see `times`.
    pub fn orientations(&self, step: usize) -> &[DQuat] {
        row(&self.orientations, step, self.topology.bodies.len())
    }
}

fn row<T>(values: &[T], step: usize, width: usize) -> &[T] {
    &values[step * width..(step + 1) * width]
}

/// Reads a field file that [`FieldsWriter`] wrote.
///
/// # Errors
/// [`ResultError::Fields`] where the file cannot be read or lacks an array, [`ResultError::NotFields`] where its
/// arrays do not fit each other.
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
    let strings = |name: &str| match has(name) {
        true => names.dataset(name)?.read_string(),
        false => Ok(Vec::new()),
    };
    let label_names = strings("label_names")?;
    let label_nodes = match label_names.is_empty() {
        true => Vec::new(),
        false => names.dataset("label_nodes")?.read_u32()?,
    };
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
        bodies: match has("body_nodes") {
            true => names.dataset("body_nodes")?.read_u32()?,
            false => Vec::new(),
        },
    };
    let orientations = match has("body_orientations") {
        true => names.dataset("body_orientations")?.read_f64()?,
        false => Vec::new(),
    };
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

/// What does not fit in a file that is whole as HDF5.
fn inconsistency(fields: &Fields) -> Option<String> {
    let Fields { topology, times, positions, velocities, tensions, orientations } = fields;
    let (nodes, segments, steps) = (topology.nodes, topology.segments.len(), times.len());
    let cells = topology.cells();
    // more than fits a memory is more than there is
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

#[cfg(test)]
mod tests {
    use super::*;

    fn topology() -> FieldsTopology {
        FieldsTopology {
            nodes: 4,
            segments: vec![[0, 1], [1, 2], [3, 1]],
            classes: vec![1, 0, 1],
            triangles: vec![[0, 1, 2], [3, 2, 1]],
            class_names: vec!["outline".into(), "Zugseil ä".into()],
            labels: vec![(2, "B".into()), (0, "tractor 1".into())],
            bodies: vec![3, 0],
        }
    }

    /// Positions, velocities and tensions that differ in every component of every step.
    fn step(step: usize) -> (Vec<DVec3>, Vec<DVec3>, Vec<f64>) {
        let value = |kind: usize, index: usize| (kind * 1000 + step * 100 + index) as f64 / 3.0;
        let vector =
            |kind: usize, node: usize| DVec3::from_array([0usize, 1, 2].map(|axis| value(kind, 3 * node + axis)));
        let vectors = |kind| (0..4).map(|node| vector(kind, node)).collect();
        (vectors(0), vectors(1), (0..3).map(|segment| value(2, segment)).collect())
    }

    /// Two orientations, different in every step.
    fn turned(step: usize) -> [DQuat; 2] {
        [1.0, 2.0].map(|rate| DQuat::from_rotation_x(rate * step as f64))
    }

    fn write(path: &Path, topology: FieldsTopology, steps: usize) {
        let mut writer = FieldsWriter::new(topology).unwrap();
        for index in 0..steps {
            let (positions, velocities, tensions) = step(index);
            let orientations = if writer.topology.bodies.is_empty() { vec![] } else { turned(index).to_vec() };
            writer.push(index as f64 * 1e-3, &positions, &velocities, &tensions, &orientations).unwrap();
        }
        writer.finish(path).unwrap();
    }

    #[test]
    fn what_is_written_reads_back_equal() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.vtkhdf");
        write(&path, topology(), 3);
        let fields = read_fields(&path).unwrap();
        assert_eq!(fields.topology, topology());
        assert_eq!(fields.times, [0.0, 1e-3, 2e-3]);
        for index in 0..3 {
            let (positions, velocities, tensions) = step(index);
            assert_eq!(fields.positions(index), positions);
            assert_eq!(fields.velocities(index), velocities);
            assert_eq!(fields.tensions(index), tensions);
            assert_eq!(fields.orientations(index), turned(index));
        }
    }

    #[test]
    fn no_names_and_no_steps_are_a_file_too() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.vtkhdf");
        let bare = FieldsTopology { nodes: 4, ..FieldsTopology::default() };
        write(&path, bare.clone(), 0);
        let fields = read_fields(&path).unwrap();
        assert_eq!(fields.topology, bare);
        assert!(fields.times.is_empty());
    }

    #[test]
    fn equal_input_gives_equal_bytes() {
        let folder = tempfile::tempdir().unwrap();
        let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
        write(&first, topology(), 2);
        write(&second, topology(), 2);
        assert_eq!(std::fs::read(first).unwrap(), std::fs::read(second).unwrap());
    }

    #[test]
    fn arrays_that_do_not_fit_the_topology_are_refused() {
        let mut writer = FieldsWriter::new(topology()).unwrap();
        let (positions, velocities, tensions) = step(0);
        assert!(matches!(
            writer.push(0.0, &positions[1..], &velocities, &tensions, &turned(0)),
            Err(ResultError::Length { what: "positions", expected: 4, found: 3 })
        ));
        assert!(writer.push(0.0, &positions, &velocities, &tensions[1..], &turned(0)).is_err());
        assert!(writer.push(0.0, &positions, &velocities, &tensions, &turned(0)[1..]).is_err());
        assert_eq!(writer.steps(), 0);
        assert!(FieldsWriter::new(FieldsTopology { classes: vec![0], ..topology() }).is_err());
    }

    #[test]
    fn a_file_of_something_else_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("fields.vtkhdf");
        std::fs::write(&path, "not HDF5").unwrap();
        assert!(read_fields(&path).unwrap_err().to_string().contains("fields.vtkhdf"));
    }
}

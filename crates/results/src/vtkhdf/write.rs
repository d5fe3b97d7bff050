//! Writer of `fields.vtkhdf`.

use std::path::Path;

use glam::{DQuat, DVec3};
use hdf5_pure::{AttrValue, FileBuilder, FinishedGroup, GroupBuilder, make_f64_type};

use super::topology::{FieldsTopology, QUATERNION_BYTES, SCALAR_BYTES, VECTOR_BYTES};
use crate::ResultError;
use crate::measures::KeptFrame;

/// The kinds of cell of a `PolyData`, in the order of the columns of its cell offsets.
const CELL_KINDS: [&str; 4] = ["Vertices", "Lines", "Polygons", "Strips"];

/// Collects the steps of a run and writes them as one file at the end.
///
/// It keeps the values as the bytes of the file, so that they are in memory only once.
#[derive(Debug)]
pub struct FieldsWriter {
    pub(super) topology: FieldsTopology,
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
    /// [`ResultError::Length`] if the topology does not have one class for each segment.
    pub fn new(topology: FieldsTopology) -> Result<Self, ResultError> {
        ResultError::length("link classes of the segments", topology.segments.len(), topology.classes.len())?;
        let (times, [positions, velocities, tensions, orientations]) = Default::default();
        Ok(Self { topology, times, positions, velocities, tensions, orientations })
    }

    /// Appends a step: time, s; positions, m, and velocities, m/s, shape (nodes,); tensions, N, shape (segments,);
    /// orientations of rigid bodies, shape (bodies,).
    ///
    /// # Errors
    /// [`ResultError::Length`] if the length of an array does not fit the topology; nothing is appended then.
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
        self.append_triangle_tensions();
        Ok(())
    }

    /// Appends a step from its bytes in a journal; see [`crate::journal`]. The caller has checked their number.
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
        self.append_triangle_tensions();
    }

    /// Puts a frame where its time belongs; one of a time that is there already is left out.
    pub(crate) fn insert(&mut self, frame: &KeptFrame) {
        let place = self.times.partition_point(|&time| time < frame.time);
        if self.times.get(place) == Some(&frame.time) {
            return;
        }
        let (nodes, cells, bodies) = (self.topology.nodes, self.topology.cells(), self.topology.bodies.len());
        let mut vectors = Vec::new();
        append_vectors(&mut vectors, &frame.position);
        splice(&mut self.positions, place * nodes * VECTOR_BYTES, vectors);
        let mut vectors = Vec::new();
        append_vectors(&mut vectors, &frame.velocity);
        splice(&mut self.velocities, place * nodes * VECTOR_BYTES, vectors);
        let mut tensions: Vec<u8> = frame.tension.iter().flat_map(|tension| tension.to_le_bytes()).collect();
        tensions.resize(cells * SCALAR_BYTES, 0);
        splice(&mut self.tensions, place * cells * SCALAR_BYTES, tensions);
        let mut quaternions = Vec::new();
        append_quaternions(&mut quaternions, frame.orientation.iter().copied());
        splice(&mut self.orientations, place * bodies * QUATERNION_BYTES, quaternions);
        self.times.insert(place, frame.time);
    }

    /// Appends zero tension for each triangle of the last step.
    fn append_triangle_tensions(&mut self) {
        self.tensions.resize(self.times.len() * self.topology.cells() * SCALAR_BYTES, 0);
    }

    /// Time of each step so far, s; shape (steps,).
    pub(crate) fn times(&self) -> &[f64] {
        &self.times
    }

    /// Number of steps so far.
    pub fn steps(&self) -> usize {
        self.times.len()
    }

    /// Writes the file to `path`. Equal input gives equal bytes.
    ///
    /// # Errors
    /// [`ResultError::Fields`] if the file cannot be written.
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

        // points at every step, cells once
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

fn splice(values: &mut Vec<u8>, place: usize, new: Vec<u8>) {
    values.splice(place..place, new);
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

/// The cells of one kind: the list of their points, and the offset of each cell in it.
fn cells<const N: usize>(mut group: GroupBuilder, cells: &[[u32; N]]) -> FinishedGroup {
    let offsets: Vec<i64> = (0..=cells.len()).map(|cell| (N * cell) as i64).collect();
    let connectivity: Vec<i64> = cells.iter().flatten().map(|&node| node.into()).collect();
    group.create_dataset("NumberOfCells").with_i64_data(&[cells.len() as i64]);
    group.create_dataset("NumberOfConnectivityIds").with_i64_data(&[connectivity.len() as i64]);
    group.create_dataset("Offsets").with_i64_data(&offsets);
    group.create_dataset("Connectivity").with_i64_data(&connectivity);
    group.finish()
}

/// Offsets of each step in the arrays: they grow for points, velocities and tensions; cells and classes are stored once.
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

/// Names of link classes and nodes, for which VTK has no place. HDF5 cannot hold an empty array of strings.
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

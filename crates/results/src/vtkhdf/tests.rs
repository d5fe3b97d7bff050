//! Fields read back to the last bit, and files and arrays that do not fit are refused.

use std::path::Path;

use glam::{DQuat, DVec3};

use super::*;
use crate::ResultError;

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
    let vector = |kind: usize, node: usize| DVec3::from_array([0usize, 1, 2].map(|axis| value(kind, 3 * node + axis)));
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
fn fields_read_back_equal() {
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
fn fields_without_names_and_steps_read_back_equal() {
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
fn a_file_that_is_not_hdf5_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fields.vtkhdf");
    std::fs::write(&path, "not HDF5").unwrap();
    assert!(read_fields(&path).unwrap_err().to_string().contains("fields.vtkhdf"));
}

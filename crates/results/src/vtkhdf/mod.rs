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

mod read;
#[cfg(test)]
mod tests;
mod topology;
mod write;

pub use read::{Fields, read_fields};
pub use topology::FieldsTopology;
pub use write::FieldsWriter;
pub(crate) use write::{append_quaternions, append_vectors};

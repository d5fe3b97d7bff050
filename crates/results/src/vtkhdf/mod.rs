//! `fields.vtkhdf`: positions and velocities of all nodes and tensions of all ropes, at every record step.
//!
//! It is one HDF5 file. ParaView opens it as a time series, h5py as arrays. The layout is VTKHDF 2.2, `PolyData`
//! (<https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/vtkhdf_specifications.html>):
//!
//! ```text
//! /VTKHDF            Version [2, 2]  Type "PolyData"
//!   Points           (steps * nodes, 3)  m, world frame
//!   Lines            one cell of two points for each segment, stored once
//!   Polygons         one cell of three points for each triangle of a sheet, stored once
//!   PointData        velocity (steps * nodes, 3)  m/s
//!   CellData         tension (steps * cells)  N;  class (cells), stored once
//!   Steps            Values (steps)  s, and the offset of each step in the arrays above
//! /netcast           class_names;  label_nodes, label_names: outside /VTKHDF, so ParaView ignores it
//!                    body_nodes (bodies)  nodes at the centres of rigid bodies
//!                    body_orientations (steps * bodies, 4)  from a body's axes to the world, quaternions x, y, z, w
//! ```
//!
//! A cell is a segment and not a whole rope, because tension varies along a rope; of ropes that run side by side it is
//! the tension of one. Triangles follow the segments and have tension 0 and class -1.

mod read;
#[cfg(test)]
mod tests;
mod topology;
mod write;

pub use read::{Fields, read_fields};
pub use topology::FieldsTopology;
pub use write::FieldsWriter;
pub(crate) use write::{append_quaternions, append_vectors};

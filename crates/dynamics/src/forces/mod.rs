//! The physics, one effect a file. A file holds the law, its force on the nodes, its power or energy.
//!
//! | effect | file | energy channel |
//! |---|---|---|
//! | tension of ropes, with their internal damping | [`rope_tension`] | elastic, rope_damping |
//! | bending of ropes | [`bending`] | elastic, rope_damping |
//! | sheets: stretch, wrinkles | [`membrane`] | elastic, sheet_damping |
//! | sheets: bending | [`hinge`] | elastic, sheet_damping |
//! | weight | [`gravity`] | gravity |
//! | constant forces on nodes | [`load`] | load |
//! | launchers: holding, guiding, pushing | [`crate::launcher`], [`crate::time::launching`] | launch |
//! | damping in proportion to mass, the stand-in for air | [`mass_damping`] | mass_damping |
//!
//! Elements of a few nodes ([`element`]), each prepared from its rest shape:
//!
//! | effect | file |
//! |---|---|
//! | bending of a rope from segment to segment | [`bending`] |
//! | tension of a sheet in its plane, wrinkling or as a plate | [`membrane`], by the law of [`tension_field`] |
//! | bending of a sheet from triangle to triangle | [`hinge`] |
//!
//! The ledger ([`crate::energy::Ledger`]) has a field for each channel.

pub mod bending;
#[cfg(test)]
mod conformance;
pub mod element;
mod fold;
pub mod gravity;
pub mod hinge;
pub mod load;
pub mod mass_damping;
pub mod membrane;
pub mod rope_tension;
pub mod tension_field;

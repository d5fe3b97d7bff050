//! The laws, one a file: force, energy, stiffness of one segment, element, node or body. They loop over nothing and know no
//! system; what goes through a net is in [`crate::effects`] and [`crate::time`].
//!
//! | law | file | energy channel |
//! |---|---|---|
//! | tension of ropes, with their internal damping | [`rope_tension`] | elastic, rope_damping |
//! | bending of ropes | [`bending`] | elastic, rope_damping |
//! | sheets in their plane, wrinkling or as plates | [`membrane`], [`tension_field`] | elastic, sheet_damping |
//! | sheets: bending | [`hinge`] | elastic, sheet_damping |
//! | other laws of tension: which there are | [`law`] | elastic, rope_damping |
//! | a second stiffness beyond a strain | [`bilinear`] | elastic |
//! | tension from a table, with hysteresis | [`tabulated`] | elastic, rope_hysteresis |
//! | relaxation | [`viscoelastic`] | elastic, rope_damping |
//! | bars that push | [`strut`] | elastic |
//! | breaking | [`breaking`] | rupture |
//! | drag of ropes, sheets, bodies | [`rope_drag`], [`sheet_drag`], [`body_drag`] | air |
//! | inertia of the medium around ropes | [`added_mass`] | added_mass |
//! | weight | [`gravity`] | gravity |
//! | forces given on nodes | [`load`] | load |
//! | ground: contact and friction | [`ground`] | ground, ground_friction |
//! | an orbit | [`orbit`] | orbit |
//! | launchers: holding, guiding, pushing | [`crate::launcher`], `effects/launchers.rs` | launch |
//! | damping in proportion to mass, the stand-in for air | [`mass_damping`] | mass_damping |
//!
//! A force between a few nodes that is no rope is an [`element`]. Channels are those of [`crate::channel`].

pub mod added_mass;
pub mod bending;
pub mod bilinear;
pub mod body_drag;
pub mod breaking;
#[cfg(test)]
mod conformance;
pub mod element;
mod fold;
pub mod gravity;
pub mod ground;
pub mod hinge;
pub mod law;
pub mod load;
pub mod mass_damping;
pub mod membrane;
pub mod memory;
pub mod orbit;
pub mod rope_drag;
pub mod rope_tension;
pub mod segment;
pub mod sheet_drag;
pub mod strut;
pub mod tabulated;
pub mod tension_field;
pub mod viscoelastic;

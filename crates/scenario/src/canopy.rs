//! `[canopy.KIND]`: the cloth at the knots of a space web.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{NonNegative, Positive};
use crate::library::cloth_names;
use crate::quantity::{Density, Length, Number, Pressure};
use crate::rope::DAMPING_RATIO;

/// The canopies of a space web: one table, named after the way they are modelled. Left out: `[canopy.links]` with its
/// defaults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Canopy {
    /// A hub and six rim nodes with twelve members that pull and never push: free to fold, like cloth.
    Links(CanopyLinks),
}

impl Canopy {
    /// Forgets the material, whose values stand in their own keys: no other library can change the canopy.
    pub(crate) fn complete(&mut self) {
        let Self::Links(links) = self;
        links.material = None;
    }
}

impl Default for Canopy {
    fn default() -> Self {
        Self::Links(CanopyLinks::default())
    }
}

/// `[canopy.links]`: a regular hexagon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CanopyLinks {
    /// A cloth of the library: it has the density and elastic modulus that are not written beside it; the thickness is
    /// then that of the cloth as a solid.
    // none once a scenario is read: its values then stand in their own keys
    #[serde(skip_serializing)]
    #[schemars(schema_with = "cloth_names")]
    pub material: Option<String>,
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
    /// Thickness, m.
    pub thickness: Length<Positive>,
    /// Density, kg/m^3.
    pub density: Density<Positive>,
    /// Elastic modulus, Pa.
    pub elastic_modulus: Pressure<Positive>,
    /// Damping of the members, as a fraction of critical.
    pub damping_ratio: Number<NonNegative>,
}

impl Default for CanopyLinks {
    fn default() -> Self {
        Self {
            material: None,
            side: Length::constant(0.14),
            thickness: Length::constant(0.01),
            density: Density::constant(2000.0),
            elastic_modulus: Pressure::constant(90e9),
            damping_ratio: DAMPING_RATIO,
        }
    }
}

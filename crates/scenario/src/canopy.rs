//! `[canopy.KIND]`: the cloth at the knots of a space web.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{Fraction, NonNegative, Positive};
use crate::library::cloth_names;
use crate::quantity::{Angle, Density, Length, Number, Pressure, Time};
use crate::rope::{DAMPING_RATIO, Damping};

/// The canopies of a space web: one table, named after the way they are modelled. Left out: `[canopy.links]` with its
/// defaults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Canopy {
    /// A hub and six rim nodes with twelve members that pull and never push: free to fold, like cloth.
    Links(CanopyLinks),
    /// A rigid plate, its payload a part of it.
    Rigid(CanopyRigid),
    /// A sheet of triangles: a plate that bends, or cloth that wrinkles.
    Membrane(CanopyMembrane),
}

impl Canopy {
    /// Side of the hexagon, m.
    pub fn side_m(&self) -> f64 {
        match self {
            Self::Links(CanopyLinks { side, .. })
            | Self::Rigid(CanopyRigid { side, .. })
            | Self::Membrane(CanopyMembrane { side, .. }) => side.si(),
        }
    }

    /// Mass of its cloth, kg, and volume, m^3.
    pub fn mass_and_volume(&self) -> (f64, f64) {
        let (thickness, density) = match self {
            Self::Links(CanopyLinks { thickness, density, .. })
            | Self::Rigid(CanopyRigid { thickness, density, .. })
            | Self::Membrane(CanopyMembrane { thickness, density, .. }) => (thickness.si(), density.si()),
        };
        let volume = HEXAGON_AREA * self.side_m() * self.side_m() * thickness;
        (density * volume, volume)
    }

    /// Open share of its cloth's area.
    pub fn porosity(&self) -> f64 {
        match self {
            Self::Links(CanopyLinks { porosity, .. })
            | Self::Rigid(CanopyRigid { porosity, .. })
            | Self::Membrane(CanopyMembrane { porosity, .. }) => porosity.si(),
        }
    }

    /// Writes the default damping out; forgets the material, whose values stand in their own keys: no other library
    /// can change the canopy.
    pub(crate) fn complete(&mut self) {
        match self {
            Self::Links(links) => links.material = None,
            Self::Rigid(_) => {}
            Self::Membrane(sheet) => {
                sheet.material = None;
                if sheet.damping_time.is_none() {
                    sheet.damping_ratio.get_or_insert(DAMPING_RATIO);
                }
            }
        }
    }
}

/// Area over the square of the side of a regular hexagon: 3 sqrt(3)/2.
const HEXAGON_AREA: f64 = 2.598_076_211_353_316;

// the paper's cloth
const SIDE: Length<Positive> = Length::constant(0.14);
const THICKNESS: Length<Positive> = Length::constant(0.01);
const DENSITY: Density<Positive> = Density::constant(2000.0);
const ELASTIC_MODULUS: Pressure<Positive> = Pressure::constant(90e9);
/// No air passes.
const CLOSED: Number<Fraction> = Number::constant(0.0);

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
    /// Open share of the cloth's area, which air passes through freely.
    pub porosity: Number<Fraction>,
}

impl Default for CanopyLinks {
    fn default() -> Self {
        Self {
            material: None,
            side: SIDE,
            thickness: THICKNESS,
            density: DENSITY,
            elastic_modulus: ELASTIC_MODULUS,
            damping_ratio: DAMPING_RATIO,
            porosity: CLOSED,
        }
    }
}

/// `[canopy.rigid]`: a regular hexagon that keeps its shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CanopyRigid {
    /// Side of the hexagon, m.
    pub side: Length<Positive>,
    /// Thickness, m.
    pub thickness: Length<Positive>,
    /// Density, kg/m^3.
    pub density: Density<Positive>,
    /// Open share of the plate's area, which air passes through freely.
    pub porosity: Number<Fraction>,
}

impl Default for CanopyRigid {
    fn default() -> Self {
        Self { side: SIDE, thickness: THICKNESS, density: DENSITY, porosity: CLOSED }
    }
}

/// `[canopy.membrane]`: a regular hexagon of 6 n^2 triangles. At most one of `damping_time` and `damping_ratio` is given;
/// with neither, the ratio is 0.05.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("not" = {"required": ["damping_time", "damping_ratio"]}))]
pub struct CanopyMembrane {
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
    /// Elastic modulus, Pa: along the fibres, where it is another across them.
    pub elastic_modulus: Pressure<Positive>,
    /// Contraction across over stretch along the fibres.
    pub poisson_ratio: Number<Fraction>,
    /// Elastic modulus across the fibres, Pa. Left out: that along them.
    pub elastic_modulus_across: Option<Pressure<Positive>>,
    /// Shear modulus, Pa. Left out: E / (2 + 2 nu), E the geometric mean of both moduli.
    pub shear_modulus: Option<Pressure<Positive>>,
    /// Direction of the fibres from the web's x axis, anticlockwise.
    pub fibre_angle: Angle,
    /// Triangles along a side, n.
    pub fineness: NonZeroU32,
    /// Whether it gives way to compression, as cloth does; a plate resists it.
    pub wrinkles: bool,
    /// Whether it resists bending.
    pub bending: SheetBending,
    /// Nodes of the sheet as near as this to a corner, m, are bound rigidly together where ropes are tied; 0: the
    /// corner alone.
    pub tie_radius: Length<NonNegative>,
    /// Internal friction of the material t, s: stress t dS/dt.
    pub damping_time: Option<Time<NonNegative>>,
    /// Numerical damping, as a fraction of critical: t = 2 ratio h sqrt(density / E), h a triangle's side. Default: 0.05
    /// where `damping_time` is not given.
    pub damping_ratio: Option<Number<NonNegative>>,
    /// Largest stress that the cloth bears, Pa: results then state the margin.
    pub strength: Option<Pressure<Positive>>,
    /// Open share of the cloth's area, which air passes through freely.
    pub porosity: Number<Fraction>,
}

impl Default for CanopyMembrane {
    fn default() -> Self {
        Self {
            material: None,
            side: SIDE,
            thickness: THICKNESS,
            density: DENSITY,
            elastic_modulus: ELASTIC_MODULUS,
            poisson_ratio: Number::constant(0.3),
            elastic_modulus_across: None,
            shear_modulus: None,
            fibre_angle: Angle::constant(0.0),
            fineness: const { NonZeroU32::new(2).unwrap() },
            wrinkles: false,
            bending: SheetBending::Plate,
            tie_radius: Length::constant(0.0),
            damping_time: None,
            damping_ratio: None,
            strength: None,
            porosity: CLOSED,
        }
    }
}

impl CanopyMembrane {
    /// How the sheet is damped, with the default where the scenario is silent.
    pub fn damping(&self) -> Damping {
        Damping::of(self.damping_time, self.damping_ratio)
    }
}

/// Whether a sheet resists bending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SheetBending {
    /// As a plate of its thickness: D = E t^3 / (12 (1 - nu^2)).
    Plate,
    /// Not at all.
    None,
}

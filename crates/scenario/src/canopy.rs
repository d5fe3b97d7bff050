//! `[canopy.KIND]`: the canopies, plates or cloths at the knots of a space web.

use std::num::NonZeroU32;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::interval::{Fraction, NonNegative, Positive};
use crate::library::cloth_names;
use crate::quantity::{Angle, Density, Length, Number, Pressure, Time};
use crate::rope::{DAMPING_RATIO, Damping};

/// The canopies of a space web: one table, named after the model of the canopy. Default: `[canopy.links]` with its
/// defaults.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Canopy {
    /// A hub and six rim nodes joined by twelve links that pull and never push. It folds freely, like cloth.
    Links(CanopyLinks),
    /// A rigid plate. The payload is a part of it.
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

    /// Mass of the cloth, kg, and its volume, m^3.
    pub fn mass_and_volume(&self) -> (f64, f64) {
        let (thickness, density) = match self {
            Self::Links(CanopyLinks { thickness, density, .. })
            | Self::Rigid(CanopyRigid { thickness, density, .. })
            | Self::Membrane(CanopyMembrane { thickness, density, .. }) => (thickness.si(), density.si()),
        };
        let volume = HEXAGON_AREA * self.side_m() * self.side_m() * thickness;
        (density * volume, volume)
    }

    /// Open share of the area of the cloth, from 0 to less than 1.
    pub fn porosity(&self) -> f64 {
        match self {
            Self::Links(CanopyLinks { porosity, .. })
            | Self::Rigid(CanopyRigid { porosity, .. })
            | Self::Membrane(CanopyMembrane { porosity, .. }) => porosity.si(),
        }
    }

    /// Fills in the default damping. Removes the material, so that a later library cannot change the canopy.
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

/// Area of a regular hexagon over the square of its side: 3 sqrt(3) / 2.
const HEXAGON_AREA: f64 = 2.598_076_211_353_316;

// the cloth of the paper, docs/validation/paper.md
const SIDE: Length<Positive> = Length::constant(0.14);
const THICKNESS: Length<Positive> = Length::constant(0.01);
const DENSITY: Density<Positive> = Density::constant(2000.0);
const ELASTIC_MODULUS: Pressure<Positive> = Pressure::constant(90e9);
/// Porosity of a cloth through which no air passes.
const CLOSED: Number<Fraction> = Number::constant(0.0);

impl Default for Canopy {
    fn default() -> Self {
        Self::Links(CanopyLinks::default())
    }
}

/// `[canopy.links]`: a regular hexagon of twelve links that pull and never push.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CanopyLinks {
    /// Name of a cloth in the library of materials. It supplies the density and elastic modulus that are not given
    /// here; `thickness` is then that of the cloth as solid fibre. Default: none.
    // none after reading: its values are then in keys of their own
    #[serde(skip_serializing)]
    #[schemars(schema_with = "cloth_names")]
    pub material: Option<String>,
    /// Side of the hexagon, m. Default: 0.14 m.
    pub side: Length<Positive>,
    /// Thickness, m. Default: 10 mm.
    pub thickness: Length<Positive>,
    /// Density, kg/m^3. Default: 2000 kg/m^3, or that of `material`.
    pub density: Density<Positive>,
    /// Elastic modulus, Pa. Default: 90 GPa, or that of `material`.
    pub elastic_modulus: Pressure<Positive>,
    /// Damping of each link as a fraction of critical damping. Default: 0.05.
    pub damping_ratio: Number<NonNegative>,
    /// Open share of the area of the cloth, from 0 to less than 1. Air passes freely through it. Default: 0.
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

/// `[canopy.rigid]`: a rigid plate, a regular hexagon.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CanopyRigid {
    /// Side of the hexagon, m. Default: 0.14 m.
    pub side: Length<Positive>,
    /// Thickness, m. Default: 10 mm.
    pub thickness: Length<Positive>,
    /// Density, kg/m^3. Default: 2000 kg/m^3.
    pub density: Density<Positive>,
    /// Open share of the area of the plate, from 0 to less than 1. Air passes freely through it. Default: 0.
    pub porosity: Number<Fraction>,
}

impl Default for CanopyRigid {
    fn default() -> Self {
        Self { side: SIDE, thickness: THICKNESS, density: DENSITY, porosity: CLOSED }
    }
}

/// `[canopy.membrane]`: a regular hexagon of 6 n^2 triangles, with n the `fineness`. Give at most one of
/// `damping_time` and `damping_ratio`; with neither, the damping ratio is 0.05.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("not" = {"required": ["damping_time", "damping_ratio"]}))]
pub struct CanopyMembrane {
    /// Name of a cloth in the library of materials. It supplies the density and elastic modulus that are not given
    /// here; `thickness` is then that of the cloth as solid fibre. Default: none.
    // none after reading: its values are then in keys of their own
    #[serde(skip_serializing)]
    #[schemars(schema_with = "cloth_names")]
    pub material: Option<String>,
    /// Side of the hexagon, m. Default: 0.14 m.
    pub side: Length<Positive>,
    /// Thickness, m. Default: 10 mm.
    pub thickness: Length<Positive>,
    /// Density, kg/m^3. Default: 2000 kg/m^3, or that of `material`.
    pub density: Density<Positive>,
    /// Elastic modulus E along the fibres, Pa. Default: 90 GPa, or that of `material`.
    pub elastic_modulus: Pressure<Positive>,
    /// Poisson's ratio nu: contraction across the fibres over stretch along them. Default: 0.3.
    pub poisson_ratio: Number<Fraction>,
    /// Elastic modulus across the fibres, Pa. Default: `elastic_modulus`.
    pub elastic_modulus_across: Option<Pressure<Positive>>,
    /// Shear modulus, Pa. Default: E / (2 + 2 nu), with E the geometric mean of both elastic moduli.
    pub shear_modulus: Option<Pressure<Positive>>,
    /// Direction of the fibres, anticlockwise from the x axis of the web, rad. Default: 0 deg.
    pub fibre_angle: Angle,
    /// Number n of triangles along a side. Default: 2.
    pub fineness: NonZeroU32,
    /// Whether the sheet gives way under compression, as cloth does. A plate resists compression. Default: false.
    pub wrinkles: bool,
    /// Whether the sheet resists bending. Default: "plate".
    pub bending: SheetBending,
    /// Radius around each corner, m. Nodes of the sheet within it are joined rigidly where ropes are tied; with 0
    /// only the corner itself is tied. Default: 0 m.
    pub tie_radius: Length<NonNegative>,
    /// Damping by internal friction of the material, as a time t, s. The damping stress is t dS/dt, with S the
    /// elastic stress. Default: none; `damping_ratio` applies.
    pub damping_time: Option<Time<NonNegative>>,
    /// Damping as a fraction of critical damping: t = 2 ratio h sqrt(density / E), with h the side of a triangle.
    /// Default: 0.05, unless `damping_time` is given.
    pub damping_ratio: Option<Number<NonNegative>>,
    /// Largest stress that the cloth bears, Pa. Results then state the margin. Default: none.
    pub strength: Option<Pressure<Positive>>,
    /// Open share of the area of the cloth, from 0 to less than 1. Air passes freely through it. Default: 0.
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
    /// How the sheet is damped, with the default where neither key is given.
    pub fn damping(&self) -> Damping {
        Damping::of(self.damping_time, self.damping_ratio)
    }
}

/// Whether a sheet resists bending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SheetBending {
    /// It bends as a plate of its thickness t: D = E t^3 / (12 (1 - nu^2)).
    Plate,
    /// It has no bending stiffness.
    None,
}

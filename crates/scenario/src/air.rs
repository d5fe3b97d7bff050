//! `[environment.air]`: the medium that a net flies through, and its drag on the net.

use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::interval::{NonNegative, OpenShare, Positive, Troposphere};
use crate::quantity::{Density, Length, Number, Viscosity};

/// Drag coefficient of a flat plate normal to the flow, the same as for a sheet in `netcast-dynamics`.
const PLATE: f64 = 1.17;

/// `[environment.air]`: the medium. It is the standard atmosphere, or a medium of constant `density` and `viscosity`,
/// such as water. An empty table is the standard atmosphere with the muzzle at sea level.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("not" = {"required": ["altitude", "density"]}))]
pub struct Air {
    /// Height of the muzzle above sea level, m. Density and viscosity are those of the standard atmosphere (ISO 2533)
    /// and change as the net rises. Default: 0 m, unless `density` is given.
    pub altitude: Option<Length<Troposphere>>,
    /// Density of a medium that is the same at any height, kg/m^3. Water has 1000. It is given together with
    /// `viscosity`. Default: that of the standard atmosphere.
    pub density: Option<Density<Positive>>,
    /// Dynamic viscosity of the medium, Pa s. Water of 20 deg C has 1 mPa s. It is given together with `density`.
    /// Default: that of the standard atmosphere.
    pub viscosity: Option<Viscosity<Positive>>,
    /// Drag coefficient of a rope in a flow normal to it. Default: it follows from the Reynolds number, as measured
    /// on round ropes (Choo & Casarella 1971).
    pub normal_coefficient: Option<Number<NonNegative>>,
    /// Drag coefficient of a rope in a flow along it, referred to diameter times length. Default: 0.02.
    pub tangential_coefficient: Number<NonNegative>,
    /// Drag coefficient of a canopy normal to the flow. The porosity of the canopy reduces it. Default: 1.17.
    pub sheet_coefficient: Number<NonNegative>,
    /// Added mass coefficient of ropes: mass of the medium that moves with a rope across its length, over the mass
    /// that the rope displaces. It is 1 for a round rope (potential flow, Lamb 1932, art. 68). Added mass is
    /// negligible in air. Default: 0.
    pub added_mass: Number<NonNegative>,
    /// Whether buoyancy acts on ropes, canopies and bodies. Default: true if `density` is given, else false.
    pub buoyancy: Option<bool>,
    /// Solidity of the net: projected area of the ropes over the area of the net, 0 to 0.7. "web" computes it from
    /// the ropes of the web within its outline as drawn. Ropes of a dense net have more drag than single ropes,
    /// because the flow is faster between them. Unless `normal_coefficient` is given, the drag coefficient is then
    /// that of smooth twine (Kristiansen & Faltinsen 2012). Default: none; each rope has the drag of a single rope.
    pub solidity: Option<Solidity>,
}

impl Default for Air {
    fn default() -> Self {
        Self {
            altitude: None,
            density: None,
            viscosity: None,
            normal_coefficient: None,
            tangential_coefficient: Number::constant(0.02),
            sheet_coefficient: Number::constant(PLATE),
            added_mass: Number::constant(0.0),
            buoyancy: None,
            solidity: None,
        }
    }
}

impl Air {
    /// Fills in the defaults that depend on the medium.
    pub(crate) fn complete(&mut self) {
        if self.density.is_none() {
            self.altitude.get_or_insert(Length::constant(0.0));
        }
        self.buoyancy.get_or_insert(self.density.is_some());
    }
}

/// The solidity of a net: projected area of its ropes over its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solidity {
    /// A given value.
    Given(Number<OpenShare>),
    /// Computed from the web as drawn.
    Web,
}

/// The word in a scenario for [`Solidity::Web`].
const WEB: &str = "web";

impl Serialize for Solidity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Given(share) => share.serialize(serializer),
            Self::Web => serializer.serialize_str(WEB),
        }
    }
}

impl<'de> Deserialize<'de> for Solidity {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct SolidityVisitor;

        impl Visitor<'_> for SolidityVisitor {
            type Value = Solidity;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(formatter, "a number or {WEB:?}")
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Solidity, E> {
                match text {
                    WEB => Ok(Solidity::Web),
                    text => Number::from_text(text).map(Solidity::Given).map_err(E::custom),
                }
            }

            fn visit_f64<E: de::Error>(self, share: f64) -> Result<Solidity, E> {
                Number::from_si(share).map(Solidity::Given).map_err(E::custom)
            }

            fn visit_i64<E: de::Error>(self, share: i64) -> Result<Solidity, E> {
                self.visit_f64(share as f64)
            }

            fn visit_u64<E: de::Error>(self, share: u64) -> Result<Solidity, E> {
                self.visit_f64(share as f64)
            }
        }

        deserializer.deserialize_any(SolidityVisitor)
    }
}

impl JsonSchema for Solidity {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "solidity".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut schema = Number::<OpenShare>::json_schema(generator);
        schema.insert("x-word".into(), WEB.into());
        schema
    }
}

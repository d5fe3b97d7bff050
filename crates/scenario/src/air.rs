//! `[environment.air]`: the medium that a net flies through, and how it drags at it.

use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::interval::{NonNegative, OpenShare, Positive, Troposphere};
use crate::quantity::{Density, Length, Number, Viscosity};

/// Drag coefficient of a plate square to the wind, as that of a sheet in `netcast-dynamics`.
const PLATE: f64 = 1.17;

/// `[environment.air]`: the standard atmosphere, or a medium of one `density` and `viscosity`, water too. As it is: that
/// atmosphere at sea level, and every drag with its default.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(extend("not" = {"required": ["altitude", "density"]}))]
pub struct Air {
    /// Height of the muzzle above the sea, m: density and viscosity are then those of the standard atmosphere (ISO 2533),
    /// which thins as the net rises. Left out, where no density is given: 0.
    pub altitude: Option<Length<Troposphere>>,
    /// Density of a medium that is the same at any height, kg/m^3; water has 1000. Its viscosity is given with it.
    pub density: Option<Density<Positive>>,
    /// Dynamic viscosity of that medium, Pa s; water of 20 deg C has 1 mPa s.
    pub viscosity: Option<Viscosity<Positive>>,
    /// Drag coefficient of a rope across it. Left out: by its Reynolds number, as measured on round ropes (Choo & Casarella
    /// 1971).
    pub normal_coefficient: Option<Number<NonNegative>>,
    /// Drag coefficient of a rope along it, with reference to diameter times length.
    pub tangential_coefficient: Number<NonNegative>,
    /// Drag coefficient of a canopy square to the wind; its porosity takes from it.
    pub sheet_coefficient: Number<NonNegative>,
    /// Mass of the medium that a rope moves with it across its length, over the mass that it displaces: 1 for a round
    /// rope (potential flow, Lamb 1932, art. 68). 0 leaves it out, which is right in air.
    pub added_mass: Number<NonNegative>,
    /// Whether ropes, canopies and bodies are buoyed up by what they displace. Left out: where a density is given.
    pub buoyancy: Option<bool>,
    /// How close the web's ropes stand: their projected area over that of the web, 0 to 0.7, or "web", for that of the
    /// web's own ropes within its outline as drawn. The ropes of a close net drag more than each alone, for the flow is
    /// faster between them; where no `normal_coefficient` is given, theirs is then that of smooth twine (Kristiansen &
    /// Faltinsen 2012). Left out: each rope drags as if alone.
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
    /// Writes out what follows from the medium.
    pub(crate) fn complete(&mut self) {
        if self.density.is_none() {
            self.altitude.get_or_insert(Length::constant(0.0));
        }
        self.buoyancy.get_or_insert(self.density.is_some());
    }
}

/// How close the ropes of a web stand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solidity {
    /// As given.
    Given(Number<OpenShare>),
    /// As the web is drawn.
    Web,
}

/// What stands for the solidity of the web as drawn.
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

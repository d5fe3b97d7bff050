//! [`Quantity`]: a value whose type has its dimension and its interval.

use std::fmt;
use std::marker::PhantomData;

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{self, Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};
use serde_json::{Map, Value};

use crate::dimension::{Measured, QuantityError, unit};
use crate::interval::{Any, Within};

/// A finite value in the SI unit `U`, within the interval `I`.
///
/// In a scenario it is a string with a unit ("2.5 m", "10 mm") or a bare number in SI units.
pub struct Quantity<U, I = Any> {
    si: f64,
    marker: PhantomData<(U, I)>,
}

/// A number without a dimension.
pub type Number<I = Any> = Quantity<unit::One, I>;
/// A length, m.
pub type Length<I = Any> = Quantity<unit::Metre, I>;
/// An area, m^2.
pub type Area<I = Any> = Quantity<unit::SquareMetre, I>;
/// A volume, m^3.
pub type Volume<I = Any> = Quantity<unit::CubicMetre, I>;
/// A mass, kg.
pub type Mass<I = Any> = Quantity<unit::Kilogram, I>;
/// A mass per length, kg/m.
pub type LinearDensity<I = Any> = Quantity<unit::KilogramPerMetre, I>;
/// A mass per volume, kg/m^3.
pub type Density<I = Any> = Quantity<unit::KilogramPerCubicMetre, I>;
/// A time, s.
pub type Time<I = Any> = Quantity<unit::Second, I>;
/// A rate, 1/s.
pub type Rate<I = Any> = Quantity<unit::PerSecond, I>;
/// A speed, m/s.
pub type Speed<I = Any> = Quantity<unit::MetrePerSecond, I>;
/// An acceleration, m/s^2.
pub type Acceleration<I = Any> = Quantity<unit::MetrePerSquareSecond, I>;
/// A force, N.
pub type Force<I = Any> = Quantity<unit::Newton, I>;
/// A force per length, N/m.
pub type ForcePerLength<I = Any> = Quantity<unit::NewtonPerMetre, I>;
/// A pressure or elastic modulus, Pa.
pub type Pressure<I = Any> = Quantity<unit::Pascal, I>;
/// A dynamic viscosity, Pa s.
pub type Viscosity<I = Any> = Quantity<unit::PascalSecond, I>;
/// A bending stiffness of a rope, N m^2.
pub type BendingStiffness<I = Any> = Quantity<unit::NewtonSquareMetre, I>;
/// An angle, rad.
pub type Angle<I = Any> = Quantity<unit::Radian, I>;
/// An angular speed, rad/s.
pub type AngularSpeed<I = Any> = Quantity<unit::RadianPerSecond, I>;

impl<U: Measured, I: Within> Quantity<U, I> {
    /// A quantity of `si` in SI.
    ///
    /// # Errors
    /// Where `si` is not finite or lies outside the interval.
    pub fn from_si(si: f64) -> Result<Self, QuantityError> {
        U::KIND.read_number(si, &I::INTERVAL).map(Self::constant)
    }

    /// Reads a number with its unit.
    ///
    /// # Errors
    /// Where the text cannot be read, has another dimension, or lies outside the interval.
    pub fn from_text(text: &str) -> Result<Self, QuantityError> {
        U::KIND.read_text(text, &I::INTERVAL).map(Self::constant)
    }
}

impl<U, I> Quantity<U, I> {
    /// A quantity that is known to lie in its interval, such as a default.
    pub const fn constant(si: f64) -> Self {
        Self { si, marker: PhantomData }
    }

    /// The value in SI.
    pub const fn si(&self) -> f64 {
        self.si
    }
}

// not derived: derives would require the same traits of the markers
impl<U, I> Clone for Quantity<U, I> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<U, I> Copy for Quantity<U, I> {}

impl<U, I> PartialEq for Quantity<U, I> {
    fn eq(&self, other: &Self) -> bool {
        self.si == other.si
    }
}

impl<U: Measured, I> fmt::Display for Quantity<U, I> {
    /// The value in its SI unit, with the fewest digits that read back as the same bits.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = format!("{:?}", self.si);
        let digits = digits.strip_suffix(".0").unwrap_or(&digits);
        match U::KIND.unit {
            "" => formatter.write_str(digits),
            unit => write!(formatter, "{digits} {unit}"),
        }
    }
}

impl<U: Measured, I> fmt::Debug for Quantity<U, I> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}

impl<U: Measured, I> Serialize for Quantity<U, I> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if U::KIND.unit.is_empty() { serializer.serialize_f64(self.si) } else { serializer.collect_str(self) }
    }
}

impl<'de, U: Measured, I: Within> Deserialize<'de> for Quantity<U, I> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct QuantityVisitor<U, I>(PhantomData<(U, I)>);

        impl<U: Measured, I: Within> Visitor<'_> for QuantityVisitor<U, I> {
            type Value = Quantity<U, I>;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str(&U::KIND.expected(&I::INTERVAL))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
                Quantity::from_text(text).map_err(E::custom)
            }

            fn visit_f64<E: de::Error>(self, si: f64) -> Result<Self::Value, E> {
                Quantity::from_si(si).map_err(E::custom)
            }

            fn visit_i64<E: de::Error>(self, si: i64) -> Result<Self::Value, E> {
                self.visit_f64(si as f64)
            }

            fn visit_u64<E: de::Error>(self, si: u64) -> Result<Self::Value, E> {
                self.visit_f64(si as f64)
            }
        }

        deserializer.deserialize_any(QuantityVisitor(PhantomData))
    }
}

impl<U: Measured, I: Within> JsonSchema for Quantity<U, I> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        U::KIND.name.into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let mut schema = Map::new();
        schema.insert("type".into(), Value::from(vec!["string", "number"]));
        schema.insert("x-dimension".into(), Value::from(U::KIND.name));
        schema.insert("x-unit".into(), Value::from(U::KIND.unit));
        schema.insert("examples".into(), Value::from(vec![U::KIND.example]));
        U::KIND.bounded(&I::INTERVAL).write_schema(&mut schema);
        schema.into()
    }
}

#[cfg(test)]
mod tests {
    use proptest::num::f64::{NORMAL, SUBNORMAL, ZERO};

    use super::*;
    use crate::interval::{NonNegative, Positive, QuarterTurns, UpToOne};

    #[test]
    fn a_quantity_is_written_in_its_unit_with_the_fewest_digits() {
        assert_eq!(Length::<Any>::from_si(2.5).unwrap().to_string(), "2.5 m");
        assert_eq!(Length::<Any>::from_text("10 mm").unwrap().to_string(), "0.01 m");
        assert_eq!(Angle::<Any>::from_text("90 deg").unwrap().to_string(), "1.5707963267948966 rad");
        assert_eq!(Pressure::<Any>::from_text("78 GPa").unwrap().to_string(), "78000000000 Pa");
    }

    #[test]
    fn a_value_outside_the_interval_is_refused() {
        assert_eq!(
            Length::<Positive>::from_text("0 m").unwrap_err().to_string(),
            r#"expected a length greater than 0 such as "2.5 m", found "0 m""#
        );
        assert!(Length::<NonNegative>::from_text("0 m").is_ok());
        assert!(Length::<Any>::from_si(f64::NAN).is_err());
        assert!(Length::<Any>::from_si(f64::INFINITY).is_err());
        assert!(Number::<UpToOne>::from_si(1.0).is_ok());
        assert!(Number::<UpToOne>::from_si(1.5).is_err());
        assert_eq!(
            Angle::<QuarterTurns>::from_text("91 deg").unwrap_err().to_string(),
            r#"expected an angle of at least -90 deg and at most 90 deg such as "30 deg", found "91 deg""#
        );
    }

    proptest::proptest! {
        #[test]
        fn a_written_quantity_reads_back_bit_for_bit(si in NORMAL | ZERO | SUBNORMAL) {
            let length = Length::<Any>::constant(si);
            match Length::<Any>::from_text(&length.to_string()) {
                Ok(back) => proptest::prop_assert_eq!(back.si().to_bits(), si.to_bits()),
                Err(_) => proptest::prop_assert!(si.abs() > unit::Metre::KIND.largest),
            }
        }
    }
}

//! The kinds of quantity in a scenario, with their dimension, their SI unit and their name in messages.

use std::ops::Bound;

pub use crate::exponents::Dimension;
use crate::interval::Interval;
use crate::unit_error::UnitError;
use crate::units;

/// A kind of quantity, such as a length.
#[derive(Debug, PartialEq)]
pub struct Kind {
    /// Its name, as in `x-dimension` of the schema.
    pub name: &'static str,
    /// The name with its article, for sentences.
    pub article_name: &'static str,
    /// Its SI unit as a scenario writes it; empty for a number.
    pub unit: &'static str,
    /// An example of a value.
    pub example: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// The largest size of a value, in the SI unit: far beyond use, and small enough that sums and squares resolve it.
    pub largest: f64,
}

/// A fault of a quantity.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// The text is not a number with a unit.
    #[error("expected {expected}, found {text:?}: {error}")]
    Unreadable {
        /// What the key takes.
        expected: String,
        /// The text in its place.
        text: String,
        /// Why it cannot be read.
        error: UnitError,
    },
    /// The value has another dimension.
    #[error("expected {expected}, found {text:?}, which {}", describe(found))]
    Dimension {
        /// What the key takes.
        expected: String,
        /// The text in its place.
        text: String,
        /// The dimension of that text.
        found: Dimension,
    },
    /// The value lies outside its interval or is not finite.
    #[error("expected {expected}, found {text}")]
    Range {
        /// What the key takes.
        expected: String,
        /// The text in its place.
        text: String,
    },
}

fn describe(found: &Dimension) -> String {
    match Kind::of(*found) {
        Some(kind) if kind.unit.is_empty() => "has no unit".to_string(),
        Some(kind) => format!("is {}", kind.article_name),
        None => format!("is in {found}"),
    }
}

impl Kind {
    /// The kind that `x-dimension` names.
    pub fn named(name: &str) -> Option<&'static Self> {
        KINDS.iter().copied().find(|kind| kind.name == name)
    }

    /// The kind of quantity of a dimension.
    pub fn of(dimension: Dimension) -> Option<&'static Self> {
        KINDS.iter().copied().find(|kind| kind.dimension == dimension)
    }

    /// Reads `text`, a number with a unit, as a value in SI units.
    ///
    /// # Errors
    /// Where it is not a number with a unit, has another dimension or lies outside `interval`.
    pub fn read_text(&self, text: &str, interval: &Interval) -> Result<f64, QuantityError> {
        let measure = units::parse(text).map_err(|error| QuantityError::Unreadable {
            expected: self.expected(interval),
            text: text.to_string(),
            error: self.of_speed(error),
        })?;
        if measure.dimension != self.dimension {
            return Err(QuantityError::Dimension {
                expected: self.expected(interval),
                text: text.to_string(),
                found: measure.dimension,
            });
        }
        self.admit(measure.si, interval, format!("{text:?}"))
    }

    /// Of a speed, `kn` stands for knots, not for kilonewtons.
    fn of_speed(&self, error: UnitError) -> UnitError {
        match error {
            UnitError::Unknown { unit, .. } if self.name == "speed" && ["kn", "kt", "kts"].contains(&&unit[..]) => {
                UnitError::Unknown { unit, nearest: Some("knots".into()) }
            }
            other => other,
        }
    }

    /// Checks a bare number, which is in SI units.
    ///
    /// # Errors
    /// Where it is not finite or lies outside `interval`.
    pub fn read_number(&self, si: f64, interval: &Interval) -> Result<f64, QuantityError> {
        self.admit(si, interval, format!("{si:?}"))
    }

    fn admit(&self, si: f64, interval: &Interval, text: String) -> Result<f64, QuantityError> {
        let interval = &self.own_bounds(interval);
        if si.is_finite() && self.bounded(interval).contains(si) {
            Ok(si)
        } else {
            // the bounds of the kind are told only to who exceeds them
            let told = if si.abs() > self.largest { self.bounded(interval) } else { *interval };
            Err(QuantityError::Range { expected: self.stated(&told), text })
        }
    }

    /// `interval`, ended by the largest size of this kind where it has no end of its own.
    pub const fn bounded(&self, interval: &Interval) -> Interval {
        let lower = match interval.lower {
            Bound::Unbounded => Bound::Included(-self.largest),
            stated => stated,
        };
        let upper = match interval.upper {
            Bound::Unbounded => Bound::Included(self.largest),
            stated => stated,
        };
        Interval { lower, upper }
    }

    /// `interval` without the ends that every value of this kind has.
    fn own_bounds(&self, interval: &Interval) -> Interval {
        let own = |bound| match bound {
            Bound::Included(limit) if f64::abs(limit) == self.largest => Bound::Unbounded,
            stated => stated,
        };
        Interval { lower: own(interval.lower), upper: own(interval.upper) }
    }

    /// What a key of this kind takes, in words, such as `a length greater than 0 such as "2.5 m"`.
    ///
    /// The bounds that every value of this kind has are left out.
    pub fn expected(&self, interval: &Interval) -> String {
        self.stated(&self.own_bounds(interval))
    }

    fn stated(&self, interval: &Interval) -> String {
        let bounds = interval.describe(self.dimension);
        let space = if bounds.is_empty() { "" } else { " " };
        if self.unit.is_empty() {
            format!("{}{space}{bounds} such as {}", self.article_name, self.example)
        } else {
            format!("{}{space}{bounds} such as {:?}", self.article_name, self.example)
        }
    }
}

/// A marker type that stands for a kind of quantity.
pub trait Measured {
    /// The kind.
    const KIND: &'static Kind;
}

macro_rules! kinds {
    ($($marker:ident: $name:literal, $article_name:literal, $unit:literal, $example:literal, $exponents:expr, $largest:expr;)*) => {
        /// Markers for [`Quantity`](crate::quantity::Quantity), each named after its SI unit.
        pub mod unit {
            use super::{Dimension, Kind, Measured};
            $(
                #[doc = concat!("Marks ", $article_name, " in `", $unit, "`.")]
                #[derive(Clone, Copy, Debug, PartialEq)]
                pub struct $marker;

                impl Measured for $marker {
                    const KIND: &'static Kind = &Kind {
                        name: $name,
                        article_name: $article_name,
                        unit: $unit,
                        example: $example,
                        dimension: Dimension::new($exponents),
                        largest: $largest,
                    };
                }
            )*
        }

        const KINDS: &[&Kind] = &[$(<unit::$marker as Measured>::KIND),*];
    };
}

// exponents of metre, kilogram, second, radian; largest size
kinds! {
    One: "number", "a number", "", "0.5", [0, 0, 0, 0], 1e9;
    Metre: "length", "a length", "m", "2.5 m", [1, 0, 0, 0], 1e6;
    SquareMetre: "area", "an area", "m^2", "16 m^2", [2, 0, 0, 0], 1e12;
    CubicMetre: "volume", "a volume", "m^3", "0.02 m^3", [3, 0, 0, 0], 1e15;
    Kilogram: "mass", "a mass", "kg", "0.5 kg", [0, 1, 0, 0], 1e9;
    KilogramPerMetre: "linear density", "a linear density", "kg/m", "145 g/m", [-1, 1, 0, 0], 1e6;
    KilogramPerCubicMetre: "density", "a density", "kg/m^3", "1850 kg/m^3", [-3, 1, 0, 0], 1e6;
    Second: "time", "a time", "s", "0.6 s", [0, 0, 1, 0], 1e9;
    PerSecond: "rate", "a rate", "1/s", "8.3 1/s", [0, 0, -1, 0], 1e9;
    MetrePerSecond: "speed", "a speed", "m/s", "50 m/s", [1, 0, -1, 0], 1e5;
    MetrePerSquareSecond: "acceleration", "an acceleration", "m/s^2", "9.80665 m/s^2", [1, 0, -2, 0], 1e6;
    Newton: "force", "a force", "N", "12 kN", [1, 1, -2, 0], 1e12;
    NewtonPerMetre: "stiffness", "a stiffness or force per length", "N/m", "5 kN/m", [0, 1, -2, 0], 1e12;
    NewtonSquareMetre: "bending stiffness", "a bending stiffness", "N m^2", "0.02 N m^2", [3, 1, -2, 0], 1e9;
    Pascal: "pressure", "a pressure or elastic modulus", "Pa", "78 GPa", [-1, 1, -2, 0], 1e16;
    PascalSecond: "viscosity", "a viscosity", "Pa s", "0.018 mPa s", [-1, 1, -1, 0], 1e6;
    Joule: "energy", "an energy", "J", "1 kJ", [2, 1, -2, 0], 1e15;
    Watt: "power", "a power", "W", "1 kW", [2, 1, -3, 0], 1e15;
    Radian: "angle", "an angle", "rad", "30 deg", [0, 0, 0, 1], 1e4;
    RadianPerSecond: "angular speed", "an angular speed", "rad/s", "20 rad/s", [0, 0, -1, 1], 1e6;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_reads_its_own_unit_and_example() {
        for kind in KINDS {
            assert_eq!(kind.read_text(&format!("2.5 {}", kind.unit), &Interval::ALL), Ok(2.5), "{}", kind.name);
            assert!(kind.read_text(kind.example, &Interval::ALL).is_ok(), "{}", kind.name);
            assert_eq!(Kind::named(kind.name).map(|found| found.dimension), Some(kind.dimension));
            assert_eq!(Kind::of(kind.dimension).map(|found| found.name), Some(kind.name));
        }
    }

    #[test]
    fn a_mass_is_refused_as_a_length() {
        let error = unit::Metre::KIND.read_text("2.5 kg", &Interval::ALL).unwrap_err();
        assert_eq!(error.to_string(), r#"expected a length such as "2.5 m", found "2.5 kg", which is a mass"#);
    }

    #[test]
    fn a_dimension_without_a_name_is_written_out() {
        let error = unit::Metre::KIND.read_text("2.5 kg m", &Interval::ALL).unwrap_err();
        assert!(error.to_string().ends_with("which is in m kg"), "{error}");
    }
}

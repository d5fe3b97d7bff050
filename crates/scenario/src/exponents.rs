//! The dimension of a quantity, as exponents of the base units.

use std::fmt;

/// Exponents of the base units of a quantity. The radian counts as a base unit, which distinguishes angles from
/// numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dimension {
    /// Exponent of the metre.
    pub length: i32,
    /// Exponent of the kilogram.
    pub mass: i32,
    /// Exponent of the second.
    pub time: i32,
    /// Exponent of the radian.
    pub angle: i32,
}

impl Dimension {
    /// The dimension with these exponents of metre, kilogram, second and radian.
    pub(crate) const fn new([length, mass, time, angle]: [i32; 4]) -> Self {
        Self { length, mass, time, angle }
    }

    /// This dimension times `other` to the power `power`.
    pub(crate) fn times(self, other: Self, power: i32) -> Self {
        Self {
            length: self.length + power * other.length,
            mass: self.mass + power * other.mass,
            time: self.time + power * other.time,
            angle: self.angle + power * other.angle,
        }
    }
}

impl fmt::Display for Dimension {
    /// The SI unit of the dimension, such as `m^2 kg s^-2`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let factors = [("m", self.length), ("kg", self.mass), ("s", self.time), ("rad", self.angle)];
        let written: Vec<String> = factors
            .iter()
            .filter(|(_, exponent)| *exponent != 0)
            .map(|(unit, exponent)| if *exponent == 1 { unit.to_string() } else { format!("{unit}^{exponent}") })
            .collect();
        formatter.write_str(&written.join(" "))
    }
}

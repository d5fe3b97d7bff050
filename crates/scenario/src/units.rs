//! Reads a number with its unit: `2.5 m`, `10 mm`, `1 kN/mm^2`, `8.3 1/s`, `145 g/m`, `30 deg`.
//!
//! ```text
//! measure = number [unit]
//! unit    = ["/"] factor { ("/" | "*" | "·" | space) factor }      a divisor needs its own "/": kg/m/s
//! factor  = "1" | [prefix] symbol ["^" integer | superscripts]
//! ```
//!
//! The digits of the number are shifted and multiplied in decimal before they become an `f64`. A unit that is a
//! decimal multiple of an SI unit thus gives the nearest `f64` ("0.3 ms" is 0.0003, "1 ft" is 0.3048). There is one
//! more rounding where a divisor is not a power of ten and for units with an irrational factor.

use crate::exponents::Dimension;
use crate::unit_error::UnitError;
use crate::unit_table::{Unit, find};

/// A number in SI units and its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The value in SI base units and radians; finite.
    pub si: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

/// Reads a number with its unit.
///
/// # Errors
/// [`UnitError`] states the reason.
pub fn parse(text: &str) -> Result<Measure, UnitError> {
    let (number, rest) = Number::take(text.trim())?;
    if rest.starts_with(',') {
        return Err(UnitError::Comma);
    }
    let (scale, dimension) = unit_expression(rest.trim())?;
    let si = scale.apply(&number)?;
    Ok(Measure { si, dimension })
}

/// A decimal number: `digits * 10^exponent`.
struct Number {
    negative: bool,
    digits: String,
    exponent: i64,
}

impl Number {
    /// Takes a number from the start of `text`. The second value is the rest of the text.
    fn take(text: &str) -> Result<(Self, &str), UnitError> {
        let (negative, unsigned) = match text.strip_prefix('-') {
            Some(unsigned) => (true, unsigned),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, rest) = take_digits(unsigned);
        let (fraction, rest) = rest.strip_prefix('.').map_or(("", rest), take_digits);
        if whole.is_empty() && fraction.is_empty() {
            return Err(UnitError::Number);
        }
        let (exponent, rest) = take_exponent(rest);
        let exponent = exponent - fraction.len() as i64;
        Ok((Self { negative, digits: format!("{whole}{fraction}"), exponent }, rest))
    }
}

fn take_digits(text: &str) -> (&str, &str) {
    text.split_at(text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len()))
}

/// Takes `e-3`; an `e` that no digit follows belongs to the unit.
fn take_exponent(text: &str) -> (i64, &str) {
    let Some(after) = text.strip_prefix(['e', 'E']) else { return (0, text) };
    let (sign, unsigned) = match after.strip_prefix('-') {
        Some(unsigned) => (-1, unsigned),
        None => (1, after.strip_prefix('+').unwrap_or(after)),
    };
    let (digits, rest) = take_digits(unsigned);
    if digits.is_empty() {
        return (0, text);
    }
    // larger than the exponent of any f64, and small enough that sums do not overflow
    let exponent = digits.parse().map_or(1_000_000, |exponent: i64| exponent.min(1_000_000));
    (sign * exponent, rest)
}

/// The factor of a unit expression to SI: `numerator / denominator * 10^exponent * rest`.
struct Scale {
    numerator: u64,
    denominator: u64,
    exponent: i64,
    rest: f64,
}

impl Scale {
    const ONE: Self = Self { numerator: 1, denominator: 1, exponent: 0, rest: 1.0 };

    fn times(&mut self, unit: &Unit, prefix_exponent: i32, power: i32) -> Result<(), UnitError> {
        let integer = unit.integer.checked_pow(power.unsigned_abs()).ok_or(UnitError::TooLarge)?;
        let side = if power < 0 { &mut self.denominator } else { &mut self.numerator };
        *side = side.checked_mul(integer).ok_or(UnitError::TooLarge)?;
        self.exponent += i64::from(power) * i64::from(unit.exponent + prefix_exponent);
        for _ in 0..power.unsigned_abs() {
            self.rest = if power < 0 { self.rest / unit.rest } else { self.rest * unit.rest };
        }
        Ok(())
    }

    fn apply(&self, number: &Number) -> Result<f64, UnitError> {
        let digits = multiply(&number.digits, self.numerator);
        let decimal = format!("{digits}e{}", number.exponent + self.exponent);
        let magnitude: f64 = decimal.parse().map_err(|_| UnitError::Number)?;
        let si = magnitude / self.denominator as f64 * self.rest;
        if !si.is_finite() {
            return Err(UnitError::TooLarge);
        }
        Ok(if number.negative { -si } else { si })
    }
}

/// Decimal digits times a whole number, exactly.
fn multiply(digits: &str, factor: u64) -> String {
    let mut carry = 0u128;
    let mut product: Vec<char> = Vec::with_capacity(digits.len() + 20);
    for digit in digits.bytes().rev() {
        carry += u128::from(digit - b'0') * u128::from(factor);
        product.push(char::from(b'0' + (carry % 10) as u8));
        carry /= 10;
    }
    while carry > 0 {
        product.push(char::from(b'0' + (carry % 10) as u8));
        carry /= 10;
    }
    product.iter().rev().collect()
}

fn unit_expression(text: &str) -> Result<(Scale, Dimension), UnitError> {
    let mut scale = Scale::ONE;
    let mut dimension = Dimension::default();
    if text.is_empty() {
        return Ok((scale, dimension));
    }
    let (mut dividing, mut rest) = match text.strip_prefix('/') {
        Some(divisor) => (true, divisor.trim_start()),
        None => (false, text),
    };
    loop {
        let symbol_length = rest.find(|c: char| !is_symbol(c)).unwrap_or(rest.len());
        let (symbol, after) = rest.split_at(symbol_length);
        rest = if symbol.is_empty() {
            rest.strip_prefix('1').ok_or_else(|| UnitError::Unit(rest.to_string()))?
        } else {
            let (unit, prefix_exponent) = find(symbol)?;
            let (power, after) = take_power(symbol, after)?;
            let power = if dividing { -power } else { power };
            scale.times(unit, prefix_exponent, power)?;
            dimension = dimension.times(unit.dimension, power);
            after
        };
        let after_space = rest.trim_start();
        if after_space.is_empty() {
            return Ok((scale, dimension));
        }
        if let Some(divisor) = after_space.strip_prefix('/') {
            dividing = true;
            rest = divisor.trim_start();
        } else if dividing {
            return Err(UnitError::Ambiguous);
        } else if let Some(factor) = after_space.strip_prefix(['*', '·']) {
            rest = factor.trim_start();
        } else if after_space.len() < rest.len() {
            rest = after_space;
        } else {
            return Err(UnitError::Unit(rest.to_string()));
        }
    }
}

fn is_symbol(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '%' | '°')
}

/// Takes the power after a symbol: `^2`, `^-1`, `²`, or nothing for 1.
fn take_power<'a>(symbol: &str, text: &'a str) -> Result<(i32, &'a str), UnitError> {
    const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    if let Some(power) = text.strip_prefix('^') {
        let (sign, digits) = power.strip_prefix('-').map_or((1, power), |digits| (-1, digits));
        let (digits, rest) = take_digits(digits);
        let power = digits.parse().ok().filter(|power: &i32| *power <= 9).ok_or(UnitError::Exponent)?;
        return Ok((sign * power, rest));
    }
    let (sign, superscript) = text.strip_prefix('⁻').map_or((1, text), |rest| (-1, rest));
    let value = superscript.chars().next().and_then(|c| SUPERSCRIPTS.chars().position(|digit| digit == c));
    if let (Some(value), Some(digit)) = (value, superscript.chars().next()) {
        return Ok((sign * value as i32, &superscript[digit.len_utf8()..]));
    }
    if text.starts_with(|c: char| c.is_ascii_digit()) {
        let (digits, _) = take_digits(text);
        return Err(UnitError::Unknown {
            unit: format!("{symbol}{digits}"),
            nearest: Some(format!("{symbol}^{digits}")),
        });
    }
    Ok((1, text))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn si(text: &str) -> f64 {
        parse(text).unwrap_or_else(|error| panic!("{text}: {error}")).si
    }

    #[test]
    fn decimal_units_give_the_nearest_float() {
        for (text, expected) in [
            ("2.5 m", 2.5),
            ("10 mm", 0.01),
            ("0.3 ms", 0.0003),
            ("2 us", 2e-6),
            ("2 µs", 2e-6),
            ("2 μs", 2e-6),
            ("78 GPa", 78e9),
            ("1 kN/mm^2", 1e9),
            ("1 kN/mm²", 1e9),
            ("1850 kg/m^3", 1850.0),
            ("1.85 g/cm^3", 1850.0),
            ("8.3 1/s", 8.3),
            ("8.3 s^-1", 8.3),
            ("8.3 s⁻¹", 8.3),
            ("8.3/s", 8.3),
            ("145 g/m", 0.145),
            ("9.80665 m/s^2", 9.80665),
            ("1 ft", 0.3048),
            ("3 lb", 1.36077711),
            ("1 lbf", 4.4482216152605),
            ("12 N*m", 12.0),
            ("12 N m", 12.0),
            ("220 dtex", 2.2e-5),
            ("-1.5e-3 km", -1.5),
            (".5 m", 0.5),
            ("5. m", 5.0),
            ("30 %", 0.3),
            ("7", 7.0),
            ("36 km/h", 10.0),
            ("60 1/min", 1.0),
            ("36 kph", 10.0),
            ("1 mph", 0.44704),
            ("1 knot", 1852.0 / 3600.0),
            ("0.1 t", 100.0),
        ] {
            assert_eq!(si(text), expected, "{text}");
        }
    }

    #[test]
    fn degrees_are_fractions_of_pi() {
        assert_eq!(si("90 deg"), std::f64::consts::FRAC_PI_2);
        assert_eq!(si("-90 deg"), -std::f64::consts::FRAC_PI_2);
        assert_eq!(si("180 °"), PI);
    }

    #[test]
    fn min_is_a_minute_and_not_a_milli_inch() {
        assert_eq!(parse("1 min").unwrap().dimension, parse("1 s").unwrap().dimension);
        assert_eq!(si("2 min"), 120.0);
    }

    #[test]
    fn many_digits_are_rounded_once() {
        assert_eq!(si("0.1000000000000000055511151231257827 m"), 0.1);
        assert_eq!(si("123456789012345678901234567890 pm"), 123456789012345678.90123456789);
    }

    #[test]
    fn errors_name_the_nearest_unit() {
        let nearest_of = |text: &str| match parse(text).unwrap_err() {
            UnitError::Unknown { nearest, .. } => nearest,
            other => panic!("{text}: {other}"),
        };
        assert_eq!(nearest_of("3 kn").as_deref(), Some("kN"));
        assert_eq!(nearest_of("3 gpa").as_deref(), Some("GPa"));
        assert_eq!(nearest_of("3 m2").as_deref(), Some("m^2"));
        assert_eq!(nearest_of("3 metres").as_deref(), Some("m"));
        assert_eq!(nearest_of("3 furlongs"), None);
        assert_eq!(parse("3 kn").unwrap_err().to_string(), r#"unknown unit "kn", did you mean "kN"?"#);
    }

    #[test]
    fn a_text_that_is_not_a_measure_gives_the_reason() {
        for (text, expected) in [
            ("", UnitError::Number),
            ("m", UnitError::Number),
            ("NaN m", UnitError::Number),
            ("inf m", UnitError::Number),
            ("2,5 m", UnitError::Comma),
            ("1 kg/m s", UnitError::Ambiguous),
            ("1 m^x", UnitError::Exponent),
            ("1 m^99", UnitError::Exponent),
            ("1e999 m", UnitError::TooLarge),
            ("1e99999999999999999999 m", UnitError::TooLarge),
            ("1 m/", UnitError::Unit(String::new())),
            ("1 m?", UnitError::Unit("?".into())),
        ] {
            assert_eq!(parse(text).unwrap_err(), expected, "{text}");
        }
    }

    proptest::proptest! {
        #[test]
        fn no_text_panics(text in "\\PC*") {
            let _ = parse(&text);
        }

        #[test]
        fn unit_like_text_does_not_panic(text in "[-+]?[0-9.,]{1,30}(e[-+]?[0-9]{1,20})? ?[a-zA-Z%µ°/*^0-9 ²⁻-]{0,20}") {
            let _ = parse(&text);
        }

        #[test]
        fn a_float_is_read_back_bit_for_bit(value in proptest::num::f64::NORMAL) {
            proptest::prop_assert_eq!(si(&format!("{value:?} m")).to_bits(), value.to_bits());
        }
    }
}

//! The units that a scenario can use.
//!
//! Factors: SI brochure, 9th edition, table 8; NIST Special Publication 811, appendix B (feet, pounds).

use std::f64::consts::PI;

use crate::exponents::Dimension;
use crate::nearest::nearest;
use crate::unit_error::UnitError;

/// A unit that a scenario can use.
pub(crate) struct Unit {
    symbol: &'static str,
    /// Whether it takes prefixes such as `k`.
    prefixes: bool,
    /// The factor to SI is `integer * 10^exponent * rest`.
    pub(crate) integer: u64,
    pub(crate) exponent: i32,
    pub(crate) rest: f64,
    pub(crate) dimension: Dimension,
}

const fn unit(symbol: &'static str, integer: u64, exponent: i32, exponents: [i32; 4]) -> Unit {
    Unit { symbol, prefixes: false, integer, exponent, rest: 1.0, dimension: Dimension::new(exponents) }
}

const fn prefixed(symbol: &'static str, exponent: i32, exponents: [i32; 4]) -> Unit {
    Unit { prefixes: true, ..unit(symbol, 1, exponent, exponents) }
}

const fn irrational(symbol: &'static str, rest: f64, exponents: [i32; 4]) -> Unit {
    Unit { rest, ..unit(symbol, 1, 0, exponents) }
}

// exponents of metre, kilogram, second, radian
const UNITS: &[Unit] = &[
    prefixed("m", 0, [1, 0, 0, 0]),
    prefixed("g", -3, [0, 1, 0, 0]),
    prefixed("s", 0, [0, 0, 1, 0]),
    prefixed("N", 0, [1, 1, -2, 0]),
    prefixed("Pa", 0, [-1, 1, -2, 0]),
    prefixed("J", 0, [2, 1, -2, 0]),
    prefixed("W", 0, [2, 1, -3, 0]),
    prefixed("Hz", 0, [0, 0, -1, 0]),
    prefixed("rad", 0, [0, 0, 0, 1]),
    prefixed("L", -3, [3, 0, 0, 0]),
    prefixed("bar", 5, [-1, 1, -2, 0]),
    prefixed("tex", -6, [-1, 1, 0, 0]),
    irrational("deg", PI / 180.0, [0, 0, 0, 1]),
    irrational("°", PI / 180.0, [0, 0, 0, 1]),
    irrational("rev", 2.0 * PI, [0, 0, 0, 1]),
    irrational("rpm", PI / 30.0, [0, 0, -1, 1]),
    unit("%", 1, -2, [0, 0, 0, 0]),
    unit("t", 1, 3, [0, 1, 0, 0]),
    irrational("kph", 1000.0 / 3600.0, [1, 0, -1, 0]),
    unit("mph", 44_704, -5, [1, 0, -1, 0]),
    irrational("knot", 1852.0 / 3600.0, [1, 0, -1, 0]),
    irrational("knots", 1852.0 / 3600.0, [1, 0, -1, 0]),
    unit("min", 60, 0, [0, 0, 1, 0]),
    unit("h", 3600, 0, [0, 0, 1, 0]),
    unit("in", 254, -4, [1, 0, 0, 0]),
    unit("ft", 3048, -4, [1, 0, 0, 0]),
    unit("yd", 9144, -4, [1, 0, 0, 0]),
    unit("mi", 1_609_344, -3, [1, 0, 0, 0]),
    unit("oz", 28_349_523_125, -12, [0, 1, 0, 0]),
    unit("lb", 45_359_237, -8, [0, 1, 0, 0]),
    unit("lbf", 44_482_216_152_605, -13, [1, 1, -2, 0]),
    unit("kgf", 980_665, -5, [1, 1, -2, 0]),
    irrational("psi", 4.448_221_615_260_5 / (0.0254 * 0.0254), [-1, 1, -2, 0]),
    unit("atm", 101_325, 0, [-1, 1, -2, 0]),
];

const PREFIXES: &[(&str, i32)] = &[
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6), // micro sign
    ("μ", -6), // greek mu
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

/// The unit that `symbol` names, and the power of ten of its prefix.
///
/// # Errors
/// [`UnitError::Unknown`] where no unit has this name.
pub(crate) fn find(symbol: &str) -> Result<(&'static Unit, i32), UnitError> {
    if let Some(unit) = UNITS.iter().find(|unit| unit.symbol == symbol) {
        return Ok((unit, 0));
    }
    let with_prefix = PREFIXES.iter().find_map(|(prefix, exponent)| {
        let bare = symbol.strip_prefix(prefix)?;
        let unit = UNITS.iter().find(|unit| unit.prefixes && unit.symbol == bare)?;
        Some((unit, *exponent))
    });
    with_prefix.ok_or_else(|| UnitError::Unknown { unit: symbol.to_string(), nearest: suggest(symbol) })
}

/// The unit with the most similar name: first by full names, then among all units with their prefixes.
fn suggest(symbol: &str) -> Option<String> {
    const FULL_NAMES: &[(&str, &str)] = &[
        ("met", "m"),
        ("kilog", "kg"),
        ("gram", "g"),
        ("sec", "s"),
        ("newton", "N"),
        ("pascal", "Pa"),
        ("degree", "deg"),
        ("radian", "rad"),
        ("minute", "min"),
        ("hour", "h"),
        ("feet", "ft"),
        ("foot", "ft"),
        ("inch", "in"),
        ("pound", "lb"),
    ];
    let lower_case = symbol.to_lowercase();
    if let Some((_, unit)) = FULL_NAMES.iter().find(|(start, _)| lower_case.starts_with(start)) {
        return Some(unit.to_string());
    }
    let bare = UNITS.iter().map(|unit| unit.symbol.to_string());
    let with_prefix = UNITS.iter().filter(|unit| unit.prefixes).flat_map(|unit| {
        PREFIXES.iter().filter(|(prefix, _)| prefix.is_ascii()).map(|(prefix, _)| format!("{prefix}{}", unit.symbol))
    });
    nearest(symbol, bare.chain(with_prefix))
}

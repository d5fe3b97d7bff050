//! Intervals of the values that a quantity can take, and marker types for them in the types of fields.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Bound, RangeBounds};

use serde_json::{Map, Value};

use crate::exponents::Dimension;

/// The values that a quantity can take, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Its lower end.
    pub lower: Bound<f64>,
    /// Its upper end.
    pub upper: Bound<f64>,
}

/// The JSON Schema keywords of the four kinds of bound.
const INCLUSIVE_LOWER: &str = "minimum";
const EXCLUSIVE_LOWER: &str = "exclusiveMinimum";
const INCLUSIVE_UPPER: &str = "maximum";
const EXCLUSIVE_UPPER: &str = "exclusiveMaximum";

impl Interval {
    /// Every number.
    pub const ALL: Self = Self { lower: Bound::Unbounded, upper: Bound::Unbounded };

    /// Whether the interval holds `si`.
    pub fn contains(&self, si: f64) -> bool {
        (self.lower, self.upper).contains(&si)
    }

    /// Reads the bounds from a JSON Schema.
    pub fn from_schema(schema: &Map<String, Value>) -> Self {
        let number = |keyword: &str| schema.get(keyword).and_then(Value::as_f64);
        let bound = |inclusive, exclusive| match (number(inclusive), number(exclusive)) {
            (_, Some(limit)) => Bound::Excluded(limit),
            (Some(limit), None) => Bound::Included(limit),
            (None, None) => Bound::Unbounded,
        };
        Self { lower: bound(INCLUSIVE_LOWER, EXCLUSIVE_LOWER), upper: bound(INCLUSIVE_UPPER, EXCLUSIVE_UPPER) }
    }

    /// Writes the bounds into a JSON Schema.
    pub fn write_schema(&self, schema: &mut Map<String, Value>) {
        let mut state = |bound, inclusive: &str, exclusive: &str| match bound {
            Bound::Included(limit) => drop(schema.insert(inclusive.into(), Value::from(limit))),
            Bound::Excluded(limit) => drop(schema.insert(exclusive.into(), Value::from(limit))),
            Bound::Unbounded => {}
        };
        state(self.lower, INCLUSIVE_LOWER, EXCLUSIVE_LOWER);
        state(self.upper, INCLUSIVE_UPPER, EXCLUSIVE_UPPER);
    }

    /// The bounds in words, such as `greater than 0`. Angles are in degrees.
    pub fn describe(&self, dimension: Dimension) -> String {
        let limit = |si: f64| match si {
            _ if dimension.angle == 1 => format!("{} deg", si.to_degrees()),
            _ if si.abs() >= 1e6 => format!("{si:e}"),
            _ => si.to_string(),
        };
        let lower = match self.lower {
            Bound::Included(si) => Some(format!("of at least {}", limit(si))),
            Bound::Excluded(si) => Some(format!("greater than {}", limit(si))),
            Bound::Unbounded => None,
        };
        let upper = match self.upper {
            Bound::Included(si) if lower.is_some() => Some(format!("at most {}", limit(si))),
            Bound::Included(si) => Some(format!("of at most {}", limit(si))),
            Bound::Excluded(si) => Some(format!("less than {}", limit(si))),
            Bound::Unbounded => None,
        };
        lower.into_iter().chain(upper).collect::<Vec<_>>().join(" and ")
    }
}

/// A marker type that stands for an interval.
pub trait Within {
    /// The interval.
    const INTERVAL: Interval;
}

macro_rules! intervals {
    ($($(#[$doc:meta])* $marker:ident: $lower:expr, $upper:expr;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, PartialEq)]
            pub struct $marker;

            impl Within for $marker {
                const INTERVAL: Interval = Interval { lower: $lower, upper: $upper };
            }
        )*
    };
}

intervals! {
    /// Any finite number.
    Any: Bound::Unbounded, Bound::Unbounded;
    /// Zero or more.
    NonNegative: Bound::Included(0.0), Bound::Unbounded;
    /// More than zero.
    Positive: Bound::Excluded(0.0), Bound::Unbounded;
    /// More than zero, at most one.
    UpToOne: Bound::Excluded(0.0), Bound::Included(1.0);
    /// More than zero, less than one.
    BelowOne: Bound::Excluded(0.0), Bound::Excluded(1.0);
    /// Zero or more, less than one.
    Fraction: Bound::Included(0.0), Bound::Excluded(1.0);
    /// Coefficients of restitution that a spring and damper in parallel can have: 0.14 to 1.
    Rebound: Bound::Included(0.14), Bound::Included(1.0);
    /// Times of a packing, s: more than 0, at most 1000.
    PackingTime: Bound::Excluded(0.0), Bound::Included(1000.0);
    /// Solidities of a net: 0 to 0.7.
    OpenShare: Bound::Included(0.0), Bound::Included(0.7);
    /// Heights above sea level at which the standard atmosphere has its linear temperature profile: -1 km to 11 km.
    Troposphere: Bound::Included(-1000.0), Bound::Included(11000.0);
    /// Heights above the ground at which wind profiles are valid: 0 to 2 km.
    BoundaryLayer: Bound::Included(0.0), Bound::Included(2000.0);
    /// Heights of an orbit above its planet: 0 to 1e9 m.
    OrbitHeight: Bound::Included(0.0), Bound::Included(1e9);
    /// Angles of more than 0 and less than 180 deg.
    HalfTurn: Bound::Excluded(0.0), Bound::Excluded(PI);
    /// Angles of more than 0 and at most 360 deg.
    WholeTurn: Bound::Excluded(0.0), Bound::Included(TAU);
    /// Angles of a flight to its axis: from 0 to less than 90 deg.
    Splay: Bound::Included(0.0), Bound::Excluded(FRAC_PI_2);
    /// Elevations from straight down to straight up: -90 deg to 90 deg.
    QuarterTurns: Bound::Included(-FRAC_PI_2), Bound::Included(FRAC_PI_2);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_read_back_from_a_schema() {
        for interval in [Any::INTERVAL, NonNegative::INTERVAL, UpToOne::INTERVAL, BelowOne::INTERVAL] {
            let mut schema = Map::new();
            interval.write_schema(&mut schema);
            assert_eq!(Interval::from_schema(&schema), interval);
        }
    }

    #[test]
    fn nan_lies_in_no_bounded_interval() {
        assert!(!Positive::INTERVAL.contains(f64::NAN));
        assert!(!Positive::INTERVAL.contains(0.0));
        assert!(NonNegative::INTERVAL.contains(0.0));
    }
}

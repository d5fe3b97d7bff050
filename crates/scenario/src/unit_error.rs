//! Reasons why a text is not a number with a unit.

/// Reasons why a text is not a number with a unit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    /// The text does not start with a number.
    #[error("it does not start with a number")]
    Number,
    /// The number is written with a comma.
    #[error("write the decimal point as \".\"")]
    Comma,
    /// No unit has this name.
    #[error("unknown unit {unit:?}{}", did_you_mean(nearest))]
    Unknown {
        /// The text in its place.
        unit: String,
        /// A unit with a similar name.
        nearest: Option<String>,
    },
    /// Another character in the place of a unit.
    #[error("expected a unit at {0:?}")]
    Unit(String),
    /// The text after `^` is not a whole number from -9 to 9.
    #[error("expected a whole number from -9 to 9 after \"^\"")]
    Exponent,
    /// A product after a division, which can be read in two ways.
    #[error("after a \"/\" a product can be read in two ways: give every divisor its own \"/\", such as \"kg/m/s\"")]
    Ambiguous,
    /// The value in SI exceeds the largest `f64`.
    #[error("it is too large")]
    TooLarge,
}

fn did_you_mean(nearest: &Option<String>) -> String {
    nearest.as_ref().map_or(String::new(), |near| format!(", did you mean {near:?}?"))
}

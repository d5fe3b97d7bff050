//! The series of round numbers …, 0.5, 1, 2, 5, 10, 20, … for scales and scale bars.

/// The places that are searched: from 1e-9 to 1e12.
const PLACES: std::ops::Range<i32> = -27..37;

/// The number at a place of the series; 1 has place 0.
pub(crate) fn number(place: i32) -> f64 {
    let mantissa = [1, 2, 5][place.rem_euclid(3) as usize];
    // parsing gives the f64 nearest to the decimal number; a product with a power of ten may not
    format!("{mantissa}e{}", place.div_euclid(3)).parse().expect("a number")
}

/// The place of the smallest number of the series that is at least `value`.
pub(crate) fn place_of(value: f64) -> i32 {
    PLACES.into_iter().find(|&place| number(place) >= value).unwrap_or(PLACES.end)
}

/// The largest number of the series that is at most `value`.
pub(crate) fn at_most(value: f64) -> f64 {
    PLACES.rev().map(number).find(|&number| number <= value).unwrap_or(number(PLACES.start))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_is_one_two_five_in_each_decade() {
        assert_eq!([-4, -3, -2, -1, 0, 1, 2, 3].map(number), [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0]);
        assert_eq!([1.0, 1.01, 2e3, 0.07].map(|value| number(place_of(value))), [1.0, 2.0, 2e3, 0.1]);
        assert_eq!([1.0, 1.99, 49.0, 0.07].map(at_most), [1.0, 1.0, 20.0, 0.05]);
    }
}

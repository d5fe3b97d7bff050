//! Numbers as text: three significant digits, and units with a fitting prefix.

use netcast_results::visible;

/// Three significant digits: `15.8`, `0.0123`, `51000`, and `1.20e-9` below 1e-4.
pub(crate) fn significant(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { value.to_string() };
    }
    // round before taking the exponent: 9.996 becomes 10.0, not 10.00
    let rounded = format!("{value:.2e}");
    let exponent: i32 = rounded.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    if exponent < -4 {
        return rounded;
    }
    let rounded: f64 = rounded.parse().unwrap_or(value);
    let decimals = (2 - exponent).max(0) as usize;
    format!("{rounded:.decimals$}")
}

/// A time to the millisecond: `0.131 s`.
pub(crate) fn time(seconds: f64) -> String {
    format!("{seconds:.3} s")
}

/// A duration from nanoseconds to minutes: `1.27 µs`, `11.3 s`, `2 min 5 s`.
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        s if s >= 60.0 => format!("{:.0} min {:.0} s", (s / 60.0).floor(), s % 60.0),
        s if s >= 1.0 || s == 0.0 => format!("{} s", significant(s)),
        s if s >= 1e-3 => format!("{} ms", significant(s * 1e3)),
        s if s >= 1e-6 => format!("{} µs", significant(s * 1e6)),
        s => format!("{} ns", significant(s * 1e9)),
    }
}

/// A ratio as percent, to two significant digits below ten: `97 %`, `0.05 %`.
pub(crate) fn percent(ratio: f64) -> String {
    let percent = 100.0 * ratio;
    let rounded = format!("{percent:.1e}");
    let exponent: i32 = rounded.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    if exponent >= 1 {
        return format!("{percent:.0} %");
    }
    if exponent < -4 {
        return format!("{rounded} %");
    }
    // parsing drops trailing zeros
    format!("{} %", rounded.parse().unwrap_or(percent))
}

/// A unit with the prefix that suits the largest of a set of numbers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scale {
    /// Divisor from the base unit to this unit.
    pub divisor: f64,
    /// The unit with its prefix.
    pub unit: String,
}

impl Scale {
    /// The prefix for values up to `largest` in `base` units: k from a thousand, M from a million.
    pub(crate) fn fitting(largest: f64, base: &str) -> Self {
        let (divisor, prefix) = match largest.abs() {
            size if size >= 1e6 => (1e6, "M"),
            size if size >= 1e3 => (1e3, "k"),
            _ => (1.0, ""),
        };
        Self { divisor, unit: format!("{prefix}{base}") }
    }
}

/// A number with its unit and a fitting prefix: `51.0 kN`.
pub(crate) fn with_prefix(value: f64, base: &str) -> String {
    let scale = Scale::fitting(value, base);
    format!("{} {}", significant(value / scale.divisor), scale.unit)
}

/// A count with thin spaces between the thousands.
pub(crate) fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// Text escaped for HTML, within an element or a quoted attribute, with symbols for control characters.
pub(crate) fn escape(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for character in visible(text).chars() {
        match character {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            other => safe.push(other),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_any_size_have_three_significant_digits() {
        let cases = [
            (15.8321, "15.8"),
            (9.996, "10.0"),
            (0.012345, "0.0123"),
            (-112.44, "-112"),
            (51234.0, "51200"),
            (0.0, "0"),
            (99.97, "100"),
            (1.2e-9, "1.20e-9"),
        ];
        for (value, text) in cases {
            assert_eq!(significant(value), text);
        }
    }

    #[test]
    fn thousands_are_grouped() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1\u{202f}000", "1\u{202f}234\u{202f}567"]);
    }

    #[test]
    fn units_fit_their_numbers() {
        assert_eq!(with_prefix(51_000.0, "N"), "51.0 kN");
        assert_eq!(with_prefix(-2.5e6, "J"), "-2.50 MJ");
        assert_eq!(with_prefix(12.0, "N"), "12.0 N");
        assert_eq!(duration(1.27e-6), "1.27 µs");
        assert_eq!(duration(125.0), "2 min 5 s");
        assert_eq!(time(0.1314), "0.131 s");
        assert_eq!(percent(0.9731), "97 %");
        assert_eq!(percent(0.0005), "0.05 %");
        assert_eq!(percent(0.0314), "3.1 %");
        assert_eq!(percent(0.0999), "10 %");
        assert_eq!(percent(-3e-9), "-3.0e-7 %");
        assert_eq!(percent(0.0), "0 %");
    }
}
